//! Reading a roll file: the keys that every kind has, then its own.

use super::bodies::Setup;
use super::overrides::overridden;
use super::{NON_SLIDING, RollKind, RollProblem, RollProblems, cylinder, prism, rod};
use crate::grammar::roll::{CYLINDER_FILE, PRISM_FILE, ROD_FILE};
use crate::grammar::{File, Section, read_checked};
use carom_motion::planar::{Obstacle, World};
use carom_num::Vec2;

/// Falls through the body's size for which a body is followed.
const FALLS: f64 = 20.0;

pub(super) fn parse(
    kind: RollKind,
    file: &str,
    source: &str,
    overrides: &[String],
) -> Result<RollProblem, RollProblems> {
    let (problem, source) =
        read_overridden(grammar_of(kind), file, source, overrides, |root| read(kind, root))?;
    Ok(RollProblem { source, ..problem })
}

/// What may stand in a roll file.
pub(crate) fn grammar_of(kind: RollKind) -> &'static File {
    match kind {
        RollKind::Cylinder => &CYLINDER_FILE,
        RollKind::Prism => &PRISM_FILE,
        RollKind::Rod => &ROD_FILE,
    }
}

/// What a reader makes of a roll file with its overrides, and the text of both.
pub(super) fn read_overridden<T>(
    grammar: &File,
    file: &str,
    source: &str,
    overrides: &[String],
    read: impl FnOnce(&Section<'_>) -> Option<T>,
) -> Result<(T, String), RollProblems> {
    let (both, syntax) = overridden(source, overrides);
    let found = if syntax.is_empty() { read_checked(grammar, &both.tree, read) } else { Err(syntax) };
    // What is no override is told beside whatever else is wrong.
    let found = if both.malformed.is_empty() {
        found
    } else {
        Err([found.err().unwrap_or_default(), both.malformed.clone()].concat())
    };
    let written =
        if both.text.is_empty() { source.to_owned() } else { format!("{source}\n# --set\n{}", both.text) };
    found.map(|found| (found, written)).map_err(|problems| RollProblems(both.apart(file, source, problems)))
}

fn read(kind: RollKind, root: &Section<'_>) -> Option<RollProblem> {
    let friction = root.quantity("friction");
    let (restitution, gravity) = (root.number("restitution"), root.number("gravity"));
    let law = root.word_or_default("law");
    let time = root.quantity("time");
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number up to 1000")]
    let strikes = root.value("strikes").map(|n| n as u32);
    let setup = match kind {
        RollKind::Cylinder => cylinder::read(root),
        RollKind::Prism => prism::read(root, strikes),
        RollKind::Rod => rod::read(root),
    };
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
