//! Where a body is at equal intervals of time, and just before and after each strike.

use super::{RollProblem, RollRun};
use crate::grammar::{kind::TIME, read_quantity};
use crate::node::{Node, Value};
use carom_motion::MotionError;
use carom_motion::planar::State;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt;

/// Poses at equal intervals that a roll has at most.
pub const MOST_POSES: u32 = 1_000_000;

/// An interval between poses \[s\]: "10 ms", or a number of seconds.
///
/// # Errors
/// What is wrong with it, in a sentence.
///
/// # Example
/// ```
/// use carom_scene::pose_interval;
/// assert_eq!((pose_interval("10 ms"), pose_interval("0.01")), (Ok(0.01), Ok(0.01)));
/// ```
pub fn pose_interval(text: &str) -> Result<f64, String> {
    let value = match text.trim().parse() {
        Ok(number) => Value::Number(number),
        Err(_) => Value::Text(text.to_owned()),
    };
    let read = read_quantity("", &Node { value, span: 0..0 }, TIME, None).map(|read| read.value);
    read.map_err(|list| list.into_iter().map(|problem| problem.message).collect::<Vec<_>>().join("; "))
}

/// Why a body is not followed with its poses.
#[derive(Clone, Debug, PartialEq)]
pub enum PosesError<E> {
    /// A fault of the numbers.
    Fault(E),
    /// There would be more than [`MOST_POSES`].
    TooMany {
        /// So many at multiples of the interval.
        poses: f64,
        /// Until the end \[s\].
        end_time: f64,
    },
}

impl<E: fmt::Display> fmt::Display for PosesError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fault(fault) => fault.fmt(f),
            Self::TooMany { poses, end_time } => {
                let least = end_time / f64::from(MOST_POSES - 1);
                write!(
                    f,
                    "so short an interval makes {poses:.0} poses in {end_time:.4} s, {MOST_POSES} are allowed: take {least:.2e} s or more, or a shorter `time`"
                )
            }
        }
    }
}

impl<E: fmt::Debug + fmt::Display> std::error::Error for PosesError<E> {}

/// A run with its poses, unless they are too many.
pub(super) fn shown<R, E>(
    followed: Result<(R, Option<f64>), E>,
    end_time: impl Fn(&R) -> f64,
) -> Result<R, PosesError<E>> {
    match followed {
        Ok((run, Some(poses))) => Err(PosesError::TooMany { poses, end_time: end_time(&run) }),
        Ok((run, None)) => Ok(run),
        Err(fault) => Err(PosesError::Fault(fault)),
    }
}

/// Where a pose stands among the strikes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PoseMark {
    /// At a multiple of the interval. At the very time of a strike it is the pose after it.
    Regular,
    /// Just before the strike of this number, from 0.
    BeforeStrike(usize),
    /// Just after the strike of this number, from 0.
    AfterStrike(usize),
    /// Where the body is no longer followed.
    End,
}

/// A pose and velocity of a body, in the plane or in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollPose<S> {
    /// When \[s\].
    pub time: f64,
    /// Which it is.
    pub mark: PoseMark,
    /// Pose and velocity.
    pub state: S,
}

/// Collects poses while a body moves.
pub(super) struct Sampler<S> {
    /// \[s\]; `None` where no poses are wanted.
    every: Option<f64>,
    regular: u32,
    strikes: usize,
    poses: Vec<RollPose<S>>,
}

impl<S: Copy> Sampler<S> {
    pub(super) fn new(every: Option<f64>) -> Self {
        Self { every, regular: 0, strikes: 0, poses: vec![] }
    }

    /// The time of the next regular pose \[s\].
    pub(super) fn next(&self) -> f64 {
        let every = self.every.filter(|_| self.regular < MOST_POSES);
        every.map_or(f64::INFINITY, |every| f64::from(self.regular) * every)
    }

    pub(super) fn show(&mut self, time: f64, state: S) {
        self.poses.push(RollPose { time, mark: PoseMark::Regular, state });
        self.regular += 1;
    }

    pub(super) fn strike(&mut self, time: f64, before: S, after: S) {
        if self.every.is_some() {
            let number = self.strikes;
            self.poses.push(RollPose { time, mark: PoseMark::BeforeStrike(number), state: before });
            self.poses.push(RollPose { time, mark: PoseMark::AfterStrike(number), state: after });
            self.strikes += 1;
        }
    }

    /// All poses of a body that was followed through so many strikes to this end, where any are wanted; or how many there would be, where they are too many.
    pub(super) fn finish(
        mut self,
        strikes: usize,
        end_time: f64,
        end: S,
    ) -> (Option<Vec<RollPose<S>>>, Option<f64>) {
        let Some(every) = self.every else { return (None, None) };
        let all = (end_time / every).floor() + 1.0;
        if all > f64::from(MOST_POSES) {
            return (None, Some(all));
        }
        self.poses.retain(|pose| match pose.mark {
            PoseMark::BeforeStrike(number) | PoseMark::AfterStrike(number) => number < strikes,
            PoseMark::Regular | PoseMark::End => pose.time < end_time,
        });
        let regular = self.poses.iter().filter(|pose| pose.mark == PoseMark::Regular).count();
        let rest = (regular..=MOST_POSES as usize).map(|number| number as f64 * every);
        let mark = PoseMark::Regular;
        self.poses.extend(rest.take_while(|t| *t <= end_time).map(|time| RollPose {
            time,
            mark,
            state: end,
        }));
        self.poses.push(RollPose { time: end_time, mark: PoseMark::End, state: end });
        // What is asked for while a series is closed is shown after the strike at its limit.
        self.poses.sort_by(|a, b| a.time.total_cmp(&b.time));
        (Some(self.poses), None)
    }
}

/// What stands beside a pose at a strike or at the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PoseAt {
    /// Just before a strike.
    BeforeStrike,
    /// Just after a strike.
    AfterStrike,
    /// Where the body is no longer followed.
    End,
}

impl PoseMark {
    /// As results say it: what it is, and the strike's place in `strikes`.
    pub(super) fn words(self) -> (Option<PoseAt>, Option<usize>) {
        match self {
            Self::Regular => (None, None),
            Self::BeforeStrike(number) => (Some(PoseAt::BeforeStrike), Some(number)),
            Self::AfterStrike(number) => (Some(PoseAt::AfterStrike), Some(number)),
            Self::End => (Some(PoseAt::End), None),
        }
    }
}

/// A pose in the plane.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RollPoseReport {
    /// When [s].
    pub t_s: f64,
    /// Where it stands beside a strike, or at the end; absent at a multiple of the interval.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub at: Option<PoseAt>,
    /// The strike's place in `strikes`, from 0; absent where the pose is at none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub strike: Option<usize>,
    /// The mass centre [m].
    pub position_m: [f64; 2],
    /// Angle of the body from its start on the level, counter-clockwise; whole turns count [rad].
    pub angle_rad: f64,
    /// Velocity of the mass centre [m/s].
    pub velocity_m_s: [f64; 2],
    /// Spin, counter-clockwise: a body that rolls forward has a negative one [rad/s].
    pub spin_rad_s: f64,
}

/// The poses of a run, where some were asked for.
pub(super) fn report(run: &RollRun) -> Option<Vec<RollPoseReport>> {
    let of = |pose: &RollPose<State>| {
        let ((at, strike), State { pose: place, twist }) = (pose.mark.words(), pose.state);
        RollPoseReport {
            t_s: pose.time,
            at,
            strike,
            position_m: [place.centre.x, place.centre.y],
            angle_rad: place.angle,
            velocity_m_s: [twist.velocity.x, twist.velocity.y],
            spin_rad_s: twist.spin,
        }
    };
    Some(run.poses.as_ref()?.iter().map(of).collect())
}

impl RollProblem {
    /// Follows the body through its strikes, as [`RollProblem::follow`], and keeps its poses at all multiples of an interval \[s\] and at every strike.
    ///
    /// # Errors
    /// A fault of the numbers, or too many poses.
    ///
    /// # Example
    /// A cylinder that rolls with 10 rad/s has turned by −1 after 0.1 s, and has come 10 cm far.
    /// ```
    /// use carom_scene::{RollKind, RollProblem};
    /// let cylinder = RollProblem::parse(RollKind::Cylinder, "c.toml", "radius = 0.1\ndistance = 0.5", &[])?;
    /// let (start, poses) = (cylinder.start.pose, cylinder.follow_showing(0.1)?.poses.unwrap());
    /// let there = poses[1].state.pose;
    /// assert!((there.centre.x - start.centre.x - 0.1).abs() < 1e-12 && (there.angle + 1.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn follow_showing(&self, interval: f64) -> Result<RollRun, PosesError<MotionError>> {
        shown(super::walk::follow(self, Some(interval)), |run| run.end_time)
    }
}
