//! Where two parts of a feed come in each other's way first, and what they were doing.

use crate::feed::FeedRun;
use crate::run::{Outcome, Stage, StageName};
use carom_motion::planar::trace::Impact;

/// What a part is doing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Doing {
    /// Its stage; `None` where it has just been put on the first plate.
    pub stage: Option<StageName>,
    /// The plate or wall it is on; in flight, the one it was on last. Plates first, then walls.
    pub obstacle: usize,
}

/// The first time that two parts of a feed are in each other's way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstContact {
    /// Their numbers, from 0, the lower first; the lower one goes ahead.
    pub parts: [usize; 2],
    /// When [s].
    pub time: f64,
    /// What each was doing until then.
    pub doing: [Doing; 2],
    /// True where the second found its place taken and did not start; false where they touched.
    pub blocked: bool,
}

impl FeedRun {
    /// The first touch of two parts, or the first start that is blocked, whichever comes first; `None` where no part is in another's way.
    ///
    /// `fixed` is the number of plates and walls.
    pub fn first_meeting(&self, fixed: usize) -> Option<FirstContact> {
        let touch = self.contacts.first().map(|contact| (contact.time, contact.parts, false));
        let blocked = self.parts.iter().position(|part| part.run.outcome == Outcome::Blocked);
        let blocked = blocked.map(|late| {
            let before = self.parts[..late].iter().rposition(|p| p.run.outcome != Outcome::Blocked);
            (self.parts[late].entered, [before.unwrap_or(0), late], true)
        });
        let first = |a: (f64, [usize; 2], bool), b: (f64, [usize; 2], bool)| if b.0 < a.0 { b } else { a };
        let (time, parts, blocked) = match (touch, blocked) {
            (Some(touch), Some(blocked)) => first(touch, blocked),
            (touch, blocked) => touch.or(blocked)?,
        };
        let doing = parts.map(|number| {
            let run = &self.parts[number].run;
            let struck = |impact: &Impact| Some((impact.time, impact.contacts.first()?.obstacle));
            Doing::until(time, &run.stages, run.trace.impacts.iter().filter_map(struck), fixed)
        });
        Some(FirstContact { parts, time, doing, blocked })
    }
}

impl Doing {
    /// What a part was doing until a time: its last stage that began before; in flight, what it left or struck last. `strikes` are the times and the obstacles of its impacts, in order, and
    /// `fixed` is the number of plates and walls.
    pub(crate) fn until<S, F>(
        time: f64,
        stages: &[Stage<S, F>],
        strikes: impl Iterator<Item = (f64, usize)>,
        fixed: usize,
    ) -> Self {
        let (mut doing, own) = (Self { stage: None, obstacle: 0 }, |o: &usize| *o < fixed);
        let mut left = f64::NEG_INFINITY;
        for stage in stages.iter().take_while(|stage| stage.start_time < time) {
            doing.stage = Some(stage.name);
            if let Some(obstacle) = stage.obstacle.filter(own) {
                (doing.obstacle, left) = (obstacle, stage.end_time);
            }
        }
        let struck = strikes.take_while(|(at, _)| *at < time).filter(|(at, _)| *at >= left);
        if let Some(obstacle) = struck.map(|(_, obstacle)| obstacle).filter(own).last() {
            doing.obstacle = obstacle;
        }
        doing
    }
}
