//! The rate problem in space: these contacts touch; which separate, stick or slip, and at which force (or impulse) rates?
//!
//! Contact i has the rates (q, r), q a vector across its normal, `r = β + x` with a base load β ≥ 0 and an excess x; the response is `w = drive + W (q, r)`.
//! Signorini: `0 ≤ x ⊥ w_n ≥ 0`. Coulomb, with the round cone: `q = −μ r e` where it slips in direction e; at zero slip either it sticks (`w_t = 0`,
//! `|q| ≤ μ r`) or it starts to slip in the direction of its response, `w_t = λ e` with `λ ≥ 0` and `q = −μ r e`.
//!
//! Every hypothesis is tried: open, or held with the slip it has, or at zero slip sticking or starting. One that is part of another, see
//! [`closed`](super::closed), is tried only where no other is consistent. Directions of starting slips are the roots of trigonometric equations: see
//! [`starts`](super::starts) for which of them are found for certain.

use super::answer::{Answer, Condition, Freedom, Guess, Member, Mode, Solution};
use super::closed::{Closed, Guesses};
use super::equations::{Found, Hypothesis};
use crate::Load;
use crate::spatial::contacts::set::MOST_EXAMINED;
use crate::tolerance::{ALONG_ITS_RESPONSE, SLACK_TOLERANCE};
use carom_num::{Mat3, Vec3};

/// A rate problem of up to N contacts in space.
///
/// # Limits
/// Rigid, one friction coefficient a contact. At most [`MOST_EXAMINED`] contacts; of more, or of numbers that are not finite, no solution is found. The work grows
/// as 2ⁿ with n contacts that slip and as 3ⁿ with n that do not; on one plane much less. Contacts that hold more than they must share what they carry by
/// one rule, which is a choice where [`Freedom::Motion`] says that the motion depends on it.
///
/// # Example
/// A block of 1 kg at rest on an incline of 3 in 4 (g = 10 m/s²) holds from μ = 3/4 on, and else starts to slip downhill, wherever that is.
/// ```
/// use carom_impact::Load;
/// use carom_impact::spatial::{Mode, RateProblem};
/// use carom_num::{Mat3, Vec3};
/// let block = [[Mat3::IDENTITY]];
/// let ask = |friction: f64| {
///     let problem = RateProblem::<1> {
///         count: 1, operator: &block, friction: &[friction],
///         drive: [Vec3::new(3.6, 4.8, -8.0)], slip: [[0.0; 2]], load: [Load::Touching(0.0)],
///     };
///     let answer = problem.solve();
///     assert!(answer.count == 1 && answer.examined);
///     answer.solutions[0].map(|s| (s.guess[0].mode, s.rates[0]))
/// };
/// let (mode, holds) = ask(0.8).unwrap();
/// assert!(mode == Mode::Sticks && (holds - Vec3::new(-3.6, -4.8, 8.0)).norm() < 1e-14);
/// let (mode, slides) = ask(0.5).unwrap();
/// assert!(mode == Mode::Starts && (slides - Vec3::new(-2.4, -3.2, 8.0)).norm() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct RateProblem<'a, const N: usize> {
    /// Number of contacts.
    pub count: usize,
    /// The operator W, as [`ContactSet::operator`](crate::spatial::contacts::set::ContactSet::operator).
    pub operator: &'a [[Mat3; N]; N],
    /// Friction coefficients.
    pub friction: &'a [f64; N],
    /// Drive of each contact, in its frame.
    pub drive: [Vec3; N],
    /// Slips (t₁, t₂): only the direction counts, and whether it is zero.
    pub slip: [[f64; 2]; N],
    /// How each contact takes part.
    pub load: [Load; N],
}

/// Of more contacts the hypotheses that are part of others are too many to be asked.
const MOST_IN_ALL: usize = 8;

/// Which hypotheses are tried, by what it takes to find the directions of slips that start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Search {
    /// At most one contact starts: all directions are found for certain.
    Certain,
    /// Two contacts start: their directions are found on scanned curves.
    Pairs,
    /// More contacts start, or rates stay open meanwhile: only the directions near the motion that the drive causes are looked for.
    Driven,
    /// The same, in all directions.
    Wide,
}

/// What was done with a hypothesis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tried {
    /// All of its directions were found.
    ForCertain,
    /// Its directions were looked for.
    Looked,
    /// It belongs to another search.
    Elsewhere,
}

/// The inequality that rejects a hypothesis, and its scaled slack.
pub(super) type Rejection = (Condition, f64);

impl<const N: usize> RateProblem<'_, N> {
    /// Tries every hypothesis and returns the solutions whose motions differ. Those in which more than two
    /// contacts start to slip, or rates stay open meanwhile, are tried only where no other is consistent; so are those that are part of another.
    ///
    /// # Example
    /// A block of 1 kg that slips along (3, 4)/5 is braked by μg = 5 m/s² against that.
    /// ```
    /// use carom_impact::{Load, spatial::RateProblem};
    /// use carom_num::{Mat3, Vec3};
    /// let answer = RateProblem::<1> {
    ///     count: 1, operator: &[[Mat3::IDENTITY]], friction: &[0.5],
    ///     drive: [Vec3::Z * -10.0], slip: [[0.3, 0.4]], load: [Load::Touching(0.0)],
    /// }.solve();
    /// let response = answer.solutions[0].unwrap().response[0];
    /// assert!(answer.count == 1 && (response - Vec3::new(-3.0, -4.0, 0.0)).norm() < 1e-14);
    /// ```
    pub fn solve(&self) -> Answer<N> {
        self.solve_observed(&mut |_, _, _| {})
    }

    /// As [`RateProblem::solve`], handing each rejected hypothesis with the inequality that rejects it and its scaled slack to `reject`.
    pub fn solve_observed(&self, reject: &mut impl FnMut(&[Guess; N], Condition, f64)) -> Answer<N> {
        let searches = [Search::Certain, Search::Pairs, Search::Wide];
        self.search(&searches, reject, |of, search| of == Closed::Yes && search < Search::Wide)
    }

    /// The solutions of the first search that finds any; `examined` says whether others may exist.
    pub fn solve_first(&self) -> Answer<N> {
        let searches = [Search::Certain, Search::Pairs, Search::Driven, Search::Wide];
        self.search(&searches, &mut |_, _, _| {}, |_, _| false)
    }

    /// Searches until something is found; searches that are made `anyway` go on.
    fn search(
        &self,
        searches: &[Search],
        reject: &mut impl FnMut(&[Guess; N], Condition, f64),
        anyway: impl Fn(Closed, Search) -> bool,
    ) -> Answer<N> {
        let mut answer = Answer::NONE;
        if self.count > N.min(MOST_EXAMINED) {
            return answer;
        }
        let (mut guesses, scale) = (Guesses::of(self), self.scale());
        for of in [Closed::Yes, Closed::No] {
            let asked = (0..self.count).filter(|&i| self.load[i] != Load::Absent).count();
            if of == Closed::No && answer.count == 0 && asked > MOST_IN_ALL {
                answer.examined = false;
                break;
            }
            for &search in searches {
                if answer.count == 0 || anyway(of, search) {
                    guesses.each(of, &mut |guess| self.examine(guess, search, scale, &mut answer, reject));
                }
            }
        }
        answer
    }

    /// The first solution of this hypothesis, if it is one of this problem.
    pub(in crate::spatial) fn first_of(&self, guess: &[Guess; N]) -> Option<Solution<N>> {
        let mut found = None;
        if !(0..self.count).all(|i| self.options(i).any(|option| option == guess[i]))
            || !Guesses::of(self).is_closed(guess)
        {
            return found;
        }
        for search in [Search::Certain, Search::Pairs, Search::Wide] {
            self.each_start(guess, search, &mut |direction| {
                let hypothesis = Hypothesis { problem: self, guess, direction: *direction };
                // What none of its rates keeps is no solution, and why does not matter here.
                let _ = hypothesis.judge(&mut |solution| found = found.or(Some(solution)));
            });
        }
        found
    }

    /// Tries a hypothesis in one search.
    fn examine(
        &self,
        guess: &[Guess; N],
        search: Search,
        scale: f64,
        answer: &mut Answer<N>,
        reject: &mut impl FnMut(&[Guess; N], Condition, f64),
    ) {
        // Of the directions tried, the one that is nearest to being a solution says why there is none.
        let mut nearest: Option<Rejection> = None;
        let mut found = false;
        let tried = self.each_start(guess, search, &mut |direction| {
            let hypothesis = Hypothesis { problem: self, guess, direction: *direction };
            match hypothesis.judge(&mut |solution| answer.keep(solution, self.count, scale)) {
                Ok(()) => found = true,
                Err(why) if nearest.is_none_or(|n| why.1 > n.1) => nearest = Some(why),
                Err(_) => {}
            }
        });
        answer.examined &=
            tried == Tried::ForCertain || (search > Search::Certain && tried == Tried::Elsewhere);
        if !found && matches!(tried, Tried::ForCertain | Tried::Looked) {
            let starting = guess.iter().position(|g| g.mode == Mode::Starts);
            let none = starting.map_or(Condition::Solvable, Condition::Starts);
            let (condition, slack) = nearest.unwrap_or((none, -1.0));
            reject(guess, condition, slack);
        }
    }

    /// The possibilities of contact i: those in which it does not hold, then those in which it does.
    pub(super) fn options(&self, i: usize) -> impl Iterator<Item = Guess> + Clone {
        let (may_hold, base) = match self.load[i] {
            Load::Absent => (false, 0.0),
            Load::Touching(base) => (true, base),
            Load::Prescribed(base) => (false, base),
        };
        let modes: &'static [Mode] = if self.slips(i) || self.friction[i] == 0.0 {
            &[Mode::Slips]
        } else {
            &[Mode::Sticks, Mode::Starts]
        };
        let free: &'static [Mode] = if base > 0.0 { modes } else { &[Mode::Open] };
        let held = if may_hold { modes } else { &[] };
        let guess = |holds| move |mode: &Mode| Guess { holds, mode: *mode };
        free.iter().map(guess(false)).chain(held.iter().map(guess(true)))
    }

    fn slips(&self, i: usize) -> bool {
        self.slip[i] != [0.0; 2]
    }

    /// Direction of the slip of contact i; zero where it does not slip.
    pub(super) fn slip_direction(&self, i: usize) -> [f64; 2] {
        let [x, y] = self.slip[i];
        // A slip may be so small that its square is nothing.
        let size = x.abs().max(y.abs());
        if size == 0.0 {
            return [0.0; 2];
        }
        let (x, y) = (x / size, y / size);
        let length = (x * x + y * y).sqrt();
        [x / length, y / length]
    }

    pub(in crate::spatial) fn base(&self, i: usize) -> f64 {
        match self.load[i] {
            Load::Absent => 0.0,
            Load::Touching(base) | Load::Prescribed(base) => base,
        }
    }

    /// Magnitude of the drive and of what the base loads do: differences far below it are rounding.
    fn scale(&self) -> f64 {
        let mut scale = self.drive[..self.count].iter().fold(0.0, |m: f64, d| m.max(d.norm()));
        for j in (0..self.count).filter(|&j| self.base(j) > 0.0) {
            for row in &self.operator[..self.count] {
                scale = scale.max(self.base(j) * (row[j] * Vec3::Z).norm());
            }
        }
        scale
    }

    /// `drive + W rates` of every contact, and the sums of the magnitudes of its terms, across the normal and along it.
    pub(in crate::spatial) fn response(&self, rates: &[Vec3; N]) -> ([Vec3; N], [[f64; 2]; N]) {
        let mut response = self.drive;
        let across = |v: Vec3| (v.x * v.x + v.y * v.y).sqrt();
        let mut terms = response.map(|d| [across(d), d.z.abs()]);
        for i in 0..self.count {
            for (block, p) in self.operator[i].iter().zip(rates).take(self.count) {
                let [a, b, c] = block.rows;
                response[i] += *block * *p;
                let size = |row: Vec3| (row.x * p.x).abs() + (row.y * p.y).abs() + (row.z * p.z).abs();
                terms[i][0] += size(a) + size(b);
                terms[i][1] += size(c);
            }
        }
        (response, terms)
    }
}

impl<const N: usize> Hypothesis<'_, N> {
    /// Hands over the solutions that the hypothesis is: one for each way in which equal springs may carry. Else the inequality that is violated most.
    pub(super) fn judge(&self, visit: &mut impl FnMut(Solution<N>)) -> Result<(), Rejection> {
        let (mut first, mut any) = (None, false);
        self.each_rates(&mut |found| match self.ask(&found) {
            Ok(solution) => {
                any = true;
                visit(solution);
            }
            Err(why) => first = first.or(Some((found, why))),
        });
        if any {
            return Ok(());
        }
        let (found, why) = first.ok_or((Condition::Solvable, -1.0))?;
        // Where something sticks, a cone may be kept by other rates of the family; what the motion breaks, only by rates that move the body otherwise.
        let forces = matches!(why.0, Condition::Pushes(_) | Condition::WithinCone(_));
        let others = if forces { found.freedom != Freedom::None } else { found.freedom == Freedom::Motion };
        if !others || !self.guess.iter().any(|g| g.mode == Mode::Sticks) {
            return Err(why);
        }
        let rates = self.middle().ok_or(why)?;
        self.ask(&Found { rates, member: Member::Middle, ..found }).map(visit)
    }

    /// Asks every inequality.
    fn ask(&self, found: &Found<N>) -> Result<Solution<N>, Rejection> {
        let (problem, rates) = (self.problem, found.rates);
        let (response, terms) = problem.response(&rates);
        let tangential = |v: Vec3| (v.x * v.x + v.y * v.y).sqrt();
        let total = (0..problem.count).fold(0.0, |m: f64, i| m + rates[i].norm() + problem.base(i));
        let mut worst = (Condition::Solvable, f64::INFINITY);
        let mut check = |condition: Condition, slack: f64, scale: f64| {
            let scaled = if scale == 0.0 { 0.0 } else { slack / scale };
            if scaled < worst.1 || scaled.is_nan() {
                worst = (condition, scaled);
            }
        };
        for (i, g) in self.guess.iter().enumerate().take(problem.count) {
            let (p, w, [across, along]) = (rates[i], response[i], terms[i]);
            if g.holds {
                check(Condition::Pushes(i), p.z - problem.base(i), total);
            } else if matches!(problem.load[i], Load::Touching(_)) {
                check(Condition::Opens(i), w.z, along);
            }
            let bound = problem.friction[i] * p.z;
            match g.mode {
                // Only a push has a cone: what pulls is rejected for that.
                Mode::Sticks if p.z < -SLACK_TOLERANCE * total => {}
                Mode::Sticks => {
                    // What carries nothing but rounding is measured against what all carry.
                    let own = bound.abs() + tangential(p);
                    let scale = if own > SLACK_TOLERANCE * total { own } else { total };
                    check(Condition::WithinCone(i), bound - tangential(p), scale)
                }
                Mode::Starts => {
                    let [x, y] = self.direction[i];
                    check(Condition::Starts(i), x * w.x + y * w.y, across);
                    // The direction came from a search: a response that grows along it, but points elsewhere, is no slip that starts.
                    let aside = (x * w.y - y * w.x).abs();
                    if aside > ALONG_ITS_RESPONSE * across {
                        check(Condition::Starts(i), -aside, across);
                    }
                }
                Mode::Open | Mode::Slips => {}
            }
        }
        let (margin_of, margin) = worst;
        let sound = response[..problem.count].iter().all(|w| w.is_finite());
        if !sound || margin.is_nan() || margin < -SLACK_TOLERANCE {
            return Err(worst);
        }
        let Found { freedom, member, .. } = *found;
        let (guess, direction) = (*self.guess, self.direction);
        Ok(Solution { guess, direction, rates: clip(rates), response, margin, margin_of, freedom, member })
    }
}

/// Rounding must not leave a normal rate that pulls.
fn clip<const N: usize>(rates: [Vec3; N]) -> [Vec3; N] {
    rates.map(|p| if p.z < 0.0 { Vec3::ZERO } else { p })
}
