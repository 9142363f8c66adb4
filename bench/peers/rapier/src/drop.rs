//! The drop that every engine is given: `drop.py` says the same in Python, and both must agree.
//!
//! World axes: x right, y up, angles counter-clockwise, SI units; the upper plate descends to the right, its edge is the origin.

pub const LENGTH: f64 = 0.1;
pub const THICKNESS: f64 = 0.001;
pub const MASS: f64 = 0.3;
pub const INERTIA: f64 = 2.5e-4;
pub const FRICTION: f64 = 0.15;
pub const GRAVITY: f64 = 9.81;
pub const LOOK_EVERY: f64 = 0.005;
pub const LIMIT: f64 = 5.0;

const TO_EDGE: f64 = 0.1;
const FLAT_ANGLE: f64 = 0.05;
const FLAT_SPIN: f64 = 1.0;
const FLAT_LOOKS: u32 = 6;
const RELEASE_GAP: f64 = 0.0005;

/// A feeder: the upper plate's slope [rad] and the lower plate's line in the paper's axes [m].
#[derive(Clone, Copy)]
pub struct Design {
    pub slope: f64,
    along: f64,
    normal: f64,
}

impl Design {
    pub fn new(slope_deg: f64, along: f64, normal: f64) -> Self {
        Self { slope: slope_deg.to_radians(), along, normal }
    }

    /// A vector in the paper's axes, in world axes.
    pub fn to_world(self, x: f64, y: f64) -> (f64, f64) {
        let (s, c) = self.slope.sin_cos();
        (x * c - y * s, -x * s - y * c)
    }

    /// The angle of the direction along the lower plate that goes right and up.
    pub fn lower_angle(self) -> f64 {
        let (x, y) = self.to_world(self.along, -self.normal);
        y.atan2(x)
    }

    /// A point of the lower plate, below the edge.
    pub fn lower_point(self) -> (f64, f64) {
        self.to_world(0.0, self.normal)
    }

    /// Centre and angle of the box that lies on the upper plate.
    pub fn start(self) -> (f64, f64, f64) {
        let (x, y) = self.to_world(-TO_EDGE, -THICKNESS / 2.0);
        (x, y, -self.slope)
    }
}

/// Looks at a part every `LOOK_EVERY` seconds of its run.
pub struct Watch {
    slope: f64,
    plate: f64,
    released: bool,
    looks: u32,
}

impl Watch {
    pub fn new(design: Design) -> Self {
        Self { slope: design.slope, plate: design.lower_angle(), released: false, looks: 0 }
    }

    /// True once: when the part has left the upper plate's edge.
    pub fn sees_release(&mut self, x: f64, y: f64, angle: f64) -> bool {
        if self.released {
            return false;
        }
        let (s, c) = angle.sin_cos();
        let (edge_along, edge_across) = (-c * x - s * y, s * x - c * y);
        let past = x * self.slope.cos() - y * self.slope.sin() > 0.0;
        self.released =
            past && (edge_along < -LENGTH / 2.0 || edge_across < -(THICKNESS / 2.0 + RELEASE_GAP));
        self.released
    }

    /// "same" or "turned" once the part has lain flat long enough.
    pub fn sees_verdict(&mut self, angle: f64, spin: f64) -> Option<&'static str> {
        let tilt = angle - self.plate;
        let flat = self.released && tilt.sin().abs() < FLAT_ANGLE && spin.abs() < FLAT_SPIN;
        self.looks = if flat { self.looks + 1 } else { 0 };
        let word = if tilt.cos() > 0.0 { "same" } else { "turned" };
        (self.looks >= FLAT_LOOKS).then_some(word)
    }
}

/// The state of the box when its corner touches the lower plate.
#[derive(Clone, Copy)]
pub struct Strike {
    pub design: Design,
    pub centre: (f64, f64),
    pub angle: f64,
    pub velocity: (f64, f64),
    pub spin: f64,
}

impl Strike {
    /// Velocity of the box's lowest corner along the lower plate's upward normal.
    pub fn approach(&self, angle: f64, velocity: (f64, f64), spin: f64) -> f64 {
        let (s, c) = self.design.lower_angle().sin_cos();
        let (sa, ca) = angle.sin_cos();
        let mut lowest = (f64::INFINITY, (0.0, 0.0));
        for (i, j) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            let (p, q) = (i * LENGTH / 2.0, j * THICKNESS / 2.0);
            let arm = (ca * p - sa * q, sa * p + ca * q);
            let height = -s * arm.0 + c * arm.1;
            if height < lowest.0 {
                lowest = (height, arm);
            }
        }
        let arm = lowest.1;
        -s * (velocity.0 - spin * arm.1) + c * (velocity.1 + spin * arm.0)
    }

    /// True when the corner approaches no more: 0.1 % of its speed before, which soft contacts keep for long.
    pub fn is_over(&self, approach_now: f64) -> bool {
        approach_now > 0.001 * self.approach(self.angle, self.velocity, self.spin)
    }
}
