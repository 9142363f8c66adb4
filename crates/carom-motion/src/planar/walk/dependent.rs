//! Constraints that almost say the same, as those of two ends that nearly touch each other.
//!
//! The matrix of their responses holds the square of what they differ by, and elimination takes them for one. Here each is made into a
//! direction at right angles, in the mass metric, to those before it, which keeps what they differ by itself.

use super::project::Row;
use crate::planar::contact::World;
use crate::tolerance::DEPENDENT_ROW;
use carom_num::Vec2;

/// Velocities and spins of all bodies.
type Motions<const B: usize> = [(Vec2, f64); B];

/// A row, as the motion that a unit impulse along it makes. The directions that were found before are taken out of it.
#[derive(Clone, Copy)]
struct Rest<const B: usize> {
    motion: Motions<B>,
    /// Of the whole row.
    size: f64,
    rate: f64,
}

impl World {
    /// The least shifts (of velocities, of spins) in the mass metric that take the residuals of the rows away.
    pub(super) fn shift_by_directions<const B: usize, const R: usize>(&self, rows: &[Row]) -> Motions<B> {
        let still = [(Vec2::ZERO, 0.0); B];
        let mut rests = [Rest { motion: still, size: 0.0, rate: 0.0 }; R];
        for (rest, row) in rests.iter_mut().zip(rows) {
            for (body, along, angle) in self.motion_along(&row.line) {
                rest.motion[body] = (rest.motion[body].0 + along, rest.motion[body].1 + angle);
            }
            rest.size = self.product(&rest.motion, &rest.motion).sqrt();
            rest.rate = row.residual;
        }
        let rests = &mut rests[..rows.len()];
        let (mut shift, mut found, mut known) = (still, [still; R], 0);
        while known < rests.len()
            && let Some((direction, by)) = self.clearest(rests, &found[..known])
        {
            add(&mut shift, &direction, by);
            for rest in rests.iter_mut() {
                let along = self.product(&rest.motion, &direction);
                add(&mut rest.motion, &direction, -along);
                rest.rate += by * along;
            }
            found[known] = direction;
            known += 1;
        }
        shift
    }

    /// The direction of the row that has most left, and how far to go along it to take its rate away.
    fn clearest<const B: usize>(&self, rests: &[Rest<B>], found: &[Motions<B>]) -> Option<(Motions<B>, f64)> {
        let left = |rest: &Rest<B>| self.product(&rest.motion, &rest.motion).sqrt() / rest.size;
        // A row of nothing leaves no number.
        let some = rests.iter().filter(|rest| left(rest) > DEPENDENT_ROW);
        let rest = some.max_by(|a, b| left(a).total_cmp(&left(b)))?;
        // Once more: what rounding has left of the directions that are known would count for much beside so little.
        let mut motion = rest.motion;
        for direction in found {
            let along = self.product(&motion, direction);
            add(&mut motion, direction, -along);
        }
        let size = self.product(&motion, &motion).sqrt();
        Some((motion.map(|(way, angle)| (way * (1.0 / size), angle / size)), -rest.rate / size))
    }

    /// Product of two motions in the mass metric: twice the kinetic energy, of one with itself.
    fn product<const B: usize>(&self, a: &Motions<B>, b: &Motions<B>) -> f64 {
        let of = self.bodies.iter().zip(a.iter().zip(b));
        of.map(|(body, (a, b))| body.mass * a.0.dot(b.0) + body.inertia * a.1 * b.1).sum()
    }
}

/// Adds so much of another motion.
fn add<const B: usize>(to: &mut Motions<B>, other: &Motions<B>, by: f64) {
    for (a, b) in to.iter_mut().zip(other) {
        *a = (a.0 + b.0 * by, a.1 + b.1 * by);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planar::contact::kinematics::Kinematics;
    use crate::planar::geometry::{Body, Shape};
    use crate::planar::modes::line::Line;
    use carom_impact::Law;

    const UP: Vec2 = Vec2 { x: 0.0, y: 1.0 };
    const MOTION: (Vec2, f64) = (Vec2 { x: 0.3, y: -0.2 }, 0.8);

    /// Rates of feet on a floor, at these places of a body whose mass centre is half a metre above it.
    fn rows(feet: &[f64]) -> Vec<Row> {
        let row = |x: &f64| {
            let line = Line::alone(&Kinematics { arm: Vec2::new(*x, -0.5), ..Kinematics::default() }, UP);
            Row { line, residual: line.direction.dot(MOTION.0) + line.moment * MOTION.1 }
        };
        feet.iter().map(row).collect()
    }

    fn world() -> World {
        let shape = Shape::new(vec![Vec2::ZERO], 0.5).unwrap();
        World::of_one(Vec2::new(0.0, -10.0), Body { shape, mass: 2.0, inertia: 0.7 }, vec![], Law::Poisson)
    }

    #[test]
    fn feet_a_hair_apart_stop_what_they_can_and_no_more() {
        for apart in [1.0, 1e-3, 1e-6, 1e-9] {
            let [(way, angle)] = world().shift_by_directions::<1, 6>(&rows(&[0.2, 0.2 + apart, 0.2]));
            // Two feet let the body slide and do nothing else.
            let after = (MOTION.0 + way, MOTION.1 + angle);
            assert!((after.0.x - 0.3).abs() < 1e-15, "{apart:e} {after:?}");
            assert!(after.0.y.abs() + after.1.abs() < 1e-15 / apart, "{apart:e} {after:?}");
        }
    }

    #[test]
    fn rows_that_say_the_same_are_one() {
        let one = world().shift_by_directions::<1, 6>(&rows(&[0.2]));
        assert_eq!(one, world().shift_by_directions::<1, 6>(&rows(&[0.2; 4])));
        // The foot stops: m Δv = p, J Δω = x p.
        let p = (0.2 - 0.2 * 0.8) / (1.0 / 2.0 + 0.2 * 0.2 / 0.7);
        let [(way, angle)] = one;
        assert!((way.y - p / 2.0).abs() < 1e-15 && (angle - 0.2 * p / 0.7).abs() < 1e-15, "{one:?} {p}");
    }
}
