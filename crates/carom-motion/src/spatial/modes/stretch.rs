//! One stretch of motion: from what the integration takes to the state of the body, and back.

use super::mode::{Equations, Mode, Vector, normalised, pack, unpack};
use crate::spatial::geometry::posture::{Height, Moving, Posture, Upright};
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::world::{Support, World};
use carom_num::{Rotation, Vec3};

/// The heights of all supports \[m\].
pub(in crate::spatial) type Heights = Vec<f64>;

/// The planes' normals, where a stretch starts.
pub(in crate::spatial) fn uprights(world: &World, attitude: Rotation) -> Vec<Upright> {
    let of = |normal: Vec3| Upright { normal, then: attitude.undo(normal) };
    world.planes().iter().map(|plane| of(plane.normal())).collect()
}

/// A stretch of motion in one mode.
#[derive(Clone, Debug)]
pub(in crate::spatial) struct Stretch {
    pub(in crate::spatial) equations: Equations,
    /// Heights at the start.
    heights: Heights,
    planes: Vec<Upright>,
    attitude: Rotation,
    /// Where the foot stands, or where the mass centre was at the start \[m\].
    place: Vec3,
    /// Velocity of the mass centre at the start of a flight [m/s].
    velocity: Vec3,
    spin: Vec3,
    gravity: Vec3,
}

impl Stretch {
    /// The stretch that starts from a state and heights; `None` where numbers overflow. A support that is held stands on the plane.
    pub(in crate::spatial) fn from(
        world: &World,
        mode: Mode,
        state: &State,
        heights: &Heights,
    ) -> Option<Self> {
        let equations = Equations::of(world, mode, state.attitude)?;
        let (place, velocity) = if mode == Mode::Flight {
            (state.centre, state.velocity)
        } else {
            let Support { feature, plane } = world.support(mode.foot().unwrap_or(0));
            let depth = feature.depth(state.attitude.undo(plane.normal()));
            (plane.onto(state.place(feature.point)) + plane.normal() * depth, Vec3::ZERO)
        };
        let (attitude, spin, gravity) = (state.attitude, state.spin, world.gravity());
        let planes = uprights(world, attitude);
        Some(Self { equations, heights: heights.clone(), planes, attitude, place, velocity, spin, gravity })
    }

    fn flies(&self) -> bool {
        self.equations.mode() == Mode::Flight
    }

    /// Where the integration starts.
    pub(in crate::spatial) fn first(&self) -> Vector {
        pack(Rotation::NONE, self.spin)
    }

    /// How far the mass centre of a flight has gone; a foot stays.
    fn base(&self, elapsed: f64) -> [Vec3; 3] {
        if !self.flies() {
            return [Vec3::ZERO; 3];
        }
        let gone = (self.velocity + self.gravity * (0.5 * elapsed)) * elapsed;
        [gone, self.velocity + self.gravity * elapsed, self.gravity]
    }

    /// The instant at which so much time has passed.
    pub(in crate::spatial) fn posture(&self, y: &Vector, elapsed: f64) -> Posture {
        self.equations.posture(y, self.base(elapsed))
    }

    /// The body at an instant.
    pub(in crate::spatial) fn moving(&self, at: &Posture) -> Moving {
        at.moving(self.attitude, self.place)
    }

    /// The height of a point of the body over the plane of a face.
    pub(in crate::spatial) fn height(&self, world: &World, support: usize, at: &Posture) -> Height {
        at.height(
            &self.planes[world.plane_of(support)],
            world.support(support).feature,
            self.heights[support],
        )
    }

    /// The normal of a support's plane at an instant, body axes.
    pub(in crate::spatial) fn up(&self, world: &World, support: usize, at: &Posture) -> Vec3 {
        at.turned.undo(self.planes[world.plane_of(support)].then)
    }

    /// The state at which so much time has passed.
    pub(in crate::spatial) fn state(&self, y: &Vector, elapsed: f64) -> State {
        let (turned, spin) = unpack(&normalised(y));
        let whole = self.attitude.after(turned);
        let attitude = Rotation::of(whole.to_array()).unwrap_or(whole);
        let arm = self.equations.arm();
        if self.flies() {
            let velocity = self.velocity + self.gravity * elapsed;
            let centre = self.place + (self.velocity + velocity) * (0.5 * elapsed);
            return State { centre, attitude, velocity, spin };
        }
        State {
            centre: self.place - attitude.apply(arm),
            attitude,
            velocity: attitude.apply(arm.cross(spin)),
            spin,
        }
    }
}
