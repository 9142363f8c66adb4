//! An impact in space, resolved and told: what `carom impact` says of it.

mod closed_form;

use crate::tasks::MADE_BY;
use carom_figure::{ImpactFigure, RollContact};
use carom_scene::{
    ImpactAxes, SpatialImpactContactReport, SpatialImpactEndReport, SpatialImpactProblem, SpatialImpactReport,
};
use carom_words::number::ascii;

/// An impact in space, and what a program is told of it.
pub struct SpatialImpactStudy {
    /// The impact.
    pub problem: SpatialImpactProblem,
    /// Its answer.
    pub report: SpatialImpactReport,
}

impl SpatialImpactStudy {
    /// Resolves an impact.
    pub fn of(problem: SpatialImpactProblem) -> Self {
        let report = SpatialImpactReport::new(&problem, &problem.solve());
        Self { problem, report }
    }

    /// What the closed form says, and whether the engine agrees; `None` where none covers the impact.
    pub fn closed_form(&self) -> Option<String> {
        closed_form::of(&self.problem, &self.report)
    }

    /// Everything that its report shows; `source` is the file as written.
    pub fn figure(&self, title: &str, source: &str) -> ImpactFigure {
        figure(&self.report, (title, source), self.closed_form())
    }

    /// Its report, one HTML page.
    pub fn page(&self, title: &str, source: &str) -> String {
        carom_figure::impact_report(&self.figure(title, source))
    }
}

/// What happens, in a few words.
pub fn verdict(report: &SpatialImpactReport) -> String {
    match &report.end {
        None => format!("no answer: {}", report.not_staged.clone().unwrap_or_default()),
        Some(end) if end.contacts.iter().all(|c| c.normal_impulse == 0.0) => {
            "nothing happens: no contact approaches".to_owned()
        }
        Some(end) => {
            let each = end.contacts.iter().map(|c| format!("{} {}", c.name, c.state.as_str()));
            each.collect::<Vec<_>>().join(", ")
        }
    }
}

/// How many ways on there were, and by which law.
pub fn lead(report: &SpatialImpactReport) -> String {
    // Of several ways on a stage names each; a load that can be shared otherwise is one way.
    let shares = report.stages.iter().all(|stage| stage.ways_on.len() <= 1);
    let ways = match report.outcome.as_str() {
        "unique" if !report.examined => "one way on was found at every stage; others may exist",
        "unique" => "one way on at every stage",
        "several" if shares => "how contacts share the load is open: other sharings leave other motions",
        "several" => "several ways on, of which one was chosen",
        _ => "no way on",
    };
    let forced = report.stages.iter().filter(|stage| stage.forced.is_some()).count();
    let ways = match (report.outcome.as_str(), forced) {
        ("forced", _) => String::new(),
        _ => format!("{ways} · "),
    };
    let forced = match forced {
        0 => String::new(),
        1 => "no way on is consistent at one stage: a contact is loaded alone · ".to_owned(),
        n => format!("no way on is consistent at {n} stages: a contact is loaded alone · "),
    };
    format!("{ways}{forced}{} law · in space", report.law)
}

/// Three numbers for a terminal.
pub fn triple(v: [f64; 3]) -> String {
    v.map(|x| ascii(x, 6)).join("  ")
}

/// How each body moves after it, a sentence each.
fn after(end: &SpatialImpactEndReport) -> Vec<String> {
    let of = |name: &str, velocity, spin| {
        format!("After{name}: velocity {} m/s, spin {} rad/s.", triple(velocity), triple(spin))
    };
    let alone = end.velocity_m_s.zip(end.spin_rad_s).map(|(velocity, spin)| of("", velocity, spin));
    let several = end.bodies.iter().map(|b| of(&format!(", {}", b.name), b.velocity_m_s, b.spin_rad_s));
    alone.into_iter().chain(several).collect()
}

fn figure(
    report: &SpatialImpactReport,
    (title, source): (&str, &str),
    beside: Option<String>,
) -> ImpactFigure {
    let length =
        |v: [f64; 3], normal: f64| (v.iter().map(|x| x * x).sum::<f64>() - normal * normal).max(0.0).sqrt();
    let contact = |c: &SpatialImpactContactReport| RollContact {
        name: c.name.clone(),
        state: c.state.as_str().to_owned(),
        impulse: [c.normal_impulse, length(c.impulse, c.normal_impulse)],
        velocity: [c.normal_velocity_m_s, length(c.velocity_m_s, c.normal_velocity_m_s)],
    };
    let mut notes: Vec<String> =
        vec!["In space: tangential impulses and slips are given by their size.".to_owned()];
    notes.extend(beside);
    if report.axes == ImpactAxes::Contact {
        notes.push("Each contact has axes of its own, as the operator was given.".to_owned());
    }
    notes.extend(report.end.iter().flat_map(after));
    let named = |k: usize, words: &str| format!("stage {}: {words}", k + 1);
    let stages = || report.stages.iter().enumerate();
    for (k, stage) in stages() {
        notes.extend(stage.forced.iter().map(|why| named(k, &format!("no way on is consistent: {why}."))));
    }
    let found = stages().flat_map(|(k, stage)| stage.ways_on.iter().map(move |way| named(k, way)));
    let rejected = stages().flat_map(|(k, stage)| {
        stage.rejected.iter().map(move |r| [named(k, &r.hypothesis), r.because.clone()])
    });
    ImpactFigure {
        title: title.to_owned(),
        verdict: verdict(report),
        lead: lead(report),
        notes,
        contacts: report.end.as_ref().map_or(vec![], |end| end.contacts.iter().map(contact).collect()),
        bodies: vec![],
        energy: report.end.as_ref().and_then(|end| Some([end.energy_before?, end.energy_after?])),
        sketch: None,
        picture: None,
        shared: vec![],
        found: found.collect(),
        stages: Some(report.stages.len()),
        rejected: Some(rejected.collect()),
        left_out: report.stages.iter().map(|stage| stage.rejected_left_out).sum(),
        source: source.to_owned(),
        made_by: MADE_BY.to_owned(),
    }
}
