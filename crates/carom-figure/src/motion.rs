//! The motion between samples: each stretch is the cubic that has the samples' places and velocities (exact for sliding and flight).

use carom_feeder::Feeder;
use carom_motion::planar::trace::{Piece, Sample, Trace};
use carom_motion::planar::{Pose, State, Twist};
use carom_num::Vec2;

fn cubic(u: f64, dt: f64, ends: [f64; 2], rates: [f64; 2]) -> (f64, f64) {
    let [p0, p1] = ends;
    let [m0, m1] = [rates[0] * dt, rates[1] * dt];
    let (a, b) = (2.0 * p0 + m0 - 2.0 * p1 + m1, -3.0 * p0 + 3.0 * p1 - 2.0 * m0 - m1);
    (((a * u + b) * u + m0) * u + p0, ((3.0 * a * u + 2.0 * b) * u + m0) / dt)
}

/// The state between two samples at the share `u` of the way, `dt` [s] apart.
fn between(a: &State, b: &State, u: f64, dt: f64) -> State {
    let (x, vx) = cubic(u, dt, [a.pose.centre.x, b.pose.centre.x], [a.twist.velocity.x, b.twist.velocity.x]);
    let (y, vy) = cubic(u, dt, [a.pose.centre.y, b.pose.centre.y], [a.twist.velocity.y, b.twist.velocity.y]);
    let (angle, spin) = cubic(u, dt, [a.pose.angle, b.pose.angle], [a.twist.spin, b.twist.spin]);
    State {
        pose: Pose { centre: Vec2::new(x, y), angle },
        twist: Twist { velocity: Vec2::new(vx, vy), spin },
    }
}

/// The finite samples of a piece; its two ends where it has none.
pub(crate) fn finite_samples(piece: &Piece) -> Vec<Sample> {
    let good = |s: &Sample| s.time.is_finite() && s.state.is_finite();
    let mut samples: Vec<Sample> = piece.samples.iter().filter(|s| good(s)).cloned().collect();
    if samples.is_empty() {
        let ends = [(piece.start_time, piece.start), (piece.end_time, piece.end)];
        samples = ends.map(|(time, state)| Sample { time, state, contacts: vec![] }).to_vec();
        samples.retain(good);
    }
    samples
}

/// The samples of a piece, with more put between where they are further apart than 1/48 of it, and at most `most` of them.
///
/// Contacts of a sample put between are those before it, with forces and places in proportion.
pub(crate) fn refined(piece: &Piece, most: usize) -> Vec<Sample> {
    let samples = finite_samples(piece);
    let step = (piece.end_time - piece.start_time) / 48.0;
    let mut out: Vec<Sample> = vec![];
    for pair in samples.windows(2) {
        let [a, b] = pair else { continue };
        out.push(a.clone());
        let dt = b.time - a.time;
        if !(step > 0.0 && dt > 1.5 * step) {
            continue;
        }
        let parts = (dt / step).round().min(96.0);
        let mut k = 1.0;
        while k < parts {
            out.push(put_between(a, b, k / parts, dt));
            k += 1.0;
        }
    }
    out.extend(samples.last().cloned());
    thinned(out, most)
}

fn put_between(a: &Sample, b: &Sample, u: f64, dt: f64) -> Sample {
    let mut contacts = a.contacts.clone();
    if a.contacts.len() == b.contacts.len() {
        for (c, to) in contacts.iter_mut().zip(&b.contacts) {
            c.point += (to.point - c.point) * u;
            c.normal_force += (to.normal_force - c.normal_force) * u;
            c.tangential_force += (to.tangential_force - c.tangential_force) * u;
            c.slip += (to.slip - c.slip) * u;
        }
    }
    Sample { time: a.time + u * dt, state: between(&a.state, &b.state, u, dt), contacts }
}

/// Every k-th element and the last, so that at most `most` remain.
fn thinned(samples: Vec<Sample>, most: usize) -> Vec<Sample> {
    let stride = samples.len().div_ceil(most.max(2));
    let last = samples.len().saturating_sub(1);
    let keep = |i: &usize| i.is_multiple_of(stride.max(1)) || *i == last;
    samples.into_iter().enumerate().filter(|(i, _)| keep(i)).map(|(_, s)| s).collect()
}

/// Every pose of a run, dense enough to find its extent.
pub(crate) fn poses(trace: &Trace) -> Vec<Pose> {
    trace.pieces.iter().flat_map(|p| refined(p, 64)).map(|s| s.state.pose).collect()
}

/// The four extreme points of the part's circle about a mass centre.
pub(crate) fn around_part(feeder: &Feeder, centre: Vec2) -> [Vec2; 4] {
    let r = feeder.part.body.shape.size();
    [Vec2::new(r, 0.0), Vec2::new(-r, 0.0), Vec2::new(0.0, r), Vec2::new(0.0, -r)].map(|d| centre + d)
}

/// The corners of the part at a pose [m], world frame.
pub(crate) fn corners(feeder: &Feeder, pose: Pose) -> Vec<Vec2> {
    let turn = Vec2::at_angle(pose.angle);
    let shape = &feeder.part.body.shape;
    shape.vertices().iter().map(|v| pose.centre + v.rotated(turn.x, turn.y)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_motion::planar::trace::PieceEnd;

    #[test]
    fn a_thrown_part_follows_its_parabola_between_two_samples() {
        let at = |t: f64| State {
            pose: Pose { centre: Vec2::new(2.0 * t, 3.0 * t - 4.905 * t * t), angle: 5.0 * t },
            twist: Twist { velocity: Vec2::new(2.0, 3.0 - 9.81 * t), spin: 5.0 },
        };
        let sample = |time: f64| Sample { time, state: at(time), contacts: vec![] };
        let piece = Piece {
            held: vec![],
            start_time: 0.0,
            end_time: 0.4,
            start: at(0.0),
            end: at(0.4),
            ended_by: PieceEnd::TimeUp,
            samples: vec![sample(0.0), sample(0.4)],
        };
        let all = refined(&piece, 1000);
        assert_eq!(all.len(), 49, "48 stretches");
        for s in all {
            let exact = at(s.time);
            assert!((s.state.pose.centre - exact.pose.centre).norm() < 1e-14, "place at {}", s.time);
            assert!((s.state.twist.velocity - exact.twist.velocity).norm() < 1e-13, "velocity at {}", s.time);
        }
        assert_eq!(refined(&piece, 10).len(), 11, "every fifth, and the last");
    }
}
