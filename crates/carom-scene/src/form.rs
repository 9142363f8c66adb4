//! The form of files: which keys they may have, what these hold, and which go together.

use crate::grammar::{File, Sink, check, comment_of, impact::IMPACT, scene::SCENE};
use crate::node::from_toml;
use crate::problem::Problem;
use crate::read_scene::LONGEST_PLAIN;
use crate::roll::spatial::SpatialRollKind;
use crate::roll::{self, RollKind};

/// A kind of file that Carom reads.
///
/// # Example
/// A misspelt key is seen without anything being laid out; what the numbers mean together is not.
/// ```
/// use carom_scene::{Form, RollKind};
/// let roll = Form::Roll(RollKind::Cylinder);
/// assert_eq!(roll.problems("radios = 1")[0].path, "radios");
/// assert!(roll.problems("radius = 1\nstep_height = 2").is_empty(), "a step of any height is a length");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A scene.
    Scene,
    /// An impact, or contacts under forces.
    Impact,
    /// A body that rolls in the plane.
    Roll(RollKind),
    /// A body that rolls or is thrown in space.
    SpatialRoll(SpatialRollKind),
}

impl Form {
    /// Every kind of file.
    pub const ALL: [Self; 8] = [
        Self::Scene,
        Self::Impact,
        Self::Roll(RollKind::Cylinder),
        Self::Roll(RollKind::Prism),
        Self::Roll(RollKind::Rod),
        Self::SpatialRoll(SpatialRollKind::Pyramid),
        Self::SpatialRoll(SpatialRollKind::Stool),
        Self::SpatialRoll(SpatialRollKind::Body),
    ];

    pub(crate) fn file(self) -> &'static File {
        match self {
            Self::Scene => &SCENE,
            Self::Impact => &IMPACT,
            Self::Roll(kind) => roll::grammar_of(kind),
            Self::SpatialRoll(kind) => roll::spatial::grammar_of(kind),
        }
    }

    /// What a key means, or which words it may be, for a comment beside its value; plates and walls stand in the path without their
    /// names. `None` where no such file has the key.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Form;
    /// assert_eq!(Form::Scene.comment("start.speed").as_deref(), Some("Speed down the plate at the start"));
    /// assert_eq!(Form::Scene.comment("plate.wall").as_deref(), Some("left | right"));
    /// ```
    pub fn comment(self, path: &str) -> Option<String> {
        self.file().variants.iter().rev().find_map(|(_, table)| comment_of(table, path))
    }

    /// What is wrong with the TOML text of a file by itself: its syntax, its form, its single values. A reader tells the same, and
    /// besides what the values mean together: names, places, what crosses what.
    pub fn problems(self, source: &str) -> Vec<Problem> {
        let (tree, syntax) = from_toml(source);
        if !syntax.is_empty() {
            return syntax;
        }
        let sink = match self {
            Self::Scene => Sink::with_longest_plain(LONGEST_PLAIN),
            Self::Impact | Self::Roll(_) | Self::SpatialRoll(_) => Sink::default(),
        };
        check(self.file(), &tree, &sink);
        sink.into_list()
    }
}
