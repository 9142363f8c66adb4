//! How much friction the supports of several planes need that hold a body.

use super::grip::{Bearing, Grip, MOST_BEARING};
use crate::spatial::geometry::body::Body;
use crate::spatial::geometry::posture::Posture;
use crate::spatial::geometry::state::Pose;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::World;
use crate::tolerance::{LEAST_GRIP, MODE_RANK};
use carom_num::cones::narrowest;
use carom_num::{Basis, Vec3};

/// Unknown forces, at most.
const MOST: usize = 3 * MOST_BEARING;
/// What is left of a unit force among many is no smaller than this, or it is nothing.
const FREE_RANK: f64 = 1e-6;

/// Supports that hold a body, where a stretch of motion starts: body axes as they were then.
#[derive(Clone, Debug)]
pub(in crate::spatial) struct Capacity {
    body: Body,
    then: Vec<Bearing>,
    gravity: Vec3,
}

impl Capacity {
    /// `None` in a world without friction, where nothing slides whatever that takes.
    pub(in crate::spatial) fn of(world: &World, held: Supports, pose: Pose) -> Option<Self> {
        let friction = world.friction()?;
        let bearing = |i: usize| Bearing {
            friction: friction.coefficient(i),
            sticks: true,
            ..Bearing::smooth(world, i, pose)
        };
        let then = held.iter().take(MOST_BEARING).map(bearing).collect();
        Some(Self { body: world.body().clone(), then, gravity: pose.attitude.undo(world.gravity()) })
    }

    /// What is left of the cones: 1 where no friction is needed, 0 where of all forces that hold the supports the best just lie within their cones, and
    /// negative where none do.
    pub(in crate::spatial) fn left(&self, at: &Posture) -> f64 {
        let (gravity, spin) = (at.turned.undo(self.gravity), at.spin);
        let free = self.body.mobility() * -spin.cross(self.body.inertia() * spin);
        let now = |b: &Bearing| Bearing {
            axes: b.axes.map(|axis| at.turned.undo(axis)),
            drive: gravity + free.cross(b.arm) + spin.cross(spin.cross(b.arm)),
            ..*b
        };
        left_of(&self.body, &self.then.iter().map(now).collect::<Vec<_>>())
    }
}

/// The same for supports some of which slip: these must not pull.
pub(in crate::spatial) fn left_of(body: &Body, bearings: &[Bearing]) -> f64 {
    let Some(reactions) = (Grip { body, bearings }).corrections() else { return f64::NAN };
    let scaled = |b: &Bearing, v: Vec3| {
        let friction = b.friction.max(LEAST_GRIP);
        if b.sticks { Vec3::new(v.x / friction, v.y / friction, v.z) } else { Vec3::Z * v.z }
    };
    let of_one = |(k, b): (usize, &Bearing)| {
        let [x, y, z] = b.axes.map(|axis| axis.dot(reactions.forces[k]));
        scaled(b, Vec3::new(x, y, z))
    };
    let forces: Vec<Vec3> = bearings.iter().enumerate().map(of_one).collect();
    let all = |free: &Vec<f64>| {
        let mut next = free.iter();
        let mut one = || next.next().copied().unwrap_or(0.0);
        let part = |b: &Bearing| {
            let along = if b.sticks { [one(), one()] } else { [0.0; 2] };
            scaled(b, Vec3::new(along[0], along[1], one()))
        };
        bearings.iter().map(part).collect::<Vec<_>>()
    };
    let open: Vec<Vec<Vec3>> = balanced(bearings).iter().map(all).collect();
    let needed = narrowest(&forces, &open);
    // In [-1, 1], also where no friction is enough.
    if needed.is_finite() { (1.0 - needed) / (1.0 + needed) } else { -1.0 }
}

/// Forces on the supports that balance each other: along the axes of each that sticks, and along the force of each that slips.
pub(in crate::spatial) fn balanced(bearings: &[Bearing]) -> Vec<Vec<f64>> {
    let reach = bearings.iter().map(|b| b.arm.norm()).fold(0.0, f64::max);
    let pushes: Vec<(Vec3, Vec3)> =
        bearings.iter().flat_map(|b| b.pushes().map(|(force, _)| (b.arm, force))).collect();
    match pushes.len() {
        0..=12 => balanced_sized::<12>(&pushes, reach),
        13..=24 => balanced_sized::<24>(&pushes, reach),
        _ => balanced_sized::<MOST>(&pushes, reach),
    }
}

fn balanced_sized<const M: usize>(pushes: &[(Vec3, Vec3)], reach: f64) -> Vec<Vec<f64>> {
    let mut basis = Basis::<M>::NONE;
    let rows: [fn(Vec3) -> f64; 3] = [|v| v.x, |v| v.y, |v| v.z];
    for of in rows {
        let row = |moment: bool| {
            let mut out = [0.0; M];
            for (out, (arm, force)) in out.iter_mut().zip(pushes) {
                *out = of(if moment { arm.cross(*force) / reach } else { *force });
            }
            out
        };
        basis.take(row(false), MODE_RANK);
        basis.take(row(true), MODE_RANK);
    }
    let holding = basis.axes().len();
    for one in 0..pushes.len() {
        basis.take(std::array::from_fn(|k| if k == one { 1.0 } else { 0.0 }), FREE_RANK);
    }
    basis.axes()[holding..].iter().map(|axis| axis[..pushes.len()].to_vec()).collect()
}
