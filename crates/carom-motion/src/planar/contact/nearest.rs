//! Which features of a body and of what it meets are nearest to touching.

use super::World;
use super::kinematics::{Kinematics, Pairing, Turn, turns};
use crate::planar::geometry::State;
use crate::tolerance::FEATURE_SLACK;

/// Rods whose ends are this many times as far from a line as distances may differ are in line with it.
const IN_LINE: f64 = 4.0;

impl World {
    /// The pair of features of a body and what it meets that is nearest to touching. `left`: on which side of what it meets the body is, where that is
    /// known.
    pub(in crate::planar) fn nearest<const B: usize>(
        &self,
        states: &[State; B],
        meeting: (usize, usize),
        left: Option<bool>,
    ) -> Option<Pairing> {
        let turns = turns(states);
        let slack = FEATURE_SLACK * self.bodies[meeting.0].shape.size();
        // A rod in line with a segment touches it from the side on which it is known to be.
        let posed = (&states[meeting.0], turns[meeting.0]);
        let side = left.filter(|left| self.side_in_line(posed, meeting, (*left, IN_LINE * slack)).is_some());
        let across =
            |pair| side.is_some() && self.side_touched(posed.1, pair).is_some_and(|from| Some(from) != side);
        let mut best: Option<(Pairing, f64, f64)> = None;
        self.each_pair(meeting, |pair| {
            if self.extents(states, &turns, pair).iter().flatten().any(|(s, _)| *s < -slack) || across(pair) {
                return;
            }
            let k = self.kinematics_turned(states, &turns, pair);
            // Behind its obstacle a pair does not count; of pairs equally near, the one that closes slowest is what keeps the body out.
            let distance = k.gap.abs();
            let better = best.is_none_or(|(_, d, rate)| {
                distance < d - slack || (distance < d + slack && k.approach > rate)
            });
            if better && self.faces_body(states, &turns, pair, &k) {
                best = Some((pair, distance, k.approach));
            }
        });
        best.map(|(pair, _, _)| pair)
    }

    /// True where a body and what it meets lie on opposite sides of the pair's tangent, up to a small slack.
    fn faces_body(&self, states: &[State], turns: &[Turn], pair: Pairing, k: &Kinematics) -> bool {
        // Where they overlap, each reaches beyond the tangent by as much.
        let slack = FEATURE_SLACK * self.body_of(pair).shape.size() + (-k.gap).max(0.0);
        let [own, other] = self.beyond_tangent(states, turns, pair, k);
        // Where they are apart the other side begins a gap farther away.
        own <= slack
            && other + k.gap <= slack
            && !self.is_in_corner(pair, k, slack / self.body_of(pair).shape.size())
    }
}
