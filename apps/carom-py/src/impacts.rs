//! Many impacts of a body at one contact in one call.

use crate::failure::of_words;
use crate::given::{self, ANY, Given, POSITIVE, Values, at, rows};
use crate::table::{Data, Named, Table};
use crate::watch::long;
use carom_impact::Law;
use carom_impact::planar::{ContactSet, ContactState, Touch, single};
use carom_num::Vec2;
use carom_words::Words;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use rayon::prelude::*;

/// The columns that are given, in their order, each with the ends of what it may be.
const GIVEN: [(&str, [f64; 2]); 11] = [
    ("mass", POSITIVE),
    ("inertia", POSITIVE),
    ("arm_x", ANY),
    ("arm_y", ANY),
    ("normal_x", ANY),
    ("normal_y", ANY),
    ("velocity_x", ANY),
    ("velocity_y", ANY),
    ("spin", ANY),
    ("friction", [0.0, f64::INFINITY]),
    ("restitution", [0.0, 1.0]),
];
/// The columns that come out, with their units.
const FOUND: [(&str, &str); 11] = [
    ("normal_impulse_N_s", "N s"),
    ("tangential_impulse_N_s", "N s"),
    ("velocity_x_m_s", "m/s"),
    ("velocity_y_m_s", "m/s"),
    ("spin_rad_s", "rad/s"),
    ("slip_m_s", "m/s"),
    ("normal_velocity_m_s", "m/s"),
    ("type", ""),
    ("energy_change_J", "J"),
    ("margin", ""),
    ("state", ""),
];
/// All but the last of them are numbers.
const NUMBERS: usize = FOUND.len() - 1;
/// What the last one says.
const STATES: [ContactState; 3] = [ContactState::Separates, ContactState::Sticks, ContactState::Slips];
/// Impacts that one thread takes at once.
const CHUNK: usize = 4096;

/// Some rows of the answer: the first one, their numbers column by column, and their states.
type Piece<'a> = (usize, Vec<&'a mut [f64]>, &'a mut [i16]);

/// One impact in each row. The columns are those of [`GIVEN`], each with a value for every row or one for all.
#[pyfunction]
#[pyo3(signature = (columns, law, progress=None))]
pub(crate) fn impacts(
    py: Python<'_>,
    columns: Vec<PyReadonlyArray1<'_, f64>>,
    law: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Table> {
    let law = given::law(py, law)?;
    let values: Vec<Values<'_>> = columns.iter().map(PyReadonlyArray1::as_array).collect();
    let given = GIVEN.iter().zip(&values);
    let given: Vec<Given<'_>> = given
        .map(|((name, allowed), values)| Given { name, values: values.view(), allowed: *allowed })
        .collect();
    let rows = rows(py, "impacts", &given)?;
    let (x, y) = (&values[4], &values[5]);
    let flat = |row: &usize| at(x, *row) == 0.0 && at(y, *row) == 0.0;
    if let Some(row) = (0..x.len().max(y.len()).min(rows)).find(flat) {
        return Err(of_words(py, &format!("normal: row {row}: (0, 0) has no direction")));
    }
    let (numbers, states) = long(py, Some(rows), progress, |watch| {
        // One by one: a copy of a column would touch all of its memory before the threads do.
        let mut numbers: Vec<Vec<f64>> = (0..NUMBERS).map(|_| vec![0.0; rows]).collect();
        let mut states = vec![0_i16; rows];
        // Each thread writes into its own rows of every column.
        let mut pieces: Vec<Piece<'_>> =
            states.chunks_mut(CHUNK).enumerate().map(|(k, states)| (k * CHUNK, vec![], states)).collect();
        for column in &mut numbers {
            pieces.iter_mut().zip(column.chunks_mut(CHUNK)).for_each(|(piece, rows)| piece.1.push(rows));
        }
        pieces.par_iter_mut().for_each(|(begin, columns, states)| {
            watch.steps(states.len());
            for (k, state) in states.iter_mut().enumerate() {
                let (found, end) = struck(&values, *begin + k, law);
                columns.iter_mut().zip(found).for_each(|(column, number)| column[k] = number);
                *state = end;
            }
        });
        drop(pieces);
        (numbers, states)
    })?;
    let words = STATES.map(|state| state.word().to_owned()).to_vec();
    let data = numbers.into_iter().map(Data::Number).chain([Data::Word { numbers: states, words }]);
    let named = FOUND.iter().zip(data).map(|((name, unit), data)| Named {
        name: (*name).to_owned(),
        unit: (*unit).to_owned(),
        data,
    });
    Ok(Table::new(rows, named.collect()))
}

/// All numbers of one impact, and what its contact does in the end; NaN where the numbers overflow.
fn struck(values: &[Values<'_>], row: usize, law: Law) -> ([f64; NUMBERS], i16) {
    let [mass, inertia, arm_x, arm_y, normal_x, normal_y, vx, vy, spin, friction, restitution] =
        std::array::from_fn(|k| at(&values[k], row));
    let nothing = ([f64::NAN; NUMBERS], -1);
    // Of any length: squares of very long and very short ones are no numbers.
    let length = normal_x.abs().max(normal_y.abs());
    let Some(normal) = Vec2::new(normal_x / length, normal_y / length).unit() else { return nothing };
    let touch = Touch { arm: Vec2::new(arm_x, arm_y), normal, friction, restitution };
    let velocity = Vec2::new(vx, vy);
    let Ok(set) = ContactSet::<1, 2>::of_free_body(mass, inertia, velocity, spin, &[touch]) else {
        return nothing;
    };
    let Ok(out) = single::resolve(&set.alone(0), law) else { return nothing };
    let impulse = normal * out.normal_impulse + normal.turned_right() * out.tangential_impulse;
    let after = velocity + impulse * (1.0 / mass);
    let spin = spin + touch.arm.cross(impulse) / inertia;
    let kind = out.kind.map_or(0.0, |kind| f64::from(kind.number()));
    let numbers = [
        out.normal_impulse,
        out.tangential_impulse,
        after.x,
        after.y,
        spin,
        out.slip,
        out.normal,
        kind,
        out.normal_work + out.tangential_work,
        if out.margin.is_finite() { out.margin } else { f64::NAN },
    ];
    let state = STATES.iter().position(|state| *state == out.state);
    (numbers, state.and_then(|state| i16::try_from(state).ok()).unwrap_or(-1))
}
