//! A prism that turns about its edge A until the next one, K, strikes the plane it rolls on.

use super::bodies::{MassSpec, Setup, unfit};
use crate::grammar::Section;
use crate::tolerance::EDGE_TOUCHES;
use carom_motion::planar::{Body, MassProperties, Pose, Shape, State, Twist};
use carom_num::Vec2;
use std::f64::consts::PI;

/// The keys of an irregular prism: from A along the plane to below the mass centre, from there to K, and the mass centre's height.
const IRREGULAR: [&str; 3] = ["a_to_centre", "centre_to_k", "height"];
/// Plane behind the prism and beyond the last strike, in sides.
const SPARE: f64 = 8.0;

pub(super) fn read(root: &Section<'_>, strikes: Option<u32>) -> Option<Setup> {
    let mass = MassSpec::read(root);
    let outline = if IRREGULAR.iter().any(|key| root.has(key)) { irregular(root) } else { regular(root) };
    let slope = root.number("slope");
    let tilt = root.number("tilt");
    let roll_rate = root.number("roll_rate");
    if roll_rate <= 0.0 && tilt == 0.0 {
        unfit(
            root,
            "roll_rate",
            "must be above 0 where the face starts flat: the prism turns forward about A",
        );
    }
    let Outline { vertices, arm } = outline?;
    let (a, k) = (vertices[0], vertices[1]);
    let shape = match Shape::new(vertices, 0.0) {
        Ok(shape) => shape,
        Err(problems) => {
            let message = problems.first().map(ToString::to_string).unwrap_or_default();
            unfit(root, "height", message);
            return None;
        }
    };
    let inertia = mass.inertia(arm, MassProperties::of(&shape).gyration_squared);
    // A stands at the origin; the plane goes down to +x.
    let turn = Vec2::at_angle(tilt - slope);
    let centre = -a.rotated(turn.x, turn.y);
    let along = Vec2::at_angle(-slope);
    let below =
        |v: &Vec2| (v.rotated(turn.x, turn.y) + centre).dot(along.turned_left()) < -EDGE_TOUCHES * arm;
    if shape.vertices().iter().any(below) {
        unfit(root, "tilt", "is so large that the edge behind A would be below the plane");
        return None;
    }
    let start = State {
        pose: Pose { centre, angle: tilt - slope },
        twist: Twist { velocity: centre.turned_right() * roll_rate, spin: -roll_rate },
    };
    let side = (k - a).norm().max(arm);
    let ahead = f64::from(strikes.unwrap_or(1)) + SPARE;
    let plane = [along * (-SPARE * side), along * (ahead * side)];
    Some(Setup {
        body: Body { shape, mass: mass.mass, inertia },
        segments: vec![("plane".to_owned(), plane)],
        unreached: vec![],
        start,
    })
}

/// Vertices about the mass centre, counter-clockwise from A and K; and the distance from A to the mass centre.
struct Outline {
    vertices: Vec<Vec2>,
    arm: f64,
}

fn regular(root: &Section<'_>) -> Option<Outline> {
    let (sides, arm) = (root.number("sides"), root.number("circumradius"));
    if sides < 3.0 {
        unfit(root, "sides", "must be 3 or more");
        return None;
    }
    // A is the left end of the lowest side.
    let mut vertices = vec![];
    let mut i = 0.0;
    while i < sides {
        vertices.push(Vec2::at_angle(-0.5 * PI + (2.0 * i - 1.0) * PI / sides) * arm);
        i += 1.0;
    }
    Some(Outline { vertices, arm })
}

/// A, K and the points opposite to them about the mass centre: the outline beyond A and K is not given, and a parallelogram is one that has
/// its centroid there.
fn irregular(root: &Section<'_>) -> Option<Outline> {
    let [d_a, d_k, h] = IRREGULAR.map(|key| root.value(key));
    let (d_a, d_k, h) = (d_a?, d_k?, h?);
    let (a, k) = (Vec2::new(-d_a, -h), Vec2::new(d_k, -h));
    Some(Outline { vertices: vec![a, k, -a, -k], arm: a.norm() })
}
