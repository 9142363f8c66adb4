//! `--poses DT`: where a body is at equal intervals of time.

use crate::args::RollOptions;
use crate::failure::Failure;
use carom_scene::{PosesError, RollProblem, RollRun, SpatialRollProblem, SpatialRollRun, pose_interval};
use std::fmt::Display;
use std::io::Write;
use std::path::Path;

/// The interval of the poses that are asked for \[s\]; or what cannot be done with them, whatever is rolled.
pub(super) fn interval(options: &RollOptions) -> Result<Option<f64>, Failure> {
    if options.poses.is_some() && options.throws.is_some() {
        let message = "--poses does not go with --throws: only how throws end is counted, and each is made again by the options that the result names";
        return Err(Failure::Usage(message.to_owned()));
    }
    let of = |asked: &String| pose_interval(asked).map_err(|why| Failure::Usage(format!("--poses: {why}")));
    options.poses.as_ref().map(of).transpose()
}

fn failure(name: &str, error: &PosesError<impl Display>) -> Failure {
    match error {
        PosesError::Fault(fault) => Failure::Undone(format!("{name}: {fault}")),
        PosesError::TooMany { .. } => Failure::Usage(format!("{name}: --poses: {error}")),
    }
}

/// Follows a body in the plane, with its poses where they are asked for.
pub(super) fn planar(name: &str, problem: &RollProblem, every: Option<f64>) -> Result<RollRun, Failure> {
    let run = match every {
        Some(interval) => problem.follow_showing(interval),
        None => problem.follow().map_err(PosesError::Fault),
    };
    run.map_err(|error| failure(name, &error))
}

/// Follows a body in space, with its poses where they are asked for.
pub(super) fn spatial(
    name: &str,
    problem: &SpatialRollProblem,
    every: Option<f64>,
) -> Result<SpatialRollRun, Failure> {
    let run = match every {
        Some(interval) => problem.follow_showing(interval),
        None => problem.follow().map_err(PosesError::Fault),
    };
    run.map_err(|error| failure(name, &error))
}

/// Tells a person where the poses are.
pub(super) fn tell_where(count: Option<usize>, file: &Path, out: &mut impl Write) -> std::io::Result<()> {
    match count {
        Some(count) => writeln!(out, "{count} poses {}", file.display()),
        None => Ok(()),
    }
}
