//! A loop that throws the rejected parts back: on which faces they start when it has run for long.

use super::estimate::{Estimate, REPETITIONS};
use crate::packed::Packed;
use std::collections::{BTreeMap, BTreeSet};
use std::slice::Iter;

/// Passes after which the loop is as it will stay, unless it goes on for ever without a part that leaves.
const MOST_PASSES: usize = 100_000;
/// Change of a share from pass to pass below which the loop is as it will stay.
const STEADY: f64 = 1e-14;

/// What becomes of a part in one pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Pass {
    /// It ends as wanted, and leaves.
    Leaves,
    /// It is rejected, and comes back on this face.
    Back(usize),
    /// It comes to lie on no face: a new part takes its place.
    Lost,
}

impl Packed for Pass {
    fn pack(&self, words: &mut Vec<u64>) {
        let (kind, face): (u64, usize) = match self {
            Self::Leaves => (0, 0),
            Self::Lost => (1, 0),
            Self::Back(face) => (2, *face),
        };
        (kind, face).pack(words);
    }

    fn unpack(words: &mut Iter<'_, u64>) -> Option<Self> {
        match <(u64, usize)>::unpack(words)? {
            (0, 0) => Some(Self::Leaves),
            (1, 0) => Some(Self::Lost),
            (2, face) => Some(Self::Back(face)),
            _ => None,
        }
    }
}

/// How many drops pass how, by the face on which they start.
pub(super) type Passes = BTreeMap<(usize, Pass), [u64; REPETITIONS]>;

/// A feeder whose rejected parts are thrown back on it, on the face on which they came to lie, when it has run for long. For each part that ends
/// as wanted, or on no face, a new one comes in, which starts as the scene says.
///
/// # Example
/// A rod that slides off a slope and is never turned: on which face it starts does not matter, and none is thrown back.
/// ```
/// use carom_feeder::{Outcome, Run, examples};
/// use carom_study::yields::{Plan, Points, sample};
/// let plan = Plan { dimensions: 1, samples: 4, seed: 1, points: Points::Sobol, plates: 1, plate: 0 };
/// let slope = |u: &[f64]| Some(examples::rod_on_a_slope(0.5 * u[0]));
/// let found = sample(&plan, slope, |run: &Run| run.outcome == Outcome::Delivered, |_| 0.0)?;
/// let recirculation = found.recirculation.unwrap();
/// assert_eq!((recirculation.starts[0].0, recirculation.starts[0].1.share), (0, 1.0));
/// assert_eq!((recirculation.wanted.share, recirculation.passes), (1.0, 1.0));
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recirculation {
    /// On which faces parts start, new ones and thrown back ones, with the share of each.
    pub starts: Vec<(usize, Estimate)>,
    /// With what probability a part in the loop ends as wanted in one pass.
    pub wanted: Estimate,
    /// Passes for each part that ends as wanted.
    pub passes: f64,
}

impl Recirculation {
    /// From the counts of all drops; `None` where no part leaves, or where parts come back on a face on which none was dropped.
    pub(super) fn of(passes: &Passes) -> Option<Self> {
        let faces: Vec<usize> = passes.keys().map(|key| key.0).collect::<BTreeSet<_>>().into_iter().collect();
        let known = |pass: &Pass| !matches!(pass, Pass::Back(face) if !faces.contains(face));
        if faces.is_empty() || !passes.keys().all(|(_, pass)| known(pass)) {
            return None;
        }
        let all: BTreeMap<(usize, Pass), f64> =
            passes.iter().map(|(key, counts)| (*key, counts.iter().sum::<u64>() as f64)).collect();
        let (starts, wanted) = steady(&faces, &all)?;
        // The spread of the repetitions tells how sure the whole is; one in which no part leaves tells nothing.
        let each: Vec<Steady> = (0..REPETITIONS)
            .filter_map(|k| {
                let own = passes.iter().map(|(key, counts)| (*key, counts[k] as f64)).collect();
                steady(&faces, &own)
            })
            .collect();
        let estimate = |share: f64, of: &dyn Fn(&Steady) -> f64| {
            Estimate::about(share, &each.iter().map(of).collect::<Vec<f64>>())
        };
        Some(Self {
            starts: faces
                .iter()
                .enumerate()
                .map(|(i, face)| (*face, estimate(starts[i], &|found| found.0[i])))
                .collect(),
            wanted: estimate(wanted, &|found| found.1),
            passes: 1.0 / wanted,
        })
    }
}

/// Shares of the faces on which parts start, and with what probability one leaves as wanted.
type Steady = (Vec<f64>, f64);

/// What the counts of one or all repetitions come to.
fn steady(faces: &[usize], counts: &BTreeMap<(usize, Pass), f64>) -> Option<Steady> {
    let of = |face: usize| counts.iter().filter(move |((from, _), _)| *from == face);
    let drops: Vec<f64> = faces.iter().map(|face| of(*face).map(|(_, count)| count).sum()).collect();
    let all: f64 = drops.iter().sum();
    if drops.contains(&0.0) {
        return None;
    }
    let fresh: Vec<f64> = drops.iter().map(|drops| drops / all).collect();
    let share = |i: usize, pass: Pass| counts.get(&(faces[i], pass)).map_or(0.0, |count| count / drops[i]);
    let mut starts = fresh.clone();
    for _ in 0..MOST_PASSES {
        let back =
            |face: usize| (0..faces.len()).map(|i| starts[i] * share(i, Pass::Back(face))).sum::<f64>();
        let back: Vec<f64> = faces.iter().map(|face| back(*face)).collect();
        let new = 1.0 - back.iter().sum::<f64>();
        let next: Vec<f64> = back.iter().zip(&fresh).map(|(back, fresh)| back + new * fresh).collect();
        let change = next.iter().zip(&starts).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        starts = next;
        if change < STEADY {
            break;
        }
    }
    let wanted: f64 = (0..faces.len()).map(|i| starts[i] * share(i, Pass::Leaves)).sum();
    (wanted > 0.0).then_some((starts, wanted))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    /// Of parts on face 0 a half leaves and a half comes back on face 1; of those on face 1 a quarter leaves and the rest stays on it.
    #[test]
    fn a_loop_of_two_faces_is_as_its_equations_say() {
        let passes: Passes = [
            ((0, Pass::Leaves), 2),
            ((0, Pass::Back(1)), 2),
            ((1, Pass::Leaves), 1),
            ((1, Pass::Back(1)), 3),
        ]
        .map(|(key, count)| (key, [count; REPETITIONS]))
        .into();
        let found = Recirculation::of(&passes).unwrap();
        // New parts are half and half. x₀ = n/2, x₁ = x₀/2 + 3 x₁/4 + n/2, n = x₀/2 + x₁/4: x₀ = 1/7 and n = 2/7.
        assert!((found.starts[0].1.share - 1.0 / 7.0).abs() < 1e-12, "{found:?}");
        assert!(
            (found.wanted.share - 2.0 / 7.0).abs() < 1e-12 && (found.passes - 3.5).abs() < 1e-11,
            "{found:?}"
        );
    }

    #[test]
    fn a_face_that_nobody_dropped_leaves_the_loop_unknown() {
        let one = |pass| Passes::from([((0, pass), [1; REPETITIONS])]);
        assert_eq!(Recirculation::of(&one(Pass::Back(1))), None, "what face 1 does is not known");
        assert_eq!(Recirculation::of(&one(Pass::Back(0))), None, "no part ever leaves");
        assert_eq!(Recirculation::of(&Passes::new()), None, "of no drops");
        assert_eq!(Recirculation::of(&one(Pass::Leaves)).unwrap().passes, 1.0, "all leave");
    }
}
