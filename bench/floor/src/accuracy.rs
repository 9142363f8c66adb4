//! How far each program is from Carom at its tightest.

use crate::{PROGRAMS, Program};
use carom_floor::{Answer, Design, answer, options};

/// Carom's tolerance for what the others are held to.
const TIGHT: f64 = 1e-13;

fn ask(program: Program, design: &Design) -> Result<Option<Answer>, String> {
    let tolerance = match program {
        Program::Carom(tolerance) => tolerance,
        Program::Floor(run) => return Ok(Some(run(&design.prepare()))),
    };
    let feeder = design.feeder().ok_or("not a part")?;
    let ready = feeder.prepare(options(tolerance)).map_err(|problem| problem.to_string())?;
    answer(&ready).map_err(|problem| problem.to_string())
}

/// Prints, of each program, how many verdicts are right and how far times and speeds are off.
pub(crate) fn report(designs: &[Design]) -> Result<(), String> {
    let exact: Result<Vec<_>, _> = designs.iter().map(|d| ask(Program::Carom(TIGHT), d)).collect();
    let exact = exact?;
    println!(
        "| program | verdicts of {} | times within s | impact speed within m/s |\n|---|---|---|---|",
        designs.len()
    );
    for (name, program) in PROGRAMS {
        let (mut right, mut time, mut speed) = (0, 0.0_f64, 0.0_f64);
        for (design, exact) in designs.iter().zip(&exact) {
            if let (Some(Answer::Lands(got)), Some(Answer::Lands(exact))) = (ask(program, design)?, exact) {
                right += u32::from(got.turned == exact.turned);
                time =
                    time.max((got.first_touch - exact.first_touch).abs()).max((got.flat - exact.flat).abs());
                speed = speed.max((got.impact_speed - exact.impact_speed).abs());
            }
        }
        println!("| {name} | {right} | {time:.1e} | {speed:.1e} |");
    }
    println!();
    Ok(())
}
