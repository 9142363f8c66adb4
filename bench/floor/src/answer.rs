//! What a drop is, and what the floor says of it.

/// The part of the feeder paper: a thin rod of 0.1 m, 0.3 kg and 2.5e-4 kg m².
pub const HALF_LENGTH: f64 = 0.05;
/// m ℓ²/J of that rod, ℓ half its length.
pub const KAPPA: f64 = 3.0;
/// Gravity [m/s²].
pub const GRAVITY: f64 = 9.81;

/// One two-plate drop: the rod starts at rest, flat on the upper plate; nothing restitutes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Design {
    /// Slope of the upper plate, which descends to the right [rad].
    pub upper_slope: f64,
    /// Slope of the lower plate, which descends to the left [rad].
    pub lower_slope: f64,
    /// b: from the upper plate's free edge, square to that plate, to the lower plate [m].
    pub line_b: f64,
    /// From the mass centre to the upper plate's free edge, along the plate [m].
    pub to_edge: f64,
    /// Friction of both plates.
    pub friction: f64,
}

/// How the rod landed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landing {
    /// True where the face that was down at the start is up.
    pub turned: bool,
    /// First touch of the lower plate [s].
    pub first_touch: f64,
    /// Speed of the end that touches first [m/s].
    pub impact_speed: f64,
    /// When it lies flat [s].
    pub flat: f64,
}

/// Why a drop is not one of those that are programmed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Uncovered {
    /// Something vanishes where a sign is asked for.
    Tie,
    /// A quantity grazes zero.
    Grazes,
    /// The front touches the lower plate before the rod has left the edge, or may.
    TouchesWhileTipping,
    /// The rod may meet the upper plate again.
    UpperPlate,
    /// Friction jams the contact (Painlevé).
    Jams,
    /// More steps or strikes than a drop has.
    TooLong,
}

/// What the floor says of a drop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Answer {
    /// It lands on the lower plate.
    Lands(Landing),
    /// Friction holds it on the upper plate.
    Stuck,
    /// Not covered, and why.
    NotCovered(Uncovered),
}

/// A drop made ready: in units of half the rod's length, gravity and the mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prepared {
    /// Sine and cosine of the upper slope.
    pub(crate) upper: (f64, f64),
    /// Sine and cosine of the lower slope.
    pub(crate) lower: (f64, f64),
    /// Height of the edge above the lower plate.
    pub(crate) edge_height: f64,
    pub(crate) to_edge: f64,
    pub(crate) friction: f64,
}

impl Design {
    /// Makes the drop ready.
    pub fn prepare(&self) -> Prepared {
        use carom_num::elementary::{cos, sin_cos};
        Prepared {
            upper: sin_cos(self.upper_slope),
            lower: sin_cos(self.lower_slope),
            edge_height: self.line_b * cos(self.upper_slope + self.lower_slope) / HALF_LENGTH,
            to_edge: self.to_edge / HALF_LENGTH,
            friction: self.friction,
        }
    }
}
