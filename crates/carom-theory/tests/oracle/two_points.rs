//! A plastic strike on K while A touches, walked in stages: at each the rates are found by trying every state of both contacts.
//!
//! The clock is N_K. Contacts that stick, slip or stay closed are solved for as one linear system; the hypothesis is kept if its
//! impulse rates, slips and separations all have the right signs. m = 1.

/// Velocities (v_x, v_y, ω clockwise) and impulses (N_A, T_A, N_K, T_K).
#[derive(Clone, Copy, Debug)]
pub struct Walked {
    pub q: [f64; 3],
    pub p: [f64; 4],
}

/// Rows: velocity of (n_A, t_A, n_K, t_K) per (v_x, v_y, ω).
pub struct Scene {
    pub rows: [[f64; 3]; 4],
    pub inertia: f64,
    pub friction: f64,
}

const SMALL: f64 = 1e-11;

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Contact A: open, or closed; then, as K: sticks, or slips with the tangential rate −direction·f·(normal rate).
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mode {
    Open,
    Sticks,
    Slips(f64),
}

impl Scene {
    fn velocities(&self, q: &[f64; 3]) -> [f64; 4] {
        [0, 1, 2, 3].map(|i| dot(&self.rows[i], q))
    }

    fn response(&self, i: usize, j: usize) -> f64 {
        let (a, b) = (&self.rows[i], &self.rows[j]);
        a[0] * b[0] + a[1] * b[1] + a[2] * b[2] / self.inertia
    }

    /// Impulse rates (with dN_K = 1) of a hypothesis, or `None` if its equations are singular.
    fn rates(&self, a: Mode, k: Mode) -> Option<[f64; 4]> {
        // Unknowns: N_A unless open, T_A if A sticks, T_K if K sticks. p = fixed + Σ unknown·column.
        let f = self.friction;
        let (mut fixed, mut columns, mut zeros) = ([0.0, 0.0, 1.0, 0.0], Vec::new(), Vec::new());
        match a {
            Mode::Open => {}
            Mode::Sticks => {
                columns.extend([[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0]]);
                zeros.extend([0, 1]);
            }
            Mode::Slips(sign) => {
                columns.push([1.0, -sign * f, 0.0, 0.0]);
                zeros.push(0);
            }
        }
        match k {
            Mode::Slips(sign) => fixed[3] = -sign * f,
            _ => {
                columns.push([0.0, 0.0, 0.0, 1.0]);
                zeros.push(3);
            }
        }
        let along = |p: &[f64; 4], i: usize| (0..4).map(|j| self.response(i, j) * p[j]).sum::<f64>();
        let matrix: Vec<Vec<f64>> =
            zeros.iter().map(|&i| columns.iter().map(|c| along(c, i)).collect()).collect();
        let right = zeros.iter().map(|&i| -along(&fixed, i)).collect();
        let solution = solve(matrix, right)?;
        for (x, column) in solution.iter().zip(&columns) {
            for (total, c) in fixed.iter_mut().zip(column) {
                *total += x * c;
            }
        }
        Some(fixed)
    }

    fn turn(&self, p: &[f64; 4]) -> [f64; 3] {
        let sum = |c: usize| (0..4).map(|i| self.rows[i][c] * p[i]).sum::<f64>();
        [sum(0), sum(1), sum(2) / self.inertia]
    }

    /// Does the hypothesis hold with the present velocities u?
    fn holds(&self, a: Mode, k: Mode, p: &[f64; 4], u: &[f64; 4]) -> bool {
        let du = self.velocities(&self.turn(p));
        let slips = |mode: Mode, slip: f64, rate: f64| match mode {
            Mode::Slips(sign) => {
                if slip.abs() > SMALL {
                    slip * sign > 0.0
                } else {
                    rate * sign > -SMALL
                }
            }
            _ => slip.abs() <= SMALL,
        };
        let within =
            |mode: Mode, n: f64, t: f64| mode != Mode::Sticks || t.abs() <= self.friction * n + SMALL;
        let a_holds = match a {
            Mode::Open => u[0] > SMALL || du[0] >= -SMALL,
            _ => u[0] <= SMALL && p[0] >= -SMALL && slips(a, u[1], du[1]) && within(a, p[0], p[1]),
        };
        a_holds && slips(k, u[3], du[3]) && within(k, 1.0, p[3])
    }

    /// Walks until K no longer approaches, or nothing moves; `None` if some stage has no solution.
    pub fn walk(&self, start: [f64; 3]) -> Option<Walked> {
        let modes = [Mode::Sticks, Mode::Slips(1.0), Mode::Slips(-1.0), Mode::Open];
        let mut at = Walked { q: start, p: [0.0; 4] };
        for _ in 0..20 {
            let u = self.velocities(&at.q);
            if u[2] >= -SMALL {
                return Some(at);
            }
            let mut kept = None;
            for a in modes {
                for k in [Mode::Sticks, Mode::Slips(1.0), Mode::Slips(-1.0)] {
                    if kept.is_none() {
                        kept = self.rates(a, k).filter(|p| self.holds(a, k, p, &u));
                    }
                }
            }
            let p = kept?;
            let turn = self.turn(&p);
            let du = self.velocities(&turn);
            // The next of: K stops approaching, A closes again, a slip stops.
            let step = [0, 1, 2, 3]
                .into_iter()
                .filter(|&i| (i != 0 || u[0] > SMALL) && (i != 1 || u[0] <= SMALL))
                .filter(|&i| u[i].abs() > SMALL && u[i] * du[i] < 0.0)
                .map(|i| -u[i] / du[i])
                .fold(f64::INFINITY, f64::min);
            if !step.is_finite() {
                return None;
            }
            at.q = [0, 1, 2].map(|i| at.q[i] + step * turn[i]);
            at.p = [0, 1, 2, 3].map(|i| at.p[i] + step * p[i]);
        }
        None
    }
}

/// Gauss elimination with row exchange; `None` if singular.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Option<Vec<f64>> {
    let n = b.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|&x, &y| a[x][i].abs().total_cmp(&a[y][i].abs()))?;
        if a[pivot][i].abs() < 1e-13 {
            return None;
        }
        a.swap(i, pivot);
        b.swap(i, pivot);
        for row in i + 1..n {
            let factor = a[row][i] / a[i][i];
            let pivot = a[i].clone();
            for (entry, p) in a[row].iter_mut().zip(&pivot).skip(i) {
                *entry -= factor * p;
            }
            b[row] -= factor * b[i];
        }
    }
    for i in (0..n).rev() {
        for column in i + 1..n {
            b[i] -= a[i][column] * b[column];
        }
        b[i] /= a[i][i];
    }
    Some(b)
}
