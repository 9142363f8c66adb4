//! What the engine says of an impact: every answer, and what other conventions say.

use crate::case::{Body, Case, Expected, Known, Spin};
use crate::motion::Bodies;
use crate::tolerance::SAME;
use carom_impact::Law;
use carom_scene::{
    AnyImpact, EndReport, ImpactAnswerReport, ImpactOutcome, ImpactProblem, SpatialImpactEndReport,
    SpatialImpactProblem, SpatialImpactReport,
};
use carom_words::Words;
use serde_json::Value;

/// A case of the engine's own: `None` where it has no answer, or the file is none.
pub(super) fn case(group: &str, name: String, impact: Value) -> Option<Case> {
    let (expected, source) = match AnyImpact::parse_json(&name, &impact.to_string()).ok()? {
        AnyImpact::Planar(problem) => {
            (in_plane(&problem)?, "Carom's walk through impulse space, in the plane")
        }
        AnyImpact::Spatial(problem) => (in_space(&problem)?, "Carom's walk through impulse space, in space"),
    };
    Some(Case::of_impact((group, name), impact, expected, source))
}

fn in_plane(problem: &ImpactProblem) -> Option<Expected> {
    let report = ImpactAnswerReport::new(problem, &problem.solve());
    let bodies = Bodies::of_plane(problem)?;
    let staged = report.staged.as_ref()?;
    // Of open shares there is a whole range of answers, which no list holds.
    if !staged.open_shares.is_empty() {
        return None;
    }
    let mut answers = vec![planar(report.law.as_str(), &staged.end)?];
    let ends = || report.end_states.iter().filter_map(|end| planar(&end.hypothesis, &end.end));
    let mut in_one_step = vec![];
    match report.outcome {
        ImpactOutcome::Unique => {}
        // The walk ends in none of the states that are consistent at the end; who solves one problem for all of it finds these.
        ImpactOutcome::PathDependent => {
            in_one_step.extend(ends().map(|end| Known { by: format!("in one step: {}", end.by), ..end }));
        }
        // Whatever the law allows counts: the walk chose one of them.
        ImpactOutcome::Several => answers.extend(ends()),
        ImpactOutcome::None | ImpactOutcome::Unresolved | ImpactOutcome::Found | ImpactOutcome::NotFound => {
            return None;
        }
    }
    let shared = report.sharing.iter().filter_map(|way| planar(way.sharing.as_str(), way.end.as_ref()?));
    let laws = Law::ALL.iter().filter_map(|law| {
        let other = ImpactProblem { law: *law, ..problem.clone() };
        let told = ImpactAnswerReport::new(&other, &other.solve_as_asked());
        // Several contacts have their own law, whatever is asked.
        (told.law.0 == *law).then(|| planar(law.word(), &told.staged?.end))?
    });
    in_one_step.extend(if report.sharing.is_empty() { laws.collect::<Vec<_>>() } else { shared.collect() });
    Some(distinct(&bodies, answers, in_one_step))
}

fn in_space(problem: &SpatialImpactProblem) -> Option<Expected> {
    let bodies = Bodies::of_space(problem)?;
    let answer = problem.solve();
    let outcome = answer.outcome.as_ref().ok()?;
    // Where the walk chose there are others that nobody listed.
    if outcome.branches > 1 {
        return None;
    }
    let report = SpatialImpactReport::new(problem, &answer);
    let answers = vec![spatial(report.law.as_str(), report.end.as_ref()?)?];
    let laws = Law::ALL.iter().filter_map(|law| {
        let other = SpatialImpactProblem { law: *law, ..problem.clone() };
        let told = SpatialImpactReport::new(&other, &other.solve());
        (told.law.0 == *law).then(|| spatial(law.word(), told.end.as_ref()?))?
    });
    Some(distinct(&bodies, answers, laws.collect()))
}

/// Each motion once: among the answers, and among the others that are no answers.
pub(super) fn distinct(bodies: &Bodies, answers: Vec<Known>, others: Vec<Known>) -> Expected {
    let differs = |from: &[Known], known: &Known| {
        from.iter().all(|other| bodies.difference(&other.bodies, &known.bodies).is_none_or(|d| d > SAME))
    };
    let mut expected = Expected { answers: vec![], others: vec![] };
    for answer in answers {
        if differs(&expected.answers, &answer) {
            expected.answers.push(answer);
        }
    }
    for other in others {
        if differs(&expected.answers, &other) && differs(&expected.others, &other) {
            expected.others.push(other);
        }
    }
    expected
}

fn planar(by: &str, end: &EndReport) -> Option<Known> {
    let alone = |(velocity, spin): ([f64; 2], f64)| Body {
        velocity_m_s: velocity.to_vec(),
        spin_rad_s: Spin::Plane(spin),
    };
    let bodies = match end.velocity_m_s.zip(end.spin_rad_s) {
        Some(body) => vec![alone(body)],
        None => end.bodies.iter().map(|body| alone((body.velocity_m_s, body.spin_rad_s))).collect(),
    };
    (!bodies.is_empty()).then(|| Known::after(by, bodies))
}

fn spatial(by: &str, end: &SpatialImpactEndReport) -> Option<Known> {
    let alone = |(velocity, spin): ([f64; 3], [f64; 3])| Body {
        velocity_m_s: velocity.to_vec(),
        spin_rad_s: Spin::Space(spin),
    };
    let bodies = match end.velocity_m_s.zip(end.spin_rad_s) {
        Some(body) => vec![alone(body)],
        None => end.bodies.iter().map(|body| alone((body.velocity_m_s, body.spin_rad_s))).collect(),
    };
    (!bodies.is_empty()).then(|| Known::after(by, bodies))
}
