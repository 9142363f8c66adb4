//! Volume, mass centre and moments of inertia of bodies about an axis: solids of revolution and hexagonal prisms.

use super::ChainPoint;
use carom_num::Vec2;
use carom_num::elementary::{sin, sin_cos};
use carom_num::quadrature::GAUSS_LEGENDRE_8;
use std::f64::consts::{FRAC_PI_8, PI};

/// Volume and moments of a body about an axis that lies in the plane of motion, each for a density of 1 kg/m³.
///
/// The body looks alike from every side that it is seen from across the axis, as far as second moments go: a solid of revolution, or a prism with
/// three equal sides or more. So half of the moment about the axis is that of the distances across it.
///
/// # Example
/// A cylinder of radius 1 m from 0 to 3 m: the moment of inertia across its axis is m (r²/4 + h²/12).
/// ```
/// use carom_motion::planar::{AxialMoments, ChainPoint};
/// use carom_num::Vec2;
/// let profile = [(0.0, 0.0), (0.0, 1.0), (3.0, 1.0), (3.0, 0.0)].map(|(z, r)| ChainPoint::straight(Vec2::new(z, r)));
/// let cylinder = AxialMoments::of_revolution(&profile);
/// assert!((cylinder.volume - 3.0 * std::f64::consts::PI).abs() < 1e-14);
/// assert!((cylinder.centre() - 1.5).abs() < 1e-15 && (cylinder.gyration_squared() - 1.0).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AxialMoments {
    /// Volume \[m³\].
    pub volume: f64,
    /// First moment along the axis, from its zero \[m⁴\].
    pub first: f64,
    /// Second moment of the distances along the axis, ∫ z² dV \[m⁵\].
    pub along: f64,
    /// Second moment of the distances from the axis, ∫ r² dV \[m⁵\]: the moment of inertia about the axis.
    pub about: f64,
}

impl AxialMoments {
    /// Of the solid that a closed meridian sweeps out round the axis.
    ///
    /// A point of the meridian is (z, r): z along the axis, and the distance r from it, which is nowhere negative. It may run either way round.
    ///
    /// Pappus' rule says that an area dA of the meridian sweeps out 2π r dA; Green's theorem turns the areas into integrals along the meridian, of
    /// which those along the axis are zero:
    ///
    /// ```text
    /// V = π ∮ r² dz     S = π ∮ z r² dz     ∫ z² dV = π ∮ z² r² dz     ∫ r² dV = π/2 ∮ r⁴ dz
    /// ```
    ///
    /// On a straight edge the integrands are polynomials of degree 4 at most, which the Gauss–Legendre rule of eight points integrates exactly.
    /// An arc is cut into pieces of at most 22.5°, on which it is exact to rounding: its error is below 10⁻¹⁷ of the arc's own share.
    ///
    /// # Source
    /// Pappus' and Guldin's second rule for volumes, and bodies of revolution as sums of thin discs for their moments: Beer & Johnston, Vector
    /// Mechanics for Engineers: Statics, chapters 5 and 9.
    ///
    /// # Example
    /// Half a ball of radius 1 m has its mass centre 3/8 m from its flat side.
    /// ```
    /// use carom_motion::planar::{AxialMoments, ChainPoint};
    /// use carom_num::Vec2;
    /// let quarter = ChainPoint { at: Vec2::new(0.0, 1.0), sweep: -std::f64::consts::FRAC_PI_2 };
    /// let meridian = [ChainPoint::straight(Vec2::ZERO), quarter, ChainPoint::straight(Vec2::new(1.0, 0.0))];
    /// assert!((AxialMoments::of_revolution(&meridian).centre() - 0.375).abs() < 1e-15);
    /// ```
    pub fn of_revolution(meridian: &[ChainPoint]) -> Self {
        let mut sum = Self::default();
        for (i, from) in meridian.iter().enumerate() {
            sum.add_edge(from, meridian[(i + 1) % meridian.len()].at);
        }
        // Counter-clockwise above the axis, a meridian comes back over it.
        if sum.volume < 0.0 { Self::default().without(sum) } else { sum }
    }

    fn add_edge(&mut self, from: &ChainPoint, to: Vec2) {
        let pieces = (from.sweep.abs() / FRAC_PI_8).ceil().clamp(1.0, 16.0) as usize;
        for piece in 0..pieces {
            let (start, width) = (piece as f64 / pieces as f64, 1.0 / pieces as f64);
            for (node, weight) in GAUSS_LEGENDRE_8 {
                for node in [-node, node] {
                    let (p, velocity) = along_edge(from, to, start + 0.5 * width * (1.0 + node));
                    let dz = velocity.x * (0.5 * width * weight);
                    let disc = PI * p.y * p.y * dz;
                    self.volume += disc;
                    self.first += p.x * disc;
                    self.along += p.x * p.x * disc;
                    self.about += 0.5 * p.y * p.y * disc;
                }
            }
        }
    }

    /// Of a prism with a regular hexagon across the axis, between two places on it [m], `across_flats` [m] from side to side.
    ///
    /// ```text
    /// A = √3/2 s²     polar moment of the area about its middle: 5√3/72 s⁴
    /// ```
    ///
    /// # Source
    /// Young & Budynas, Roark's Formulas for Stress and Strain, 7th edition, table A.1: a regular hexagon of side a = s/√3 has I = 5√3/16 a⁴ about
    /// every axis through its middle.
    ///
    /// # Example
    /// A hexagon of 2 m across flats has the area 2√3 m².
    /// ```
    /// use carom_motion::planar::AxialMoments;
    /// let prism = AxialMoments::of_hexagonal_prism(0.0, 1.0, 2.0);
    /// assert!((prism.volume - 12_f64.sqrt()).abs() < 1e-15 && (prism.centre() - 0.5).abs() < 1e-15);
    /// ```
    pub fn of_hexagonal_prism(from: f64, to: f64, across_flats: f64) -> Self {
        let squared = across_flats * across_flats;
        let (area, long, middle) = (0.5 * 3f64.sqrt() * squared, (to - from).abs(), 0.5 * (from + to));
        let volume = area * long;
        Self {
            volume,
            first: volume * middle,
            along: volume * (middle * middle + long * long / 12.0),
            about: 5.0 * 3f64.sqrt() / 72.0 * squared * squared * long,
        }
    }

    /// Both bodies together.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::AxialMoments;
    /// let [a, b, whole] = [(0.0, 1.0), (1.0, 3.0), (0.0, 3.0)].map(|(z, to)| AxialMoments::of_hexagonal_prism(z, to, 1.0));
    /// assert!((a.with(b).gyration_squared() - whole.gyration_squared()).abs() < 1e-15);
    /// ```
    #[must_use]
    pub fn with(self, other: Self) -> Self {
        Self {
            volume: self.volume + other.volume,
            first: self.first + other.first,
            along: self.along + other.along,
            about: self.about + other.about,
        }
    }

    /// This body with another one cut out of it.
    ///
    /// # Example
    /// ```
    /// use carom_motion::planar::AxialMoments;
    /// let prism = AxialMoments::of_hexagonal_prism(0.0, 1.0, 2.0);
    /// assert_eq!(prism.without(prism), AxialMoments::default());
    /// ```
    #[must_use]
    pub fn without(self, other: Self) -> Self {
        Self {
            volume: self.volume - other.volume,
            first: self.first - other.first,
            along: self.along - other.along,
            about: self.about - other.about,
        }
    }

    /// The place of the mass centre on the axis [m].
    pub fn centre(&self) -> f64 {
        self.first / self.volume
    }

    /// Moment of inertia across the axis, about the mass centre, divided by the mass \[m²\]: that of the body as it turns in the plane of motion.
    ///
    /// ```text
    /// k² = (½ ∫ r² dV + ∫ z² dV) / V − z̄²
    /// ```
    ///
    /// # Source
    /// Beer & Johnston, Vector Mechanics for Engineers: Statics, chapter 9: a thin disc has half of its moment about the axis across it; the
    /// parallel-axis theorem.
    ///
    /// # Example
    /// A ball has 2/5 of its radius squared.
    /// ```
    /// use carom_motion::planar::{AxialMoments, ChainPoint};
    /// use carom_num::Vec2;
    /// let half = ChainPoint { at: Vec2::new(-1.0, 0.0), sweep: -std::f64::consts::PI };
    /// let ball = AxialMoments::of_revolution(&[half, ChainPoint::straight(Vec2::new(1.0, 0.0))]);
    /// assert!((ball.gyration_squared() - 0.4).abs() < 1e-15);
    /// ```
    pub fn gyration_squared(&self) -> f64 {
        let centre = self.centre();
        (0.5 * self.about + self.along) / self.volume - centre * centre
    }
}

/// The point of an edge at a share of its way, and how fast it goes there with that share.
fn along_edge(from: &ChainPoint, to: Vec2, share: f64) -> (Vec2, Vec2) {
    let (chord, half) = (to - from.at, 0.5 * from.sweep);
    let point = from.along(to, share);
    if half == 0.0 {
        return (point, chord);
    }
    let (sine, cos) = sin_cos(half * (2.0 * share - 1.0));
    (point, chord.rotated(cos, sine) * (half / sin(half)))
}
