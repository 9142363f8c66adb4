//! The work of a drop, counted: a slowdown shows here without a clock. A change of these numbers belongs in the changelog.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod paper;

use carom_motion::planar::Options;

#[test]
fn a_two_plate_drop_costs_this_much() {
    let counts = [(15.0, (0.347, 0.2)), (10.0, (0.428, 0.3))].map(|(slope, line)| {
        let feeder = paper::feeder(slope, line, 0.0);
        let options = Options { tolerance: 1e-10, ..Options::default() };
        let work = feeder.prepare(options).unwrap().verdict().unwrap().work;
        (work.rhs_evaluations, work.events, work.impacts)
    });
    assert_eq!(counts, [(362, 6, 2), (267, 6, 3)], "evaluations, events and impacts at rtol 1e-10");
}
