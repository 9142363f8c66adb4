//! What the judge says: counts and errors by engine and group.

use crate::case::Case;
use crate::judge::{Judged, Verdict};
use carom_words::aligned;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write as _;

/// What the judge says of all engines.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom judge")]
pub struct JudgeReport {
    /// How many cases there are.
    pub cases: usize,
    /// How far an answer may be off and still agree, as a share of the motion before; null where the tolerance of each case counts.
    pub within: Option<f64>,
    /// Each engine, in the order of their names.
    pub engines: Vec<EngineReport>,
}

/// What the judge says of one engine.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct EngineReport {
    /// Its name.
    pub engine: String,
    /// All cases together.
    pub all: GroupReport,
    /// Each group of cases.
    pub groups: Vec<GroupReport>,
    /// Each case.
    pub judged: Vec<Judged>,
}

/// Counts and errors of a group of cases.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct GroupReport {
    /// Its name.
    pub group: String,
    /// How many cases it has.
    pub cases: usize,
    /// Answers that the law allows.
    pub agree: usize,
    /// Answers that another law or convention gives.
    pub other_convention: usize,
    /// Answers that are none of these.
    pub differ: usize,
    /// Cases that the engine cannot be asked.
    pub refused: usize,
    /// Cases without an answer.
    pub missing: usize,
    /// Answers with more energy than before, and than the nearest answer that the law allows.
    pub gained_energy: usize,
    /// How far answers are from the nearest one that the law allows.
    pub difference: Spread,
    /// How far the restitution that is seen is from the one that is known, where there is one contact.
    pub restitution_error: Spread,
    /// How far the energy after is off, as a share of that before.
    pub energy_error: Spread,
    /// How far spins are off.
    pub spin_error: Spread,
}

/// Middle and largest of the sizes of some numbers.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Spread {
    /// The median; null where there are none.
    pub median: Option<f64>,
    /// The largest; null where there are none.
    pub largest: Option<f64>,
}

impl Spread {
    fn of(numbers: impl Iterator<Item = f64>) -> Self {
        let mut sizes: Vec<f64> = numbers.map(f64::abs).collect();
        sizes.sort_by(f64::total_cmp);
        Self { median: sizes.get(sizes.len() / 2).copied(), largest: sizes.last().copied() }
    }
}

impl GroupReport {
    fn of(group: &str, judged: &[&Judged]) -> Self {
        let count = |verdict: Verdict| judged.iter().filter(|one| one.verdict == verdict).count();
        let restitution = |one: &&Judged| Some(one.restitution? - one.restitution_expected?);
        Self {
            group: group.to_owned(),
            cases: judged.len(),
            agree: count(Verdict::Agrees),
            other_convention: count(Verdict::OtherConvention),
            differ: count(Verdict::Differs),
            refused: count(Verdict::Refused),
            missing: count(Verdict::Missing),
            gained_energy: judged.iter().filter(|one| one.gained_energy).count(),
            difference: Spread::of(judged.iter().filter_map(|one| one.difference)),
            restitution_error: Spread::of(judged.iter().filter_map(restitution)),
            energy_error: Spread::of(judged.iter().filter_map(|one| one.energy_error)),
            spin_error: Spread::of(judged.iter().filter_map(|one| one.spin_error)),
        }
    }
}

impl JudgeReport {
    pub(crate) fn new(cases: &[Case], judged: Vec<(String, Vec<Judged>)>, within: Option<f64>) -> Self {
        let mut names: Vec<&str> = vec![];
        for case in cases {
            if !names.contains(&case.group.as_str()) {
                names.push(&case.group);
            }
        }
        let engines = judged.into_iter().map(|(engine, judged)| {
            let all: Vec<&Judged> = judged.iter().collect();
            let of = |group: &&str| {
                let own = cases.iter().zip(&judged).filter(|(case, _)| case.group == **group);
                GroupReport::of(group, &own.map(|(_, judged)| judged).collect::<Vec<_>>())
            };
            let (all, groups) = (GroupReport::of("all", &all), names.iter().map(of).collect());
            EngineReport { engine, all, groups, judged }
        });
        Self { cases: cases.len(), within, engines: engines.collect() }
    }

    /// For a person: each engine's groups as a table, and below it what the columns mean.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for engine in &self.engines {
            // Writing to a String cannot fail.
            let all = &engine.all;
            let answered = all.cases - all.missing - all.refused;
            let _ = writeln!(
                text,
                "{}: {} of {answered} answers agree, {} follow another law or convention; {} of {} cases without an answer\n",
                engine.engine,
                all.agree,
                all.other_convention,
                all.missing + all.refused,
                all.cases,
            );
            let head = [
                "group",
                "agree",
                "other",
                "differ",
                "none",
                "difference",
                "largest",
                "restitution",
                "energy",
                "spin",
                "gained",
            ];
            let rows = std::iter::once(head.map(str::to_owned).to_vec());
            let groups = engine.groups.iter().filter(|group| group.cases > group.missing).map(row);
            let _ = writeln!(text, "{}", aligned(&rows.chain(groups).collect::<Vec<_>>()));
        }
        let agree = match self.within {
            Some(share) => format!("off by {} of the motion at most", shown(share)),
            None => "off by no more than the tolerance of the case".to_owned(),
        };
        let _ = write!(text, "agree: what the law of the case allows, {agree}.{NOTES}");
        text
    }
}

const NOTES: &str = "
other: what another law of restitution, or another convention on sharing, gives. none: refused or missing. gained: more energy than before,
where the law gives less.
difference, restitution, energy, spin: medians of how far answers are from the nearest one that the law allows: the root of the kinetic
energy of the difference (largest: the worst); restitution seen at the one contact; energy after; spins. Shares of what was before.
";

fn row(group: &GroupReport) -> Vec<String> {
    let share = |number: Option<f64>| number.map_or("-".to_owned(), shown);
    vec![
        group.group.clone(),
        group.agree.to_string(),
        group.other_convention.to_string(),
        group.differ.to_string(),
        (group.refused + group.missing).to_string(),
        share(group.difference.median),
        share(group.difference.largest),
        share(group.restitution_error.median),
        share(group.energy_error.median),
        share(group.spin_error.median),
        group.gained_energy.to_string(),
    ]
}

/// A share: in per cent from a hundredth of one on, else by its power of ten.
fn shown(share: f64) -> String {
    const PLAIN: std::ops::Range<f64> = 1e-4..1e3;
    match share {
        0.0 => "0".to_owned(),
        share if PLAIN.contains(&share) => format!("{:.2} %", 100.0 * share),
        share => format!("{share:.0e}"),
    }
}
