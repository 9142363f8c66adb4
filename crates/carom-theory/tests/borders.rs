//! Where the state of a strike changes on a way through the plane of two quantities, one of the borders says so: it belongs to these two states, applies
//! there, and changes its sign.

use crate::oracle;

use carom_theory::rocking::{Border, Cylinder, Prism, RodState, SupportedRod};
use carom_theory::spatial::{Approach, LateralRoll, Pyramid, Stool};
use oracle::Stream;

const SEED: u64 = 20_261_122;
const WAYS: usize = 20_000;
/// Halvings of a way: to its last digits, short of rounding in the residuals.
const HALVINGS: u32 = 40;
/// Sums of a few rounded terms of order one; on the axis of a state that two conditions share, both ends may have one sign.
const ROUNDING: f64 = 1e-9;

/// The states at both ends of the shortest part of a way on which they differ, and the borders there; `None` where none changes.
fn change<const N: usize>(
    [from, to]: [f64; 2],
    state: impl Fn(f64) -> u8,
    borders: impl Fn(f64) -> [Border; N],
) -> Option<([u8; 2], [[Border; N]; 2])> {
    let (mut low, mut high) = (from, to);
    let start = state(low);
    if start == state(high) {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if state(middle) == start { low = middle } else { high = middle }
    }
    let mut states = [start, state(high)];
    states.sort_unstable();
    Some((states, [borders(low), borders(high)]))
}

fn is_said<const N: usize>((states, [below, above]): &([u8; 2], [[Border; N]; 2])) -> bool {
    below.iter().zip(above).any(|(below, above)| {
        let crosses = below.residual * above.residual <= 0.0
            || below.residual.abs().min(above.residual.abs()) < ROUNDING;
        below.states == *states && (below.applies || above.applies) && crosses
    })
}

/// How many ways change the state, each of which must be said.
fn said<const N: usize>(
    what: &str,
    way: impl Fn(&mut Stream) -> Option<([u8; 2], [[Border; N]; 2])>,
) -> usize {
    let mut stream = Stream(SEED);
    let mut found = 0;
    for number in 0..WAYS {
        if let Some(change) = way(&mut stream) {
            assert!(is_said(&change), "{what}, way {number} of seed {SEED}: {change:?}");
            found += 1;
        }
    }
    found
}

#[test]
fn states_of_a_cylinder_change_at_its_borders() {
    let found = said("cylinder", |stream| {
        let (inertia_ratio, friction) = (stream.within(0.05, 1.0), stream.within(0.0, 2.0));
        let at = |half_angle: f64| Cylinder { mass: 1.0, radius: 1.0, inertia_ratio, friction, half_angle };
        let ends = [stream.within(0.02, 1.55), stream.within(0.02, 1.55)];
        change(ends, |angle| at(angle).state().number(), |angle| at(angle).borders())
    });
    assert!(found > WAYS / 4, "{found} changes");
}

#[test]
fn states_of_a_prism_change_at_its_borders() {
    let found = said("prism", |stream| {
        let (to_centre, to_k) = (1.0, stream.within(0.5, 2.0));
        let (height, friction) = (stream.within(0.05, 1.0), stream.within(0.0, 2.0));
        let at = |inertia: f64| Prism { mass: 1.0, inertia, to_centre, to_k, height, friction };
        let ends = [stream.within(0.01, 2.5), stream.within(0.01, 2.5)];
        change(ends, |inertia| at(inertia).state().number(), |inertia| at(inertia).borders())
    });
    assert!(found > WAYS / 10, "{found} changes");
}

#[test]
fn a_rod_turns_about_its_other_support_beyond_its_border() {
    let found = said("rod", |stream| {
        let (mass, to_a, to_b) =
            (stream.decades(-1.0, 1.0), stream.within(0.1, 1.0), stream.within(0.1, 1.0));
        let at = |inertia: f64| SupportedRod { mass, inertia, to_a, to_b };
        let turns = |inertia: f64| match at(inertia).strike(1.0) {
            Ok((RodState::Stops, _)) => 1,
            Ok((RodState::TurnsAboutB, _)) => 2,
            Err(_) => 0,
        };
        let ends = [stream.decades(-3.0, 1.0), stream.decades(-3.0, 1.0)];
        change(ends, turns, |inertia| [at(inertia).border()])
    });
    assert!(found > WAYS / 10, "{found} changes");
}

#[test]
fn outcomes_of_a_stool_change_at_its_borders() {
    let found = said("stool", |stream| {
        let stool = Stool {
            supports: 3 + (stream.bits() % 6) as u32,
            circle_radius: 1.0,
            centre_height: stream.within(0.1, 2.0),
            mass: 1.0,
            inertia_transverse: stream.within(0.1, 0.5),
            inertia_axial: stream.within(0.1, 0.5),
        };
        let (tilting, tilt) = (stream.within(-1.0, 1.0), stream.within(0.0, 0.5));
        let at = |swinging: f64| Approach { tilting, closing: 1.0, swinging, tilt };
        let ends = [stream.within(-3.0, 3.0), stream.within(-3.0, 3.0)];
        change(ends, |swinging| stool.outcome(&at(swinging)), |swinging| stool.borders(&at(swinging)))
    });
    assert!(found > WAYS / 10, "{found} changes");
}

#[test]
fn a_rolling_pyramid_has_the_printed_critical_height_and_knows_no_unit() {
    for sides in 3..=12 {
        let printed = Pyramid { sides, height: 1.0, circumradius: 1.0, mass: 1.0 }.critical_height();
        let sides = f64::from(sides);
        let ratio = LateralRoll::critical_ratio(sides, 0.75, 1.0);
        assert!(
            ratio.is_some_and(|ratio| (ratio - printed).abs() < 1e-14),
            "{sides} sides: {ratio:?}, {printed}"
        );
        for share in [0.5, 0.99, 1.01, 2.0] {
            let body = LateralRoll::homogeneous(sides, share * printed);
            let [apex, _, long, ..] = body.borders();
            assert_eq!(
                apex.residual > 0.0,
                share < 1.0,
                "{sides} sides, {share} of the critical height: the apex"
            );
            assert_eq!(long.residual > 0.0, sides > 3.0, "{sides} sides: only a triangle is short");
            // In other units of length and mass every border lies where it did.
            let (l, m) = (3.0, 7.0);
            let scaled = LateralRoll {
                height: l * body.height,
                circumradius: l * body.circumradius,
                apex_to_centre: l * body.apex_to_centre,
                mass: m * body.mass,
                inertia_transverse: m * l * l * body.inertia_transverse,
                inertia_axial: m * l * l * body.inertia_axial,
                ..body
            };
            for (one, other) in body.borders().iter().zip(scaled.borders()) {
                assert_eq!((one.states, one.applies), (other.states, other.applies), "{sides} sides");
                let signs =
                    [one.residual, other.residual].map(|r| if r.abs() < 1e-12 { 0.0 } else { r.signum() });
                assert_eq!(signs[0], signs[1], "{sides} sides: {one:?}, {other:?}");
            }
        }
    }
}
