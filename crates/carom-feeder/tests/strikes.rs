//! What a landing says of strikes against the trace of its run.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::random;

use carom_motion::planar::Options;

#[test]
fn the_first_strike_and_the_hardest_are_those_of_the_trace() {
    let (mut landings, mut harder) = (0, 0);
    for seed in 0..400 {
        let Ok(prepared) = random::feeder(seed).prepare(Options::default()).map(|prepared| prepared.run())
        else {
            continue;
        };
        let run = prepared.unwrap();
        for landing in &run.landings {
            let strikes = run.trace.impacts.iter().map(|impact| impact.contacts[0]);
            let speeds: Vec<f64> = strikes
                .filter(|contact| contact.obstacle == landing.plate)
                .map(|contact| (contact.before.slip.powi(2) + contact.before.normal.powi(2)).sqrt())
                .collect();
            let hardest = speeds.iter().copied().fold(0.0, f64::max);
            assert_eq!(landing.impact_speed, speeds.first().copied().unwrap_or(0.0), "seed {seed}");
            assert_eq!(landing.max_impact_speed, hardest, "seed {seed}");
            landings += 1;
            harder += u32::from(hardest > landing.impact_speed);
        }
    }
    println!("of {landings} landings {harder} are struck harder later than first");
    assert!(landings > 200 && harder > 0, "{landings} {harder}");
}
