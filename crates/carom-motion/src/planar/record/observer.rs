//! Who looks on while a body moves.

use super::trace::{Impact, PieceEnd};
use crate::planar::geometry::{Feature, State};
use carom_impact::planar::ImpactType;

/// A contact that transmits force, as handed to an observer.
pub use super::trace::{ContactSample, HeldContact};

/// The bare facts of an impact, for runs that keep no trace.
///
/// # Example
/// A ball that has fallen 0.2 m at g = 10 m/s² strikes with 2 m/s; it has no slip, and none starts.
/// ```
/// use carom_impact::planar::ImpactType;
/// use carom_motion::planar::{Observer, Options, Walker, examples};
/// use carom_motion::planar::{observer::ImpactFacts, trace::Impact};
/// let (world, start) = examples::falling_ball();
/// struct Last(Option<ImpactFacts>);
/// impl Observer for Last {
///     fn impact(&mut self, facts: &ImpactFacts, _: Option<Impact>) {
///         self.0 = Some(*facts);
///     }
/// }
/// let mut last = Last(None);
/// Walker::new(&world, start, vec![], Options::default())?.advance(&mut last)?;
/// let struck = last.0.unwrap();
/// assert!((struck.time - 0.2).abs() < 1e-12 && (struck.speed - 2.0).abs() < 1e-12);
/// assert_eq!((struck.obstacle, struck.kind), (0, Some(ImpactType::SticksFromRest)));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactFacts {
    /// Time [s].
    pub time: f64,
    /// Obstacle of the striking contact.
    pub obstacle: usize,
    /// Features of the striking contact.
    pub feature: Feature,
    /// Speed of the striking contact point relative to the obstacle [m/s].
    pub speed: f64,
    /// Type, where one contact acts.
    pub kind: Option<ImpactType>,
    /// State before.
    pub before: State,
    /// State after.
    pub after: State,
}

/// The bare facts of a smooth piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PieceFacts {
    /// Start [s].
    pub start_time: f64,
    /// End [s].
    pub end_time: f64,
    /// Pose and velocity at the start.
    pub start: State,
    /// Pose and velocity at the end.
    pub end: State,
    /// Why it ended.
    pub ended_by: PieceEnd,
}

/// Who looks on. `()` looks at nothing.
///
/// # Example
/// Somebody who notes the speed of each strike: with e = 1/2 each is half of the one before.
/// ```
/// use carom_motion::planar::{Happening, Observer, Options, Walker, examples};
/// use carom_motion::planar::{observer::ImpactFacts, trace::Impact};
/// let (world, start) = examples::falling_ball();
/// struct Speeds(Vec<f64>);
/// impl Observer for Speeds {
///     fn impact(&mut self, facts: &ImpactFacts, _: Option<Impact>) {
///         self.0.push(facts.speed);
///     }
/// }
/// let mut speeds = Speeds(vec![]);
/// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
/// while walker.advance(&mut speeds)? == Happening::Moves {}
/// assert!((speeds.0[0] - 2.0).abs() < 1e-12);
/// assert!(speeds.0[..6].windows(2).all(|v| (v[1] / v[0] - 0.5).abs() < 1e-12));
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
pub trait Observer {
    /// True: samples and whole impacts are made and handed over.
    ///
    /// # Example
    /// Who looks at nothing wants no samples; a recorder does.
    /// ```
    /// use carom_motion::planar::{Observer, Recorder};
    /// assert!(!().is_dense());
    /// assert!(Recorder::default().is_dense());
    /// ```
    fn is_dense(&self) -> bool {
        false
    }

    /// True: slip speeds are handed over.
    fn wants_slips(&self) -> bool {
        false
    }

    /// The time at which the state is wanted next, whatever the steps of the walk are [s]; infinite where none is. Asked again after each.
    fn next_instant(&self) -> f64 {
        f64::INFINITY
    }

    /// The state at the time that [`Observer::next_instant`] has named: not interpolated, but from the formula or the dense output of the step
    /// that holds there. At an event it is the state after it. What is asked for while a series of impacts is closed is the state where it was closed.
    fn instant(&mut self, time: f64, state: &State) {
        let _ = (time, state);
    }

    /// A smooth piece starts with these contacts held.
    fn starts(&mut self, time: f64, state: &State, held: &mut dyn Iterator<Item = HeldContact>) {
        let _ = (time, state, held);
    }

    /// An instant of the present piece; only where [`Observer::is_dense`].
    ///
    /// # Example
    /// At every instant of a fall the energy is what it was at the start: 3 J.
    /// ```
    /// use carom_motion::planar::observer::ContactSample;
    /// use carom_motion::planar::{Observer, Options, State, Walker, World, examples};
    /// let (world, start) = examples::falling_ball();
    /// struct Fall<'w>(&'w World);
    /// impl Observer for Fall<'_> {
    ///     fn is_dense(&self) -> bool {
    ///         true
    ///     }
    ///     fn sample(&mut self, _: f64, state: &State, _: &mut dyn Iterator<Item = ContactSample>) {
    ///         assert!((self.0.energy(&[*state]) - 3.0).abs() < 1e-12);
    ///     }
    /// }
    /// Walker::new(&world, start, vec![], Options::default())?.advance(&mut Fall(&world))?;
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    fn sample(&mut self, time: f64, state: &State, contacts: &mut dyn Iterator<Item = ContactSample>) {
        let _ = (time, state, contacts);
    }

    /// The present piece has ended.
    fn piece(&mut self, piece: &PieceFacts) {
        let _ = piece;
    }

    /// An impact; `whole` only where [`Observer::is_dense`].
    fn impact(&mut self, facts: &ImpactFacts, whole: Option<Impact>) {
        let _ = (facts, whole);
    }

    /// The contact struck last would have to pull to be held: it lifts off at once. Only where
    /// [`Observer::is_dense`].
    ///
    /// # Example
    /// A rod of 1 kg and 1 m that stands upright and spins with 10 rad/s is struck at its foot. To be held
    /// there, its centre would have to move in a circle of ½ m about the foot: the force would be `m (g − ω²
    /// ℓ/2)`, −40 N.
    /// ```
    /// use carom_impact::Law;
    /// use carom_motion::planar::{Observer, Obstacle, Options, Pose, State, Twist, Walker, World, examples};
    /// use carom_num::Vec2;
    /// struct Pull(Option<f64>);
    /// impl Observer for Pull {
    ///     fn is_dense(&self) -> bool {
    ///         true
    ///     }
    ///     fn lifts_off(&mut self, needed_force: f64) {
    ///         self.0 = Some(needed_force);
    ///     }
    /// }
    /// let floor = Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::new(1.0, 0.0), 0.0, 0.0);
    /// let rod = examples::rod(1.0, 1.0, 1.0 / 12.0);
    /// let world = World::of_one(Vec2::new(0.0, -10.0), rod, vec![floor], Law::Poisson);
    /// let pose = Pose { centre: Vec2::new(0.0, 0.5), angle: std::f64::consts::FRAC_PI_2 };
    /// let start = State { pose, twist: Twist { velocity: Vec2::new(0.0, -1.0), spin: 10.0 } };
    /// let mut pull = Pull(None);
    /// Walker::new(&world, start, vec![], Options::default())?.advance(&mut pull)?;
    /// assert!((pull.0.unwrap() + 40.0).abs() < 1e-9);
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    fn lifts_off(&mut self, needed_force: f64) {
        let _ = needed_force;
    }

    /// Infinitely many impacts between these two times [s] were closed at their limit. The limit is right to a millionth of the world's time.
    ///
    /// # Example
    /// A ball strikes first after 0.2 s; its bounces last 0.2 s, 0.1 s, … and are over at 0.6 s. The last few
    /// millionths of the world's time, 0.1 s, are not waited for.
    /// ```
    /// use carom_motion::planar::{Happening, Observer, Options, Walker, examples};
    /// let (world, start) = examples::falling_ball();
    /// struct Limit(f64);
    /// impl Observer for Limit {
    ///     fn accumulation(&mut self, from: f64, to: f64) {
    ///         assert!(0.2 - 1e-12 < from && from < to);
    ///         self.0 = to;
    ///     }
    /// }
    /// let mut limit = Limit(0.0);
    /// let mut walker = Walker::new(&world, start, vec![], Options::default())?;
    /// while walker.advance(&mut limit)? == Happening::Moves {}
    /// assert!((limit.0 - 0.6).abs() < 1e-6);
    /// # Ok::<(), carom_motion::MotionError>(())
    /// ```
    fn accumulation(&mut self, from: f64, to: f64) {
        let _ = (from, to);
    }

    /// Slip speed of a held contact on an obstacle [m/s], at every step of the integration; only where [`Observer::wants_slips`].
    fn slips(&mut self, obstacle: usize, speed: f64) {
        let _ = (obstacle, speed);
    }

    /// An impact acts at a contact with this obstacle: at the contact that strikes, or at another one. Told for each contact, before
    /// [`Observer::impact`].
    fn touches(&mut self, obstacle: usize) {
        let _ = obstacle;
    }
}

impl Observer for () {}

/// The observers, one for each body. The walk is compiled once, whoever looks on: it tells them of events, not of every number.
pub(in crate::planar) type Observers<'o, const B: usize> = [Option<&'o mut dyn Observer>; B];

/// True where somebody wants samples and whole impacts.
pub(in crate::planar) fn is_dense<const B: usize>(observers: &Observers<'_, B>) -> bool {
    observers.iter().flatten().any(|observer| observer.is_dense())
}

/// True where somebody wants slip speeds.
pub(in crate::planar) fn wants_slips<const B: usize>(observers: &Observers<'_, B>) -> bool {
    observers.iter().flatten().any(|observer| observer.wants_slips())
}
