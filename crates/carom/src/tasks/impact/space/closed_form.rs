//! The closed form of an impact in space, where there is one, beside the engine's numbers.

use crate::tasks::tolerance::{NON_SLIDING_AGREES, SAME_NUMBER};
use carom_impact::Law;
use carom_scene::{SpatialImpactProblem, SpatialImpactReport};
use carom_theory::spatial::{AfterTwist, SpinStops, Twist};
use carom_words::number::ascii;

/// The closed form of a body that falls flat while it spins about the normal, beside the engine.
pub(super) fn of(problem: &SpatialImpactProblem, report: &SpatialImpactReport) -> Option<String> {
    let twist = twist(problem)?;
    let end = report.end.as_ref().filter(|_| report.law.0 == Law::Poisson)?;
    let AfterTwist { stops, spin, rising, .. } = twist.after().ok()?;
    let stops = match stops {
        SpinStops::Not => "the spin goes on",
        SpinStops::InRestitution => "the spin stops in restitution",
        SpinStops::InCompression => "the spin stops in compression",
    };
    let near = |a: f64, b: f64, scale: f64| (a - b).abs() <= NON_SLIDING_AGREES * scale.abs();
    let agrees =
        near(end.spin_rad_s?[2], spin, twist.spin) && near(end.velocity_m_s?[2], rising, twist.approach);
    Some(format!(
        "closed form of a flat fall with a spin about the normal: {stops}, {} rad/s and {} m/s after: {}",
        ascii(spin, 6),
        ascii(rising, 6),
        if agrees { "agrees" } else { "does not agree" }
    ))
}

/// The twist that an impact is, if it is one: it falls straight down, on supports evenly about the axis of its spin, a principal one.
fn twist(problem: &SpatialImpactProblem) -> Option<Twist> {
    let (body, first) = (problem.body.as_ref()?, problem.touches.first()?);
    let size = problem.touches.iter().map(|t| t.arm.norm()).fold(0.0, f64::max);
    let radius = (first.arm.x * first.arm.x + first.arm.y * first.arm.y).sqrt();
    let alike = problem.touches.iter().all(|t| {
        let r = (t.arm.x * t.arm.x + t.arm.y * t.arm.y).sqrt();
        t.normal.z == 1.0
            && (t.friction, t.restitution) == (first.friction, first.restitution)
            && (r - radius).abs() <= SAME_NUMBER * size
            && (t.arm.z - first.arm.z).abs() <= SAME_NUMBER * size
    });
    let middle = problem.touches.iter().fold(carom_num::Vec3::ZERO, |sum, t| sum + t.arm);
    let centred = middle.x.abs().max(middle.y.abs()) <= SAME_NUMBER * size;
    let straight = (body.velocity.x, body.velocity.y, body.spin.x, body.spin.y) == (0.0, 0.0, 0.0, 0.0);
    (alike && centred && straight && problem.touches.len() >= 2 && body.velocity.z < 0.0).then_some(Twist {
        mass: body.mass,
        inertia: body.inertia.rows[2].z,
        circle_radius: radius,
        approach: -body.velocity.z,
        spin: body.spin.z,
        friction: first.friction,
        restitution: first.restitution,
    })
}
