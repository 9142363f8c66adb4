//! Both cases of the paper, rod and box 1 mm thick, against a solution to 8–10 digits by other means (`reference/feeder_exact.json`,
//! Radau and DOP853 at tolerances of 1e-12 and 1e-10).

#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::print_stdout,
    reason = "a test fails by panicking, and says what it measured"
)]

use crate::paper;

use carom_feeder::{Run, Stage, StageName, Verdict};
use carom_motion::planar::trace::PieceEnd;
use carom_motion::planar::{ChainPoint, Options, State};
use carom_num::Vec2;
use serde_json::Value;

/// The bar, relative to the value (to 1e-3 of its SI unit where it is smaller than that).
const BAR: f64 = 1e-8;

struct Comparison {
    name: String,
    worst: f64,
    count: u32,
}

impl Comparison {
    fn number(&mut self, what: &str, ours: f64, reference: &Value) {
        let expected = reference.as_f64().unwrap();
        let error = (ours - expected).abs() / expected.abs().max(1e-3);
        assert!(error <= BAR, "{} {what}: {ours} is not {expected} ({error:.1e})", self.name);
        self.worst = self.worst.max(error);
        self.count += 1;
    }

    fn vector(&mut self, what: &str, ours: Vec2, reference: &Value) {
        self.number(what, ours.x, &reference[0]);
        self.number(what, ours.y, &reference[1]);
    }
}

/// A state in the paper's axes: x along the upper plate, y down through it, angles from x to y.
struct InPaperAxes {
    centre: Vec2,
    velocity: Vec2,
    angle_deg: f64,
    spin: f64,
}

fn in_paper_axes(state: &State, slope_deg: f64) -> InPaperAxes {
    let (x, y) = paper::axes(slope_deg);
    let turn = |v: Vec2| Vec2::new(v.dot(x), v.dot(y));
    InPaperAxes {
        centre: turn(state.pose.centre),
        velocity: turn(state.twist.velocity),
        angle_deg: -state.pose.angle.to_degrees() - slope_deg,
        spin: -state.twist.spin,
    }
}

fn stage(run: &Run, name: StageName) -> &Stage {
    run.stages.iter().find(|s| s.name == name).unwrap()
}

fn compare_tip(c: &mut Comparison, run: &Run, slope_deg: f64, reference: &Value) {
    let slide = stage(run, StageName::Slide);
    c.number("slide duration", slide.end_time, &reference["slide"]["duration_s"]);
    c.number("slide speed", slide.end.twist.velocity.norm(), &reference["slide"]["speed_m_s"]);
    let (tip, expected) = (stage(run, StageName::Tip), &reference["tip"]);
    let end = in_paper_axes(&tip.end, slope_deg);
    c.number("tip duration", tip.end_time - tip.start_time, &expected["duration_s"]);
    c.number("tip angle", end.angle_deg, &expected["angle_deg"]);
    c.number("tip spin", end.spin, &expected["spin"]);
    c.vector("tip centre", end.centre, &expected["centre"]);
    c.vector("tip velocity", end.velocity, &expected["velocity"]);
    // Along the body, from the edge (the origin) to the centre: reach and its rate.
    let along = Vec2::at_angle(end.angle_deg.to_radians());
    c.number("tip r", end.centre.dot(along), &expected["r_m"]);
    let rate = end.velocity.dot(along) + end.spin * end.centre.dot(along.turned_left());
    c.number("tip radial velocity", rate, &expected["v_radial"]);
    let released = matches!(run.trace.pieces[tip.pieces.end - 1].ended_by, PieceEnd::ForceZero(_));
    assert_eq!(released, expected["ended_by"] == "release", "{}: {:?}", c.name, tip.ended_by);
}

fn compare_flight_and_impact(c: &mut Comparison, run: &Run, slope_deg: f64, reference: &Value) {
    let (flight, expected) = (stage(run, StageName::Flight), &reference["flight"]);
    let end = in_paper_axes(&flight.end, slope_deg);
    c.number("flight duration", flight.end_time - flight.start_time, &expected["duration_s"]);
    c.number("flight angle", end.angle_deg, &expected["angle_deg"]);
    c.number("flight spin", end.spin, &expected["spin"]);
    c.vector("flight centre", end.centre, &expected["centre"]);
    c.vector("flight velocity", end.velocity, &expected["velocity"]);
    let (strike, expected) = (&run.trace.impacts[0], &reference["impact"]);
    assert_eq!(u64::from(strike.kind.unwrap().number()), expected["type"].as_u64().unwrap(), "{}", c.name);
    // τ points down the lower plate, against our tangent; n out of it.
    let n = strike.contacts[0].normal;
    for (when, twist, slip) in [
        ("before", strike.before, strike.contacts[0].before),
        ("after", strike.after, strike.contacts[0].after),
    ] {
        let expected = &expected[when];
        c.number("slip", -slip.slip, &expected["slip"]);
        c.number("normal", slip.normal, &expected["normal"]);
        c.number("v_tau", -n.turned_right().dot(twist.velocity), &expected["v_tau"]);
        c.number("v_n", n.dot(twist.velocity), &expected["v_n"]);
        c.number("spin", -twist.spin, &expected["spin"]);
    }
}

fn compare_after(c: &mut Comparison, run: &Run, reference: &Value) {
    let touch = run.trace.impacts[0].time;
    let after = &reference["after"];
    // Everything that happens after the first touch: slip reversals and touches, in order.
    let ours: Vec<f64> = run
        .trace
        .pieces
        .iter()
        .filter(|p| {
            p.start_time >= touch && matches!(p.ended_by, PieceEnd::SlipZero(_) | PieceEnd::Closes { .. })
        })
        .map(|p| p.end_time - touch)
        .collect();
    let events = after["events"].as_array().unwrap();
    assert_eq!(ours.len(), events.len(), "{}: events after the first touch", c.name);
    for (time, event) in ours.iter().zip(events) {
        c.number("event after the touch", *time, &event[0]);
    }
    let landing = run.landings.last().unwrap();
    c.number("flat", landing.flat.unwrap() - landing.first_touch, &after["flat_after_first_touch_s"]);
    let verdict = if landing.verdict == Some(Verdict::Same) { "same" } else { "turned" };
    assert_eq!(after["verdict"], verdict, "{}", c.name);
}

#[test]
fn both_cases_agree_to_eight_digits() {
    let all: Value = serde_json::from_str(include_str!("reference/feeder_exact.json")).unwrap();
    for (name, reference) in all.as_object().unwrap() {
        let slope_deg = reference["upper_slope_deg"].as_f64().unwrap();
        let line =
            (reference["line"]["along_m"].as_f64().unwrap(), reference["line"]["normal_m"].as_f64().unwrap());
        let run = paper::feeder(slope_deg, line, reference["thickness_m"].as_f64().unwrap()).run().unwrap();
        let mut c = Comparison { name: name.clone(), worst: 0.0, count: 0 };
        compare_tip(&mut c, &run, slope_deg, reference);
        compare_flight_and_impact(&mut c, &run, slope_deg, reference);
        compare_after(&mut c, &run, reference);
        println!("{name}: {} numbers, worst relative difference {:.1e}", c.count, c.worst);
    }
}

/// A rod without thickness on a plate that has none either, and is bent above where the rod starts, does what it does on a straight one: it lies on the side on which it
/// starts, whatever rounding says of the other.
#[test]
fn a_rod_on_a_bent_plate_keeps_to_its_side() {
    for slope_deg in [10.0, 12.3, 15.0, 19.1, 22.2, 28.0, 32.5] {
        let straight = paper::feeder(slope_deg, (0.428, 0.3), 0.0);
        let expected = straight.run().unwrap();
        for turn in [-0.4, -0.05, 0.05, 0.4] {
            let mut bent = straight.clone();
            let upper = &mut bent.plates[0];
            let (kink, edge) = (upper.uphill, upper.edge);
            upper.uphill = kink + {
                let way = Vec2::at_angle(turn);
                (kink - edge).rotated(way.x, way.y)
            };
            upper.form.course = [upper.uphill, kink, edge].map(ChainPoint::straight).into();
            upper.unbounded = false;
            let run = bent.run().unwrap();
            let stages = |run: &Run| run.stages.iter().map(|stage| stage.name).collect::<Vec<_>>();
            assert_eq!(stages(&run), stages(&expected), "{slope_deg}°, bent by {turn}");
            for (stage, expected) in run.stages.iter().zip(&expected.stages) {
                let off = (stage.end_time - expected.end_time).abs();
                assert!(off <= BAR, "{slope_deg}°, bent by {turn}: {:?} ends {off:e} s off", stage.name);
            }
        }
    }
}

/// A rod that starts above a bend, steeper below, slides over it: at the kink, or along the arc, it touches both stretches, and neither from below.
#[test]
fn a_rod_slides_over_a_bend_of_its_plate() {
    for (slope_deg, turn) in [(19.4, 0.19), (25.5, 0.13), (33.1, 0.08)] {
        let mut bent = paper::feeder(slope_deg, (0.428, 0.3), 0.0);
        bent.plates.iter_mut().for_each(|plate| plate.friction = 0.1);
        let upper = &mut bent.plates[0];
        let (kink, edge) = (upper.uphill * 0.6, upper.edge);
        let way = Vec2::at_angle(turn);
        upper.uphill = kink + (kink - edge).rotated(way.x, way.y) * 2.0;
        upper.unbounded = false;
        let top = upper.uphill;
        for arc in [0.0, 0.05] {
            // The arc turns from one stretch to the other, and is tangent to both.
            let [before, after] = [top - kink, edge - kink].map(|to| kink + to.unit().unwrap() * arc);
            let course = match arc {
                0.0 => vec![top, kink, edge].into_iter().map(ChainPoint::straight).collect(),
                _ => vec![
                    ChainPoint::straight(top),
                    ChainPoint { at: before, sweep: -turn },
                    ChainPoint::straight(after),
                    ChainPoint::straight(edge),
                ],
            };
            bent.plates[0].form.course = course;
            for to_edge in [0.36, 0.3703, 0.3813, 0.4] {
                bent.start.to_edge = to_edge;
                let run = bent.run().unwrap();
                let slides = run.stages.iter().filter(|stage| stage.name == StageName::Slide).count();
                assert!(
                    slides >= 1 && run.effort.events < 500,
                    "{slope_deg}°, {to_edge} m, arc {arc}: {run:?}"
                );
                assert!(run.landings.iter().any(|landing| landing.plate == 1), "it comes to the lower plate");
            }
        }
    }
}

/// Where a plate gets less steep, a rod across the kink goes through the one stretch or the other, though neither has a thickness; where it gets steeper,
/// it stands out over it.
#[test]
fn a_rod_that_starts_across_a_hollow_kink_is_refused() {
    for (slope_deg, turn) in [(19.4, -0.3), (25.5, -0.02), (25.5, 0.02), (33.1, 0.2)] {
        let mut bent = paper::feeder(slope_deg, (0.428, 0.3), 0.0);
        let upper = &mut bent.plates[0];
        let (kink, edge) = (upper.uphill * 0.6, upper.edge);
        let way = Vec2::at_angle(turn);
        upper.uphill = kink + (kink - edge).rotated(way.x, way.y) * 2.0;
        upper.unbounded = false;
        upper.form.course = [upper.uphill, kink, edge].map(ChainPoint::straight).into();
        // The rod is 0.1 m long.
        for (from_kink, across) in [(0.06, false), (0.03, true), (-0.03, true), (-0.06, false)] {
            bent.start.to_edge = (kink - edge).norm() + from_kink;
            let refused = bent.prepare(Options::default()).is_err();
            assert_eq!(
                refused,
                across && turn < 0.0,
                "{slope_deg}°, bent by {turn}, {from_kink} m from the kink"
            );
        }
    }
}

/// A plate whose first stretch runs the other way: the line from its first to its last point says nothing of its sides.
#[test]
fn a_rod_starts_on_the_upper_side_of_a_hook() {
    let mut hook = paper::feeder(14.0, (0.428, 0.3), 0.0);
    let upper = &mut hook.plates[0];
    let expected = paper::feeder(14.0, (0.428, 0.3), 0.0).run().unwrap();
    let corner = upper.uphill + Vec2::new(0.0, 0.15);
    upper.form.course =
        [corner + Vec2::new(0.6, 0.0), corner, upper.uphill, upper.edge].map(ChainPoint::straight).into();
    upper.uphill = corner + Vec2::new(0.6, 0.0);
    upper.unbounded = false;
    let run = hook.run().unwrap();
    let off = (run.end_time - expected.end_time).abs();
    assert!(off <= BAR, "it ends {off:e} s off: {:?}", run.stages.iter().map(|s| s.name).collect::<Vec<_>>());
}

#[test]
fn case_2_lifts_off_right_after_its_impact_and_touches_again() {
    for thickness in [0.0, 0.001] {
        let run = paper::feeder(10.0, (0.428, 0.3), thickness).run().unwrap();
        let strike = &run.trace.impacts[0];
        assert!(strike.holding_would_need.unwrap() < -6.0, "{:?}", strike.holding_would_need);
        let next = run.trace.pieces.iter().find(|p| p.start_time >= strike.time).unwrap();
        assert!(next.held.is_empty(), "the part flies right after the impact");
        assert!(run.trace.impacts.len() == 3, "second touch and lying down: {}", run.trace.impacts.len());
    }
    let rod = paper::feeder(10.0, (0.428, 0.3), 0.0).run().unwrap();
    assert!(
        (rod.trace.impacts[0].holding_would_need.unwrap() + 6.27).abs() < 0.005,
        "the derivation's −6.27 N"
    );
}
