//! `peers-carom drop|impact PART-SETTING FILE`: verdicts and time, or spins, as one line of JSON; `peers-carom boundary`: designs close to the boundary;
//! `peers-carom map PART-SETTING`: the verdicts of a map of 300 × 300 designs; `peers-carom hollow FILE`: what becomes of parts with hollows.
//!
//! Parts: `rod` and `box` (1 mm thick). Settings: `default` is what the project ships, `fast` and `loose` looser tolerances of the integration.
//! Each drop is checked, made ready and run for its verdict alone, on one thread.

mod boundary;
mod feeders;
mod hollow;
mod map;

use carom_motion::planar::Options;
use feeders::{Design, THICKNESS};
use std::time::Instant;

/// Relative tolerance of the integration at `fast` and at `loose`.
const FAST: f64 = 1e-6;
const LOOSE: f64 = 1e-4;
/// A list that takes less than this [s] is run several times.
const AT_LEAST: f64 = 0.3;

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["boundary"] => boundary::write(),
        ["map", setting] => {
            let (thickness, options) = read_setting(setting)?;
            map::draw(thickness, options)?
        }
        ["hollow", file] => hollow::write(&read(file)?)?,
        [what @ ("drop" | "impact"), setting, file] => {
            let text = read(file)?;
            let designs = text.lines().skip(1).map(design).collect::<Result<Vec<_>, _>>()?;
            let (thickness, options) = read_setting(setting)?;
            if *what == "drop" {
                drops(&designs, thickness, options)
            } else {
                impacts(&designs, thickness, options)?
            }
        }
        _ => return Err("usage: peers-carom drop|impact PART-SETTING FILE, peers-carom map PART-SETTING, peers-carom hollow FILE, or: peers-carom boundary".into()),
    }
    Ok(())
}

fn read(file: &str) -> Result<String, String> {
    std::fs::read_to_string(file).map_err(|problem| format!("{file}: {problem}"))
}

fn read_setting(word: &str) -> Result<(f64, Options), String> {
    let default = Options::default();
    match word {
        "rod-default" => Ok((0.0, default)),
        "box-default" => Ok((THICKNESS, default)),
        "rod-fast" => Ok((0.0, Options { tolerance: FAST, ..default })),
        "box-fast" => Ok((THICKNESS, Options { tolerance: FAST, ..default })),
        "rod-loose" => Ok((0.0, Options { tolerance: LOOSE, ..default })),
        "box-loose" => Ok((THICKNESS, Options { tolerance: LOOSE, ..default })),
        other => Err(format!("no setting {other}")),
    }
}

/// The design that a line begins with.
fn design(line: &str) -> Result<Design, String> {
    let numbers: Vec<f64> = line.split(',').map_while(|field| field.parse().ok()).collect();
    match numbers.as_slice() {
        [slope_deg, along, normal, ..] => {
            Ok(Design { slope_deg: *slope_deg, along: *along, normal: *normal })
        }
        _ => Err(format!("no design: {line}")),
    }
}

fn drops(designs: &[Design], thickness: f64, options: Options) {
    let started = Instant::now();
    let mut passes = 0.0;
    let verdicts = loop {
        let run =
            |design: &Design| feeders::feeder(*design, thickness).map(|f| feeders::verdict(&f, options));
        let verdicts: Vec<&str> = designs.iter().map(|design| run(design).unwrap_or("none")).collect();
        passes += 1.0;
        if started.elapsed().as_secs_f64() >= AT_LEAST {
            break verdicts;
        }
    };
    let seconds = started.elapsed().as_secs_f64() / passes;
    println!("{{\"seconds\": {seconds}, \"verdicts\": [\"{}\"]}}", verdicts.join("\", \""));
}

/// The spin after each design's first impact: of a whole run, as the impact that begins it is exact here.
fn impacts(designs: &[Design], thickness: f64, options: Options) -> Result<(), String> {
    let spin = |design: &Design| {
        let feeder = feeders::feeder(*design, thickness)?;
        let run = feeder.prepare(options).and_then(|prepared| prepared.run()).ok()?;
        run.trace.impacts.first().map(|impact| impact.after.spin.to_string())
    };
    let spins: Option<Vec<String>> = designs.iter().map(spin).collect();
    println!("{{\"spins\": [{}]}}", spins.ok_or("a design without an impact")?.join(", "));
    Ok(())
}
