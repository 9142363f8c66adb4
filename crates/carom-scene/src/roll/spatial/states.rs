//! Every state of the non-sliding law at a strike: which contacts keep, and what refuses the others.

use super::SpatialRollProblem;
use super::strike_report::SpatialForkReport;
use crate::tolerance::{CONTACT_RESTS, SUPPORT_TOUCHES};
use carom_impact::spatial::{Conclusion, ContactSet, Refusal, RigidBody, StatesOfKeeping, Touch};
use carom_motion::spatial::{State, Supports};
use carom_num::Vec3;
use carom_num::cones::narrowest;
use carom_words::{impact_space, roll_space};

/// Refused states that are told of a strike: all up to six contacts; twelve have thousands.
const MOST_REFUSED: usize = 64;

/// A consistent state.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Consistent {
    pub(super) hypothesis: String,
    pub(super) kept: Supports,
    /// Impulse and velocity after of each touching point, world axes.
    pub(super) contacts: Vec<[Vec3; 2]>,
    pub(super) friction_demand: f64,
    pub(super) slack: f64,
    /// In how many directions other impulses leave the same motion.
    pub(super) freedom: usize,
}

/// A state that is refused, and by what.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rejected {
    pub(super) hypothesis: String,
    pub(super) because: String,
    pub(super) kept: Supports,
    /// The point whose inequality fails, and by how much; none where no impulses bring the kept points to rest.
    pub(super) fails: Option<(usize, Fails)>,
}

/// What an inequality asks not to be negative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Fails {
    /// A normal impulse [N s].
    Impulse(f64),
    /// A normal velocity after [m/s].
    Velocity(f64),
}

/// Every state of one strike.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct States {
    pub(super) touching: Supports,
    pub(super) conclusion: Conclusion,
    /// Velocity before of each touching point, world axes.
    pub(super) before: Vec<Vec3>,
    pub(super) consistent: Vec<Consistent>,
    pub(super) rejected: Vec<Rejected>,
    /// Refused states that are not told.
    pub(super) left_out: usize,
    /// Where the walk through a strike with friction had several ways on.
    pub(super) forks: Vec<SpatialForkReport>,
}

/// The points that touch where a run has ended in a strike.
pub(super) fn touching_at(problem: &SpatialRollProblem, state: &State) -> Supports {
    let body = problem.world.body();
    let low = |r: &Vec3| state.place(*r).z <= SUPPORT_TOUCHES * body.reach();
    body.supports().iter().enumerate().filter(|(_, r)| low(r)).map(|(i, _)| i).collect()
}

/// The states of a strike that finds the body in this state; `None` where the law cannot be asked.
pub(super) fn states(problem: &SpatialRollProblem, before: &State, touching: Supports) -> Option<States> {
    match touching.len() {
        0..=4 => asked::<4>(problem, before, touching),
        _ => asked::<12>(problem, before, touching),
    }
}

/// Takes what rounding leaves of the velocities of contacts at rest: two of them could not be stopped exactly.
fn at_rest<const N: usize>(set: &mut ContactSet<N>) {
    let fastest = set.velocity.iter().map(|v| v.norm()).fold(0.0, f64::max);
    for v in set.velocity.iter_mut().filter(|v| v.norm() <= CONTACT_RESTS * fastest) {
        *v = Vec3::ZERO;
    }
}

fn asked<const N: usize>(problem: &SpatialRollProblem, before: &State, touching: Supports) -> Option<States> {
    let body = problem.world.body();
    let rigid = RigidBody {
        mass: body.mass(),
        inertia: before.attitude.turn(body.inertia()),
        velocity: before.velocity,
        spin: before.attitude.apply(before.spin),
    };
    let arms: Vec<Vec3> = touching.iter().map(|i| before.attitude.apply(body.supports()[i])).collect();
    let touch = |arm: &Vec3| Touch { arm: *arm, normal: Vec3::Z, friction: 0.0, restitution: 0.0 };
    let touches: Vec<Touch> = arms.iter().map(touch).collect();
    let mut set = ContactSet::<N>::of_free_body(&rigid, &touches).ok()?;
    at_rest(&mut set);
    let states = set.states_of_keeping();
    let points: Vec<usize> = touching.iter().collect();
    let consistent = states.consistent.iter().map(|state| {
        let world = |k: usize, v: Vec3| set.frame[k].transposed() * v;
        let kept = chosen(&points, &state.kept);
        Consistent {
            hypothesis: roll_space::kept(&problem.points, [kept, Supports::NONE], touching),
            kept,
            contacts: (0..points.len())
                .map(|k| {
                    // What is kept rests: that is known better than the impulses say it.
                    let velocity = if state.kept[k] { Vec3::ZERO } else { state.velocity[k] };
                    [world(k, state.impulse[k]), world(k, velocity)]
                })
                .collect(),
            friction_demand: narrowest(&state.impulse, &state.free),
            slack: state.slack,
            freedom: state.free.len(),
        }
    });
    Some(States {
        touching,
        conclusion: states.conclusion(),
        before: (0..points.len()).map(|k| set.frame[k].transposed() * set.velocity[k]).collect(),
        consistent: consistent.collect(),
        rejected: rejected(problem, &points, touching, &states),
        left_out: states.refused.len().saturating_sub(MOST_REFUSED),
        forks: vec![],
    })
}

fn chosen<const N: usize>(points: &[usize], kept: &[bool; N]) -> Supports {
    points.iter().zip(kept).filter(|(_, kept)| **kept).map(|(i, _)| *i).collect()
}

fn rejected<const N: usize>(
    problem: &SpatialRollProblem,
    points: &[usize],
    touching: Supports,
    states: &StatesOfKeeping<N>,
) -> Vec<Rejected> {
    let told = states.refused.iter().take(MOST_REFUSED).map(|refused| {
        let kept = chosen(points, &refused.kept);
        let at = |k: usize| points.get(k).copied().unwrap_or_default();
        let fails = match refused.refusal {
            Refusal::Pulls(k) => Some((at(k), Fails::Impulse(refused.amount))),
            Refusal::Approaches(k) => Some((at(k), Fails::Velocity(refused.amount))),
            Refusal::Unsolvable => None,
        };
        let because = impact_space::refused(&problem.names_of(touching), refused.refusal, refused.amount);
        Rejected {
            hypothesis: roll_space::kept(&problem.points, [kept, Supports::NONE], touching),
            because,
            kept,
            fails,
        }
    });
    told.collect()
}
