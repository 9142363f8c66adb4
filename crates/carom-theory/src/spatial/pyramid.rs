//! A regular pyramid that rolls over its lateral edges on a plane, from face to face.

#[cfg(test)]
mod tests;

use crate::OutsideDomain;
use crate::domain::{require, require_finite, require_positive};
use crate::vectors::{V, cross, dot, minus, solved, times};

/// A homogeneous pyramid on a regular base, which turns about the lateral edge OA (O its apex, A a corner of the base) until the next corner K
/// of the base strikes the plane: then the face OAK lies on it.
///
/// Vectors are in the body's axes: the origin is O, z runs from the apex to the middle of the base, and the face OAK is symmetric about x:
/// `A = (a C, −a S, h)`, `K = (a C, a S, h)`, `C = cos(π/n)`, `S = sin(π/n)`.
///
/// # Example
/// On a hexagon sin²(π/6) = 1/4: the critical height is √(5/6) of the circumradius.
/// ```
/// let pyramid = carom_theory::spatial::Pyramid { sides: 6, height: 1.0, circumradius: 2.0, mass: 1.0 };
/// assert!((pyramid.critical_height() - 2.0 * (5.0f64 / 6.0).sqrt()).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pyramid {
    /// n ≥ 3, sides of the base.
    pub sides: u32,
    /// h > 0 \[m\].
    pub height: f64,
    /// a > 0, circumradius of the base \[m\].
    pub circumradius: f64,
    /// m > 0 \[kg\].
    pub mass: f64,
}

/// Which of the three points stay on the plane.
///
/// # Example
/// The long pyramid on a triangle stops, that on a square rolls on.
/// ```
/// use carom_theory::spatial::{Kept, Pyramid};
/// let kept = |sides| Pyramid { sides, height: 2.0, circumradius: 1.0, mass: 1.0 }.kept();
/// assert_eq!([kept(3), kept(4)], [Kept::All, Kept::ApexAndNext]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kept {
    /// O and K: it rolls on, about the next lateral edge. The long pyramid, n ≥ 4.
    ApexAndNext,
    /// K alone: the apex separates as well as A. The short pyramid, n ≥ 4.
    Next,
    /// All three: it stops. The long pyramid on a triangle.
    All,
    /// A and K: it turns about the base's edge. The short pyramid on a triangle.
    BaseEdge,
}

/// What the strike of a pyramid leaves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PyramidStrike {
    /// Which points stay.
    pub kept: Kept,
    /// Angular velocity after [rad/s], in the body's axes.
    pub spin: [f64; 3],
    /// Normal impulses at O, A and K [N s]. Where two points stay, the part of the tangential impulses along their line is open, the normal ones are not.
    pub normal: [f64; 3],
    /// Kinetic energy after, as a fraction of that before.
    pub energy_ratio: f64,
}

/// The lengths and angles that the forms are made of.
struct Parts {
    /// cos and sin of π/n, and cos 2π/n.
    cos: f64,
    sin: f64,
    cos_double: f64,
    /// q = 1 − (2/3) sin²(π/n): the polygon's factor in the moments of inertia.
    q: f64,
    /// Lateral edge L, slant height D [m].
    edge: f64,
    slant: f64,
    /// Q = q a² + 4 h² [m²].
    big_q: f64,
    /// Corners and mass centre, from the apex.
    a: V,
    k: V,
    centre: V,
    /// Unit normal of the plane, into the body.
    normal: V,
}

impl Pyramid {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::Pyramid;
    /// let flat = Pyramid { sides: 2, height: 1.0, circumradius: 1.0, mass: 1.0 };
    /// assert_eq!(flat.check().map_err(|error| error.quantity), Err("sides"));
    /// assert_eq!(Pyramid { sides: 3, ..flat }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require(self.sides >= 3, "sides", f64::from(self.sides), ">= 3")?;
        require_positive("height", self.height)?;
        require_positive("circumradius", self.circumradius)?;
        require_positive("mass", self.mass)
    }

    fn parts(&self) -> Parts {
        let (h, a) = (self.height, self.circumradius);
        let (sin, cos) = libm::sincos(core::f64::consts::PI / f64::from(self.sides));
        let q = 1.0 - 2.0 / 3.0 * sin * sin;
        let slant = (h * h + a * a * cos * cos).sqrt();
        Parts {
            cos,
            sin,
            cos_double: cos * cos - sin * sin,
            q,
            edge: (a * a + h * h).sqrt(),
            slant,
            big_q: q * a * a + 4.0 * h * h,
            a: [a * cos, -a * sin, h],
            k: [a * cos, a * sin, h],
            centre: [0.0, 0.0, 0.75 * h],
            normal: [-h / slant, 0.0, a * cos / slant],
        }
    }

    /// Moments of inertia about the mass centre, across and along the axis [kg m²]:
    ///
    /// ```text
    /// J_t = (3/20) m a² q + (3/80) m h²,   J_a = (3/10) m a² q,   q = 1 − (2/3) sin²(π/n)
    /// ```
    ///
    /// # Example
    /// A pyramid on very many sides is a cone: `J_a = (3/10) m a²`.
    /// ```
    /// use carom_theory::spatial::Pyramid;
    /// let cone = Pyramid { sides: 1_000_000, height: 2.0, circumradius: 1.0, mass: 1.0 };
    /// assert!((cone.inertia()[1] - 0.3).abs() < 1e-11);
    /// ```
    pub fn inertia(&self) -> [f64; 2] {
        let q = self.parts().q;
        let (ma2, mh2) =
            (self.mass * self.circumradius * self.circumradius, self.mass * self.height * self.height);
        [0.15 * ma2 * q + 0.0375 * mh2, 0.3 * ma2 * q]
    }

    /// a √(1 − (2/3) sin²(π/n)): a pyramid of at least this height is long, its apex stays \[m\].
    ///
    /// This is the printed criterion, `sin(π/n)²` read as the square of the sine. It is the sign of the apex's normal impulse, for every n.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::Pyramid;
    /// let square = Pyramid { sides: 4, height: 1.0, circumradius: 1.0, mass: 1.0 };
    /// assert!((square.critical_height() - (2.0f64 / 3.0).sqrt()).abs() < 1e-15);
    /// ```
    pub fn critical_height(&self) -> f64 {
        self.circumradius * self.parts().q.sqrt()
    }

    /// Velocity with which K strikes, for the roll rate Ω about OA [m/s]: `v = 2 a S D Ω / L`.
    ///
    /// # Example
    /// A square base with a = 1 and h = 1: `v = 2 √½ √(3/2) / √2 = √1.5`.
    /// ```
    /// use carom_theory::spatial::Pyramid;
    /// let square = Pyramid { sides: 4, height: 1.0, circumradius: 1.0, mass: 1.0 };
    /// assert!((square.strike_speed(1.0) - 1.5f64.sqrt()).abs() < 1e-15);
    /// ```
    pub fn strike_speed(&self, roll_rate: f64) -> f64 {
        let p = self.parts();
        2.0 * self.circumradius * p.sin * p.slant * roll_rate / p.edge
    }

    /// k, the roll rate about OK after by that about OA before, where O and K stay:
    ///
    /// ```text
    /// k = (2 q h² + Q cos 2π/n) / (2 q h² + Q),   Q = q a² + 4 h²
    /// ```
    ///
    /// Negative on a triangle, and there only: A would approach, it stays too.
    ///
    /// # Example
    /// On a square cos 2π/n is 0: with a = h and q = 2/3, k = (4/3) / (4/3 + 14/3) = 2/9.
    /// ```
    /// use carom_theory::spatial::Pyramid;
    /// let square = Pyramid { sides: 4, height: 1.0, circumradius: 1.0, mass: 1.0 };
    /// assert!((square.roll_ratio() - 2.0 / 9.0).abs() < 1e-15);
    /// ```
    pub fn roll_ratio(&self) -> f64 {
        let p = self.parts();
        let both = 2.0 * p.q * self.height * self.height;
        (both + p.big_q * p.cos_double) / (both + p.big_q)
    }

    /// Which points stay.
    ///
    /// The printed text has two outcomes, and A separates in both. That is so for n ≥ 4 (of the short pyramid it is the apex that separates too: the
    /// print says A twice). On a triangle neither occurs.
    ///
    /// # Example
    /// On a square the critical height is √(2/3) = 0.816 of the circumradius.
    /// ```
    /// use carom_theory::spatial::{Kept, Pyramid};
    /// let kept = |height| Pyramid { sides: 4, height, circumradius: 1.0, mass: 1.0 }.kept();
    /// assert_eq!([kept(0.81), kept(0.82)], [Kept::Next, Kept::ApexAndNext]);
    /// ```
    pub fn kept(&self) -> Kept {
        match (self.sides, self.height >= self.critical_height()) {
            (3, true) => Kept::All,
            (3, false) => Kept::BaseEdge,
            (_, true) => Kept::ApexAndNext,
            (_, false) => Kept::Next,
        }
    }

    /// The strike at a roll rate Ω > 0 about OA [rad/s].
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::spatial::{Kept, Pyramid};
    /// let square = Pyramid { sides: 4, height: 1.0, circumradius: 1.0, mass: 1.0 };
    /// let strike = square.strike(1.0)?;
    /// assert_eq!(strike.kept, Kept::ApexAndNext);
    /// assert!((strike.energy_ratio - 4.0 / 81.0).abs() < 1e-15);
    /// assert!((strike.spin[0] + 1.0 / 9.0).abs() < 1e-15);
    /// # Ok::<(), carom_theory::OutsideDomain>(())
    /// ```
    pub fn strike(&self, roll_rate: f64) -> Result<PyramidStrike, OutsideDomain> {
        self.check()?;
        require(roll_rate > 0.0, "roll rate", roll_rate, "> 0")?;
        require_finite("roll rate", roll_rate)?;
        let p = self.parts();
        let kept = self.kept();
        let (spin, normal) = match kept {
            Kept::ApexAndNext => self.on_the_next_edge(&p, roll_rate),
            Kept::Next => self.on_the_next_corner(&p, roll_rate),
            Kept::All => ([0.0; 3], self.stopped(&p, roll_rate)),
            Kept::BaseEdge => self.on_the_base_edge(&p, roll_rate),
        };
        let before = times(-roll_rate / p.edge, p.a);
        // Before, the apex is at rest; after, a point that is kept.
        let pivot = match kept {
            Kept::ApexAndNext | Kept::All => [0.0; 3],
            Kept::Next | Kept::BaseEdge => p.k,
        };
        let energy_ratio = self.energy(spin, minus(p.centre, pivot)) / self.energy(before, p.centre);
        Ok(PyramidStrike { kept, spin, normal, energy_ratio })
    }

    /// Kinetic energy of a turn about a fixed point, the mass centre at `s` from it [J].
    fn energy(&self, spin: V, s: V) -> f64 {
        let [across, along] = self.inertia();
        let velocity = cross(spin, s);
        0.5 * self.mass * dot(velocity, velocity)
            + 0.5 * (across * (spin[0] * spin[0] + spin[1] * spin[1]) + along * spin[2] * spin[2])
    }

    /// O and K stay: the angular momentum about OK keeps.
    ///
    /// ```text
    /// ω₁ = −Ω k K/L,   N_K = (3/10) m Ω a S Q B / (L D (Q + 2 q h²)),   N_O = N_K (h² − q a²)/Q,   B = C² Q + 2 q h²
    /// ```
    fn on_the_next_edge(&self, p: &Parts, roll_rate: f64) -> (V, [f64; 3]) {
        let (h2, a) = (self.height * self.height, self.circumradius);
        let spin = times(-roll_rate * self.roll_ratio() / p.edge, p.k);
        let both = 2.0 * p.q * h2;
        let b = p.cos * p.cos * p.big_q + both;
        let at_k =
            0.3 * self.mass * roll_rate * a * p.sin * p.big_q * b / (p.edge * p.slant * (p.big_q + both));
        (spin, [at_k * (h2 - p.q * a * a) / p.big_q, 0.0, at_k])
    }

    /// K stays alone: the angular momentum about K keeps.
    ///
    /// ```text
    /// ω₁ = ω₀ − m v J_K⁻¹ (s × N),   s = G − K
    /// ```
    fn on_the_next_corner(&self, p: &Parts, roll_rate: f64) -> (V, [f64; 3]) {
        let s = minus(p.centre, p.k);
        let before = times(-roll_rate / p.edge, p.a);
        let pulled = times(self.mass * self.strike_speed(roll_rate), cross(s, p.normal));
        let spin = minus(before, solved(self.inertia_about(s), pulled));
        let velocity = minus(cross(spin, s), cross(before, p.centre));
        (spin, [0.0, 0.0, self.mass * dot(velocity, p.normal)])
    }

    /// Inertia about a point from which the mass centre is at s: `J_c + m (s² 1 − s sᵀ)`.
    fn inertia_about(&self, s: V) -> [V; 3] {
        let [across, along] = self.inertia();
        let central = [across, across, along];
        let entry = |i: usize, j: usize| {
            let own = if i == j { central[i] + self.mass * dot(s, s) } else { 0.0 };
            own - self.mass * s[i] * s[j]
        };
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)))
    }

    /// All three stay.
    ///
    /// ```text
    /// N_K = f (Q + 2 q h²),   N_A = −f E,   N_O = 2 f S² (h² − q a²),
    /// f = 3 m Ω a/(40 S L D),   E = 2 C² Q − q a² + 2 q h² − 4 h²
    /// ```
    fn stopped(&self, p: &Parts, roll_rate: f64) -> [f64; 3] {
        let (h2, a2) = (self.height * self.height, self.circumradius * self.circumradius);
        let f = 3.0 * self.mass * roll_rate * self.circumradius / (40.0 * p.sin * p.edge * p.slant);
        let e = 2.0 * p.cos * p.cos * p.big_q - p.q * a2 + 2.0 * p.q * h2 - 4.0 * h2;
        [2.0 * f * p.sin * p.sin * (h2 - p.q * a2), -f * e, f * (p.big_q + 2.0 * p.q * h2)]
    }

    /// A and K stay: the apex lifts.
    ///
    /// ```text
    /// ω₁ = Ω 3 a S (q a² − h²) / (L (3 q a² + 2 h² + 20 a² C²)) y
    /// ```
    ///
    /// The sum of the normal impulses is the change of the normal momentum, their difference that of the angular momentum about the face's middle line.
    fn on_the_base_edge(&self, p: &Parts, roll_rate: f64) -> (V, [f64; 3]) {
        let (h2, a2) = (self.height * self.height, self.circumradius * self.circumradius);
        let rate = roll_rate * 3.0 * self.circumradius * p.sin * (p.q * a2 - h2)
            / (p.edge * (3.0 * p.q * a2 + 2.0 * h2 + 20.0 * a2 * p.cos * p.cos));
        let (spin, before) = ([0.0, rate, 0.0], times(-roll_rate / p.edge, p.a));
        let gained = minus(cross(spin, minus(p.centre, p.k)), cross(before, p.centre));
        let impulse = times(self.mass, gained);
        // Along the middle line, from the apex: the impulses act half an edge beside it.
        let line = times(1.0 / p.slant, [self.circumradius * p.cos, 0.0, self.height]);
        let [across, along] = self.inertia();
        let turned = minus(spin, before);
        let momentum = [across * turned[0], across * turned[1], along * turned[2]];
        let middle = times(0.5, [p.a[0] + p.k[0], p.a[1] + p.k[1], p.a[2] + p.k[2]]);
        let of_sum = cross(minus(middle, p.centre), impulse);
        let half = self.circumradius * p.sin;
        // y × N is the line reversed or not: the sign of the moment of K's impulse.
        let lever = half * dot(cross([0.0, 1.0, 0.0], p.normal), line);
        let difference = dot(minus(momentum, of_sum), line) / lever;
        let sum = dot(impulse, p.normal);
        (spin, [0.0, 0.5 * (sum - difference), 0.5 * (sum + difference)])
    }
}
