//! Poses at equal intervals of time against closed forms: they are the engine's dense output, as exact as the steps themselves.

use carom_motion::planar::State;
use carom_num::elementary::{cos, sin};
use carom_num::{Rotation, Vec3};
use carom_scene::{
    PoseMark, RollKind, RollPose, RollProblem, RollReport, SpatialRollKind, SpatialRollProblem,
    SpatialRollReport, pose_interval,
};
use carom_words::Words;

/// What poses may differ by from a closed form, in units of the motion: steps have an error of 1e-11 each, and tens of them follow each other.
const CLOSE: f64 = 1e-9;
const G: f64 = 9.81;

fn planar(kind: RollKind, text: &str) -> RollProblem {
    RollProblem::parse(kind, "test.toml", text, &[]).unwrap()
}

fn spatial(kind: SpatialRollKind, text: &str) -> SpatialRollProblem {
    SpatialRollProblem::parse(kind, "test.toml", text, &[]).unwrap()
}

fn near(ours: f64, exact: f64, scale: f64, what: &str) {
    assert!((ours - exact).abs() <= CLOSE * scale, "{what}: {ours} is not {exact}");
}

/// Every pose at a multiple of the interval is there, in order, and no other; each strike has two at its time; the end stands last.
fn stand_in_order<S: Copy>(poses: &[RollPose<S>], every: f64, strikes: &[f64], end: f64) {
    assert!(poses.windows(2).all(|p| p[0].time <= p[1].time), "in the order of time");
    let regular: Vec<f64> = poses.iter().filter(|p| p.mark == PoseMark::Regular).map(|p| p.time).collect();
    assert_eq!(regular.len(), (end / every).floor() as usize + 1, "0 to {end} s every {every} s");
    for (i, time) in regular.iter().enumerate() {
        assert_eq!(*time, i as f64 * every, "pose {i}");
    }
    for (i, strike) in strikes.iter().enumerate() {
        let place = poses.iter().position(|p| p.mark == PoseMark::BeforeStrike(i)).unwrap();
        let [before, after] = [poses[place], poses[place + 1]];
        assert_eq!((before.time, after.time), (*strike, *strike), "strike {i}");
        assert_eq!(after.mark, PoseMark::AfterStrike(i), "strike {i}");
    }
    let last = poses.last().unwrap();
    assert_eq!((last.mark, last.time), (PoseMark::End, end), "the end");
    assert_eq!(poses.len(), regular.len() + 2 * strikes.len() + 1, "and no others");
}

#[test]
fn a_cylinder_rolls_as_its_closed_form_says() {
    let roll = planar(RollKind::Cylinder, "radius = 0.1\nroll_rate = 10\ndistance = 0.7\ngamma = '40 deg'");
    let run = roll.follow_showing(0.01).unwrap();
    let (poses, strike) = (run.poses.unwrap(), &run.trace.impacts[0]);
    stand_in_order(&poses, 0.01, &[strike.time], run.end_time);
    near(strike.time, 0.7, 1.0, "it rolls 0.7 m with 1 m/s");
    for RollPose { time, state: State { pose, twist }, .. } in
        poses.iter().take_while(|p| p.time < 0.7 - CLOSE)
    {
        near(pose.centre.x, roll.start.pose.centre.x + time, 1.0, "x");
        near(pose.angle, -10.0 * time, 7.0, "angle");
        near(twist.velocity.x, 1.0, 1.0, "speed");
        near(twist.spin, -10.0, 10.0, "spin");
    }
}

#[test]
fn what_slides_at_first_rolls_with_two_thirds_of_its_speed() {
    // A solid cylinder that is thrown without spin: v = v₀ − μ g t until v₀/(3 μ g), then two thirds of v₀.
    let text =
        "radius = 0.1\nroll_rate = 0\nspeed = 1.5\nfriction = 0.2\ndistance = 3\ntime = 2\ngamma = '40 deg'";
    let roll = planar(RollKind::Cylinder, text);
    let poses = roll.follow_showing(0.02).unwrap().poses.unwrap();
    let stops = 1.5 / (3.0 * 0.2 * G);
    let at = |t: f64| 1.5 * t - 0.5 * 0.2 * G * t * t;
    let mut seen = [0, 0];
    for RollPose { time, state, .. } in poses.iter().take_while(|p| p.time < 1.9) {
        let (slides, rolls) = (time.min(stops), (time - stops).max(0.0));
        let x = state.pose.centre.x - roll.start.pose.centre.x;
        near(x, at(slides) + rolls, 2.0, "x");
        near(state.twist.velocity.x, 1.5 - 0.2 * G * slides, 1.5, "speed");
        near(state.pose.angle, -(0.2 * G / 0.1) * slides * slides - 10.0 * rolls, 20.0, "angle");
        seen[usize::from(rolls > 0.0)] += 1;
    }
    assert!(seen[0] > 5 && seen[1] > 5, "sliding and rolling: {seen:?}");
}

#[test]
fn a_bounce_is_a_parabola_between_two_strikes() {
    let text = "radius = 0.1\nrestitution = 0.8\nfriction = 0\nstrikes = 3\ngamma = '40 deg'";
    let roll = planar(RollKind::Cylinder, text);
    let run = roll.follow_showing(0.002).unwrap();
    let poses = run.poses.unwrap();
    let times: Vec<f64> = run.trace.impacts.iter().map(|impact| impact.time).collect();
    stand_in_order(&poses, 0.002, &times, run.end_time);
    let mut flown = 0;
    for (i, pair) in run.trace.impacts.windows(2).enumerate() {
        let piece = run.trace.pieces.iter().find(|p| p.start_time == pair[0].time).unwrap();
        if !piece.held.is_empty() {
            continue;
        }
        let within = |p: &&RollPose<State>| {
            p.mark == PoseMark::Regular && pair[0].time <= p.time && p.time < pair[1].time
        };
        for RollPose { time, state, .. } in poses.iter().filter(within) {
            let (t, v) = (time - pair[0].time, pair[0].after.velocity);
            near(state.pose.centre.x, pair[0].pose.centre.x + v.x * t, 1.0, "x");
            near(state.pose.centre.y, pair[0].pose.centre.y + v.y * t - 0.5 * G * t * t, 1.0, "y");
            near(state.pose.angle, pair[0].pose.angle + pair[0].after.spin * t, 10.0, "angle");
            flown += 1;
        }
        let before = poses.iter().find(|p| p.mark == PoseMark::BeforeStrike(i + 1)).unwrap();
        near(
            before.state.twist.velocity.y,
            pair[0].after.velocity.y - G * (pair[1].time - pair[0].time),
            1.0,
            "v",
        );
    }
    assert!(flown > 10, "it flies: {flown}");
}

/// A prism turns about its edge as a pendulum: its rate by its energy, and the time between two angles by the integral of 1/ω.
#[test]
fn a_prism_turns_about_its_edge_as_a_pendulum() {
    let roll = planar(RollKind::Prism, "sides = 6\ncircumradius = 0.1\nroll_rate = 3\ntilt = '30 deg'");
    let run = roll.follow_showing(0.005).unwrap();
    let (body, strike) = (&roll.world.bodies[0], run.trace.impacts[0].time);
    let turning = body.inertia + body.mass * 0.01;
    let start = roll.start;
    // The mass centre is 0.1 m from the edge, at this angle above the plane where the body's is 0.
    let foot = run.trace.pieces[0].samples[0].contacts[0].point;
    let arm = start.pose.centre - foot;
    let height = |angle: f64| {
        let turned = angle - start.pose.angle;
        arm.x * sin(turned) + arm.y * cos(turned)
    };
    let rate = |angle: f64| {
        let fallen = arm.y - height(angle);
        (start.twist.spin.powi(2) + 2.0 * body.mass * G * fallen / turning).sqrt()
    };
    let poses: Vec<_> = run.poses.unwrap().into_iter().filter(|p| p.time < strike).collect();
    assert!(poses.len() > 10, "{}", poses.len());
    for pair in poses.windows(2) {
        let [from, to] = [pair[0].state.pose.angle, pair[1].state.pose.angle];
        near(pair[1].state.twist.spin, -rate(to), 10.0, "spin by the energy");
        near(pair[1].state.pose.centre.y - foot.y, height(to), 0.1, "height");
        // Simpson's rule of 64 parts: its error is far below rounding of what is compared.
        let at = |k: u32| 1.0 / rate(from + (to - from) * f64::from(k) / 64.0);
        let sum: f64 = (0..=64).map(|k| at(k) * [2.0, 4.0][k as usize % 2]).sum::<f64>() - at(0) - at(64);
        near((from - to) / (3.0 * 64.0) * sum, pair[1].time - pair[0].time, 1.0, "time by the integral");
    }
}

/// A square plate is a symmetric top: it precesses about its angular momentum with L/A and turns about its axis against that.
#[test]
fn a_plate_flies_as_a_symmetric_top() {
    let text =
        "box = [0.06, 0.06, 0.02]\nheight = 3\nturn = 1\nvelocity = [0.3, -0.2, 1]\nspin = [15, 0, 12]";
    let roll = spatial(SpatialRollKind::Body, text);
    let run = roll.follow_showing(0.02).unwrap();
    let poses = run.poses.unwrap();
    let times: Vec<f64> = run.strikes.iter().map(|strike| strike.impact.time).collect();
    stand_in_order(&poses, 0.02, &times, run.end_time);
    let (start, inertia) = (roll.start, roll.world.body().inertia());
    let (across, along) = (inertia.rows[0].x, inertia.rows[2].z);
    assert!((across - inertia.rows[1].y).abs() < 1e-12 * across, "a square plate");
    let momentum = start.attitude.apply(inertia * start.spin);
    let own = start.spin.z * (1.0 - along / across);
    let flight: Vec<_> = poses.iter().take_while(|p| p.time < times[0]).collect();
    assert!(flight.len() > 40, "{}", flight.len());
    for RollPose { time: t, state, .. } in flight {
        let exact = Rotation::by(momentum * (t / across))
            .after(start.attitude)
            .after(Rotation::by(Vec3::Z * (own * t)));
        for axis in [Vec3::X, Vec3::Y, Vec3::Z] {
            let apart = (state.attitude.apply(axis) - exact.apply(axis)).norm();
            assert!(apart <= CLOSE, "at {t} s: {apart:e}");
        }
        let spin = Rotation::by(Vec3::Z * -(own * t)).apply(start.spin);
        assert!((state.spin - spin).norm() <= CLOSE * spin.norm(), "at {t} s: {:?} {spin:?}", state.spin);
        let centre = start.centre + start.velocity * *t - Vec3::Z * (0.5 * G * t * t);
        assert!((state.centre - centre).norm() <= CLOSE, "at {t} s");
        assert!((state.velocity - (start.velocity - Vec3::Z * (G * t))).norm() <= CLOSE, "at {t} s");
    }
}

/// What turns about corners and edges, slides and rocks keeps its energy at every pose, but for what strikes and friction take.
#[test]
fn poses_in_space_keep_the_energy_between_strikes() {
    let cases = [
        (SpatialRollKind::Pyramid, "strikes = 3"),
        (SpatialRollKind::Stool, "axis = [0.3, 1, 0]"),
        (SpatialRollKind::Body, "strikes = 6"),
    ];
    for (kind, text) in cases {
        let roll = spatial(kind, text);
        let run = roll.follow_showing(5e-4).unwrap();
        let poses = run.poses.unwrap();
        let times: Vec<f64> = run.strikes.iter().map(|strike| strike.impact.time).collect();
        stand_in_order(&poses, 5e-4, &times, run.end_time);
        let energy = |p: &RollPose<_>| {
            let state: &carom_motion::spatial::State = &p.state;
            state.kinetic(roll.world.body()) + state.potential(&roll.world)
        };
        let scale = energy(&poses[0]);
        let until = run.closings.first().map_or(run.end_time, |closing| closing.time);
        let mut compared = 0;
        for pair in poses.windows(2).filter(|pair| pair[1].time < until) {
            if !matches!(pair[1].mark, PoseMark::AfterStrike(_)) {
                near(energy(&pair[1]), energy(&pair[0]), scale, "energy");
                compared += 1;
            }
        }
        assert!(compared > 20, "{}: {compared}", kind.word());
    }
}

#[test]
fn a_closed_series_leaves_no_gap_in_the_poses() {
    let rod = planar(RollKind::Rod, "restitution = 0.3");
    let run = rod.follow_showing(1e-3).unwrap();
    assert!(!run.trace.accumulations.is_empty(), "strikes without end");
    let times: Vec<f64> = run.trace.impacts.iter().map(|impact| impact.time).collect();
    stand_in_order(run.poses.as_ref().unwrap(), 1e-3, &times, run.end_time);
}

#[test]
fn poses_change_nothing_else() {
    let prism = planar(RollKind::Prism, "strikes = 4\nslope = '10 deg'");
    let [without, mut with] = [prism.follow().unwrap(), prism.follow_showing(1e-3).unwrap()];
    assert!(with.poses.take().is_some_and(|poses| poses.len() > 100), "they are there");
    assert_eq!(without, with, "in the plane");
    let stool = spatial(SpatialRollKind::Stool, "friction = 0.2");
    let [without, mut with] = [stool.follow().unwrap(), stool.follow_showing(1e-3).unwrap()];
    assert!(with.poses.take().is_some_and(|poses| poses.len() > 100), "they are there");
    assert_eq!(without, with, "in space");
}

#[test]
fn a_pose_says_its_strike_by_its_place_in_the_list() {
    let prism = planar(RollKind::Prism, "strikes = 2");
    let report = RollReport::new(&prism, &prism.follow_showing(0.1).unwrap());
    for pose in report.poses.unwrap().iter().filter(|pose| pose.strike.is_some()) {
        assert_eq!(pose.t_s, report.strikes[pose.strike.unwrap()].t_s, "{pose:?}");
    }
    // This stool finds no way on at its last strike, which has a pose before it and none after.
    let jams = spatial(SpatialRollKind::Stool, "spin = [0, 0, 6]");
    let report = SpatialRollReport::new(&jams, &jams.follow_showing(0.01).unwrap());
    let poses = report.poses.unwrap();
    let [before, end] = &poses[poses.len() - 2..] else { panic!("two") };
    assert_eq!((before.strike, end.strike), (Some(report.strikes.len() - 1), None), "{before:?}");
    assert_eq!(before.position_m, end.position_m, "it is the end");
}

#[test]
fn an_interval_that_makes_too_many_poses_is_refused() {
    let roll = planar(RollKind::Cylinder, "distance = 3\ntime = 1");
    assert!(
        roll.follow_showing(1e-6).is_err_and(|error| error.to_string().contains("1000001 poses")),
        "one too many"
    );
    let stool = spatial(SpatialRollKind::Stool, "");
    assert!(
        stool.follow_showing(1e-9).is_err_and(|error| error.to_string().contains("are allowed")),
        "in space"
    );
    for (text, says) in
        [("0", "above 0"), ("-1 ms", "above 0"), ("nan", "finite"), ("3 mm", "time"), ("soon", "time")]
    {
        let message = pose_interval(text).unwrap_err();
        assert!(message.contains(says), "{text}: {message}");
    }
}
