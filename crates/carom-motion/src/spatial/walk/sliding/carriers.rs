//! The supports that carry a sliding body.

use crate::spatial::geometry::feature::Feature;
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::World;
use carom_num::Vec3;

/// A support that carries a sliding body.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Carrier {
    pub(in crate::spatial) support: usize,
    pub(in crate::spatial) feature: Feature,
    pub(in crate::spatial) friction: f64,
    pub(in crate::spatial) sticks: bool,
    /// Where it starts to slip from rest: the direction, world axes.
    pub(in crate::spatial) lead: Vec3,
    /// The tangents and the normal of its plane: world axes, and in body axes as they were at the start.
    pub(in crate::spatial) frame: [Vec3; 3],
    pub(in crate::spatial) then: [Vec3; 3],
    /// One that carries nothing at first touches on while it pulls by no more than this \[N\]: that is rounding.
    pub(in crate::spatial) spare: f64,
    /// It is on the foot's plane.
    pub(in crate::spatial) level: bool,
    /// Where it touches the body is where the foot does.
    pub(in crate::spatial) is_foot: bool,
}

/// What carries a sliding body, and where slips that are zero start.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Carried<'a> {
    pub(in crate::spatial) sticking: Supports,
    pub(in crate::spatial) slipping: Supports,
    pub(in crate::spatial) leads: &'a [(usize, Vec3)],
}

/// The carriers of a body with this foot; `None` without friction.
pub(super) fn carriers_of(
    world: &World,
    carried: &Carried<'_>,
    state: &State,
    foot: usize,
) -> Option<Vec<Carrier>> {
    let friction = world.friction()?;
    let lead = |i: usize| carried.leads.iter().find(|(k, _)| *k == i).map_or(Vec3::ZERO, |(_, e)| *e);
    let of = |support: usize| {
        let frame = world.axes(support, state.pose());
        let feature = |i: usize| match world.pair(i) {
            Some(_) => Feature::point(world.arm(i, state.pose())),
            None => *world.support(i).feature,
        };
        let (feature, own) = (feature(support), feature(foot));
        let on_face = world.pair(foot).is_none();
        let level = on_face && world.plane_of(support) == world.plane_of(foot);
        Carrier {
            support,
            feature,
            friction: friction.coefficient(support),
            sticks: carried.sticking.contains(support),
            lead: lead(support),
            frame,
            then: frame.map(|axis| state.attitude.undo(axis)),
            spare: 0.0,
            level,
            is_foot: support == foot || on_face && feature == own && (level || own.is_sharp()),
        }
    };
    Some(carried.sticking.union(carried.slipping).iter().map(of).collect())
}
