//! The exact law of a rate problem, as a judge that knows no hypotheses, and a search by it.
//!
//! Signorini and Coulomb together say that rates p of a contact with response w are what they are projected to from `p − w`: the normal rate onto all above
//! its base load, the tangential rate onto the disc of radius μ r. How far they are from it is the judge's number; Newton's method on that, from rates
//! drawn at random, is the search. It shares nothing with the kernel, which guesses what every contact does and looks for directions.

use carom_impact::Load;
use carom_impact::spatial::RateProblem;
use carom_num::Vec3;
use carom_num::elementary::{ln, sin_cos};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

/// Unknowns: three rates of each of four contacts.
const MOST: usize = 12;
/// Newton's steps from one start.
const STEPS: u32 = 40;
/// Pivots below this fraction of the first are none: contacts hold each other.
const RANK: f64 = 1e-10;
/// Rates violate the law by no more than this, in units of what one contact would take alone.
pub(crate) const EXACT: f64 = 1e-9;
/// Motions nearer than this share of the largest velocity are one.
pub(crate) const SAME: f64 = 1e-6;

/// A rate problem and its natural units.
pub(crate) struct ExactLaw<'p, 'a, const N: usize> {
    problem: &'p RateProblem<'a, N>,
    /// What a contact's own rate answers a velocity with.
    mobility: [[f64; 2]; N],
    unit: f64,
}

impl<'p, 'a, const N: usize> ExactLaw<'p, 'a, N> {
    pub(crate) fn of(problem: &'p RateProblem<'a, N>) -> Self {
        let mobility = std::array::from_fn(|i| {
            let [a, b, c] = problem.operator[i][i].rows;
            [a.x.max(b.y), c.z]
        });
        let drive = |i: usize| problem.drive[i].norm() / problem.operator[i][i].rows[2].z;
        let unit = (0..problem.count).map(|i| drive(i).max(base(problem.load[i]))).fold(0.0, f64::max);
        Self { problem, mobility, unit }
    }

    pub(crate) fn response(&self, rates: &[Vec3; N]) -> [Vec3; N] {
        std::array::from_fn(|i| {
            let by = |w: Vec3, j: usize| w + self.problem.operator[i][j] * rates[j];
            (0..self.problem.count).fold(self.problem.drive[i], by)
        })
    }

    /// The largest violation of the law, in units of what one contact would take alone.
    pub(crate) fn violation(&self, rates: &[Vec3; N]) -> f64 {
        let w = self.response(rates);
        let of = |i: usize| (rates[i] - self.projected(i, rates[i], w[i]).0).norm();
        (0..self.problem.count).map(of).fold(0.0, f64::max) / self.unit
    }

    /// What the law makes of rates p and response w, and its derivatives by p and by w.
    fn projected(&self, i: usize, p: Vec3, w: Vec3) -> (Vec3, [[Vec3; 3]; 2]) {
        let (mu, zero) = (self.problem.friction[i], Vec3::ZERO);
        let [across, along] = self.mobility[i];
        let (mut out, mut by_p, mut by_w) = (zero, [zero; 3], [zero; 3]);
        match self.problem.load[i] {
            Load::Absent => return (zero, [by_p, by_w]),
            Load::Prescribed(base) => out.z = base,
            Load::Touching(base) => {
                out.z = (p.z - w.z / along).max(base);
                if p.z - w.z / along > base {
                    (by_p[2], by_w[2]) = (Vec3::Z, Vec3::Z * (-1.0 / along));
                }
            }
        }
        let [x, y] = self.problem.slip[i];
        let (slip, radius) = ((x * x + y * y).sqrt(), mu * p.z.max(0.0));
        if slip > 0.0 {
            (out.x, out.y) = (-radius * x / slip, -radius * y / slip);
            let growth = if p.z > 0.0 { mu } else { 0.0 };
            (by_p[0], by_p[1]) = (Vec3::Z * (-growth * x / slip), Vec3::Z * (-growth * y / slip));
            return (out, [by_p, by_w]);
        }
        let (a, b) = (p.x - w.x / across, p.y - w.y / across);
        let far = (a * a + b * b).sqrt();
        if far <= radius {
            (out.x, out.y) = (a, b);
            (by_p[0], by_p[1]) = (Vec3::X, Vec3::Y);
            (by_w[0], by_w[1]) = (Vec3::X * (-1.0 / across), Vec3::Y * (-1.0 / across));
        } else {
            let (c, s) = (a / far, b / far);
            (out.x, out.y) = (radius * c, radius * s);
            let growth = if p.z > 0.0 { mu } else { 0.0 };
            let turn = radius / far;
            let rows = [Vec3::new(s * s, -c * s, 0.0) * turn, Vec3::new(-c * s, c * c, 0.0) * turn];
            (by_p[0], by_p[1]) = (rows[0] + Vec3::Z * (growth * c), rows[1] + Vec3::Z * (growth * s));
            (by_w[0], by_w[1]) = (rows[0] * (-1.0 / across), rows[1] * (-1.0 / across));
        }
        (out, [by_p, by_w])
    }

    /// Newton's method from these rates.
    pub(crate) fn polished(&self, mut rates: [Vec3; N]) -> Option<[Vec3; N]> {
        let n = 3 * self.problem.count;
        for _ in 0..STEPS {
            if self.violation(&rates) < 1e-3 * EXACT {
                break;
            }
            let w = self.response(&rates);
            let (mut matrix, mut right) = ([[0.0; MOST]; MOST], [0.0; MOST]);
            for i in 0..self.problem.count {
                let (out, [by_p, by_w]) = self.projected(i, rates[i], w[i]);
                let miss = (out - rates[i]).to_array();
                for axis in 0..3 {
                    right[3 * i + axis] = miss[axis];
                    for j in 0..self.problem.count {
                        // A row of (derivative by w) W.
                        let row = self.problem.operator[i][j].transposed() * by_w[axis];
                        let own = if i == j { by_p[axis] } else { Vec3::ZERO };
                        for (k, v) in (row + own).to_array().into_iter().enumerate() {
                            matrix[3 * i + axis][3 * j + k] = -v;
                        }
                    }
                    matrix[3 * i + axis][3 * i + axis] += 1.0;
                }
            }
            let step = eliminated(&mut matrix, &mut right, n);
            for i in 0..self.problem.count {
                rates[i] += Vec3::new(step[3 * i], step[3 * i + 1], step[3 * i + 2]);
            }
            if !rates.iter().all(|p| p.is_finite()) {
                return None;
            }
        }
        (self.violation(&rates) < EXACT).then_some(rates)
    }

    /// All rates found from so many random starts, whose motions differ.
    pub(crate) fn search(&self, starts: u32, seed: u64) -> Vec<[Vec3; N]> {
        let mut random = Pcg64::seed_from_u64(seed);
        let mut found: Vec<[Vec3; N]> = vec![];
        for _ in 0..starts {
            let rates = std::array::from_fn(|i| {
                if i >= self.problem.count || matches!(self.problem.load[i], Load::Absent) {
                    return Vec3::ZERO;
                }
                let r = base(self.problem.load[i]) - self.unit * ln(random.random_range(1e-6_f64..1.0));
                let (turn, share) =
                    (random.random_range(0.0..std::f64::consts::TAU), random.random_range(0.0..1.5));
                let (q, (sin, cos)) = (self.problem.friction[i] * r * share, sin_cos(turn));
                Vec3::new(q * cos, q * sin, r)
            });
            if let Some(rates) = self.polished(rates)
                && !found.iter().any(|other| self.same(other, &rates))
            {
                found.push(rates);
            }
        }
        found
    }

    /// True where both bring the same motion about.
    pub(crate) fn same(&self, one: &[Vec3; N], other: &[Vec3; N]) -> bool {
        let [a, b] = [one, other].map(|rates| self.response(rates));
        let largest = a.iter().chain(&b).chain(&self.problem.drive).map(|v| v.norm()).fold(0.0, f64::max);
        (0..self.problem.count).all(|i| (a[i] - b[i]).norm() <= SAME * largest)
    }
}

fn base(load: Load) -> f64 {
    match load {
        Load::Absent => 0.0,
        Load::Touching(base) | Load::Prescribed(base) => base,
    }
}

/// Gauss's elimination with the largest pivot; unknowns without one stay as they are.
fn eliminated(matrix: &mut [[f64; MOST]; MOST], right: &mut [f64; MOST], n: usize) -> [f64; MOST] {
    let mut column: [usize; MOST] = std::array::from_fn(|k| k);
    let (mut rank, mut first) = (0, 0.0);
    while rank < n {
        let places = (rank..n).flat_map(|i| (rank..n).map(move |j| (i, j)));
        let size = |&(i, j): &(usize, usize)| matrix[i][column[j]].abs();
        let Some(pivot) = places.max_by(|a, b| size(a).total_cmp(&size(b))) else { break };
        let largest = size(&pivot);
        if rank == 0 {
            first = largest;
        }
        if largest <= RANK * first {
            break;
        }
        matrix.swap(rank, pivot.0);
        right.swap(rank, pivot.0);
        column.swap(rank, pivot.1);
        for i in rank + 1..n {
            let by = matrix[i][column[rank]] / matrix[rank][column[rank]];
            if by != 0.0 {
                for c in &column[rank..n] {
                    matrix[i][*c] -= by * matrix[rank][*c];
                }
                right[i] -= by * right[rank];
            }
        }
        rank += 1;
    }
    let mut x = [0.0; MOST];
    for k in (0..rank).rev() {
        let known: f64 = (k + 1..rank).map(|j| matrix[k][column[j]] * x[column[j]]).sum();
        x[column[k]] = (right[k] - known) / matrix[k][column[k]];
    }
    x
}
