//! Cylinder, prism and rod as sets of contacts, and the engine's answers in the letters of their closed forms.
#![allow(unreachable_pub, reason = "a module shared by test files")]
pub mod compare;
pub mod draw;

use carom_impact::Law;
use carom_impact::planar::end_states::EndState;
use carom_impact::planar::staged::StagedOutcome;
use carom_impact::planar::{ContactSet2, Touch, end_states, staged};
use carom_num::Vec2;
use carom_theory::rocking::{Cylinder, Prism, SupportedRod};

/// A body of which contact 0 is A and contact 1 is K; roll rates are clockwise.
#[derive(Clone, Copy, Debug)]
pub struct Rocking {
    pub mass: f64,
    pub inertia: f64,
    pub touches: [Touch; 2],
    /// (v_x, v_y, ω clockwise) before.
    pub before: [f64; 3],
}

fn touch(arm: Vec2, normal: Vec2, friction: f64, restitution: f64) -> Touch {
    Touch { arm, normal, friction, restitution }
}

const UP: Vec2 = Vec2 { x: 0.0, y: 1.0 };

impl Rocking {
    /// A cylinder that rolls on A with the roll rate ω₀.
    pub fn cylinder(c: &Cylinder, roll_rate: f64, restitution: f64) -> Self {
        let normal = Vec2::at_angle(2.0 * c.half_angle).turned_left();
        let at = |n: Vec2| touch(n * -c.radius, n, c.friction, restitution);
        Self {
            mass: c.mass,
            inertia: c.inertia_ratio * c.mass * c.radius * c.radius,
            touches: [at(UP), at(normal)],
            before: [roll_rate * c.radius, 0.0, roll_rate],
        }
    }

    /// A prism that turns about A with the roll rate ω₀, its face just flat.
    pub fn prism(p: &Prism, roll_rate: f64, restitution: f64) -> Self {
        let at = |x: f64| touch(Vec2::new(x, -p.height), UP, p.friction, restitution);
        Self {
            mass: p.mass,
            inertia: p.inertia,
            touches: [at(-p.to_centre), at(p.to_k)],
            before: [roll_rate * p.height, -roll_rate * p.to_centre, roll_rate],
        }
    }

    /// A rod that turns about A with the roll rate ω₀, just level, on smooth supports.
    pub fn rod(r: &SupportedRod, roll_rate: f64, restitution: f64) -> Self {
        let at = |x: f64| touch(Vec2::new(x, 0.0), UP, 0.0, restitution);
        Self {
            mass: r.mass,
            inertia: r.inertia,
            touches: [at(-r.to_a), at(r.to_b)],
            before: [0.0, -roll_rate * r.to_a, roll_rate],
        }
    }

    /// The contacts, with what touches or sticks before doing so exactly.
    pub fn set(&self) -> ContactSet2 {
        let [x, y, w] = self.before;
        let mut set =
            ContactSet2::of_free_body(self.mass, self.inertia, Vec2::new(x, y), -w, &self.touches).unwrap();
        set.snap(1e-14);
        set
    }

    /// Velocities (slip, normal) of both contacts in this motion.
    pub fn velocities(&self, [x, y, w]: [f64; 3]) -> [[f64; 2]; 2] {
        self.touches.map(|t| {
            let (slip, normal) = t.velocity(Vec2::new(x, y), -w);
            [slip, normal]
        })
    }

    /// The largest velocity at a contact before [m/s].
    pub fn speed(&self) -> f64 {
        self.velocities(self.before).iter().flatten().fold(0.0, |m: f64, u| m.max(u.abs()))
    }

    /// The motion after impulses (tangential, normal) at both contacts.
    pub fn after(&self, impulse: &[[f64; 2]; 2]) -> [f64; 3] {
        let [mut x, mut y, mut w] = self.before;
        for (t, [along, press]) in self.touches.iter().zip(impulse) {
            let p = t.normal.turned_right() * *along + t.normal * *press;
            x += p.x / self.mass;
            y += p.y / self.mass;
            w -= t.arm.cross(p) / self.inertia;
        }
        [x, y, w]
    }

    /// Unit impulses (tangential, normal) at both contacts that push along the chord between them, and cancel.
    pub fn chord(&self) -> [[f64; 2]; 2] {
        let [a, k] = self.touches;
        let along = (k.arm - a.arm) * (std::f64::consts::FRAC_1_SQRT_2 / (k.arm - a.arm).norm());
        [(a, -along), (k, along)].map(|(t, p)| [t.normal.turned_right().dot(p), t.normal.dot(p)])
    }

    /// The staged answer.
    pub fn strike(&self) -> StagedOutcome<2> {
        staged::resolve(&self.set(), Law::Poisson).unwrap()
    }

    /// The end states whose velocities differ by more than `within` [m/s]. Two ways to be at rest are one.
    pub fn different_end_states(&self, within: f64) -> Vec<EndState<2>> {
        let mut different: Vec<EndState<2>> = Vec::new();
        for end in end_states::enumerate(&self.set(), Law::Poisson).found {
            if !different
                .iter()
                .any(|other| self.moves_as(other, &end.velocity, within + self.rounding(&end)))
            {
                different.push(end);
            }
        }
        different
    }

    /// Does the end state have these velocities, within `within` [m/s] and the rounding of its impulses?
    pub fn moves_as(&self, end: &EndState<2>, velocities: &[[f64; 2]; 2], within: f64) -> bool {
        let pairs = end.velocity.as_flattened().iter().zip(velocities.as_flattened());
        let allowed = within + self.rounding(end);
        pairs.into_iter().all(|(a, b)| (a - b).abs() <= allowed)
    }

    /// Rounding of velocities: wedged contacts may press each other far harder than they must, and their impulses cancel.
    fn rounding(&self, end: &EndState<2>) -> f64 {
        let largest = end.impulse.iter().flatten().fold(0.0, |m: f64, p| m.max(p.abs()));
        1e-14 * self.response() * largest
    }

    /// The largest velocity that a unit impulse makes where it acts [1/kg].
    pub fn response(&self) -> f64 {
        let operator = self.set().operator;
        operator.iter().flatten().fold(0.0, |m: f64, b| m.max(b.tt.abs()).max(b.nn.abs()))
    }

    pub fn energy_ratio(&self, [x, y, w]: [f64; 3]) -> f64 {
        let energy = |x: f64, y: f64, w: f64| self.mass * (x * x + y * y) + self.inertia * w * w;
        let [x0, y0, w0] = self.before;
        energy(x, y, w) / energy(x0, y0, w0)
    }
}

/// Impulses as the tables order them: (N_A, T_A, N_K, T_K). The forward tangents are the normals turned right.
pub fn ordered(impulse: &[[f64; 2]; 2]) -> [f64; 4] {
    [impulse[0][1], impulse[0][0], impulse[1][1], impulse[1][0]]
}

/// The number 1 to 4 of a plastic end state of the cylinder with these velocities, each zero within `within` [m/s].
pub fn number_of(velocities: &[[f64; 2]; 2], within: f64) -> u8 {
    let [[slip_a, rise_a], [slip_k, _]] = velocities.map(|v| v.map(|u| u.abs() > within));
    match (rise_a, slip_k) {
        (true, false) => 1,
        (true, true) => 2,
        (false, _) if slip_a => 3,
        _ => 4,
    }
}
