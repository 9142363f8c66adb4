//! The judge: an answer beside what is known.

use crate::answer::Answer;
use crate::case::{Case, Known};
use crate::motion::Bodies;
use crate::report::JudgeReport;
use crate::tolerance::GAINED;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// What is said of an answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// It is one of the answers that the law of the case allows.
    Agrees,
    /// It is what another law of restitution, or another convention on sharing, says.
    OtherConvention,
    /// It is none of these.
    Differs,
    /// The engine said that it cannot be asked.
    Refused,
    /// There is no answer.
    Missing,
}

impl Verdict {
    /// In words: `other convention`.
    ///
    /// # Example
    /// ```
    /// assert_eq!(carom_referee::Verdict::Agrees.word(), "agrees");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::OtherConvention => "other convention",
            Self::Differs => "differs",
            Self::Refused => "refused",
            Self::Missing => "missing",
        }
    }

    /// True where there is an answer.
    pub fn answered(self) -> bool {
        !matches!(self, Self::Refused | Self::Missing)
    }
}

/// One case, judged.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Judged {
    /// The case.
    pub case: String,
    /// What is said of the answer.
    pub verdict: Verdict,
    /// The law, the convention or the hypothesis that it follows, of what it is nearest to.
    pub nearest: Option<String>,
    /// How far it is from the nearest answer that the law allows: the root of the kinetic energy of the difference, as a share of that
    /// before; null for a drop.
    pub difference: Option<f64>,
    /// The same of the spins alone.
    pub spin_error: Option<f64>,
    /// The kinetic energy after less that of the nearest answer, as a share of the energy before.
    pub energy_error: Option<f64>,
    /// True where the energy after is above that before, and above that of the nearest answer.
    pub gained_energy: bool,
    /// The normal velocity after as a share of that before, at the only contact; null where there are more.
    pub restitution: Option<f64>,
    /// The same of the nearest answer.
    pub restitution_expected: Option<f64>,
}

impl Judged {
    fn without_answer(case: &Case, verdict: Verdict) -> Self {
        Self {
            case: case.case.clone(),
            verdict,
            nearest: None,
            difference: None,
            spin_error: None,
            energy_error: None,
            gained_energy: false,
            restitution: None,
            restitution_expected: None,
        }
    }
}

/// Judges the answers of each engine to all cases; a case without an answer is missing. An answer agrees where it is off by no more than the
/// tolerance of its case, or than `within` where that is given: a share of the motion before.
///
/// # Example
/// An engine that repeats what is known is right.
/// ```
/// use carom_referee::{cases, judge, read_answers};
/// let cases = cases();
/// let bodies = serde_json::to_string(&cases[0].expected.answers[0].bodies).unwrap();
/// let line = format!(r#"{{"case": "{}", "bodies": {bodies}}}"#, cases[0].case);
/// let report = judge(&cases, &read_answers("mine.jsonl", &line, &cases).unwrap(), None);
/// let mine = &report.engines[0];
/// assert_eq!((mine.engine.as_str(), mine.all.agree, mine.all.missing), ("mine", 1, cases.len() - 1));
/// ```
pub fn judge(cases: &[Case], answers: &[Answer], within: Option<f64>) -> JudgeReport {
    let name = |answer: &Answer| answer.engine.clone().unwrap_or_default();
    let engines: BTreeSet<String> = answers.iter().map(name).collect();
    let judged = engines.into_iter().map(|engine| {
        let own = answers.iter().filter(|answer| name(answer) == engine);
        let own: BTreeMap<&str, &Answer> = own.map(|answer| (answer.case.as_str(), answer)).collect();
        let judged =
            cases.iter().map(|case| one(case, own.get(case.case.as_str()).copied(), within)).collect();
        (engine, judged)
    });
    JudgeReport::new(cases, judged.collect(), within)
}

fn one(case: &Case, answer: Option<&Answer>, within: Option<f64>) -> Judged {
    let Some(answer) = answer else { return Judged::without_answer(case, Verdict::Missing) };
    if answer.refused.is_some() {
        return Judged::without_answer(case, Verdict::Refused);
    }
    match &case.impact {
        // Cases are read with their impacts: one that is none does not come here.
        Some(asked) => Bodies::of(asked).map_or_else(
            || Judged::without_answer(case, Verdict::Differs),
            |bodies| impact(case, &bodies, answer, within.unwrap_or(case.tolerance)),
        ),
        None => {
            let known = case.expected.answers.iter().find(|known| known.verdict == answer.verdict);
            let verdict = if known.is_some() { Verdict::Agrees } else { Verdict::Differs };
            let nearest = known.map(|known| known.by.clone());
            Judged { nearest, ..Judged::without_answer(case, verdict) }
        }
    }
}

fn impact(case: &Case, bodies: &Bodies, answer: &Answer, within: f64) -> Judged {
    let after = answer.bodies();
    let apart = |known: &&Known| bodies.difference(&known.bodies, &after).unwrap_or(f64::INFINITY);
    let nearest_of = |all: &'_ [Known]| {
        let nearest = all.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
        Some((nearest.clone(), apart(&nearest)))
    };
    let Some((known, difference)) = nearest_of(&case.expected.answers) else {
        return Judged::without_answer(case, Verdict::Differs);
    };
    let other = nearest_of(&case.expected.others).filter(|(_, apart)| *apart <= within);
    let (verdict, by) = if difference <= within {
        (Verdict::Agrees, known.by.clone())
    } else if let Some((other, _)) = other {
        (Verdict::OtherConvention, other.by)
    } else {
        (Verdict::Differs, known.by.clone())
    };
    let before = bodies.energy_before();
    let change = |after: &[crate::Body]| bodies.energy(after).map(|energy| energy / before);
    let (mine, theirs) = (change(&after), change(&known.bodies));
    Judged {
        case: case.case.clone(),
        verdict,
        nearest: Some(by),
        difference: Some(difference),
        spin_error: bodies.spin_difference(&known.bodies, &after),
        energy_error: mine.zip(theirs).map(|(mine, theirs)| mine - theirs),
        gained_energy: mine.is_some_and(|mine| mine > theirs.map_or(1.0, |theirs| theirs.max(1.0)) + GAINED),
        restitution: bodies.restitution(&after),
        restitution_expected: bodies.restitution(&known.bodies),
    }
}
