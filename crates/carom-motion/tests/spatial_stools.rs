//! Stools that chatter and rock to rest, against an independent program's runs.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod stools;

use carom_motion::spatial::{End, Options, Run, World, run};
use stools::{Stool, runs};

fn rolled(stool: &Stool) -> Run {
    let world = World::new(stool.body(), stool.gravity()).unwrap();
    run(&world, &stool.start(), &Options::default(), &mut ()).unwrap()
}

#[test]
fn dbg() {
    for stool in runs() {
        let run = rolled(&stool);
        println!(
            "{} {:?} {} {} {:?} drift {:e}",
            stool.name, run.end, run.time, stool.rest, run.effort, run.drift
        );
        println!("{:?}", run.closings);
        for (i, (ours, theirs)) in run.impacts.iter().zip(&stool.impacts).enumerate() {
            println!(
                "{i} {} dt {:e} dw {:e} {:?} {:?}",
                ours.time,
                ours.time - theirs.time,
                (ours.spin_after - theirs.spin).norm(),
                ours.kept,
                theirs.kept
            );
        }
    }
}
