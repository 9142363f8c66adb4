//! Motions of bodies, and how far two of them are apart.

use crate::case::{Body, Spin};
use carom_impact::{planar, spatial};
use carom_num::Vec3;
use carom_scene::{AnyImpact, ImpactProblem, SpatialImpactProblem};
use serde_json::Value;

/// Bodies that meet: how hard each is to move.
pub(crate) struct Bodies {
    /// Each as a body in space; `None` for one that nothing moves.
    inertia: Vec<Option<spatial::RigidBody>>,
    /// True of bodies in the plane.
    in_plane: bool,
    /// The contact of a body that is touched once: from its mass centre, and the normal.
    touch: Option<(Vec3, Vec3)>,
}

impl Bodies {
    /// Those of an impact file; `None` where it has none.
    pub(crate) fn of(impact: &Value) -> Option<Self> {
        Self::of_any(&AnyImpact::parse_json("case", &impact.to_string()).ok()?)
    }

    pub(crate) fn of_any(impact: &AnyImpact) -> Option<Self> {
        match impact {
            AnyImpact::Planar(problem) => Self::of_plane(problem),
            AnyImpact::Spatial(problem) => Self::of_space(problem),
        }
    }

    pub(crate) fn of_plane(problem: &ImpactProblem) -> Option<Self> {
        if let Some(group) = &problem.group {
            let inertia = group.bodies.iter().map(in_the_plane).collect();
            return Some(Self { inertia, in_plane: true, touch: None });
        }
        let body = problem.body.as_ref()?;
        let alone = planar::RigidBody {
            mass: body.mass,
            inertia: body.inertia,
            centre: carom_num::Vec2::ZERO,
            velocity: body.velocity,
            spin: body.spin,
        };
        let touch = match &body.touches[..] {
            [touch] => Some((flat(touch.arm), flat(touch.normal))),
            _ => None,
        };
        Some(Self { inertia: vec![in_the_plane(&alone)], in_plane: true, touch })
    }

    pub(crate) fn of_space(problem: &SpatialImpactProblem) -> Option<Self> {
        if let Some(group) = &problem.group {
            let fixed = group.fixed.iter();
            let inertia =
                group.bodies.iter().zip(fixed).map(|(body, fixed)| (!fixed).then_some(*body)).collect();
            return Some(Self { inertia, in_plane: false, touch: None });
        }
        let touch = match &problem.touches[..] {
            [touch] => Some((touch.arm, touch.normal)),
            _ => None,
        };
        Some(Self { inertia: vec![Some(problem.body?)], in_plane: false, touch })
    }

    /// What is wrong with the form of an answer: how many bodies, how many numbers, numbers that are none.
    pub(crate) fn wrong(&self, after: &[Body]) -> Option<String> {
        let (bodies, axes) = (self.inertia.len(), if self.in_plane { 2 } else { 3 });
        if after.len() != bodies {
            return Some(format!("{} bodies, and the case has {bodies}", after.len()));
        }
        let form = after.iter().enumerate().find_map(|(i, body)| {
            let spin = matches!(body.spin_rad_s, Spin::Plane(_)) == self.in_plane;
            if body.velocity_m_s.len() != axes || !spin {
                let spin = if self.in_plane { "one number" } else { "three numbers" };
                return Some(format!(
                    "body {}: a velocity of {axes} numbers and a spin of {spin} are asked",
                    i + 1
                ));
            }
            None
        });
        let too_large = || self.energy(after).is_none_or(|energy| !energy.is_finite());
        form.or_else(|| too_large().then(|| "a number is none, or too large".to_owned()))
    }

    /// True of what moves before: without that there is no share of it.
    pub(crate) fn moves(&self) -> bool {
        let energy = self.energy_before();
        energy.is_finite() && energy > 0.0
    }

    /// The kinetic energy before [J].
    pub(crate) fn energy_before(&self) -> f64 {
        self.inertia.iter().flatten().map(spatial::RigidBody::energy).sum()
    }

    /// The kinetic energy of a motion [J].
    pub(crate) fn energy(&self, after: &[Body]) -> Option<f64> {
        self.energy_of(after, |(v, w)| (v, w))
    }

    /// How far two motions are apart: the root of the kinetic energy of their difference as a share of that before.
    pub(crate) fn difference(&self, a: &[Body], b: &[Body]) -> Option<f64> {
        let apart = apart(a, b)?;
        Some((self.energy(&apart)? / self.energy_before()).sqrt())
    }

    /// The same of the spins alone.
    pub(crate) fn spin_difference(&self, a: &[Body], b: &[Body]) -> Option<f64> {
        let apart = apart(a, b)?;
        Some((self.energy_of(&apart, |(_, w)| (Vec3::ZERO, w))? / self.energy_before()).sqrt())
    }

    /// The restitution that is seen at the only contact: the quotient of the normal velocities after and before.
    pub(crate) fn restitution(&self, after: &[Body]) -> Option<f64> {
        let ((arm, normal), [body], [Some(before)]) = (self.touch?, after, &self.inertia[..]) else {
            return None;
        };
        let (v, w) = twist(body)?;
        let (then, now) =
            ((before.velocity + before.spin.cross(arm)).dot(normal), (v + w.cross(arm)).dot(normal));
        (then < 0.0).then(|| -now / then)
    }

    fn energy_of(&self, after: &[Body], part: impl Fn((Vec3, Vec3)) -> (Vec3, Vec3)) -> Option<f64> {
        if after.len() != self.inertia.len() {
            return None;
        }
        let mut sum = 0.0;
        for (body, after) in self.inertia.iter().zip(after) {
            let (velocity, spin) = part(twist(after)?);
            sum += body.map_or(0.0, |body| spatial::RigidBody { velocity, spin, ..body }.energy());
        }
        Some(sum)
    }
}

/// Velocity and spin in space.
fn twist(body: &Body) -> Option<(Vec3, Vec3)> {
    match (&body.velocity_m_s[..], body.spin_rad_s) {
        ([x, y], Spin::Plane(spin)) => Some((Vec3::new(*x, *y, 0.0), Vec3::new(0.0, 0.0, spin))),
        ([x, y, z], Spin::Space([a, b, c])) => Some((Vec3::new(*x, *y, *z), Vec3::new(a, b, c))),
        _ => None,
    }
}

/// The difference of two motions.
fn apart(a: &[Body], b: &[Body]) -> Option<Vec<Body>> {
    if a.len() != b.len() {
        return None;
    }
    let one = |(a, b): (&Body, &Body)| {
        let spin_rad_s = match (a.spin_rad_s, b.spin_rad_s) {
            (Spin::Plane(a), Spin::Plane(b)) => Spin::Plane(a - b),
            (Spin::Space(a), Spin::Space(b)) => Spin::Space(std::array::from_fn(|i| a[i] - b[i])),
            _ => return None,
        };
        let velocity_m_s = a.velocity_m_s.iter().zip(&b.velocity_m_s).map(|(a, b)| a - b).collect();
        Some(Body { velocity_m_s, spin_rad_s })
    };
    a.iter().zip(b).map(one).collect()
}

fn flat(v: carom_num::Vec2) -> Vec3 {
    Vec3::new(v.x, v.y, 0.0)
}

/// A body in the plane as one in space; `None` for one that nothing moves.
fn in_the_plane(body: &planar::RigidBody) -> Option<spatial::RigidBody> {
    body.mass.is_finite().then(|| spatial::RigidBody {
        mass: body.mass,
        inertia: carom_num::Mat3::diagonal(body.inertia, body.inertia, body.inertia),
        velocity: flat(body.velocity),
        spin: Vec3::new(0.0, 0.0, body.spin),
    })
}
