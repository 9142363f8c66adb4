//! What the page asks.

use crate::reply::Failure;
use carom_figure::View;
use carom_num::Vec2;
use carom_scene::{Grip, Hold};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A request: a scene, the files beside it, and what is asked of them.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Request {
    /// The scene's file name.
    pub name: String,
    /// The scene.
    pub text: String,
    /// The files that it may name, as text; an STL file, which may be none, with one letter for each byte.
    #[serde(default)]
    pub files: BTreeMap<String, String>,
    /// What is asked.
    pub ask: Ask,
}

/// What may be asked.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Ask {
    /// Change the scene or the impact, run or resolve it, and show everything.
    Show {
        /// What changes; nothing where it is only looked at.
        #[serde(default)]
        change: Option<Change>,
        /// Where the picture is.
        frame: Frame,
    },
    /// What else there is to know of the scene as it stands.
    Study(Study),
    /// One worker's portion of long work.
    Portion {
        /// The work.
        study: Shared,
        /// Which round of it, from 0: what a round asks may follow from the one before.
        round: usize,
        /// Which portion, from 0.
        number: u32,
        /// Of how many.
        of: u32,
    },
    /// What all portions say together, or that one more round is needed.
    Joined {
        /// The work.
        study: Shared,
        /// The answers of all portions, round by round.
        known: Vec<Vec<String>>,
    },
}

/// Long work that several workers share.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Shared {
    /// How surely it ends as wanted under its tolerances.
    Yield {
        /// Drops at least.
        samples: u64,
        /// Of the random points.
        seed: u64,
    },
    /// How it ends over two of its quantities.
    Map {
        /// Abscissa and ordinate.
        axes: [Side; 2],
        /// Cells of each.
        cells: usize,
        /// How often a cell is halved at most.
        depth: u32,
        /// Accuracy of the boundaries, as a share of the axes.
        accuracy: f64,
    },
}

/// A change of a scene, or of an impact.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Change {
    /// Drag a grip from where it was seen in this text to a place.
    Drag {
        /// What is dragged: an earlier answer's.
        grip: Held,
        /// Where to [m].
        to: [f64; 2],
        /// Lengths snap to multiples of this [m], angles of the second [rad].
        snap: [f64; 2],
    },
    /// Write a value in place of another, as a person types it.
    Write {
        /// Path of the quantity.
        path: String,
        /// What is written: `25 ± 0.5 deg`.
        value: String,
    },
    /// Write these values.
    Move {
        /// Quantities by their paths, SI.
        values: BTreeMap<String, f64>,
    },
    /// Draw one more plate or wall.
    Add {
        /// `plate` or `wall`.
        table: Table,
        /// One end [m].
        from: [f64; 2],
        /// The other.
        to: [f64; 2],
        /// Ends snap to multiples of this [m].
        snap: f64,
    },
    /// Take a plate or wall away.
    Remove {
        /// Its number among plates and walls.
        obstacle: usize,
    },
    /// What is wanted on a plate.
    Want {
        /// Its number.
        plate: usize,
        /// `same`, `turned`, `any` or a face's number; empty where nothing is.
        want: String,
    },
    /// Pull a point or an arrow of an impact to where the pointer is.
    Pull {
        /// What is pulled: an earlier answer's.
        pulled: Pulled,
        /// Where to, in pixels of the window.
        at: [f64; 2],
        /// In small steps.
        fine: bool,
    },
    /// One more contact of the body that is struck.
    AddContact {
        /// Where, in pixels of the window.
        at: [f64; 2],
    },
    /// Take a contact away.
    RemoveContact {
        /// Its number.
        contact: usize,
    },
    /// Other keys in a table, as TOML.
    Replace {
        /// Its name: `part`, `design`.
        table: String,
        /// Its keys.
        lines: String,
    },
}

/// Where a picture is: a window that there is already, or a new one around all of the motion.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Frame {
    /// Around the motion: width and height in pixels.
    Size([f64; 2]),
    /// That is there.
    Window(Window),
}

/// What may be asked of a scene as it stands.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Study {
    /// One strike in full.
    Strike {
        /// Its number from 0.
        number: usize,
    },
    /// How far one quantity may move alone before the verdict flips.
    Limit {
        /// Path of the quantity.
        path: String,
    },
    /// How it would end with these values; nothing else.
    At {
        /// Quantities by their paths, SI.
        values: BTreeMap<String, f64>,
    },
    /// Which layout makes drops end as wanted.
    Design {
        /// Layouts of the first look.
        scan: u64,
        /// Drops that confirm the winner.
        samples: u64,
        /// What every random number comes from.
        seed: u64,
    },
    /// The files that `carom run` writes, or of an impact `carom impact`.
    Files,
    /// The drawings that `carom draw` writes.
    Drawings,
    /// Run it so many times for the verdict alone: how fast the page is.
    Race {
        /// Runs.
        runs: u32,
    },
}

/// What can be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Table {
    /// A plate.
    Plate,
    /// A wall.
    Wall,
}

/// An axis of a map.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Side {
    /// Path of its quantity.
    pub path: String,
    /// Its ends, SI.
    pub from: f64,
    /// The greater one.
    pub to: f64,
}

/// What is held of a plate or wall, or the part where no obstacle is given. The page gives back what it was given.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Held {
    /// Number among plates and walls.
    pub obstacle: Option<usize>,
    /// `first`, `middle` or `last`.
    pub hold: Hold,
    /// The point that the pointer takes along [m].
    pub at: [f64; 2],
    /// Where its ends were seen [m].
    pub ends: [[f64; 2]; 2],
    /// Which of them are none: the plate goes on there.
    pub cut: [bool; 2],
}

impl Held {
    pub(crate) fn grip(&self) -> Grip {
        match self.obstacle {
            None => Grip::Part,
            Some(index) => Grip::Obstacle {
                index,
                ends: self.ends.map(point),
                cut: self.cut,
                hold: self.hold,
                at: point(self.at),
            },
        }
    }
}

/// What is pulled of an impact. The page gives back what it was given.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pulled {
    /// The table of the file: `contact.0`.
    pub table: String,
    /// Its key.
    pub key: PulledKey,
    /// Where it starts from, in the world [m]: the point that a normal stands on, the mass centre that a velocity is of.
    pub from: [f64; 2],
}

/// What can be pulled.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PulledKey {
    /// A contact's point.
    Point,
    /// A contact's normal.
    Normal,
    /// A body's mass centre.
    Centre,
    /// A body's velocity.
    Velocity,
}

/// The window of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Window {
    /// Lower left corner [m].
    pub low: [f64; 2],
    /// Pixels in a metre.
    pub scale: f64,
    /// Width and height in pixels.
    pub size: [f64; 2],
    /// Of an impact: pixels of an arrow for 1 m/s.
    #[serde(default)]
    pub speed: f64,
}

impl Window {
    pub(crate) fn of(view: &View) -> Self {
        let size = (view.high - view.low) * view.scale;
        Self { low: [view.low.x, view.low.y], scale: view.scale, size: [size.x, size.y], speed: 0.0 }
    }

    pub(crate) fn view(&self) -> Result<View, Failure> {
        let low = point(self.low);
        let high = low + point(self.size) * (1.0 / self.scale);
        if low.is_finite() && high.is_finite() && self.scale > 0.0 && high.x > low.x && high.y > low.y {
            Ok(View { low, high, scale: self.scale })
        } else {
            Err(Failure::of_page("the window has no size"))
        }
    }
}

pub(crate) fn point([x, y]: [f64; 2]) -> Vec2 {
    Vec2::new(x, y)
}
