//! What the author of a scene drew and wrote, and a feeder does not know.

use carom_num::Vec2;

/// Which way a measure is taken.
///
/// # Example
/// From (0, 0) to (3, 4) it is 3 level, 4 plumb, and 5 along.
/// ```
/// use {carom_figure::Axis, carom_num::Vec2};
/// let lengths = [Axis::Level, Axis::Plumb, Axis::Along].map(|axis| axis.length(Vec2::ZERO, Vec2::new(3.0, 4.0)));
/// assert_eq!(lengths, [3.0, 4.0, 5.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Across, level.
    Level,
    /// Up and down, plumb.
    Plumb,
    /// From point to point.
    Along,
    /// Below the horizontal, an angle.
    Slope,
    /// Of an arc: from its centre to a point of it.
    Radius,
}

impl Axis {
    /// The length between two points that is measured this way \[m\]; of a slope the length along.
    ///
    /// # Example
    /// ```
    /// use {carom_figure::Axis, carom_num::Vec2};
    /// assert_eq!(Axis::Plumb.length(Vec2::new(1.0, 0.5), Vec2::new(9.0, -0.25)), 0.75);
    /// ```
    pub fn length(self, from: Vec2, to: Vec2) -> f64 {
        let across = to - from;
        match self {
            Self::Level => across.x.abs(),
            Self::Plumb => across.y.abs(),
            Self::Along | Self::Slope | Self::Radius => across.norm(),
        }
    }
}

/// A measure that a scene writes, between two points of the layout.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// The plate that it places, counted from 0; `None` for what places none, such as the width of the channel.
    pub plate: Option<usize>,
    /// Its key: `drop`, `gap`, `slope`.
    pub name: String,
    /// Its value with unit and tolerance, as written.
    pub text: String,
    /// Which way it is taken.
    pub axis: Axis,
    /// Where it begins [m].
    pub from: Vec2,
    /// Where it ends [m].
    pub to: Vec2,
}

/// What the author of a scene drew and wrote, beyond what a feeder is made of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    /// The part as its file draws it, about its mass centre in its own axes \[m\]: closed loops, the outline first, then its holes.
    /// Empty where the part's shape is all that is drawn.
    pub outline: Vec<Vec<Vec2>>,
    /// What the scene writes.
    pub measures: Vec<Measure>,
}

impl Draft {
    /// The measure of a plate with this name, where one is written.
    pub(crate) fn of_plate(&self, plate: usize, name: &str) -> Option<&Measure> {
        self.measures.iter().find(|measure| measure.plate == Some(plate) && measure.name == name)
    }
}
