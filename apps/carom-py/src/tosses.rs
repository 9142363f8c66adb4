//! Many tosses of a body in space in one call: where it is at equal intervals of time.

use crate::answers::toml;
use crate::failure::{of_inputs, of_words};
use crate::given::{Given, at, rows};
use crate::watch::long;
use carom::motion::spatial::{End, Friction, State};
use carom_impact::Law;
use carom_num::{Rotation, Vec3};
use carom_scene::{PoseMark, SpatialRollKind, SpatialRollProblem};
use numpy::ndarray::ArrayView2;
use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use rayon::prelude::*;

/// The columns of a start, in their order: attitudes are unit quaternions, spins in the body's axes.
const START: [&str; 13] = [
    "position_x",
    "position_y",
    "position_z",
    "attitude_w",
    "attitude_x",
    "attitude_y",
    "attitude_z",
    "velocity_x",
    "velocity_y",
    "velocity_z",
    "spin_x",
    "spin_y",
    "spin_z",
];
/// Numbers that an answer may have: 1.6 GB.
const MOST_NUMBERS: usize = 200_000_000;
/// Numbers of a pose: the position and the attitude.
const POSE: usize = 7;

/// What is tossed: the name of a roll file, its text, and whether that is JSON; by which law it strikes; how often it is looked at, and how many times.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub(crate) struct Asks {
    body: (String, String, bool),
    law: String,
    interval: f64,
    count: usize,
}

/// The poses of tosses, a row each: `count` poses one after another, the first at the start. A body that rests stays where it is; where a toss cannot
/// be followed further, NaN.
#[pyfunction]
#[pyo3(signature = (start, friction, restitution, asks, progress=None))]
pub(crate) fn tosses<'py>(
    py: Python<'py>,
    start: PyReadonlyArray2<'py, f64>,
    friction: PyReadonlyArray1<'py, f64>,
    restitution: PyReadonlyArray1<'py, f64>,
    asks: Asks,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let Asks { body: (name, text, json), law, interval, count } = asks;
    let text = toml(py, &name, &text, json)?;
    let problem = SpatialRollProblem::parse(SpatialRollKind::Body, &name, &text, &[])
        .map_err(|found| of_inputs(py, &found.0))?;
    let law = match law.as_str() {
        "poisson" => Law::Poisson,
        "stronge" => Law::Stronge,
        other => return Err(of_words(py, &format!("law: \"{other}\" is none of poisson, stronge"))),
    };
    let (start, friction, restitution) = (start.as_array(), friction.as_array(), restitution.as_array());
    let any = [f64::NEG_INFINITY, f64::INFINITY];
    let columns = START.iter().zip(start.columns());
    let mut given: Vec<Given<'_>> =
        columns.map(|(name, values)| Given { name, values, allowed: any }).collect();
    given.push(Given { name: "friction", values: friction.view(), allowed: [0.0, f64::INFINITY] });
    given.push(Given { name: "restitution", values: restitution.view(), allowed: [0.0, 1.0] });
    let rows = rows(py, "tosses", &given)?;
    if rows.saturating_mul(count).saturating_mul(POSE) > MOST_NUMBERS {
        let message = format!("tosses: {rows} tosses with {count} poses each are too many for one call");
        return Err(of_words(py, &message));
    }
    let starts = (0..start.nrows()).map(|row| state(&start, row)).collect::<Option<Vec<_>>>();
    let starts = starts.ok_or_else(|| of_words(py, "tosses: an attitude of four zeros is no rotation"))?;
    let poses = long(py, Some(rows), progress, |watch| {
        let mut poses = vec![f64::NAN; rows * count * POSE];
        poses.par_chunks_mut((count * POSE).max(1)).enumerate().panic_fuse().for_each(|(row, poses)| {
            watch.step();
            let contact = Friction::new(at(&friction, row)).with_restitution(at(&restitution, row));
            let start = starts[if starts.len() == 1 { 0 } else { row }];
            tossed(&problem, (start, contact.with_law(law)), (interval, count), poses);
        });
        poses
    })?;
    poses.into_pyarray(py).reshape([rows, count * POSE])
}

/// The start in a row; `None` where its attitude is none.
fn state(start: &ArrayView2<'_, f64>, row: usize) -> Option<State> {
    let [px, py, pz, w, x, y, z, vx, vy, vz, sx, sy, sz] = std::array::from_fn(|k| start[[row, k]]);
    Some(State {
        centre: Vec3::new(px, py, pz),
        attitude: Rotation::of([w, x, y, z])?,
        velocity: Vec3::new(vx, vy, vz),
        spin: Vec3::new(sx, sy, sz),
    })
}

/// Writes the poses of one toss; nothing where it cannot be followed.
fn tossed(
    problem: &SpatialRollProblem,
    (start, contact): (State, Friction),
    (interval, count): (f64, usize),
    poses: &mut [f64],
) {
    let Ok(world) = problem.world.clone().with_friction(contact) else { return };
    // As long as it is looked at, whatever the file says.
    let most_time = interval * count as f64;
    let problem = SpatialRollProblem { world, start, most_time, strikes: None, ..problem.clone() };
    let Ok(run) = problem.follow_showing(interval) else { return };
    let regular = run.poses.iter().flatten().filter(|pose| pose.mark == PoseMark::Regular);
    let rests = matches!(run.end, Some(End::AtRest { .. }));
    let rest = std::iter::repeat(run.last).take_while(|_| rests);
    let states = regular.map(|pose| pose.state).chain(rest);
    for (pose, state) in poses.chunks_mut(POSE).zip(states.take(count)) {
        let (centre, attitude) = (state.centre, state.attitude);
        let numbers = [centre.x, centre.y, centre.z, attitude.w, attitude.v.x, attitude.v.y, attitude.v.z];
        pose.copy_from_slice(&numbers);
    }
}
