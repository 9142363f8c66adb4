//! For how long a pair that has just opened in flight stays open.

use super::flight::Known;
use crate::planar::contact::{
    World,
    kinematics::{Kinematics, Pairing, Turn},
};
use crate::planar::geometry::{Feature, State};
use crate::planar::modes::watch::leading;

impl World {
    /// A time up to which a pair that opens from zero gap stays open for certain, by the Taylor series of its gap [s].
    pub(super) fn left_zero_after(&self, start: &State, pair: Pairing, known: &Known<'_>) -> f64 {
        let scales = &known.scales;
        let horizon = scales.time;
        let speed = start.twist.velocity.norm() + self.gravity.norm() * horizon;
        let mut w = start.twist.spin.abs();
        // The centre of a shallow arc lies farther away than the body is large.
        let shape = &self.body_of(pair).shape;
        let size = shape.size().max(shape.reach());
        let k = self.kinematics(std::array::from_ref(start), pair);
        if let Feature::VertexOnEnd { vertex, end } = pair.feature {
            // The line between two vertices turns as they pass each other.
            let distance = (shape.radius_of(vertex) + self.met(pair).radius_of(end)).abs();
            w += (speed + w * size) / distance;
        }
        let derivatives = self.gap_derivatives(start, pair, &k);
        let reach = k.arm.norm() + size + speed * horizon;
        let g = self.gravity.norm();
        let mut unit = 1.0 / scales.length;
        let rates = derivatives.map(|d| {
            unit *= scales.time;
            d * unit
        });
        let Some(order) = leading(&rates, known.significant, true) else { return 0.0 };
        // The bound of the next derivative comes from the product rule for a turning normal and a falling point.
        let n = f64::from(order + 1);
        let next = w.powi(order + 1) * reach
            + n * w.powi(order) * speed
            + 0.5 * n * (n - 1.0) * w.powi(order - 1) * g;
        let d = (1..).zip(derivatives).find_map(|(of, d)| (of == order).then_some(d)).unwrap_or(0.0);
        if d < 0.0 { 0.0 } else { (0.5 * n * d / next.max(f64::MIN_POSITIVE)).min(horizon) }
    }

    /// First four derivatives of a pair's gap in flight.
    fn gap_derivatives(&self, state: &State, pair: Pairing, k: &Kinematics) -> [f64; 4] {
        let (v, w, g) = (state.twist.velocity, state.twist.spin, self.gravity);
        let second = k.normal_bias + k.normal.dot(g);
        match pair.feature {
            Feature::VertexOnFace { vertex, .. } => {
                let r = Turn::of(state).apply(self.bodies[0].shape.vertices()[vertex]);
                [k.approach, second, -w.powi(3) * k.normal.dot(r.turned_left()), w.powi(4) * k.normal.dot(r)]
            }
            Feature::FaceOnEnd { .. } => {
                // n turns with the body: n′ = ω p, n″ = −ω² n, … ; d = centre − end.
                let (n, p, d) = (k.normal, k.normal.turned_left(), -k.arm);
                let third = -w.powi(3) * p.dot(d) - 3.0 * w * w * n.dot(v) + 3.0 * w * p.dot(g);
                let fourth = w.powi(4) * n.dot(d) - 4.0 * w.powi(3) * p.dot(v) - 6.0 * w * w * n.dot(g);
                [k.approach, second, third, fourth]
            }
            Feature::VertexOnEnd { .. } => [k.approach, second, 0.0, 0.0],
        }
    }
}
