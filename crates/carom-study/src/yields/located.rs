//! A probability by its boundary. Along one quantity it is located where drops stop to end as wanted; that gives the share of a line. Over the other
//! quantities these shares are averaged.
//!
//! Shares change smoothly, and where the boundary is smooth they are nearly those under a [surface](super::surface) that is fitted to it, whose mean is known.
//! So the mean of the surface is taken, and the mean difference between lines and surface is added. The surface is fitted to the lines of other repetitions
//! than those that it is compared with: a bad one biases nothing.
//!
//! A change is followed down to a short piece of its line, and one more drop, at a place drawn evenly in that piece, decides to which end of the piece the change is put.
//! The lower the change lies, the more often it is the lower end: the mean over draws is where the change is, however long the piece.
//!
//! Each line is also checked at one place, drawn evenly along it. Where a drop there does not do what the line says, the difference counts. So what the
//! nodes of lines do not see biases nothing either, on average over seeds. What no check meets is not in the interval: [`Located::unseen`] bounds it.

use super::surface::Surface;
use super::{Estimate, Plan, REPETITIONS, YieldError, wilson};
use crate::stretches::{self, find};
use carom_num::sobol::random;
use rayon::prelude::*;

/// Where lines are asked at first: at their ends but for a millionth, and between. At the very ends a quantity that is spread normally is infinite.
const NODES: [f64; 5] = [1e-6, 0.25, 0.5, 0.75, 1.0 - 1e-6];
/// How short the piece of a line is in which a change is left.
const WITHIN: f64 = 1.0 / 256.0;
/// Changes that are followed between two nodes.
const MOST_CHANGES: usize = 4;
/// Lines along each quantity that are asked at some nodes, to see which quantity decides.
const TRIALS: u64 = 8;
/// The nodes that they are asked at.
const TRIED: [f64; 3] = [NODES[0], NODES[2], NODES[4]];
/// Lines of a repetition at most: all are kept until the surface is fitted, about 100 bytes each.
const MOST_LINES: u64 = 1 << 14;

/// A probability that was located.
///
/// # Example
/// See [`locate`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Located {
    /// With what probability it ends as wanted; `count` is the number of lines.
    pub wanted: Estimate,
    /// What of all lines may do something else than was seen, at most (Wilson, 95 %, two-sided): of so many checks so many did not do what their line says. With `n` checks and no surprise it is
    /// about 3.8/n.
    pub unseen: f64,
    /// Along which quantity the boundary was located.
    pub along: usize,
    /// How many of the lines change.
    pub changed: u64,
    /// How many drops were followed.
    pub drops: u64,
}

/// One line: where it lies, the share of it that is wanted, about where its only change is (and whether what is below it is wanted), and drops.
#[derive(Clone, Debug, Default)]
struct Line {
    others: Vec<f64>,
    share: f64,
    change: Option<(f64, bool)>,
    /// Whether the ending changes on it at all.
    changes: bool,
    /// Whether it was checked, and whether the check surprised.
    check: Option<bool>,
    drops: u64,
}

/// Locates the boundary of what is wanted: `plan.samples` lines in each repetition. `wanted` says whether the drop at a point of the unit cube ends as it
/// should.
///
/// # Limits
/// The interval is Student's over the repetitions; where hardly a line changes it is at least as wide as Wilson's of independent lines. It does not hold what neither nodes nor checks see: a window of
/// a hundredth of each line, between nodes, is met by none of 16 checks in 85 of 100 seeds. At most 2¹⁴ lines in a repetition.
///
/// # Errors
/// [`YieldError`].
///
/// # Example
/// The corner of a cube that x + y + z = 1 cuts off is a sixth of it.
/// ```
/// use carom_study::yields::{Plan, Points, locate};
/// let plan = Plan { dimensions: 3, samples: 16, seed: 1, points: Points::Sobol, plates: 0, plate: 0 };
/// let found = locate(&plan, |u| u.iter().sum::<f64>() < 1.0)?;
/// assert!((found.wanted.share - 1.0 / 6.0).abs() < 1e-3 && found.drops < 4000);
/// # Ok::<(), carom_study::yields::YieldError>(())
/// ```
pub fn locate(plan: &Plan, wanted: impl Fn(&[f64]) -> bool + Sync) -> Result<Located, YieldError> {
    plan.check()?;
    if plan.samples > MOST_LINES {
        return Err(YieldError::Samples { found: plan.samples, most: MOST_LINES });
    }
    let (along, trials) = decisive(plan, &wanted);
    let lines = plan.rounded();
    let sets: Vec<_> = (0..REPETITIONS).filter_map(|repetition| plan.points(repetition)).collect();
    let one = |number: u64| {
        let points = sets.get((number / lines) as usize)?;
        let draw = |change: usize| random(plan.seed, number, plan.dimensions + change);
        Some(Line::of(points(number % lines), along, draw, &wanted))
    };
    let found: Vec<Line> = (0..plan.drops())
        .into_par_iter()
        .panic_fuse()
        .map(|number| one(number).unwrap_or_default())
        .collect();
    let repetitions: Vec<&[Line]> = found.chunks(lines as usize).collect();
    let (some, rest) = repetitions.split_at(REPETITIONS / 2);
    let surfaces = [fitted(rest), fitted(some)];
    let differs = |(number, own): (usize, &&[Line])| {
        let average = |of: &dyn Fn(&Line) -> f64| own.iter().map(of).sum::<f64>() / own.len() as f64;
        let Some(surface) = &surfaces[number / (REPETITIONS / 2)] else { return average(&|line| line.share) };
        let start: Vec<f64> = (1..plan.dimensions).map(|k| random(plan.seed, number as u64, k)).collect();
        surface.mean(&start) + average(&|line| line.share - surface.share(&line.others))
    };
    let each: Vec<f64> = repetitions.par_iter().enumerate().panic_fuse().map(differs).collect();
    let share = each.iter().sum::<f64>() / each.len() as f64;
    let mut wanted = Estimate { count: found.len() as u64, ..Estimate::about(share.clamp(0.0, 1.0), &each) };
    // Where hardly a line changes, the repetitions are too much alike to tell the spread.
    let changed = found.iter().filter(|line| line.changes).count();
    if changed < REPETITIONS {
        let [low, high] = wilson(wanted.share, found.len() as f64);
        (wanted.low, wanted.high) = (wanted.low.min(low.max(0.0)), wanted.high.max(high.min(1.0)));
    }
    let checks = found.iter().filter_map(|line| line.check);
    let (checked, surprises) =
        (checks.clone().count() as f64, checks.filter(|surprises| *surprises).count() as f64);
    let unseen = if checked > 0.0 { wilson(surprises / checked, checked)[1] } else { 1.0 };
    Ok(Located {
        wanted,
        unseen,
        along,
        changed: changed as u64,
        drops: trials + found.iter().map(|line| line.drops).sum::<u64>(),
    })
}

/// The boundary, from the lines that change once, the way that most of them do.
fn fitted(lines: &[&[Line]]) -> Option<Surface> {
    let changes =
        || lines.iter().flat_map(|lines| lines.iter()).filter_map(|line| Some((line, line.change?)));
    let ways = changes().map(|(_, (_, below))| i64::from(below) * 2 - 1).sum::<i64>();
    let places = changes().filter(|(_, (_, below))| *below == (ways > 0));
    let places: Vec<(&[f64], f64)> = places.map(|(line, (place, _))| (&line.others[..], place)).collect();
    Surface::through(&places, ways > 0)
}

/// The quantity along which most lines change, and the drops that it took to see that.
fn decisive(plan: &Plan, wanted: &(impl Fn(&[f64]) -> bool + Sync)) -> (usize, u64) {
    let Some(points) = plan.points(REPETITIONS) else { return (0, 0) };
    let changes = |along: usize| {
        let line = |number: u64| {
            let mut point = points(number);
            let mut at = |place: f64| {
                point[along] = place;
                wanted(&point)
            };
            let [low, middle, high] = TRIED.map(&mut at);
            low != middle || middle != high
        };
        (0..TRIALS).filter(|number| line(*number)).count()
    };
    let found: Vec<usize> = (0..plan.dimensions).into_par_iter().panic_fuse().map(changes).collect();
    let most = found.iter().copied().max().unwrap_or(0);
    let along = found.iter().position(|changes| *changes == most).unwrap_or(0);
    (along, TRIED.len() as u64 * TRIALS * plan.dimensions as u64)
}

impl Line {
    /// The line through a point, along one quantity, where that point is the check. `draw` gives a number in (0, 1) for each change.
    fn of(
        point: Vec<f64>,
        along: usize,
        draw: impl Fn(usize) -> f64,
        wanted: &(impl Fn(&[f64]) -> bool + Sync),
    ) -> Self {
        let at = |place: f64| {
            let mut moved = point.clone();
            moved[along] = place;
            wanted(&moved)
        };
        let options = stretches::Options { accuracy: WITHIN, most: MOST_CHANGES };
        let found = find(&NODES, options, at, |label| *label);
        let pieces = &found.pieces;
        let others: Vec<f64> =
            point.iter().enumerate().filter(|(k, _)| *k != along).map(|(_, u)| *u).collect();
        let change = match pieces.as_slice() {
            [below, above] => Some((0.5 * (below.last + above.first), below.label)),
            _ => None,
        };
        let mut line = Self {
            others,
            share: 0.0,
            change,
            changes: pieces.len() > 1,
            check: None,
            drops: found.evaluations as u64,
        };
        let whole = |is: bool| f64::from(u8::from(is));
        for (k, piece) in pieces.iter().enumerate() {
            // The ends of the line belong to the pieces there.
            let from = if k == 0 { 0.0 } else { piece.first };
            let to = if k + 1 == pieces.len() { 1.0 } else { piece.last };
            line.share += whole(piece.label) * (to - from);
            if (from..=to).contains(&point[along]) {
                let does = wanted(&point);
                line.drops += 1;
                line.check = Some(does != piece.label);
                line.share += whole(does) - whole(piece.label);
            }
            // One drop speaks for all of the gap before the next piece.
            if let Some(next) = pieces.get(k + 1) {
                let gap = next.first - piece.last;
                line.drops += 1;
                line.share += whole(at(piece.last + gap * draw(k))) * gap;
            }
        }
        line
    }
}
