//! A body that rocks: it strikes with two contacts in turn, ever sooner, and comes to rest on both.

use super::accumulation::Series;
use super::walker::Walker;
use crate::periods::left;
use crate::planar::contact::{kinematics::Pairing, touching::Few};
use crate::planar::geometry::State;
use crate::planar::modes::{line::Line, mode::Held, strike::Struck};
use crate::tolerance::{MODE_RANK, ROCKING_ERROR, ROCKING_LEFT, ROCKING_MOVE, STILL_SPEED};
use carom_impact::planar::Slip;
use carom_num::solve::solve_regular;

/// Turns remembered: three periods of two, and those of the turn before.
const TURNS: usize = 8;

/// The turns of two contacts that strike alternately. Each may chatter before the other strikes: its first strike is its turn.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::planar) struct Rocking {
    /// When, the newest last [s].
    times: [f64; TURNS],
    len: usize,
    /// The contact that struck last, and the other one.
    pairs: [Option<Pairing>; 2],
}

impl Rocking {
    /// An impact: a turn, where one contact strikes that approaches.
    pub(super) fn note(&mut self, struck: &Few<Struck>, forced: bool, time: f64) {
        let mut striking = struck.iter().filter(|s| s.normal < 0.0).map(|s| s.pair);
        match (striking.next(), striking.next()) {
            (Some(pair), None) if !forced => self.turn(pair, time),
            _ => *self = Self::default(),
        }
    }

    fn turn(&mut self, pair: Pairing, time: f64) {
        let [last, other] = self.pairs;
        if last == Some(pair) {
            return;
        }
        if other != Some(pair) {
            let before = self.len.checked_sub(1).map(|latest| self.times[latest]);
            self.len = 0;
            before.into_iter().for_each(|time| self.push(time));
        }
        self.pairs = [Some(pair), last];
        self.push(time);
    }

    fn push(&mut self, time: f64) {
        if self.len == TURNS {
            self.times.rotate_left(1);
            self.len -= 1;
        }
        self.times[self.len] = time;
        self.len += 1;
    }

    /// The series of these turns, and who takes them, once little is left of it and its limit is known: the last turn says the same of it as the one before.
    fn series(&self, time_scale: f64) -> Option<(Series, [Pairing; 2])> {
        let [Some(last), Some(other)] = self.pairs else { return None };
        if self.len < TURNS {
            return None;
        }
        let (now, limit) = (self.times[TURNS - 1], self.limit(TURNS - 1)?);
        let known = (limit - self.limit(TURNS - 2)?).abs() <= ROCKING_ERROR * time_scale;
        let left = limit - now;
        let is_over = known && (0.0..=ROCKING_LEFT * time_scale).contains(&left);
        is_over.then_some((Series { from: self.times[0], left }, [last, other]))
    }

    /// The limit by the turns up to one of them [s].
    fn limit(&self, turn: usize) -> Option<f64> {
        left([3, 2, 1, 0].map(|k| self.times[turn - 2 * k])).map(|(left, _)| self.times[turn] + left)
    }
}

impl<const B: usize> Walker<'_, B> {
    /// Where the body has all but come to rest on the two contacts that it rocks on: the series, and the contacts as they are held from its limit on.
    pub(super) fn rocked(&self) -> Option<(Series, Few<Held>)> {
        // Others may hang on what rocks, or come to meet it before the limit.
        if !self.alone {
            return None;
        }
        let (series, pairs) = self.rocking.series(self.scales.time)?;
        let (mut held, mut both) = (Few::default(), Few::default());
        for pair in pairs {
            let slip = self.kinematics(pair).slip;
            held.push(Held::slipping(pair, slip, STILL_SPEED * self.scales.speed));
            both.push(pair);
        }
        // It lies down by so little that nothing beside it is reached.
        let (now, laid) = (self.states[0].pose, self.closed_up(&self.states, &both)[0].pose);
        let turned = (laid.angle - now.angle).abs() * self.world.bodies[0].shape.size();
        let moved = (laid.centre - now.centre).norm().max(turned);
        if moved > ROCKING_MOVE * self.scales.length {
            return None;
        }
        // Nor does it come to anything else before the limit, or over an end.
        let mut states = self.states;
        states[0].pose.centre += states[0].twist.velocity * series.left;
        let near = self.near_within(series.left, &states);
        let stays = near.len() == 2 && both.iter().all(|pair| near.iter().any(|other| other == pair));
        stays.then_some((series, held))
    }

    /// The bodies as the strikes to come leave them, but for what the weight does meanwhile: none of these contacts, two at most, moves along its normal, and each impulse has brought its
    /// friction.
    pub(super) fn stopped(&self, held: &Few<Held>) -> [State; B] {
        let mut states = self.states;
        let sticks = held.iter().any(|h| h.slip == Slip::Sticks);
        if B > 1 || held.len() > 2 || sticks {
            return states;
        }
        let lines: Vec<_> = held.iter().map(|h| self.stopping(h)).collect();
        let (mut matrix, mut rates) = ([[0.0; 2]; 2], [0.0; 2]);
        for (i, (row, _, rate)) in lines.iter().enumerate() {
            rates[i] = -rate;
            for (k, (_, force, _)) in lines.iter().enumerate() {
                matrix[i][k] = self.world.response(row, force);
            }
        }
        let impulses = solve_regular(matrix, rates, lines.len(), MODE_RANK).unwrap_or_default();
        for (impulse, (_, force, _)) in impulses.into_iter().zip(lines.iter()) {
            for (body, velocity, spin) in self.world.motion_along(force) {
                states[body].twist.velocity += velocity * impulse;
                states[body].twist.spin += spin * impulse;
            }
        }
        states
    }

    /// Of a contact that slips: its normal, its force with friction, and how fast it opens.
    fn stopping(&self, held: &Held) -> (Line, Line, f64) {
        let k = self.kinematics(held.pair);
        let pull = held.slip.pull(self.world.surface(held.pair).friction);
        let line = |direction| self.world.line(&k, held.pair, direction);
        (line(k.normal), line(k.normal + k.tangent() * pull), k.approach)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::geometry::Feature;

    fn corner(vertex: usize) -> Pairing {
        Pairing { body: 0, obstacle: 0, feature: Feature::VertexOnFace { vertex, face: 0 } }
    }

    /// The first limit that turns with these intervals tell, and the time of the turn that tells it.
    fn told(intervals: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
        let (mut rocking, mut time) = (Rocking::default(), 0.0);
        for (turn, interval) in intervals.enumerate() {
            rocking.turn(corner(turn % 2), time);
            if let Some((series, _)) = rocking.series(1.0) {
                return Some((time, time + series.left));
            }
            time += interval;
        }
        None
    }

    /// Long and short turns alternate, as those of a part whose mass centre is not in the middle do.
    #[test]
    fn turns_that_shrink_geometrically_are_closed_at_their_limit() {
        let period = [0.7, 0.2];
        let intervals = (0..40).map(|k| period[k % 2] * 0.25f64.powi((k / 2) as i32));
        let (time, limit) = told(intervals).unwrap();
        assert!((limit - 1.2).abs() < 1e-12, "{limit}");
        assert!(limit - time < 1e-3 && limit - time > 1e-5, "closed at {time}");
    }

    #[test]
    fn a_contact_that_chatters_has_one_turn() {
        let mut rocking = Rocking::default();
        for (vertex, time) in [(0, 0.0), (1, 0.1), (1, 0.12), (1, 0.125), (0, 0.2)] {
            rocking.turn(corner(vertex), time);
        }
        assert_eq!((rocking.len, rocking.times[..3].to_vec()), (3, vec![0.0, 0.1, 0.2]));
    }

    #[test]
    fn a_third_contact_begins_anew() {
        let mut rocking = Rocking::default();
        for (vertex, time) in [(0, 0.0), (1, 0.1), (0, 0.2), (2, 0.3)] {
            rocking.turn(corner(vertex), time);
        }
        assert_eq!((rocking.len, rocking.pairs), (2, [Some(corner(2)), Some(corner(0))]));
    }

    /// Ratios of 0.6 and 0.33 in turn tell the same limit once by chance.
    #[test]
    fn turns_whose_ratio_changes_are_not_closed() {
        let times = [
            0.507_125_323_101,
            0.507_170_444_830,
            0.507_192_641_877,
            0.507_212_730_153,
            0.507_228_194_773,
            0.507_234_771_244,
            0.507_239_322_514,
            0.507_243_749_928,
            0.507_245_977_209,
            0.507_247_131_188,
            0.507_248_183_223,
        ];
        assert_eq!(told(times.windows(2).map(|t| t[1] - t[0]).chain([1.0])), None);
    }
}
