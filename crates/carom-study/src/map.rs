//! Outcome maps: how a drop ends, over two quantities of a feeder.
//!
//! A map is the [region diagram](crate::regions) of a drop's [`Ending`]: the boundaries between outcomes are located by bisection of whole
//! runs, not drawn through a raster. What every node of the grid measures is kept beside it.

use crate::device::Device;
use crate::ending::{Dropped, Ending};
use crate::packed::{Packed, packed};
use crate::regions::{self, Cells, Options, Range, Regions, RegionsError, raster};
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

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
/// use carom_impact::Law;
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
pub fn draw<D: Device>(
    x: Range,
    y: Range,
    options: &Options,
    plate: usize,
    feeder: impl Fn(f64, f64) -> Option<D> + Sync,
) -> Result<Map, RegionsError> {
    drawn([x, y], options, plate, &feeder, &[])
}

/// Draws a map and says how the drop at the middle of every cell ends, with few of these drops followed: see [`regions::cells`].
/// Regions are sought on a grid eight times as coarse, which is the one the map has.
///
/// `options` are [`cells_options`] unless boundaries are wanted more finely.
///
/// # Errors
/// As [`draw`].
///
/// # Example
/// A rod on a slope of 3 in 4, at 4000 places: a friction of 3/4 holds it.
/// ```
/// use carom_feeder::{Outcome, examples};
/// use carom_study::regions::Range;
/// use carom_study::{Ending, map};
/// let axes = [Range { from: 0.6, to: 0.9, count: 100 }, Range { from: 1.0, to: 2.0, count: 40 }];
/// let slope = |friction, _| Some(examples::rod_on_a_slope(friction));
/// let (found, cells) = map::draw_cells(axes, &map::cells_options(axes), 0, slope)?;
/// let held = cells.labels.iter().filter(|ending| **ending == Ending::Otherwise(Outcome::Stuck)).count();
/// assert_eq!((held, found.nodes.len()), (50 * 40, 14 * 6));
/// assert!(found.drops < 800);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
pub fn draw_cells<D: Device>(
    axes: [Range; 2],
    options: &Options,
    plate: usize,
    feeder: impl Fn(f64, f64) -> Option<D> + Sync,
) -> Result<(Map, Cells<Ending>), RegionsError> {
    regions::check(axes[0], axes[1], options)?;
    let mut map = drawn(raster::followed(axes).0, options, plate, &feeder, &[])?;
    let ending = |x, y| Dropped::through(feeder(x, y).as_ref(), plate).ending;
    let cells = raster::filled(axes, &map.regions, ending);
    map.drops += cells.evaluations;
    Ok((map, cells))
}

/// How closely boundaries must be located to say how every cell ends.
///
/// # Example
/// A tenth of a cell.
/// ```
/// use carom_study::{map::cells_options, regions::Range};
/// assert_eq!(cells_options([Range { from: 0.0, to: 1.0, count: 100 }; 2]).accuracy, 1e-3);
/// ```
pub fn cells_options(axes: [Range; 2]) -> Options {
    raster::followed(axes).1
}

/// As [`draw`], where some drops are known already: those of [`explore`].
///
/// # Errors
/// As [`draw`].
pub fn draw_knowing<D: Device>(
    [x, y]: [Range; 2],
    options: &Options,
    plate: usize,
    feeder: impl Fn(f64, f64) -> Option<D> + Sync,
    known: &[Node],
) -> Result<Map, RegionsError> {
    drawn([x, y], options, plate, &feeder, known)
}

/// Follows the drops that [`draw`] asks for in a band of the plane: `number` of `of` bands of rows, from 0. A machine each, and
/// [`draw_knowing`] what they found: the map is the same, to the last digit.
///
/// # Errors
/// As [`draw`]. A band that there is not has no drops.
///
/// # Example
/// ```
/// use carom_feeder::examples;
/// use carom_study::map::{draw, draw_knowing, explore, of_words, to_words};
/// use carom_study::regions::{Options, Range};
/// let slope = |friction: f64, _: f64| Some(examples::rod_on_a_slope(friction));
/// let axes = [Range { from: 0.6, to: 1.2, count: 3 }, Range { from: 1.0, to: 2.0, count: 2 }];
/// let options = Options { accuracy: 1e-3, depth: 1 };
/// let mut known = explore(axes, &options, 0, (0, 2), slope)?;
/// let sent = to_words(&explore(axes, &options, 0, (1, 2), slope)?);
/// known.extend(of_words(&sent).unwrap());
/// let whole = draw(axes[0], axes[1], &options, 0, slope)?;
/// assert_eq!(draw_knowing(axes, &options, 0, |_, _| None::<carom_feeder::Feeder>, &known)?, whole);
/// # Ok::<(), carom_study::regions::RegionsError>(())
/// ```
pub fn explore<D: Device>(
    axes: [Range; 2],
    options: &Options,
    plate: usize,
    band: (u32, u32),
    feeder: impl Fn(f64, f64) -> Option<D> + Sync,
) -> Result<Vec<Node>, RegionsError> {
    let asked = Mutex::new(BTreeMap::new());
    regions::explore(axes, options, band, |x, y| {
        let node = Node::of(feeder(x, y), [x, y], plate);
        // Only a thread that panics poisons a lock, and its panic goes on.
        asked.lock().unwrap_or_else(PoisonError::into_inner).insert([x, y].map(f64::to_bits), node);
        node.ending
    })?;
    Ok(asked.into_inner().unwrap_or_else(PoisonError::into_inner).into_values().collect())
}

packed!(Node { x, y, ending, impact_speed, flat, margin });

/// Drops as whole numbers, to be sent to where the map is drawn.
pub fn to_words(nodes: &Vec<Node>) -> Vec<u64> {
    nodes.sealed()
}

/// The drops that [`to_words`] gave; `None` where the numbers are no drops.
pub fn of_words(words: &[u64]) -> Option<Vec<Node>> {
    Vec::unsealed(words)
}

impl Node {
    fn of<D: Device>(feeder: Option<D>, [x, y]: [f64; 2], plate: usize) -> Self {
        let dropped = Dropped::through(feeder.as_ref(), plate);
        Self {
            x,
            y,
            ending: dropped.ending,
            impact_speed: dropped.impact_speed(plate),
            flat: dropped.flat(plate),
            margin: dropped.margin(),
        }
    }
}

fn drawn<D: Device>(
    [x, y]: [Range; 2],
    options: &Options,
    plate: usize,
    feeder: &(dyn Fn(f64, f64) -> Option<D> + Sync),
    known: &[Node],
) -> Result<Map, RegionsError> {
    regions::check(x, y, options)?;
    let known: BTreeMap<[u64; 2], Node> =
        known.iter().map(|node| ([node.x, node.y].map(f64::to_bits), *node)).collect();
    let node = |x: f64, y: f64| {
        let known = known.get(&[x, y].map(f64::to_bits)).copied();
        known.unwrap_or_else(|| Node::of(feeder(x, y), [x, y], plate))
    };
    let places: Vec<[f64; 2]> = regions::nodes([x, y]).collect();
    let nodes: Vec<Node> = places.par_iter().panic_fuse().map(|&[x, y]| node(x, y)).collect();
    let labels = nodes.iter().map(|node| node.ending).collect();
    let regions = regions::find_between([x, y], options, labels, &|x, y| node(x, y).ending)?;
    let drops = nodes.len() + regions.evaluations;
    Ok(Map { regions, nodes, drops })
}
