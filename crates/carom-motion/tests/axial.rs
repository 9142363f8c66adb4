//! Moments of solids of revolution: the closed forms, and an independent sum of shells for random profiles.

use carom_motion::planar::{AxialMoments, ChainPoint};
use carom_num::Vec2;
use carom_theory::solids::{self, Solid};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::f64::consts::{FRAC_PI_2, PI};

/// Rounding of a few hundred sums of numbers of one size.
const ROUNDING: f64 = 1e-12;
/// Shells of the independent sum. Its error is that of the midpoint rule, at the steepest places of an arc some N^(−3/2).
const SHELLS: usize = 20_000;
const OF_SHELLS: f64 = 1e-5;
const SEED: u64 = 0x5011d;

fn at(z: f64, r: f64) -> ChainPoint {
    ChainPoint::straight(Vec2::new(z, r))
}

fn bent(z: f64, r: f64, sweep: f64) -> ChainPoint {
    ChainPoint { sweep, ..at(z, r) }
}

fn meets(meridian: &[ChainPoint], known: Solid, shift: f64, name: &str) {
    let found = AxialMoments::of_revolution(meridian);
    let close = |a: f64, b: f64| (a - b).abs() <= ROUNDING * (1.0 + b.abs());
    assert!(close(found.volume, known.volume), "{name}: volume {found:?}, {known:?}");
    assert!(close(found.centre() - shift, known.centre), "{name}: centre {}, {known:?}", found.centre());
    let gyration = found.gyration_squared();
    assert!(close(gyration, known.gyration_squared), "{name}: {gyration}, {known:?}");
}

#[test]
fn textbook_solids_are_met_to_rounding() {
    let (r, h, from) = (0.7, 1.9, -0.4);
    let to = from + h;
    meets(&[at(from, 0.0), at(from, r), at(to, r), at(to, 0.0)], solids::cylinder(r, h), from, "cylinder");
    meets(&[at(from, 0.0), at(from, r), at(to, 0.0)], solids::cone(r, h), from, "cone");
    meets(&[bent(-r, 0.0, -PI), at(r, 0.0)], solids::ball(r), 0.0, "ball");
    let half = [at(from, 0.0), bent(from, r, -FRAC_PI_2), at(from + r, 0.0)];
    meets(&half, solids::half_ball(r), from, "half a ball");
    let ring = [at(from, 0.3), at(from, r), at(to, r), at(to, 0.3)];
    meets(&ring, solids::ring(0.3, r, h), from, "ring");
}

/// Pappus: a circle of radius a round the axis at the distance c; across the axis k² = c²/2 + 5a²/8, the known form of a torus.
#[test]
fn a_torus_has_the_volume_of_pappus() {
    let (c, a) = (2.0, 0.5);
    let circle = [bent(-a, c, -PI), bent(a, c, -PI)];
    let torus = AxialMoments::of_revolution(&circle);
    assert!((torus.volume - 2.0 * PI * PI * c * a * a).abs() < ROUNDING, "{torus:?}");
    let known = 0.5 * c * c + 0.625 * a * a;
    assert!(
        (torus.gyration_squared() - known).abs() < ROUNDING,
        "{} is not {known}",
        torus.gyration_squared()
    );
}

#[test]
fn a_meridian_may_run_either_way() {
    let there = [at(0.0, 0.0), bent(0.0, 0.5, -1.0), at(2.0, 0.8), at(2.5, 0.0)];
    let back = [at(0.0, 0.0), at(2.5, 0.0), bent(2.0, 0.8, 1.0), at(0.0, 0.5)];
    let [a, b] = [&there, &back].map(|meridian| AxialMoments::of_revolution(meridian));
    assert!(a.volume > 0.0 && (a.volume - b.volume).abs() < ROUNDING, "{a:?} {b:?}");
    assert!((a.gyration_squared() - b.gyration_squared()).abs() < ROUNDING, "{a:?} {b:?}");
}

/// An arc that is hardly bent has its centre far away, and still differs from a line by next to nothing.
#[test]
fn an_arc_that_is_hardly_bent_is_a_line() {
    let line = AxialMoments::of_revolution(&[at(0.0, 0.0), at(0.0, 1.0), at(2.0, 1.5), at(2.0, 0.0)]);
    let hardly =
        AxialMoments::of_revolution(&[at(0.0, 0.0), bent(0.0, 1.0, 1e-13), at(2.0, 1.5), at(2.0, 0.0)]);
    assert!((line.volume - hardly.volume).abs() < ROUNDING, "{line:?} {hardly:?}");
    assert!((line.gyration_squared() - hardly.gyration_squared()).abs() < ROUNDING, "{line:?} {hardly:?}");
}

/// The outer radius of an edge at a place on the axis, by the circle's own equation.
fn radius(from: &ChainPoint, to: Vec2, z: f64) -> f64 {
    match from.arc_to(to) {
        None => from.at.y + (to.y - from.at.y) * (z - from.at.x) / (to.x - from.at.x),
        // The profile runs forward, so an arc to the right is the upper half of its circle.
        Some((centre, radius)) => {
            let off = z - centre.x;
            centre.y - radius.signum() * (radius * radius - off * off).max(0.0).sqrt()
        }
    }
}

#[test]
fn random_profiles_agree_with_a_sum_of_discs() {
    let mut random = Pcg64::seed_from_u64(SEED);
    for round in 0..40 {
        let mut points = vec![at(0.0, 0.0)];
        let mut z = 0.0;
        for _ in 0..random.random_range(2..6) {
            let sweep = if random.random_bool(0.6) { random.random_range(-0.8..0.8) } else { 0.0 };
            points.push(bent(z, random.random_range(0.5..1.5), sweep));
            z += random.random_range(1.5..2.5);
        }
        points.push(at(z, 1.0));
        points.push(at(z, 0.0));
        let found = AxialMoments::of_revolution(&points);
        let mut sums = [0.0; 4];
        for edge in points.windows(2).filter(|edge| edge[1].at.x > edge[0].at.x) {
            let width = (edge[1].at.x - edge[0].at.x) / SHELLS as f64;
            for i in 0..SHELLS {
                let z = edge[0].at.x + (i as f64 + 0.5) * width;
                let r = radius(&edge[0], edge[1].at, z);
                let disc = PI * r * r * width;
                // A thin disc: m z² and m r²/4 across its middle.
                let parts = [disc, z * disc, (z * z + 0.25 * r * r) * disc, 0.5 * r * r * disc];
                sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
            }
        }
        let (centre, k) = (sums[1] / sums[0], sums[2] / sums[0]);
        let close = |a: f64, b: f64| (a - b).abs() <= OF_SHELLS * b.abs();
        assert!(close(found.volume, sums[0]), "seed {SEED}, round {round}: {found:?} {sums:?}");
        assert!(close(found.about, sums[3]), "seed {SEED}, round {round}: {found:?} {sums:?}");
        assert!(close(found.centre(), centre), "seed {SEED}, round {round}: {found:?} {sums:?}");
        let gyration = found.gyration_squared();
        assert!(close(gyration, k - centre * centre), "seed {SEED}, round {round}: {found:?} {sums:?}");
    }
}
