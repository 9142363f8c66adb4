//! Dragging what a scene draws: which values of its file bring a plate, a wall or the part to where a pointer is.

use crate::problem::{Problem, ProblemKind, Problems};
use crate::scene::{NamedQuantity, Scene};
use crate::unit::Dimension;
use crate::variants::Variants;
use carom_feeder::Feeder;
use carom_num::Vec2;
use carom_num::solve::solve_any;
use serde::{Deserialize, Serialize};

/// Quantities that one drag moves at most.
const MOST: usize = 8;
/// Steps of the search: it is all but linear, and a pointer's next place starts from the last.
const STEPS: usize = 8;
/// How much harder an end that is not dragged is to move than the one that is.
const STIFF: f64 = 30.0;
/// The step of a difference quotient, as a share of what a quantity's unit means on the drawing.
const NUDGE: f64 = 1e-6;
/// Steps below this share of the drawing end the search.
const STILL: f64 = 1e-9;
/// Damping: the share of the largest entry that keeps a direction at rest that moves nothing.
const DAMPING: f64 = 1e-9;

/// What is held while it is dragged.
///
/// # Example
/// ```
/// use carom_scene::Hold;
/// assert_ne!(Hold::First, Hold::Last);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Hold {
    /// The first end: a plate's uphill end. The other stays, if it can.
    First,
    /// The middle: both ends move alike, if they can.
    Middle,
    /// The last end: a plate's free edge. The other stays, if it can.
    Last,
}

/// What a pointer drags.
///
/// # Example
/// ```
/// use carom_scene::Grip;
/// assert_ne!(Grip::Part, Grip::Obstacle { index: 0, ends: Default::default(), cut: [false; 2], hold: carom_scene::Hold::Last, at: Default::default() });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Grip {
    /// The part, along the plate it starts on.
    Part,
    /// A plate, or after the plates a wall.
    Obstacle {
        /// Its number among plates and walls, from 0.
        index: usize,
        /// Where its ends are seen [m].
        ends: [Vec2; 2],
        /// Which ends are none: the picture cuts a plate there that goes on.
        cut: [bool; 2],
        /// Where it is held.
        hold: Hold,
        /// The point that the pointer takes along \[m\]; of an end that end.
        at: Vec2,
    },
}

/// To what values snap: to multiples of these, SI.
///
/// # Example
/// ```
/// use carom_scene::Snap;
/// assert_eq!(Snap { length: 1e-3, angle: 0.5_f64.to_radians() }.length, 1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Snap {
    /// Of lengths [m].
    pub length: f64,
    /// Of angles [rad].
    pub angle: f64,
}

impl Scene {
    /// The quantities of the file that move a plate, a wall or the part, in the order of the scene; those that the file does not write cannot.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{Grip, Scene};
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// assert_eq!(scene.moved_by(None)[0].path, "start.to_edge");
    /// let lower: Vec<String> = scene.moved_by(Some(1)).into_iter().map(|quantity| quantity.path).collect();
    /// assert_eq!(lower, ["plate.lower.line.along", "plate.lower.line.normal"]);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn moved_by(&self, obstacle: Option<usize>) -> Vec<NamedQuantity> {
        let feeder = self.feeder();
        let named = |of: &str, name: &str| vec![format!("{of}.{name}.")];
        let prefixes = match obstacle {
            None => vec!["start.to_edge".to_owned()],
            Some(i) => match (feeder.plates.get(i), i.checked_sub(feeder.plates.len())) {
                (Some(plate), _) => named("plate", &plate.name),
                (None, Some(wall)) => feeder.walls.get(wall).map_or(vec![], |wall| named("wall", &wall.name)),
                (None, None) => vec![],
            },
        };
        let places = |quantity: &NamedQuantity| {
            let dimension = quantity.kind.dimension;
            let shape = quantity.path.ends_with("_radius");
            quantity.written && matches!(dimension, Dimension::Length | Dimension::Angle) && !shape
        };
        let of = |prefixes: &[String]| {
            let begins = |path: &str| prefixes.iter().any(|prefix| path.starts_with(prefix.as_str()));
            let all = self.quantities().into_iter();
            all.filter(|quantity| places(quantity) && begins(&quantity.path)).take(MOST).collect::<Vec<_>>()
        };
        let own = of(&prefixes);
        // A zig-zag and a channel draw plates and walls that have no tables of their own.
        if own.is_empty() && obstacle.is_some() {
            return of(&["zigzag.".to_owned(), "channel.width".to_owned()]);
        }
        own
    }

    /// The text of the scene after a grip was dragged to a point \[m\], or as near as its quantities allow. Tolerances and comments stay.
    ///
    /// # Errors
    /// Nothing in the file moves it; a drawing that the values make impossible.
    ///
    /// # Example
    /// The part is drawn 30 mm up the plate, which slopes by 10°.
    /// ```
    /// use carom_scene::{Grip, Scene, Snap};
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// let at = scene.feeder().start_state().pose.centre;
    /// let up = at + carom_num::Vec2::at_angle(170_f64.to_radians()) * 0.0302;
    /// let text = scene.dragged(&Grip::Part, up, Snap { length: 1e-3, angle: 0.01 })?;
    /// assert!(text.contains("to_edge = \"130.0 mm\""), "{text}");
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn dragged(&self, grip: &Grip, to: Vec2, snap: Snap) -> Result<String, Problems> {
        let obstacle = match grip {
            Grip::Part => None,
            Grip::Obstacle { index, .. } => Some(*index),
        };
        let moved = self.moved_by(obstacle);
        if moved.is_empty() {
            let message = "nothing that the file writes moves this";
            let problem = Problem::new(ProblemKind::MissingKey, "", message, None);
            return Err(Problems::new(self.file(), self.source(), vec![problem]));
        }
        let paths: Vec<&str> = moved.iter().map(|quantity| quantity.path.as_str()).collect();
        let variants = self.variants(&paths)?;
        let drag = Drag { variants: &variants, moved: &moved, grip, to, size: size_of(grip, self.feeder()) };
        let found = drag.search();
        let value = |(quantity, found): (&NamedQuantity, f64)| snapped(quantity, found, snap);
        let values: Vec<f64> = moved.iter().zip(found).map(value).collect();
        // What has not moved stays as it is written.
        let changed = moved.iter().zip(&values).filter(|(quantity, value)| quantity.value != **value);
        let (paths, values): (Vec<&str>, Vec<f64>) =
            changed.map(|(quantity, value)| (quantity.path.as_str(), *value)).unzip();
        self.variants(&paths)?.text_with_tolerances(&values)
    }

    /// Where a plate or wall can be held: whether some quantity of the file moves its first end, its middle, its last end. `cut` says which
    /// ends are none, because the plate goes on.
    ///
    /// # Example
    /// The first plate's free edge is the origin, wherever its slope points.
    /// ```
    /// use carom_scene::Scene;
    /// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
    /// assert_eq!(scene.holds(0, [true, false]), [true, true, false]);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn holds(&self, obstacle: usize, cut: [bool; 2]) -> [bool; 3] {
        let moved = self.moved_by(Some(obstacle));
        let paths: Vec<&str> = moved.iter().map(|quantity| quantity.path.as_str()).collect();
        let (Some(now), Ok(variants)) = (ends_of(self.feeder(), obstacle), self.variants(&paths)) else {
            return [false; 3];
        };
        let size = (now[1] - now[0]).norm();
        let own: Vec<f64> = moved.iter().map(|quantity| quantity.value).collect();
        let mut holds = [false; 3];
        for (k, quantity) in moved.iter().enumerate() {
            let lever = if quantity.kind.dimension == Dimension::Angle { 1.0 } else { size };
            let nudged = [NUDGE, -NUDGE].into_iter().find_map(|nudge| {
                let mut values = own.clone();
                values[k] += nudge * lever;
                ends_of(&variants.feeder(&values).ok()?, obstacle)
            });
            let Some(there) = nudged else { continue };
            let apart = [there[0] - now[0], there[1] - now[1]];
            // A plate that goes on can be turned about its other end.
            let turned = (apart[1] - apart[0]).norm() > STILL * size;
            let moves = apart.map(|apart| apart.norm() > STILL * size);
            let ends = [0, 1].map(|end| moves[end] || (cut[end] && turned));
            let now = [ends[0], moves[0] || moves[1], ends[1]];
            holds = core::array::from_fn(|hold| holds[hold] || now[hold]);
        }
        holds
    }
}

/// Lengths of the drawing around a grip are measured in this [m].
fn size_of(grip: &Grip, feeder: &Feeder) -> f64 {
    match grip {
        Grip::Part => feeder.part.body.shape.size(),
        Grip::Obstacle { ends: [from, to], .. } => (*to - *from).norm(),
    }
}

/// A value that has moved, at the nearest multiple of a step in the unit of drawings.
fn snapped(quantity: &NamedQuantity, found: f64, snap: Snap) -> f64 {
    let dimension = quantity.kind.dimension;
    let step = if dimension == Dimension::Angle { snap.angle } else { snap.length };
    let rests = (found - quantity.value).abs() < 0.5 * step;
    match dimension.unit(dimension.usual()) {
        Some(unit) if !rests && step > 0.0 => {
            let step = unit.of_si(step);
            unit.to_si((unit.of_si(found) / step).round() * step)
        }
        _ if rests => quantity.value,
        _ => found,
    }
}

struct Drag<'a> {
    variants: &'a Variants<'a>,
    moved: &'a [NamedQuantity],
    grip: &'a Grip,
    to: Vec2,
    /// What the drawing's lengths are measured in [m].
    size: f64,
}

impl Drag<'_> {
    /// Gauss and Newton, damped: of all values that come as near the nearest to the old ones.
    fn search(&self) -> Vec<f64> {
        let mut values: Vec<f64> = self.moved.iter().map(|quantity| quantity.value).collect();
        let Some(mut misses) = self.misses(&values) else { return values };
        for _ in 0..STEPS {
            let Some(step) = self.step(&values, &misses) else { break };
            // A step that leads where nothing can be drawn, or not nearer, is halved.
            let mut share = 1.0;
            let next = (0..STEPS).find_map(|_| {
                let tried: Vec<f64> =
                    values.iter().zip(&step).map(|(value, step)| value + share * step).collect();
                share *= 0.5;
                let nearer = |new: &[f64; 4]| square(new) < square(&misses);
                self.misses(&tried).filter(nearer).map(|new| (tried, new))
            });
            let Some((tried, new)) = next else { break };
            let gained = square(&misses) - square(&new);
            (values, misses) = (tried, new);
            if gained < STILL * STILL * self.size * self.size {
                break;
            }
        }
        values
    }

    /// What one unit of a quantity means on the drawing [m].
    fn lever(&self, quantity: &NamedQuantity) -> f64 {
        if quantity.kind.dimension == Dimension::Angle { self.size } else { 1.0 }
    }

    fn step(&self, values: &[f64], misses: &[f64; 4]) -> Option<Vec<f64>> {
        let count = values.len();
        let mut columns = [[0.0; 4]; MOST];
        for (k, quantity) in self.moved.iter().enumerate() {
            let nudge = NUDGE * self.size / self.lever(quantity);
            let mut moved = values.to_vec();
            let there = [nudge, -nudge].into_iter().find_map(|nudge| {
                moved[k] = values[k] + nudge;
                Some((self.misses(&moved)?, nudge))
            });
            if let Some((there, nudge)) = there {
                let unit = nudge * self.lever(quantity);
                columns[k] = core::array::from_fn(|row| (there[row] - misses[row]) / unit);
            }
        }
        let dot = |a: &[f64; 4], b: &[f64; 4]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let largest = columns.iter().map(|column| dot(column, column)).fold(0.0, f64::max);
        if largest == 0.0 {
            return None;
        }
        let mut matrix = [[0.0; MOST]; MOST];
        let mut right = [0.0; MOST];
        for i in 0..count {
            for j in 0..count {
                matrix[i][j] = dot(&columns[i], &columns[j]);
            }
            matrix[i][i] += DAMPING * largest;
            right[i] = -dot(&columns[i], misses);
        }
        let found = solve_any(matrix, right, count, f64::EPSILON)?.point;
        Some(self.moved.iter().zip(found).map(|(quantity, step)| step / self.lever(quantity)).collect())
    }

    /// By how much these values miss what the pointer wants [m]; `None` where nothing can be drawn with them.
    fn misses(&self, values: &[f64]) -> Option<[f64; 4]> {
        let feeder = self.variants.feeder(values).ok()?;
        match *self.grip {
            Grip::Part => {
                let miss = feeder.start_state().pose.centre - self.to;
                Some([miss.x, miss.y, 0.0, 0.0])
            }
            Grip::Obstacle { index, ends, cut, hold, at } => {
                let now = ends_of(&feeder, index)?;
                let moved = self.to - at;
                let wanted = match hold {
                    Hold::First => [ends[0] + moved, ends[1]],
                    Hold::Middle => [ends[0] + moved, ends[1] + moved],
                    Hold::Last => [ends[0], ends[1] + moved],
                };
                let normal = (now[1] - now[0]).unit()?.turned_left();
                // Of a plate that goes on only its line can be brought to a point.
                let miss = |k: usize| {
                    let off = now[k] - wanted[k];
                    if cut[k] { normal * off.dot(normal) } else { off }
                };
                let [a, b] = [miss(0), miss(1)];
                let [a, b] = match hold {
                    Hold::First => [a, b * STIFF],
                    Hold::Middle => [(a + b) * 0.5, (a - b) * STIFF],
                    Hold::Last => [a * STIFF, b],
                };
                Some([a.x, a.y, b.x, b.y])
            }
        }
    }
}

fn square(misses: &[f64; 4]) -> f64 {
    misses.iter().map(|miss| miss * miss).sum()
}

/// The ends of a plate or wall [m].
fn ends_of(feeder: &Feeder, obstacle: usize) -> Option<[Vec2; 2]> {
    match feeder.plates.get(obstacle) {
        Some(plate) => Some([plate.uphill, plate.edge]),
        None => feeder.walls.get(obstacle - feeder.plates.len()).map(|wall| [wall.from, wall.to]),
    }
}

#[cfg(test)]
mod tests;
