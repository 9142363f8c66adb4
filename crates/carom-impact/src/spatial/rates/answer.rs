//! The answer of a rate problem in space: a set of solutions, each with its smallest margin.

use crate::tolerance::{EQUAL_MARGINS, SAME_LENGTH, SAME_MOTION};
use carom_num::Vec3;

/// What a contact does.
///
/// # Example
/// A block of 1 kg at rest on an incline of 3 in 4 sticks or starts to slip, as friction is above or below
/// 3/4.
/// ```
/// use carom_impact::{Load, spatial::{Mode, RateProblem}};
/// use carom_num::{Mat3, Vec3};
/// let mode = |friction: f64| RateProblem::<1> {
///     count: 1, operator: &[[Mat3::IDENTITY]], friction: &[friction],
///     drive: [Vec3::new(0.0, 6.0, -8.0)], slip: [[0.0; 2]], load: [Load::Touching(0.0)],
/// }.solve().solutions[0].map(|solution| solution.guess[0].mode);
/// assert_eq!([mode(0.8), mode(0.7)], [Some(Mode::Sticks), Some(Mode::Starts)]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// It transmits nothing.
    Open,
    /// It slips already, and friction acts against the slip.
    Slips,
    /// It sticks.
    Sticks,
    /// It starts to slip, and friction acts against the slip that starts.
    Starts,
}

/// What a hypothesis says of one contact.
///
/// # Example
/// A block that slips already: friction brakes it, and the floor holds it up.
/// ```
/// use carom_impact::{Load, spatial::{Guess, Mode, RateProblem}};
/// use carom_num::{Mat3, Vec3};
/// let answer = RateProblem::<1> {
///     count: 1, operator: &[[Mat3::IDENTITY]], friction: &[0.5],
///     drive: [Vec3::Z * -10.0], slip: [[3.0, 4.0]], load: [Load::Touching(0.0)],
/// }.solve();
/// let slips = Guess { holds: true, mode: Mode::Slips };
/// assert_eq!(answer.solutions[0].map(|solution| solution.guess), Some([slips]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Guess {
    /// Its normal velocity does not change, and its normal rate may exceed the base load.
    pub holds: bool,
    /// What it does.
    pub mode: Mode,
}

impl Guess {
    /// A contact that transmits nothing.
    pub(in crate::spatial) const OPEN: Self = Self { holds: false, mode: Mode::Open };

    /// True where friction is the whole cone's, against a slip.
    pub(in crate::spatial) fn slides(self) -> bool {
        matches!(self.mode, Mode::Slips | Mode::Starts)
    }
}

/// The inequality that rejects a hypothesis, or the one that is nearest to doing so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Condition {
    /// The contact's normal rate must not pull.
    Pushes(usize),
    /// An open contact must not approach.
    Opens(usize),
    /// A sticking contact must stay within the friction cone.
    WithinCone(usize),
    /// There must be a direction in which the contact starts to slip while friction acts against it.
    Starts(usize),
    /// The equations of the hypothesis must have a solution.
    Solvable,
}

/// What a hypothesis leaves open.
///
/// # Example
/// A body of 1 kg that rests on two points: they may press against each other along their line.
/// ```
/// use carom_impact::{Load, spatial::{ContactSet, Freedom, RateProblem, RigidBody, Touch}};
/// use carom_num::{Mat3, Vec3};
/// let body = RigidBody { mass: 1.0, inertia: Mat3::IDENTITY, velocity: Vec3::ZERO, spin: Vec3::ZERO };
/// let foot = |x| Touch { arm: Vec3::new(x, 0.0, -0.5), normal: Vec3::Z, friction: 0.5, restitution: 0.0 };
/// let set = ContactSet::<2>::of_free_body(&body, &[foot(-1.0), foot(1.0)])?;
/// let solution = RateProblem::<2> {
///     count: 2, operator: &set.operator, friction: &set.friction,
///     drive: [Vec3::Z * -10.0; 2], slip: [[0.0; 2]; 2], load: [Load::Touching(0.0); 2],
/// }.solve().solutions[0].unwrap();
/// assert_eq!(solution.freedom, Freedom::Rates);
/// assert!(solution.rates.iter().all(|rate| (rate.z - 5.0).abs() < 1e-14), "half of the weight each");
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Freedom {
    /// Nothing.
    None,
    /// The rates; the motion is determined.
    Rates,
    /// The motion as well: how contacts share the load changes friction, and with it the motion.
    Motion,
}

/// Which of several consistent hypotheses is followed, where none goes on with what contacts do. Among equals it is the one of the shortest rates,
/// whatever the order of the contacts.
///
/// # Example
/// A rod whose end slips into its lean, `W_nn − μW_tn = 5/2 − 2 · 3/2 < 0`, and is pulled off: it may leave,
/// or friction may hold it.
/// ```
/// use carom_impact::{Load, spatial::{Mode, Preference, RateProblem}};
/// use carom_num::{Mat3, Vec3};
/// let operator = [[Mat3 { rows: [Vec3::new(2.5, 0.0, 1.5), Vec3::Y, Vec3::new(1.5, 0.0, 2.5)] }]];
/// let answer = RateProblem::<1> {
///     count: 1, operator: &operator, friction: &[2.0],
///     drive: [Vec3::Z * 10.0], slip: [[1.0, 0.0]], load: [Load::Touching(0.0)],
/// }.solve();
/// let does = |preference| answer.preferred(None, preference).map(|solution| solution.guess[0].mode);
/// assert_eq!(does(Preference::MostOpen), Some(Mode::Open));
/// assert_eq!(does(Preference::MostKept), Some(Mode::Slips));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Preference {
    /// The one with most open contacts; among equals, the one with most that slip.
    #[default]
    MostOpen,
    /// The one with most contacts that keep; among equals, the one with most that stick.
    MostKept,
}

/// Which member of a family of rates is meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::spatial) enum Member {
    /// As equal springs share, of which these contacts, one bit each, are lifted.
    Springs(u32),
    /// The one whose smallest slack is largest.
    Middle,
}

impl Member {
    /// The same, where this contact carries something or nothing: at the moment at which that changes rounding must not decide it.
    pub(in crate::spatial) fn carrying(self, i: usize, carries: bool) -> Self {
        match self {
            Self::Middle => self,
            Self::Springs(lifted) if carries => Self::Springs(lifted & !(1 << i)),
            Self::Springs(lifted) => Self::Springs(lifted | 1 << i),
        }
    }
}

/// A consistent hypothesis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<const N: usize> {
    /// The hypothesis.
    pub guess: [Guess; N],
    /// Direction of the slip, or of the slip that starts: a unit vector (t₁, t₂), or zero.
    pub direction: [[f64; 2]; N],
    /// Rates of each contact, in its frame.
    pub rates: [Vec3; N],
    /// Response `drive + W rates` of each contact, in its frame; absent ones included.
    pub response: [Vec3; N],
    /// Smallest slack divided by the sum of its terms' magnitudes.
    pub margin: f64,
    /// Which inequality that is.
    pub margin_of: Condition,
    /// What is left open. Contacts share as equal springs do; where that breaks a cone, by the rates whose smallest slack is largest.
    pub freedom: Freedom,
    pub(in crate::spatial) member: Member,
}

impl<const N: usize> Solution<N> {
    /// The length of all rates.
    fn length(&self) -> f64 {
        self.rates.iter().map(|rate| rate.dot(*rate)).sum::<f64>().sqrt()
    }
}

/// All distinct solutions found.
#[derive(Clone, Copy, Debug)]
pub struct Answer<const N: usize> {
    /// Solutions whose motions differ; of more than [`Answer::KEPT`] those of the shortest rates.
    pub solutions: [Option<Solution<N>>; 8],
    /// Number of solutions whose motions differ.
    pub count: usize,
    /// True where all directions of starting slips were found for certain: there are no other solutions. False where more than one contact
    /// starts to slip, or rates stay open meanwhile: then directions were searched for, and one may be missed.
    pub examined: bool,
}

impl<const N: usize> Answer<N> {
    /// How many solutions are kept.
    pub const KEPT: usize = 8;

    pub(in crate::spatial) const NONE: Self = Self { solutions: [None; 8], count: 0, examined: true };

    /// The kept solutions.
    pub fn iter(&self) -> impl Iterator<Item = &Solution<N>> {
        self.solutions.iter().flatten()
    }

    /// Takes a solution in, unless one with the same motion is there already. `scale` is the drive's magnitude.
    pub(in crate::spatial) fn keep(&mut self, solution: Solution<N>, count: usize, scale: f64) {
        let magnitude = |s: &Solution<N>| s.response[..count].iter().fold(scale, |m: f64, w| m.max(w.norm()));
        let own = magnitude(&solution);
        let same = |other: &Solution<N>| {
            let largest = magnitude(other).max(own);
            let mut pairs = solution.response[..count].iter().zip(&other.response);
            pairs.all(|(a, b)| (*a - *b).norm() <= SAME_MOTION * largest)
        };
        if let Some(kept) = self.solutions.iter_mut().flatten().find(|kept| same(kept)) {
            // The member that is farther from being rejected stands for the motion; of equals the one that fixes more of it.
            let fixed = |s: &Solution<N>| {
                s.guess.iter().map(|g| u8::from(g.holds) + u8::from(g.mode == Mode::Sticks)).sum::<u8>()
            };
            let equal = (solution.margin - kept.margin).abs() <= EQUAL_MARGINS;
            if if equal { fixed(&solution) > fixed(kept) } else { solution.margin > kept.margin } {
                *kept = solution;
            }
            return;
        }
        if let Some(place) = self.solutions.get_mut(self.count) {
            *place = Some(solution);
        } else if let Some(longest) =
            self.solutions.iter_mut().flatten().max_by(|a, b| a.length().total_cmp(&b.length()))
            && solution.length() < longest.length()
        {
            *longest = solution;
        }
        self.count += 1;
    }

    /// The preferred solution: the one that keeps what contacts do at `present` where there is one, else as the preference says.
    pub fn preferred(&self, present: Option<&[Mode; N]>, preference: Preference) -> Option<&Solution<N>> {
        let keeps =
            |s: &&Solution<N>| present.is_some_and(|p| (0..N).all(|i| goes_on(p[i], s.guess[i].mode)));
        let kept = self.iter().find(keeps);
        kept.or_else(|| self.best(preference, |_| true))
    }

    /// The preferred solution among those in which contacts do not all do what they do at `present`.
    pub fn another(&self, present: &[Mode; N], preference: Preference) -> Option<&Solution<N>> {
        self.best(preference, |s| (0..N).any(|i| !goes_on(present[i], s.guess[i].mode)))
    }

    fn best(&self, preference: Preference, counts: impl Fn(&Solution<N>) -> bool) -> Option<&Solution<N>> {
        let count = |s: &Solution<N>, of: fn(&Guess) -> bool| s.guess.iter().filter(|g| of(g)).count();
        let rank = |s: &Solution<N>| match preference {
            Preference::MostOpen => (count(s, |g| g.mode == Mode::Open), count(s, |g| g.slides())),
            Preference::MostKept => (count(s, |g| g.holds), count(s, |g| g.mode == Mode::Sticks)),
        };
        let most = self.iter().filter(|s| counts(s)).map(rank).max()?;
        let equals = || self.iter().filter(|s| counts(s) && rank(s) == most);
        let shortest = equals().map(Solution::length).fold(f64::INFINITY, f64::min);
        equals().filter(|s| s.length() <= (1.0 + SAME_LENGTH) * shortest).last()
    }
}

/// A slip that has started goes on as one that slips.
fn goes_on(present: Mode, now: Mode) -> bool {
    present == now || (present == Mode::Starts && now == Mode::Slips)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_slip_that_has_started_goes_on_under_another_name() {
        let modes = [Mode::Open, Mode::Sticks, Mode::Starts, Mode::Slips];
        let pairs = modes.iter().flat_map(|&present| modes.map(|now| (present, now)));
        let others: Vec<_> =
            pairs.filter(|(present, now)| present != now && goes_on(*present, *now)).collect();
        assert_eq!(others, [(Mode::Starts, Mode::Slips)]);
        assert!(modes.iter().all(|&mode| goes_on(mode, mode)));
    }
}
