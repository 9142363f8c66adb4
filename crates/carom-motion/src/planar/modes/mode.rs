//! A mode: contacts that are held, each sticking or slipping; its forces and accelerations.

use super::line::{Line, Mobility};
use super::question::Posed;
use crate::planar::contact::{
    World,
    kinematics::{Kinematics, Pairing, Turn, turns},
    touching::Few,
};
use crate::planar::geometry::State;
use crate::tolerance::MODE_RANK;
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::solve::solve_regular;

/// A contact that is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::planar) struct Held {
    pub(in crate::planar) pair: Pairing,
    pub(in crate::planar) slip: Slip,
}

impl Held {
    /// A contact that slips at this velocity; up to `still` it sticks [m/s].
    pub(in crate::planar) fn slipping(pair: Pairing, velocity: f64, still: f64) -> Self {
        let slip = match velocity {
            v if v > still => Slip::Forward,
            v if v < -still => Slip::Backward,
            _ => Slip::Sticks,
        };
        Self { pair, slip }
    }
}

/// Acceleration of the mass centre [m/s²] and of the angle [rad/s²].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::planar) struct Acceleration {
    pub(in crate::planar) linear: Vec2,
    pub(in crate::planar) angular: f64,
}

impl Acceleration {
    /// Where a body is that moves so for a short time [s] from a state.
    pub(in crate::planar) fn over(&self, state: &State, time: f64) -> State {
        let (v, w) = (state.twist.velocity, state.twist.spin);
        let mut out = *state;
        out.pose.centre += v * time + self.linear * (0.5 * time * time);
        out.pose.angle += w * time + 0.5 * self.angular * time * time;
        out.twist.velocity += self.linear * time;
        out.twist.spin += self.angular * time;
        out
    }
}

/// A held contact in one state, with its forces.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Loaded {
    pub(in crate::planar) held: Held,
    pub(in crate::planar) kinematics: Kinematics,
    /// Normal force on the body [N].
    pub(in crate::planar) normal_force: f64,
    /// Tangential force on the body [N].
    pub(in crate::planar) tangential_force: f64,
}

/// All held contacts in one state.
#[derive(Clone, Copy, Debug)]
pub(in crate::planar) struct Forces<const B: usize> {
    pub(in crate::planar) contacts: Few<Loaded>,
    pub(in crate::planar) acceleration: [Acceleration; B],
    /// The mode leaves the forces indeterminate: these are a member of the family they may be of.
    pub(super) indeterminate: bool,
    /// How far the mode's equations are from singular: for one slipping contact `m (W_nn − sμW_nt)`; its sign is what counts.
    pub(super) regularity: f64,
}

impl<const B: usize> Default for Forces<B> {
    fn default() -> Self {
        let acceleration = [Acceleration::default(); B];
        Self { contacts: Few::default(), acceleration, indeterminate: false, regularity: 1.0 }
    }
}

/// Forces and accelerations of a single contact.
struct OneContact {
    normal: f64,
    tangential: f64,
    regularity: f64,
    acceleration: Acceleration,
}

/// Forces and accelerations of two slipping contacts.
struct TwoSlipping {
    normals: [f64; 2],
    acceleration: Acceleration,
    regularity: f64,
}

impl World {
    /// Forces and accelerations of a mode in a state.
    pub(in crate::planar) fn forces<const B: usize>(
        &self,
        held: &Few<Held>,
        states: &[State; B],
    ) -> Forces<B> {
        let mut out = Forces::default();
        self.forces_into(held, states, &turns(states), &mut out);
        out
    }

    /// As [`World::forces`], into a place that may have been used before: it is large, and mostly empty.
    pub(in crate::planar) fn forces_into<const B: usize>(
        &self,
        held: &Few<Held>,
        states: &[State; B],
        turns: &[Turn; B],
        out: &mut Forces<B>,
    ) {
        out.contacts.clear();
        out.indeterminate = false;
        // One contact of a lone body, and two that slip, are most of what a feeder's part does: solved by hand they need no matrix.
        if let (Some(h), 1, 1) = (held.get(0), held.len(), B) {
            let k = self.alone(states, turns, h);
            let one = self.one_contact(h, &k);
            out.contacts.push(Loaded {
                held: *h,
                kinematics: k,
                normal_force: one.normal,
                tangential_force: one.tangential,
            });
            (out.acceleration, out.regularity) = ([one.acceleration; B], one.regularity);
            return;
        }
        for h in held.iter() {
            let kinematics = self.kinematics_turned(states, turns, h.pair);
            out.contacts.push(Loaded { held: *h, kinematics, normal_force: 0.0, tangential_force: 0.0 });
        }
        let contacts = &mut out.contacts;
        if let (Some(a), Some(b), 2, 1) = (contacts.get(0), contacts.get(1), contacts.len(), B)
            && let Some(two) = self.two_slipping([(&a.held, &a.kinematics), (&b.held, &b.kinematics)])
        {
            for (c, normal) in contacts.iter_mut().zip(two.normals) {
                c.normal_force = normal;
                c.tangential_force = c.held.slip.pull(self.surface(c.held.pair).friction) * normal;
            }
            (out.acceleration, out.regularity) = ([two.acceleration; B], two.regularity);
            return;
        }
        // The cost grows with the third power of the rows, and most modes have few.
        if held.len() <= 2 {
            self.solve_forces::<B, 4>(held, (states, turns), out);
        } else if held.len() <= 6 {
            self.solve_forces::<B, 12>(held, (states, turns), out);
        } else {
            self.solve_forces::<B, 24>(held, (states, turns), out);
        }
    }

    /// Accelerations of a mode in a state: what the integration needs. One contact of a lone body and two that slip, the most common modes,
    /// are solved by hand.
    pub(in crate::planar) fn accelerate<const B: usize>(
        &self,
        held: &Few<Held>,
        states: &[State; B],
    ) -> [Acceleration; B] {
        if B > 1 {
            return self.forces(held, states).acceleration;
        }
        let turns = turns(states);
        if let (Some(h), 1) = (held.get(0), held.len()) {
            let k = self.alone(states, &turns, h);
            return [self.one_contact(h, &k).acceleration; B];
        }
        if let (Some(a), Some(b), 2) = (held.get(0), held.get(1), held.len())
            && a.slip != Slip::Sticks
            && b.slip != Slip::Sticks
        {
            let of = |h: &Held| self.alone(states, &turns, h);
            if let Some(two) = self.two_slipping([(a, &of(a)), (b, &of(b))]) {
                return [two.acceleration; B];
            }
        }
        self.forces(held, states).acceleration
    }

    /// Kinematics of a contact of a lone body, which is one on an obstacle: asked for in every evaluation.
    #[inline(always)]
    fn alone(&self, states: &[State], turns: &[Turn], h: &Held) -> Kinematics {
        self.on_obstacle(&states[0], turns[0], h.pair, &self.obstacles[h.pair.obstacle])
    }

    /// Two slipping contacts of a lone body, solved by hand; `None` where the mode is another or its equations are singular.
    #[inline(always)]
    fn two_slipping(&self, [a, b]: [(&Held, &Kinematics); 2]) -> Option<TwoSlipping> {
        if a.0.slip == Slip::Sticks || b.0.slip == Slip::Sticks {
            return None;
        }
        let solid = |(h, k): (&Held, &Kinematics)| {
            let pull = h.slip.pull(self.obstacles[h.pair.obstacle].friction);
            let bias = -k.normal_bias - k.normal.dot(self.gravity);
            (Line::alone(k, k.normal), Line::alone(k, k.normal + k.tangent() * pull), bias)
        };
        let ((row_a, force_a, bias_a), (row_b, force_b, bias_b)) = (solid(a), solid(b));
        let mobility = self.mobility();
        let (aa, ab) = (mobility.response(&row_a, &force_a), mobility.response(&row_a, &force_b));
        let (ba, bb) = (mobility.response(&row_b, &force_a), mobility.response(&row_b, &force_b));
        let determinant = aa * bb - ab * ba;
        let largest = aa.abs().max(ab.abs()).max(ba.abs()).max(bb.abs());
        if determinant.abs() <= MODE_RANK * largest * largest {
            return None;
        }
        let normals = [(bias_a * bb - bias_b * ab) / determinant, (bias_b * aa - bias_a * ba) / determinant];
        let mut acceleration = Acceleration { linear: self.gravity, angular: 0.0 };
        for (normal, line) in normals.into_iter().zip([&force_a, &force_b]) {
            acceleration.linear += line.direction * (normal * mobility.linear);
            acceleration.angular += line.moment * normal * mobility.angular;
        }
        let m = self.bodies[0].mass;
        Some(TwoSlipping { normals, acceleration, regularity: m * m * determinant })
    }

    /// One contact of a lone body, solved by hand.
    #[inline(always)]
    fn one_contact(&self, h: &Held, k: &Kinematics) -> OneContact {
        let friction = self.obstacles[h.pair.obstacle].friction;
        let mobility = self.mobility();
        let (n, t) = (Line::alone(k, k.normal), Line::alone(k, k.tangent()));
        let pull = h.slip.pull(friction);
        let normal_bias = -k.normal_bias - k.normal.dot(self.gravity);
        let (nn, nt) = (mobility.response(&n, &n), mobility.response(&n, &t));
        let (normal, tangential, regularity) = if h.slip == Slip::Sticks {
            let slip_bias = -k.slip_bias - k.tangent().dot(self.gravity);
            let tt = mobility.response(&t, &t);
            let determinant = nn * tt - nt * nt;
            let normal = (normal_bias * tt - slip_bias * nt) / determinant;
            (normal, (slip_bias * nn - normal_bias * nt) / determinant, 1.0)
        } else {
            let response = nn + pull * nt;
            let normal = normal_bias / response;
            (normal, pull * normal, self.bodies[0].mass * response)
        };
        let acceleration = Acceleration {
            linear: self.gravity + (n.direction * normal + t.direction * tangential) * mobility.linear,
            angular: (n.moment * normal + t.moment * tangential) * mobility.angular,
        };
        OneContact { normal, tangential, regularity, acceleration }
    }

    /// What forces do to a lone body.
    fn mobility(&self) -> Mobility {
        Mobility::of(&self.bodies[0])
    }

    /// Acceleration by gravity of a pair's contact point along a direction, relative to the other side [m/s²]: zero where both sides fall.
    pub(super) fn gravity_along(&self, pair: Pairing, direction: Vec2) -> f64 {
        if pair.obstacle < self.obstacles.len() { direction.dot(self.gravity) } else { 0.0 }
    }

    fn solve_forces<const B: usize, const M: usize>(
        &self,
        held: &Few<Held>,
        posed: Posed<'_, B>,
        out: &mut Forces<B>,
    ) {
        let contacts = &mut out.contacts;
        // Rows: the constraints (normal rate, and slip rate where it sticks). Columns: the forces that hold them.
        let (mut rows, mut columns, mut bias) = ([None; M], [None; M], [0.0; M]);
        let mut n = 0;
        for c in contacts.iter() {
            let (k, pair) = (&c.kinematics, c.held.pair);
            let pull = c.held.slip.pull(self.surface(pair).friction);
            rows[n] = Some(self.line(k, pair, k.normal));
            columns[n] = Some(self.line(k, pair, k.normal + k.tangent() * pull));
            bias[n] = -k.normal_bias - self.gravity_along(pair, k.normal);
            n += 1;
            if c.held.slip == Slip::Sticks {
                rows[n] = Some(self.line(k, pair, k.tangent()));
                columns[n] = rows[n];
                bias[n] = -k.slip_bias - self.gravity_along(pair, k.tangent());
                n += 1;
            }
        }
        let mut matrix = [[0.0; M]; M];
        for i in 0..n {
            for j in 0..n {
                if let (Some(row), Some(column)) = (&rows[i], &columns[j]) {
                    matrix[i][j] = self.response(row, column);
                }
            }
        }
        let regularity = self.regularity(&matrix, n);
        let solved = solve_regular(matrix, bias, n, MODE_RANK);
        let indeterminate = solved.is_none();
        match solved {
            Some(x) => self.share(contacts, &x),
            None => {
                let shared = self.shared_forces(posed, held).unwrap_or_default();
                for (c, [q, r]) in contacts.iter_mut().zip(shared) {
                    (c.tangential_force, c.normal_force) = (q, r);
                }
            }
        }
        // Places without a body stay where they are.
        let mut acceleration = [Acceleration::default(); B];
        for a in acceleration.iter_mut().take(self.bodies.len()) {
            a.linear = self.gravity;
        }
        for c in contacts.iter() {
            let k = &c.kinematics;
            let force = k.normal * c.normal_force + k.tangent() * c.tangential_force;
            for (body, arm, force) in self.acts_on(c.held.pair, k, force) {
                acceleration[body].linear += force / self.bodies[body].mass;
                acceleration[body].angular += arm.cross(force) / self.bodies[body].inertia;
            }
        }
        (out.acceleration, out.indeterminate, out.regularity) = (acceleration, indeterminate, regularity);
    }

    /// Writes the solved forces into the contacts.
    fn share<const M: usize>(&self, contacts: &mut Few<Loaded>, x: &[f64; M]) {
        let mut n = 0;
        for c in contacts.iter_mut() {
            let sticks = c.held.slip == Slip::Sticks;
            let friction = self.surface(c.held.pair).friction;
            c.normal_force = x[n];
            c.tangential_force = if sticks { x[n + 1] } else { c.held.slip.pull(friction) * x[n] };
            n += if sticks { 2 } else { 1 };
        }
    }

    /// Determinant of the mode's matrix, scaled by the mass; 1 where nothing is held.
    fn regularity<const M: usize>(&self, matrix: &[[f64; M]; M], n: usize) -> f64 {
        let m = self.bodies[0].mass;
        match n {
            0 => 1.0,
            1 => m * matrix[0][0],
            2 => m * m * (matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]),
            _ => 1.0,
        }
    }
}
