//! How a solid part rests on its faces, by the numbers that its scene gives them.

use super::SpaceScene;
use crate::roll::spatial::ThrownShape;
use carom_feeder::spatial::{Face, Part};
use carom_motion::spatial::{Rest, Stance};
use carom_num::Vec3;

/// How it rests on each face. A rounded part tips over the balls at its corners: what is between them decides, and a mass centre that is not there is seen from
/// as in the sharp part.
pub(super) fn rests(part: &Part, shape: &ThrownShape, centre: Vec3) -> Vec<Rest> {
    let (touches, radius) = shape.touching();
    let (found, radius) = match touches.rests(centre) {
        Some(found) => (found, radius),
        None => (shape.hull.rests(centre).unwrap_or_default(), 0.0),
    };
    // Faces of a box are numbered in another order than those of its hull.
    let place = |face: &Face| touches.faces().iter().position(|of| of.corners == face.corners);
    let places: Vec<usize> = part.faces.iter().filter_map(place).collect();
    let numbered = |rest: &Rest| Rest {
        stance: Stance { height: rest.stance.height + radius, ..rest.stance },
        tips_onto: places.iter().position(|place| *place == rest.tips_onto).unwrap_or_default(),
        ..*rest
    };
    places.iter().filter_map(|place| found.get(*place)).map(numbered).collect()
}

impl SpaceScene {
    /// How the part rests on each of its faces, by their numbers.
    ///
    /// # Example
    /// A box of 40 × 10 × 20 mm lies on its lower face and tips over the nearer sides, before and behind it, after atan(10/5).
    /// ```
    /// use carom_scene::SpaceScene;
    /// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
    /// let scene = SpaceScene::parse("bar.toml", text)?;
    /// let lower = scene.rests()[0];
    /// assert!((lower.tips_after - 2f64.atan()).abs() < 1e-12 && [4, 5].contains(&lower.tips_onto));
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn rests(&self) -> Vec<Rest> {
        rests(&self.feeder().part, self.shape(), self.mass_centre())
    }

    /// The share with which the part comes to rest on each face where it is let go gently.
    pub(crate) fn resting(&self) -> Vec<f64> {
        shares(&self.feeder().part, self.shape(), self.mass_centre())
    }
}

/// The same before there is a scene.
pub(super) fn shares(part: &Part, shape: &ThrownShape, centre: Vec3) -> Vec<f64> {
    rests(part, shape, centre).iter().map(|rest| rest.share).collect()
}
