//! What supports that are kept make of a state: they stand on the plane, and the body turns about their line or not at all.

use super::mode::{Mode, normal_of};
use crate::spatial::geometry::state::{Pose, State, measured};
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::World;
use crate::spatial::modes::grip::{Bearing, Grip};
use crate::tolerance::MOST_SETTLING_TURN;
use carom_num::{Rotation, Vec3};

/// The direction in the body that must come to lie along the plane's normal, given what it is near to; `None` where the held supports leave it open.
fn wanted_normal(world: &World, mode: Mode, up: Vec3, pose: Pose) -> Option<Vec3> {
    match mode {
        Mode::Flight | Mode::Pivot { .. } | Mode::Slides { .. } => None,
        Mode::Edge { along, .. } => (up - along * up.dot(along)).unit(),
        Mode::Rest { held } => {
            let normal = normal_of(world, held, pose)?;
            Some(if normal.dot(up) < 0.0 { -normal } else { normal })
        }
    }
}

/// The state with its held supports on the plane, at rest: the least turn that levels them; the rest of the spin stays. Supports of several planes keep the
/// attitude that they have.
pub(in crate::spatial) fn settled(world: &World, mode: Mode, state: &State) -> State {
    let Some(foot) = mode.foot() else { return *state };
    // What holds several normals holds the place as well: nothing but the motion is to be taken back.
    if world.has_pairs(mode.held(world)) {
        return match mode {
            Mode::Rest { .. } => State { velocity: Vec3::ZERO, spin: Vec3::ZERO, ..*state },
            _ => *state,
        };
    }
    let plane = world.support(foot).plane;
    let up = state.attitude.undo(plane.normal());
    let wanted =
        wanted_normal(world, mode, up, state.pose()).filter(|_| world.is_of_one_plane(mode.held(world)));
    let turn = wanted.map_or(Vec3::ZERO, |normal| normal.cross(up));
    // In body axes: the normal n goes to where e is, R e' = z with e' = n.
    let attitude = if turn.norm() > 0.0 && turn.norm() < MOST_SETTLING_TURN {
        let turned = state.attitude.after(Rotation::by(turn));
        Rotation::of(turned.to_array()).unwrap_or(turned)
    } else {
        state.attitude
    };
    let spin = match mode {
        Mode::Rest { .. } => Vec3::ZERO,
        Mode::Edge { along, .. } => along * along.dot(state.spin),
        _ => state.spin,
    };
    let arm = world.arm(foot, Pose { attitude, ..state.pose() });
    let centre = plane.onto(state.place(arm)) - attitude.apply(arm);
    State { centre, attitude, velocity: attitude.apply(arm.cross(spin)), spin }
}

/// A small displacement: of the mass centre, world axes \[m\], and a turn, body axes \[rad\].
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Displacement {
    moved: Vec3,
    turn: Vec3,
}

impl Displacement {
    /// The least one, by the body's own mass, that puts supports where they touch.
    ///
    /// Heights of hops are counted on from touch to touch, and the place of the body does not follow the last digits of that.
    pub(in crate::spatial) fn putting_down(world: &World, held: Supports, state: &State) -> Self {
        let pose = state.pose();
        let bearing = |support: usize| {
            let own = Bearing::smooth(world, support, pose);
            Bearing { drive: own.up() * measured(world, state, None, support), ..own }
        };
        let bearings: Vec<Bearing> = held.iter().map(bearing).collect();
        let (moved, turn) = Grip { body: world.body(), bearings: &bearings }.taken_back();
        Self { moved: pose.attitude.apply(moved), turn }
    }

    /// The one that has led from a pose to another one.
    pub(in crate::spatial) fn between(before: Pose, after: Pose) -> Self {
        let [w, x, y, z] = before.attitude.inverse().after(after.attitude).to_array();
        Self { moved: after.centre - before.centre, turn: Vec3::new(x, y, z) * 2.0_f64.copysign(w) }
    }

    /// No place of the body goes farther \[m\].
    pub(in crate::spatial) fn most(&self, world: &World) -> f64 {
        self.moved.norm().max(self.turn.norm() * world.body().reach())
    }

    /// How far a place of the body goes, which is so far from the mass centre in its axes; world axes \[m\].
    pub(in crate::spatial) fn of(&self, arm: Vec3, attitude: Rotation) -> Vec3 {
        self.moved + attitude.apply(self.turn.cross(arm))
    }

    /// Where it brings a body.
    pub(in crate::spatial) fn from(&self, state: &State) -> State {
        let turned = state.attitude.after(Rotation::by(self.turn));
        let attitude = Rotation::of(turned.to_array()).unwrap_or(turned);
        State { centre: state.centre + self.moved, attitude, ..*state }
    }
}

/// The spin of a body once a whole edge holds it too: the impulses act on that edge, so that the angular momentum about it stays.
pub(in crate::spatial) fn spin_on(world: &World, mode: Mode, state: &State) -> Vec3 {
    let body = world.body();
    match mode {
        Mode::Edge { ends: [end, _], along, .. } => {
            let arm = world.arm(end, state.pose());
            let moved = arm.cross(state.attitude.undo(state.velocity)) * body.mass();
            let momentum = body.inertia() * state.spin - moved;
            along * (along.dot(momentum) / along.dot(body.inertia_about(arm) * along))
        }
        Mode::Rest { .. } => Vec3::ZERO,
        _ => state.spin,
    }
}

/// All supports of a set that is held in this mode.
pub(in crate::spatial) fn all_held(world: &World, mode: Mode, kept: Supports) -> bool {
    kept.difference(mode.held(world)).is_empty()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spatial::geometry::body::Body;
    use carom_num::Mat3;

    fn cube() -> World {
        let corner = |x: f64, y: f64| Vec3::new(x, y, -0.5);
        let corners = vec![corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
        World::new(Body::new(1.0, Mat3::IDENTITY, corners).unwrap(), -Vec3::Z).unwrap()
    }

    #[test]
    fn kept_supports_come_to_lie_on_the_plane() {
        let world = cube();
        let attitude = Rotation::by(Vec3::Z * 0.7).after(Rotation::by(Vec3::new(1e-6, -3e-6, 0.0)));
        let spin = Vec3::new(0.1, 0.2, 0.3);
        let state = State::standing(world.body(), 1, attitude, spin);
        for kept in [[1, 2].into_iter().collect::<Supports>(), (0..4).collect()] {
            let mode = Mode::holding(&world, kept, state.pose());
            let after = settled(&world, mode, &state);
            for i in kept.iter() {
                let height = after.place(world.point(i)).z;
                assert!(height.abs() < 1e-15, "{i}: {height}");
            }
            let spin = if kept.len() == 2 { Vec3::Y * 0.2 } else { Vec3::ZERO };
            assert_eq!(after.spin, spin);
        }
    }
}
