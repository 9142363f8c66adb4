//! The forces on the supports that are held, for whoever looks at a motion.

use super::sliding::Sliding;
use super::sliding::carriers::Carried;
use crate::MotionError;
use crate::spatial::geometry::state::{Pose, State};
use crate::spatial::geometry::world::World;
use crate::spatial::modes::contacts::{Question, Way};
use crate::spatial::modes::mode::Mode;
use crate::spatial::terms::Choice;
use carom_num::Vec3;

/// What the planes do to the supports that a body holds.
///
/// # Example
/// A cube of 1 kg that lies still at g = 10 m/s² rests on four corners, which carry 10 N together and need no
/// friction.
/// ```
/// use carom_motion::spatial::{Forces, Mode, State, World, examples, forces};
/// use carom_num::{Rotation, Vec3};
/// let cube = examples::cube();
/// let lying = State::standing(&cube, 0, Rotation::NONE, Vec3::ZERO);
/// let world = World::new(cube, Vec3::Z * -10.0).unwrap();
/// let held = Mode::Rest { held: (0..4).collect() };
/// let Forces { forces, friction_demand } = forces(&world, held, &lying)?.unwrap();
/// let sum = forces.iter().fold(Vec3::ZERO, |sum, (_, force)| sum + *force);
/// assert!((sum - Vec3::Z * 10.0).norm() < 1e-13 && friction_demand < 1e-14);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Forces {
    /// The force on each held support, world axes \[N\]; where they are a family, that of equal springs, or one that does not pull.
    pub forces: Vec<(usize, Vec3)>,
    /// The least friction coefficient with which forces exist that hold every support: over the whole family, where they are one.
    pub friction_demand: f64,
}

/// The forces on the held supports; `None` where they cannot all be held, because one would have to pull.
///
/// For supports that slide the world must have friction, and each of them must slide already.
///
/// # Errors
/// [`MotionError::TooManyTouching`], [`MotionError::Impact`] as of a run.
///
/// # Example
/// A rod of 2 m and 1 kg, held by its foot at 45° and let go: `N = m g (1 − ¾ sin² 45°)`, `T = ¾ m g sin 45° cos 45°`.
/// ```
/// use carom_motion::spatial::{Body, Mode, State, Supports, World, forces};
/// use carom_num::{Mat3, Rotation, Vec3};
/// let rod = Body::new(1.0, Mat3::diagonal(1.0 / 3.0, 1.0 / 3.0, 1e-3), vec![-Vec3::Z]).unwrap();
/// let leaning = State::standing(&rod, 0, Rotation::by(Vec3::Y * std::f64::consts::FRAC_PI_4), Vec3::ZERO);
/// let world = World::new(rod, Vec3::Z * -10.0).unwrap();
/// let held = forces(&world, Mode::Pivot { support: 0, held: Supports::one(0) }, &leaning)?.unwrap();
/// let (support, force) = held.forces[0];
/// assert!(support == 0 && (force - Vec3::new(3.75, 0.0, 6.25)).norm() < 1e-13);
/// assert!((held.friction_demand - 0.6).abs() < 1e-14);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
pub fn forces(world: &World, mode: Mode, state: &State) -> Result<Option<Forces>, MotionError> {
    if let Mode::Slides { sticking, slipping } = mode {
        let carried = Carried { sticking, slipping, leads: &[] };
        let heights = vec![0.0; world.count()];
        let forces = Sliding::from(world, &carried, state, &heights)
            .and_then(|(sliding, first)| sliding.forces(&first));
        return Ok(forces
            .filter(|f| f.iter().all(|(i, force)| world.normal(*i, state.pose()).dot(*force) >= 0.0))
            .map(|f| sliding_forces(world, state.pose(), f)));
    }
    let asked = mode.held(world);
    let question = Question { world, state, time: 0.0, asked, without: None, choice: Choice::KeepMost };
    let way = question.of_motion()?.way.filter(|way| way.kept == asked);
    Ok(way.map(|Way { pushes, friction_demand, .. }| Forces { forces: pushes, friction_demand }))
}

fn sliding_forces(world: &World, pose: Pose, forces: Vec<(usize, Vec3)>) -> Forces {
    let demand = |(support, force): &(usize, Vec3)| {
        let across = world.along(*support, pose, *force).norm();
        if across > 0.0 { across / world.normal(*support, pose).dot(*force) } else { 0.0 }
    };
    let friction_demand = forces.iter().map(demand).fold(0.0, f64::max);
    Forces { forces, friction_demand }
}
