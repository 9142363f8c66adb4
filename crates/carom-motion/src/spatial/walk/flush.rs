//! Supports that stay on what they touch for as long as others are held: nothing has to be searched for there.

use super::walker::Walker;
use crate::MotionError;
use crate::spatial::geometry::crossing::Crossing;
use crate::spatial::geometry::pair::Pair;
use crate::spatial::geometry::state::Pose;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::surface::Edge;
use crate::tolerance::{BESIDE, LEAST_SPAN, ON_EDGE, ONE_PLACE, SKIMS_BESIDE};
use carom_num::Vec3;

/// A mark for each support: however many they are.
#[derive(Clone, Debug, Default)]
pub(super) struct Marks(Vec<bool>);

impl Marks {
    /// True where this support is marked.
    pub(super) fn contains(&self, support: usize) -> bool {
        self.0.get(support).is_some_and(|mark| *mark)
    }
}

impl Walker<'_> {
    /// Supports that touch, or would between their ends, and cannot leave what they touch.
    ///
    /// A body that is held at three places of one plane turns about the normal of that plane alone: its points there, its edges there and those of the plate stay on it. One that is held
    /// at two places of an edge keeps this edge on the plane, and where it crosses edges of the plate they meet.
    pub(super) fn flush(&self) -> Marks {
        self.flush_with(self.mode.held(self.world))
    }

    /// The same where these are held.
    pub(super) fn flush_with(&self, held: Supports) -> Marks {
        let (world, pose) = (self.world, self.state.pose());
        if held.len() < 2 || world.body().rounding().is_none() {
            return Marks::default();
        }
        let near = SKIMS_BESIDE * self.scales.length;
        let low = |i: &usize| !held.contains(*i) && self.heights[*i].abs() <= near;
        let mut seen: Vec<Vec3> = vec![];
        let mut out = Marks(vec![false; world.count()]);
        for support in held.iter() {
            let normal = world.normal(support, pose);
            let like = |other: Vec3| (other - normal).norm() <= ONE_PLACE;
            if seen.iter().any(|other| like(*other)) {
                continue;
            }
            seen.push(normal);
            let carriers = held.those(|i| like(world.normal(i, pose)));
            let places: Vec<Vec3> = carriers.iter().map(|i| world.arm(i, pose)).collect();
            let flat = spans(&places, world.body().reach());
            let stays = |i: &usize| {
                like(world.normal(*i, pose))
                    && (flat || world.pair(*i).is_some_and(|pair| self.edge_is_held(pair, carriers, pose)))
            };
            (0..world.count()).filter(low).filter(stays).for_each(|i| out.0[i] = true);
        }
        out
    }

    /// What is flush with what is held touches: where what is held has drifted it would be taken for what is beside its face.
    pub(super) fn note_flush(&mut self) {
        let [near, beside] = [SKIMS_BESIDE, BESIDE].map(|share| share * self.scales.length);
        let sunk = |height: &f64| (-near..-beside).contains(height);
        if self.heights.iter().any(sunk) {
            let flush = self.flush();
            for (support, height) in self.heights.iter_mut().enumerate() {
                if sunk(height) && flush.contains(support) {
                    *height = 0.0;
                }
            }
        }
    }

    /// Those of them that touch.
    pub(super) fn lies_flush(&self) -> Result<Supports, MotionError> {
        let flush = self.flush();
        Ok(self.touching()?.those(|i| flush.contains(i)))
    }

    /// True where two of these supports hold the body's edge of a crossing at different places.
    fn edge_is_held(&self, pair: &Pair, carriers: Supports, pose: Pose) -> bool {
        let Pair::Cross(Crossing { own, .. }) = pair else { return false };
        let (world, reach) = (self.world, self.world.body().reach());
        let on = |i: &usize| match world.pair(*i) {
            Some(Pair::Cross(Crossing { own: other, .. })) => is_one(own, other),
            Some(Pair::Corner { .. } | Pair::Round(_)) => false,
            None => (world.point(*i) - own.from).cross(own.along).norm() <= ON_EDGE * reach,
        };
        let along: Vec<f64> =
            carriers.iter().filter(on).map(|i| (world.arm(i, pose) - own.from).dot(own.along)).collect();
        let first = along.first().copied().unwrap_or_default();
        along.iter().any(|other| (other - first).abs() > LEAST_SPAN * reach)
    }
}

/// One edge of the body.
fn is_one(a: &Edge, b: &Edge) -> bool {
    a.from == b.from && a.along == b.along
}

/// True where three of these places are well off one line.
fn spans(places: &[Vec3], reach: f64) -> bool {
    let Some((first, others)) = places.split_first() else { return false };
    let arms: Vec<Vec3> = others.iter().map(|place| *place - *first).collect();
    let least = LEAST_SPAN * reach * reach;
    arms.iter().any(|a| arms.iter().any(|b| a.cross(*b).norm() > least))
}
