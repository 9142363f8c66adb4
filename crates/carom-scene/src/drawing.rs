//! What a scene says, quantity by quantity, before it is laid out.

use crate::chain::ChainDrawing;
use crate::contact_table::NamedContact;
pub(crate) use crate::part_drawing::{MassCentre, MassSpec, Outline, PartDrawing, ShapeWord};
use crate::quantity::Quantity;
use carom_feeder::Stop;
use carom_impact::Law;
use carom_study::design::{Aim, Limits};
use carom_words::Words;
use std::ops::Range;

/// A side: of the channel, or the way downhill.
///
/// # Example
/// ```
/// use carom_scene::Side;
/// assert_eq!((Side::Left.sign(), Side::Left.other().sign()), (-1.0, 1.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Towards −x.
    Left,
    /// Towards +x.
    Right,
}

impl Side {
    /// The other side.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Side;
    /// assert_eq!((Side::Left.other(), Side::Left.other().other()), (Side::Right, Side::Left));
    /// ```
    pub fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// −1 for left, +1 for right.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Side;
    /// assert_eq!(Side::Left.sign() + Side::Right.sign(), 0.0);
    /// assert!(Side::Right.sign() > 0.0);
    /// ```
    pub fn sign(self) -> f64 {
        match self {
            Self::Left => -1.0,
            Self::Right => 1.0,
        }
    }

    /// `left` or `right`.
    ///
    /// # Example
    /// ```
    /// use carom_scene::Side;
    /// assert_eq!([Side::Left, Side::Right].map(Side::word), ["left", "right"]);
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// What a designer wants on a plate.
///
/// # Example
/// On the upper plate nothing is wanted, on the lower one the part is to be turned.
/// ```
/// use carom_scene::*;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// assert_eq!(scene.wants(), [None, Some(Want::Turned)]);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Want {
    /// The face that was down at the start.
    Same,
    /// The opposite face.
    Turned,
    /// Whatever.
    Any,
    /// This face.
    Face(usize),
}

carom_words::words! {
    Side {
        Left = "left",
        Right = "right",
    }
}

impl Words for Want {
    const ALL: &'static [Self] = &[Self::Same, Self::Turned, Self::Any];

    fn word(self) -> &'static str {
        match self {
            Self::Same => "same",
            Self::Turned => "turned",
            Self::Any => "any",
            // A face is written as its number.
            Self::Face(_) => "face",
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ContactDrawing {
    pub(crate) friction: Option<Quantity>,
    /// The file has a friction, be it a good one or not.
    pub(crate) friction_written: bool,
    pub(crate) restitution: Quantity,
    pub(crate) law: Law,
    /// Where friction and restitution are those of two materials.
    pub(crate) named: Option<&'static NamedContact>,
}

/// On which face the part starts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum StartFaces {
    One(usize),
    /// One of these, each with its weight.
    Mixed(Vec<(usize, f64)>),
    /// One on which it can rest.
    Resting,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StartDrawing {
    pub(crate) to_edge: Quantity,
    pub(crate) speed: Quantity,
    pub(crate) faces: StartFaces,
    pub(crate) face_span: Option<Range<usize>>,
    /// Of a part in space: its turn on the plate, and how far it is from the middle.
    pub(crate) turn: Option<Quantity>,
    pub(crate) aside: Option<Quantity>,
}

/// Friction and restitution where they are a plate's own.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Surface {
    pub(crate) friction: Option<Quantity>,
    pub(crate) restitution: Option<Quantity>,
    /// Where they are those of two materials.
    pub(crate) named: Option<&'static NamedContact>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ChannelDrawing {
    pub(crate) width: Quantity,
    pub(crate) surface: Surface,
}

/// How high a hinge is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Level {
    Height(Quantity),
    Drop(Quantity),
}

/// How far a hinged plate reaches.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Reach {
    Gap(Quantity),
    Length(Quantity),
}

impl Place {
    /// Measured from the plate before it.
    pub(crate) fn is_relative(&self) -> bool {
        match self {
            Self::Origin { .. } | Self::Ends { .. } | Self::Chain { .. } => false,
            Self::Hinged { level, .. } => matches!(level, Level::Drop(_)),
            Self::Line { .. } | Self::Through { .. } => true,
            // The side that it slopes to may be.
            Self::Edge { downhill, .. } => downhill.is_none(),
        }
    }
}

/// The ways to place a plate.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Place {
    /// The first plate, its free edge at the origin; without a length as long as needed.
    Origin { slope: Quantity, length: Option<Quantity>, downhill: Side },
    /// Hinged at a wall, sloping away from it.
    Hinged { wall: Side, level: Level, slope: Quantity, reach: Reach },
    /// x/along + y/normal = 1 in the previous plate's axes; as long as needed.
    Line { along: Quantity, normal: Quantity, downhill: Option<Side> },
    /// A slope and a point of its line, from the previous plate's free edge; as long as needed.
    Through { slope: Quantity, below: [Quantity; 2], downhill: Option<Side> },
    /// Its free edge.
    Edge { edge: [Quantity; 2], slope: Quantity, length: Quantity, downhill: Option<Side> },
    /// Uphill end and free edge.
    Ends { from: [Quantity; 2], to: [Quantity; 2] },
    /// Its course, which may be bent.
    Chain { chain: ChainDrawing },
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PlateDrawing {
    pub(crate) name: String,
    pub(crate) place: Place,
    pub(crate) edge_radius: Option<Quantity>,
    /// In space.
    pub(crate) width: Option<Quantity>,
    pub(crate) roll: Option<Quantity>,
    pub(crate) side_walls: Option<Quantity>,
    pub(crate) v_angle: Option<Quantity>,
    pub(crate) surface: Surface,
    pub(crate) want: Option<Want>,
    pub(crate) span: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ZigzagDrawing {
    pub(crate) plates: Quantity,
    pub(crate) drop: Quantity,
    pub(crate) slope: Quantity,
    pub(crate) gap: Quantity,
    pub(crate) height: Quantity,
    pub(crate) wall: Side,
    pub(crate) surface: Surface,
    pub(crate) want: Option<Want>,
    pub(crate) span: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WallDrawing {
    pub(crate) name: String,
    pub(crate) course: WallCourse,
    pub(crate) edge_radius: Option<Quantity>,
    pub(crate) surface: Surface,
    pub(crate) span: Range<usize>,
}

/// A round bar in space.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PinDrawing {
    pub(crate) name: String,
    pub(crate) ends: [[Quantity; 3]; 2],
    pub(crate) radius: Quantity,
    pub(crate) surface: Surface,
}

/// How a wall runs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum WallCourse {
    Ends { from: [Quantity; 2], to: [Quantity; 2] },
    Chain { chain: ChainDrawing },
}

/// Several parts, one after another.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FeedDrawing {
    /// How many.
    pub(crate) parts: Quantity,
    /// Time between them [s].
    pub(crate) interval: Quantity,
    /// Between the parts.
    pub(crate) surface: Surface,
    pub(crate) span: Range<usize>,
}

/// A quantity that a design may choose.
///
/// # Example
/// The slope may be 10° to 40°.
/// ```
/// use carom_scene::*;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let Free { path, low, high } = &scene.design().unwrap().free[0];
/// assert_eq!((path.as_str(), *low, *high), ("plate.lower.slope", 10_f64.to_radians(), 40_f64.to_radians()));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Free {
    /// Its path.
    pub path: String,
    /// Lowest value, SI.
    pub low: f64,
    /// Highest value, SI.
    pub high: f64,
}

/// What a design may choose, must keep and aims at.
///
/// # Example
/// No strike may be harder than 3 m/s; nothing is said of the height.
/// ```
/// use carom_scene::*;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let design = scene.design().unwrap();
/// assert_eq!(design.max_impact_speed.as_ref().map(|limit| limit.value), Some(3.0));
/// assert_eq!((design.max_height.is_none(), design.aim), (true, Aim::Yield));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Design {
    /// The free quantities, in the order of the file.
    pub free: Vec<Free>,
    /// Highest approach speed of an impact [m/s].
    pub max_impact_speed: Option<Quantity>,
    /// Highest slip [m/s].
    pub max_sliding_speed: Option<Quantity>,
    /// Highest feeder [m].
    pub max_height: Option<Quantity>,
    /// Widest feeder [m].
    pub max_width: Option<Quantity>,
    /// Longest time [s].
    pub max_time: Option<Quantity>,
    /// True where the part may touch no wall.
    pub forbid_walls: bool,
    /// What to be best at.
    pub aim: Aim,
}

impl Design {
    /// What must be kept, SI.
    pub fn limits(&self) -> Limits {
        let value = |quantity: &Option<Quantity>| quantity.as_ref().map(|quantity| quantity.value);
        Limits {
            impact_speed: value(&self.max_impact_speed),
            sliding_speed: value(&self.max_sliding_speed),
            height: value(&self.max_height),
            width: value(&self.max_width),
            time: value(&self.max_time),
            no_wall: self.forbid_walls,
        }
    }
}

/// Everything a scene says.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Drawing {
    pub(crate) gravity: Quantity,
    pub(crate) stop: Stop,
    pub(crate) part: PartDrawing,
    pub(crate) contact: ContactDrawing,
    pub(crate) start: StartDrawing,
    pub(crate) channel: Option<ChannelDrawing>,
    /// Walls beside the drawing, in space.
    pub(crate) groove: Option<ChannelDrawing>,
    pub(crate) plates: Vec<PlateDrawing>,
    pub(crate) zigzag: Option<ZigzagDrawing>,
    pub(crate) walls: Vec<WallDrawing>,
    pub(crate) pins: Vec<PinDrawing>,
    pub(crate) feed: Option<FeedDrawing>,
    pub(crate) design: Option<Design>,
}
