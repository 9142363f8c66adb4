//! Reading a roll file of a spatial kind: the keys that both have, then its own.

use super::setup::Setup;
use super::{SpatialRollKind, SpatialRollProblem, body, pyramid, rough, stool};
use crate::grammar::roll_space::{BODY_FILE, PYRAMID_FILE, STOOL_FILE};
use crate::grammar::{File, Section};
use crate::input::{Beside, Files};
use crate::roll::RollProblems;
use crate::roll::bodies::unfit;
use crate::roll::read::read_overridden;
use carom_motion::MotionError;
use carom_motion::spatial::{Options, World, run};
use carom_num::Vec3;
use std::path::Path;

/// Falls through the body's size for which a body is followed.
pub(super) const FALLS: f64 = 400.0;

pub(super) fn parse(
    kind: SpatialRollKind,
    file: &str,
    source: &str,
    overrides: &[String],
    files: &dyn Files,
) -> Result<SpatialRollProblem, RollProblems> {
    let beside = Beside { folder: Path::new(file).parent().unwrap_or(Path::new("")), files };
    let (problem, source) =
        read_overridden(grammar_of(kind), file, source, overrides, |root| read(kind, beside, root))?;
    Ok(SpatialRollProblem { source, ..problem })
}

/// What may stand in a roll file.
pub(crate) fn grammar_of(kind: SpatialRollKind) -> &'static File {
    match kind {
        SpatialRollKind::Pyramid => &PYRAMID_FILE,
        SpatialRollKind::Stool => &STOOL_FILE,
        SpatialRollKind::Body => &BODY_FILE,
    }
}

fn read(kind: SpatialRollKind, beside: Beside<'_>, root: &Section<'_>) -> Option<SpatialRollProblem> {
    let gravity = root.number("gravity");
    let (strikes, time) = (root.value("strikes"), root.value("time"));
    let choice = root.word_or_default("choice");
    let friction = if kind == SpatialRollKind::Pyramid { None } else { rough::read(root) };
    let setup = match kind {
        SpatialRollKind::Pyramid => pyramid::read(root),
        SpatialRollKind::Stool => stool::read(root),
        SpatialRollKind::Body => body::read(root, beside),
    };
    let problem = setup.and_then(|setup| {
        let Setup { body, points, drawing, faces, pyramid, thrown, start } = setup;
        let world = match World::new(body, Vec3::Z * -gravity) {
            Ok(world) => world,
            Err(error) => {
                unfit(root, "gravity", error.to_string());
                return None;
            }
        };
        let world = rough::with(root, world, friction)?;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number up to 10 000"
        )]
        let strikes = strikes.map(|n| n as u32);
        let most_time = time.unwrap_or(FALLS * world.scales().time);
        // A pyramid is meant to roll over, a thrown body has no right way up.
        let overturns = kind == SpatialRollKind::Stool;
        let source = String::new();
        Some(SpatialRollProblem {
            kind,
            world,
            start,
            points,
            drawing,
            faces,
            pyramid,
            thrown,
            strikes,
            most_time,
            choice,
            overturns,
            source,
        })
    });
    if let Some(problem) = &problem {
        startable(root, problem);
    }
    problem
}

/// Whether a run can begin there: the engine is asked, for a step.
fn startable(root: &Section<'_>, problem: &SpatialRollProblem) {
    if !problem.start.kinetic(problem.world.body()).is_finite() {
        let key = if problem.pyramid.is_some() { "roll_rate" } else { "spin" };
        unfit(root, key, "is too large: the kinetic energy is beyond every number");
        return;
    }
    let options = Options { most_steps: 1, most_impacts: 1, ..Options::default() };
    let name = |point: usize| problem.points.get(point).map_or("?", String::as_str);
    match run(&problem.world, &problem.start, &options, &mut ()) {
        Err(MotionError::Below { support, depth }) => {
            let message = format!("would put {} {depth:.6} m below the plane", name(support));
            let key = match problem.kind {
                SpatialRollKind::Body => "height",
                _ if root.has("axis") => "axis",
                _ => "tilt",
            };
            unfit(root, key, message);
        }
        Err(MotionError::Slides { support, speed }) => {
            let message = format!(
                "would let {}, which stands on the plane too, slide along it with {speed:.6} m/s",
                name(support)
            );
            let key = if root.has("velocity") { "velocity" } else { "spin" };
            unfit(root, key, message);
        }
        _ => {}
    }
}
