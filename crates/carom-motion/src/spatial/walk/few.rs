//! Of many corners of a face that touch, few that speak for the others.
//!
//! A rigid face that does not sink in with some of its corners, well apart, sinks in nowhere between them: what carries it may be sought among these. An answer in which no other one is driven
//! in is one of all corners, of which the others take nothing: an impulse of zero at a corner that does not approach is what Signorini's and Coulomb's laws allow. So the others are looked at
//! afterwards, and one that would be driven in is asked as well.

use super::walker::Walker;
use crate::MotionError;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::contacts::{Answer, Way};
use crate::spatial::modes::grip::MOST_BEARING;
use crate::spatial::modes::mode::Mode;
use crate::spatial::walk::strike::pushed;
use crate::tolerance::{FAINT_STRIKE, STILL_ACCELERATION, SUPPORT_STAYS};
use carom_num::Vec3;
use carom_num::elementary::sin_cos;
use std::f64::consts::TAU;

/// More corners of a face than this are many.
const MANY: usize = 8;
/// Directions along a face in which its farthest corners speak for the others.
const DIRECTIONS: u32 = 6;
/// The first of them is that of the body's x axis, unless that is as steep to the face as this cosine.
const STEEP: f64 = 0.9;

impl Walker<'_> {
    /// These supports, but of the corners on each face that are many the farthest in directions that are fixed to the body, and `also`.
    pub(super) fn few(&self, of: Supports, also: Supports) -> Supports {
        if of.len() <= MANY {
            return of;
        }
        let mut out = of.those(|i| self.world.pair(i).is_some() || also.contains(i));
        for plane in 0..self.world.planes().len() {
            let on = self.world.of_plane(plane);
            let own = of.those(|i| on.contains(&i));
            out = out.union(if own.len() <= MANY { own } else { self.farthest(own) });
        }
        out
    }

    /// The same with those that carry the body now; the others are noted as beside them.
    pub(super) fn spoken_for(&mut self, touching: Supports, also: Supports) -> Supports {
        let few = self.few(touching, self.carrying().union(also));
        self.beside = touching.difference(few);
        few
    }

    /// Where more touch than can be asked at once: those that speak for the others.
    pub(super) fn askable(&self, touching: Supports) -> Supports {
        if touching.len() > MOST_BEARING { self.few(touching, self.carrying()) } else { touching }
    }

    /// The supports that carry the body: where a face lies flat not all that it holds on a plane do.
    fn carrying(&self) -> Supports {
        match self.mode {
            Mode::Slides { sticking, slipping } => sticking.union(slipping),
            mode => mode.held(self.world),
        }
    }

    /// The corners that lie flat beside those that carry the body.
    pub(super) fn flat_beside(&self) -> Result<Supports, MotionError> {
        if self.world.body().supports().len() <= MANY {
            return Ok(Supports::NONE);
        }
        let carrying = self.carrying();
        Ok(self.lies_flush()?.those(|i| self.world.pair(i).is_none() && !carrying.contains(i)))
    }

    /// The one of the corners beside those that were asked that the mode draws down fastest, if it does any.
    pub(super) fn drawn_in(&self) -> Result<Option<usize>, MotionError> {
        if self.beside.is_empty() {
            return Ok(None);
        }
        let (flush, faint) = (self.flush(), FAINT_STRIKE * self.scales.speed);
        let free = self.beside.those(|i| !flush.contains(i) && self.rise_of(i).abs() <= faint);
        let still = STILL_ACCELERATION * self.world.gravity().norm();
        let fastest = self.rising_faster(free)?.into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
        Ok(fastest.filter(|(_, second)| *second < -still).map(|(i, _)| i))
    }

    /// The farthest corners of a face, however these are numbered.
    fn farthest(&self, own: Supports) -> Supports {
        let (world, pose) = (self.world, self.state.pose());
        let up = own.iter().next().map_or(Vec3::Z, |i| pose.attitude.undo(world.normal(i, pose)));
        let first = if up.x.abs() < STEEP { Vec3::X } else { Vec3::Y };
        let first = (first - up * up.dot(first)).unit().unwrap_or(first);
        let across = up.cross(first);
        let near = SUPPORT_STAYS * self.scales.length;
        let farthest = |k: u32| {
            let (sine, cosine) = sin_cos(TAU * f64::from(k) / f64::from(DIRECTIONS));
            let (out, beside) = (first * cosine + across * sine, across * cosine - first * sine);
            let along = |i: usize, axis: Vec3| world.point(i).dot(axis);
            let most = own.iter().map(|i| along(i, out)).fold(f64::NEG_INFINITY, f64::max);
            let ends = own.iter().filter(|i| along(*i, out) >= most - near);
            ends.max_by(|a, b| along(*a, beside).total_cmp(&along(*b, beside)))
        };
        (0..DIRECTIONS).filter_map(farthest).collect()
    }

    /// The impact of these supports, and of those they speak for that it would drive in; with all that were asked.
    pub(super) fn blow_on_all(
        &self,
        mut touching: Supports,
        press: Option<f64>,
    ) -> Result<(Supports, Answer), MotionError> {
        let mut beside = self.beside;
        loop {
            let answer = self.blow(touching, press)?;
            let Some(way) = &answer.way else { return Ok((touching, answer)) };
            let Some(driven) = self.driven_in(beside, way) else { return Ok((touching, answer)) };
            if touching.len() >= MOST_BEARING {
                let takes = |i: usize| way.pushes.iter().any(|(k, p)| *k == i && p.norm() > 0.0);
                touching = touching.those(|i| takes(i) || way.kept.contains(i));
            }
            (touching, beside) = (touching.with(driven), beside.difference(Supports::one(driven)));
        }
    }

    /// The one of these supports that approaches fastest after an impact.
    fn driven_in(&self, beside: Supports, way: &Way) -> Option<usize> {
        if beside.is_empty() {
            return None;
        }
        let (world, pose) = (self.world, self.state.pose());
        let after = pushed(&self.state, world, &way.pushes);
        let least = -SUPPORT_STAYS * self.top_speed();
        let rise = |i: usize| world.normal(i, pose).dot(after.velocity_of(world.arm(i, pose)));
        let rises = beside.iter().map(|i| (i, rise(i))).filter(|(_, rise)| *rise < least);
        rises.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
    }
}
