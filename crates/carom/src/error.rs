//! One error for all the crates behind the face.

use carom_feeder::RunError;
use carom_impact::ImpactError;
use carom_motion::MotionError;
use carom_motion::planar::ShapeProblem;
use carom_scene::Problems;
use carom_study::regions::RegionsError;
use thiserror::Error;

/// Anything that can go wrong behind this crate, so that `?` serves for all of it.
///
/// What a part does is never an error: a part that jams, misses its plate or bounces until the budget of events is spent is an
/// [`Outcome`](crate::feeder::Outcome) of its run.
///
/// # Example
/// ```
/// use carom::prelude::*;
/// // Two problems in one file, and both are named.
/// let error = Error::from(Scene::parse("bad.toml", "[part]\nshape = \"rod\"\nlength = \"100 mn\"\nmass = -1\n").unwrap_err());
/// assert!(error.is_input() && !error.is_budget());
/// let text = error.to_string();
/// assert!(text.contains("bad.toml:3:10: part.length") && text.contains("bad.toml:4:8: part.mass"), "{text}");
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum Error {
    /// A scene or an impact's file: every problem, each with line, key, value and what is allowed.
    #[error(transparent)]
    Scene(#[from] Problems),
    /// A feeder cannot be run, or its run met a fault of the numbers.
    #[error(transparent)]
    Run(#[from] RunError),
    /// A walk in time met a fault of the numbers.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// An impact that was asked for directly could not be resolved.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// Axes or options over which no regions can be sought.
    #[error(transparent)]
    Regions(#[from] RegionsError),
    /// Vertices and a radius that are not a shape: every problem found.
    #[error("not a shape: {}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))]
    Shape(Vec<ShapeProblem>),
}

impl From<Vec<ShapeProblem>> for Error {
    fn from(problems: Vec<ShapeProblem>) -> Self {
        Self::Shape(problems)
    }
}

impl Error {
    /// True where what was asked cannot be answered as it stands: change the input.
    pub fn is_input(&self) -> bool {
        match self {
            Self::Scene(_) | Self::Shape(_) | Self::Regions(_) | Self::Run(RunError::Problems(_)) => true,
            Self::Impact(error) => matches!(
                error,
                ImpactError::TooMany { .. }
                    | ImpactError::OutsideDomain { .. }
                    | ImpactError::Faults(_)
                    | ImpactError::Overflow
            ),
            _ => false,
        }
    }

    /// True where a budget of steps ran out before the answer was found. (A run that spends its budget of time or events is no error:
    /// [`Outcome::NeverFlat`](crate::feeder::Outcome::NeverFlat).)
    pub fn is_budget(&self) -> bool {
        matches!(self.of_impact(), Some(ImpactError::Unending { .. }))
    }

    /// True where no consistent motion leads through an impact that was asked for directly. (A run in which this happens ends as
    /// [`Outcome::Jammed`](crate::feeder::Outcome::Jammed).)
    pub fn is_jammed(&self) -> bool {
        matches!(self.of_impact(), Some(ImpactError::Jammed | ImpactError::Circling { .. }))
    }

    /// What an impact said, whether it was asked for directly or met on a walk.
    fn of_impact(&self) -> Option<&ImpactError> {
        match self {
            Self::Impact(error)
            | Self::Motion(MotionError::Impact { error, .. })
            | Self::Run(RunError::Motion(MotionError::Impact { error, .. })) => Some(error),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_feeder::FeederProblem;

    fn on_the_way(error: ImpactError) -> MotionError {
        MotionError::Impact { time: 1.0, error }
    }

    #[test]
    fn input_is_told_from_budget_and_from_physics() {
        let unending = ImpactError::Unending { stages: 9 };
        let cases: [(Error, [bool; 3]); 9] = [
            (vec![ShapeProblem::Empty].into(), [true, false, false]),
            (RunError::Problems(vec![FeederProblem::NoPlates]).into(), [true, false, false]),
            (ImpactError::TooMany { count: 7, most: 6 }.into(), [true, false, false]),
            (ImpactError::Overflow.into(), [true, false, false]),
            (unending.into(), [false, true, false]),
            (RunError::Motion(on_the_way(unending)).into(), [false, true, false]),
            (ImpactError::Jammed.into(), [false, false, true]),
            (ImpactError::Circling { stages: 3 }.into(), [false, false, true]),
            (MotionError::NotFinite { time: 0.0 }.into(), [false, false, false]),
        ];
        for (error, expected) in cases {
            assert_eq!([error.is_input(), error.is_budget(), error.is_jammed()], expected, "{error:?}");
        }
    }

    #[test]
    fn a_shape_names_all_its_problems() {
        let text = Error::from(vec![ShapeProblem::Coincide(0, 1), ShapeProblem::Coincide(2, 3)]).to_string();
        assert_eq!(text, "not a shape: vertices 0 and 1 coincide; vertices 2 and 3 coincide");
    }

    #[test]
    fn what_an_impact_says_on_a_walk_is_no_fault_of_the_input() {
        let error = Error::from(on_the_way(ImpactError::Overflow));
        assert!(!error.is_input(), "the walk made those numbers");
        assert_eq!(error.to_string(), "at t = 1 s: the numbers of the impact overflow: choose other units");
    }
}
