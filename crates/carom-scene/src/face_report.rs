//! The faces of a part: what it can lie on, and how surely it stays there.

use crate::space::SpaceScene;
use crate::word::Word;
use carom_motion::planar::{Rest, RestKind, Shape};
use carom_motion::spatial;
use schemars::JsonSchema;
use serde::Serialize;

/// A face of a part: a side on which it can lie on level ground.
///
/// # Example
/// An L of 20 mm × 30 mm lies across its hollow as well; face 0 is the side that starts at its first corner.
/// ```
/// use carom_motion::planar::RestKind;
/// use carom_scene::{FaceReport, Scene, Word};
/// let part = "shape = \"polygon\"\nvertices = [[0, 0], [0.03, 0], [0.03, 0.01], [0.01, 0.01], [0.01, 0.02], [0, 0.02]]\nmass = 0.1\n";
/// let text = format!("[part]\n{part}[[plate]]\nslope = \"20 deg\"\n[contact]\nfriction = 0.2\nrestitution = 0\n[start]\nto_edge = 0.2\n");
/// let scene = Scene::parse("l.toml", &text)?;
/// let faces = FaceReport::of(&scene.feeder().part.body.shape);
/// assert_eq!((faces.len(), faces[2].kind), (5, Word(RestKind::Across)));
/// assert!((faces[0].inside_m[0] + faces[0].inside_m[1] - 0.03).abs() < 1e-15);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FaceReport {
    /// Its number, as results name it.
    pub face: usize,
    /// What lies below: a side, two points with a hollow between them, or the lowest point of an arc.
    pub kind: Word<RestKind>,
    /// From one outermost point that touches to the other one [m]; 0 of an arc.
    pub width_m: f64,
    /// Height of the mass centre above it [m].
    pub centre_height_m: f64,
    /// How far the mass centre is inside either end, along the face, the end that comes first counter-clockwise first [m]; negative where it is
    /// outside.
    pub inside_m: [f64; 2],
    /// The smaller of them [m]: the part is stable where it is positive. An arc has none, and is stable.
    pub margin_m: Option<f64>,
    /// How far the part can be tilted clockwise and counter-clockwise before it tips over [rad]; zeros where it does not stay.
    pub tips_after_rad: [f64; 2],
    /// True where the part stays on it on level ground.
    pub stable: bool,
    /// The share of all attitudes from which it tips onto this face, where it tips so slowly that it never swings on.
    pub quasi_static_share: f64,
}

impl FaceReport {
    /// The faces of a shape, by their numbers; none of a disc, which lies alike on all its rim.
    pub fn of(shape: &Shape) -> Vec<Self> {
        let numbered = shape.rests().iter().enumerate();
        numbered.map(|(face, rest)| Self::new(face, rest)).collect()
    }

    fn new(face: usize, rest: &Rest) -> Self {
        let inside = rest.inside();
        Self {
            face,
            kind: Word(rest.kind),
            width_m: (rest.to - rest.from).norm(),
            centre_height_m: rest.depth,
            inside_m: inside,
            margin_m: (rest.kind != RestKind::Arc).then(|| inside[0].min(inside[1])),
            tips_after_rad: rest.basin,
            stable: rest.share() > 0.0,
            quasi_static_share: rest.share(),
        }
    }
}

/// A face of a solid part's hull: on it the part can lie, or it rolls off.
///
/// # Example
/// A box of 40 × 10 × 20 mm. Face 0 is 40 × 20 mm and 5 mm below the mass centre: its solid angle is `4 atan(20·10/(5 √(20² + 5² + 10²)))`.
/// ```
/// use carom_scene::{SolidFaceReport, SpaceScene};
/// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
/// let faces = SolidFaceReport::of(&SpaceScene::parse("bar.toml", text)?);
/// let closed = (200.0 / (5.0 * 525f64.sqrt())).atan() / std::f64::consts::PI;
/// assert!(faces[0].stable && (faces[0].quasi_static_share - closed).abs() < 1e-12);
/// assert!((faces.iter().map(|face| face.quasi_static_share).sum::<f64>() - 1.0).abs() < 1e-12);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SolidFaceReport {
    /// Its number, as results name it.
    pub face: usize,
    /// Its corners, by their numbers, counter-clockwise as seen from outside.
    pub corners: Vec<usize>,
    /// Unit normal, outwards, in the part's axes.
    pub normal: [f64; 3],
    /// Height of the mass centre above it [m].
    pub centre_height_m: f64,
    /// How far inside the face the mass centre's projection is from the nearest side [m]; negative where it is outside. Of a rounded part the face ends where the round edges
    /// begin.
    pub margin_m: f64,
    /// True where the part stays on it on level ground.
    pub stable: bool,
    /// How far the part can be tilted at least before it tips over [rad]; 0 where it does not stay.
    pub tips_after_rad: f64,
    /// The side over which it tips so, or rolls off: the corners at its two ends.
    pub tips_over: [usize; 2],
    /// The face beyond that side.
    pub tips_onto: usize,
    /// The face as it is seen from the mass centre: its solid angle, as a share of 4π.
    pub solid_angle_share: f64,
    /// The share of all attitudes from which the part comes to rest on this face, where it is let go so gently that it never swings on: by solid angles, and with what rolls onto it from
    /// faces on which it does not stay.
    pub quasi_static_share: f64,
}

impl SolidFaceReport {
    /// The faces of a scene's part, by their numbers.
    pub fn of(scene: &SpaceScene) -> Vec<Self> {
        let (faces, rests) = (&scene.feeder().part.faces, scene.rests());
        let numbered = faces.iter().zip(&rests).enumerate();
        numbered.map(|(face, (of, rest))| Self::new(face, of, rest)).collect()
    }

    fn new(face: usize, of: &carom_feeder::spatial::Face, rest: &spatial::Rest) -> Self {
        Self {
            face,
            corners: of.corners.clone(),
            normal: of.normal.to_array(),
            centre_height_m: of.depth,
            margin_m: rest.stance.margin,
            stable: rest.stays,
            tips_after_rad: rest.tips_after,
            tips_over: rest.tips_over,
            tips_onto: rest.tips_onto,
            solid_angle_share: rest.seen,
            quasi_static_share: rest.share,
        }
    }
}
