//! How fast a body may turn while a mode lasts: bounds that hold for certain, by its energy and the length of a step.

use super::World;
use super::body::principal_range;
use super::mode::{Equations, Mode};
use super::posture::Posture;
use carom_num::Vec3;

/// Bounds on a mode's motion.
///
/// A mode conserves its energy, so that its kinetic energy never exceeds what it has when the mass centre is as low as it can come. With the least
/// and the largest moment λ₁, λ₃ about the foot:
///
/// ```text
/// |ω| ≤ Ω = √(2 T_most / λ₁),   |ω̇| ≤ (m g |s| + Ω² (λ₃ − λ₁)/2) / λ₁,   |ḧ| ≤ |d| (|ω̇| + Ω²)
/// ```
///
/// for a point at d from the foot, since `|ω × J ω| = |ω × (J − λ) ω|` for any λ. On an edge its one moment stands for both.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// Ω for the whole mode [rad/s].
    spin: f64,
    /// The largest moment of the weight about the foot [N m].
    pull: f64,
    least: f64,
    largest: f64,
    /// The foot of a mode on the plane, or the mass centre of a flight.
    from: Vec3,
    /// The foot's own acceleration along the normal: that of a flight.
    fall: f64,
    /// The edge that all turns about.
    along: Option<Vec3>,
}

/// Room for the rounding of the energy, in m g |s|.
const ROOM: f64 = 1e-9;

impl Bounds {
    /// Bounds for the mode that a body is in at an instant.
    pub(super) fn of(world: &World, equations: &Equations, at: &Posture) -> Self {
        let (arm, about) = (equations.arm(), equations.about());
        let along = match equations.mode() {
            Mode::Edge { along, .. } => Some(along),
            _ => None,
        };
        let (least, largest, lever) = match along {
            Some(u) => {
                let moment = u.dot(about * u);
                (moment, moment, arm - u * arm.dot(u))
            }
            None => {
                let (least, largest) = principal_range(about);
                (least, largest, arm)
            }
        };
        let pull = equations.weight() * lever.norm();
        let height = world.body().mass() * lever.dot(equations.gravity(at.turned));
        let most = 0.5 * at.spin.dot(about * at.spin) + height + (1.0 + ROOM) * pull;
        let fall = if equations.mode() == Mode::Flight { world.gravity().z.abs() } else { 0.0 };
        Self { spin: (2.0 * most.max(0.0) / least).sqrt(), pull, least, largest, from: arm, fall, along }
    }

    /// The angular acceleration at spins up to this.
    fn turning(&self, spin: f64) -> f64 {
        (self.pull + 0.5 * spin * spin * (self.largest - self.least)) / self.least
    }

    /// What the acceleration of a point's height does not exceed for a while from an instant on [m/s²].
    pub(super) fn bend(&self, spin: Vec3, arm: Vec3, length: f64) -> f64 {
        let most = self.spin.min(spin.norm() + self.turning(self.spin) * length);
        let d = arm - self.from;
        let reach = self.along.map_or(d, |u| d - u * d.dot(u)).norm();
        self.fall + reach * (self.turning(most) + most * most)
    }
}
