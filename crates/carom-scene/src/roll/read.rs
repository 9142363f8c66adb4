//! Reading a roll file: the keys that every kind has, then its own.

use super::bodies::Setup;
use super::overrides::overridden;
use super::{NON_SLIDING, RollKind, RollProblem, RollProblems, cylinder, prism, rod};
use crate::drawing::{COUNT, FRICTION, GRAVITY, RESTITUTION, TIME};
use crate::problem::{Problem, ProblemKind};
use crate::read_part::read_law;
use crate::section::{Section, Sink};
use carom_motion::planar::{Obstacle, World};
use carom_num::Vec2;

/// Standard of the papers [m/s²].
pub(super) const DEFAULT_GRAVITY: f64 = 9.81;
/// Falls through the body's size for which a body is followed.
const FALLS: f64 = 20.0;

pub(super) fn parse(
    kind: RollKind,
    file: &str,
    source: &str,
    overrides: &[String],
) -> Result<RollProblem, RollProblems> {
    let (problem, source) = read_overridden(file, source, overrides, |root| read(kind, root))?;
    Ok(RollProblem { source, ..problem })
}

/// What a reader makes of a roll file with its overrides, and the text of both.
pub(super) fn read_overridden<T>(
    file: &str,
    source: &str,
    overrides: &[String],
    read: impl FnOnce(Section<'_>) -> Option<T>,
) -> Result<(T, String), RollProblems> {
    let (both, syntax) = overridden(source, overrides);
    let found = if syntax.is_empty() {
        let sink = Sink::default();
        let found = Section::new("", &both.tree, &sink).and_then(read);
        let mut problems = sink.into_list();
        problems.extend(both.malformed.iter().cloned());
        found.filter(|_| problems.is_empty()).ok_or(problems)
    } else {
        Err([syntax, both.malformed.clone()].concat())
    };
    let written =
        if both.text.is_empty() { source.to_owned() } else { format!("{source}\n# --set\n{}", both.text) };
    found.map(|found| (found, written)).map_err(|problems| RollProblems(both.apart(file, source, problems)))
}

fn read(kind: RollKind, root: Section<'_>) -> Option<RollProblem> {
    if let Some(key) = ["part", "plate", "zigzag", "body", "operator"].into_iter().find(|key| root.has(key)) {
        let message = "this is no roll file: its keys stand in no table";
        let problem = Problem::new(ProblemKind::File, key, message, Some(root.key_span(key)));
        root.sink().push(problem.with_help("`carom run` runs a scene, `carom impact` resolves an impact"));
        return None;
    }
    let friction = root.quantity("friction", FRICTION);
    let restitution = root.quantity("restitution", RESTITUTION).map_or(0.0, |e| e.value);
    let gravity = root.quantity("gravity", GRAVITY).map_or(DEFAULT_GRAVITY, |g| g.value);
    let law = read_law(&root);
    let strikes = root.quantity("strikes", COUNT);
    let time = root.quantity("time", TIME);
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number up to 1000")]
    let strikes = strikes.map(|n| n.value as u32);
    let setup = match kind {
        RollKind::Cylinder => cylinder::read(&root),
        RollKind::Prism => prism::read(&root, strikes),
        RollKind::Rod => rod::read(&root),
    };
    root.finish();
    let Setup { body, segments, unreached, start } = setup?;
    let friction = friction.map(|f| f.value);
    let (names, ends): (Vec<String>, Vec<[Vec2; 2]>) = segments.into_iter().unzip();
    let of = |[from, to]: &[Vec2; 2]| Obstacle::new(*from, *to, friction.unwrap_or(NON_SLIDING), restitution);
    let world = World::of_one(Vec2::new(0.0, -gravity), body, ends.iter().map(of).collect(), law);
    let falls = FALLS + kind.falls_a_strike() * f64::from(strikes.unwrap_or(kind.usual_strikes()));
    let most_time = time.map_or(falls * world.scales().time, |time| time.value);
    Some(RollProblem {
        kind,
        world,
        start,
        friction,
        restitution,
        obstacles: names,
        unreached,
        strikes,
        most_time,
        source: String::new(),
    })
}

impl RollKind {
    /// Falls through the body's size for which it is followed at each strike: a cylinder rolls on for ever where nothing stops it, a prism
    /// may stay long on an edge.
    fn falls_a_strike(self) -> f64 {
        match self {
            Self::Cylinder => 2.0,
            Self::Prism | Self::Rod => 40.0,
        }
    }

    /// Strikes that are followed where nothing is written: one, and for a rod as many as it takes to come to rest.
    pub(super) fn usual_strikes(self) -> u32 {
        match self {
            Self::Cylinder | Self::Prism => 1,
            Self::Rod => 1000,
        }
    }
}
