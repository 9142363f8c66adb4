//! Stools on rough ground: where friction is ample and no foot strikes aslant, they move as if nothing could slide.

#![allow(clippy::print_stdout, reason = "how far two laws differ is a measurement")]

use crate::stools;

use carom_motion::spatial::{End, Friction, Impact, Mode, Options, Run, Samples, State, World, run};
use stools::{Stool, runs};

fn rolled(stool: &Stool, friction: Option<f64>) -> (Run, Samples) {
    let world = World::new(stool.body(), stool.gravity()).unwrap();
    let world = match friction {
        Some(friction) => world.with_friction(Friction::new(friction)).unwrap(),
        None => world,
    };
    let mut samples = Samples::default();
    let run = run(&world, &stool.start(), &Options::default(), &mut samples).unwrap();
    (run, samples)
}

/// Runs in which no foot strikes aslant while another must stick, and a friction that is enough for them.
const ALIKE: [(&str, f64); 9] = [
    ("T3a", 1.0),
    ("T3a", 8.0),
    ("T3b", 1.0),
    ("T3b", 8.0),
    ("T3c", 8.0),
    ("C4a", 1.0),
    ("H6a", 1.0),
    ("H6a", 8.0),
    ("H6b", 1.0),
];

#[test]
fn ample_friction_is_as_good_as_none_that_slides() {
    for (name, friction) in ALIKE {
        let stools = runs();
        let stool = stools.iter().find(|s| s.name == name).unwrap();
        let (held, _) = rolled(stool, None);
        let (rough, samples) = rolled(stool, Some(friction));
        let slid = samples.pieces.iter().any(|p| matches!(p.mode, Mode::Slides { .. }));
        let alike = |a: &Impact, b: &Impact| {
            (a.time - b.time).abs() < 1e-10 && (a.spin_after - b.spin_after).norm() < 1e-9 && a.kept == b.kept
        };
        // Where something may slide turns are closed earlier: fewer strikes are followed.
        let same = rough.impacts.iter().filter(|b| held.impacts.iter().any(|a| alike(a, b))).count();
        println!("{name}, μ = {friction}: {same} of {} impacts alike", rough.impacts.len());
        assert!(!slid && rough.end == held.end && (rough.time - held.time).abs() < 1e-10, "{:?}", rough.end);
        assert!(same + 3 >= rough.impacts.len(), "but for the last of a series all are alike");
    }
}

/// Up to the first impact a foot that needs no more friction than there is stays where it is, bit by bit.
#[test]
fn until_it_strikes_a_rough_foot_is_a_held_one() {
    for stool in runs() {
        let ((held, _), (rough, samples)) = (rolled(&stool, None), rolled(&stool, Some(8.0)));
        assert!(matches!(samples.pieces[0].mode, Mode::Pivot { .. } | Mode::Edge { .. }));
        let (a, b) = (&held.impacts[0], &rough.impacts[0]);
        assert_eq!(
            (a.time, a.spin_before, a.attitude),
            (b.time, b.spin_before, b.attitude),
            "{}",
            stool.name
        );
    }
}

/// With little friction every stool slides before it comes to rest.
#[test]
fn on_smooth_ground_stools_slide_to_rest() {
    for stool in runs() {
        let (rough, samples) = rolled(&stool, Some(0.3));
        assert!(samples.pieces.iter().any(|p| matches!(p.mode, Mode::Slides { .. })), "{}", stool.name);
        assert!(matches!(rough.end, End::AtRest { .. }), "{}: {:?}", stool.name, rough.end);
        let lost: f64 = rough.impacts.iter().map(|i| i.kinetic_before - i.kinetic_after).sum();
        let world = World::new(stool.body(), stool.gravity()).unwrap();
        let energy = |s: &State| s.kinetic(world.body()) + s.potential(&world);
        let open = energy(&stool.start()) + rough.friction_work - lost - energy(&rough.state);
        println!(
            "{}: strikes take {lost} J, friction between them {} J, open {open:e}",
            stool.name, rough.friction_work
        );
        assert!(open.abs() < 2e-6 * world.scales().energy, "{}: {open:e}", stool.name);
    }
}
