//! Where a stretch starts in which supports slide or roll.

use super::carriers::{Carried, Carrier, carriers_of};
use super::{DIMENSIONS, SLIP, Sliding, Vector, YAW};
use crate::spatial::geometry::feature::Feature;
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::World;
use crate::spatial::modes::grip::MOST_BEARING;
use crate::spatial::modes::mode::{Mode, normal_of};
use crate::spatial::modes::stretch::{Heights, uprights};
use crate::spatial::walk::motion::Motion;
use crate::tolerance::SLIP_SPECK;
use carom_num::Vec3;

/// The support from which the motion is reckoned.
struct Foot {
    support: usize,
    /// The mass centre, where it is no point of the body on a face.
    feature: Feature,
    /// The plane of that face.
    plane: Option<usize>,
    /// The tangents and the normal of the plane, or the world's axes.
    frame: [Vec3; 3],
    /// Where the feature is, world axes.
    place: Vec3,
}

impl Foot {
    /// One that sticks, on a face where there is one: its plane keeps digits. Else the slowest.
    fn of(world: &World, carried: &Carried<'_>, state: &State) -> Option<Self> {
        let speed = |i: usize| velocity_of(world, state, i).norm();
        let slowest = || carried.slipping.iter().min_by(|a, b| speed(*a).total_cmp(&speed(*b)));
        let on_face = carried.sticking.iter().find(|i| world.pair(*i).is_none());
        let support = on_face.or_else(|| carried.sticking.iter().next()).or_else(slowest)?;
        if world.pair(support).is_some() {
            let (feature, frame) = (Feature::point(Vec3::ZERO), [Vec3::X, Vec3::Y, Vec3::Z]);
            return Some(Self { support, feature, plane: None, frame, place: state.centre });
        }
        let (feature, number) = (*world.support(support).feature, world.plane_of(support));
        let plane = world.planes()[number];
        let depth = feature.depth(state.attitude.undo(plane.normal()));
        let place = plane.onto(state.place(feature.point)) + plane.normal() * depth;
        Some(Self { support, feature, plane: Some(number), frame: plane.axes(), place })
    }
}

/// Velocity of the body where a support touches, world axes.
fn velocity_of(world: &World, state: &State, support: usize) -> Vec3 {
    state.velocity_of(world.arm(support, state.pose()))
}

/// From the foot to the other end of the edge that carries a body, body axes.
fn edge_from(world: &World, foot: &Feature, mode: Mode) -> Option<Vec3> {
    let Mode::Edge { ends, .. } = mode else { return None };
    let [a, b] = ends.map(|end| world.point(end) - foot.point);
    Some(if a.norm() > b.norm() { a } else { b })
}

impl<'w> Sliding<'w> {
    /// The stretch that starts from a state. `None` without friction, and where no support carries the body or more do than [`MOST_BEARING`].
    pub(in crate::spatial) fn from(
        world: &'w World,
        carried: &Carried<'_>,
        state: &State,
        heights: &Heights,
    ) -> Option<(Self, Vector)> {
        let bearing = carried.sticking.union(carried.slipping);
        if bearing.is_empty() || bearing.len() > MOST_BEARING {
            return None;
        }
        let Foot { support, feature: foot, plane, frame, place } = Foot::of(world, carried, state)?;
        let carriers = carriers_of(world, carried, state, support)?;
        let speck = SLIP_SPECK * world.scales().speed;
        let paired = world.has_pairs(bearing);
        let loose = paired || !world.are_alike(bearing);
        let apart = loose || !world.is_of_one_plane(bearing);
        let mode = Mode::holding(world, bearing, state.pose());
        let flat = matches!(mode, Mode::Rest { .. }) && !apart;
        let normal = flat.then(|| normal_of(world, bearing, state.pose())).flatten();
        let axes = frame.map(|axis| state.attitude.undo(axis));
        let [east, north, up] = frame.map(|axis| world.gravity().dot(axis));
        let mut motion = Self {
            world,
            body: world.body(),
            scales: world.scales(),
            gravity: Vec3::new(east, north, up),
            attitude: state.attitude,
            heights: heights.clone(),
            planes: uprights(world, state.attitude),
            carriers,
            foot,
            plane,
            pair: plane.is_none().then_some(support),
            paired,
            ways: if plane.is_none() { 3 } else { 2 },
            place,
            frame,
            axes,
            apart,
            redundant: false,
            loose,
            normal: normal.map(|n| if n.dot(axes[2]) < 0.0 { -n } else { n }),
            edge: if apart { None } else { edge_from(world, &foot, mode) },
            speck,
            grown: Supports::NONE,
            most: [0.0; 3],
        };
        let first = motion.first(state, support);
        motion.note_idle(&first);
        Some((motion, first))
    }

    /// What is integrated, as it is at the start.
    fn first(&mut self, state: &State, foot: usize) -> Vector {
        let (world, spin) = (self.world, state.spin);
        let rests =
            |c: &Carrier| c.lead != Vec3::ZERO && velocity_of(world, state, c.support).norm() <= self.speck;
        let starts = |c: &&Carrier| !c.sticks && rests(c);
        let starting: Supports = self.carriers.iter().filter(starts).map(|c| c.support).collect();
        let resting: Vec<&Carrier> =
            self.carriers.iter().filter(|c| c.sticks || starting.contains(c.support)).collect();
        let (foot_rests, several_rest) = (resting.iter().any(|c| c.is_foot), resting.len() > 1);
        let slip = if foot_rests { Vec3::ZERO } else { velocity_of(world, state, foot) };
        let slip = if self.pair.is_some() { world.along(foot, state.pose(), slip) } else { slip };
        // Two points of a plane at rest: nothing turns about its normal.
        let yaw = if several_rest && !self.apart { 0.0 } else { spin.dot(self.axes[2]) };
        let mut first = [0.0; DIMENSIONS];
        (first[0], first[4], first[5], first[6], first[YAW]) = (1.0, spin.x, spin.y, spin.z, yaw);
        (0..self.ways).for_each(|k| first[SLIP + k] = slip.dot(self.frame[k]));
        let fast = |c: &&Carrier| !c.sticks && !starting.contains(c.support);
        self.grown = self.carriers.iter().filter(fast).map(|c| c.support).collect();
        if self.apart { self.projected(&first, starting) } else { self.tidied(&first) }
    }
}
