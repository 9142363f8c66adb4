//! On which faces a body may come to rest: how far it must be tilted to leave each, over which side, and how many directions lead to each.

use super::hull::sides;
use super::polyhedron::{Face, Polyhedron, Stance};
use crate::tolerance::OVER_A_SIDE;
use carom_num::Vec3;
use carom_num::elementary::atan2;
use std::f64::consts::PI;

/// How a body stands on a face on level ground, and how it leaves it.
///
/// # Example
/// A cube of 1 m tips over after 45°, and each of its faces is a sixth of all that is around its centre.
/// ```
/// use carom_motion::spatial::{Polyhedron, Rest, examples};
/// use carom_num::Vec3;
/// let cube = Polyhedron::of_points(&examples::cube_corners(), 1e-9).unwrap();
/// let rests = cube.rests(Vec3::new(0.5, 0.5, 0.5)).unwrap();
/// for Rest { stays, tips_after, share, .. } in rests {
///     assert!(stays && (tips_after - std::f64::consts::FRAC_PI_4).abs() < 1e-15);
///     assert!((share - 1.0 / 6.0).abs() < 1e-15);
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Height of the mass centre, and how far inside the face it is.
    pub stance: Stance,
    /// True where the body stays: the mass centre is over the inside of the face. One that is over a side is balanced, and does not stay.
    pub stays: bool,
    /// By how much the body can be tilted at least before it tips over \[rad\]: up to where the mass centre is above a side. 0 where it does not stay.
    pub tips_after: f64,
    /// The side over which it tips so, or over which it rolls off where it does not stay: the vertices at its two ends.
    pub tips_over: [usize; 2],
    /// The face beyond that side.
    pub tips_onto: usize,
    /// The face as it is seen from the mass centre: its solid angle, as a share of 4π.
    pub seen: f64,
    /// The share of all directions from which the body comes to rest on it where it is let go gently: the share of the face as it is seen, and of those that
    /// roll off onto it. 0 where it does not stay.
    pub share: f64,
}

impl Polyhedron {
    /// How a body with this mass centre \[m\] rests on each of its faces, by their numbers; `None` where the mass centre is not inside.
    ///
    /// A direction belongs to the face through which it leaves the body: with it downwards the body is let go without speed, and lands on that face. Where
    /// the body does not stay there, it rolls off over the side that the mass centre is farthest beyond, from face to face, its mass centre lower each time. The
    /// shares of all faces add up to 1.
    ///
    /// # Limits
    /// Nothing swings, bounces or slides. The shares are those of a body that tips over its corners and sides without speed where it stays on every face and the mass
    /// centre is over the inside of every edge, as in a box. Any other body that stands on a corner need not lie down on the face that is below its mass centre, and where the
    /// mass centre is beyond a corner of a face it may leave the face over another side than the one that is taken: there the shares are an estimate.
    ///
    /// # Source
    /// The solid angle as a measure: G. Boothroyd, C. Ho, Natural resting aspects of parts for automatic handling, J. Eng. Ind. 99 (1977) 314; K. Goldberg, B. Mirtich,
    /// Y. Zhuang, J. Craig, B. Carlisle, J. Canny, Part pose statistics: estimators and experiments, IEEE Trans. Robotics Automation 15 (1999) 849, their quasi-static
    /// estimator. The solid angle of a triangle: A. Van Oosterom, J. Strackee, The solid angle of a plane triangle, IEEE Trans. Biomed. Eng. 30 (1983) 125.
    ///
    /// # Example
    /// A bar of 1 × 1 × 4 m ends on an end as often as `4 atan(1/(8√(16/4 + 1/2)))/4π` says: the solid angle of a rectangle 2a × 2b at the height h is `4 atan(a b/(h √(h² + a² + b²)))`.
    /// ```
    /// use carom_motion::spatial::Polyhedron;
    /// use carom_num::Vec3;
    /// let corner = |i: usize| Vec3::new((i & 1) as f64, (i >> 1 & 1) as f64, 4.0 * (i >> 2) as f64);
    /// let bar = Polyhedron::of_points(&(0..8).map(corner).collect::<Vec<_>>(), 1e-9).unwrap();
    /// let rests = bar.rests(Vec3::new(0.5, 0.5, 2.0)).unwrap();
    /// let end = bar.faces().iter().position(|face| face.normal == Vec3::Z).unwrap();
    /// let closed = (0.25 / (2.0 * 4.5_f64.sqrt())).atan() / std::f64::consts::PI;
    /// assert!((rests[end].share - closed).abs() < 1e-15);
    /// ```
    pub fn rests(&self, centre: Vec3) -> Option<Vec<Rest>> {
        let reach = self.vertices().iter().map(|r| (*r - centre).norm()).fold(0.0, f64::max);
        let rests = (0..self.faces().len()).map(|face| self.rest_on(face, centre, OVER_A_SIDE * reach));
        let mut rests = rests.collect::<Option<Vec<Rest>>>()?;
        let mut highest_first: Vec<usize> = (0..rests.len()).collect();
        highest_first.sort_by(|a, b| rests[*b].stance.height.total_cmp(&rests[*a].stance.height));
        for face in highest_first {
            let Rest { stays, tips_onto, share, .. } = rests[face];
            // Over a side that the mass centre is beyond the next face is lower, but for rounding: then the body stays where it is.
            if !stays && rests[tips_onto].stance.height < rests[face].stance.height {
                rests[tips_onto].share += share;
                rests[face].share = 0.0;
            }
        }
        Some(rests)
    }

    /// What is known of one face alone: `share` is what is seen of it. `None` where the mass centre is not behind it.
    fn rest_on(&self, face: usize, centre: Vec3, least: f64) -> Option<Rest> {
        let stance = self.stance(face, centre).filter(|stance| stance.height > 0.0)?;
        let corners = &self.faces()[face].corners;
        let (side, _) = sides(corners)
            .map(|side| (side, self.inside(face, side, centre)))
            .min_by(|a, b| a.1.total_cmp(&b.1))?;
        let (from, to) = side;
        // The face on the other side goes along it the other way.
        let beyond = |of: &Face| sides(&of.corners).any(|other| other == (to, from));
        let stays = stance.margin > least;
        let seen = self.solid_angle(corners, centre) / (4.0 * PI);
        Some(Rest {
            stance,
            stays,
            tips_after: if stays { atan2(stance.margin, stance.height) } else { 0.0 },
            tips_over: [from, to],
            tips_onto: self.faces().iter().position(beyond)?,
            seen,
            share: seen,
        })
    }

    /// The solid angle of a face as it is seen from a place behind it \[sr\].
    fn solid_angle(&self, corners: &[usize], from: Vec3) -> f64 {
        let at = |k: usize| self.vertices()[corners[k]] - from;
        let triangle = |k: usize| {
            let [a, b, c] = [at(0), at(k), at(k + 1)];
            let [x, y, z] = [a, b, c].map(Vec3::norm);
            let beside = x * y * z + a.dot(b) * z + a.dot(c) * y + b.dot(c) * x;
            2.0 * atan2(a.dot(b.cross(c)), beside)
        };
        (1..corners.len().saturating_sub(1)).map(triangle).sum()
    }
}
