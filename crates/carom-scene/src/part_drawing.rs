//! What a scene says of its part, before it is built.

use crate::chain::ChainDrawing;
use crate::library::LibraryPart;
use crate::outline::FileOutline;
use crate::quantity::Quantity;
use crate::roll::spatial::ThrownShape;
use carom_num::{Mat3, Vec3};
use std::ops::Range;

/// What a part looks like from the side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ShapeWord {
    Rod,
    Box,
    Polygon,
    Chain,
    Disc,
    Outline,
    Bolt,
    Washer,
    Pin,
    Cap,
    Bracket,
    Revolved,
}

impl ShapeWord {
    /// True of bodies of revolution, which have no depth.
    pub(crate) fn is_revolved(self) -> bool {
        matches!(self, Self::Bolt | Self::Washer | Self::Pin | Self::Cap | Self::Revolved)
    }
}

carom_words::words! {
    ShapeWord {
        Rod = "rod",
        Box = "box",
        Polygon = "polygon",
        Chain = "chain",
        Disc = "disc",
        Outline = "outline",
        Bolt = "bolt",
        Washer = "washer",
        Pin = "pin",
        Cap = "cap",
        Bracket = "bracket",
        Revolved = "revolved",
    }
}

/// The shape of a part in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum SolidWord {
    Solid,
}

carom_words::words! {
    SolidWord {
        Solid = "solid",
    }
}

/// A solid, in the axes of its drawing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SolidDrawing {
    pub(crate) shape: ThrownShape,
    /// Of a part that is not uniform: mass centre \[m\] and inertia about it [kg m²].
    pub(crate) centre: Option<Vec3>,
    pub(crate) inertia: Option<Mat3>,
}

/// The outline of the part.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Outline {
    Rod { length: Quantity },
    Box { length: Quantity, height: Quantity },
    Polygon { vertices: Vec<[Quantity; 2]> },
    Chain { chain: ChainDrawing },
    Disc { radius: Quantity },
    File { drawn: FileOutline, scale: Quantity },
    Library(Box<LibraryPart>),
    Solid(Box<SolidDrawing>),
}

/// Mass, or what it follows from.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum MassSpec {
    Mass(Quantity),
    /// A body of revolution needs no depth.
    Density {
        density: Quantity,
        depth: Option<Quantity>,
    },
}

/// Where the mass centre is, in the coordinates of the drawing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MassCentre {
    pub(crate) at: [Quantity; 2],
    pub(crate) span: Range<usize>,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PartDrawing {
    pub(crate) outline: Outline,
    /// Of a part that is not uniform.
    pub(crate) mass_centre: Option<MassCentre>,
    pub(crate) corner_radius: Option<Quantity>,
    pub(crate) mass: MassSpec,
    pub(crate) inertia: Option<Quantity>,
    pub(crate) span: Range<usize>,
}
