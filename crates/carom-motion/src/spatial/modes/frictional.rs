//! The contacts of an impact with friction.

use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::World;
use crate::tolerance::SLIP_ROUNDING;
use carom_impact::ImpactError;
use carom_impact::spatial::{ContactSet, Touch};
use carom_num::Vec3;

/// The impact that a body meets at supports that touch their planes, as [`carom_impact::spatial::staged`] takes it. The contacts are in the supports'
/// order. Those that are `held` have stayed on theirs and do not approach; the others approach as the motion says.
///
/// Asked with an [`Impact`](crate::spatial::record::run::Impact)'s `touching` and `held` and the state before it, it is the question that the run has asked: the walk, observed, says
/// which other ways there were.
///
/// # Errors
/// As [`ContactSet::of_free_body`]. In a world without friction the contacts have none.
///
/// # Example
/// A cube of 1 m and 1 kg comes down flat with 2 m/s. An impulse at one corner moves that corner with `1/m +
/// s²/J = 1 + 6/2`, and the opposite one with `1 − 6/2`.
/// ```
/// use carom_motion::spatial::{State, Supports, World, examples, frictional_contacts};
/// use carom_num::{Rotation, Vec3};
/// let cube = examples::cube();
/// let down = State { velocity: Vec3::Z * -2.0, ..State::standing(&cube, 0, Rotation::NONE, Vec3::ZERO) };
/// let world = World::new(cube, Vec3::Z * -10.0).unwrap();
/// let set = frictional_contacts::<4>(&world, &down, (0..4).collect(), Supports::NONE)?;
/// assert_eq!((set.count, set.velocity[0].z), (4, -2.0));
/// let moved = [0, 2].map(|corner| set.operator[0][corner].rows[2].z);
/// assert!((moved[0] - 4.0).abs() < 1e-14 && (moved[1] + 2.0).abs() < 1e-14);
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn frictional_contacts<const N: usize>(
    world: &World,
    before: &State,
    touching: Supports,
    held: Supports,
) -> Result<ContactSet<N>, ImpactError> {
    let mut set = contacts_of(world, before, touching)?;
    let size = before.velocity.norm() + before.spin.norm() * world.body().reach();
    let slips = slips_on_planes(world, before, touching, size);
    for ((k, i), slip) in touching.iter().enumerate().zip(slips) {
        let normal = world.normal(i, before.pose());
        let fall =
            if held.contains(i) { 0.0 } else { normal.dot(before.velocity_of(world.arm(i, before.pose()))) };
        set.velocity[k] = Vec3 { z: fall, ..set.frame[k] * slip };
    }
    Ok(set)
}

/// Supports that touch, as impact and rate problem take them.
pub(in crate::spatial) fn contacts_of<const N: usize>(
    world: &World,
    state: &State,
    asked: Supports,
) -> Result<ContactSet<N>, ImpactError> {
    let touch = |i: usize| Touch {
        arm: state.attitude.apply(world.arm(i, state.pose())),
        normal: world.normal(i, state.pose()),
        friction: world.friction().map_or(0.0, |f| f.coefficient(i)),
        restitution: world.friction().map_or(0.0, |f| f.restitution(i)),
    };
    let touches: Vec<Touch> = asked.iter().map(touch).collect();
    ContactSet::of_free_body(&state.rigid(world.body()), &touches)
}

/// Slips of supports that touch their planes, in their order, world axes: on each plane those of one motion along it, exactly. Slips that are zero but for rounding are zero,
/// and the others are of the turn about such a support.
///
/// Their distances do not change, so that differences of slips along them are nothing but the rounding of the body's speeds. A hop may be slower than that is
/// relative to it, and in its impact no impulse could ever bring such a slip to rest.
fn slips_on_planes(world: &World, state: &State, touching: Supports, size: f64) -> Vec<Vec3> {
    let spin = state.attitude.apply(state.spin);
    let rounded = |slip: Vec3| if slip.norm() <= SLIP_ROUNDING * size { Vec3::ZERO } else { slip };
    let mut slips = vec![];
    for (number, plane) in world.planes().iter().enumerate() {
        let of_plane = world.of_plane(number);
        let own = touching.those(|i| of_plane.contains(&i));
        let slip = |i: usize| plane.along(state.velocity_of(world.arm(i, state.pose())));
        let place = |i: usize| plane.along(state.attitude.apply(world.arm(i, state.pose())));
        let slowest = own.iter().min_by(|a, b| slip(*a).norm().total_cmp(&slip(*b).norm()));
        let Some(base) = slowest else { continue };
        let (of_base, turn) = (rounded(slip(base)), plane.normal() * plane.normal().dot(spin));
        slips.extend(own.iter().map(|i| rounded(of_base + turn.cross(place(i) - place(base)))));
    }
    let pairs = touching.iter().filter(|i| world.pair(*i).is_some());
    let slip = |i: usize| {
        let velocity = state.velocity_of(world.arm(i, state.pose()));
        rounded(world.along(i, state.pose(), velocity))
    };
    slips.extend(pairs.map(slip));
    slips
}
