//! Stools that fall, chatter and rock to rest, against an independent program's runs and the closed forms.

#![allow(clippy::print_stdout, reason = "how far two programs differ is a measurement")]

use crate::stools;

use carom_motion::spatial::{
    End, Impact, Mode, Observer, Options, Piece, Run, Samples, State, Supports, World, forces, run,
};
use carom_num::Vec3;
use carom_num::elementary::sin_cos;
use stools::{Stool, Struck, runs};

/// What is compared of each run to [`TIME`] and [`SPIN`].
const FIRST: usize = 20;
/// [s].
const TIME: f64 = 1e-10;
/// [rad/s].
const SPIN: f64 = 1e-10;
/// The other program's times after the closing of a chatter [s].
const TIME_AFTER_CHATTER: f64 = 1e-8;
/// Its times of rest: it sums up the last impacts of a series, which are trusted to eight digits [s].
const REST: f64 = 1e-8;
/// In m g × reach + kinetic energy.
const DRIFT: f64 = 1e-12;

fn rolled(stool: &Stool, closing: f64) -> Run {
    let world = World::new(stool.body(), stool.gravity()).unwrap();
    run(&world, &stool.start(), &Options { closing, ..Options::default() }, &mut ()).unwrap()
}

fn compare(name: &str, ours: &Impact, theirs: &Struck) -> [f64; 2] {
    assert_eq!(ours.touching, theirs.touching, "{name} at {}: what touches", theirs.time);
    let kept = theirs.kept.unwrap_or(theirs.touching);
    assert_eq!(ours.kept, kept, "{name} at {}: what is kept", theirs.time);
    assert!(ours.striking.difference(ours.touching).is_empty(), "{name}: what strikes touches");
    let energy = (ours.kinetic_after - theirs.kinetic).abs() / ours.kinetic_before;
    assert!(energy < SPIN, "{name} at {}: kinetic energy {energy:e}", theirs.time);
    [(ours.time - theirs.time).abs(), (ours.spin_after - theirs.spin).norm()]
}

#[test]
fn the_first_impacts_are_those_of_an_independent_program() {
    for stool in runs().iter().filter(|s| !s.impacts.is_empty()) {
        let run = rolled(stool, 1e-8);
        let before_closing = stool.impacts.iter().take_while(|i| !i.closes).take(FIRST);
        let (mut worst, mut count) = ([0.0_f64; 2], 0);
        for (ours, theirs) in run.impacts.iter().zip(before_closing.clone()) {
            let apart = compare(&stool.name, ours, theirs);
            worst = [worst[0].max(apart[0]), worst[1].max(apart[1])];
            count += 1;
        }
        println!("{}: {count} impacts, times to {:e} s, spins to {:e} rad/s", stool.name, worst[0], worst[1]);
        assert_eq!(count, before_closing.count(), "{}: none is missing", stool.name);
        assert!(worst[0] < TIME && worst[1] < SPIN, "{}: {worst:?}", stool.name);
    }
}

#[test]
fn the_energies_are_those_of_an_independent_program() {
    for stool in runs().iter().filter(|s| !s.impacts.is_empty()) {
        let run = rolled(stool, 1e-8);
        let flat = stool.mass * stool.g * stool.height;
        let mut worst = 0.0_f64;
        for (ours, theirs) in run.impacts.iter().zip(&stool.impacts).take(FIRST).filter(|(_, t)| !t.closes) {
            let energy = ours.kinetic_after + ours.potential - flat;
            worst = worst.max((energy - theirs.energy).abs() / flat);
        }
        println!("{}: energies to {worst:e}", stool.name);
        assert!(worst < SPIN, "{}: {worst:e}", stool.name);
    }
}

#[test]
fn what_follows_a_chatter_is_the_same() {
    for stool in runs() {
        let Some(edge) = stool.impacts.iter().position(|i| i.closes) else { continue };
        let run = rolled(&stool, 1e-6);
        let (closing, theirs) = (&run.closings[0], &stool.impacts[edge]);
        assert_eq!(Some(closing.kept), theirs.kept, "{}: the edge", stool.name);
        println!("{}: the chatter ends at {:e} s from theirs", stool.name, closing.limit - theirs.time);
        assert!((closing.limit - theirs.time).abs() < TIME_AFTER_CHATTER, "{}: {closing:?}", stool.name);
        let ours = run.impacts.iter().filter(|i| i.time > closing.limit);
        let mut worst = 0.0_f64;
        for (ours, theirs) in ours.zip(&stool.impacts[edge + 1..]) {
            assert_eq!((ours.touching, Some(ours.kept)), (theirs.touching, theirs.kept), "{}", stool.name);
            worst = worst.max((ours.time - theirs.time).abs());
        }
        println!("{}: impacts after it to {worst:e} s", stool.name);
        assert!(worst < TIME_AFTER_CHATTER, "{}: {worst:e}", stool.name);
    }
}

#[test]
fn all_come_to_rest_when_they_should() {
    for stool in runs() {
        let run = rolled(&stool, Options::default().closing);
        println!(
            "{}: rests at {} s, {:e} s from theirs; {:?}",
            stool.name,
            run.time,
            run.time - stool.rest,
            run.effort
        );
        let held: Supports = (0..stool.count).collect();
        assert_eq!(run.end, End::AtRest { held }, "{}", stool.name);
        assert!((run.time - stool.rest).abs() < REST, "{}: {}", stool.name, run.time);
        assert!((run.state.up() - Vec3::Z).norm() < 1e-14, "{} lies flat", stool.name);
        assert_eq!(run.state.spin, Vec3::ZERO, "{} does not turn", stool.name);
        assert!(run.effort.evaluations < 400 + 100 * run.effort.impacts, "{}: {:?}", stool.name, run.effort);
    }
}

/// Compares the energy at every sample with that at the first sample of its stretch.
struct Energies<'w> {
    world: &'w World,
    first: Option<f64>,
    worst: f64,
}

impl Observer for Energies<'_> {
    fn is_dense(&self) -> bool {
        true
    }

    fn sample(&mut self, _: f64, _: Mode, state: &State) {
        let kinetic = state.kinetic(self.world.body());
        let energy = kinetic + state.potential(self.world);
        let first = *self.first.get_or_insert(energy);
        self.worst = self.worst.max((energy - first).abs() / (self.world.scales().energy + kinetic));
    }

    fn piece(&mut self, _: &Piece) {
        self.first = None;
    }
}

#[test]
fn the_energy_keeps_between_impacts() {
    for stool in runs() {
        let world = World::new(stool.body(), stool.gravity()).unwrap();
        let mut energies = Energies { world: &world, first: None, worst: 0.0 };
        let run = run(&world, &stool.start(), &Options::default(), &mut energies).unwrap();
        let worst = energies.worst;
        println!("{}: energy keeps to {:e}, at samples to {worst:e}", stool.name, run.drift);
        assert!(run.drift < DRIFT && worst < DRIFT, "{}: {:e} {worst:e}", stool.name, run.drift);
    }
}

#[test]
fn a_chatter_shrinks_by_the_ratio_of_the_closed_form() {
    for stool in runs().iter().filter(|s| s.impacts.iter().any(|i| i.closes)) {
        let run = rolled(stool, 1e-6);
        let closing = &run.closings[0];
        let last = run.impacts.iter().rfind(|i| i.time <= closing.time).unwrap();
        let up = last.attitude.undo(Vec3::Z);
        let tilt = carom_num::elementary::atan2((up.x * up.x + up.y * up.y).sqrt(), up.z);
        let ratio = stool.theory().chatter_ratio(tilt).unwrap();
        println!("{}: ratio {} a period of two, {} in theory", stool.name, closing.ratio, ratio * ratio);
        assert_eq!(closing.period, 2, "{}: two supports in turn", stool.name);
        assert!((closing.ratio - ratio * ratio).abs() < 1e-5 * ratio, "{}: {ratio}", stool.name);
        // The cube's is 5/11.
        assert!((ratio - 5.0 / 11.0).abs() < 1e-6, "{}: {ratio}", stool.name);
    }
}

#[test]
fn a_stool_on_its_edge_rocks_by_the_ratio_of_the_closed_form() {
    for stool in runs().iter().filter(|s| s.impacts.iter().any(|i| i.closes)) {
        let run = rolled(stool, 1e-6);
        let flat: Vec<_> = run.impacts.iter().filter(|i| i.touching.len() == stool.count).collect();
        assert!(flat.len() >= 6, "{}: {}", stool.name, flat.len());
        let mut worst = 0.0_f64;
        for impact in flat {
            let ratio = impact.spin_after.norm() / impact.spin_before.norm();
            worst = worst.max((ratio - stool.theory().flat_from_edge()).abs());
        }
        println!("{}: flat impacts to {worst:e} of the closed form", stool.name);
        assert!(worst < 1e-10, "{}: {worst:e}", stool.name);
    }
}

#[test]
fn tilt_is_followed_between_impacts() {
    let stool = runs().into_iter().find(|s| s.name == "T3a").unwrap();
    let world = World::new(stool.body(), stool.gravity()).unwrap();
    let mut samples = Samples::default();
    run(&world, &stool.start(), &Options::default(), &mut samples).unwrap();
    // It turns about the horizontal through support 0: by energy, J θ̇²/2 = m g (z(0.1) − z(θ)).
    let moment = stool.across + stool.mass * (stool.radius * stool.radius + stool.height * stool.height);
    let height = |tilt: f64| {
        let (sin, cos) = sin_cos(tilt);
        stool.radius * sin + stool.height * cos
    };
    let mut before = f64::INFINITY;
    for (time, _, state) in &samples.instants {
        let tilt = state.tilt(Vec3::Z);
        assert!(tilt <= before, "it falls: {tilt} at {time}");
        before = tilt;
        let gained = stool.mass * stool.g * (height(0.1) - height(tilt));
        let rate = (2.0 * gained.max(0.0) / moment).sqrt();
        assert!((state.spin.norm() - rate).abs() < 1e-7, "{time}: {} {rate}", state.spin.norm());
    }
    assert!(before < 1e-12 && samples.instants.len() > 20, "{before} {}", samples.instants.len());
}

/// The largest friction that the flights of a run about one support need, printed to three digits by the program of the reference.
const FRICTION: [(&str, f64); 9] = [
    ("T3a", 0.712),
    ("T3b", 0.707),
    ("T3c", 0.645),
    ("C4a", 0.765),
    ("C4b", 0.849),
    ("C4c", 0.841),
    ("H6a", 0.707),
    ("P3", 0.686),
    ("H6b", 0.783),
];

#[test]
fn held_supports_need_the_friction_of_an_independent_program() {
    for stool in runs() {
        let world = World::new(stool.body(), stool.gravity()).unwrap();
        let mut samples = Samples::default();
        run(&world, &stool.start(), &Options::default(), &mut samples).unwrap();
        let mut most = 0.0_f64;
        let pivots = samples.instants.iter().filter(|(_, mode, _)| matches!(mode, Mode::Pivot { .. }));
        for (time, mode, state) in pivots {
            let held = forces(&world, *mode, state).unwrap().unwrap();
            assert!(held.forces[0].1.z > 0.0, "{} is pressed on at {time}", stool.name);
            most = most.max(held.friction_demand);
        }
        let printed = FRICTION.iter().find(|(name, _)| *name == stool.name).unwrap().1;
        println!("{}: friction {most}, {printed} in print", stool.name);
        assert!((most - printed).abs() < 1e-3, "{}: {most} {printed}", stool.name);
    }
}
