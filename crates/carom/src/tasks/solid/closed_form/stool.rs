//! The strikes of a stool: a support and its neighbour, or all supports at once.

use super::Predicted;
use crate::tasks::tolerance::OFF_LINE;
use carom_motion::spatial::Supports;
use carom_num::Vec3;
use carom_num::elementary::{atan2, cos};
use carom_scene::{ClosedFormReport, SpatialRollProblem, SpatialStrike};
use carom_theory::spatial::{Approach, Stool};
use std::f64::consts::PI;

pub(super) fn of(problem: &SpatialRollProblem, strike: &SpatialStrike) -> Option<ClosedFormReport> {
    let stool = stool(problem)?;
    let touching = strike.impact.touching;
    let predicted = if touching.len() == problem.points.len() {
        flat(problem, &stool, strike)
    } else {
        neighbours(problem, &stool, strike)
    };
    Some(predicted?.beside(problem, strike))
}

fn stool(problem: &SpatialRollProblem) -> Option<Stool> {
    let body = problem.world.body();
    let (first, inertia) = (body.supports().first()?, body.inertia());
    let stool = Stool {
        supports: u32::try_from(problem.points.len()).ok()?,
        circle_radius: first.x,
        centre_height: -first.z,
        mass: body.mass(),
        inertia_transverse: inertia.rows[0].x,
        inertia_axial: inertia.rows[2].z,
    };
    stool.check().is_ok().then_some(stool)
}

/// A support O that was stood on and its neighbour K that strikes.
fn neighbours(problem: &SpatialRollProblem, stool: &Stool, strike: &SpatialStrike) -> Option<Predicted> {
    let impact = &strike.impact;
    let n = problem.points.len();
    let held = impact.touching.difference(impact.striking);
    let (o, k) = (held.iter().next()?, impact.striking.iter().next()?);
    if impact.touching.len() != 2 || held.len() != 1 || (o + 1) % n != k && (k + 1) % n != o {
        return None;
    }
    let points = problem.world.body().supports();
    let (at_o, at_k) = (*points.get(o)?, *points.get(k)?);
    // In body axes: u from O to K, N the plane's normal, e towards the body's middle.
    let u = (at_k - at_o).unit()?;
    let normal = strike.before.up();
    let across = normal.cross(u);
    // Where K comes before O in their order the middle is on the other side: a mirror image, in which spins about u and N turn round.
    let hand = if across.dot((at_o + at_k) * -0.5) >= 0.0 { 1.0 } else { -1.0 };
    let e = across * hand;
    let spin = impact.spin_before;
    let tilt = atan2(-Vec3::Z.dot(e), normal.z);
    let approach = Approach {
        tilting: hand * spin.dot(u),
        closing: spin.dot(across),
        swinging: hand * spin.dot(normal),
        tilt,
    };
    approach.check().ok()?;
    let (on_both, on_next) = (stool.on_both(&approach), stool.on_next(&approach));
    let name = |i: usize| problem.points.get(i).map_or("?", String::as_str);
    let both = on_both.normal.iter().all(|p| *p >= 0.0);
    let next = on_next.normal >= 0.0 && on_next.separation >= 0.0;
    let (case, kept, after, of) = match (both, next) {
        (true, _) => (
            format!("both {} and {} stay", name(o), name(k)),
            vec![o, k],
            u * (hand * on_both.tilting),
            vec![(o, on_both.normal[0]), (k, on_both.normal[1])],
        ),
        (false, true) => (
            format!("{} separates, {} stays", name(o), name(k)),
            vec![k],
            u * (hand * on_next.spin[0]) + across * on_next.spin[1] + normal * (hand * on_next.spin[2]),
            vec![(k, on_next.normal)],
        ),
        (false, false) => return None,
    };
    let words = format!(
        "both would stay with the normal impulses {:.6} N s at {} and {:.6} N s at {}{}",
        on_both.normal[0],
        name(o),
        on_both.normal[1],
        name(k),
        if both && next { "; that only the latter stays is consistent too" } else { "" }
    );
    Some(Predicted { case, words, kept, spin: after, normal: of })
}

/// All supports at once, from one support or from the edge between two.
fn flat(problem: &SpatialRollProblem, stool: &Stool, strike: &SpatialStrike) -> Option<Predicted> {
    let impact = &strike.impact;
    let n = problem.points.len();
    let held = impact.touching.difference(impact.striking);
    let points = problem.world.body().supports();
    let middle = held.iter().filter_map(|i| points.get(i)).fold(Vec3::ZERO, |sum, r| sum + *r);
    // The line about which it turned is across the way to the middle of what it stood on.
    let out = Vec3::new(middle.x, middle.y, 0.0).unit()?;
    let spin = impact.spin_before;
    let along = Vec3::Z.cross(out);
    if spin.cross(along).norm() > OFF_LINE * spin.norm() {
        return None;
    }
    let (from_edge, ratio) = match held.len() {
        1 => (false, stool.flat_from_support()),
        2 => (true, stool.flat_from_edge()),
        _ => return None,
    };
    let opposite: Supports = if ratio == 0.0 { impact.touching } else { farthest(points, -out) };
    let (a, gyration) = (stool.circle_radius, stool.gyration_squared());
    let inner = a * cos(PI / f64::from(stool.supports));
    let here = if from_edge { inner } else { a };
    let to_edge = from_edge == n.is_multiple_of(2);
    let there = if to_edge { inner } else { a };
    let sign = if ratio == 0.0 { "<=" } else { ">" };
    let what = if from_edge { "an edge" } else { "a support" };
    let case = format!(
        "flat from {what}: κ² = J_t/m + c² = {gyration:.6e} m² {sign} {:.6e} m², the product of its distance from the middle and that of what lies opposite",
        here * there
    );
    let words = if ratio == 0.0 {
        "it stops".to_owned()
    } else {
        format!("it rocks on with (κ² − a d)/(κ² + d²) = {ratio:.9} of its spin")
    };
    Some(Predicted { case, words, kept: opposite.iter().collect(), spin: spin * ratio, normal: vec![] })
}

/// The supports that lie farthest in a direction: one, or two alike.
fn farthest(points: &[Vec3], out: Vec3) -> Supports {
    let most = points.iter().map(|r| r.dot(out)).fold(f64::NEG_INFINITY, f64::max);
    let alike = |r: &Vec3| most - r.dot(out) <= OFF_LINE * most.abs();
    points.iter().enumerate().filter(|(_, r)| alike(r)).map(|(i, _)| i).collect()
}
