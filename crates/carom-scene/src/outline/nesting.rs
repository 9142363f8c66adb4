//! Which loop is the outline and which are its holes; loops that cross, repeat or stand apart.

use super::drawn::{Fault, MOST_SOUGHT, length, place};
use super::loops::Loop;
use super::moments::Moments;
use crate::tolerance::{NO_AREA, OUTLINE_ROUNDING};
use carom_num::Vec2;
use carom_num::elementary::atan2;
use carom_num::segment::properly_cross;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// A simple loop turns once round; sums of its corners' angles differ from that by rounding only [rad].
const ONCE: f64 = 0.1;
/// Pairs of sides a side that are compared where a drawing is known to be wrong: enough for all pairs of 600 sides. A path that is laid over itself many
/// times has as many pairs of sides as the square of that, none of which need cross.
const ENOUGH_COMPARED: usize = 300;

/// One outline and its holes: counter-clockwise and clockwise.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Nest {
    pub(crate) outer: Loop,
    pub(crate) holes: Vec<Loop>,
}

/// A loop as the corners of a polygon, and which of its edges each chord belongs to.
struct Chain {
    points: Vec<Vec2>,
    edges: Vec<usize>,
    low: Vec2,
    high: Vec2,
}

impl Chain {
    fn of(drawn: &Loop, within: f64) -> Self {
        let (mut points, mut edges) = (vec![], vec![]);
        for (number, edge) in drawn.edges.iter().enumerate() {
            let chords = edge.chords(1.0, within);
            points.extend((0..chords).map(|i| edge.point(i as f64 / chords as f64)));
            edges.resize(points.len(), number);
        }
        let fold = |pick: fn(f64, f64) -> f64, start: f64| {
            points.iter().fold(Vec2::new(start, start), |v, p| Vec2::new(pick(v.x, p.x), pick(v.y, p.y)))
        };
        let (low, high) = (fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY));
        Self { points, edges, low, high }
    }

    fn side(&self, i: usize) -> (Vec2, Vec2) {
        (self.points[i], self.points[(i + 1) % self.points.len()])
    }

    /// By how much its sides turn all round [rad]; those shorter than rounding have no direction.
    fn turning(&self, rounding: f64) -> f64 {
        let sides: Vec<Vec2> = (0..self.points.len())
            .map(|i| self.side(i))
            .map(|(a, b)| b - a)
            .filter(|side| side.norm() > rounding)
            .collect();
        let turn = |i: usize| {
            let (a, b) = (sides[i], sides[(i + 1) % sides.len()]);
            atan2(a.cross(b), a.dot(b))
        };
        (0..sides.len()).map(turn).sum()
    }

    /// True where a point is inside: an odd number of sides are to its right.
    fn holds(&self, point: Vec2) -> bool {
        let crossed = |i: &usize| {
            let (a, b) = self.side(*i);
            (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)
        };
        (0..self.points.len()).filter(crossed).count() % 2 == 1
    }

    /// True where most of another's corners are inside: some may lie on this loop.
    fn surrounds(&self, other: &Self) -> bool {
        let within = self.low.x <= other.low.x
            && self.low.y <= other.low.y
            && other.high.x <= self.high.x
            && other.high.y <= self.high.y;
        let inside = |points: &[Vec2]| points.iter().filter(|point| self.holds(**point)).count();
        within && 2 * inside(&other.points) > other.points.len()
    }
}

/// Sorts loops into one outline and its holes.
///
/// # Errors
/// Every loop that encloses nothing, crosses itself or another, is drawn twice, or stands apart.
pub(crate) fn nest(loops: Vec<Loop>, size: f64, within: f64) -> Result<Nest, Vec<Fault>> {
    let chains: Vec<Chain> = loops.iter().map(|drawn| Chain::of(drawn, within)).collect();
    let areas: Vec<f64> =
        loops.iter().map(|drawn| Moments::of(&drawn.edges, drawn.edges[0].from()).area).collect();
    let rounding = OUTLINE_ROUNDING * size;
    let once: Vec<bool> =
        chains.iter().map(|chain| (chain.turning(rounding).abs() - TAU).abs() <= ONCE).collect();
    let repeats = repeated(&loops, &areas, size);
    let wrong = !repeats.is_empty() || once.contains(&false);
    let (mut faults, _) = crossings(&loops, &chains, rounding, wrong);
    for ((drawn, once), area) in loops.iter().zip(once).zip(&areas) {
        let origin = &drawn.origins[0];
        if area.abs() <= NO_AREA * size * size {
            faults.push(Fault::new(origin.line, format!("{origin} closes a loop that encloses no area")));
        // A crossing that is told already explains a loop that does not turn once.
        } else if faults.is_empty() && !once {
            let text = format!("the loop of {origin} runs through itself or back along itself");
            faults.push(Fault::new(origin.line, text));
        }
    }
    faults.extend(repeats);
    if !faults.is_empty() {
        return Err(faults);
    }
    let depth =
        |i: usize| chains.iter().enumerate().filter(|(j, c)| *j != i && c.surrounds(&chains[i])).count();
    let depths: Vec<usize> = (0..loops.len()).map(depth).collect();
    faults = apart(&loops, &chains, &depths);
    if !faults.is_empty() {
        return Err(faults);
    }
    let mut nest: Option<Nest> = None;
    let mut holes = vec![];
    for ((mut drawn, area), depth) in loops.into_iter().zip(areas).zip(depths) {
        // The outline runs counter-clockwise and holes clockwise, so that their moments add up with the right sign.
        if (area > 0.0) != (depth == 0) {
            drawn.reverse();
        }
        match depth {
            0 => nest = Some(Nest { outer: drawn, holes: vec![] }),
            _ => holes.push(drawn),
        }
    }
    let nothing = || vec![Fault::new(None, "there is no closed outline in it")];
    nest.map(|nest| Nest { holes, ..nest }).ok_or_else(nothing)
}

/// Edges that cross, each pair once, up to [`MOST_SOUGHT`], and how many pairs of sides were compared to find them.
///
/// Of a drawing that is `wrong` whether any cross or not, those among [`ENOUGH_COMPARED`] pairs a side.
fn crossings(loops: &[Loop], chains: &[Chain], slack: f64, wrong: bool) -> (Vec<Fault>, usize) {
    let mut sides: Vec<(usize, usize)> = vec![];
    for (number, chain) in chains.iter().enumerate() {
        sides.extend((0..chain.points.len()).map(|i| (number, i)));
    }
    let span = |side: &(usize, usize)| {
        let (a, b) = chains[side.0].side(side.1);
        (a.x.min(b.x), a.x.max(b.x))
    };
    // Sorted along x, each side is compared only with those that begin before it ends: drawings have thousands of sides that never meet.
    sides.sort_by(|a, b| span(a).0.total_cmp(&span(b).0).then(a.cmp(b)));
    let most = if wrong { ENOUGH_COMPARED.saturating_mul(sides.len()) } else { usize::MAX };
    let mut found = BTreeSet::new();
    let (mut faults, mut compared) = (vec![], 0);
    'sides: for (k, first) in sides.iter().enumerate() {
        let reach = span(first).1;
        for second in sides[k + 1..].iter().take_while(|second| span(second).0 <= reach) {
            if compared == most || faults.len() == MOST_SOUGHT {
                break 'sides;
            }
            compared += 1;
            let ((a, b), (c, d)) = (chains[first.0].side(first.1), chains[second.0].side(second.1));
            if a.y.max(b.y) < c.y.min(d.y)
                || c.y.max(d.y) < a.y.min(b.y)
                || !properly_cross((a, b), (c, d), slack)
            {
                continue;
            }
            let edge = |side: &(usize, usize)| (side.0, chains[side.0].edges[side.1]);
            let (one, other) = (edge(first).min(edge(second)), edge(first).max(edge(second)));
            if found.insert((one, other)) {
                let at = a + (b - a) * ((c - a).cross(d - c) / (b - a).cross(d - c));
                faults.push(crossing(loops, one, other, at));
            }
        }
    }
    (faults, compared)
}

fn crossing(loops: &[Loop], one: (usize, usize), other: (usize, usize), at: Vec2) -> Fault {
    let [first, second] = [one, other].map(|(number, edge)| &loops[number].origins[edge]);
    let text = if first == second {
        format!("{first} crosses itself at {}", place(at))
    } else {
        format!("{first} crosses {second} at {}", place(at))
    };
    Fault::new(first.line, text)
}

/// Loops of the same area about the same point, up to [`MOST_SOUGHT`] pairs.
fn repeated(loops: &[Loop], areas: &[f64], size: f64) -> Vec<Fault> {
    let about = Vec2::ZERO;
    let centre = |drawn: &Loop| Moments::of(&drawn.edges, about).properties(about).centroid;
    let centres: Vec<Vec2> = loops.iter().map(centre).collect();
    // Sorted along x, each loop is compared only with those whose centres are as near: a perforated sheet has thousands of equal holes.
    let mut order: Vec<usize> = (0..loops.len()).collect();
    order.sort_by(|i, j| centres[*i].x.total_cmp(&centres[*j].x).then(i.cmp(j)));
    let (near, alike) = (OUTLINE_ROUNDING * size, NO_AREA * size * size);
    let same = |i: usize, j: usize| {
        (areas[i].abs() - areas[j].abs()).abs() <= alike && (centres[i] - centres[j]).norm() <= near
    };
    let mut pairs = vec![];
    for (k, &i) in order.iter().enumerate() {
        let after = order[k + 1..].iter().take_while(|j| centres[**j].x - centres[i].x <= near);
        pairs.extend(after.filter(|j| same(i, **j)).map(|&j| (i.min(j), i.max(j))));
        if pairs.len() >= MOST_SOUGHT {
            break;
        }
    }
    pairs.sort_unstable();
    pairs.truncate(MOST_SOUGHT);
    let fault = |(i, j): (usize, usize)| {
        let (first, second) = (&loops[i].origins[0], &loops[j].origins[0]);
        Fault::new(second.line, format!("{second} repeats the loop of {first}"))
    };
    pairs.into_iter().map(fault).collect()
}

/// Loops beside the outline, and loops within holes.
fn apart(loops: &[Loop], chains: &[Chain], depths: &[usize]) -> Vec<Fault> {
    let outside = depths.iter().filter(|depth| **depth == 0).count();
    let help = "a part is one piece: keep one outline; of a DXF file `layer` can choose it";
    let fault = |i: usize, what: &str| {
        let (origin, size) = (&loops[i].origins[0], chains[i].high - chains[i].low);
        let text = format!("{what} {origin} ({} by {})", length(size.x), length(size.y));
        Fault::new(origin.line, text).with_help(help)
    };
    let judged = depths.iter().enumerate().filter_map(|(i, depth)| match depth {
        0 if outside > 1 => Some(fault(i, &format!("one of {outside} separate outlines:"))),
        0 | 1 => None,
        _ => Some(fault(i, "an outline within a hole:")),
    });
    judged.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outline::drawn::Origin;
    use crate::outline::edge::Edge;

    /// A side of the square that is drawn, and how near to it chords are looked for [m].
    const SIZE: f64 = 1.0;
    const WITHIN: f64 = 1e-3;

    /// A square that is drawn so many times in one go.
    fn laps(count: usize) -> Loop {
        let corners = [(0.0, 0.0), (SIZE, 0.0), (SIZE, SIZE), (0.0, SIZE)].map(|(x, y)| Vec2::new(x, y));
        let side = |i: usize| Edge::Line { from: corners[i % 4], to: corners[(i + 1) % 4] };
        let origin = Origin { name: "<path>".to_owned(), line: 1 };
        Loop { edges: (0..4 * count).map(side).collect(), origins: vec![origin; 4 * count] }
    }

    /// Pairs of sides that are compared to judge so many laps.
    fn compared(count: usize, wrong: bool) -> usize {
        let drawn = [laps(count)];
        let chains = drawn.each_ref().map(|drawn| Chain::of(drawn, WITHIN));
        let (faults, compared) = crossings(&drawn, &chains, OUTLINE_ROUNDING * SIZE, wrong);
        assert!(faults.is_empty(), "sides that lie on each other do not cross: {faults:?}");
        compared
    }

    /// Of 4 n sides n lie on each of the square's, and all overlap along x but those of the left with those of the right: of 4n (4n − 1)/2 pairs n² are not compared.
    #[test]
    fn a_path_laid_over_itself_is_told_in_work_that_grows_with_its_length() {
        assert_eq!(compared(100, false), 400 * 399 / 2 - 100 * 100, "all pairs that overlap");
        for count in [1000, 5000] {
            assert_eq!(compared(count, true), ENOUGH_COMPARED * 4 * count, "{count} laps");
            let faults = nest(vec![laps(count)], SIZE, WITHIN).unwrap_err();
            let text = "the loop of the <path> in line 1 runs through itself or back along itself";
            assert_eq!(faults, [Fault::new(1, text)], "{count} laps");
        }
    }

    #[test]
    fn a_loop_that_is_drawn_many_times_is_told_with_its_repeats_as_far_as_any_are_sought() {
        let faults = nest((0..5000).map(|_| laps(1)).collect(), SIZE, WITHIN).unwrap_err();
        assert_eq!(faults.len(), MOST_SOUGHT, "of 12 497 500 pairs");
        assert!(faults.iter().all(|fault| fault.text.contains("repeats the loop")), "{:?}", faults[0]);
    }
}
