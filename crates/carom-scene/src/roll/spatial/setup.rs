//! What a spatial kind builds, and what both kinds read.

use super::PyramidShape;
use super::body::ThrownBody;
use super::homogeneous::Moments;
use crate::grammar::Section;
use crate::roll::bodies::unfit;
use carom_motion::spatial::{Body, BodyProblem, State};
use carom_num::{Mat3, Vec3};

/// More contacts than these at once are not enumerated.
pub(super) const MOST_POINTS: u32 = 12;

/// A solid to draw, in the body's axes from its mass centre.
///
/// # Example
/// A box is drawn with its eight corners and six faces.
/// ```
/// use carom_scene::*;
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
pub(super) struct MassSpec {
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

impl MassSpec {
    /// Moments that no body has are told at once: whatever else is wrong with the file must not hide them.
    pub(super) fn read(root: &Section<'_>) -> Self {
        let mass = root.number("mass");
        let (across, along) = (root.value("inertia_transverse"), root.value("inertia_axial"));
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

/// A count that has a default; `None` where what is written is none.
pub(super) fn count(root: &Section<'_>, key: &str) -> Option<u32> {
    if root.is_bad(key) {
        return None;
    }
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number up to 12")]
    Some(root.number(key) as u32)
}

/// A vector, SI.
pub(super) fn triple(root: &Section<'_>, key: &str) -> Option<Vec3> {
    root.vector(key).map(|[x, y, z]| Vec3::new(x.value, y.value, z.value))
}
