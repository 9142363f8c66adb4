//! When does a bouncing disc come to rest, and after how many impacts?
//!
//! ```sh
//! cargo run -p carom --example when_does_it_stop
//! ```
//!
//! Dropped from a height h it bounces infinitely often and stops after `√(2h/g) (1 + e)/(1 − e)`. The walk takes it to lie
//! once a flight would last less than 1e-7 of √(size/g), here 1e-8 s, and so stops 1e-8/(1 − e) s early at most.
#![expect(clippy::print_stdout, reason = "a program that answers a question")]

use carom::motion::planar::{Body, Happening, Obstacle, Shape, Walker, World};
use carom::prelude::*;

const HEIGHT: f64 = 1.25;
const RADIUS: f64 = 0.1;
const GRAVITY: f64 = 10.0;

fn main() -> Result<(), Error> {
    println!("  e   stops at s   closed form   impacts walked");
    for restitution in [0.0, 0.2, 0.4, 0.6, 0.8, 0.9] {
        let (time, impacts) = stop(restitution)?;
        let limit = (2.0 * HEIGHT / GRAVITY).sqrt() * (1.0 + restitution) / (1.0 - restitution);
        println!("{restitution:>4.1} {time:>12.8} {limit:>13.8} {impacts:>16}");
    }
    Ok(())
}

fn stop(restitution: f64) -> Result<(f64, u64), Error> {
    let world = World::of_one(
        Vec2::new(0.0, -GRAVITY),
        Body { shape: Shape::new(vec![Vec2::ZERO], RADIUS)?, mass: 1.0, inertia: 0.005 },
        vec![Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::new(1.0, 0.0), 0.3, restitution)],
        Law::Poisson,
    );
    let start =
        State { pose: Pose { centre: Vec2::new(0.0, RADIUS + HEIGHT), angle: 0.0 }, twist: Twist::default() };
    let mut walker = Walker::new(&world, start, vec![true], Options::default())?;
    while walker.advance(&mut ())? == Happening::Moves {}
    Ok((walker.time(), walker.effort().impacts))
}
