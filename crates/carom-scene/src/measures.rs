//! What a scene draws and writes for pictures: its part's outline, and the measures of its plates.

use crate::chain::{ArcDrawing, ChainDrawing, Stop};
use crate::drawing::{Level, Outline, Place, PlateDrawing, Reach, Side, WallCourse};
use crate::layout::zigzag_plates;
use crate::quantity::{Quantity, Tolerance};
use crate::scene::Scene;
use crate::space::SpaceScene;
use crate::unit::Dimension;
use carom_feeder::FormArc;
use carom_motion::planar::ChainPoint;
use carom_num::Vec2;

/// Which way a measure is taken.
///
/// # Example
/// ```
/// use carom_scene::MeasureAxis;
/// assert_ne!(MeasureAxis::Level, MeasureAxis::Plumb);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeasureAxis {
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

/// A measure that a scene writes, between two points of its layout.
///
/// # Example
/// A drop is measured plumb, from hinge to hinge.
/// ```
/// use carom_scene::{MeasureAxis, Scene};
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let slope = scene.measures().into_iter().find(|measure| measure.axis == MeasureAxis::Slope).unwrap();
/// assert_eq!((slope.plate, slope.name), (Some(0), "slope"));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// The plate that it places, counted from 0; `None` for what places none.
    pub plate: Option<usize>,
    /// Its key.
    pub name: &'static str,
    /// Value and tolerance in a drawing's unit.
    pub text: String,
    /// Which way it is taken.
    pub axis: MeasureAxis,
    /// Where it begins [m].
    pub from: Vec2,
    /// Where it ends [m].
    pub to: Vec2,
}

/// A quantity as a drawing has it: `150 ± 1 mm`, `25 ± 0.5°`.
fn shown(quantity: &Quantity) -> String {
    let dimension = quantity.kind.dimension;
    let (unit, symbol) = match (dimension, dimension.unit(dimension.usual())) {
        (Dimension::Angle, unit) => (unit, "°".to_owned()),
        (_, Some(unit)) => (Some(unit), format!(" {}", unit.symbol)),
        (_, None) => (None, String::new()),
    };
    let number = |value: f64| {
        let value = unit.map_or(value, |unit| unit.of_si(value));
        Dimension::Number.show_digits(value, DIGITS)
    };
    match quantity.tolerance {
        None => format!("{}{symbol}", number(quantity.value)),
        Some(Tolerance::Limits { half_width }) => {
            format!("{} ± {}{symbol}", number(quantity.value), number(half_width))
        }
        Some(Tolerance::Sigma { sigma }) => {
            format!("{}{symbol} (σ {}{symbol})", number(quantity.value), number(sigma))
        }
        Some(Tolerance::Uniform { low, high }) => format!("{} to {}{symbol}", number(low), number(high)),
    }
}

/// Digits of a measure.
const DIGITS: usize = 7;

impl Scene {
    /// What its part's file draws, or its library, about the part's mass centre, in the part's own axes \[m\]: closed chains of points, the outline first, then its
    /// holes, near enough to its curves for pictures; of a part of the library that is hollow, what is hollow in it. Empty where its shape is all there is to see.
    pub fn outline(&self) -> Vec<Vec<Vec2>> {
        match &self.drawing().part.outline {
            Outline::File { drawn, scale } => drawn.loops(scale.value, self.origin()),
            Outline::Library(part) => part.loops(self.origin()),
            _ => vec![],
        }
    }

    /// The measures that it writes about its plates and its channel, in the order of the file; where its plates stand they are measured.
    ///
    /// # Example
    /// The second plate of a zig-zag hangs its drop below the first one.
    /// ```
    /// use carom_scene::Scene;
    /// let scene = Scene::parse("zigzag.toml", r#"
    ///     part = { shape = "rod", length = "40 mm", mass = "0.1 kg" }
    ///     contact = { friction = 0.15 }
    ///     start = { to_edge = "60 mm" }
    ///     channel = { width = "240 mm" }
    ///     zigzag = { plates = 2, drop = "150 ± 1 mm", slope = "25 deg", gap = "90 mm" }
    /// "#)?;
    /// let measures = scene.measures();
    /// let drop = measures.iter().find(|measure| measure.name == "drop").unwrap();
    /// assert_eq!((drop.plate, drop.text.as_str(), drop.from.y - drop.to.y), (Some(1), "150 ± 1 mm", 0.15));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn measures(&self) -> Vec<Measure> {
        let drawing = self.drawing();
        let zigzag = drawing.zigzag.as_ref().map(zigzag_plates);
        let drawn: &[PlateDrawing] = zigzag.as_deref().unwrap_or(&drawing.plates);
        let plates = &self.feeder().plates;
        let mut all = vec![];
        if let (Some(channel), Some(first)) = (&drawing.channel, plates.first()) {
            let top = plates.iter().map(|plate| plate.uphill.y).fold(first.uphill.y, f64::max);
            let (from, to) = (Vec2::new(0.0, top), Vec2::new(channel.width.value, top));
            let (name, text) = ("width", shown(&channel.width));
            all.push(Measure { plate: None, name, text, axis: MeasureAxis::Level, from, to });
        }
        let width = drawing.channel.as_ref().map(|channel| channel.width.value);
        let ends: Vec<(Vec2, Vec2)> = plates.iter().map(|plate| (plate.uphill, plate.edge)).collect();
        for (i, (drawn, plate)) in drawn.iter().zip(plates).enumerate() {
            all.extend(lies(i, drawn, &ends, width));
            let chain = match &drawn.place {
                Place::Chain { chain } => Some(chain),
                _ => None,
            };
            let radii = Radii { plate: Some(i), chain, edge: drawn.edge_radius.as_ref() };
            all.extend(radii.measures(&plate.form.course, &plate.arcs()));
        }
        for drawn in &drawing.walls {
            let chain = match &drawn.course {
                WallCourse::Chain { chain } => Some(chain),
                WallCourse::Ends { .. } => None,
            };
            let radii = Radii { plate: None, chain, edge: drawn.edge_radius.as_ref() };
            if let Some(wall) = self.feeder().walls.iter().find(|wall| wall.name == drawn.name) {
                all.extend(radii.measures(&wall.form.course, &wall.arcs()));
            }
        }
        all
    }
}

impl SpaceScene {
    /// The measures that it writes about its plates, in the order of the file, as [`Scene::measures`]: those of the drawing, seen from the side.
    ///
    /// # Example
    /// ```
    /// use carom_scene::{AnyScene, MeasureAxis};
    /// let AnyScene::Space(scene) = AnyScene::read("../../examples/solid.toml".as_ref())? else { panic!("it is in space") };
    /// let first = &scene.measures()[0];
    /// assert_eq!((first.plate, first.axis, first.text.as_str()), (Some(0), MeasureAxis::Slope, "15°"));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn measures(&self) -> Vec<Measure> {
        let ends: Vec<(Vec2, Vec2)> =
            self.feeder().plates.iter().map(|plate| (plate.uphill, plate.edge)).collect();
        let width = self.drawing().channel.as_ref().map(|channel| channel.width.value);
        let drawn = self.drawing().plates.iter().enumerate().take(ends.len());
        drawn.flat_map(|(i, drawn)| lies(i, drawn, &ends, width)).collect()
    }
}

/// What is written about where a plate lies, of plates with these ends.
fn lies(plate: usize, drawn: &PlateDrawing, ends: &[(Vec2, Vec2)], width: Option<f64>) -> Vec<Measure> {
    let before = plate.checked_sub(1).map(|before| ends[before]);
    Lies { plate, ends: ends[plate], before, width }.measures(&drawn.place)
}

/// What is written about the radii of a plate or wall.
struct Radii<'d> {
    plate: Option<usize>,
    chain: Option<&'d ChainDrawing>,
    edge: Option<&'d Quantity>,
}

impl Radii<'_> {
    /// The radii that are written, of these arcs of a course: one of the two edges stands for both.
    fn measures(&self, course: &[ChainPoint], arcs: &[FormArc]) -> Vec<Measure> {
        // Bends come in the order of the course, each from the point where it begins.
        let mut begins = course.iter().filter(|point| point.sweep != 0.0).map(|point| point.at);
        let written = arcs.iter().filter(|arc| !arc.uphill).filter_map(|arc| {
            let (name, radius) =
                if arc.bend { ("bend R", self.of_bend(begins.next()?)) } else { ("edge R", self.edge) };
            let (plate, text) = (self.plate, shown(radius?));
            Some(Measure { plate, name, text, axis: MeasureAxis::Radius, from: arc.centre, to: arc.middle })
        });
        written.collect()
    }

    /// The radius of the bend that begins here: that of the arc which the chain draws there, else that of its rounded corners.
    fn of_bend(&self, begins: Vec2) -> Option<&Quantity> {
        let chain = self.chain?;
        let starts = |stop: &&Stop| Vec2::new(stop.at[0].value, stop.at[1].value) == begins;
        match chain.stops.iter().find(starts).map(|stop| &stop.arc) {
            Some(Some((ArcDrawing::OfRadius { radius, .. }, _))) => Some(radius),
            Some(_) => None,
            None => chain.bend_radius.as_ref(),
        }
    }
}

/// Where a plate lies, and what it is measured from.
struct Lies {
    plate: usize,
    /// Uphill end and free edge.
    ends: (Vec2, Vec2),
    /// Those of the plate before it.
    before: Option<(Vec2, Vec2)>,
    /// The channel's.
    width: Option<f64>,
}

impl Lies {
    fn measure(
        &self,
        name: &'static str,
        quantity: &Quantity,
        axis: MeasureAxis,
        ends: (Vec2, Vec2),
    ) -> Measure {
        let (plate, text) = (Some(self.plate), shown(quantity));
        Measure { plate, name, text, axis, from: ends.0, to: ends.1 }
    }

    fn slope(&self, slope: &Quantity) -> Measure {
        self.measure("slope", slope, MeasureAxis::Slope, self.ends)
    }

    fn length(&self, length: &Quantity) -> Measure {
        self.measure("length", length, MeasureAxis::Along, self.ends)
    }

    fn measures(&self, place: &Place) -> Vec<Measure> {
        let (uphill, edge) = self.ends;
        match place {
            Place::Origin { slope, length, .. } => {
                let length = length.as_ref().map(|length| self.length(length));
                std::iter::once(self.slope(slope)).chain(length).collect()
            }
            Place::Hinged { wall, level, slope, reach } => {
                let level = match (level, self.before) {
                    (Level::Drop(drop), Some((hinge, _))) => {
                        Some(self.measure("drop", drop, MeasureAxis::Plumb, (hinge, uphill)))
                    }
                    (Level::Height(height), _) if height.value != 0.0 => {
                        let from = Vec2::new(uphill.x, 0.0);
                        Some(self.measure("height", height, MeasureAxis::Plumb, (from, uphill)))
                    }
                    _ => None,
                };
                // A gap is measured to the wall on the other side of the hinge.
                let far = match wall {
                    Side::Left => self.width.unwrap_or(edge.x),
                    Side::Right => 0.0,
                };
                let reach = match reach {
                    Reach::Gap(gap) => {
                        let ends = (edge, Vec2::new(far, edge.y));
                        self.measure("gap", gap, MeasureAxis::Level, ends)
                    }
                    Reach::Length(length) => self.length(length),
                };
                level.into_iter().chain([self.slope(slope), reach]).collect()
            }
            Place::Through { slope, below, .. } => {
                let from = self.before.map_or(edge, |(_, edge)| edge);
                let level = from + Vec2::new(below[0].value, 0.0);
                let point = level + Vec2::new(0.0, below[1].value);
                let [x, y] = [
                    self.measure("below x", &below[0], MeasureAxis::Level, (from, level)),
                    self.measure("below y", &below[1], MeasureAxis::Plumb, (level, point)),
                ];
                vec![self.slope(slope), x, y]
            }
            Place::Line { along, normal, .. } => {
                let Some((start, from)) = self.before else { return vec![] };
                let x = (from - start).unit().unwrap_or_default();
                // Down through the plate, whichever way it slopes.
                let y = if x.x < 0.0 { x.turned_left() } else { x.turned_right() };
                let [to_x, to_y] = [from + x * along.value, from + y * normal.value];
                vec![
                    self.measure("along", along, MeasureAxis::Along, (from, to_x)),
                    self.measure("normal", normal, MeasureAxis::Along, (from, to_y)),
                ]
            }
            Place::Edge { slope, length, .. } => vec![self.slope(slope), self.length(length)],
            Place::Ends { .. } | Place::Chain { .. } => vec![],
        }
    }
}
