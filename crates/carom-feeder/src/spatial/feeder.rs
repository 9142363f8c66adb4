//! What stands on a feeder's drawing, and how wide it is.

use super::part::Part;
use crate::feeder::{Stop, crossing};
use carom_impact::Law;
use carom_num::{Vec2, Vec3};

/// What a plate is like across its line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum CrossSection {
    /// Flat, its sides open.
    #[default]
    Flat,
    /// Flat, with walls along both sides, square to it.
    Walled {
        /// How high they are [m].
        height: f64,
    },
    /// Two flanks of a V groove, whose bottom is the line.
    Groove {
        /// The angle between them [rad].
        angle: f64,
    },
}

impl CrossSection {
    /// True of a V groove.
    pub fn is_groove(self) -> bool {
        matches!(self, Self::Groove { .. })
    }
}

/// A plate, thin, with the same ends as in the drawing: flat, or two flanks of a V groove along the line between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Plate {
    /// Its name.
    pub name: String,
    /// Uphill end, in the drawing [m].
    pub uphill: Vec2,
    /// Free edge, the downhill end [m].
    pub edge: Vec2,
    /// Its width across the drawing, half of it to either side [m]; of a groove how wide it opens. `None` where it is as wide as needed.
    pub width: Option<f64>,
    /// How far it is turned about the line from its uphill end to its free edge, clockwise as seen down that line where it leads to the right [rad]: a positive one lowers the side
    /// that is towards whoever looks at the drawing.
    pub roll: f64,
    /// What it is like across.
    pub cross_section: CrossSection,
    /// Radius of its edges [m]: it is then a sheet twice as thick below its upper side, its ends half round, and its sides where no walls stand along them. Thin and sharp at 0.
    pub edge_radius: f64,
    /// Friction against the part.
    pub friction: f64,
    /// Restitution against the part.
    pub restitution: f64,
    /// True where the drawing gives the plate no length and it is as long as needed: pictures may cut it.
    pub unbounded: bool,
}

/// What a wall is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WallForm {
    /// A line of the drawing from one end to the other [m], as wide as needed.
    Across {
        /// One end.
        from: Vec2,
        /// The other end.
        to: Vec2,
        /// Radius of its edges [m]: it is then a sheet twice as thick about that line, its ends half round. Thin and sharp at 0.
        edge_radius: f64,
    },
    /// A round bar: all places within a radius of the line between two ends [m].
    Pin {
        /// Its ends.
        ends: [Vec3; 2],
        /// Its radius [m].
        radius: f64,
    },
    /// A plane without ends beside the drawing, parallel to it: at this z [m], touched from the side of the drawing. Two of them make a groove.
    Beside {
        /// Where it is.
        z: f64,
    },
}

/// Another obstacle.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Its name.
    pub name: String,
    /// Where it is.
    pub form: WallForm,
    /// Friction against the part.
    pub friction: f64,
    /// Restitution against the part.
    pub restitution: f64,
}

/// How the part starts: lying flat on the first plate; in a groove on the flank behind, and against the other one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// From the mass centre to the first plate's free edge, along the plate [m].
    pub to_edge: f64,
    /// From the middle of the plate to the mass centre, across it: towards whoever looks at the drawing [m]. 0 in a groove, where both flanks say where it is.
    pub aside: f64,
    /// How far the part is turned on the plate, or on its flank, counter-clockwise as seen from above it [rad]. At 0 the body's axes are those of the drawing, but for the least turn that lays
    /// the face down (about z where it is half a turn), and the slope of the plate.
    pub turn: f64,
    /// Speed down the plate [m/s].
    pub speed: f64,
    /// The face that is down.
    pub face: usize,
}

/// A feeder in space.
#[derive(Clone, Debug, PartialEq)]
pub struct Feeder {
    /// Gravity, downwards [m/s²].
    pub gravity: f64,
    /// When a run stops.
    pub stop: Stop,
    /// Restitution law.
    pub law: Law,
    /// The part.
    pub part: Part,
    /// How it starts.
    pub start: Start,
    /// The plates, in the order the part meets them.
    pub plates: Vec<Plate>,
    /// Other obstacles.
    pub walls: Vec<Wall>,
}

impl Feeder {
    /// Pairs of plates whose middle lines cross in the drawing, by their numbers: such a feeder can be run, but not built. Plates that only touch do not cross, and plates as
    /// long as needed do not count. Side walls are not looked at.
    pub fn crossing_plates(&self) -> Vec<(usize, usize)> {
        let drawn = |plate: &Plate| if plate.unbounded { vec![] } else { vec![(plate.uphill, plate.edge)] };
        crossing(&self.plates.iter().map(drawn).collect::<Vec<_>>())
    }
}
