//! Hypotheses that leave no response: they need not be tried one by one.
//!
//! Contacts that hold as many independent velocities as there are leave no other: `w = 0` at every contact, if any rates at all cancel the
//! drive. Most hypotheses of several contacts are such; one body has three velocities, whatever it touches. They share this one motion, and
//! one of them speaks for all, that in which each contact holds, and sticks where it may:
//!
//! - whatever forces another one allows, this one allows too, since a slip that starts or a contact that opens has a force at the edge of its cone;
//! - where its forces have slack left, it is the farthest from being rejected: in another one a contact opens or starts at `w = 0`, with a margin
//!   of nothing.
//!
//! Where its slack is not clear, every hypothesis is tried; a velocity that is not clearly independent of those that are held does not count as held.

use super::answer::{Guess, Solution};
use super::equations::Equations;
use super::rate::Options;
use crate::planar::contacts::names::Slip;
use crate::tolerance::{CLEARLY, INDEPENDENT, MADE_BY_OTHERS, NO_RESPONSE, RANK};
use carom_num::solve::dot;

/// Hypotheses from which on it is worth knowing: more than two contacts have.
const WORTH_KNOWING: usize = 40;

/// Friction up to which slacks are known to far less than what is clear.
const STEEPEST_CONE: f64 = 100.0;

/// What all hypotheses come to that leave no response.
pub(super) struct Standstill<const N: usize, const M: usize> {
    /// How many velocities of the contacts are independent.
    rank: usize,
    /// Each velocity (contact, axis), as a direction among the independent ones.
    velocities: [[[f64; M]; 2]; N],
    /// The solution that they are, if they are one.
    pub(super) solution: Option<Solution<N>>,
}

/// Directions that are square to each other, of which so many are in use.
pub(super) type Held<const M: usize> = [[f64; M]; M];

impl<const N: usize, const M: usize> Standstill<N, M> {
    /// `None` where it is not clear, or not worth knowing.
    pub(super) fn of(equations: &Equations<'_, N, M>, options: &Options<N>) -> Option<Self> {
        if options.each().map(<[Guess]>::len).product::<usize>() < WORTH_KNOWING {
            return None;
        }
        let mut guess = [Guess { holds: false, slip: Slip::Open }; N];
        for (most, of) in guess.iter_mut().zip(options.each()) {
            *most = *of.iter().max_by_key(|option| option.velocities().count())?;
        }
        let problem = equations.problem;
        // The largest slack of a family is a linear programme's, whose coefficients friction multiplies.
        let steep = |mu: &f64| mu.is_finite() && *mu > STEEPEST_CONE;
        if problem.friction[..problem.count].iter().any(steep) {
            return None;
        }
        let found = equations.middle_of(&guess, RANK).filter(|m| !m.indeterminate || m.slack.is_some())?;
        let (response, terms) = problem.response(&found.rates);
        let moves = |i: usize| (0..2).any(|axis| response[i][axis].abs() > NO_RESPONSE * terms[i][axis]);
        if (0..problem.count).any(moves) {
            return None;
        }
        let solution = match problem.verify(&guess, found.rates, found.indeterminate) {
            Ok(solution) if solution.margin > CLEARLY => Some(solution),
            Err(broken) if found.slack.map_or(broken.share > CLEARLY, |slack| slack < -CLEARLY) => None,
            _ => return None,
        };
        let (rank, velocities) = directions(equations)?;
        Some(Self { rank, velocities, solution })
    }

    /// Adds the velocities that contact i holds to those that are held: how many independent ones are held then, or `None` where all are.
    pub(super) fn hold(
        &self,
        (i, option): (usize, Guess),
        held: &mut Held<M>,
        mut count: usize,
    ) -> Option<usize> {
        for axis in option.velocities() {
            if let Some(direction) = square_to(&self.velocities[i][axis], &held[..count], INDEPENDENT) {
                held[count] = direction;
                count += 1;
                if count == self.rank {
                    return None;
                }
            }
        }
        Some(count)
    }
}

impl Guess {
    /// The axes along which the contact's velocity does not change.
    fn velocities(self) -> impl Iterator<Item = usize> {
        let holds = [self.slip == Slip::Sticks, self.holds];
        (0..2).filter(move |axis| holds[*axis])
    }
}

/// How many of the contacts' velocities are independent, and each as a direction among these.
fn directions<const N: usize, const M: usize>(
    equations: &Equations<'_, N, M>,
) -> Option<(usize, [[[f64; M]; 2]; N])> {
    let count = equations.problem.count;
    let mut rows = [[[0.0; M]; 2]; N];
    for (i, of_contact) in rows.iter_mut().enumerate().take(count) {
        for j in 0..count {
            let b = &equations.problem.operator[i][j];
            [of_contact[0][2 * j], of_contact[0][2 * j + 1]] = [b.tt, b.tn];
            [of_contact[1][2 * j], of_contact[1][2 * j + 1]] = [b.nt, b.nn];
        }
        for row in of_contact.iter_mut() {
            *row = square_to(row, &[], 0.0)?;
        }
    }
    let mut basis = [[0.0; M]; M];
    let mut rank = 0;
    // The one that is farthest from those before comes next, so that what is left at the end is rounding.
    while rank < 2 * count {
        let left = |row: &[f64; M]| norm(&rest(row, &basis[..rank]));
        let all = rows[..count].iter().flatten();
        let farthest = all.max_by(|a, b| left(a).total_cmp(&left(b)))?;
        let Some(direction) = square_to(farthest, &basis[..rank], MADE_BY_OTHERS) else { break };
        basis[rank] = direction;
        rank += 1;
    }
    let mut among = [[[0.0; M]; 2]; N];
    for (of_contact, rows) in among.iter_mut().zip(&rows[..count]) {
        for (coordinates, row) in of_contact.iter_mut().zip(rows) {
            for (coordinate, direction) in coordinates.iter_mut().zip(&basis[..rank]) {
                *coordinate = dot(row, direction);
            }
        }
    }
    Some((rank, among))
}

/// The direction of what a vector has beyond these directions; `None` where that is no longer than `least`.
fn square_to<const M: usize>(vector: &[f64; M], directions: &[[f64; M]], least: f64) -> Option<[f64; M]> {
    let rest = rest(vector, directions);
    let length = norm(&rest);
    (length > least).then(|| rest.map(|v| v / length))
}

/// What a vector has beyond these directions.
fn rest<const M: usize>(vector: &[f64; M], directions: &[[f64; M]]) -> [f64; M] {
    let mut rest = *vector;
    for direction in directions {
        let along = dot(&rest, direction);
        rest.iter_mut().zip(direction).for_each(|(v, d)| *v -= along * d);
    }
    rest
}

fn norm<const M: usize>(v: &[f64; M]) -> f64 {
    dot(v, v).sqrt()
}
