//! Constraint drift: the least motion, in the mass metric, that closes the gaps and stops the rates of held contacts.

use super::kinematics::{Kinematics, Pairing, Turn};
use super::mode::Held;
use super::touching::{Few, MOST_TOUCHING};
use super::walker::Walker;
use super::{State, World};
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::solve::{solve_any, solve_regular};

/// Rows of constraints: a normal and a tangent for each contact.
const ROWS: usize = 2 * MOST_TOUCHING;
/// Residuals below this, in the world's own units, are left.
const NEGLIGIBLE: f64 = 1e-15;

/// A direction at an arm, and how much motion along it is too much.
#[derive(Clone, Copy, Debug, Default)]
struct Row {
    direction: Vec2,
    moment: f64,
    residual: f64,
}

fn row(k: &Kinematics, direction: Vec2, residual: f64) -> Row {
    Row { direction, moment: k.arm.cross(direction), residual }
}

impl World {
    /// The least shift (of the centre, of the angle) in the mass metric that takes the residuals of the rows away.
    fn least_shift(&self, rows: &[Row]) -> (Vec2, f64) {
        let (m, j) = (self.body.mass, self.body.inertia);
        if let [a] = rows {
            let p = -a.residual / (a.direction.dot(a.direction) / m + a.moment * a.moment / j);
            return (a.direction * (p / m), a.moment * p / j);
        }
        let (mut matrix, mut right) = ([[0.0; ROWS]; ROWS], [0.0; ROWS]);
        for (i, a) in rows.iter().enumerate() {
            right[i] = -a.residual;
            for (k, b) in rows.iter().enumerate() {
                matrix[i][k] = a.direction.dot(b.direction) / m + a.moment * b.moment / j;
            }
        }
        let n = rows.len();
        let x = solve_regular(matrix, right, n, 1e-10)
            .or_else(|| solve_any(matrix, right, n, 1e-6).map(|s| s.point));
        let mut shift = (Vec2::ZERO, 0.0);
        for (p, a) in x.unwrap_or([0.0; ROWS]).iter().zip(rows) {
            shift.0 += a.direction * (p / m);
            shift.1 += a.moment * p / j;
        }
        shift
    }
}

impl Walker<'_> {
    /// The state with the gaps and rates of the held contacts taken back to zero.
    pub(super) fn projected(&self, state: &State) -> State {
        self.projected_onto(state, &self.held)
    }

    pub(super) fn projected_onto(&self, state: &State, held: &Few<Held>) -> State {
        let mut out = self.closed_up(state, held.iter().map(|h| h.pair));
        let mut rows = [Row::default(); ROWS];
        let mut worst = 0.0_f64;
        let (turn, mut n) = (Turn::of(&out), 0);
        for h in held.iter() {
            let k = self.world.kinematics_turned(&out, turn, h.pair);
            rows[n] = row(&k, k.normal, k.approach);
            worst = worst.max(k.approach.abs());
            n += 1;
            if h.slip == Slip::Sticks {
                rows[n] = row(&k, k.tangent(), k.slip);
                worst = worst.max(k.slip.abs());
                n += 1;
            }
        }
        if worst > NEGLIGIBLE * self.scales.speed {
            let (shift, spin) = self.world.least_shift(&rows[..n]);
            out.twist.velocity += shift;
            out.twist.spin += spin;
        }
        out
    }

    /// The state with the gaps of these pairs taken back to zero; velocities stay.
    pub(super) fn closed_up(&self, state: &State, pairs: impl Iterator<Item = Pairing>) -> State {
        let mut out = *state;
        let mut rows = [Row::default(); ROWS];
        let (mut worst, mut n) = (0.0_f64, 0);
        let turn = Turn::of(&out);
        for (r, pair) in rows.iter_mut().zip(pairs) {
            let k = self.world.kinematics_turned(&out, turn, pair);
            *r = row(&k, k.normal, k.gap);
            worst = worst.max(k.gap.abs());
            n += 1;
        }
        if worst > NEGLIGIBLE * self.scales.length {
            let (shift, angle) = self.world.least_shift(&rows[..n]);
            out.pose.centre += shift;
            out.pose.angle += angle;
        }
        out
    }
}
