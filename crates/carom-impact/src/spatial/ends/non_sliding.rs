//! The non-sliding law: a contact that is kept comes to rest, whatever friction that takes; the others take no impulse.
//!
//! A *state* is the set of contacts that are kept. Its impulses solve `W_SS p_S = −u_S`. It is consistent where no kept contact pulls and none of the
//! others approaches. All states are tried; states that leave the same motion are one, named by all the contacts that rest in it.
//!
//! Where kept contacts resist each other (two along their line, four on one plane) the impulses are a family: a normal impulse that is negative in
//! one member and not in another pulls only if it does in all. For contacts on one plane that asks whether the impulse's line meets the hull of
//! the contacts.
//!
//! # Source
//! Polukoshko, Viba and others, on simultaneous collisions of rolling bodies, section 5.

use crate::spatial::contacts::set::ContactSet;
use crate::tolerance::{KEEPING_SLACK, RANK, SAME_MOTION};
use carom_num::Vec3;
use carom_num::cones::narrowest;
use carom_num::slack::Slacks;
use carom_num::solve::{Solutions, solve_any};

/// Why a state is not consistent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// A kept contact would pull.
    Pulls(usize),
    /// A contact that is not kept would approach.
    Approaches(usize),
    /// No impulses bring the kept contacts to rest.
    Unsolvable,
}

/// A consistent state.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptState<const N: usize> {
    /// Which contacts are kept: all those that rest.
    pub kept: [bool; N],
    /// Impulses in the contacts' frames [N s]; where they are a family, the shortest member, or one that does not pull.
    pub impulse: [Vec3; N],
    /// Directions along which the impulses may change while the motion stays the same.
    pub free: Vec<[Vec3; N]>,
    /// Velocities after, in the contacts' frames [m/s].
    pub velocity: [Vec3; N],
    /// The smallest of its inequalities' slacks: normal impulses as fractions of all impulses, separations as fractions of all velocities.
    pub slack: f64,
}

/// A state that is not consistent, and the inequality that refuses it most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refused<const N: usize> {
    /// Which contacts it keeps.
    pub kept: [bool; N],
    /// Why it is refused.
    pub refusal: Refusal,
    /// By how much, as [`KeptState::slack`]; negative.
    pub slack: f64,
    /// The normal impulse [N s] that pulls, or the normal velocity [m/s] that approaches; −∞ where the state is unsolvable.
    pub amount: f64,
}

/// What refuses a state, its slack, and the amount in its unit.
type Refuses = (Refusal, f64, f64);

/// How many different motions are consistent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Conclusion {
    /// One.
    Unique,
    /// Several: the law leaves it open.
    Several,
    /// None: no motion without sliding exists.
    None,
    /// None at some stage, where the contact that friction drives in was loaded alone: see [`Ground`](crate::spatial::stages::staged::Ground).
    Forced,
}

/// All states of the non-sliding law.
#[derive(Clone, Debug, PartialEq)]
pub struct StatesOfKeeping<const N: usize> {
    /// The consistent ones, each with another motion; those that keep most come first.
    pub consistent: Vec<KeptState<N>>,
    /// The others.
    pub refused: Vec<Refused<N>>,
}

impl<const N: usize> StatesOfKeeping<N> {
    /// How many different motions are consistent.
    pub fn conclusion(&self) -> Conclusion {
        match self.consistent.len() {
            0 => Conclusion::None,
            1 => Conclusion::Unique,
            _ => Conclusion::Several,
        }
    }
}

impl<const N: usize> KeptState<N> {
    /// The least friction coefficient for which some impulses of the family lie in all cones, to 1e-9 of it. Infinite where a contact needs
    /// a tangential impulse but has no normal one.
    pub fn friction_demand(&self) -> f64 {
        narrowest(&self.impulse, &self.free)
    }
}

/// The largest of the quotients of tangential and normal impulse.
pub(in crate::spatial) fn demand<const N: usize>(impulse: &[Vec3; N]) -> f64 {
    let of = |p: &Vec3| {
        let tangential = (p.x * p.x + p.y * p.y).sqrt();
        if tangential == 0.0 {
            0.0
        } else if p.z > 0.0 {
            tangential / p.z
        } else {
            f64::INFINITY
        }
    };
    impulse.iter().map(of).fold(0.0, f64::max)
}

impl<const N: usize> ContactSet<N> {
    /// Tries every state of the non-sliding law.
    ///
    /// # Limits
    /// Plastic: restitution is not asked, nor is friction ([`KeptState::friction_demand`] says how much of it is needed). The work doubles with every
    /// contact; at most 12 are taken, of more nothing is found.
    ///
    /// # Example
    /// A cube that turns about one edge comes down flat on the other one's corners too. It does not stop: it turns on about these.
    /// ```
    /// use carom_impact::spatial::{Conclusion, ContactSet, RigidBody, Touch};
    /// use carom_num::{Mat3, Vec3};
    /// let (spin, third) = (Vec3::new(0.0, 1.0, 0.0), 1.0 / 6.0);
    /// let velocity = spin.cross(Vec3::new(0.5, 0.0, 0.5));
    /// let cube = RigidBody { mass: 1.0, inertia: Mat3::diagonal(third, third, third), velocity, spin };
    /// let corner = |x: f64, y: f64| Touch {
    ///     arm: Vec3::new(x, y, -0.5), normal: Vec3::Z, friction: 0.0, restitution: 0.0,
    /// };
    /// let corners = [corner(-0.5, -0.5), corner(-0.5, 0.5), corner(0.5, -0.5), corner(0.5, 0.5)];
    /// let states = ContactSet::<4>::of_free_body(&cube, &corners)?.states_of_keeping();
    /// assert_eq!(states.conclusion(), Conclusion::Unique);
    /// assert_eq!(states.consistent[0].kept, [false, false, true, true]);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn states_of_keeping(&self) -> StatesOfKeeping<N> {
        self.states_within(KEEPING_SLACK, SAME_MOTION)
    }

    /// As [`ContactSet::states_of_keeping`], but a slack below zero is never taken for rounding, and states are told apart however close their
    /// motions are. It finds the border between two states to the last digit.
    ///
    /// # Limits
    /// At equality rounding decides.
    pub fn states_of_keeping_strictly(&self) -> StatesOfKeeping<N> {
        self.states_within(0.0, 0.0)
    }

    fn states_within(&self, tolerance: f64, alike: f64) -> StatesOfKeeping<N> {
        let mut out = StatesOfKeeping { consistent: vec![], refused: vec![] };
        if self.count > 12 {
            return out;
        }
        let mut states: Vec<u32> = (0..1_u32 << self.count).collect();
        states.sort_by_key(|bits| std::cmp::Reverse(bits.count_ones()));
        let speed = self.speed();
        for bits in states {
            let kept = std::array::from_fn(|i| i < self.count && bits >> i & 1 == 1);
            match self.keeping(&kept, speed, tolerance) {
                Ok(state) => {
                    let same = |other: &KeptState<N>| {
                        let mut pairs = other.velocity.iter().zip(&state.velocity);
                        pairs.all(|(a, b)| (*a - *b).norm() < alike * speed)
                    };
                    if !out.consistent.iter().any(same) {
                        out.consistent.push(state);
                    }
                }
                Err((refusal, slack, amount)) => out.refused.push(Refused { kept, refusal, slack, amount }),
            }
        }
        out
    }

    /// All velocities, added up.
    fn speed(&self) -> f64 {
        self.velocity.iter().take(self.count).map(|v| v.norm()).sum()
    }

    /// One state: its impulses and its inequalities.
    fn keeping(&self, kept: &[bool; N], speed: f64, tolerance: f64) -> Result<KeptState<N>, Refuses> {
        match kept.iter().filter(|k| **k).count() {
            0..=2 => self.keeping_sized::<6>(kept, speed, tolerance),
            3..=4 => self.keeping_sized::<12>(kept, speed, tolerance),
            _ => self.keeping_sized::<36>(kept, speed, tolerance),
        }
    }

    fn keeping_sized<const M: usize>(
        &self,
        kept: &[bool; N],
        speed: f64,
        tolerance: f64,
    ) -> Result<KeptState<N>, Refuses> {
        let mut places = [0; N];
        let mut n = 0;
        for i in (0..self.count).filter(|i| kept[*i]) {
            places[n] = i;
            n += 1;
        }
        let places = &places[..n];
        let family =
            self.at_rest::<M>(places).ok_or((Refusal::Unsolvable, f64::NEG_INFINITY, f64::NEG_INFINITY))?;
        let (point, pulls) = not_pulling(&family, n, tolerance);
        let mut impulse = [Vec3::ZERO; N];
        let spread = |of: &[f64; M]| {
            let mut all = [Vec3::ZERO; N];
            for (k, i) in places.iter().enumerate() {
                all[*i] = Vec3::new(of[3 * k], of[3 * k + 1], of[3 * k + 2]);
            }
            all
        };
        impulse.copy_from_slice(&spread(&point));
        let velocity = self.after(&impulse);
        let (mut slack, mut refusal, mut amount) = (f64::INFINITY, Refusal::Unsolvable, f64::INFINITY);
        if let Some((k, least)) = pulls {
            (slack, refusal, amount) = (least, Refusal::Pulls(places[k]), point[3 * k + 2]);
        }
        // All members of a family leave one motion: separations are asked of the one that was taken.
        for j in (0..self.count).filter(|j| !kept[*j]) {
            let separation = if speed > 0.0 { velocity[j].z / speed } else { 0.0 };
            if separation < slack {
                (slack, refusal, amount) = (separation, Refusal::Approaches(j), velocity[j].z);
            }
        }
        if slack < -tolerance {
            return Err((refusal, slack, amount));
        }
        let free = family.free[..family.freedom].iter().map(spread).collect();
        Ok(KeptState { kept: *kept, impulse, free, velocity, slack })
    }

    /// The impulses at these contacts that bring them to rest, the shortest as the point.
    fn at_rest<const M: usize>(&self, places: &[usize]) -> Option<Solutions<M>> {
        let (mut matrix, mut right) = ([[0.0; M]; M], [0.0; M]);
        for (a, i) in places.iter().enumerate() {
            for (row, u) in self.velocity[*i].to_array().into_iter().enumerate() {
                right[3 * a + row] = -u;
                for (b, j) in places.iter().enumerate() {
                    let block = self.operator[*i][*j].rows[row].to_array();
                    matrix[3 * a + row][3 * b..3 * b + 3].copy_from_slice(&block);
                }
            }
        }
        let mut family = solve_any(matrix, right, 3 * places.len(), RANK)?;
        family.shorten();
        Some(family)
    }
}

/// The member of a family of impulses at n contacts that is taken, and the contact whose normal impulse is the smallest in it, as a fraction of all
/// impulses: the shortest if none pulls there, else the one whose smallest is largest.
fn not_pulling<const M: usize>(
    family: &Solutions<M>,
    n: usize,
    tolerance: f64,
) -> ([f64; M], Option<(usize, f64)>) {
    let least = |point: &[f64; M]| {
        let total: f64 = point.iter().map(|p| p.abs()).sum();
        let share = |k: usize| if total > 0.0 { point[3 * k + 2] / total } else { 0.0 };
        (0..n).map(|k| (k, share(k))).min_by(|a, b| a.1.total_cmp(&b.1))
    };
    let shortest = least(&family.point);
    if family.freedom == 0 || shortest.is_none_or(|(_, share)| share >= -tolerance) {
        return (family.point, shortest);
    }
    let mut slacks = Slacks::<M>::of(family.freedom);
    for k in 0..n {
        slacks.push(family.point[3 * k + 2], |j| family.free[j][3 * k + 2]);
    }
    let total: f64 = family.point.iter().map(|p| p.abs()).sum();
    let Some((z, _)) = slacks.largest_smallest(total) else { return (family.point, shortest) };
    let mut point = family.point;
    for (along, direction) in z.iter().zip(&family.free[..family.freedom]) {
        point.iter_mut().zip(direction).for_each(|(p, d)| *p += along * d);
    }
    (point, least(&point))
}
