//! Small worlds that the examples of this module share: every number in them is round, so that a result can be checked by hand.

use crate::planar::{
    contact::World,
    geometry::{Body, Obstacle, Pose, Shape, State, Surface, Twist},
};
use carom_impact::Law;
use carom_num::Vec2;

/// A ball of 1 kg and radius 0.1 m at rest, its centre 0.3 m above a floor with μ = 0.3 and e = 1/2; g = 10 m/s².
///
/// It falls 0.2 m in 0.2 s and strikes with 2 m/s. The floor is the line y = 0 from x = −1 m to 9 m.
pub fn falling_ball() -> (World, State) {
    (over_floor(), State { pose: Pose { centre: Vec2::new(0.0, 0.3), angle: 0.0 }, twist: Twist::default() })
}

/// The ball of [`falling_ball`] on the floor, sliding to the right with 3 m/s and without spin.
pub fn sliding_ball() -> (World, State) {
    let twist = Twist { velocity: Vec2::new(3.0, 0.0), spin: 0.0 };
    (over_floor(), State { pose: Pose { centre: Vec2::new(0.0, 0.1), angle: 0.0 }, twist })
}

fn over_floor() -> World {
    let floor = Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::new(9.0, 0.0), 0.3, 0.5);
    World::of_one(Vec2::new(0.0, -10.0), disc(0.1, 1.0, 0.005), vec![floor], Law::Poisson)
}

/// A block of 0.4 m by 0.2 m and 1 kg that lies on a floor with this friction, under this gravity [m/s²]. Face 0 is its lower one.
pub fn lying_block(gravity: Vec2, friction: f64) -> (World, State) {
    let corners = [(-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1)].map(|(x, y)| Vec2::new(x, y));
    let block = Body { shape: Shape::of_checked(corners.to_vec(), 0.0), mass: 1.0, inertia: 0.2 / 12.0 };
    let floor = Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), friction, 0.0);
    let state = State { pose: Pose { centre: Vec2::new(0.0, 0.1), angle: 0.0 }, twist: Twist::default() };
    (World::of_one(gravity, block, vec![floor], Law::Poisson), state)
}

/// Two balls of 1 kg and 3 kg and radius 0.1 m without gravity; between them μ = 0.2 and e = 1/2.
pub fn two_balls() -> World {
    let between = Surface { friction: 0.2, restitution: 0.5 };
    let bodies = vec![disc(0.1, 1.0, 0.005), disc(0.1, 3.0, 0.015)];
    World { gravity: Vec2::ZERO, bodies, obstacles: vec![], between, law: Law::Poisson }
}

/// A body with its centre at x [m] on the x axis, moving along it with a speed [m/s], without spin.
pub fn on_the_axis(x: f64, speed: f64) -> State {
    let pose = Pose { centre: Vec2::new(x, 0.0), angle: 0.0 };
    State { pose, twist: Twist { velocity: Vec2::new(speed, 0.0), spin: 0.0 } }
}

/// A disc of this radius \[m\], mass \[kg\] and inertia [kg m²]; the numbers are not checked.
pub fn disc(radius: f64, mass: f64, inertia: f64) -> Body {
    Body { shape: Shape::of_checked(vec![Vec2::ZERO], radius), mass, inertia }
}

/// A rod of this length \[m\], mass \[kg\] and inertia [kg m²] along x, without thickness; the numbers are not checked.
pub fn rod(length: f64, mass: f64, inertia: f64) -> Body {
    let half = 0.5 * length;
    Body { shape: Shape::of_checked(vec![Vec2::new(-half, 0.0), Vec2::new(half, 0.0)], 0.0), mass, inertia }
}
