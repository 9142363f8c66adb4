//! Boundaries between the engine's outcomes against the closed forms of rocking bodies.

use carom_num::elementary::atan;
use carom_study::regions::{Options, Range, Regions, distance, find};
use carom_study::rocking::Rolling;
use carom_theory::rocking::{Border, Cylinder, Prism, SupportedRod};

/// What is asked of boundaries and meeting points, as a share of the range.
const ACCURACY: f64 = 1e-9;

/// The largest distance of the engine's boundaries from the curve between the same two states.
fn worst(found: &Regions<u8>, borders: impl Fn(f64, f64) -> Vec<Border>) -> f64 {
    let mut worst = 0.0f64;
    for boundary in &found.boundaries {
        let [a, b] = boundary.pair;
        for &[x, y] in &boundary.points {
            let k = borders(x, y).iter().position(|border| border.states == [a, b]);
            let k = k.unwrap_or_else(|| panic!("no closed form has a border {a}|{b}, as at {x}, {y}"));
            worst = worst.max(distance([found.x, found.y], [x, y], |x, y| borders(x, y)[k].residual));
        }
    }
    worst
}

fn cylinder(b: f64) -> Regions<u8> {
    let friction = Range { from: 0.0, to: 1.5, count: 60 };
    let gamma = Range { from: 1.0, to: 89.0, count: 60 };
    find(friction, gamma, &Options::default(), |f, gamma| {
        Rolling::cylinder(b, gamma.to_radians(), f, 0.0).strike().unwrap().cylinder_state().unwrap_or(0)
    })
    .unwrap()
}

fn cylinder_borders(b: f64) -> impl Fn(f64, f64) -> Vec<Border> {
    move |friction, gamma| {
        let half_angle = gamma.to_radians();
        Cylinder { mass: 1.0, radius: 1.0, inertia_ratio: b, friction, half_angle }.borders().to_vec()
    }
}

#[test]
fn a_ring_has_three_curves_that_never_meet() {
    let found = cylinder(1.0);
    let off = worst(&found, cylinder_borders(1.0));
    assert!(off <= ACCURACY, "{off:e}");
    let pairs: Vec<[u8; 2]> = found.boundaries.iter().map(|boundary| boundary.pair).collect();
    assert_eq!(pairs, [[1, 2], [2, 3], [3, 4]], "one line each");
    assert!(found.junctions.is_empty(), "{:?}", found.junctions);
}

#[test]
fn lighter_cylinders_have_four_curves_that_meet_and_one_that_goes_on() {
    for b in [0.5, 0.4] {
        let found = cylinder(b);
        let off = worst(&found, cylinder_borders(b));
        assert!(off <= ACCURACY, "b = {b}: {off:e}");
        let pairs: Vec<[u8; 2]> = found.boundaries.iter().map(|boundary| boundary.pair).collect();
        assert_eq!(pairs, [[1, 2], [1, 4], [2, 3], [3, 4]], "b = {b}: one line each");
        let [point] = &found.junctions[..] else { panic!("b = {b}: {:?}", found.junctions) };
        let gamma = atan(((1.0 + b) / (1.0 - b)).sqrt()).to_degrees();
        let exact = [b / (1.0 - b * b).sqrt(), gamma];
        let off = ((point.at[0] - exact[0]) / 1.5).abs().max(((point.at[1] - exact[1]) / 88.0).abs());
        assert!(off <= ACCURACY, "b = {b}: {point:?}, exactly {exact:?}: {off:e}");
        assert_eq!(point.labels, [1, 4, 3, 2], "b = {b}: all four states around {point:?}");
        let beyond =
            found.boundaries.iter().filter(|line| line.points.iter().any(|p| p[0] > 1.01 * exact[0]));
        assert_eq!(
            beyond.map(|line| line.pair).collect::<Vec<_>>(),
            [[1, 4]],
            "b = {b}: only 1 and 4 beyond f*"
        );
    }
}

#[test]
fn a_prism_has_four_regions_that_meet_in_a_point() {
    let sizes = [0.5, 0.5, 0.3];
    let inertia = Range { from: 0.01, to: 0.4, count: 40 };
    let friction = Range { from: 0.0, to: 1.2, count: 40 };
    let found = find(inertia, friction, &Options::default(), |inertia, friction| {
        Rolling::prism(inertia, sizes, friction, 0.0).strike().unwrap().prism_state().unwrap_or(0)
    })
    .unwrap();
    let [to_centre, to_k, height] = sizes;
    let off = worst(&found, |inertia, friction| {
        Prism { mass: 1.0, inertia, to_centre, to_k, height, friction }.borders().to_vec()
    });
    assert!(off <= ACCURACY, "{off:e}");
    // J = m(d_A d_K − h²), f = h/d_A
    let [point] = &found.junctions[..] else { panic!("{:?}", found.junctions) };
    let off = ((point.at[0] - 0.16) / 0.39).abs().max(((point.at[1] - 0.6) / 1.2).abs());
    assert!(off <= ACCURACY && point.labels.len() == 4, "{point:?}: {off:e}");
}

#[test]
fn a_rod_has_a_hyperbola() {
    let side = Range { from: 0.01, to: 0.5, count: 40 };
    let found = find(side, side, &Options::default(), |a, b| {
        Rolling::rod(1.0, [a, b], 0.0).strike().unwrap().rod_state().unwrap_or(0)
    })
    .unwrap();
    let off = worst(&found, |a, b| vec![SupportedRod::uniform(1.0, 1.0, [a, b]).border()]);
    assert!(off <= ACCURACY, "{off:e}");
    // 12ab = l² between b = 0.5 and a = 0.5: one line.
    assert_eq!((found.boundaries.len(), found.junctions.len()), (1, 0), "{:?}", found.shares);
}
