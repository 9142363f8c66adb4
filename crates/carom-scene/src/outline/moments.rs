//! Area, centroid and polar moment of what closed loops of edges enclose.

use super::edge::Edge;
use carom_motion::planar::MassProperties;
use carom_num::Vec2;
use carom_num::quadrature::GAUSS_LEGENDRE_8;
use std::f64::consts::FRAC_PI_4;

/// Area and moments about a point, counter-clockwise loops counting positive.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Moments {
    pub(crate) area: f64,
    first: Vec2,
    polar: f64,
}

impl Moments {
    /// Of what a closed loop encloses, about a point.
    ///
    /// Green's theorem turns each moment into an integral along the edges:
    ///
    /// ```text
    /// A = ½ ∮ p × dp     S = ⅓ ∮ p (p × dp)     J = ¼ ∮ |p|² (p × dp)
    /// ```
    ///
    /// On a line or a cubic the integrands are polynomials of degree 11 at most, which the rule integrates exactly.
    /// An arc is cut into pieces of at most 45°, on which the rule is exact to rounding: its error is below 10⁻¹⁵ of r², r³ or r⁴.
    pub(crate) fn of<'e>(edges: impl IntoIterator<Item = &'e Edge>, about: Vec2) -> Self {
        let mut sum = Self::default();
        for edge in edges {
            let pieces = match edge {
                Edge::Arc(arc) => (arc.sweep.abs() / FRAC_PI_4).ceil().clamp(1.0, 16.0) as usize,
                Edge::Line { .. } | Edge::Cubic(_) => 1,
            };
            for piece in 0..pieces {
                sum.add_piece(edge, about, piece as f64 / pieces as f64, 1.0 / pieces as f64);
            }
        }
        sum
    }

    fn add_piece(&mut self, edge: &Edge, about: Vec2, start: f64, width: f64) {
        for (node, weight) in GAUSS_LEGENDRE_8 {
            for node in [-node, node] {
                let s = start + 0.5 * width * (1.0 + node);
                let p = edge.point(s) - about;
                let turned = p.cross(edge.velocity(s)) * (0.5 * width * weight);
                self.area += 0.5 * turned;
                self.first += p * (turned / 3.0);
                self.polar += 0.25 * p.dot(p) * turned;
            }
        }
    }

    /// This with something added.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            area: self.area + other.area,
            first: self.first + other.first,
            polar: self.polar + other.polar,
        }
    }

    /// Of a uniform plate; the moments are about `about`.
    pub(crate) fn properties(self, about: Vec2) -> MassProperties {
        let centroid = self.first / self.area;
        let gyration_squared = self.polar / self.area - centroid.dot(centroid);
        MassProperties { area: self.area, centroid: about + centroid, gyration_squared }
    }
}
