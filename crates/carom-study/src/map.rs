//! Outcome maps: how a drop ends, over two quantities of a feeder.
//!
//! A map is the [region diagram](crate::regions) of a drop's [`Ending`]: the boundaries between outcomes are located by bisection of whole
//! runs, not drawn through a raster. What every node of the grid measures is kept beside it.

use crate::ending::{Dropped, Ending};
use crate::regions::{self, Options, Range, Regions, RegionsError};
use carom_feeder::Feeder;
use carom_motion::planar;
use rayon::prelude::*;

/// What one node of a map's grid measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Abscissa, in units of its axis.
    pub x: f64,
    /// Ordinate, in units of its axis.
    pub y: f64,
    /// How the drop ends on the plate.
    pub ending: Ending,
    /// Speed of the striking point when it first strikes the plate [m/s]; `None` where it does not lie there in the end.
    pub impact_speed: Option<f64>,
    /// When it first lies flat on the plate [s].
    pub flat: Option<f64>,
    /// The smallest decided inequality of the run, scaled; `None` where nothing was decided.
    pub margin: Option<f64>,
}

/// An outcome map.
///
/// # Example
/// A rod on a slope of 3 in 4: the border lies at a friction of 3/4, however long the way, and cuts off a
/// quarter of the map. Within `4/(8·600²)` of 3/4 a rod takes longer than the 600 s for which it is followed.
/// ```
/// use carom_feeder::{Outcome, examples};
/// use carom_study::regions::{Options, Range};
/// use carom_study::{Ending, map};
/// let slope = examples::rod_on_a_slope;
/// let friction = Range { from: 0.6, to: 1.2, count: 3 };
/// let reach = Range { from: 1.0, to: 2.0, count: 1 };
/// let found = map::draw(friction, reach, &Options::default(), 0, |friction, _| Some(slope(friction)))?;
/// assert!(found.regions.boundaries[0].points.iter().all(|[x, _]| (x - 0.75).abs() < 2e-6));
/// let delivered = Ending::Otherwise(Outcome::Delivered);
/// let share = found.regions.shares.iter().find(|share| share.label == delivered).unwrap();
/// assert!((share.area - 0.25).abs() < 1e-5);
/// assert_eq!(found.nodes.len(), 4 * 2);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    /// Regions of equal endings and the boundaries between them.
    pub regions: Regions<Ending>,
    /// The nodes of the grid, row by row from the lowest ordinate up.
    pub nodes: Vec<Node>,
    /// How many drops were followed.
    pub drops: usize,
}

/// Draws a map: `feeder` gives the feeder at a point of the plane, `None` where what is drawn cannot be; `plate` is the number of the
/// plate that is looked at.
///
/// # Guarantees, limits
/// As [`regions::find`]. The result does not depend on the number of threads.
///
/// # Errors
/// [`RegionsError`]: a range, a number of cells, an accuracy or a depth outside what is allowed.
///
/// # Example
/// A rod that slides towards an edge: friction of tan 15° holds it.
/// ```
/// use carom_feeder::{Feeder, Outcome, Part, Plate, Start, Stop};
/// use carom_impact::planar::Law;
/// use carom_num::Vec2;
/// use carom_study::regions::{Options, Range};
/// use carom_study::{Ending, map};
/// let slide = |friction: f64, reach: f64| {
///     let downhill = Vec2::new(15_f64.to_radians().cos(), -15_f64.to_radians().sin());
///     let plate = Plate { name: "upper".into(), uphill: -downhill, edge: Vec2::ZERO, friction, restitution: 0.0, unbounded: false, form: Default::default() };
///     Some(Feeder {
///         gravity: 9.81,
///         stop: Stop::Landed,
///         law: Law::Poisson,
///         part: Part::rod(0.1, 0.3, 2.5e-4)?,
///         start: Start { to_edge: reach, speed: 0.0, face: 0 },
///         plates: vec![plate],
///         walls: vec![],
///     })
/// };
/// let friction = Range { from: 0.1, to: 0.4, count: 4 };
/// let reach = Range { from: 0.1, to: 0.3, count: 4 };
/// let found = map::draw(friction, reach, &Options::default(), 0, slide)?;
/// let border = &found.regions.boundaries[0];
/// assert!(border.points.iter().all(|[f, _]| (f - 15_f64.to_radians().tan()).abs() < 1e-9));
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
pub fn draw(
    x: Range,
    y: Range,
    options: &Options,
    plate: usize,
    feeder: impl Fn(f64, f64) -> Option<Feeder> + Sync,
) -> Result<Map, RegionsError> {
    drawn([x, y], options, plate, &feeder)
}

fn drawn(
    [x, y]: [Range; 2],
    options: &Options,
    plate: usize,
    feeder: &(dyn Fn(f64, f64) -> Option<Feeder> + Sync),
) -> Result<Map, RegionsError> {
    regions::check(x, y, options)?;
    let drop = |x: f64, y: f64| Dropped::of(feeder(x, y).as_ref(), plate, &planar::Options::default());
    let places: Vec<[f64; 2]> = regions::nodes([x, y]).collect();
    let nodes: Vec<Node> = places
        .par_iter()
        .map(|&[x, y]| {
            let dropped = drop(x, y);
            Node {
                x,
                y,
                ending: dropped.ending,
                impact_speed: dropped.impact_speed(plate),
                flat: dropped.flat(plate),
                margin: dropped.margin(),
            }
        })
        .collect();
    let known = nodes.iter().map(|node| node.ending).collect();
    let regions = regions::find_between([x, y], options, known, &|x, y| drop(x, y).ending)?;
    let drops = nodes.len() + regions.evaluations;
    Ok(Map { regions, nodes, drops })
}
