//! A throw in the plane, on level ground.

use super::{Pose, Spent, Thrown};
use carom_motion::MotionError;
use carom_motion::planar::{Happening, Options, Shape, State, Walker, World};
use carom_num::Vec2;

/// Follows a throw of the only body of a world to its end. Obstacle 0 is level ground; faces are numbered as [`Shape::rests`].
///
/// A body that rolls to and fro on an arc for ever, because nothing takes energy from it, is on the face of that arc where it has too little energy
/// to leave it. One that lies flat and slides without friction is on its face as well.
///
/// # Example
/// A square of 2 m whose centre is let go 1.5 m above the ground, and tilted by 10°, comes to lie on the side that was below; tilted by 80°, on the next
/// one.
/// ```
/// use carom_impact::Law;
/// use carom_motion::planar::{Body, Obstacle, Options, Pose as Place, Shape, State, World};
/// use carom_num::Vec2;
/// use carom_study::poses::{Pose, thrown_in_plane};
/// let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
/// let shape = Shape::new(corners.to_vec(), 0.0).unwrap();
/// let square = Body { shape, mass: 1.0, inertia: 2.0 / 3.0 };
/// let ground = Obstacle::new(Vec2::new(-50.0, 0.0), Vec2::new(50.0, 0.0), 0.3, 0.0);
/// let world = World::of_one(Vec2::new(0.0, -9.81), square, vec![ground], Law::Poisson);
/// let thrown = |degrees: f64| {
///     let pose = Place { centre: Vec2::new(0.0, 1.5), angle: degrees.to_radians() };
///     thrown_in_plane((&world, &Options::default()), &State { pose, ..State::default() }).pose
/// };
/// assert_eq!((thrown(10.0), thrown(80.0)), (Pose::Face(0), Pose::Face(3)));
/// ```
pub fn thrown_in_plane((world, options): (&World, &Options), release: &State) -> Thrown {
    followed(world, *options, release).unwrap_or(Thrown::LOST)
}

fn followed(world: &World, options: Options, release: &State) -> Result<Thrown, MotionError> {
    let mut walker = Walker::new(world, *release, vec![], options)?.ending_at_swings();
    let pose = loop {
        match walker.advance(&mut ())? {
            Happening::Moves => {}
            Happening::Rests => break rest(&walker, world),
            Happening::Swings => break swing(walker.state(), world),
            Happening::Jams => break Pose::NoConsistentOutcome,
            Happening::GivenUp => break Pose::Failed,
            // It has run off the ground's end.
            Happening::FliesAway => break Pose::StillMoves(Spent::Time),
            Happening::BudgetSpent => {
                let steps = walker.effort().events >= options.most_events;
                let spent = if steps { Spent::Steps } else { Spent::Time };
                break walker.flat_on(0).map_or(Pose::StillMoves(spent), Pose::Face);
            }
        }
    };
    Ok(Thrown { pose, time: walker.time(), impacts: walker.effort().impacts })
}

fn rest(walker: &Walker<'_>, world: &World) -> Pose {
    let below = || world.bodies[0].shape.rest_below(walker.state().pose.down());
    let stands = || if walker.held().next().is_some() { Pose::Balanced } else { Pose::NoFace };
    walker.flat_on(0).or_else(below).map_or_else(stands, Pose::Face)
}

/// The face of the arc that a body rolls on, where it cannot leave it.
fn swing(state: &State, world: &World) -> Pose {
    let (body, gravity) = (&world.bodies[0], world.gravity.norm());
    let shape: &Shape = &body.shape;
    let down = state.pose.down();
    let on = shape.rest_below(down).and_then(|face| Some((face, shape.rests().get(face).copied()?)));
    let Some((face, rest)) = on else { return Pose::Balanced };
    let energy = body.kinetic_energy(&state.twist) + body.mass * gravity * shape.centre_height(down);
    let out = |angle: f64| {
        let turn = Vec2::at_angle(angle);
        body.mass * gravity * shape.centre_height(rest.normal.rotated(turn.x, turn.y))
    };
    let barrier = out(rest.basin[0]).min(out(-rest.basin[1]));
    if energy < barrier { Pose::Face(face) } else { Pose::StillMoves(Spent::Time) }
}
