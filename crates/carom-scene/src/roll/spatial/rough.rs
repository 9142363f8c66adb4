//! Friction of the plane under a stool or a body that is thrown, and what the law of its strikes is called.

use super::{SpatialRollKind, SpatialRollProblem};
use crate::grammar::Section;
use crate::roll::bodies::unfit;
use carom_impact::Law;
use carom_motion::spatial::{Friction, World};
use carom_words::Words;

/// The friction that a file writes; `None` for the non-sliding law.
pub(super) fn read(root: &Section<'_>) -> Option<Friction> {
    let (friction, restitution) = (root.value("friction"), root.number("restitution"));
    let law: Law = root.word_or_default("law");
    Some(Friction::new(friction?).with_restitution(restitution).with_law(law))
}

/// The world with its friction, where it has some.
pub(super) fn with(root: &Section<'_>, world: World, friction: Option<Friction>) -> Option<World> {
    let Some(friction) = friction else { return Some(world) };
    match world.with_friction(friction) {
        Ok(world) => Some(world),
        Err(problem) => {
            unfit(root, "friction", problem.to_string());
            None
        }
    }
}

impl SpatialRollProblem {
    /// By which law its strikes go, in a sentence.
    pub fn law_in_words(&self) -> String {
        match self.world.friction() {
            None => "Strikes are plastic, and no contact slides: a contact that keeps comes to rest, whatever friction that takes.".to_owned(),
            Some(friction) => format!(
                "Friction {} after Coulomb at every {}, restitution {} after {}.",
                friction.coefficient(0),
                if self.kind == SpatialRollKind::Body { "vertex" } else { "support" },
                friction.restitution(0),
                friction.law().word()
            ),
        }
    }
}
