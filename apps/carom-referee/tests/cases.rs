//! The cases themselves: how many there are, of what kinds, and whether closed forms and engine say the same.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use carom_referee::{Case, Known, Verdict, cases, judge, read_answers, read_cases};
use carom_scene::{AnyImpact, ImpactAnswerReport, SpatialImpactReport};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// What the engine answers to an impact, as a line of an answer file.
fn answered(case: &Case) -> Option<String> {
    let impact = case.impact.as_ref()?.to_string();
    let end: Value = match AnyImpact::parse_json(&case.case, &impact).expect("it is an impact file") {
        AnyImpact::Planar(problem) => {
            serde_json::to_value(ImpactAnswerReport::new(&problem, &problem.solve()).staged)
                .expect("it is JSON")
        }
        AnyImpact::Spatial(problem) => {
            serde_json::to_value(SpatialImpactReport::new(&problem, &problem.solve()).end)
                .expect("it is JSON")
        }
    };
    let body =
        |from: &Value| json!({ "velocity_m_s": from["velocity_m_s"], "spin_rad_s": from["spin_rad_s"] });
    let bodies: Vec<Value> = match end["bodies"].as_array().filter(|list| !list.is_empty()) {
        Some(list) => list.iter().map(body).collect(),
        None => vec![body(&end)],
    };
    Some(json!({ "case": case.case, "engine": "Carom", "bodies": bodies }).to_string())
}

#[test]
fn there_are_cases_of_every_kind_each_with_a_name_of_its_own() {
    let cases = cases();
    let mut groups: BTreeMap<&str, usize> = BTreeMap::new();
    for case in &cases {
        *groups.entry(&case.group).or_default() += 1;
    }
    let several = cases.iter().filter(|case| case.expected.answers.len() > 1).count();
    let others = cases.iter().filter(|case| !case.expected.others.is_empty()).count();
    assert!(others >= 100, "laws or conventions differ on {others}");
    // What is asked and has no answer is left out: none may be lost without being seen.
    assert_eq!((cases.len(), groups["on feet in space"], groups["wedge"]), (632, 24, 40), "{groups:?}");
    let names: BTreeSet<&str> = cases.iter().map(|case| case.case.as_str()).collect();
    assert_eq!(names.len(), cases.len(), "each has its own name");
    assert!(several >= 24, "{several} have several answers");
    assert!(groups.values().all(|count| *count >= 16), "no group is too small to count: {groups:?}");
    let verdicts: BTreeSet<_> =
        cases.iter().filter_map(|case| case.expected.answers[0].verdict.clone()).collect();
    assert_eq!(verdicts.len(), 2, "drops end both ways");
}

#[test]
fn every_type_of_impact_occurs_under_every_law() {
    let mut types: BTreeMap<(String, u8), usize> = BTreeMap::new();
    for case in cases().iter().filter(|case| case.group.starts_with("one contact, ")) {
        let impact = case.impact.as_ref().expect("it is an impact").to_string();
        let AnyImpact::Planar(problem) =
            AnyImpact::parse_json("case", &impact).expect("it is an impact file")
        else {
            panic!("it is in the plane")
        };
        let report = ImpactAnswerReport::new(&problem, &problem.solve());
        let kind = report.staged.and_then(|staged| staged.kind).expect("one contact acts");
        *types.entry((case.group.clone(), kind)).or_default() += 1;
    }
    assert_eq!(types.len(), 21, "seven types under three laws: {types:?}");
}

#[test]
fn a_case_is_written_and_read_as_it_is() {
    let cases = cases();
    let text: String =
        cases.iter().map(|case| format!("{}\n", serde_json::to_string(case).expect("it is JSON"))).collect();
    assert_eq!(read_cases("cases.jsonl", &text).expect("they are cases"), cases, "nothing is lost");
}

#[test]
fn the_engine_agrees_with_every_case_and_closed_forms_with_it() {
    let cases = cases();
    let lines: Vec<String> = cases.iter().filter_map(answered).collect();
    let answers = read_answers("engine.jsonl", &lines.join("\n"), &cases).expect("they are answers");
    let report = judge(&cases, &answers, None);
    let [engine] = &report.engines[..] else { panic!("one engine answered") };
    let wrong: Vec<_> = engine.judged.iter().filter(|one| one.verdict == Verdict::Differs).collect();
    assert!(wrong.is_empty(), "{wrong:?}");
    let closed = engine
        .groups
        .iter()
        .filter(|group| group.group.starts_with("one contact, ") || group.group == "ball");
    for group in closed {
        assert_eq!(group.agree, group.cases, "{}", group.group);
        let worst = group.difference.largest.expect("there are answers");
        // Rounding of both, magnified by what the numbers of a case are sensitive to.
        assert!(worst < 1e-14, "{}: closed forms and walk differ by {worst:e}", group.group);
    }
}

#[test]
fn answers_of_other_laws_and_conventions_are_told_as_such() {
    let cases = cases();
    let line = |case: &Case, known: &Known| json!({ "case": case.case, "bodies": known.bodies }).to_string();
    let lines: Vec<String> =
        cases.iter().filter_map(|case| Some(line(case, case.expected.others.last()?))).collect();
    let answers = read_answers("others.jsonl", &lines.join("\n"), &cases).expect("they are answers");
    let report = judge(&cases, &answers, None);
    assert_eq!(report.engines[0].all.other_convention, lines.len(), "each follows another law or convention");
    let told = |name: &str| report.engines[0].judged.iter().any(|one| one.nearest.as_deref() == Some(name));
    assert!(told("newton") && told("in sequence"), "and it is named");
}
