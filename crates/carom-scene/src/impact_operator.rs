//! The operator alone: between any bodies, for one contact or for several.

use crate::grammar::Section;
use crate::impact_contacts::{ImpactContacts, MOST_PIVOTED};
use crate::impact_touch::letter;
use crate::node::Value;
use crate::problem::ProblemKind;
use crate::tolerance::MATRIX_ROUNDING;
use carom_impact::planar::{Block, ContactSet, ContactSet6, MOST_CONTACTS};

/// How a matrix stands for contacts.
pub(crate) struct Rows {
    /// Rows of each contact.
    pub(crate) per: usize,
    /// What they are.
    pub(crate) words: &'static str,
    /// Contacts at most.
    pub(crate) most: usize,
}

const PLANE: Rows =
    Rows { per: 2, words: "two rows for each contact, tangential and normal", most: MOST_PIVOTED };

impl Rows {
    /// How many contacts so many rows are of.
    fn contacts(&self, size: usize) -> Option<usize> {
        let fits = size > 0 && size.is_multiple_of(self.per) && size <= self.per * self.most;
        fits.then_some(size / self.per)
    }

    /// How many contacts the matrix is of, whatever else is wrong with it.
    pub(crate) fn count(&self, section: &Section<'_>) -> Option<usize> {
        match &section.get("matrix")?.value {
            Value::List(rows) => self.contacts(rows.len()),
            _ => None,
        }
    }
}

/// Names and contacts of `[operator]`.
pub(crate) fn read_operator(root: &Section<'_>) -> Option<(Vec<String>, ImpactContacts)> {
    let section = root.section("operator")?;
    let found = if section.has("matrix") { read_many(&section) } else { read_one(&section) };
    let contacts = found?;
    Some(((0..contacts.count()).map(letter).collect(), contacts))
}

fn none<const N: usize, const M: usize>() -> ContactSet<N, M> {
    ContactSet {
        count: 0,
        operator: [[Block::default(); N]; N],
        slip: [0.0; N],
        normal: [0.0; N],
        friction: [0.0; N],
        restitution: [0.0; N],
    }
}

fn read_one(section: &Section<'_>) -> Option<ImpactContacts> {
    let (tt, tn, nn) = (section.value("w_tt")?, section.value("w_tn")?, section.value("w_nn")?);
    if tn * tn >= tt * nn {
        let message = "is impossible for any bodies: w_tn² must be less than w_tt w_nn";
        section.blame(ProblemKind::OutOfRange, "w_tn", message);
        return None;
    }
    let mut set: ContactSet6 = none();
    set.count = 1;
    set.operator[0][0] = Block { tt, tn, nt: tn, nn };
    (set.slip[0], set.normal[0]) = (section.value("slip")?, section.value("approach")?);
    (set.friction[0], set.restitution[0]) = (section.value("friction")?, section.number("restitution"));
    Some(set.into())
}

/// `matrix` (2n × 2n), `velocity` (2n), `friction` and `restitution` (n, or one for all); tangential and normal by turns.
fn read_many(section: &Section<'_>) -> Option<ImpactContacts> {
    let matrix = read_matrix(section, &PLANE);
    // Its rows say how long the lists should be, whatever else is wrong with it.
    let count = PLANE.count(section);
    let velocity = read_list(section, "velocity", count.map(|count| 2 * count));
    let [friction, restitution] = read_surfaces(section, count);
    let (matrix, count) = (matrix?, count?);
    let (velocity, friction, restitution) = (velocity?, friction?, restitution?);
    let lists = [&velocity, &friction, &restitution].map(Vec::as_slice);
    Some(if count > MOST_CONTACTS {
        ImpactContacts::Many(Box::new(filled(&matrix, lists)))
    } else {
        filled::<MOST_CONTACTS, { 2 * MOST_CONTACTS }>(&matrix, lists).into()
    })
}

/// The contacts of a matrix, with their velocities, friction and restitution.
fn filled<const N: usize, const M: usize>(
    matrix: &[Vec<f64>],
    [velocity, friction, restitution]: [&[f64]; 3],
) -> ContactSet<N, M> {
    let count = friction.len();
    let mut set = none();
    set.count = count;
    for i in 0..count {
        for j in 0..count {
            let at = |a: usize, b: usize| matrix[2 * i + a][2 * j + b];
            set.operator[i][j] = Block { tt: at(0, 0), tn: at(0, 1), nt: at(1, 0), nn: at(1, 1) };
        }
        (set.slip[i], set.normal[i]) = (velocity[2 * i], velocity[2 * i + 1]);
        (set.friction[i], set.restitution[i]) = (friction[i], restitution[i]);
    }
    set
}

/// `friction` and `restitution` of so many contacts.
pub(crate) fn read_surfaces(section: &Section<'_>, count: Option<usize>) -> [Option<Vec<f64>>; 2] {
    let friction = read_list(section, "friction", count);
    let restitution = match section.has("restitution") {
        true => read_list(section, "restitution", count),
        false => Some(vec![0.0; count.unwrap_or(0)]),
    };
    [friction, restitution]
}

/// A matrix that is symmetric and has no negative eigenvalue.
pub(crate) fn read_matrix(section: &Section<'_>, of: &Rows) -> Option<Vec<Vec<f64>>> {
    let problem = |kind, message: String| {
        section.blame_value(kind, "matrix", message);
        None::<Vec<Vec<f64>>>
    };
    let Value::List(rows) = &section.get("matrix")?.value else { return None };
    let size = rows.len();
    if of.contacts(size).is_none() {
        let message = format!("needs {}, up to {}; found {size}", of.words, of.per * of.most);
        return problem(ProblemKind::Geometry, message);
    }
    let matrix: Vec<Vec<f64>> = section.rows("matrix")?;
    let uneven: Vec<(usize, usize)> =
        matrix.iter().map(Vec::len).enumerate().filter(|(_, length)| *length != size).collect();
    for (i, length) in &uneven {
        problem(ProblemKind::Geometry, format!("row {i} has {length} numbers, expected {size}"));
    }
    if !uneven.is_empty() {
        return None;
    }
    // Rounding is measured against the largest entry: entries have no unit of their own to be small in.
    let largest = matrix.iter().flatten().fold(0.0f64, |largest, entry| largest.max(entry.abs()));
    let pairs = (0..size).flat_map(|i| (0..i).map(move |j| (i, j)));
    let mut skew = pairs.filter(|(i, j)| (matrix[*i][*j] - matrix[*j][*i]).abs() > MATRIX_ROUNDING * largest);
    if let Some((i, j)) = skew.next() {
        let message =
            format!("must be symmetric: [{i}][{j}] is {}, [{j}][{i}] is {}", matrix[i][j], matrix[j][i]);
        return problem(ProblemKind::OutOfRange, message);
    }
    if !is_semidefinite(&matrix, MATRIX_ROUNDING * largest) {
        let message =
            "must have no negative eigenvalue: an impulse cannot take a velocity against itself".into();
        return problem(ProblemKind::OutOfRange, message);
    }
    Some(matrix)
}

/// Cholesky's decomposition, a vanishing pivot having a vanishing row.
fn is_semidefinite(matrix: &[Vec<f64>], rounding: f64) -> bool {
    let mut left = matrix.to_vec();
    for k in 0..left.len() {
        let pivot = left[k][k];
        if pivot < -rounding
            || (pivot <= rounding && (k..left.len()).any(|i| left[i][k].abs() > 1e3 * rounding))
        {
            return false;
        }
        if pivot <= rounding {
            continue;
        }
        for i in k + 1..left.len() {
            for j in k + 1..left.len() {
                let taken = left[i][k] * left[k][j] / pivot;
                left[i][j] -= taken;
            }
        }
    }
    true
}

/// A list of `count` quantities, or one quantity for all; of any length where the count is not known.
fn read_list(section: &Section<'_>, key: &str, count: Option<usize>) -> Option<Vec<f64>> {
    let Value::List(_) = section.get(key)?.value else {
        return Some(vec![section.value(key)?; count.unwrap_or(1)]);
    };
    let values = section.values(key)?;
    if let Some(count) = count.filter(|count| values.len() != *count) {
        let plural = if count == 1 { "" } else { "s" };
        let message = format!("expected {count} number{plural}, found {}", values.len());
        section.blame_value(ProblemKind::Geometry, key, message);
        return None;
    }
    Some(values)
}
