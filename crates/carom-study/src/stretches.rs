//! A line cut up by what happens at each of its points: [`regions`](crate::regions) in one dimension.
//!
//! A *classifier* gives every point a label, and a label a *kind*: what matters most about it. [`find`] asks at nodes, isolates every change
//! of kind between two neighbours by bisection, and then every other change of label. Where another label turns up between, both halves are
//! searched.
//!
//! # Guarantees
//! Both ends of every bracket were asked: a [`Stretch`] has its label at `first` and `last` and everywhere between that was asked, and another
//! one at its neighbours'. Changes are as far apart as the accuracy, but for those that are [unresolved](Stretches::unresolved). The result does
//! not depend on the number of threads.
//!
//! # Limits
//! The classifier is seen at points only: a stretch shorter than the distance of two nodes may be missed. A classifier that is noise is not
//! followed to the last digit: of more than [`Options::most`] changes between two nodes the uppermost are followed, and the rest are taken as
//! they come. The last change of kind on the line is thus always located, wherever nodes see it.

use rayon::prelude::*;

/// How carefully to look.
///
/// # Example
/// A change is bracketed as closely as is asked for.
/// ```
/// use carom_study::stretches::{Options, find};
/// let pieces = |accuracy| find(&[0.0, 1.0], Options { accuracy, most: 8 }, |x| x < 0.3, |low| *low).pieces;
/// for accuracy in [1e-2, 1e-12] {
///     let found = pieces(accuracy);
///     assert!(found[0].last < 0.3 && 0.3 <= found[1].first && found[1].first - found[0].last <= accuracy);
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// How far apart the points are between which a change is located at most.
    pub accuracy: f64,
    /// Changes that are followed between two neighbouring nodes.
    pub most: usize,
}

/// A piece of the line on which the same was found.
///
/// # Example
/// From 0 to just below 0.3.
/// ```
/// use carom_study::stretches::{Options, Stretch, find};
/// let found = find(&[0.0, 1.0], Options { accuracy: 1e-9, most: 8 }, |x| x < 0.3, |low| *low);
/// let Stretch { label, first, last } = found.pieces[0];
/// assert!(label && first == 0.0 && last < 0.3 && 0.3 - last < 1e-9);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch<L> {
    /// What was found.
    pub label: L,
    /// The first point with it that was asked.
    pub first: f64,
    /// The last point with it that was asked.
    pub last: f64,
}

/// A line, cut up.
///
/// # Example
/// One change costs as many questions as halvings of 1/2 down to a billionth, 29, beside the three nodes.
/// ```
/// use carom_study::stretches::{Options, find};
/// let found = find(&[0.0, 0.5, 1.0], Options { accuracy: 1e-9, most: 8 }, |x| x < 0.3, |low| *low);
/// assert_eq!((found.pieces.len(), found.unresolved, found.evaluations), (2, 0.0, 3 + 29));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Stretches<L> {
    /// Its pieces, in order: neighbours differ, and lie no further apart than the accuracy where all between them was followed.
    pub pieces: Vec<Stretch<L>>,
    /// What of the line lies between neighbours that are further apart than the accuracy: changes that were not followed.
    pub unresolved: f64,
    /// How often the classifier was asked.
    pub evaluations: usize,
}

/// One place of the line and what the classifier says there.
#[derive(Clone, Debug)]
struct Sample<L> {
    at: f64,
    label: L,
}

/// Finds the stretches of equal labels on a line between the first and the last of these nodes, given in any order.
///
/// # Guarantees, limits
/// As the [module](self). An accuracy below the distance of neighbouring doubles asks for that.
///
/// # Example
/// Where the whole part of a square changes between 0 and 1.5: at 1 and at √2.
/// ```
/// use carom_study::stretches::{Options, find};
/// let found = find(&[0.0, 0.7, 1.5], Options { accuracy: 1e-9, most: 64 }, |x| (x * x) as u8, |whole| *whole);
/// let starts: Vec<f64> = found.pieces.iter().map(|piece| piece.first).collect();
/// assert_eq!(starts.len(), 3);
/// assert!((starts[1] - 1.0).abs() < 1e-9 && (starts[2] - 2_f64.sqrt()).abs() < 1e-9);
/// ```
pub fn find<L: Clone + PartialEq + Send + Sync, K: PartialEq>(
    nodes: &[f64],
    options: Options,
    classify: impl Fn(f64) -> L + Sync,
    kind: impl Fn(&L) -> K + Sync,
) -> Stretches<L> {
    let mut places = nodes.to_vec();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let same_kind = |a: &L, b: &L| kind(a) == kind(b);
    let mut asked = asked_at(&places, &classify);
    asked = refined(asked, options, &classify, &same_kind);
    asked = refined(asked, options, &classify, &|a, b| a == b);
    let evaluations = asked.len();
    let mut found = Stretches { pieces: vec![], unresolved: 0.0, evaluations };
    for Sample { at, label } in asked {
        match found.pieces.last_mut() {
            Some(last) if last.label == label => last.last = at,
            before => {
                let gap = before.map_or(0.0, |before| at - before.last);
                if gap > options.accuracy {
                    found.unresolved += gap;
                }
                found.pieces.push(Stretch { label, first: at, last: at });
            }
        }
    }
    found
}

fn asked_at<L: Send>(places: &[f64], classify: &(dyn Fn(f64) -> L + Sync)) -> Vec<Sample<L>> {
    places.par_iter().panic_fuse().map(|at| Sample { at: *at, label: classify(*at) }).collect()
}

/// The same answers, with those of the bisections between neighbours that differ.
fn refined<L: Clone + Send + Sync>(
    asked: Vec<Sample<L>>,
    options: Options,
    classify: &(dyn Fn(f64) -> L + Sync),
    same: &(dyn Fn(&L, &L) -> bool + Sync),
) -> Vec<Sample<L>> {
    let between: Vec<Vec<Sample<L>>> = asked
        .par_windows(2)
        .map(|pair| {
            let mut bisection = Bisection { options, classify, same, found: vec![], changes: 0 };
            if let [low, high] = pair {
                bisection.isolate(low, high);
            }
            bisection.found.reverse();
            bisection.found
        })
        .collect();
    let mut between = between.into_iter();
    let mut out = vec![];
    for one in asked {
        out.push(one);
        out.extend(between.next().unwrap_or_default());
    }
    out
}

/// A bisection between two answers.
struct Bisection<'a, L> {
    options: Options,
    classify: &'a dyn Fn(f64) -> L,
    same: &'a dyn Fn(&L, &L) -> bool,
    /// The answers between, from the upper end down.
    found: Vec<Sample<L>>,
    /// Changes that were located.
    changes: usize,
}

impl<L: Clone> Bisection<'_, L> {
    fn isolate(&mut self, low: &Sample<L>, high: &Sample<L>) {
        if (self.same)(&low.label, &high.label) {
            return;
        }
        let at = 0.5 * (low.at + high.at);
        let resolved = high.at - low.at <= self.options.accuracy || at <= low.at || at >= high.at;
        if resolved || self.changes >= self.options.most {
            self.changes += 1;
            return;
        }
        let middle = Sample { at, label: (self.classify)(at) };
        // Where the budget runs out before all is followed, the upper changes are those that are known.
        self.isolate(&middle, high);
        self.found.push(middle.clone());
        self.isolate(low, &middle);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nodes(count: usize) -> Vec<f64> {
        (0..=count).map(|k| k as f64 / count as f64).collect()
    }

    #[test]
    fn a_change_of_kind_is_located_where_labels_are_noise() {
        // Below 0.3 every point has a label of its own.
        let label = |x: f64| if x < 0.3 { 1 + x.to_bits() } else { 0 };
        let options = Options { accuracy: 1e-9, most: 4 };
        let found = find(&nodes(10), options, label, |label| *label == 0);
        let last = found.pieces.last().unwrap();
        let before = &found.pieces[found.pieces.len() - 2];
        assert!((last.first - 0.3).abs() < 1e-9 && last.first - before.last <= 1e-9, "{last:?} {before:?}");
        assert!(
            found.unresolved > 0.2 && found.evaluations < 500,
            "{} {}",
            found.unresolved,
            found.evaluations
        );
    }

    #[test]
    fn the_last_of_many_changes_between_two_nodes_is_located() {
        // Forty flips between the nodes 0.5 and 1, at multiples of 0.01 up to 0.9.
        let label = |x: f64| if x >= 0.9 { 0 } else { 1 - (100.0 * x) as u64 % 2 };
        let options = Options { accuracy: 1e-9, most: 8 };
        for found in [
            find(&[0.0, 0.5, 1.0], options, label, |label| *label),
            find(&[0.0, 0.5, 1.0], options, label, |_| ()),
        ] {
            let [.., before, last] = found.pieces.as_slice() else { panic!("{found:?}") };
            assert_eq!((before.label, last.label), (1, 0), "0.89 to 0.9 is not lost");
        }
        let label = |x: f64| if x >= 0.9 { 0 } else { 1 + (100.0 * x) as u64 };
        let found = find(&[0.5, 1.0], options, label, |label| *label);
        let [.., before, last] = found.pieces.as_slice() else { panic!("{found:?}") };
        assert!((last.first - 0.9).abs() < 1e-9 && last.first - before.last <= 1e-9, "{last:?} {before:?}");
        assert!(found.unresolved > 0.1, "{}", found.unresolved);
    }

    #[test]
    fn windows_between_nodes_of_one_kind_are_found_where_labels_differ() {
        let label = |x: f64| match x {
            x if x < 0.34 => 1,
            x if x < 0.36 => 2,
            x if x < 0.37 => 1,
            _ => 3,
        };
        let found = find(&nodes(10), Options { accuracy: 1e-6, most: 64 }, label, |_| ());
        let labels: Vec<i32> = found.pieces.iter().map(|piece| piece.label).collect();
        assert_eq!((labels, found.unresolved), (vec![1, 2, 1, 3], 0.0));
        assert_eq!((found.pieces[0].first, found.pieces[3].last), (0.0, 1.0));
    }

    #[test]
    fn one_node_is_a_line_of_one_point() {
        let found = find(&[2.0], Options { accuracy: 0.1, most: 1 }, |_| 7, |_| ());
        assert_eq!(found.pieces, [Stretch { label: 7, first: 2.0, last: 2.0 }]);
        assert!(find(&[], Options { accuracy: 0.1, most: 1 }, |_| 7, |_| ()).pieces.is_empty());
    }
}
