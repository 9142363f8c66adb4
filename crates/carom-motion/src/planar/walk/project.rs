//! Constraint drift: the least motion, in the mass metric, that closes the gaps and stops the rates of held contacts.

use crate::planar::contact::{
    World,
    kinematics::{Kinematics, Pairing, Turn},
    touching::{Few, MOST_TOUCHING},
};
use crate::planar::geometry::State;
use crate::planar::modes::{
    line::{Line, Mobility},
    mode::Held,
};
use crate::planar::walk::walker::Walker;
use crate::tolerance::{
    MOST_AMPLIFIED, MOST_STOPPED_RATE, NEGLIGIBLE_RESIDUAL, PROJECTED_RATE, PROJECTION_RANK,
    REGULAR_PROJECTION,
};
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::solve::{solve_any, solve_regular};

/// Rows of constraints: a normal and a tangent for each contact.
const ROWS: usize = 2 * MOST_TOUCHING;
/// Rows of two contacts, the most that a lone body mostly holds.
const FEW_ROWS: usize = 4;

/// A line through a contact, and how much motion along it is too much.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Row {
    pub(super) line: Line,
    pub(super) residual: f64,
}

impl World {
    /// The least shifts (of the centres, of the angles) in the mass metric that take the residuals of the rows away.
    fn least_shift<const B: usize, const R: usize>(&self, rows: &[Row]) -> [(Vec2, f64); B] {
        let mut shift = [(Vec2::ZERO, 0.0); B];
        let mut add = |line: &Line, p: f64| {
            for (body, along, angle) in self.motion_along(line) {
                shift[body].0 += along * p;
                shift[body].1 += angle * p;
            }
        };
        if let ([a], [body]) = (rows, &self.bodies[..]) {
            // One contact of a lone body.
            let Mobility { linear, angular } = Mobility::of(body);
            let response = linear + a.line.moment * a.line.moment * angular;
            let p = -a.residual / response;
            shift[0] = (a.line.direction * (p * linear), a.line.moment * p * angular);
            return shift;
        }
        if let [a] = rows {
            add(&a.line, -a.residual / self.response(&a.line, &a.line));
            return shift;
        }
        let (mut matrix, mut right) = ([[0.0; R]; R], [0.0; R]);
        for (i, a) in rows.iter().enumerate() {
            right[i] = -a.residual;
            for (k, b) in rows.iter().enumerate() {
                matrix[i][k] = self.response(&a.line, &b.line);
            }
        }
        let n = rows.len();
        let x = solve_regular(matrix, right, n, REGULAR_PROJECTION)
            .or_else(|| solve_any(matrix, right, n, PROJECTION_RANK).map(|s| s.point));
        for (p, a) in x.unwrap_or([0.0; R]).iter().zip(rows) {
            add(&a.line, *p);
        }
        shift
    }
}

impl<const B: usize> Walker<'_, B> {
    /// The states with the gaps and rates of the held contacts taken back to zero.
    pub(in crate::planar) fn projected(&self, states: &[State; B]) -> [State; B] {
        self.projected_onto(states, &self.held)
    }

    pub(in crate::planar) fn projected_onto(&self, states: &[State; B], held: &Few<Held>) -> [State; B] {
        if held.len() <= FEW_ROWS / 2 {
            self.projected_by::<FEW_ROWS>(states, held)
        } else {
            self.projected_by::<ROWS>(states, held)
        }
    }

    fn projected_by<const R: usize>(&self, states: &[State; B], held: &Few<Held>) -> [State; B] {
        let mut seen = [Kinematics::default(); R];
        let (mut out, turns) = self.closed_up_by(states, held.iter().map(|h| h.pair), &mut seen);
        let mut rows = [Row::default(); R];
        let (mut worst, mut n) = (0.0_f64, 0);
        for (h, known) in held.iter().zip(&seen) {
            let k = match &turns {
                None => *known,
                Some(turns) => self.world.kinematics_turned(&out, turns, h.pair),
            };
            rows[n] = Row { line: self.world.line(&k, h.pair, k.normal), residual: k.approach };
            worst = worst.max(k.approach.abs());
            n += 1;
            if h.slip == Slip::Sticks {
                rows[n] = Row { line: self.world.line(&k, h.pair, k.tangent()), residual: k.slip };
                worst = worst.max(k.slip.abs());
                n += 1;
            }
        }
        if worst > NEGLIGIBLE_RESIDUAL * self.scales.speed {
            let shifts = self.slowed::<R>(&rows[..n]);
            for (state, (velocity, spin)) in out.iter_mut().zip(shifts) {
                state.twist.velocity += velocity;
                state.twist.spin += spin;
            }
        }
        out
    }

    /// Changes of the velocities that take the rates of these rows away. They stay small where rows almost say the same.
    fn slowed<const R: usize>(&self, rows: &[Row]) -> [(Vec2, f64); B] {
        let shifts = self.world.least_shift::<B, R>(rows);
        if rows.len() == 1 {
            return shifts;
        }
        let left = |row: &Row| (row.residual + self.world.rate_along(&row.line, &shifts)).abs();
        if rows.iter().map(left).fold(0.0, f64::max) <= PROJECTED_RATE * self.scales.speed {
            return shifts;
        }
        let whole = self.world.shift_by_directions::<B, R>(rows);
        if self.size_of(&whole) <= MOST_STOPPED_RATE * self.scales.speed { whole } else { shifts }
    }

    /// The largest of some shifts, turns by the world's length.
    fn size_of(&self, shifts: &[(Vec2, f64); B]) -> f64 {
        let size = |(way, angle): &(Vec2, f64)| way.norm().max(angle.abs() * self.scales.length);
        shifts.iter().map(size).fold(0.0, f64::max)
    }

    /// The states with the gaps of these pairs taken back to zero; velocities stay.
    pub(in crate::planar) fn closed_up(&self, states: &[State; B], pairs: &Few<Pairing>) -> [State; B] {
        let each = pairs.iter().copied();
        if pairs.len() <= FEW_ROWS {
            self.closed_up_by(states, each, &mut [Kinematics::default(); FEW_ROWS]).0
        } else {
            self.closed_up_by(states, each, &mut [Kinematics::default(); ROWS]).0
        }
    }

    /// As [`Walker::closed_up`]. Leaves in `seen` the kinematics before, and returns the turns after where anything was shifted.
    fn closed_up_by<const R: usize>(
        &self,
        states: &[State; B],
        pairs: impl Iterator<Item = Pairing> + Clone,
        seen: &mut [Kinematics; R],
    ) -> ([State; B], Option<[Turn; B]>) {
        let mut out = *states;
        let turns = self.turned.of(&out);
        let (mut worst, mut n) = (0.0_f64, 0);
        for (k, pair) in seen.iter_mut().zip(pairs.clone()) {
            *k = self.world.kinematics_turned(&out, &turns, pair);
            worst = worst.max(k.gap.abs());
            n += 1;
        }
        if worst <= NEGLIGIBLE_RESIDUAL * self.scales.length {
            return (out, None);
        }
        let mut rows = [Row::default(); R];
        for (r, (k, pair)) in rows.iter_mut().zip(seen.iter().zip(pairs)) {
            *r = Row { line: self.world.line(k, pair, k.normal), residual: k.gap };
        }
        let shifts = self.world.least_shift::<B, R>(&rows[..n]);
        if self.size_of(&shifts) > MOST_AMPLIFIED * worst {
            // Contacts that say almost the same in different ways: no motion so large is meant.
            return (out, None);
        }
        let mut after = turns;
        for ((state, turn), (way, angle)) in out.iter_mut().zip(&mut after).zip(shifts) {
            state.pose.centre += way;
            state.pose.angle += angle;
            *turn = turn.turned(state, angle);
        }
        (out, Some(after))
    }
}
