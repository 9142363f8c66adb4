//! What is said of an end: what the tightest decision was about, between what a part jammed, by how much it missed.

use crate::part_view::PartView;
use crate::run::{Decided, Jam, JamKind, Touch};
use carom_motion::planar::{Margin, MarginOf, State, World};

/// Places along a flight at which its distance from the plate is looked at first. Between two of them the distance has one least value, for flights
/// that pass a plate.
const PLACES: u32 = 256;
/// Thirds by which the stretch around the nearest place is cut: what is left is 10⁻¹⁴ of the flight.
const CUTS: u32 = 70;

/// What the tightest decision was about.
pub(crate) fn decided(margin: &Margin) -> Decided {
    match margin.of {
        MarginOf::Nothing => Decided::Nothing,
        MarginOf::Rate => Decided::Contacts { time: margin.time },
        MarginOf::Impact => Decided::Impact { time: margin.time },
    }
}

/// Between what a part jammed.
pub(crate) fn jam(kind: JamKind, part: &impl PartView) -> Jam {
    let mut contacts: Vec<Touch> = vec![];
    let mut add = |obstacle, feature| {
        let touch = Touch { obstacle, feature };
        if !contacts.contains(&touch) {
            contacts.push(touch);
        }
    };
    match kind {
        JamKind::Wedged => part.each_held(&mut |h| add(h.obstacle, h.feature)),
        JamKind::Unresolved => part.each_in_touch(&mut add),
    }
    Jam { kind, contacts }
}

/// Least distance of the part from an obstacle in a flight that starts so and lasts so long [m].
pub(crate) fn nearest_in_flight(world: &World, obstacle: usize, start: &State, lasts: f64) -> Option<f64> {
    let at = |time: f64| world.distance(0, &start.flown(world.gravity, time), obstacle);
    let place = |i: u32| lasts * f64::from(i) / f64::from(PLACES);
    let nearest = (0..=PLACES).min_by(|i, j| at(place(*i)).total_cmp(&at(place(*j))))?;
    let (mut low, mut high) = (place(nearest.saturating_sub(1)), place((nearest + 1).min(PLACES)));
    for _ in 0..CUTS {
        let third = (high - low) / 3.0;
        if at(low + third) <= at(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    Some(at(0.5 * (low + high)).min(at(place(nearest))))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use carom_impact::Law;
    use carom_motion::planar::{Body, Obstacle, Pose, Shape, Twist};
    use carom_num::Vec2;

    /// A ball of 20 mm is thrown level at 1 m/s at g = 10 m/s². After 0.1 s it is at (0.1, −0.05) m and falls at 45°. A plate that starts 70 mm
    /// from there, square to the way on its outer side, and leads away from it, is missed by 50 mm.
    #[test]
    fn a_ball_misses_a_plate_by_the_distance_of_its_parabola() {
        let shape = Shape::new(vec![Vec2::ZERO], 0.02).unwrap();
        let body = Body { shape, mass: 0.1, inertia: 2e-5 };
        let outwards = Vec2::new(1.0, 1.0) / 2f64.sqrt();
        let edge = Vec2::new(0.1, -0.05) + outwards * 0.07;
        let plate = Obstacle::new(edge + outwards * 0.3, edge, 0.2, 0.0);
        let world = World::of_one(Vec2::new(0.0, -10.0), body, vec![plate], Law::Poisson);
        let thrown =
            State { pose: Pose::default(), twist: Twist { velocity: Vec2::new(1.0, 0.0), spin: 3.0 } };
        let missed = nearest_in_flight(&world, 0, &thrown, 1.0).unwrap();
        assert!((missed - 0.05).abs() < 1e-12, "{missed} m");
        // Of a flight that ends on the way the last place is the nearest.
        let short = nearest_in_flight(&world, 0, &thrown, 0.05).unwrap();
        let left = (Vec2::new(0.05, -0.0125) - edge).norm() - 0.02;
        assert!((short - left).abs() < 1e-12, "{short} m, not {left} m");
    }
}
