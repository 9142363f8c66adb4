//! How a body with friction comes to lie where its contacts are: before a mode is entered, and where a series of impacts is closed.

use super::motion::Motion;
use super::sliding::carriers::Carried;
use super::walker::Walker;
use crate::MotionError;
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::modes::grip::{Bearing, Grip, MOST_BEARING};
use crate::spatial::modes::mode::Mode;
use crate::spatial::modes::settle::{Displacement, settled};
use crate::tolerance::{CLEAR_OF_ROUNDING, MOST_LAID, TOUCHES_AT_START};
use carom_num::Vec3;

/// At the limit of a series the impulses that end it stop every slip that is below this many times the largest speed along the normal.
const SWEPT: f64 = 4.0;

impl Walker<'_> {
    /// Takes back what rounding has left of heights and of velocities along the normal.
    pub(super) fn settle_rough(&mut self, asked: Supports) -> Result<(), MotionError> {
        let before = self.state;
        self.put_down(asked)?;
        self.follow_heights(&before, asked);
        Ok(())
    }

    /// Puts supports where they touch, and takes their velocities along the normal away.
    fn put_down(&mut self, asked: Supports) -> Result<(), MotionError> {
        let (sticking, slipping): (Vec<usize>, Vec<usize>) =
            asked.iter().partition(|i| self.slip_of(*i) == Vec3::ZERO);
        let apart = !self.world.is_of_one_plane(asked);
        if slipping.is_empty() && !apart {
            self.state =
                settled(self.world, Mode::holding(self.world, asked, self.state.pose()), &self.state);
            return Ok(());
        }
        if apart && asked.len() <= MOST_BEARING {
            let by = Displacement::putting_down(self.world, asked, &self.state);
            let share = by.most(self.world) / self.scales.length;
            if share > TOUCHES_AT_START && share <= MOST_LAID {
                self.state = by.from(&self.state);
            }
        }
        // On one plane one that sticks says of the others that they only turn about it.
        let most = if apart { sticking.len() } else { 1 };
        let carried = Carried {
            sticking: sticking.into_iter().take(most).collect(),
            slipping: slipping.into_iter().collect(),
            leads: &[],
        };
        if !apart {
            self.state = self.without_rises(asked);
        }
        let (sliding, first) = self.sliding_on(&carried)?;
        self.state = sliding.state(&first, 0.0);
        Ok(())
    }

    /// Heights above other planes go along with a body that has been put down on those of `asked`. Those of hops stay: they are counted from what is held, and what is taken back is what
    /// the place of the body was off.
    fn follow_heights(&mut self, before: &State, asked: Supports) {
        let (world, pose) = (self.world, before.pose());
        let by = Displacement::between(pose, self.state.pose());
        if by.most(world) <= TOUCHES_AT_START * self.scales.length {
            return;
        }
        let own = asked.iter().next().filter(|_| world.is_of_one_plane(asked)).map(|i| world.plane_of(i));
        let other = |i: &usize| !asked.contains(*i) && Some(world.plane_of(*i)) != own;
        for support in (0..world.count()).filter(other) {
            let rise = world.normal(support, pose).dot(by.of(world.arm(support, pose), pose.attitude));
            let height = &mut self.heights[support];
            if height.abs() > CLEAR_OF_ROUNDING * self.scales.length && rise.is_finite() {
                *height += rise;
            }
        }
    }

    /// The state in which none of these supports moves along the normal, by the least change of the motion: it takes energy, if anything.
    fn without_rises(&self, asked: Supports) -> State {
        let state = &self.state;
        let bearings: Vec<Bearing> = asked.iter().map(|i| self.bearing(i)).collect();
        let (velocity, spin) = Grip { body: self.world.body(), bearings: &bearings }.taken_back();
        State { velocity: state.velocity + state.attitude.apply(velocity), spin: state.spin + spin, ..*state }
    }

    /// The state in which all of these supports touch, by the least motion; `None` where that is more than what a closed series leaves.
    pub(super) fn laid(&self, kept: Supports) -> Option<State> {
        let by = Displacement::putting_down(self.world, kept, &self.state);
        (by.most(self.world) <= MOST_LAID * self.scales.length).then(|| by.from(&self.state))
    }

    /// A support without friction that has to take its velocity away.
    fn bearing(&self, support: usize) -> Bearing {
        let drive = self.state.attitude.undo(self.velocity_of(support));
        Bearing { drive, ..Bearing::smooth(self.world, support, self.state.pose()) }
    }

    /// The state in which none of these supports moves along the normal, where a series of impacts with friction comes to its limit.
    ///
    /// The impulses of the series are those of the weight meanwhile less what stops the support that has just risen. Since the stretch that follows starts at the
    /// last impact and not at the limit, it brings those of the weight; here the others are taken back, with their share of friction. Where nothing is `left` of the series
    /// no weight is still to come: what rises is stopped without friction, which would drive the body on.
    pub(super) fn landed(&self, kept: Supports, left: f64) -> Option<State> {
        let (body, state, friction) = (self.world.body(), &self.state, self.world.friction()?);
        if kept.len() > MOST_BEARING {
            return None;
        }
        let rises = kept.iter().map(|i| self.rise_of(i).abs()).fold(0.0, f64::max);
        let bearing = |i: usize| {
            let slip = self.slip_of(i);
            // A slip that is no faster than the bounces has been stopped by the impulses of the bounces still to come.
            let sticks = slip.norm() <= SWEPT * rises;
            Bearing {
                friction: if left > 0.0 { friction.coefficient(i) } else { 0.0 },
                sticks,
                toward: if sticks {
                    Vec3::ZERO
                } else {
                    state.attitude.undo(slip.unit().unwrap_or(Vec3::ZERO))
                },
                ..self.bearing(i)
            }
        };
        let bearings: Vec<Bearing> = kept.iter().map(bearing).collect();
        let reactions = Grip { body, bearings: &bearings }.reactions()?;
        Some(State {
            velocity: state.velocity + state.attitude.apply(reactions.force) / body.mass(),
            spin: state.spin + body.mobility() * reactions.moment,
            ..*state
        })
    }
}
