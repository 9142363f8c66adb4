//! `peers-rapier drop SETTING FILE` and `peers-rapier impact SETTING FILE`: verdicts and time, or spins, as one line of JSON. `peers-rapier
//! cases` answers the referee.

#![allow(clippy::disallowed_methods, reason = "nothing here is promised to be the same on all platforms")]

mod cases;
mod drop;
mod model;

use drop::{Design, Strike};
use model::Setting;
use std::time::Instant;

/// Step [s] of the isolated impact: the finest.
const IMPACT_STEP: f64 = 1e-5;
/// A list that takes less than this [s] is run several times.
const AT_LEAST: f64 = 0.3;

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if arguments == ["cases"] {
        return cases::answer_lines();
    }
    let [what, setting, file] = arguments.as_slice() else {
        return Err("usage: peers-rapier drop|impact default|fast|fine FILE, or peers-rapier cases".into());
    };
    let setting = match setting.as_str() {
        "default" => model::DEFAULT,
        "fast" => model::FAST,
        "fine" => model::FINE,
        other => return Err(format!("no setting {other}")),
    };
    let text = std::fs::read_to_string(file).map_err(|problem| format!("{file}: {problem}"))?;
    let rows: Vec<Vec<f64>> = text.lines().skip(1).map(numbers).collect();
    match what.as_str() {
        "drop" => drops(&rows, setting),
        "impact" => impacts(&rows, setting),
        other => return Err(format!("neither drop nor impact: {other}")),
    }
    Ok(())
}

/// The numbers a line begins with.
fn numbers(line: &str) -> Vec<f64> {
    line.split(',').map_while(|field| field.parse().ok()).collect()
}

fn drops(rows: &[Vec<f64>], setting: Setting) {
    let started = Instant::now();
    let mut passes = 0.0;
    let verdicts = loop {
        let run = |row: &Vec<f64>| model::drop_part(Design::new(row[0], row[1], row[2]), setting);
        let verdicts: Vec<&str> = rows.iter().map(run).collect();
        passes += 1.0;
        if started.elapsed().as_secs_f64() >= AT_LEAST {
            break verdicts;
        }
    };
    let seconds = started.elapsed().as_secs_f64() / passes;
    println!("{{\"seconds\": {seconds}, \"verdicts\": [\"{}\"]}}", verdicts.join("\", \""));
}

fn impacts(rows: &[Vec<f64>], setting: Setting) {
    let spins: Vec<String> = rows
        .iter()
        .map(|row| Strike {
            design: Design::new(row[0], row[1], row[2]),
            centre: (row[3], row[4]),
            angle: row[5],
            velocity: (row[6], row[7]),
            spin: row[8],
        })
        .map(|strike| model::strike(strike, setting, IMPACT_STEP).to_string())
        .collect();
    println!("{{\"spins\": [{}]}}", spins.join(", "));
}
