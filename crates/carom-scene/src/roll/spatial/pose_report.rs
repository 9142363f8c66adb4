//! What many throws of a body say, as JSON.

use super::{SpatialRollProblem, ThrownBodyReport};
use crate::map_report::StudyRunReport;
use crate::quantity::{Quantity, Tolerance};
use crate::word::PoseWord;
use crate::yield_report::{ProbabilityReport, SpreadReport};
use carom_study::poses::{Plan, Pose, Posed, Poses};
use carom_words::Words;
use schemars::JsonSchema;
use serde::Serialize;

/// A quantity that may vary from throw to throw.
///
/// # Example
/// Limits of ±3 are three standard deviations.
/// ```
/// use carom_scene::{ThrowRangeReport, quantity::{Allowed, Kind, Quantity, Tolerance}, unit::Dimension};
/// let kind = Kind::new(Dimension::Spin, Allowed::Any);
/// let tolerance = Some(Tolerance::Limits { half_width: 3.0 });
/// let range = ThrowRangeReport::from(&Quantity { tolerance, ..Quantity::default_of(9.0, kind) });
/// assert_eq!((range.low, range.high, range.sigma), (Some(6.0), Some(12.0), Some(1.0)));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ThrowRangeReport {
    /// Lowest; null where a normal distribution has no end.
    pub low: Option<f64>,
    /// Its value, or the middle of its tolerance.
    pub middle: f64,
    /// Highest; null where a normal distribution has no end.
    pub high: Option<f64>,
    /// fixed, uniform, or normal.
    #[schemars(extend("enum" = ["fixed", "uniform", "normal"]))]
    pub distribution: &'static str,
    /// Standard deviation, of a normal distribution before its ends are cut; null of the others.
    pub sigma: Option<f64>,
}

/// A way in which throws end.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PoseEndReport {
    /// How.
    pub end: PoseWord,
    /// The face that is down; null of the other ends.
    pub face: Option<usize>,
    /// Its vertices.
    pub vertices: Vec<String>,
    /// Its unit normal, outwards.
    pub normal: Option<[f64; 3]>,
    /// True where the mass centre is over the face.
    pub stable: Option<bool>,
    /// With what probability a throw ends so.
    pub probability: ProbabilityReport,
    /// Of the throws that come to rest on a face, the share on this one, with Wilson's interval of independent throws; null of other ends.
    pub of_resting: Option<ProbabilityReport>,
    /// The first throw that ends so; null where none does.
    pub first: Option<PoseThrowReport>,
}

/// One throw, to be made again.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PoseThrowReport {
    /// The repetition that it is of.
    pub repetition: usize,
    /// Its number in it.
    pub number: u64,
    /// What `carom roll body --set` makes it again from.
    pub set: Vec<String>,
}

/// Many throws of a body.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom roll body --throws")]
pub struct PoseReport {
    /// body.
    #[schemars(extend("const" = "body"))]
    pub kind: &'static str,
    /// The law of its strikes, in a sentence.
    pub law: String,
    /// Mass [kg].
    pub mass_kg: f64,
    /// The body.
    pub body: ThrownBodyReport,
    /// Of its lowest vertex above the plane [m].
    pub height_m: ThrowRangeReport,
    /// Horizontal speed [m/s].
    pub speed_m_s: ThrowRangeReport,
    /// Size of the spin [rad/s].
    pub spin_rate_rad_s: ThrowRangeReport,
    /// Velocity upwards at the release [m/s].
    pub rise_m_s: f64,
    /// Throws, in 16 repetitions.
    pub throws: u64,
    /// What every random number comes from.
    pub seed: u64,
    /// Every way in which throws end; their counts add up to all of them. Faces come first: every stable one, and any other that came up.
    pub ends: Vec<PoseEndReport>,
    /// With what probability a throw comes to rest on a face.
    pub resting: ProbabilityReport,
    /// When those come to rest [s].
    pub time_s: Option<SpreadReport>,
    /// Their strikes.
    pub strikes: Option<SpreadReport>,
    /// What it took.
    pub run: StudyRunReport,
}

impl From<&Quantity> for ThrowRangeReport {
    fn from(quantity: &Quantity) -> Self {
        let middle = quantity.value;
        let [least, most] = quantity.kind.interval();
        let within = |low: f64, high: f64| (Some(low.max(least)), Some(high.min(most)));
        let ((low, high), distribution, sigma) = match quantity.tolerance {
            None => ((Some(middle), Some(middle)), "fixed", None),
            Some(Tolerance::Uniform { low, high }) => (within(low, high), "uniform", None),
            Some(Tolerance::Limits { half_width }) => {
                (within(middle - half_width, middle + half_width), "normal", Some(half_width / 3.0))
            }
            Some(Tolerance::Sigma { sigma }) => {
                let end = |end: f64| end.is_finite().then_some(end);
                ((end(least), end(most)), "normal", Some(sigma))
            }
        };
        Self { low, middle, high, distribution, sigma }
    }
}

impl PoseReport {
    /// The report of a sampling; `None` where no body is thrown. `law` says in a sentence by which law strikes go.
    pub fn new(
        problem: &SpatialRollProblem,
        plan: &Plan,
        found: &Poses,
        law: &str,
        run: StudyRunReport,
    ) -> Option<Self> {
        let body = ThrownBodyReport::new(problem)?;
        let throw = &problem.thrown.as_ref()?.throw;
        let ends = found.ends.iter().map(|posed| end(problem, plan, &body, posed)).collect();
        Some(Self {
            kind: problem.kind.word(),
            law: law.to_owned(),
            mass_kg: problem.world.body().mass(),
            height_m: (&throw.height).into(),
            speed_m_s: (&throw.speed).into(),
            spin_rate_rad_s: (&throw.spin_rate).into(),
            rise_m_s: throw.rise,
            throws: found.throws,
            seed: plan.seed,
            ends,
            resting: found.resting.into(),
            time_s: found.time.as_ref().map(Into::into),
            strikes: found.impacts.as_ref().map(Into::into),
            body,
            run,
        })
    }
}

fn end(problem: &SpatialRollProblem, plan: &Plan, body: &ThrownBodyReport, posed: &Posed) -> PoseEndReport {
    let face = match posed.pose {
        Pose::Face(face) => body.faces.get(face),
        _ => None,
    };
    let first = posed.first.map(|(repetition, number)| PoseThrowReport {
        repetition,
        number,
        set: problem.overrides(&problem.release(&plan.point(repetition, number))),
    });
    PoseEndReport {
        end: PoseWord(posed.pose),
        face: face.map(|face| face.face),
        vertices: face.map_or(vec![], |face| face.vertices.clone()),
        normal: face.map(|face| face.normal),
        stable: face.map(|face| face.stable),
        probability: posed.probability.into(),
        of_resting: posed.of_resting.map(Into::into),
        first,
    }
}
