//! A corner's strike by its two angles against the same strike in the world.

use carom_impact::Law;
use carom_impact::planar::{ContactSet2, ImpactType, Touch, staged};
use carom_num::Vec2;
use carom_study::corner::Striker;

/// The part of the published feeder.
const ROD: Striker =
    Striker { length: 0.1, height: 0.0, mass: 0.3, inertia: 2.5e-4, friction: 0.15, restitution: 0.0 };
/// Spins reach 100 rad/s, and an impact cancels two digits.
const ROUNDING: f64 = 1e-11;

#[test]
fn the_strike_is_that_of_the_part_in_the_world() {
    for k in 0..400 {
        let (i, j) = (f64::from(k % 20), f64::from(k / 20));
        let [angle, incidence] = [-1.43 + 0.149 * i, -1.41 + 0.147 * j];
        let part = Striker { friction: 0.05 * (i + 1.0), restitution: 0.04 * j, ..ROD };
        let (speed, spin) = (1.87, 7.6 - i);
        let ours = part.strike([angle, incidence], speed, spin).unwrap();
        // The middle lies half a length from the corner along the axis, which leans from the normal (up) to the left.
        let axis = Vec2::at_angle(angle).turned_left();
        let arm = axis * (-0.5 * part.length);
        let corner = Vec2::at_angle(incidence).turned_right() * speed;
        let velocity = corner - arm.turned_left() * spin;
        let touch = Touch {
            arm,
            normal: Vec2::new(0.0, 1.0),
            friction: part.friction,
            restitution: part.restitution,
        };
        let set = ContactSet2::of_free_body(part.mass, part.inertia, velocity, spin, &[touch]).unwrap();
        let out = staged::resolve(&set, Law::Poisson).unwrap();
        let [tangential, normal] = out.impulse[0];
        let after = spin + arm.cross(Vec2::new(tangential, normal)) / part.inertia;
        assert!(
            (ours.spin - after).abs() <= ROUNDING * (1.0 + after.abs()),
            "{angle} {incidence}: {ours:?} {after}"
        );
    }
}

#[test]
fn a_mirror_image_turns_the_other_way() {
    let part = Striker { height: 0.03, friction: 0.3, restitution: 0.4, ..ROD };
    for [angle, incidence] in [[0.4, -0.3], [-0.2, 0.9], [1.1, 0.2]] {
        let (one, other) =
            (part.strike([angle, incidence], 2.0, 5.0), part.strike([-angle, -incidence], 2.0, -5.0));
        let (one, other) = (one.unwrap(), other.unwrap());
        assert_eq!(one.kind, other.kind, "the same type");
        assert!((one.spin + other.spin).abs() <= ROUNDING * (1.0 + one.spin.abs()), "{one:?} {other:?}");
    }
}

#[test]
fn the_second_case_of_the_feeder_slides_throughout_and_turns_on() {
    // The printed state before: φ_K = 32.1°; in plate axes (down, out) the centre moves with (0.558, −1.852) m/s, spin 7.637 rad/s.
    let angle = 32.15f64.to_radians();
    let arm = Vec2::at_angle(angle).turned_left() * -0.05;
    let corner = Vec2::new(0.558, -1.852) + arm.turned_left() * 7.637;
    let incidence = carom_num::elementary::atan2(corner.x, -corner.y);
    let out = ROD.strike([angle, incidence], corner.norm(), 7.637).unwrap();
    assert_eq!(out.kind, Some(ImpactType::SlidesThroughout), "type 1");
    // From this state the balance of momentum gives 31.97 rad/s; the angle is printed to 0.1°, which is worth 0.03.
    assert!((out.spin - 31.972).abs() < 0.05, "{out:?}");
}
