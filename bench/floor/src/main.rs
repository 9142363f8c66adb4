//! `cargo run --release -p carom-floor`: the floor and Carom on the same drops, in turn: accuracy, time, instructions.
#![allow(clippy::print_stdout, reason = "a program that reports to the person who runs it")]

mod accuracy;
mod instructions;
mod timing;

use carom_feeder::Feeder;
use carom_floor::{Answer, Design, Prepared, coarse, fine, grid, options};
use std::hint::black_box;

/// One of the programs that are compared.
#[derive(Clone, Copy, Debug)]
enum Program {
    /// Carom, at this tolerance.
    Carom(f64),
    /// The floor, at this setting.
    Floor(fn(&Prepared) -> Answer),
}

/// All of them, by the names of the table.
const PROGRAMS: [(&str, Program); 4] = [
    ("carom-1e-10", Program::Carom(1e-10)),
    ("floor-1e-9", Program::Floor(fine)),
    ("carom-1e-6", Program::Carom(1e-6)),
    ("floor-1e-6", Program::Floor(coarse)),
];

/// A program with all its drops made ready.
enum Ready<'f> {
    Carom(Vec<carom_feeder::Prepared<'f>>),
    Floor(fn(&Prepared) -> Answer, Vec<Prepared>),
}

impl<'f> Ready<'f> {
    /// The feeders are those of the designs, one each.
    fn new(program: Program, designs: &[Design], feeders: &'f [Feeder]) -> Result<Self, String> {
        match program {
            Program::Carom(tolerance) => {
                let ready: Result<_, _> = feeders.iter().map(|f| f.prepare(options(tolerance))).collect();
                Ok(Self::Carom(ready.map_err(|problem| problem.to_string())?))
            }
            Program::Floor(run) => Ok(Self::Floor(run, designs.iter().map(Design::prepare).collect())),
        }
    }

    /// Runs one drop, by number.
    fn run(&self, number: usize) -> Result<(), String> {
        match self {
            Self::Carom(feeders) => {
                black_box(black_box(&feeders[number]).run_untraced().map_err(|problem| problem.to_string())?);
            }
            Self::Floor(run, drops) => {
                black_box(run(black_box(&drops[number])));
            }
        }
        Ok(())
    }
}

fn main() -> Result<(), String> {
    let designs = grid();
    let feeders = designs.iter().map(Design::feeder).collect::<Option<Vec<_>>>().ok_or("not a part")?;
    let words: Vec<String> = std::env::args().skip(1).collect();
    match words.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        [] => {
            accuracy::report(&designs)?;
            let times = timing::measure(&designs, &feeders)?;
            let counts = instructions::count(designs.len());
            timing::report(&times, &counts);
            Ok(())
        }
        [name, passes] => {
            let program = PROGRAMS.iter().find(|(known, _)| known == name).ok_or("no such program")?.1;
            let ready = Ready::new(program, &designs, &feeders)?;
            let passes: usize = passes.parse().map_err(|_| "not a number of passes")?;
            (0..passes).try_for_each(|_| (0..designs.len()).try_for_each(|number| ready.run(number)))
        }
        _ => Err("usage: carom-floor, or: carom-floor PROGRAM PASSES".into()),
    }
}
