//! Many impacts of a body at several contacts in one call.

use crate::failure::of_words;
use crate::given::{self, ANY, Given, POSITIVE, Values, at, rows};
use crate::table::{Data, Named, Table};
use crate::watch::long;
use carom_impact::Law;
use carom_impact::planar::Touch;
use carom_num::Vec2;
use carom_scene::{ImpactAnswerReport, ImpactBody, ImpactOutcome, ImpactProblem};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use rayon::prelude::*;

/// What is given of the body.
const BODY: [(&str, [f64; 2]); 5] =
    [("mass", POSITIVE), ("inertia", POSITIVE), ("velocity[0]", ANY), ("velocity[1]", ANY), ("spin", ANY)];
/// What is given of each contact.
const CONTACT: [(&str, [f64; 2]); 6] = [
    ("points[#, 0]", ANY),
    ("points[#, 1]", ANY),
    ("normals[#, 0]", ANY),
    ("normals[#, 1]", ANY),
    ("friction[#]", [0.0, f64::INFINITY]),
    ("restitution[#]", [0.0, 1.0]),
];
/// Numbers that come out of the body, and of each contact.
const OF_BODY: [(&str, &str); 5] = [
    ("velocity_x_m_s", "m/s"),
    ("velocity_y_m_s", "m/s"),
    ("spin_rad_s", "rad/s"),
    ("energy_before_J", "J"),
    ("energy_after_J", "J"),
];
const OF_CONTACT: [(&str, &str); 4] = [
    ("normal_impulse_N_s", "N s"),
    ("tangential_impulse_N_s", "N s"),
    ("normal_velocity_m_s", "m/s"),
    ("slip_m_s", "m/s"),
];

/// What one row says: whether its answer is the only one, its numbers, and what its contacts do.
type Row = (Option<&'static str>, Vec<f64>, Vec<Option<&'static str>>);

/// One impact in each row. The columns are those of [`BODY`], and of [`CONTACT`] for every contact.
#[pyfunction]
#[pyo3(signature = (columns, contacts, law, progress=None))]
pub(crate) fn impact_batch(
    py: Python<'_>,
    columns: Vec<PyReadonlyArray1<'_, f64>>,
    contacts: usize,
    law: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Table> {
    let law = given::law(py, law)?;
    let values: Vec<Values<'_>> = columns.iter().map(PyReadonlyArray1::as_array).collect();
    let body = BODY.iter().map(|(name, allowed)| ((*name).to_owned(), *allowed));
    let of_contact = |i: usize| CONTACT.map(|(name, allowed)| (name.replace('#', &i.to_string()), allowed));
    let names: Vec<(String, [f64; 2])> = body.chain((0..contacts).flat_map(of_contact)).collect();
    let given: Vec<Given<'_>> = names
        .iter()
        .zip(&values)
        .map(|((name, allowed), values)| Given { name, values: values.view(), allowed: *allowed })
        .collect();
    let rows = rows(py, "impact_batch", &given)?;
    let flat = |row: &usize| normals(&values, contacts, *row).iter().any(|n| n.x == 0.0 && n.y == 0.0);
    if let Some(row) = (0..rows).find(flat) {
        return Err(of_words(py, &format!("normals: row {row}: (0, 0) has no direction")));
    }
    let found: Vec<Row> = long(py, Some(rows), progress, |watch| {
        let one = |row: usize| {
            watch.step();
            struck(&values, contacts, row, law)
        };
        (0..rows).into_par_iter().panic_fuse().map(one).collect()
    })?;
    Ok(table(&found, contacts))
}

fn normals(values: &[Values<'_>], contacts: usize, row: usize) -> Vec<Vec2> {
    let first = |i: usize| BODY.len() + CONTACT.len() * i + 2;
    (0..contacts).map(|i| Vec2::new(at(&values[first(i)], row), at(&values[first(i) + 1], row))).collect()
}

/// The impact of a row; NaN where the numbers overflow, or there is no walk.
fn struck(values: &[Values<'_>], contacts: usize, row: usize, law: Law) -> Row {
    let number = |column: usize| at(&values[column], row);
    let touch = |(i, normal): (usize, Vec2)| {
        let first = BODY.len() + CONTACT.len() * i;
        // As a file's; squares of very long and very short ones are no numbers.
        let length = normal.x.abs().max(normal.y.abs());
        let normal = normal.unit().or_else(|| Vec2::new(normal.x / length, normal.y / length).unit())?;
        let arm = Vec2::new(number(first), number(first + 1));
        Some(Touch { arm, normal, friction: number(first + 4), restitution: number(first + 5) })
    };
    let touches: Option<Vec<Touch>> =
        normals(values, contacts, row).into_iter().enumerate().map(touch).collect();
    let problem = touches.and_then(|touches| {
        let [mass, inertia, x, y, spin] = std::array::from_fn(number);
        let body = ImpactBody { mass, inertia, velocity: Vec2::new(x, y), spin, touches };
        ImpactProblem::of_body(law, body).ok()
    });
    let nothing = vec![f64::NAN; OF_BODY.len() + OF_CONTACT.len() * contacts];
    let Some(problem) = problem else { return (None, nothing, vec![None; contacts]) };
    let report = ImpactAnswerReport::new(&problem, &problem.solve_as_asked());
    let outcome = Some(said(report.outcome));
    let many = || report.end_states.first().map(|state| &state.end);
    let Some(end) = report.staged.as_ref().map(|staged| &staged.end).or_else(many) else {
        return (outcome, nothing, vec![None; contacts]);
    };
    let [x, y] = end.velocity_m_s.unwrap_or([f64::NAN; 2]);
    let or_nan = |number: Option<f64>| number.unwrap_or(f64::NAN);
    let mut numbers = vec![x, y, or_nan(end.spin_rad_s), or_nan(end.energy_before), or_nan(end.energy_after)];
    for contact in &end.contacts {
        let found = [
            contact.normal_impulse,
            contact.tangential_impulse,
            contact.normal_velocity_m_s,
            contact.slip_m_s,
        ];
        numbers.extend(found);
    }
    (outcome, numbers, end.contacts.iter().map(|contact| Some(contact.state.as_str())).collect())
}

/// The word that an answer has for it.
fn said(outcome: ImpactOutcome) -> &'static str {
    match outcome {
        ImpactOutcome::Unique => "unique",
        ImpactOutcome::Several => "several",
        ImpactOutcome::PathDependent => "path_dependent",
        ImpactOutcome::None => "none",
        ImpactOutcome::Unresolved => "unresolved",
        ImpactOutcome::Found => "found",
        ImpactOutcome::NotFound => "not_found",
    }
}

fn table(found: &[Row], contacts: usize) -> Table {
    let mut outcome = Data::words();
    found.iter().for_each(|(word, _, _)| outcome.push_word(*word));
    let named = |name: String, unit: &str, data: Data| Named { name, unit: unit.to_owned(), data };
    let column = |k: usize| Data::Number(found.iter().map(|(_, numbers, _)| numbers[k]).collect());
    let mut all = vec![named("outcome".to_owned(), "", outcome)];
    all.extend(
        OF_BODY.iter().enumerate().map(|(k, (name, unit))| named((*name).to_owned(), unit, column(k))),
    );
    for i in 0..contacts {
        let mut states = Data::words();
        found.iter().for_each(|(_, _, words)| states.push_word(words[i]));
        all.push(named(format!("state.{i}"), "", states));
        let first = OF_BODY.len() + OF_CONTACT.len() * i;
        all.extend(
            OF_CONTACT
                .iter()
                .enumerate()
                .map(|(k, (name, unit))| named(format!("{name}.{i}"), unit, column(first + k))),
        );
    }
    Table::new(found.len(), all)
}
