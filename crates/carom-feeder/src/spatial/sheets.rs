//! Plates and walls as the sheets that they are: for the part, and for pictures.

use super::feeder::{CrossSection, Plate, Wall, WallForm};
use crate::tolerance::{UNDER_WALLS, WIDE};
use carom_motion::spatial::{Obstacle, Plane};
use carom_num::elementary::sin_cos;
use carom_num::{Rotation, Vec3};
use std::f64::consts::PI;

/// Facets of a half round edge in a picture.
const FACETS: u32 = 4;

/// Axes of what carries on a plate, world axes: downhill, out of its upper side, and across it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axes {
    pub(super) downhill: Vec3,
    pub(super) up: Vec3,
    pub(super) across: Vec3,
}

impl Axes {
    /// Turned about the downhill line so far from up towards across.
    fn leant(self, angle: f64) -> Self {
        let (sine, cosine) = sin_cos(angle);
        let Self { downhill, up, across } = self;
        Self { downhill, up: up * cosine + across * sine, across: across * cosine - up * sine }
    }
}

/// The middle of a sheet: a rectangle about whose places balls are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet {
    ends: [Vec3; 2],
    /// Unit vectors from the second end to the first, across, and out of it.
    axes: [Vec3; 3],
    /// How far it reaches to either side.
    half: f64,
    radius: f64,
}

impl Sheet {
    /// One between two ends that reaches so far to either side. Its round ends reach as far as drawn, and so do its sides where they are round.
    fn between(ends: [Vec3; 2], [across, up]: [Vec3; 2], half: f64, radius: f64) -> Option<Self> {
        let along = (ends[0] - ends[1]).unit()?;
        let ends = [ends[0] - along * radius, ends[1] + along * radius];
        Some(Self { ends, axes: [along, across, up], half, radius })
    }

    /// Its corners, so far out of the middle and so much wider: at the first end, then at the other one.
    fn corners(&self, out: f64, wider: f64) -> [Vec3; 4] {
        let [along, across, up] = self.axes;
        let (across, up) = (across * (self.half + wider), up * out);
        let [first, second] = [self.ends[0] + along * wider + up, self.ends[1] - along * wider + up];
        [first + across, first - across, second - across, second + across]
    }

    /// Its polygons: one of a thin sheet; else its two sides, and facets around it, mitred at its corners.
    fn polygons(&self) -> Vec<Vec<Vec3>> {
        let ring = |k: u32| {
            let (sine, cosine) = sin_cos(PI * f64::from(k) / f64::from(FACETS));
            self.corners(self.radius * cosine, self.radius * sine)
        };
        let first = ring(0);
        if self.radius == 0.0 {
            return vec![first.to_vec()];
        }
        let facets = (0..FACETS).flat_map(|k| {
            let [high, low] = [ring(k), ring(k + 1)];
            (0..4).map(move |i| vec![high[i], high[(i + 1) % 4], low[(i + 1) % 4], low[i]])
        });
        let below = ring(FACETS).into_iter().rev().collect();
        [first.to_vec(), below].into_iter().chain(facets).collect()
    }
}

/// What a rectangle is to the part, with a ball of a radius about all of its places; `None` where it has no size.
pub(super) fn obstacle((corners, radius): ([Vec3; 4], f64)) -> Option<Obstacle> {
    let thin = Obstacle::plate(&corners).ok()?;
    if radius > 0.0 { thin.rounded(radius).ok() } else { Some(thin) }
}

impl Plate {
    /// The axes of the plate; `None` where it has no length.
    pub(super) fn axes(&self) -> Option<Axes> {
        let run = (self.edge - self.uphill).unit()?;
        let downhill = Vec3::new(run.x, run.y, 0.0);
        let left = if run.x >= 0.0 { run.turned_left() } else { -run.turned_left() };
        let sign = if run.x >= 0.0 { 1.0 } else { -1.0 };
        let roll = Rotation::by(downhill * (sign * self.roll));
        Some(Axes { downhill, up: roll.apply(Vec3::new(left.x, left.y, 0.0)), across: roll.apply(Vec3::Z) })
    }

    /// The axes of what carries: of a flat plate its own; of the flanks of a groove, the one behind first. None where it has no length.
    pub(super) fn carrying(&self) -> Vec<Axes> {
        let Some(axes) = self.axes() else { return vec![] };
        match self.cross_section {
            CrossSection::Flat | CrossSection::Walled { .. } => vec![axes],
            CrossSection::Groove { angle } => {
                let lean = 0.5 * (PI - angle);
                vec![axes.leant(lean), axes.leant(-lean)]
            }
        }
    }

    /// The sheets that carry, below their upper sides. Sides are round as ends are, unless walls stand along them: the upper side reaches under these.
    fn carriers(&self, size: f64) -> Vec<Sheet> {
        let radius = self.edge_radius;
        let half = 0.5 * self.width.unwrap_or(WIDE * size);
        let under = UNDER_WALLS * size;
        // How far the middles of their sheets reach across, from one side to the other.
        let reaches = match self.cross_section {
            CrossSection::Walled { .. } => vec![[-half - under, half + under]],
            CrossSection::Flat if self.width.is_none() => vec![[-half, half]],
            CrossSection::Flat => vec![[radius - half, half - radius]],
            CrossSection::Groove { angle } => {
                let (sine, cosine) = sin_cos(0.5 * angle);
                // At the bottom each goes on below the other: as a bent sheet does, their middles meet.
                let (long, beyond) = (half / sine - radius, under.max(radius * cosine / sine));
                vec![[-long, beyond], [-beyond, long]]
            }
        };
        let sheet = |(Axes { up, across, .. }, [from, to]): (Axes, [f64; 2])| {
            let middle = across * (0.5 * (from + to)) - up * radius;
            let ends = [self.edge, self.uphill].map(|at| Vec3::new(at.x, at.y, 0.0) + middle);
            Sheet::between(ends, [across, up], 0.5 * (to - from), radius)
        };
        self.carrying().into_iter().zip(reaches).filter_map(sheet).collect()
    }

    /// The walls along its sides, by their corners; none where they have no height or the plate is as wide as needed. They go on below the upper side, as that does under them: where they meet
    /// the part touches faces, and no edges.
    fn sides(&self, size: f64) -> Vec<[Vec3; 4]> {
        let CrossSection::Walled { height } = self.cross_section else { return vec![] };
        let (Some(width), Some(axes)) = (self.width, self.axes()) else { return vec![] };
        let [edge, uphill] = [self.edge, self.uphill].map(|at| Vec3::new(at.x, at.y, 0.0));
        let [low, high] = [-UNDER_WALLS * size, height].map(|rise| axes.up * rise);
        let side = |sign: f64| {
            let beside = axes.across * (0.5 * width * sign);
            [edge + beside + low, edge + beside + high, uphill + beside + high, uphill + beside + low]
        };
        vec![side(1.0), side(-1.0)]
    }

    /// The rectangles in the middle of its sheets that carry, and those of the walls along its sides, by their corners \[m\]; each with the radius of the ball about all of its places.
    /// Beside a part of this size; none where it has no length.
    pub fn sheets(&self, size: f64) -> Vec<([Vec3; 4], f64)> {
        let carriers = self.carriers(size).into_iter().map(|sheet| (sheet.corners(0.0, 0.0), sheet.radius));
        carriers.chain(self.sides(size).into_iter().map(|corners| (corners, 0.0))).collect()
    }

    /// Its polygons as a picture has them \[m\], beside a part of this size: its sheets that carry, each by the corners along its free edge first, counter-clockwise as seen from above where
    /// it leads to the right, round edges in facets; then the walls along its sides.
    pub fn polygons(&self, size: f64) -> Vec<Vec<Vec3>> {
        let carriers = self.carriers(size).into_iter().flat_map(|sheet| sheet.polygons());
        carriers.chain(self.sides(size).into_iter().map(Vec::from)).collect()
    }
}

impl Wall {
    /// What scenes call it.
    pub(super) fn kind(&self) -> &'static str {
        if matches!(self.form, WallForm::Pin { .. }) { "pin" } else { "wall" }
    }

    /// The sheet of a wall across the drawing, which reaches so far to either side.
    fn sheet(&self, half: f64) -> Option<Sheet> {
        let WallForm::Across { from, to, edge_radius } = self.form else { return None };
        let ends = [from, to].map(|at| Vec3::new(at.x, at.y, 0.0));
        let up = Vec3::Z.cross((ends[0] - ends[1]).unit()?);
        Sheet::between(ends, [Vec3::Z, up], half, edge_radius)
    }

    /// Its polygons as a picture has them \[m\], so far to either side of the drawing, a pin in facets; none of a wall beside it.
    pub fn polygons(&self, half: f64) -> Vec<Vec<Vec3>> {
        if let WallForm::Pin { ends, radius } = self.form {
            return pin_polygons(ends, radius);
        }
        self.sheet(half).map(|sheet| sheet.polygons()).unwrap_or_default()
    }

    /// What it is to the part; a wall across the drawing is as wide as needed for parts of this size.
    pub(super) fn obstacle(&self, size: f64) -> Option<Obstacle> {
        let found = match self.form {
            WallForm::Across { .. } => {
                let sheet = self.sheet(0.5 * WIDE * size)?;
                obstacle((sheet.corners(0.0, 0.0), sheet.radius))?
            }
            WallForm::Pin { ends, radius } => Obstacle::pin(ends, radius).ok()?,
            WallForm::Beside { z } => {
                let inwards = Vec3::Z * if z > 0.0 { -1.0 } else { 1.0 };
                Plane::new(inwards, -z.abs()).ok()?.into()
            }
        };
        Some(found.with_friction(self.friction).with_restitution(self.restitution))
    }
}

/// Facets of a round bar and of its half balls: rings from one end to the other.
fn pin_polygons([from, to]: [Vec3; 2], radius: f64) -> Vec<Vec<Vec3>> {
    let along = (to - from).unit().unwrap_or(Vec3::Y);
    let [first, second] = along.tangents();
    let around = 4 * FACETS;
    let ring = |middle: Vec3, off: f64| {
        let point = move |k: u32| {
            let (sine, cosine) = sin_cos(2.0 * PI * f64::from(k) / f64::from(around));
            middle + (first * cosine + second * sine) * off
        };
        (0..around).map(point).collect::<Vec<_>>()
    };
    let cap = |end: Vec3, sign: f64| {
        let turn = move |k: u32| sin_cos(0.5 * PI * f64::from(k) / f64::from(FACETS));
        (0..FACETS).map(move |k| (end + along * (sign * radius * turn(k).0), radius * turn(k).1))
    };
    let rings: Vec<Vec<Vec3>> =
        cap(from, -1.0).rev().chain(cap(to, 1.0)).map(|(at, off)| ring(at, off)).collect();
    let bands = rings.windows(2).flat_map(|pair| {
        let n = pair[0].len();
        (0..n).map(move |k| {
            let next = (k + 1) % n;
            vec![pair[0][k], pair[0][next], pair[1][next], pair[1][k]]
        })
    });
    let ends = [rings.first(), rings.last()].into_iter().flatten().cloned();
    bands.chain(ends).collect()
}
