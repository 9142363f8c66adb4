//! The run of a body: stretches of motion, impacts, and which supports are held after them.

use super::motion::{Event, Stop};
use super::series::Recent;
use crate::MotionError;
use crate::evaluated::watched;
use crate::spatial::geometry::state::State;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::Scales;
use crate::spatial::geometry::world::World;
use crate::spatial::modes::contacts::{Answer, Question};
use crate::spatial::modes::mode::{Mode, spanned};
use crate::spatial::modes::settle::settled;
use crate::spatial::modes::stretch::Heights;
use crate::spatial::record::observer::Observer;
use crate::spatial::record::run::Impact;
use crate::spatial::record::run::{Budget, Clock, Closing, End, Run};
use crate::spatial::terms::{Effort, Options};
use crate::tolerance::{ONE_INSTANT, ROUNDING_OF_TIME};
use carom_impact::spatial::Conclusion;
use carom_num::Vec3;

/// Events at one instant after which a run ends: what it does there has no end.
const MOST_AT_ONE_INSTANT: u32 = 1000;

/// A body on its way.
pub(super) struct Walker<'w> {
    pub(in crate::spatial) world: &'w World,
    pub(in crate::spatial) scales: Scales,
    pub(in crate::spatial) options: &'w Options,
    pub(in crate::spatial) observer: &'w mut dyn Observer,
    pub(in crate::spatial) time: f64,
    pub(in crate::spatial) state: State,
    pub(in crate::spatial) mode: Mode,
    /// Heights of the supports: counted on, not measured from the attitude, as long as they are small.
    pub(in crate::spatial) heights: Heights,
    /// How long the last stretch lasted [s].
    pub(super) lasted: f64,
    /// Supports that have left the plane without speed at the start of the present stretch.
    pub(super) departing: Supports,
    /// Corners that touch at present, and for which others of their faces speak.
    pub(super) beside: Supports,
    /// The next step [s]; 0 where none is known.
    pub(in crate::spatial) length: f64,
    /// The latest impacts, the latest limits of series of them, and those of series of such: bounces on a corner, between the corners of an edge, and from edge
    /// to edge. What supports do between impacts, however smoothly they start to slip, stick or open, shrinks with them and ends no series.
    pub(super) recent: [Recent; 3],
    /// The first strikes of supports that strike one after the other.
    pub(super) turns: Recent,
    pub(in crate::spatial) impacts: Vec<Impact>,
    pub(in crate::spatial) closings: Vec<Closing>,
    pub(in crate::spatial) drift: f64,
    /// Where slips that were zero start in the present mode, world axes.
    pub(super) leads: Vec<(usize, Vec3)>,
    /// When friction has forced the latest impacts without approach \[s\], and how many of them there were at that instant.
    pub(super) forced: (f64, u32),
    /// Work of friction between impacts so far \[J\].
    pub(in crate::spatial) friction_work: f64,
    pub(in crate::spatial) effort: Effort,
}

/// Lets a body move until it ends.
///
/// *Without friction in the world* the body moves without sliding: a support that is held stays where it is, whatever friction that takes. Between impacts it flies, turns about a
/// support or an edge; a support is let go once the normal force on it falls to zero, one that comes down makes an impact
/// ([`carom_impact::spatial::ContactSet::states_of_keeping`]). After an impact the same law says of the accelerations which of the supports that
/// touch at rest are held.
///
/// *With friction* ([`World::with_friction`]) every support that touches sticks, slides or opens, as the rate problem says
/// ([`carom_impact::spatial::RateProblem`]), until the friction that one takes comes to the edge of its cone, a slip to its end, a normal force to zero, or
/// another support to the plane; impacts are walked through with friction ([`carom_impact::spatial::staged`]).
///
/// # Guarantees
/// - No touch is missed: the acceleration of each height is bounded by the energy, and steps forward are never longer than this bound allows. While supports slide the bound is one and
///   a half times what five places of a step show. Of edges that cross it is the gap times the sine between them that is bounded.
/// - No loss of a normal force is missed, as far as five nodes of a step, and of its halves where they do not suffice, show it.
/// - Where the law leaves several ways open, [`Options::choice`] chooses, and every impact says how many there were.
///
/// # Errors
/// [`MotionError`]: faults of the numbers. How the motion ends, whatever it is, is [`Run::end`].
///
/// # Limits
/// A body that chatters strikes infinitely often in finite time; the series is closed at the limit of its last periods once little is left of it
/// ([`Options::closing`], [`Run::closings`]), and so are series of such limits, and of those. What the law would say of hops smaller than that is not asked.
///
/// Without friction impacts are plastic; each says how much friction it needs, and where no motion without sliding is consistent the run ends.
///
/// With friction, more supports than determine their forces carry the body as equal springs do: where
/// a body turns while it slides on four supports or more, its motion depends on that. At most sixteen supports are asked at once; of a face that touches with more than eight corners six
/// speak for the others, and every other one that would sink in. A point in a corner is one of each plane. A place that is a corner, an edge and a face at once counts once. A contact is between the ends of its face or its edges up to 1e-12 of the
/// reach. A slip below 1e-11 of the world's speed is rest. Closed series keep the friction of their impulses to first order in what is left of them. Where friction lets no motion go on
/// (Painlevé's paradox) there is an impact without approach, or else, by name, no consistent outcome; so ends a run too whose impact the walk of
/// [`carom_impact::spatial::staged`] gives up.
///
/// # Example
/// A cube of 1 m, tilted about one of its lower edges by 0.1 and let go, rocks to rest.
/// ```
/// use carom_motion::spatial::{Body, End, Options, State, World, run};
/// use carom_num::{Mat3, Rotation, Vec3};
/// let third = 1.0 / 6.0;
/// let corner = |x: f64, y: f64| Vec3::new(x, y, -0.5);
/// let corners = vec![corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
/// let cube = Body::new(1.0, Mat3::diagonal(third, third, third), corners).unwrap();
/// let start = State::standing(&cube, 0, Rotation::by(Vec3::X * 0.1), Vec3::ZERO);
/// let world = World::new(cube, Vec3::Z * -9.81).unwrap();
/// let end = run(&world, &start, &Options::default(), &mut ()).unwrap();
/// assert!(matches!(end.end, End::AtRest { .. }));
/// // Each impact leaves a quarter of the spin.
/// let first = &end.impacts[0];
/// assert!((first.kinetic_after / first.kinetic_before - 1.0 / 16.0).abs() < 1e-12);
/// ```
pub fn run(
    world: &World,
    start: &State,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Run, MotionError> {
    options.check()?;
    if world.body().is_round() && world.friction().is_none() {
        return Err(MotionError::Rolls);
    }
    let mut walker = Walker::new(world, start, options, observer)?;
    let end = match walker.begin()? {
        Some(end) => end,
        None => walker.go_on()?,
    };
    let Walker { time, state, impacts, closings, drift, friction_work, effort, .. } = walker;
    Ok(Run { end, time, state, impacts, closings, drift, friction_work, effort })
}

impl<'w> Walker<'w> {
    fn new(
        world: &'w World,
        start: &State,
        options: &'w Options,
        observer: &'w mut dyn Observer,
    ) -> Result<Self, MotionError> {
        // A quaternion that somebody writes has the length 1 only to the digits written; the run keeps it from there on.
        let attitude = carom_num::Rotation::of(start.attitude.to_array());
        let Some(attitude) = attitude.filter(|_| start.is_finite()) else {
            return Err(MotionError::NotFinite { time: 0.0 });
        };
        Ok(Self {
            world,
            scales: world.scales(),
            options,
            observer,
            time: 0.0,
            state: State { attitude, ..*start },
            mode: Mode::Flight,
            heights: vec![0.0; world.count()],
            lasted: 0.0,
            departing: Supports::NONE,
            beside: Supports::NONE,
            length: 0.0,
            recent: Default::default(),
            turns: Recent::default(),
            impacts: vec![],
            closings: vec![],
            drift: 0.0,
            leads: vec![],
            forced: (f64::NAN, 0),
            friction_work: 0.0,
            effort: Effort::default(),
        })
    }

    fn go_on(&mut self) -> Result<End, MotionError> {
        let (mut instant, mut events) = (self.time, 0);
        loop {
            let time = self.time;
            if time - instant > ONE_INSTANT * self.scales.time {
                (instant, events) = (time, 0);
            }
            events += 1;
            if events > MOST_AT_ONE_INSTANT {
                return Ok(End::BudgetSpent(Budget::Steps));
            }
            let (end, lost) = watched(|| self.advance());
            // What it has come to is not to be relied on.
            if lost && end.is_ok() {
                return Err(MotionError::NotFinite { time });
            }
            if let Some(end) = end? {
                return Ok(end);
            }
            if self.effort.impacts >= self.options.most_impacts {
                return Ok(End::BudgetSpent(Budget::Impacts));
            }
        }
    }

    /// To the next event, and through it.
    fn advance(&mut self) -> Result<Option<End>, MotionError> {
        if self.observer.starts(self.time, self.mode, &self.state).is_break() {
            self.goes_to_the_limit()?;
            return Ok(Some(End::Stopped));
        }
        let stop = self.glide()?;
        self.beside = self.flat_beside()?;
        Ok(match stop {
            Stop::Event(Event::Touches(support)) => self.meet(Supports::one(support))?,
            Stop::Event(Event::Lets { support, .. }) => self.let_go(support)?,
            Stop::Event(Event::Slips(which)) => self.slip_starts(which)?,
            Stop::Event(Event::Gives) => self.gives()?,
            Stop::Event(Event::Stops) => self.slip_stops()?,
            Stop::Event(Event::Jams) => self.strike_unapproached(self.mode.held(self.world))?,
            Stop::Event(Event::Leaves { support, .. }) => self.leave(support)?,
            Stop::Event(Event::Flattens(_)) => Some(End::Flat { touching: self.mode.held(self.world) }),
            Stop::Event(Event::Overturns) => Some(End::Overturned),
            Stop::Spent(budget) => Some(End::BudgetSpent(budget)),
            Stop::Away => Some(End::FliesAway),
            Stop::Still => Some(self.at_rest()),
        })
    }

    /// Nothing moves, and what touches without being pressed stays on the plane too: with it the body may be more than balanced.
    fn at_rest(&self) -> End {
        let held = self.mode.held(self.world);
        let touching = held.union(self.departing);
        match Mode::sticking(self.world, touching, self.state.pose()) {
            Mode::Rest { .. } => End::AtRest { held: spanned(self.world, touching) },
            _ => End::Balanced { held },
        }
    }

    pub(in crate::spatial) fn question(&self, asked: Supports) -> Question<'_> {
        let (world, state, time, choice) = (self.world, &self.state, self.time, self.options.choice);
        Question { world, state, time, asked, without: None, choice }
    }

    /// Enters the mode that holds those of the resting supports that must be held. The others leave the plane; `without` is one of them.
    pub(in crate::spatial) fn hold(
        &mut self,
        resting: Supports,
        without: Option<usize>,
    ) -> Result<Option<End>, MotionError> {
        if self.world.friction().is_some() {
            return self.hold_rough(resting, without);
        }
        let world = self.world;
        let mut held = resting;
        if !resting.is_empty() {
            self.state = settled(world, Mode::holding(world, resting, self.state.pose()), &self.state);
            self.effort.questions += 1;
            match (Question { without, ..self.question(resting) }).of_motion()? {
                Answer { way: Some(way), .. } => held = way.kept,
                Answer { conclusion, .. } => return Ok(Some(without_way(conclusion, Clock::Motion))),
            }
        }
        self.departs(resting.difference(held));
        self.mode = Mode::holding(world, held, self.state.pose());
        self.state = settled(world, self.mode, &self.state);
        let rests = matches!(self.mode, Mode::Rest { .. });
        Ok(rests.then(|| End::AtRest { held: spanned(world, held) }))
    }

    /// No forces on what carries the body keep it as it is any longer. An edge that lies flush beside, over the end of a plate, takes its share of the load first, if there is one: corners on
    /// faces carry from the start.
    fn gives(&mut self) -> Result<Option<End>, MotionError> {
        let held = self.mode.held(self.world);
        let beside = self.lies_flush()?.those(|i| self.world.pair(i).is_some());
        // What has been asked a moment ago has taken nothing over.
        let again = self.lasted <= ROUNDING_OF_TIME * self.scales.time;
        if beside.is_empty() || again {
            return self.slips_apart(None, held);
        }
        self.hold_ahead(held.union(beside))
    }

    /// The normal force of a held support has fallen to zero: the support is let go if there is a way on without it. There is none where the other
    /// supports, or nothing, would let it sink: a force along the plane has kept it up, and only sliding could end that.
    fn let_go(&mut self, support: usize) -> Result<Option<End>, MotionError> {
        let held = self.mode.held(self.world);
        if self.world.friction().is_none() {
            return self.hold(held, Some(support));
        }
        let beside = self.lies_flush()?;
        let end = self.hold(held, Some(support))?;
        if end.is_some() || beside.is_empty() {
            return Ok(end);
        }
        // What lies flush beside those that were held takes the load over from now on, or departs with it: now it may have no acceleration yet.
        let sinking = self.a_moment_later(|walker| walker.sinking(beside))?;
        if !sinking.is_empty() {
            return self.hold_ahead(self.mode.held(self.world).union(sinking));
        }
        self.departing = self.departing.union(beside);
        Ok(None)
    }
}

/// The end where the law offers no way that is followed.
pub(super) fn without_way(conclusion: Conclusion, clock: Clock) -> End {
    match conclusion {
        Conclusion::Several => End::Several(clock),
        Conclusion::Unique | Conclusion::None | Conclusion::Forced => End::NoConsistentOutcome(clock),
    }
}
