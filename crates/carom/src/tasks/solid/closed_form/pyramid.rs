//! The strike of a homogeneous pyramid that turns about a lateral edge.

use super::Predicted;
use crate::tasks::tolerance::OFF_EDGE;
use carom_num::Vec3;
use carom_scene::{ClosedFormReport, PyramidShape, SpatialRollProblem, SpatialStrike};
use carom_theory::spatial::{Kept, Pyramid, PyramidStrike};

/// The apex is the body's first point, the base's corners follow in their order.
const APEX: usize = 0;

pub(super) fn of(problem: &SpatialRollProblem, strike: &SpatialStrike) -> Option<ClosedFormReport> {
    let shape = problem.pyramid.filter(|shape| shape.homogeneous)?;
    let [a, k] = edge_and_next(&shape, strike)?;
    let points = problem.world.body().supports();
    let (from, to, next) = (points.get(APEX)?, points.get(a)?, points.get(k)?);
    let edge = (*to - *from).unit()?;
    let spin = strike.impact.spin_before;
    let roll_rate = spin.norm();
    if spin.cross(edge).norm() > OFF_EDGE * roll_rate {
        return None;
    }
    let mass = problem.world.body().mass();
    let PyramidShape { sides, height, circumradius, .. } = shape;
    let pyramid = Pyramid { sides, height, circumradius, mass };
    let strikes = pyramid.strike(roll_rate).ok()?;
    let after = turned(strikes.spin, *to, *next)?;
    let predicted = predicted(problem, &pyramid, &strikes, [a, k], after);
    Some(predicted.beside(problem, strike))
}

/// The corner about whose edge it turned, and the one that strikes.
fn edge_and_next(shape: &PyramidShape, strike: &SpatialStrike) -> Option<[usize; 2]> {
    let impact = &strike.impact;
    let mut corners = impact.touching.iter().filter(|i| *i != APEX);
    let (one, other, none) = (corners.next()?, corners.next()?, corners.next());
    let neighbours = other == one + 1 || (one == 1 && other == shape.sides as usize);
    let mut striking = impact.striking.iter();
    let (next, alone) = (striking.next()?, striking.next().is_none());
    let fits = none.is_none() && neighbours && alone && next != APEX && impact.touching.contains(APEX);
    fits.then_some(if next == one { [other, one] } else { [one, other] })
}

/// The form's spin in the body's axes: there x points to the middle of the edge AK, y from A to K, z along the axis. Where K comes before A in the
/// base's order, that is a mirror image, and a spin turns round.
fn turned(spin: [f64; 3], a: Vec3, k: Vec3) -> Option<Vec3> {
    let middle = (a + k) * 0.5;
    let x = Vec3::new(middle.x, middle.y, 0.0).unit()?;
    let y = (k - a).unit()?;
    let hand = x.cross(y).z;
    Some((x * spin[0] + y * spin[1] + Vec3::Z * spin[2]) * hand.signum())
}

fn predicted(
    problem: &SpatialRollProblem,
    pyramid: &Pyramid,
    strike: &PyramidStrike,
    [a, k]: [usize; 2],
    spin: Vec3,
) -> Predicted {
    let name = |i: usize| problem.points.get(i).map_or("?", String::as_str);
    let (o, a_name, k_name) = (name(APEX), name(a), name(k));
    let critical = pyramid.critical_height();
    let (sides, height) = (pyramid.sides, pyramid.height);
    let long = format!("h = {height:.6} m >= a √(1 − ⅔ sin² π/n) = {critical:.6} m");
    let short = format!("h = {height:.6} m < a √(1 − ⅔ sin² π/n) = {critical:.6} m");
    let (case, kept, words) = match strike.kept {
        Kept::ApexAndNext => (
            format!("long pyramid, n = {sides}: {long}"),
            vec![APEX, k],
            format!("printed: {a_name} separates, it rolls on about {o}{k_name}; so it is for n >= 4"),
        ),
        Kept::Next => (
            format!("short pyramid, n = {sides}: {short}"),
            vec![k],
            format!(
                "printed: {a_name} \"also\" separates; it is the apex {o} that separates beside {a_name}: it turns about {k_name} alone"
            ),
        ),
        Kept::All => (
            format!("long pyramid on a triangle: {long}"),
            vec![APEX, a, k],
            "not in print: on a triangle the long pyramid stops".to_owned(),
        ),
        Kept::BaseEdge => (
            format!("short pyramid on a triangle: {short}"),
            vec![a, k],
            format!(
                "not in print: on a triangle the apex lifts and it turns about the base's edge {a_name}{k_name}"
            ),
        ),
    };
    let normal = [APEX, a, k].into_iter().zip(strike.normal).collect();
    Predicted { case, words, kept, spin, normal }
}
