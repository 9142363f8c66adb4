//! A mode: contacts that are held, each sticking or slipping; its forces and accelerations.

use super::kinematics::{Kinematics, Pairing, Turn};
use super::touching::Few;
use super::{State, World};
use carom_impact::planar::Slip;
use carom_num::Vec2;
use carom_num::solve::{solve_any, solve_regular};

/// A contact that is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Held {
    pub(super) pair: Pairing,
    pub(super) slip: Slip,
}

/// Acceleration of the mass centre [m/s²] and of the angle [rad/s²].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Acceleration {
    pub(super) linear: Vec2,
    pub(super) angular: f64,
}

/// A held contact in one state, with its forces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Loaded {
    pub(super) held: Held,
    pub(super) kinematics: Kinematics,
    /// Normal force on the body [N].
    pub(super) normal_force: f64,
    /// Tangential force on the body [N].
    pub(super) tangential_force: f64,
}

/// All held contacts in one state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Forces {
    pub(super) contacts: Few<Loaded>,
    pub(super) acceleration: Acceleration,
    /// How far the mode's equations are from singular: for one slipping contact `m (W_nn − sμW_nt)`; its sign is what counts.
    pub(super) regularity: f64,
}

/// Forces and accelerations of a single contact.
struct OneContact {
    normal: f64,
    tangential: f64,
    regularity: f64,
    acceleration: Acceleration,
}

/// Pivots below this fraction of the matrix count as zero.
const RANK_TOLERANCE: f64 = 1e-12;

/// A generalised force (force and moment about the mass centre) and what it does to a contact.
#[derive(Clone, Copy)]
struct Line {
    direction: Vec2,
    moment: f64,
}

impl Line {
    fn new(k: &Kinematics, direction: Vec2) -> Self {
        Self { direction, moment: k.arm.cross(direction) }
    }
}

impl World {
    /// Forces and accelerations of a mode in a state.
    pub(super) fn forces(&self, held: &Few<Held>, state: &State) -> Forces {
        let turn = Turn::of(state);
        let mut contacts = Few::default();
        if let (Some(h), 1) = (held.get(0), held.len()) {
            let k = self.kinematics_turned(state, turn, h.pair);
            let one = self.one_contact(h, &k);
            contacts.push(Loaded {
                held: *h,
                kinematics: k,
                normal_force: one.normal,
                tangential_force: one.tangential,
            });
            return Forces { contacts, acceleration: one.acceleration, regularity: one.regularity };
        }
        for h in held.iter() {
            let kinematics = self.kinematics_turned(state, turn, h.pair);
            contacts.push(Loaded { held: *h, kinematics, normal_force: 0.0, tangential_force: 0.0 });
        }
        if contacts.len() <= 2 { self.solve_forces::<4>(contacts) } else { self.solve_forces::<12>(contacts) }
    }

    /// Accelerations of a mode in a state: what the integration needs. One contact, the most common mode, is solved by hand.
    pub(super) fn accelerate(&self, held: &Few<Held>, state: &State) -> Acceleration {
        let (Some(h), 1) = (held.get(0), held.len()) else {
            return self.forces(held, state).acceleration;
        };
        let k = self.kinematics_turned(state, Turn::of(state), h.pair);
        self.one_contact(h, &k).acceleration
    }

    /// One contact, solved by hand.
    fn one_contact(&self, h: &Held, k: &Kinematics) -> OneContact {
        let friction = self.obstacles[h.pair.obstacle].friction;
        let (n, t) = (Line::new(k, k.normal), Line::new(k, k.tangent()));
        let pull = h.slip.pull(friction);
        let normal_bias = -k.normal_bias - k.normal.dot(self.gravity);
        let (nn, nt) = (self.response(&n, &n), self.response(&n, &t));
        let (normal, tangential, regularity) = if h.slip == Slip::Sticks {
            let slip_bias = -k.slip_bias - k.tangent().dot(self.gravity);
            let tt = self.response(&t, &t);
            let determinant = nn * tt - nt * nt;
            let normal = (normal_bias * tt - slip_bias * nt) / determinant;
            (normal, (slip_bias * nn - normal_bias * nt) / determinant, 1.0)
        } else {
            let response = nn + pull * nt;
            let normal = normal_bias / response;
            (normal, pull * normal, self.body.mass * response)
        };
        let force = k.normal * normal + k.tangent() * tangential;
        let acceleration = Acceleration {
            linear: self.gravity + force / self.body.mass,
            angular: k.arm.cross(force) / self.body.inertia,
        };
        OneContact { normal, tangential, regularity, acceleration }
    }

    fn response(&self, row: &Line, force: &Line) -> f64 {
        row.direction.dot(force.direction) / self.body.mass + row.moment * force.moment / self.body.inertia
    }

    fn solve_forces<const M: usize>(&self, mut contacts: Few<Loaded>) -> Forces {
        // Rows: the constraints (normal rate, and slip rate where it sticks). Columns: the forces that hold them.
        let (mut rows, mut columns, mut bias) = ([None; M], [None; M], [0.0; M]);
        let mut n = 0;
        for c in contacts.iter() {
            let k = &c.kinematics;
            let friction = self.obstacles[c.held.pair.obstacle].friction;
            let pull = c.held.slip.pull(friction);
            rows[n] = Some(Line::new(k, k.normal));
            columns[n] = Some(Line::new(k, k.normal + k.tangent() * pull));
            bias[n] = -k.normal_bias - k.normal.dot(self.gravity);
            n += 1;
            if c.held.slip == Slip::Sticks {
                rows[n] = Some(Line::new(k, k.tangent()));
                columns[n] = rows[n];
                bias[n] = -k.slip_bias - k.tangent().dot(self.gravity);
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
        let x = solve_regular(matrix, bias, n, RANK_TOLERANCE)
            .or_else(|| solve_any(matrix, bias, n, 1e-9).map(|s| s.point))
            .unwrap_or([0.0; M]);
        let mut acceleration = Acceleration { linear: self.gravity, angular: 0.0 };
        for (force, line) in x.iter().zip(&columns).take(n) {
            if let Some(line) = line {
                acceleration.linear += line.direction * (force / self.body.mass);
                acceleration.angular += line.moment * force / self.body.inertia;
            }
        }
        self.share(&mut contacts, &x);
        Forces { contacts, acceleration, regularity }
    }

    /// Writes the solved forces into the contacts.
    fn share<const M: usize>(&self, contacts: &mut Few<Loaded>, x: &[f64; M]) {
        let mut n = 0;
        for c in contacts.iter_mut() {
            let friction = self.obstacles[c.held.pair.obstacle].friction;
            c.normal_force = x[n];
            c.tangential_force = match c.held.slip {
                Slip::Forward => -friction * x[n],
                Slip::Backward => friction * x[n],
                Slip::Sticks => x[n + 1],
                Slip::Open => 0.0,
            };
            n += if c.held.slip == Slip::Sticks { 2 } else { 1 };
        }
    }

    /// Determinant of the mode's matrix, scaled by the mass; 1 where nothing is held.
    fn regularity<const M: usize>(&self, matrix: &[[f64; M]; M], n: usize) -> f64 {
        let m = self.body.mass;
        match n {
            0 => 1.0,
            1 => m * matrix[0][0],
            2 => m * m * (matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]),
            _ => 1.0,
        }
    }
}
