//! A thin rod on two point supports, A behind its middle and B before it.

use super::bodies::{MassSpec, Setup, unfit};
use crate::grammar::{Section, roll::DEFAULT_RELEASE};
use crate::tolerance::ROD_OVERHANG;
use carom_motion::planar::{Body, Pose, Shape, State, Twist};
use carom_num::Vec2;

const DEFAULT_ARM: f64 = 0.25;
/// Height of the posts that carry the supports, in lengths of the rod.
const POST: f64 = 0.3;

pub(super) fn read(root: &Section<'_>) -> Option<Setup> {
    let mass = MassSpec::read(root);
    let length = root.number("length");
    let arm = |key: &'static str| {
        let arm = root.value(key).unwrap_or(DEFAULT_ARM * length);
        if arm > 0.5 * length {
            unfit(
                root,
                key,
                format!("must be at most half the length, {} m: the rod lies on it", 0.5 * length),
            );
        }
        arm
    };
    let (to_a, to_b) = (arm("to_a"), arm("to_b"));
    let release = root.value("release");
    let roll_rate = root.value("roll_rate");
    let release = release.unwrap_or(if roll_rate.is_some() { 0.0 } else { DEFAULT_RELEASE });
    let roll_rate = roll_rate.unwrap_or(0.0);
    if release == 0.0 && roll_rate <= 0.0 {
        unfit(root, "roll_rate", "must be above 0 where the rod starts level: it turns about A down to B");
    }
    let half = 0.5 * length;
    let reach = half.max(to_a.max(to_b) + ROD_OVERHANG * length);
    let shape = Shape::new(vec![Vec2::new(-reach, 0.0), Vec2::new(reach, 0.0)], 0.0).ok()?;
    let inertia = mass.inertia(half, length * length / 12.0);
    // The mass centre starts `to_a` from A, along the rod; level, it is at the origin.
    let (a, b) = (Vec2::new(-to_a, 0.0), Vec2::new(to_b, 0.0));
    let from_a = Vec2::at_angle(release) * to_a;
    let start = State {
        pose: Pose { centre: a + from_a, angle: release },
        twist: Twist { velocity: from_a.turned_right() * roll_rate, spin: -roll_rate },
    };
    let foot = Vec2::new(0.0, -POST * length);
    Some(Setup {
        body: Body { shape, mass: mass.mass, inertia },
        segments: vec![("A".to_owned(), [a + foot, a]), ("B".to_owned(), [b + foot, b])],
        unreached: vec![],
        start,
    })
}
