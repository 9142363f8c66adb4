//! Reading a roll file of a spatial kind: the keys that both have, then its own.

use super::setup::Setup;
use super::{SpatialRollKind, SpatialRollProblem, body, pyramid, rough, stool};
use crate::drawing::{GRAVITY, STRIKES, TIME};
use crate::problem::{Problem, ProblemKind};
use crate::roll::RollProblems;
use crate::roll::bodies::unfit;
use crate::roll::read::{DEFAULT_GRAVITY, read_overridden};
use crate::section::Section;
use carom_motion::spatial::{Choice, MotionError, Options, World, run};
use carom_num::Vec3;
use std::path::Path;

/// Falls through the body's size for which a body is followed.
const FALLS: f64 = 400.0;
/// What the non-sliding law, the only one of a pyramid's strikes, does not ask.
const NOT_ASKED: [(&str, &str); 3] = [
    (
        "friction",
        "contacts that keep do not slide in space, whatever friction that takes; the result says how much",
    ),
    ("restitution", "strikes in space are plastic"),
    ("law", "strikes in space are plastic, contacts that keep do not slide"),
];
const CHOICES: [(&str, Choice); 3] =
    [("keep most", Choice::KeepMost), ("keep fewest", Choice::KeepFewest), ("end", Choice::End)];

pub(super) fn parse(
    kind: SpatialRollKind,
    file: &str,
    source: &str,
    overrides: &[String],
) -> Result<SpatialRollProblem, RollProblems> {
    let folder = Path::new(file).parent().unwrap_or(Path::new(""));
    let (problem, source) = read_overridden(file, source, overrides, |root| read(kind, folder, root))?;
    Ok(SpatialRollProblem { source, ..problem })
}

fn read(kind: SpatialRollKind, folder: &Path, root: Section<'_>) -> Option<SpatialRollProblem> {
    let asked = kind != SpatialRollKind::Pyramid;
    if !asked {
        refuse_unasked(&root);
    }
    let gravity = root.quantity("gravity", GRAVITY).map_or(DEFAULT_GRAVITY, |g| g.value);
    let strikes = root.quantity("strikes", STRIKES);
    let time = root.quantity("time", TIME);
    let choice = root.word("choice", &CHOICES).unwrap_or_default();
    let friction = if asked { rough::read(&root) } else { None };
    let setup = match kind {
        SpatialRollKind::Pyramid => pyramid::read(&root),
        SpatialRollKind::Stool => stool::read(&root),
        SpatialRollKind::Body => body::read(&root, folder),
    };
    let problem = setup.and_then(|setup| {
        let Setup { body, points, drawing, faces, pyramid, thrown, start } = setup;
        let world = match World::new(body, Vec3::Z * -gravity) {
            Ok(world) => world,
            Err(error) => {
                unfit(&root, "gravity", error.to_string());
                return None;
            }
        };
        let world = rough::with(&root, world, friction)?;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a whole number up to 10 000"
        )]
        let strikes = strikes.map(|n| n.value as u32);
        let most_time = time.map_or(FALLS * world.scales().time, |time| time.value);
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
        startable(&root, problem);
    }
    root.finish();
    problem
}

/// Says of keys of other laws that the non-sliding one does not ask for them.
fn refuse_unasked(root: &Section<'_>) {
    for (key, why) in NOT_ASKED {
        // Asked for only where it stands: no list of keys should offer it.
        if root.has(key) && root.get(key).is_some() {
            let (message, span) = (format!("is not asked: {why}"), Some(root.key_span(key)));
            root.sink().push(Problem::new(ProblemKind::Unsupported, key, message, span));
        }
    }
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
