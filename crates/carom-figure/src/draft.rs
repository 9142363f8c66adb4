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
            Self::Along | Self::Slope => across.norm(),
        }
    }
}

/// A measure that a scene writes, between two points of the layout.
///
/// # Example
/// It stands in the drawing as it was written.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::{Axis, Draft, Measure, layout_svg};
/// let length = Measure {
///     plate: Some(0), name: "length".to_owned(), text: "1000 ± 2 mm".to_owned(),
///     axis: Axis::Along, from: uphill, to: edge,
/// };
/// let draft = Draft { measures: vec![length], ..Draft::default() };
/// assert!(layout_svg(&feeder, None, &draft).contains("length 1000 ± 2 mm"));
/// ```
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
///
/// # Example
/// A washer's outline has a hole: two closed loops. They are drawn instead of its shape.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (law, stop) = (Law::Poisson, Stop::Landed);
/// # let part = Part::rectangle(0.1, 0.1, 0.3, 2.5e-4).unwrap();
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use carom_figure::{Draft, layout_svg};
/// let square = |a: f64| [(a, a), (-a, a), (-a, -a), (a, -a)].map(|(x, y)| Vec2::new(x, y)).to_vec();
/// let draft = Draft { outline: vec![square(0.05), square(0.02)], ..Draft::default() };
/// let svg = layout_svg(&feeder, None, &draft);
/// assert!(svg.contains("class=\"hull\""), "what touches, beside what is drawn");
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    /// The part as its file draws it, about its mass centre in its own axes \[m\]: closed loops, the outline first, then its holes.
    /// Empty where the part's shape is all that is drawn.
    pub outline: Vec<Vec<Vec2>>,
    /// Faces of the part's shape that are no sides of the outline: lines across hollows.
    pub bridges: Vec<usize>,
    /// What the scene writes.
    pub measures: Vec<Measure>,
}

impl Draft {
    /// The measure of a plate with this name, where one is written.
    pub(crate) fn of_plate(&self, plate: usize, name: &str) -> Option<&Measure> {
        self.measures.iter().find(|measure| measure.plate == Some(plate) && measure.name == name)
    }
}
