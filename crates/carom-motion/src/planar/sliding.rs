//! The most common mode, a lone body that slides on an obstacle with one contact: its accelerations with all that stays the same worked out
//! beforehand. They are asked for in every stage of every step.

use super::events::{Vector, rate, unpack};
use super::mode::Held;
use super::touching::Few;
use super::walker::Walker;
use super::{Feature, World};
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::elementary::sin_cos;

/// What slides on what.
#[derive(Clone, Copy)]
enum Features {
    /// A vertex, from the mass centre in the body's frame, rounded by a radius, on a face with this normal.
    Vertex { vertex: Vec2, radius: f64, normal: Vec2 },
    /// A face with this outward normal in the body's frame on an end.
    Face { outward: Vec2, end: Vec2 },
}

/// A lone body's one contact, which slides.
#[derive(Clone, Copy)]
pub(super) struct Sliding {
    features: Features,
    /// Tangential force per normal force.
    pull: f64,
    per_mass: f64,
    per_inertia: f64,
    gravity: Vec2,
}

impl Sliding {
    /// The rates of (x, y, angle, vx, vy, spin).
    ///
    /// ```text
    /// N (n·d/m + (a×n)(a×d)/J) = −bias − n·g,   d = n + pull t;   acceleration = g + N d/m,   angular = N (a×d)/J
    /// ```
    #[inline]
    fn rate(&self, y: &[f64; 6]) -> [f64; 6] {
        let (sin, cos) = sin_cos(y[2]);
        let (v, w) = (Vec2::new(y[3], y[4]), y[5]);
        let (normal, arm, bias) = match self.features {
            Features::Vertex { vertex, radius, normal } => {
                let r = vertex.rotated(cos, sin);
                (normal, r - normal * radius, -w * w * normal.dot(r))
            }
            Features::Face { outward, end } => {
                let normal = -outward.rotated(cos, sin);
                let arm = end - Vec2::new(y[0], y[1]);
                let bias = -2.0 * w * normal.turned_right().dot(v) + w * w * normal.dot(arm);
                (normal, arm, bias)
            }
        };
        let along = normal + normal.turned_right() * self.pull;
        let lever = arm.cross(along);
        let response = self.per_mass + arm.cross(normal) * lever * self.per_inertia;
        let force = (-bias - normal.dot(self.gravity)) / response;
        let a = self.gravity + along * (force * self.per_mass);
        [y[3], y[4], y[5], a.x, a.y, lever * force * self.per_inertia]
    }
}

impl World {
    /// The mode of a lone body with one contact that slides; `None` for other modes.
    pub(super) fn sliding(&self, held: &Few<Held>) -> Option<Sliding> {
        let ([body], Some(h), 1) = (&self.bodies[..], held.get(0), held.len()) else { return None };
        let obstacle = self.obstacles.get(h.pair.obstacle).filter(|_| h.slip != Slip::Sticks)?;
        let shape = &body.shape;
        let features = match h.pair.feature {
            Feature::VertexOnFace { vertex, face } => Features::Vertex {
                vertex: shape.vertices()[vertex],
                radius: shape.radius(),
                normal: obstacle.normal(face),
            },
            Feature::FaceOnEnd { face, end } => {
                Features::Face { outward: shape.face_normal(face), end: obstacle.end(end) }
            }
            Feature::VertexOnEnd { .. } => return None,
        };
        Some(Sliding {
            features,
            pull: h.slip.pull(obstacle.friction),
            per_mass: 1.0 / body.mass,
            per_inertia: 1.0 / body.inertia,
            gravity: self.gravity,
        })
    }
}

impl<const B: usize> Walker<'_, B> {
    /// The rates of the present mode.
    pub(super) fn rates(&self) -> impl Fn(&Vector<B>) -> Vector<B> + '_ {
        let (world, held) = (&*self.world, &self.held);
        let sliding = if B == 1 { world.sliding(held) } else { None };
        move |y| match &sliding {
            Some(sliding) => y.map(|y| sliding.rate(&y)),
            None => rate(y, &world.accelerate(held, &unpack(y))),
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::planar::kinematics::Pairing;
    use crate::planar::{Body, Obstacle, Shape};
    use carom_impact::planar::Law;

    #[test]
    fn a_sliding_contact_accelerates_as_any_mode() {
        let shape = Shape::new(vec![Vec2::new(-0.05, 0.0), Vec2::new(0.05, 0.01)], 0.002).unwrap();
        let body = Body { shape, mass: 0.3, inertia: 2.5e-4 };
        let obstacle = Obstacle::new(Vec2::new(-1.0, 0.2), Vec2::new(1.0, -0.3), 0.15, 0.0);
        let world = World::of_one(Vec2::new(0.3, -9.81), body, vec![obstacle], Law::Poisson);
        let features = [Feature::VertexOnFace { vertex: 1, face: 1 }, Feature::FaceOnEnd { face: 0, end: 1 }];
        for (i, angle) in [0.1, 0.9, 2.0, -1.3].into_iter().enumerate() {
            for (feature, slip) in features.into_iter().zip([Slip::Forward, Slip::Backward]) {
                let mut held: Few<Held> = Few::default();
                held.push(Held { pair: Pairing { body: 0, obstacle: 0, feature }, slip });
                let y =
                    [[0.9, -0.2, angle, 0.4 - angle, 0.3, 5.0 - 2.0 * f64::from(u8::try_from(i).unwrap())]];
                let general = rate(&y, &world.forces(&held, &unpack(&y)).acceleration);
                let ours = world.sliding(&held).unwrap().rate(&y[0]);
                for (a, b) in ours.iter().zip(&general[0]) {
                    assert!(
                        (a - b).abs() <= 1e-12 * (1.0 + b.abs()),
                        "{feature:?} {angle}: {ours:?} {general:?}"
                    );
                }
            }
        }
    }
}
