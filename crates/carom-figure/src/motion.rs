//! The motion between samples: each stretch is the cubic that has the samples' places and velocities (exact for sliding and flight).

use carom_feeder::Feeder;
use carom_motion::planar::trace::{ContactSample, Piece, Sample};
use carom_motion::planar::{Pose, Shape, State, Twist};
use carom_num::Vec2;

/// Poses that the extent of a picture is found from: pieces that are many share them, so that a part of many corners costs no more than its corners.
const MOST_POSES: usize = 1 << 14;
/// And of one piece.
const MOST_OF_PIECE: usize = 64;

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

/// One instant of a piece, its contacts still where the run keeps them.
#[derive(Clone, Copy)]
pub(crate) struct Moment<'a> {
    /// Time [s].
    pub(crate) time: f64,
    /// Pose and velocity.
    pub(crate) state: State,
    contacts: &'a [ContactSample],
}

impl Moment<'_> {
    fn is_finite(&self) -> bool {
        self.time.is_finite() && self.state.is_finite()
    }

    /// With its contacts.
    pub(crate) fn sample(&self) -> Sample {
        Sample { time: self.time, state: self.state, contacts: self.contacts.to_vec() }
    }
}

/// The finite samples of a piece; its two ends where it has none.
pub(crate) fn instants(piece: &Piece) -> impl Iterator<Item = Moment<'_>> + Clone {
    let own = piece.samples.iter().map(|s| Moment { time: s.time, state: s.state, contacts: &s.contacts });
    let own = own.filter(Moment::is_finite);
    let without = if own.clone().next().is_none() { 2 } else { 0 };
    let ends = [(piece.start_time, piece.start), (piece.end_time, piece.end)].into_iter().take(without);
    own.chain(ends.map(|(time, state)| Moment { time, state, contacts: &[] }).filter(Moment::is_finite))
}

/// An instant at the share `u` of the way from one sample to the next.
struct Between<'a> {
    from: Moment<'a>,
    to: Moment<'a>,
    u: f64,
}

impl Between<'_> {
    fn pose(&self) -> Pose {
        if self.u == 0.0 { self.from.state.pose } else { self.state().pose }
    }

    fn state(&self) -> State {
        between(&self.from.state, &self.to.state, self.u, self.to.time - self.from.time)
    }

    /// Contacts are those of the sample before, with forces and places in proportion.
    fn sample(&self) -> Sample {
        let (a, b, u) = (&self.from, &self.to, self.u);
        let mut sample = a.sample();
        if u == 0.0 {
            return sample;
        }
        sample.time = a.time + u * (b.time - a.time);
        sample.state = self.state();
        if a.contacts.len() == b.contacts.len() {
            for (c, to) in sample.contacts.iter_mut().zip(b.contacts) {
                c.point += (to.point - c.point) * u;
                c.normal_force += (to.normal_force - c.normal_force) * u;
                c.tangential_force += (to.tangential_force - c.tangential_force) * u;
                c.slip += (to.slip - c.slip) * u;
            }
        }
        sample
    }
}

/// The samples of a piece, with more put between where they are further apart than 1/48 of it; one after the other, none kept.
fn spread(piece: &Piece) -> impl Iterator<Item = Between<'_>> {
    let step = (piece.end_time - piece.start_time) / 48.0;
    let all = instants(piece);
    let pairs = all.clone().zip(all.clone().skip(1)).flat_map(move |(from, to)| {
        let dt = to.time - from.time;
        let parts = if step > 0.0 && dt > 1.5 * step { (dt / step).round().min(96.0) } else { 1.0 };
        (0..parts as u32).map(move |k| Between { from, to, u: f64::from(k) / parts })
    });
    pairs.chain(all.last().map(|end| Between { from: end, to: end, u: 0.0 }))
}

/// Every k-th of these and the last, so that at most `most` remain, or one more.
fn thinned<T>(all: impl Iterator<Item = T>, count: usize, most: usize) -> impl Iterator<Item = T> {
    let stride = count.div_ceil(most.max(2)).max(1);
    let keep = move |i: usize| i.is_multiple_of(stride) || i + 1 == count;
    all.enumerate().filter(move |(i, _)| keep(*i)).map(|(_, one)| one)
}

/// The samples of a piece, with more put between where they are far apart, and at most `most` of them, or one more.
pub(crate) fn refined(piece: &Piece, most: usize) -> impl Iterator<Item = Sample> + '_ {
    thinned(spread(piece), spread(piece).count(), most).map(|at| at.sample())
}

/// The poses of [`refined`], without its contacts.
pub(crate) fn poses(piece: &Piece, most: usize) -> impl Iterator<Item = Pose> + '_ {
    thinned(spread(piece), spread(piece).count(), most).map(|at| at.pose())
}

/// The run's own samples, which pictures join by cubics: at most `most` of them, or one more.
pub(crate) fn own(piece: &Piece, most: usize) -> impl Iterator<Item = Moment<'_>> {
    thinned(instants(piece), instants(piece).count(), most)
}

/// How many instants a piece may show where pieces of so many share `whole`: `most` while they need no more, two at least.
pub(crate) fn share(counts: &[usize], whole: usize, most: usize) -> usize {
    let needed = |each: usize| counts.iter().map(|count| *count.min(&each)).sum::<usize>();
    let (mut fits, mut too_many) = (2, most + 1);
    while too_many - fits > 1 {
        let each = usize::midpoint(fits, too_many);
        if needed(each) <= whole {
            fits = each;
        } else {
            too_many = each;
        }
    }
    fits
}

/// How many poses of each piece the extent of a picture is found from.
pub(crate) fn poses_each<'a>(pieces: impl Iterator<Item = &'a Piece>) -> usize {
    share(&pieces.map(|piece| spread(piece).count()).collect::<Vec<_>>(), MOST_POSES, MOST_OF_PIECE)
}

/// How many own samples of each piece are shown.
pub(crate) fn own_each(pieces: &[Piece], whole: usize, most: usize) -> usize {
    share(&pieces.iter().map(|piece| instants(piece).count()).collect::<Vec<_>>(), whole, most)
}

/// The four extreme points of the part's circle about a mass centre.
pub(crate) fn around_part(feeder: &Feeder, centre: Vec2) -> [Vec2; 4] {
    let r = feeder.part.body.shape.size();
    [Vec2::new(r, 0.0), Vec2::new(-r, 0.0), Vec2::new(0.0, r), Vec2::new(0.0, -r)].map(|d| centre + d)
}

/// The corners of a shape at a pose [m], world frame.
pub(crate) fn corners(shape: &Shape, pose: Pose) -> impl Iterator<Item = Vec2> {
    let turn = Vec2::at_angle(pose.angle);
    shape.vertices().iter().map(move |v| pose.centre + v.rotated(turn.x, turn.y))
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
        let all: Vec<Sample> = refined(&piece, 1000).collect();
        assert_eq!(all.len(), 49, "48 stretches");
        for s in all {
            let exact = at(s.time);
            assert!((s.state.pose.centre - exact.pose.centre).norm() < 1e-14, "place at {}", s.time);
            assert!((s.state.twist.velocity - exact.twist.velocity).norm() < 1e-13, "velocity at {}", s.time);
        }
        assert_eq!(refined(&piece, 10).count(), 11, "every fifth, and the last");
    }

    #[test]
    fn pieces_that_are_many_share_and_few_are_left_alone() {
        assert_eq!(share(&[300, 5, 40], 345, 300), 300, "room for all");
        // Of 100 samples in three pieces: 5 + 40 + 55, so that the longest alone is thinned.
        assert_eq!(share(&[300, 5, 40], 100, 300), 55, "the longest has what the others leave");
        assert_eq!(share(&[64; 1000], 16_000, 64), 16, "equal parts");
        assert_eq!(share(&[64; 1000], 10, 64), 2, "both ends");
    }
}
