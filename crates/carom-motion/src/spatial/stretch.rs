//! One stretch of motion: from what the integration takes to the state of the body, and back.

use super::mode::{Equations, Mode, Vector, normalised, unpack};
use super::posture::{Height, Posture};
use super::{State, World};
use carom_num::Vec3;

/// A stretch of motion in one mode.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    pub(super) equations: Equations,
    /// Where the foot stands, or where the mass centre was at the start \[m\].
    place: Vec3,
    /// Velocity of the mass centre at the start of a flight [m/s].
    velocity: Vec3,
    gravity: Vec3,
}

impl Stretch {
    /// The stretch that starts from a state; `None` where numbers overflow. A support that is held stands on the plane.
    pub(super) fn from(world: &World, mode: Mode, state: &State) -> Option<Self> {
        let equations = Equations::of(world, mode)?;
        let (place, velocity) = if mode == Mode::Flight {
            (state.centre, state.velocity)
        } else {
            let foot = state.place(equations.arm());
            (Vec3::new(foot.x, foot.y, 0.0), Vec3::ZERO)
        };
        Some(Self { equations, place, velocity, gravity: world.gravity() })
    }

    fn flies(&self) -> bool {
        self.equations.mode() == Mode::Flight
    }

    /// The height of what heights are taken from.
    fn base(&self, elapsed: f64) -> Height {
        if !self.flies() {
            return Height::default();
        }
        let (z, rate, fall) = (self.place.z, self.velocity.z, self.gravity.z);
        let value = z + elapsed * (rate + 0.5 * fall * elapsed);
        Height { value, rate: rate + fall * elapsed, second: fall }
    }

    /// The instant at which so much time has passed.
    pub(super) fn posture(&self, y: &Vector, elapsed: f64) -> Posture {
        self.equations.posture(y, self.base(elapsed))
    }

    /// The state at which so much time has passed.
    pub(super) fn state(&self, y: &Vector, elapsed: f64) -> State {
        let (attitude, spin) = unpack(&normalised(y));
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
