//! Contacts that start to slip together, as one motion.
//!
//! What holds and what sticks leaves a body few motions: with three feet that hold those of a plane, with one that sticks and another that holds a turn
//! about both. A motion gives the direction of every slip at once. The directions give the rates, and the rates give the motion that follows: the
//! hypothesis is consistent where that is the motion that was assumed. Scaled to size 1, a motion is a place on a circle or on a sphere, however
//! many contacts there are.
//!
//! The sphere is covered with triangles, small enough that no slip turns far over one; near a motion about a contact, whose slip takes all directions there,
//! they are halved again and again. Where the motions that follow surround the assumed one there is such a place, and Newton's method goes to it.

use super::answer::{Guess, Mode};
use super::equations::{Hypothesis, MOST, component};
use super::rate::RateProblem;
use super::starts::{Directions, additive};
use crate::tolerance::{MAY_PUSH_BESIDE, NO_MOTION, RANK};
use carom_num::elementary::sin_cos;
use carom_num::normal::quantile;
use carom_num::solve::solve_any;
use carom_num::{Rotation, Vec3};
use std::f64::consts::TAU;

/// Most motions that are searched.
const MOST_FREEDOM: usize = 8;
/// Triangles of the icosahedron are halved this often whatever is in them: their sides are 0.3 rad then.
const ALWAYS: u32 = 2;
/// And at most so often: 1e-3 rad.
const MOST_HALVINGS: u32 = 10;
/// Between neighbours no slip turns by more, as its cosine: a third of a radian.
const TURNS_LITTLE: f64 = 0.945;
/// Steps around a circle of motions.
const SCAN: u32 = 96;
/// Where the first of them begins [steps]: not at the motion that the drive causes, which is often the one that is sought, and lies then on the seam.
const BEGINS: f64 = 0.37;
/// Of more motions than a sphere so many are tried, and of these so many are followed.
const LOOKS: usize = 600;
const BEST: usize = 40;
/// A place is sought beyond the sides of a triangle by this share of it: what follows is not linear.
const BEYOND: f64 = 0.5;

/// Motions that contacts which start to slip have in common.
pub(super) struct Motions<'p, const N: usize> {
    problem: &'p RateProblem<'p, N>,
    guess: &'p [Guess; N],
    /// Directions of contacts that slip already.
    direction: Directions<N>,
    /// Slips of the contacts that start, orthonormal over all of them.
    basis: Vec<Directions<N>>,
    /// Their slips in the motion that the drive causes; none where nothing does what the hypothesis says.
    driven: Option<Directions<N>>,
}

/// A motion by its parts along the basis.
type Place = [f64; MOST_FREEDOM];

/// A motion that is assumed, and what follows from it.
#[derive(Clone, Copy)]
struct Look<const N: usize> {
    at: Place,
    /// The motion that follows, of size 1.
    follows: Place,
    direction: Directions<N>,
    /// Contacts whose rates pull, one bit each.
    pulls: u32,
}

impl<const N: usize> RateProblem<'_, N> {
    /// The motions in which these contacts may start to slip; `None` where they are more than can be searched.
    pub(super) fn motions<'p>(
        &'p self,
        guess: &'p [Guess; N],
        direction: Directions<N>,
        starting: &[usize],
    ) -> Option<Motions<'p, N>> {
        let active = (0..self.count).filter(|&j| guess[j].mode != Mode::Open).count();
        let all = match active {
            0..=2 => self.slips_left::<6>(guess, starting),
            3..=4 => self.slips_left::<12>(guess, starting),
            5..=8 => self.slips_left::<24>(guess, starting),
            _ => self.slips_left::<MOST>(guess, starting),
        };
        let driven = all.first().copied();
        Some(Motions { problem: self, guess, direction, basis: independent(all)?, driven })
    }

    /// Slips of the starting contacts that holding and sticking contacts permit, for any rates of the others. The first is the one that the drive
    /// causes.
    fn slips_left<const M: usize>(&self, guess: &[Guess; N], starting: &[usize]) -> Vec<Directions<N>> {
        let active = || (0..self.count).filter(|&j| guess[j].mode != Mode::Open);
        let (mut matrix, mut right, mut rows) = ([[0.0; M]; M], [0.0; M], 0);
        for i in active() {
            let sticks = guess[i].mode == Mode::Sticks;
            for (axis, fixed) in [sticks, sticks, guess[i].holds].into_iter().enumerate() {
                if fixed {
                    let entries = active().flat_map(|j| self.operator[i][j].rows[axis].to_array());
                    matrix[rows].iter_mut().zip(entries).for_each(|(place, entry)| *place = entry);
                    right[rows] = -component(self.drive[i], axis);
                    rows += 1;
                }
            }
        }
        // Nothing does what the hypothesis says.
        let Some(family) = solve_any(matrix, right, 3 * active().count(), RANK) else { return vec![] };
        let slip = |rates: &[f64; M], driven: f64| {
            let (mut slip, mut terms) = ([[0.0; 2]; N], 0.0);
            for &i in starting {
                let drive = self.drive[i] * driven;
                slip[i] = [drive.x, drive.y];
                terms += drive.norm();
                for (c, j) in active().enumerate() {
                    let by =
                        self.operator[i][j] * Vec3::new(rates[3 * c], rates[3 * c + 1], rates[3 * c + 2]);
                    slip[i] = [slip[i][0] + by.x, slip[i][1] + by.y];
                    terms += by.norm();
                }
            }
            if dot(&slip, &slip).sqrt() > NO_MOTION * terms { slip } else { [[0.0; 2]; N] }
        };
        let free = family.free[..family.freedom].iter().map(|rates| slip(rates, 0.0));
        std::iter::once(slip(&family.point, 1.0)).chain(free).collect()
    }
}

fn dot<const N: usize>(a: &Directions<N>, b: &Directions<N>) -> f64 {
    a.iter().zip(b).map(|([x, y], [u, v])| x * u + y * v).sum()
}

/// An orthonormal basis, from the largest on; `None` of more than [`MOST_FREEDOM`].
fn independent<const N: usize>(mut all: Vec<Directions<N>>) -> Option<Vec<Directions<N>>> {
    let size = |of: &Directions<N>| dot(of, of).sqrt();
    let mut basis: Vec<Directions<N>> = vec![];
    all.retain(|of| size(of) > 0.0);
    for of in &mut all {
        let length = size(of);
        of.iter_mut().flatten().for_each(|x| *x /= length);
    }
    while let Some(next) = all.iter().copied().max_by(|a, b| size(a).total_cmp(&size(b))) {
        if size(&next) <= NO_MOTION {
            break;
        }
        if basis.len() == MOST_FREEDOM {
            return None;
        }
        let unit = next.map(|[x, y]| [x / size(&next), y / size(&next)]);
        for other in &mut all {
            // Twice is enough for rounding.
            for _ in 0..2 {
                let along = dot(other, &unit);
                other
                    .iter_mut()
                    .zip(&unit)
                    .for_each(|(o, u)| *o = [o[0] - along * u[0], o[1] - along * u[1]]);
            }
        }
        basis.push(unit);
    }
    Some(basis)
}

impl<const N: usize> Motions<'_, N> {
    /// How many of them are independent: they are a point, two points, a circle or a sphere.
    pub(in crate::spatial) fn freedom(&self) -> usize {
        self.basis.len()
    }

    /// Hands the directions of the motion that the drive causes to `visit`.
    pub(super) fn driven(&self, visit: &mut impl FnMut(&Directions<N>)) {
        let Some(driven) = &self.driven else { return };
        let mut at = [0.0; MOST_FREEDOM];
        at.iter_mut().zip(&self.basis).for_each(|(part, basis)| *part = dot(basis, driven));
        self.look(at).iter().for_each(|look| visit(&look.direction));
    }

    /// Hands directions to `visit`: both where there are two, else those near which the motion that follows seems to be the assumed one.
    pub(super) fn each_near(&self, visit: &mut impl FnMut(&Directions<N>)) {
        match self.freedom() {
            0 => {}
            1 => {
                let looks = [1.0, -1.0].map(|sign| self.look(place(Vec3::X * sign)));
                looks.iter().flatten().for_each(|look| visit(&look.direction));
            }
            2 => self.circle(visit),
            3 => self.sphere(visit),
            _ => self.best(visit),
        }
    }

    /// The motion that follows from an assumed one; `None` where nothing can be said.
    fn look(&self, at: Place) -> Option<Look<N>> {
        let mut direction = self.direction;
        for (i, place) in direction.iter_mut().enumerate().take(self.problem.count) {
            if self.guess[i].mode == Mode::Starts {
                let sum =
                    |axis: usize| self.basis.iter().zip(at).map(|(b, part)| part * b[i][axis]).sum::<f64>();
                let (x, y) = (sum(0), sum(1));
                let length = (x * x + y * y).sqrt();
                *place = [x / length, y / length];
            }
        }
        // A motion about a contact gives it no slip, and so no direction.
        if !direction.iter().flatten().all(|e| e.is_finite()) {
            return None;
        }
        let hypothesis = Hypothesis { problem: self.problem, guess: self.guess, direction };
        let rates = hypothesis.shared()?;
        let (response, _) = self.problem.response(&rates);
        let slips: Directions<N> = std::array::from_fn(|i| {
            if self.guess[i].mode == Mode::Starts { [response[i].x, response[i].y] } else { [0.0; 2] }
        });
        let size = dot(&slips, &slips).sqrt();
        let mut follows = [0.0; MOST_FREEDOM];
        follows.iter_mut().zip(&self.basis).for_each(|(part, basis)| *part = dot(basis, &slips) / size);
        let total: f64 = rates.iter().map(|p| p.norm()).sum();
        let mut pulls = 0;
        for i in (0..self.problem.count).filter(|&i| self.guess[i].holds) {
            pulls |= u32::from(rates[i].z - self.problem.base(i) < -MAY_PUSH_BESIDE * total) << i;
        }
        follows[0].is_finite().then_some(Look { at, follows, direction, pulls })
    }

    /// Around a circle of motions.
    fn circle(&self, visit: &mut impl FnMut(&Directions<N>)) {
        let at = |turn: f64| {
            let (sin, cos) = sin_cos(TAU * (turn + BEGINS) / f64::from(SCAN));
            self.look(place(Vec3::new(cos, sin, 0.0)))
        };
        for step in 0..SCAN {
            let mut ends = [f64::from(step), f64::from(step + 1)];
            let mut sides = vec![(ends, 0)];
            while let Some((turns, halvings)) = sides.pop() {
                ends = turns;
                let [Some(one), Some(other)] = ends.map(at) else { continue };
                if halvings < MOST_HALVINGS && self.turns(&one, &other) {
                    let middle = 0.5 * (ends[0] + ends[1]);
                    sides.extend([([ends[0], middle], halvings + 1), ([middle, ends[1]], halvings + 1)]);
                    continue;
                }
                let aside = |look: &Look<N>| look.at[0] * look.follows[1] - look.at[1] * look.follows[0];
                let [a, b] = [aside(&one), aside(&other)];
                let goes_on = one.goes_on() > 0.0 || other.goes_on() > 0.0;
                if (a > 0.0) != (b > 0.0) && goes_on {
                    let share = a / (a - b);
                    if let Some(near) = at(ends[0] + share * (ends[1] - ends[0])) {
                        visit(&near.direction);
                    }
                }
            }
        }
    }

    /// Where there are more motions than a sphere: those whose following motion is nearest to the assumed one.
    fn best(&self, visit: &mut impl FnMut(&Directions<N>)) {
        let looks = (0..LOOKS).filter_map(|number| {
            let mut at = [0.0; MOST_FREEDOM];
            for (axis, part) in at.iter_mut().enumerate().take(self.freedom()) {
                *part = quantile(additive(number, axis));
            }
            let size = at.iter().map(|x| x * x).sum::<f64>().sqrt();
            self.look(at.map(|x| x / size))
        });
        let mut looks: Vec<Look<N>> = looks.collect();
        looks.sort_by(|a, b| {
            (a.pulls.count_ones(), b.goes_on())
                .partial_cmp(&(b.pulls.count_ones(), a.goes_on()))
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        looks.iter().take(BEST).for_each(|look| visit(&look.direction));
    }

    /// True where a slip turns far from one to the other.
    fn turns(&self, one: &Look<N>, other: &Look<N>) -> bool {
        let mut pairs = one.direction.iter().zip(&other.direction).zip(self.guess);
        pairs.any(|(([x, y], [u, v]), guess)| guess.mode == Mode::Starts && x * u + y * v < TURNS_LITTLE)
    }

    /// Over a sphere of motions, beginning with an icosahedron.
    fn sphere(&self, visit: &mut impl FnMut(&Directions<N>)) {
        // Askew, so that what is symmetric in the frame does not lie on its sides.
        let askew = Rotation::by(Vec3::new(0.3, 0.5, 0.7));
        let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
        let mut corners = vec![];
        for a in [1.0, -1.0] {
            for b in [golden, -golden] {
                corners.extend([Vec3::new(0.0, a, b), Vec3::new(a, b, 0.0), Vec3::new(b, 0.0, a)]);
            }
        }
        let looks: Vec<Option<Look<N>>> =
            corners.iter().map(|&corner| self.look(place(askew.apply(corner).unit()?))).collect();
        // Neighbours are 2 apart, all others farther.
        let near = |i: usize, j: usize| (corners[i] - corners[j]).norm() < 2.5;
        for i in 0..12 {
            for j in (0..i).filter(|&j| near(i, j)) {
                for k in (0..j).filter(|&k| near(i, k) && near(j, k)) {
                    if let [Some(a), Some(b), Some(c)] = [looks[i], looks[j], looks[k]] {
                        self.triangle([a, b, c], 0, visit);
                    }
                }
            }
        }
    }

    fn triangle(&self, corners: [Look<N>; 3], halvings: u32, visit: &mut impl FnMut(&Directions<N>)) {
        let [a, b, c] = corners;
        let turns = || self.turns(&a, &b) || self.turns(&b, &c) || self.turns(&c, &a);
        if halvings < ALWAYS || (halvings < MOST_HALVINGS && turns()) {
            let middle = |one: &Look<N>, other: &Look<N>| {
                self.look(place((vector(one.at) + vector(other.at)).unit()?))
            };
            let [Some(ab), Some(bc), Some(ca)] = [middle(&a, &b), middle(&b, &c), middle(&c, &a)] else {
                return;
            };
            for smaller in [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]] {
                self.triangle(smaller, halvings + 1, visit);
            }
            return;
        }
        let back = corners.iter().all(|look| look.goes_on() < 0.0);
        if back || a.pulls & b.pulls & c.pulls != 0 {
            return;
        }
        if let Some(near) = place_in(&corners).and_then(|at| self.look(place(at))) {
            visit(&near.direction);
        }
    }
}

impl<const N: usize> Look<N> {
    /// The cosine between the assumed motion and the one that follows.
    fn goes_on(&self) -> f64 {
        self.at.iter().zip(self.follows).map(|(at, follows)| at * follows).sum()
    }
}

fn place(at: Vec3) -> Place {
    let mut out = [0.0; MOST_FREEDOM];
    out[..3].copy_from_slice(&at.to_array());
    out
}

fn vector([x, y, z, ..]: Place) -> Vec3 {
    Vec3::new(x, y, z)
}

/// The place in a triangle, or little beyond its sides, where the motion that follows would be the assumed one if it changed linearly.
fn place_in<const N: usize>(corners: &[Look<N>; 3]) -> Option<Vec3> {
    let [a, b, c] = corners.map(|look| vector(look.at));
    let (u, v) = ((b - a).unit()?, a.cross(b - a).unit()?);
    let [p, q, r] = corners.map(|look| {
        let (at, follows) = (vector(look.at), vector(look.follows));
        let across = follows - at * at.dot(follows);
        [across.dot(u), across.dot(v)]
    });
    let cross = |p: [f64; 2], q: [f64; 2]| p[0] * q[1] - p[1] * q[0];
    let shares = [cross(q, r), cross(r, p), cross(p, q)];
    let sum: f64 = shares.iter().sum();
    let [s, t, w] = shares.map(|share| share / sum);
    let inside = [s, t, w].iter().all(|share| *share >= -BEYOND);
    if inside { (a * s + b * t + c * w).unit() } else { None }
}
