//! A pyramid on a regular base that turns about its lateral edge OA until the next corner K of the base strikes: then the face OAK lies on the plane.

use super::PyramidShape;
use super::homogeneous;
use super::setup::{MassSpec, Setup, SpatialDrawing, count};
use crate::grammar::{Section, roll::DEFAULT_RADIUS};
use crate::roll::bodies::unfit;
use carom_motion::spatial::State;
use carom_num::elementary::{atan2, sin, sin_cos};
use carom_num::{Rotation, Vec3};
use std::f64::consts::PI;

const DEFAULT_ROLL_RATE: f64 = 5.0;
/// The mass centre's height over the base of a homogeneous one.
const QUARTER: f64 = 0.25;
/// The corners of the base in the literature's letters; O is the apex.
const LETTERS: [&str; 12] = ["A", "K", "C", "D", "E", "F", "G", "H", "I", "J", "L", "M"];

pub(super) fn read(root: &Section<'_>) -> Option<Setup> {
    let mass = MassSpec::read(root);
    let shape = shape(root);
    let lifted = root.number("tilt");
    let roll_rate = root.value("roll_rate").unwrap_or(if lifted > 0.0 { 0.0 } else { DEFAULT_ROLL_RATE });
    if roll_rate <= 0.0 && lifted == 0.0 {
        unfit(
            root,
            "roll_rate",
            "must be above 0 where the face starts flat: the pyramid turns about OA down to K",
        );
    }
    let below = root.value("apex_to_centre");
    let shape = shape?;
    let below = below.unwrap_or((1.0 - QUARTER) * shape.height);
    if below >= shape.height {
        unfit(root, "apex_to_centre", format!("must be less than the height, {} m", shape.height));
        return None;
    }
    let shape = PyramidShape { homogeneous: mass.is_open() && !root.has("apex_to_centre"), ..shape };
    let PyramidShape { sides, height, circumradius, .. } = shape;
    let points = points(&shape, below);
    let solid = homogeneous::pyramid(mass.mass, sides, circumradius, height);
    let body = mass.body(root, solid, points.clone(), "circumradius")?;
    let n = sides as usize;
    let faces: Vec<Vec<usize>> = (0..n).map(|j| vec![0, 1 + (j + 1) % n, 1 + j]).collect();
    let start = State::standing(&body, 0, attitude(&shape, &points, lifted), edge(&points) * -roll_rate);
    let inward = |face: &Vec<usize>| {
        let at = |i: usize| points[face[i]];
        (at(2) - at(0)).cross(at(1) - at(0)).unit()
    };
    // The base counts as well: the tilt that is shown is that of the face nearest to the plane.
    let mut normals: Vec<Vec3> = faces.iter().filter_map(inward).collect();
    normals.push(-Vec3::Z);
    let base = (1..=n).collect();
    let names = std::iter::once("O").chain(LETTERS).take(n + 1).map(str::to_owned).collect();
    Some(Setup {
        body,
        points: names,
        drawing: SpatialDrawing { corners: points, faces: [faces, vec![base]].concat(), lines: vec![] },
        faces: normals,
        pyramid: Some(shape),
        thrown: None,
        start,
    })
}

/// Base and height, as they are written.
fn shape(root: &Section<'_>) -> Option<PyramidShape> {
    let sides = count(root, "sides")?;
    let (radius, base_edge) = (root.value("circumradius"), root.value("base_edge"));
    let (height, ratio) = (root.value("height"), root.number("height_ratio"));
    let of_edge = base_edge.map(|edge| 0.5 * edge / sin(PI / f64::from(sides)));
    let circumradius = radius.or(of_edge).unwrap_or(DEFAULT_RADIUS);
    Some(PyramidShape {
        sides,
        height: height.unwrap_or(ratio * circumradius),
        circumradius,
        homogeneous: true,
    })
}

/// The apex and the base's corners from the mass centre: z runs from the apex to the base, the face OAK is symmetric about x.
fn points(shape: &PyramidShape, below: f64) -> Vec<Vec3> {
    let corner = |j: u32| {
        let (sin, cos) = sin_cos(PI / f64::from(shape.sides) * (2.0 * f64::from(j) - 1.0));
        Vec3::new(shape.circumradius * cos, shape.circumradius * sin, shape.height - below)
    };
    std::iter::once(Vec3::Z * -below).chain((0..shape.sides).map(corner)).collect()
}

/// From the apex to A, unit.
fn edge(points: &[Vec3]) -> Vec3 {
    (points[1] - points[0]).unit().unwrap_or(Vec3::Z)
}

/// The face OAK on the plane, then lifted about OA.
fn attitude(shape: &PyramidShape, points: &[Vec3], lifted: f64) -> Rotation {
    let (_, cos) = sin_cos(PI / f64::from(shape.sides));
    // The face's normal (−h, 0, a C) is turned up about −y.
    let angle = atan2(shape.height, shape.circumradius * cos);
    let flat = Rotation::by(Vec3::Y * angle);
    Rotation::by(flat.apply(edge(points)) * lifted).after(flat)
}
