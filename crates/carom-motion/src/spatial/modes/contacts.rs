//! What the non-sliding law says of the supports that touch: in an impact of their velocities, in motion of their accelerations.

use crate::MotionError;
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::World;
use crate::spatial::terms::Choice;
use carom_impact::spatial::{Conclusion, ContactSet, Freedom, Touch};
use carom_num::Vec3;
use carom_num::cones::narrowest;

/// The most supports that are enumerated.
pub(super) const MOST_TOUCHING: usize = 12;

/// What the law says.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::spatial) struct Answer {
    pub(in crate::spatial) conclusion: Conclusion,
    /// The way that is followed.
    pub(in crate::spatial) way: Option<Way>,
}

/// A way on.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::spatial) struct Way {
    pub(in crate::spatial) kept: Supports,
    /// Those of them that slide after.
    pub(in crate::spatial) sliding: Supports,
    /// Impulses or forces on the supports that were asked about, world axes.
    pub(in crate::spatial) pushes: Vec<(usize, Vec3)>,
    pub(in crate::spatial) friction_demand: f64,
    /// What sharing among the supports leaves open.
    pub(in crate::spatial) open: Freedom,
}

/// How many ways there are, in a word.
pub(in crate::spatial) trait Conclusive {
    fn conclusion(self) -> Conclusion;
}

impl Conclusive for usize {
    fn conclusion(self) -> Conclusion {
        match self {
            0 => Conclusion::None,
            1 => Conclusion::Unique,
            _ => Conclusion::Several,
        }
    }
}

/// A question to the law.
pub(in crate::spatial) struct Question<'a> {
    pub(in crate::spatial) world: &'a World,
    pub(in crate::spatial) state: &'a State,
    pub(in crate::spatial) time: f64,
    pub(in crate::spatial) asked: Supports,
    /// One of them that must not be kept.
    pub(in crate::spatial) without: Option<usize>,
    pub(in crate::spatial) choice: Choice,
}

impl Question<'_> {
    /// Which supports an impact keeps.
    pub(in crate::spatial) fn of_impact(&self) -> Result<Answer, MotionError> {
        self.ask(None)
    }

    /// Which of the supports that touch at rest are held: the same question, about the accelerations that the free body would have.
    pub(in crate::spatial) fn of_motion(&self) -> Result<Answer, MotionError> {
        let (body, state, State { attitude, spin, .. }) = (self.world.body(), self.state, *self.state);
        let turning = body.mobility() * -spin.cross(body.inertia() * spin);
        let accelerations = self.asked.iter().map(|i| {
            let (arm, bent) = (self.world.arm(i, state.pose()), self.world.bent(i, state));
            self.world.gravity() + attitude.apply(turning.cross(arm) + bent)
        });
        self.ask(Some(&accelerations.collect::<Vec<_>>()))
    }

    fn ask(&self, accelerations: Option<&[Vec3]>) -> Result<Answer, MotionError> {
        match self.asked.len() {
            0..=4 => self.ask_sized::<4>(accelerations),
            5..=MOST_TOUCHING => self.ask_sized::<MOST_TOUCHING>(accelerations),
            count => Err(MotionError::TooManyTouching { time: self.time, count, most: MOST_TOUCHING }),
        }
    }

    fn ask_sized<const N: usize>(&self, accelerations: Option<&[Vec3]>) -> Result<Answer, MotionError> {
        let (body, state) = (self.world.body(), self.state);
        let touch = |i: usize| Touch {
            arm: state.attitude.apply(self.world.arm(i, state.pose())),
            normal: self.world.normal(i, state.pose()),
            friction: 0.0,
            restitution: 0.0,
        };
        let touches: Vec<Touch> = self.asked.iter().map(touch).collect();
        let refused = |error| MotionError::Impact { time: self.time, error };
        let mut set = ContactSet::<N>::of_free_body(&state.rigid(body), &touches).map_err(refused)?;
        for (i, a) in accelerations.unwrap_or_default().iter().enumerate() {
            // The question is the same on both clocks: in motion accelerations stand where velocities stand in an impact.
            set.velocity[i] = set.frame[i] * *a;
        }
        let states = set.states_of_keeping();
        let without = self.asked.iter().position(|i| Some(i) == self.without);
        let ways: Vec<_> = states.consistent.iter().filter(|s| without.is_none_or(|k| !s.kept[k])).collect();
        let conclusion = ways.len().conclusion();
        let chosen = match (self.choice, conclusion) {
            (Choice::End, Conclusion::Several) => None,
            (Choice::KeepFewest, _) => ways.last(),
            _ => ways.first(),
        };
        let way = chosen.map(|s| Way {
            kept: self.asked.iter().enumerate().filter(|(k, _)| s.kept[*k]).map(|(_, i)| i).collect(),
            sliding: Supports::NONE,
            pushes: self
                .asked
                .iter()
                .enumerate()
                .map(|(k, i)| (i, set.frame[k].transposed() * s.impulse[k]))
                .collect(),
            friction_demand: narrowest(&s.impulse, &s.free),
            open: if s.free.is_empty() { Freedom::None } else { Freedom::Rates },
        });
        Ok(Answer { conclusion, way })
    }
}
