//! How fast a body may turn while a mode lasts: bounds that hold for certain, by its energy and the length of a step.

use super::mode::{Equations, Mode};
use crate::spatial::geometry::body::principal_range;
use crate::spatial::geometry::posture::{Bend, Most, Posture};
use crate::spatial::geometry::world::{Support, World};
use crate::tolerance::ENERGY_ROOM;
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
pub(in crate::spatial) struct Bounds {
    /// Ω for the whole mode [rad/s].
    spin: f64,
    /// The largest moment of the weight about the foot [N m].
    pull: f64,
    least: f64,
    largest: f64,
    /// The foot of a mode on the plane, or the mass centre of a flight.
    from: Vec3,
    /// The foot's own acceleration, world axes: that of a flight.
    fall: Vec3,
    /// The edge that all turns about.
    along: Option<Vec3>,
}

impl Bounds {
    /// Bounds for the mode that a body is in at an instant.
    pub(in crate::spatial) fn of(world: &World, equations: &Equations, at: &Posture) -> Self {
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
        let most = 0.5 * at.spin.dot(about * at.spin) + height + (1.0 + ENERGY_ROOM) * pull;
        let fall = if equations.mode() == Mode::Flight { world.gravity() } else { Vec3::ZERO };
        Self { spin: (2.0 * most.max(0.0) / least).sqrt(), pull, least, largest, from: arm, fall, along }
    }

    /// The angular acceleration at spins up to this.
    fn turning(&self, spin: f64) -> f64 {
        (self.pull + 0.5 * spin * spin * (self.largest - self.least)) / self.least
    }

    /// What a spin, its rate and the acceleration of the mass centre do not exceed from an instant on.
    pub(in crate::spatial) fn most(&self, spin: Vec3, time: f64) -> Most {
        let most = self.spin.min(spin.norm() + self.turning(self.spin) * time);
        let turning = self.turning(most);
        let acceleration = self.fall.norm() + self.from.norm() * (turning + most * most);
        Most { spin: most, turning, acceleration }
    }

    /// A bound on the acceleration of a support's height from an instant on; the normal of its plane is `up` in body axes.
    pub(in crate::spatial) fn bend(
        &self,
        [spin, up]: [Vec3; 2],
        Support { feature, plane }: &Support<'_>,
        length: f64,
    ) -> Bend {
        let Most { spin: most, turning, .. } = self.most(spin, length);
        let d = feature.point - self.from;
        let reach = self.along.map_or(d, |u| d - u * d.dot(u)).norm();
        let own = self.fall.dot(plane.normal()).abs() + reach * (turning + most * most);
        Bend::own(own).and(feature.bend([up, spin], [most, turning], length))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::geometry::body::Body;
    use crate::spatial::geometry::state::{Pose, State};
    use crate::spatial::geometry::supports::Supports;
    use crate::spatial::modes::mode::Vector;
    use crate::spatial::modes::stretch::Stretch;
    use carom_num::ode8::step_plain;
    use carom_num::{Mat3, Rotation};

    fn world() -> World {
        let turn = Rotation::by(Vec3::new(0.7, -0.2, 1.9));
        let inertia = turn.turn(Mat3::diagonal(0.9, 0.5, 0.6));
        let supports = vec![
            Vec3::new(1.0, 0.2, -0.3),
            Vec3::new(-0.4, 0.9, 0.1),
            Vec3::new(0.1, -0.6, 0.8),
            Vec3::new(0.3, 0.4, -1.2),
        ];
        let body = Body::new(1.3, (inertia + inertia.transposed()) * 0.5, supports).unwrap();
        World::new(body, Vec3::new(2.0, 1.0, -9.0)).unwrap()
    }

    /// The largest quotient of a height's acceleration and its bound, while a mode goes on for some time.
    fn largest_share(mode: Mode, spin: Vec3) -> f64 {
        let world = world();
        let state = State::standing(world.body(), 0, Rotation::by(Vec3::new(-0.8, 0.4, 0.3)), spin);
        let stretch = Stretch::from(&world, mode, &state, &vec![0.0; world.count()]).unwrap();
        let rates = |y: &Vector| stretch.equations.rate(y);
        let first = stretch.first();
        let at = stretch.posture(&first, 0.0);
        let bounds = Bounds::of(&world, &stretch.equations, &at);
        let (mut y, mut worst, step) = (first, 0.0_f64, 0.01);
        let start_spin = at.spin;
        for k in 0..300 {
            let elapsed = step * f64::from(k);
            let at = stretch.posture(&y, elapsed);
            for support in 0..world.count() {
                let own = world.support(support);
                let second = stretch.height(&world, support, &at).second.abs();
                // From the start on for as long as this, and from here on for no time at all.
                for spin in [(start_spin, elapsed), (at.spin, 0.0)] {
                    let bend = bounds.bend([spin.0, at.up], &own, spin.1).most;
                    worst = worst.max(if second > 1e-12 { second / bend } else { 0.0 });
                }
            }
            y = step_plain(y, rates(&y), step, rates).end;
        }
        worst
    }

    #[test]
    fn no_height_accelerates_beyond_its_bound() {
        let world = world();
        let edge = Mode::holding(&world, [0, 3].into_iter().collect(), Pose::NONE);
        let Mode::Edge { along, .. } = edge else { panic!("two supports make an edge") };
        for size in [0.0, 1.0, 7.0] {
            let spin = Vec3::new(0.4, -0.8, 0.5) * size;
            for (mode, spin) in [
                (Mode::Pivot { support: 0, held: Supports::one(0) }, spin),
                (Mode::Flight, spin),
                (edge, along * size),
            ] {
                let share = largest_share(mode, spin);
                assert!(share <= 1.0 && share > 0.05, "{mode:?} at {size}: {share}");
            }
        }
    }
}
