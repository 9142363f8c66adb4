//! The Taylor series of a lone body's motion with one contact, and what they say.

use crate::evaluated::{Quantity, evaluated};
use crate::planar::contact::{World, kinematics::Turn};
use crate::planar::geometry::{Feature, State};
use crate::planar::modes::mode::Held;
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::taylor::{integral, reach, spread, value};

/// What does not change during a step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Given {
    pub(super) held: Held,
    /// The state at the start.
    pub(super) start: State,
    /// The body's turn there.
    pub(super) turn: Turn,
    /// The contact's frame at the start.
    pub(super) tangent: Vec2,
    pub(super) normal: Vec2,
    /// The vertex from the mass centre, or the end, in that frame.
    pub(super) arm: Vec2,
    pub(super) radius: f64,
    /// Gravity in that frame.
    pub(super) gravity: Vec2,
    /// Tangential force per normal force.
    pub(super) pull: f64,
    pub(super) mass: f64,
    pub(super) inertia: f64,
    pub(super) per_mass: f64,
    pub(super) per_inertia: f64,
}

/// The series of one step: the coefficients of what changes, in powers of the time since its start [s].
#[derive(Clone, Debug)]
pub(super) struct Expansion<const P: usize> {
    pub(super) given: Given,
    /// Cosine and sine of the body's turn since the start.
    pub(super) cos: [f64; P],
    pub(super) sin: [f64; P],
    pub(super) spin: [f64; P],
    pub(super) slip: [f64; P],
    /// The contact from the mass centre, along t and n.
    pub(super) along: [f64; P],
    pub(super) across: [f64; P],
    /// Forces on the body; one order less than the motion.
    pub(super) force: [f64; P],
    pub(super) friction: [f64; P],
    /// The spin times the cosine and times the sine of the turn.
    pub(super) turning: ([f64; P], [f64; P]),
    /// Spin times what it bends the contact's way with; see the kinds of contact.
    pub(super) bending: [f64; P],
    /// Angular acceleration per normal force of what slides; the inertia about the contact of what rolls.
    pub(super) lever: [f64; P],
    /// Angular acceleration of what slides or rolls.
    pub(super) angular: [f64; P],
    /// Velocity of the mass centre along t, of a vertex; the spin's square, of a face.
    pub(super) way: [f64; P],
    /// 1 over the normal acceleration per normal force, or over the inertia about the contact, at the start.
    pub(super) over: f64,
}

/// Bounds on how far quantities of a step differ from what they are at its start.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Spreads {
    pub(super) force: f64,
    pub(super) friction: f64,
    pub(super) slip: f64,
    pub(super) spin: f64,
    /// Of the place of the contact along what it slides on.
    pub(super) way: f64,
    pub(super) cos: f64,
    pub(super) sin: f64,
}

impl Given {
    /// What is held on what, from here on; `None` where the mode is not a lone body's one contact between a vertex and a face.
    pub(super) fn of(world: &World, held: &Held, state: &State) -> Option<Self> {
        let ([body], Some(obstacle)) = (&world.bodies[..], world.obstacles.get(held.pair.obstacle)) else {
            return None;
        };
        let (shape, turn) = (&body.shape, Turn::of(state));
        let mut radius = 0.0;
        let (normal, arm) = match held.pair.feature {
            Feature::VertexOnFace { vertex, face } => {
                radius = shape.radius_of(vertex);
                (obstacle.normal(face), turn.apply(shape.vertices()[vertex]))
            }
            // Normals point into the body that is followed, and so against the outward normal of its own face.
            Feature::FaceOnEnd { face, end } => {
                (-turn.apply(shape.face_normal(face)), obstacle.end(end) - state.pose.centre)
            }
            Feature::VertexOnEnd { .. } => return None,
        };
        let tangent = normal.turned_right();
        let seen = |v: Vec2| Vec2::new(tangent.dot(v), normal.dot(v));
        Some(Self {
            held: *held,
            start: *state,
            turn,
            tangent,
            normal,
            arm: seen(arm),
            radius,
            gravity: seen(world.gravity),
            pull: held.slip.pull(obstacle.friction),
            mass: body.mass,
            inertia: body.inertia,
            per_mass: 1.0 / body.mass,
            per_inertia: 1.0 / body.inertia,
        })
    }

    /// True where a vertex of the body is in touch: the frame rests.
    pub(super) fn by_vertex(&self) -> bool {
        matches!(self.held.pair.feature, Feature::VertexOnFace { .. })
    }
}

impl<const P: usize> Expansion<P> {
    /// The series from here on.
    pub(super) fn of(given: Given) -> Self {
        let z = [0.0; P];
        let mut it = Self {
            given,
            cos: z,
            sin: z,
            spin: z,
            slip: z,
            along: z,
            across: z,
            force: z,
            friction: z,
            turning: (z, z),
            bending: z,
            lever: z,
            angular: z,
            way: z,
            over: 0.0,
        };
        it.expand_from(given);
        it
    }

    /// The series of the same mode from another start, in the place of these.
    pub(super) fn expand_from(&mut self, given: Given) {
        self.given = given;
        let (twist, arm) = (given.start.twist, given.arm);
        (self.cos[0], self.sin[0], self.spin[0]) = (1.0, 0.0, twist.spin);
        (self.along[0], self.across[0]) = (arm.x, arm.y);
        if given.by_vertex() {
            self.across[0] -= given.radius;
        }
        self.way[0] = given.tangent.dot(twist.velocity);
        if given.held.slip != Slip::Sticks {
            self.slip[0] = self.way[0] - twist.spin * self.across[0];
        }
        self.expand();
        self.spin[P - 1] = evaluated(Quantity::Coefficient, self.spin[P - 1]);
    }

    /// Coefficients of a vector that turns with the body, from its components at the start.
    #[inline(always)]
    pub(super) fn turned(&self, v: Vec2, i: usize) -> (f64, f64) {
        (v.x * self.cos[i] - v.y * self.sin[i], v.y * self.cos[i] + v.x * self.sin[i])
    }

    /// How long a step may be so that what the series leaves out of the spin, of the slip and of the turn stays below these tolerances [s]. It is
    /// found in a unit of time [s], so that it scales with it to the last digit.
    pub(super) fn reach(&self, (spin, slip, turn): (f64, f64, f64), unit: f64) -> f64 {
        let excess = |i: usize| {
            let turning = self.cos[i].abs().max(self.sin[i].abs());
            (self.spin[i].abs() / spin).max(self.slip[i].abs() / slip).max(turning / turn)
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "a small order")]
        let reach = |i: usize| unit * reach(excess(i) * unit.powi(i as i32), i as u32);
        reach(P - 1).min(reach(P - 2))
    }

    /// The state after a time within the step [s].
    pub(super) fn state(&self, t: f64) -> State {
        let Given { start, tangent, normal, arm, radius, .. } = self.given;
        let turned = integral(&self.spin, t);
        let (spin, slip) = (value(&self.spin, t), value(&self.slip, t));
        let (cos, sin) = (value(&self.cos, t), value(&self.sin, t));
        let mut state = start;
        let (tangent, normal, along, across) = if self.given.by_vertex() {
            let vertex = arm.rotated(cos, sin);
            let way = integral(&self.slip, t) - radius * turned - (vertex.x - arm.x);
            state.pose.centre += tangent * way - normal * (vertex.y - arm.y);
            (tangent, normal, vertex.x, vertex.y - radius)
        } else {
            let along = value(&self.along, t);
            let end = start.pose.centre + tangent * arm.x + normal * arm.y;
            let (tangent, normal) = (tangent.rotated(cos, sin), normal.rotated(cos, sin));
            state.pose.centre = end - tangent * along - normal * arm.y;
            (tangent, normal, along, arm.y)
        };
        state.pose.angle += turned;
        state.twist.spin = spin;
        state.twist.velocity = tangent * (slip + spin * across) - normal * (spin * along);
        state
    }

    /// How far the quantities that event functions are made of change within a step of this length [s].
    pub(super) fn spreads(&self, length: f64) -> Spreads {
        let of = |a: &[f64; P]| spread(a, length);
        let slip = of(&self.slip);
        let spin = of(&self.spin);
        let way = if self.given.by_vertex() {
            length * (self.slip[0].abs() + slip + self.given.radius * (self.spin[0].abs() + spin))
        } else {
            of(&self.along)
        };
        let (cos, sin) = (of(&self.cos), of(&self.sin));
        Spreads { force: of(&self.force), friction: of(&self.friction), slip, spin, way, cos, sin }
    }

    /// A bound on the angular acceleration within a step of this length [rad/s²].
    pub(super) fn most_angular(&self, length: f64) -> f64 {
        let mut most = 0.0;
        for i in (1..P).rev() {
            most = most * length + i as f64 * self.spin[i].abs();
        }
        most
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::planar::contact::kinematics::Pairing;
    use crate::planar::contact::touching::Few;
    use crate::planar::geometry::{Body, Obstacle, Shape};
    use crate::planar::modes::watch::{Watch, Watched};
    use crate::planar::walk::events::{pack, rate, unpack};
    use carom_impact::Law;
    use carom_num::ode8::step_plain;

    /// Rounding of forces, places and velocities that are sums of some dozen terms, as a share.
    const AS_EQUATIONS: f64 = 1e-12;

    /// A rounded rod on an inclined obstacle.
    fn world() -> World {
        let shape = Shape::new(vec![Vec2::new(-0.05, 0.0), Vec2::new(0.05, 0.01)], 0.002).unwrap();
        let body = Body { shape, mass: 0.3, inertia: 2.5e-4 };
        let obstacle = Obstacle::new(Vec2::new(-1.0, 0.2), Vec2::new(1.0, -0.3), 0.15, 0.0);
        World::of_one(Vec2::new(0.3, -9.81), body, vec![obstacle], Law::Poisson)
    }

    /// A state of this angle, spin and slip in which the contact is closed and stays so.
    fn touching(world: &World, held: &Held, (angle, spin, slip): (f64, f64, f64)) -> State {
        let mut state = State::default();
        (state.pose.angle, state.twist.spin) = (angle, spin);
        let k = world.kinematics(&[state], held.pair);
        state.pose.centre -= k.normal * k.gap;
        let k = world.kinematics(&[state], held.pair);
        state.twist.velocity = k.tangent() * (slip - k.slip) - k.normal * k.approach;
        state
    }

    #[test]
    fn the_series_follow_the_equations_of_motion() {
        let world = world();
        let features = [Feature::VertexOnFace { vertex: 1, face: 1 }, Feature::FaceOnEnd { face: 0, end: 1 }];
        for angle in [0.1, 0.9, 2.0, -1.3] {
            for feature in features {
                for (slip, moving) in [(Slip::Forward, 0.7), (Slip::Backward, -0.7), (Slip::Sticks, 0.0)] {
                    let pair = Pairing { body: 0, obstacle: 0, feature };
                    let held = Held { pair, slip };
                    let state = touching(&world, &held, (angle, 3.0 - angle, moving));
                    let series = Expansion::<18>::of(Given::of(&world, &held, &state).unwrap());
                    let mut list: Few<Held> = Few::default();
                    list.push(held);
                    let forces = world.forces(&list, &[state]);
                    let c = forces.contacts.get(0).unwrap();
                    assert!(
                        (series.force[0] - c.normal_force).abs()
                            < AS_EQUATIONS * (1.0 + c.normal_force.abs())
                    );
                    assert!(
                        (series.friction[0] - c.tangential_force).abs()
                            < AS_EQUATIONS * (1.0 + c.normal_force.abs())
                    );
                    // Many small steps of the general method come to the same place.
                    let of = |y: &[[f64; 6]; 1]| rate(y, &world.forces(&list, &unpack(y)).acceleration);
                    let (time, steps) = (series.reach((1e-13, 1e-14, 1e-14), 0.1), 40);
                    let mut y = pack(&[state]);
                    for _ in 0..steps {
                        y = step_plain(y, of(&y), time / f64::from(steps), of).end;
                    }
                    let ours = pack(&[series.state(time)]);
                    for (a, b) in ours[0].iter().zip(&y[0]) {
                        assert!(
                            (a - b).abs() <= AS_EQUATIONS * (1.0 + b.abs()),
                            "{held:?} {angle}: {ours:?} {y:?}"
                        );
                    }
                    assert!(time > 1e-3, "the series reach somewhere: {time}");
                }
            }
        }
    }

    /// Normal acceleration per normal force of a contact that slides, times the mass.
    fn response(world: &World, held: &Held, state: &State) -> f64 {
        let k = world.kinematics(&[*state], held.pair);
        let (body, pull) = (&world.bodies[0], held.slip.pull(world.obstacles[0].friction));
        let along = k.tangent().dot(k.arm);
        1.0 + body.mass / body.inertia * along * (along - pull * k.normal.dot(k.arm))
    }

    #[test]
    fn what_bounds_show_to_stay_above_zero_does_not_fall() {
        let mut world = world();
        // So rough that the normal force grows without bound on some ways (Painlevé's paradox).
        world.obstacles[0].friction = 2.0;
        let scales = world.scales();
        let (mut shown, mut asked) = (0, 0);
        for feature in [Feature::VertexOnFace { vertex: 1, face: 1 }, Feature::FaceOnEnd { face: 0, end: 1 }]
        {
            for (slip, moving) in [(Slip::Forward, 0.7), (Slip::Backward, -0.7)] {
                for step in 0..40 {
                    let held = Held { pair: Pairing { body: 0, obstacle: 0, feature }, slip };
                    let state = touching(&world, &held, (0.15 * f64::from(step) - 3.0, 2.0, moving));
                    let series = Expansion::<18>::of(Given::of(&world, &held, &state).unwrap());
                    let length = series.reach((1e-13, 1e-14, 1e-14), 0.1);
                    let spreads = series.spreads(length);
                    for what in [Watch::Regular, Watch::Force(0), Watch::Slip(0)] {
                        let watched = Watched::plain(what);
                        asked += 1;
                        if series.stays(&world, &watched, &spreads) {
                            shown += 1;
                            let fall = series.fall((&world, &scales), &watched, (0.0, length));
                            assert_eq!(fall, None, "{what:?} of {held:?} at step {step}");
                        }
                    }
                    // The series of the response says what the states along the step do.
                    let of_series = series.quantity(&world, &scales, &Watch::Regular).unwrap();
                    for i in 0..=4 {
                        let time = length * f64::from(i) / 4.0;
                        let expected = response(&world, &held, &series.state(time));
                        let found = value(&of_series, time);
                        assert!(
                            (found - expected).abs() <= AS_EQUATIONS * (1.0 + expected.abs()),
                            "{found} {expected} of {held:?} at step {step}"
                        );
                    }
                }
            }
        }
        assert!(shown > asked / 2, "the bounds show something: {shown} of {asked}");
    }
}
