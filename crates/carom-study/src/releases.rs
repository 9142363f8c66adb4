//! A stool that is let go standing on one support: what its first strike keeps, and how it ends.

use carom_motion::spatial::{
    Body, Choice, End, Impact, Observer, Options, Overturning, State, Supports, World, run,
};
use carom_num::elementary::sin_cos;
use carom_num::{Mat3, Rotation, Vec3};
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// The stool's own gravity [m/s²]: its circle of supports has the radius 1 m, and so rates are in units of √(g/a).
const GRAVITY: f64 = 1.0;
/// Time after which a stool that has neither come to rest nor overturned is given up, in units of √(a/g).
const MOST_TIME: f64 = 400.0;
/// Strikes after which it is given up: a series of them is closed long before.
const MOST_STRIKES: u64 = 1000;

/// A stool of revolution on n supports, let go standing on support 0. Lengths are in units of the circle's radius a, rates in units of √(g/a).
///
/// # Example
/// A stool whose mass centre is as high as its circle of four supports is wide tips over an edge, √½ from the
/// middle, beyond `atan √½`.
/// ```
/// use carom_study::releases::{Release, Settled};
/// let stool = |tilt: f64| Release {
///     supports: 4, centre: 1.0, gyration: 0.5, axial: 1.0, tilt, direction: 0.25 * std::f64::consts::PI,
///     spin: 0.0, strikes: 1,
/// };
/// let border = 0.5f64.sqrt().atan();
/// assert_eq!(stool(border + 1e-3).followed().settled, Settled::Overturned);
/// assert_eq!(stool(border - 1e-3).followed().settled, Settled::GoesOn);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Release {
    /// Supports, 3 to 12, evenly on the circle; they are numbered round it.
    pub supports: u32,
    /// The mass centre above the supports, > 0.
    pub centre: f64,
    /// Radius of gyration across the axis, > 0.
    pub gyration: f64,
    /// Moment about the axis by that across it, in (0, 2].
    pub axial: f64,
    /// It is turned so far [rad] about a direction in the plane of the supports …
    pub tilt: f64,
    /// … which has this angle from the line from the middle to support 0 [rad]; 90° lifts it straight over support 0.
    pub direction: f64,
    /// Its spin about its axis.
    pub spin: f64,
    /// Strikes after which nobody looks on; 0 for none.
    pub strikes: u32,
}

/// How it ends.
///
/// # Example
/// A cube tilted the other way would stand in the floor.
/// ```
/// use carom_study::releases::{Release, Settled};
/// let cube = Release {
///     supports: 4, centre: 0.5f64.sqrt(), gyration: (1.0f64 / 3.0).sqrt(), axial: 1.0, tilt: 0.1,
///     direction: 0.25 * std::f64::consts::PI, spin: 0.0, strikes: 0,
/// };
/// assert_eq!(cube.followed().settled, Settled::AtRest);
/// assert_eq!(Release { tilt: -0.1, ..cube }.followed().settled, Settled::NoStart);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Settled {
    /// It comes to rest on its supports.
    AtRest,
    /// It turns over.
    Overturned,
    /// Without sliding there is no way on.
    NoConsistentOutcome,
    /// It still moves after as many strikes, or as much time, as were granted.
    GoesOn,
    /// It stands still on a support or an edge.
    Balanced,
    /// It cannot start so: a support would be below the plane.
    NoStart,
}

/// What became of a release.
///
/// # Example
/// A cube that comes down from standing on an edge touches with all four corners and keeps the far two.
/// ```
/// use carom_study::releases::{Release, Released};
/// let cube = Release {
///     supports: 4, centre: 0.5f64.sqrt(), gyration: (1.0f64 / 3.0).sqrt(), axial: 1.0, tilt: 0.1,
///     direction: 0.25 * std::f64::consts::PI, spin: 0.0, strikes: 0,
/// };
/// let Released { first: [touching, kept], .. } = cube.followed();
/// assert_eq!((touching.len(), kept.len()), (4, 2));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Released {
    /// How it ended.
    pub settled: Settled,
    /// Of the first strike: which supports touch in it, and which are kept. Both are empty where there is none.
    pub first: [Supports; 2],
}

/// Remembers the first strike, and stops after some.
struct Watcher {
    most: u32,
    seen: u32,
    first: [Supports; 2],
}

impl Observer for Watcher {
    fn impact(&mut self, impact: &Impact) -> ControlFlow<()> {
        if self.seen == 0 {
            self.first = [impact.touching, impact.kept];
        }
        self.seen += 1;
        if self.seen == self.most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    }
}

impl Release {
    /// Lets it go and follows it. Where the law leaves several ways open, the one that keeps the most contacts is followed.
    ///
    /// # Example
    /// A cube, tilted straight over its edge, rocks to rest: what comes down first is the far edge.
    /// ```
    /// use carom_study::releases::{Release, Settled};
    /// let cube = Release {
    ///     supports: 4, centre: 0.5f64.sqrt(), gyration: (1.0f64 / 3.0).sqrt(), axial: 1.0, tilt: 0.1,
    ///     direction: 0.25 * std::f64::consts::PI, spin: 0.0, strikes: 0,
    /// };
    /// assert_eq!(cube.followed().settled, Settled::AtRest);
    /// assert_eq!(Release { tilt: 1.0, ..cube }.followed().settled, Settled::Overturned);
    /// ```
    pub fn followed(&self) -> Released {
        let mut watcher = Watcher { most: self.strikes, seen: 0, first: [Supports::NONE; 2] };
        let settled = match self.run(&mut watcher) {
            None => Settled::NoStart,
            Some(End::AtRest { .. }) => Settled::AtRest,
            Some(End::Balanced { .. }) => Settled::Balanced,
            Some(End::Overturned) => Settled::Overturned,
            Some(End::NoConsistentOutcome(_) | End::Several(_)) => Settled::NoConsistentOutcome,
            Some(End::BudgetSpent(_) | End::Stopped | End::Flat { .. } | End::FliesAway) => Settled::GoesOn,
        };
        Released { settled, first: watcher.first }
    }

    /// `None` where it cannot start.
    fn run(&self, watcher: &mut Watcher) -> Option<End> {
        let place = |j: u32| {
            let (sin, cos) = sin_cos(TAU * f64::from(j) / f64::from(self.supports));
            Vec3::new(cos, sin, -self.centre)
        };
        let across = self.gyration * self.gyration;
        let inertia = Mat3::diagonal(across, across, self.axial * across);
        let body = Body::new(1.0, inertia, (0..self.supports).map(place).collect()).ok()?;
        let (sin, cos) = sin_cos(self.direction);
        let attitude = Rotation::by(Vec3::new(cos, sin, 0.0) * self.tilt);
        let start = State::standing(&body, 0, attitude, Vec3::Z * self.spin);
        let world = World::new(body, Vec3::Z * -GRAVITY).ok()?;
        let options = Options {
            most_time: MOST_TIME,
            most_impacts: MOST_STRIKES,
            choice: Choice::KeepMost,
            overturning: Some(Overturning::Beyond),
            ..Options::default()
        };
        Some(run(&world, &start, &options, watcher).ok()?.end)
    }
}
