//! What a spatial kind builds, and what both kinds read.

use super::PyramidShape;
use super::body::ThrownBody;
use super::homogeneous::Moments;
use crate::drawing::{INERTIA, MASS};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{Allowed, Kind};
use crate::roll::bodies::unfit;
use crate::section::{Section, expected, read_quantity};
use crate::unit::Dimension;
use carom_motion::spatial::{Body, BodyProblem, State};
use carom_num::{Mat3, Vec3};

/// Mass where none is written \[kg\].
const DEFAULT_MASS: f64 = 1.0;
/// More contacts than these at once are not enumerated.
pub(super) const MOST_POINTS: u32 = 12;
/// Fewer are no polygon.
const LEAST_POINTS: u32 = 3;
/// How many.
const POINTS: Kind = Kind::new(Dimension::Count, Allowed::Whole(LEAST_POINTS, MOST_POINTS));

/// A solid to draw, in the body's axes from its mass centre.
///
/// # Example
/// A box is drawn with its eight corners and six faces.
/// ```
/// # use carom_scene::*;
/// let text = "box = [0.06, 0.04, 0.02]\nmass = 1\nturn = 0\nheight = 0.2";
/// let brick = SpatialRollProblem::parse(SpatialRollKind::Body, "brick.toml", text, &[])?;
/// let SpatialDrawing { corners, faces, lines } = brick.drawing;
/// assert_eq!((corners.len(), faces.len(), lines.len()), (8, 6, 0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpatialDrawing {
    /// Corners \[m\].
    pub corners: Vec<Vec3>,
    /// The corners of each plane face, counter-clockwise as seen from outside.
    pub faces: Vec<Vec<usize>>,
    /// Lines beside the faces: a stool's legs.
    pub lines: Vec<[usize; 2]>,
}

/// A body, its names and its start.
pub(super) struct Setup {
    pub(super) body: Body,
    pub(super) points: Vec<String>,
    pub(super) drawing: SpatialDrawing,
    pub(super) faces: Vec<Vec3>,
    pub(super) pyramid: Option<PyramidShape>,
    pub(super) thrown: Option<ThrownBody>,
    pub(super) start: State,
}

/// Mass and the moments of inertia that are written.
pub(super) struct Heft {
    pub(super) mass: f64,
    across: Option<f64>,
    along: Option<f64>,
    /// They are those of no body, which has been said.
    impossible: bool,
}

fn too_slender(across: f64, along: f64) -> String {
    format!(
        "no body has the moments {across} kg m² across its axis and {along} kg m² about it: the latter is at most twice the former"
    )
}

impl Heft {
    /// Moments that no body has are told at once: whatever else is wrong with the file must not hide them.
    pub(super) fn read(root: &Section<'_>) -> Self {
        let value = |key, kind| root.quantity(key, kind).map(|q| q.value);
        let mass = value("mass", MASS).unwrap_or(DEFAULT_MASS);
        let (across, along) = (value("inertia_transverse", INERTIA), value("inertia_axial", INERTIA));
        let impossible = across.zip(along).is_some_and(|(across, along)| along > 2.0 * across);
        if let (true, Some(across), Some(along)) = (impossible, across, along) {
            unfit(root, "inertia_axial", too_slender(across, along));
        }
        Self { mass, across, along, impossible }
    }

    /// True where no moment is written.
    pub(super) fn is_open(&self) -> bool {
        self.across.is_none() && self.along.is_none()
    }

    /// The body on its points; the moments that are not written are those of the solid. `size` is the key that the distances of the points come from.
    pub(super) fn body(
        &self,
        root: &Section<'_>,
        solid: Moments,
        points: Vec<Vec3>,
        size: &'static str,
    ) -> Option<Body> {
        let (across, along) = (self.across.unwrap_or(solid.across), self.along.unwrap_or(solid.along));
        match Body::new(self.mass, Mat3::diagonal(across, across, along), points) {
            Ok(body) => Some(body),
            Err(_) if self.impossible => None,
            Err(_) if along > 2.0 * across => {
                let key = if self.along.is_some() { "inertia_axial" } else { "inertia_transverse" };
                unfit(root, key, too_slender(across, along));
                None
            }
            Err(problems) => {
                let of_mass = |p: &BodyProblem| matches!(p, BodyProblem::Mass(_));
                let key = if problems.iter().all(of_mass) { "mass" } else { size };
                let message = problems.first().map_or_else(
                    || "makes a moment of inertia that is too large or too small to compute with".to_owned(),
                    ToString::to_string,
                );
                unfit(root, key, message);
                None
            }
        }
    }
}

/// How many corners or supports; `None`, and a problem, where they are no polygon.
pub(super) fn count(root: &Section<'_>, key: &'static str, default: u32) -> Option<u32> {
    let Some(count) = root.quantity(key, POINTS) else { return (!root.has(key)).then_some(default) };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number up to 12")]
    Some(count.value as u32)
}

/// Three quantities in square brackets.
pub(super) fn triple(root: &Section<'_>, key: &'static str, kind: Kind) -> Option<Vec3> {
    let node = root.get(key)?;
    match &node.value {
        crate::node::Value::List(items) if items.len() == 3 => {
            let mut read = [None; 3];
            for ((value, item), axis) in read.iter_mut().zip(items).zip(["x", "y", "z"]) {
                let path = format!("{key}.{axis}");
                *value = read_quantity(&path, item, kind, root.sink()).map(|q| q.value);
            }
            let [x, y, z] = read;
            Some(Vec3::new(x?, y?, z?))
        }
        crate::node::Value::List(items) => {
            let message = format!("expected three numbers [x, y, z], found {}", items.len());
            let span = Some(node.span.clone());
            root.sink().push(Problem::new(ProblemKind::WrongValue, key, message, span));
            None
        }
        _ => {
            root.sink().push(expected("three numbers [x, y, z]", key, node));
            None
        }
    }
}
