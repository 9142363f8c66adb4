//! Several parts, one after the other: those that touch push each other, part and go on.

use crate::course::{Course, Watcher};
use crate::drop::{Prepared, RunError};
use crate::feeder::FeederProblem;
use crate::run::{Outcome, Run};
use carom_motion::MotionError;
use carom_motion::planar::observer::HeldContact;
use carom_motion::planar::trace::{Impact, Trace};
use carom_motion::planar::{Crowd, Happening, Options, Recorder, Surface, World};

/// How a feeder is fed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Feed {
    /// Number of parts.
    pub parts: usize,
    /// Time from one part's start to the next [s].
    pub interval: f64,
    /// How parts rub and rebound on each other.
    pub between: Surface,
}

/// One of several parts.
#[derive(Clone, Debug, PartialEq)]
pub struct FedPart {
    /// When it started [s].
    pub entered: f64,
    /// Its run; times count from the first part's start. Its trace goes on after the outcome, to the end of the feed; what it touches beyond
    /// the plates and walls is another part, see [`FedPart::other_part`].
    pub run: Run,
}

/// Two parts that touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Their numbers, from 0, the lower first.
    pub parts: [usize; 2],
    /// When they touch first [s].
    pub time: f64,
    /// Speed of the points that strike each other then [m/s]; `None` where they come to touch without a strike.
    pub speed: Option<f64>,
}

/// What several parts did.
#[derive(Clone, Debug, PartialEq)]
pub struct FeedRun {
    /// The parts, in order.
    pub parts: Vec<FedPart>,
    /// The first contact of each two parts that touch, in order of time.
    pub contacts: Vec<Contact>,
    /// When nothing was left to decide [s].
    pub end_time: f64,
    /// Why the feed was broken off there, where it was: more parts or contacts together than are resolved, or a fault of the numbers.
    pub broken_off: Option<MotionError>,
}

/// Most parts of one feed.
const MOST_PARTS: usize = 100;
/// The longest interval [s]: all parts share one clock, and a late one must not lose its digits.
const LONGEST: f64 = 3600.0;

impl Prepared<'_> {
    /// Feeds several parts and keeps everything.
    ///
    /// A part that finds its place taken does not start: [`Outcome::Blocked`]. A part that rests may be struck by a later one and go on; its outcome
    /// is that at the end of the feed.
    ///
    /// # Errors
    /// [`RunError::Problems`] for what is wrong with the feed. What happened before a fault of the motion is kept: [`FeedRun::broken_off`].
    pub fn feed(&self, feed: &Feed) -> Result<FeedRun, RunError> {
        self.check(feed).map_err(RunError::Problems)?;
        let world = World {
            bodies: vec![self.feeder.part.body.clone(); feed.parts],
            between: feed.between,
            ..self.world.clone()
        };
        let mut recorders = vec![Recorder::default(); feed.parts];
        let (mut parts, end_time, broken_off) = Feeding::new(self, feed, &world, &mut recorders).follow();
        for (part, recorder) in parts.iter_mut().zip(recorders) {
            part.run.trace = recorder.into_trace();
            part.run.stages = crate::stages::stages(self.feeder, &world.obstacles, &part.run.trace);
        }
        let contacts = contacts(&parts, world.obstacles.len());
        Ok(FeedRun { parts, contacts, end_time, broken_off })
    }

    fn check(&self, feed: &Feed) -> Result<(), Vec<FeederProblem>> {
        let mut found = vec![];
        let mut demand = |fine: bool, path: &str, value: f64, allowed: &'static str| {
            if !fine {
                found.push(FeederProblem::OutOfRange { path: path.to_owned(), value, allowed });
            }
        };
        #[expect(clippy::cast_precision_loss, reason = "only shown")]
        let count = feed.parts as f64;
        demand((1..=MOST_PARTS).contains(&feed.parts), "feed.parts", count, "1 to 100");
        demand(
            feed.interval > 0.0 && feed.interval <= LONGEST,
            "feed.interval",
            feed.interval,
            "above 0 s, at most 3600 s",
        );
        let Surface { friction, restitution } = feed.between;
        demand(friction.is_finite() && friction >= 0.0, "feed.friction", friction, "0 or more");
        demand((0.0..=1.0).contains(&restitution), "feed.restitution", restitution, "0 to 1");
        if found.is_empty() { Ok(()) } else { Err(found) }
    }
}

impl FedPart {
    /// The number, from 0, of the part that an obstacle's number in this part's trace stands for; `None` for plates and walls.
    pub fn other_part(obstacle: usize, plates_and_walls: usize) -> Option<usize> {
        obstacle.checked_sub(plates_and_walls)
    }
}

/// A feed on its way.
struct Feeding<'p, 'f, 'o, 'w> {
    prepared: &'p Prepared<'f>,
    feed: &'o Feed,
    crowd: Crowd<'w>,
    watchers: Vec<Watcher<'o>>,
    courses: Vec<Course<'p, 'f>>,
    parts: Vec<FedPart>,
    /// Its outcome stands, whatever it meets.
    decided: Vec<bool>,
}

impl<'p, 'f, 'o, 'w> Feeding<'p, 'f, 'o, 'w> {
    fn new(
        prepared: &'p Prepared<'f>,
        feed: &'o Feed,
        world: &'w World,
        recorders: &'o mut [Recorder],
    ) -> Self {
        #[expect(clippy::cast_precision_loss, reason = "at most a hundred")]
        let lasts = feed.interval * feed.parts as f64;
        let options = Options {
            most_time: prepared.options.most_time + lasts,
            most_events: prepared.options.most_events * feed.parts as u64,
            ..prepared.options
        };
        let mut watchers = vec![];
        for (number, recorder) in recorders.iter_mut().enumerate() {
            watchers.push(Watcher::new(prepared, starts(feed, number), recorder));
        }
        Self {
            prepared,
            feed,
            crowd: Crowd::new(world, options),
            watchers,
            courses: (0..feed.parts).map(|_| Course::new(prepared)).collect(),
            parts: vec![],
            decided: vec![],
        }
    }

    fn follow(mut self) -> (Vec<FedPart>, f64, Option<MotionError>) {
        let broken_off = self.walk().err();
        // Those still on their way, or woken after a rest, have come to nothing yet.
        let outcome = if broken_off.is_some() { Outcome::Unresolved } else { Outcome::NeverFlat };
        for body in 0..self.parts.len() {
            let Some(part) = self.crowd.member(body).filter(|m| m.ended().is_none()) else { continue };
            if !self.decided[body] {
                self.parts[body].run = self.courses[body].finish(outcome, &part, &self.watchers[body]);
            }
        }
        (self.parts, self.crowd.time(), broken_off)
    }

    fn walk(&mut self) -> Result<(), MotionError> {
        self.enter_due()?;
        while !self.is_over() {
            let due = if self.parts.len() < self.feed.parts {
                starts(self.feed, self.parts.len())
            } else {
                f64::INFINITY
            };
            let step = self.crowd.advance(due, &mut self.watchers)?;
            for body in step.bodies {
                self.note(body, step.happening);
            }
            if step.happening == Happening::BudgetSpent {
                break;
            }
            self.enter_due()?;
        }
        self.crowd.pause(&mut self.watchers)
    }

    /// True where all parts have started, and each has come to an outcome that stands or rests.
    fn is_over(&self) -> bool {
        let settled =
            |body: usize| self.decided[body] || self.crowd.member(body).is_none_or(|m| m.ended().is_some());
        self.parts.len() == self.feed.parts && (0..self.parts.len()).all(settled)
    }

    /// Lets the parts start whose time has come.
    fn enter_due(&mut self) -> Result<(), MotionError> {
        let number = self.parts.len();
        if number == self.feed.parts || starts(self.feed, number) > self.crowd.time() {
            return Ok(());
        }
        let start = self.prepared.start;
        let entered = self.crowd.time();
        let free = self.crowd.has_room(number, &start)?;
        let outcome = if free { Outcome::NeverFlat } else { Outcome::Blocked };
        self.parts.push(FedPart { entered, run: Run::without_motion(outcome, entered) });
        self.decided.push(!free);
        if free {
            self.crowd.enter(number, start, self.prepared.sides.clone())?;
        }
        self.enter_due()
    }

    fn note(&mut self, body: usize, happening: Happening) {
        let Some(part) = self.crowd.member(body) else { return };
        // What happens to one of several that were together is asked of each.
        let happening =
            if happening == Happening::Moves { happening } else { part.ended().unwrap_or(Happening::Moves) };
        let gone = happening == Happening::FliesAway;
        if !self.decided[body]
            && let Some(outcome) = self.courses[body].note(happening, &part, &mut self.watchers[body])
        {
            self.parts[body].run = self.courses[body].finish(outcome, &part, &self.watchers[body]);
            self.decided[body] = happening != Happening::Rests;
        }
        if gone {
            self.crowd.leave(body);
        }
    }
}

/// When a part starts [s].
fn starts(feed: &Feed, number: usize) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "at most a hundred")]
    let number = number as f64;
    feed.interval * number
}

/// The first contact of each two parts.
fn contacts(parts: &[FedPart], fixed: usize) -> Vec<Contact> {
    let mut out: Vec<Contact> = vec![];
    for (number, part) in parts.iter().enumerate() {
        for (time, obstacle, speed) in touches(&part.run.trace) {
            let Some(other) = FedPart::other_part(obstacle, fixed).filter(|o| *o > number) else { continue };
            match out.iter_mut().find(|c| c.parts == [number, other]) {
                Some(known) if known.time < time || (known.time == time && known.speed.is_some()) => {}
                Some(known) => (known.time, known.speed) = (time, speed),
                None => out.push(Contact { parts: [number, other], time, speed }),
            }
        }
    }
    out.sort_by(|a, b| a.time.total_cmp(&b.time));
    out
}

/// What a part touches, and when: by a strike, with its speed, or held from the start of a piece.
fn touches(trace: &Trace) -> impl Iterator<Item = (f64, usize, Option<f64>)> + '_ {
    let struck = |impact: &Impact| {
        let time = impact.time;
        let contacts = impact.contacts.iter().map(move |c| {
            let speed = (c.before.slip * c.before.slip + c.before.normal * c.before.normal).sqrt();
            (time, c.obstacle, Some(speed))
        });
        contacts.collect::<Vec<_>>()
    };
    let held = trace.pieces.iter().flat_map(|piece| {
        let time = piece.start_time;
        piece.held.iter().map(move |h: &HeldContact| (time, h.obstacle, None))
    });
    trace.impacts.iter().flat_map(struck).chain(held)
}
