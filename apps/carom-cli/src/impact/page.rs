//! The report of an impact as a page.

use super::planes::{joint, planes};
use super::text;
use crate::pipeline;
use carom_figure::{
    ImpactFigure, ImpactPicture, ImpactShared, ImpactSketch, ImpactedBody, RollContact, SketchContact,
};
use carom_impact::planar::Touch;
use carom_scene::{EndReport, ImpactAnswer, ImpactAnswerReport, ImpactProblem, Uniqueness};

/// One HTML page; `source` is the file as written.
pub(super) fn page(
    title: &str,
    source: &str,
    problem: &ImpactProblem,
    (answer, report): (&ImpactAnswer, &ImpactAnswerReport),
) -> String {
    let end = text::shown(report);
    let verdict = end.map_or_else(
        || format!("no answer: {}", report.not_staged.clone().unwrap_or_default()),
        |end| text::states(end, report.staged.as_ref()),
    );
    let alone = || planes(problem, answer).into_iter().next().map(|(_, plane)| ImpactPicture::Plane(plane));
    let mut notes = text::not_examined(problem, report);
    if let Some(decided) = &report.decided_by {
        notes.push(format!("Decided by {}.", decided.because));
    }
    for share in report.staged.iter().flat_map(|staged| &staged.open_shares) {
        let (takes, leaves) = (text::share_words(share), text::velocities(&share.end));
        notes.push(format!(
            "Another share of compression, where {takes}, leaves {leaves} (m/s): restitution multiplies the share."
        ));
    }
    let shared = report.sharing.iter().map(|shared| ImpactShared {
        name: shared.sharing.to_string(),
        verdict: shared.verdict.words().to_owned(),
        said: text::said(shared),
    });
    let rejected = report.rejected.iter().map(|r| [r.hypothesis.clone(), r.because.clone()]);
    pipeline::impact_report(&ImpactFigure {
        title: title.to_owned(),
        verdict,
        lead: format!("{} · {}", answer.certainty().words(), text::law(problem, report)),
        notes,
        contacts: end.map_or(vec![], contacts),
        bodies: end.map_or(vec![], bodies),
        energy: end.and_then(|end| Some([end.energy_before?, end.energy_after?])),
        sketch: sketch(problem),
        picture: joint(problem, answer).map(ImpactPicture::Walk).or_else(alone),
        shared: shared.collect(),
        found: report.end_states.iter().map(|end| end.hypothesis.clone()).collect(),
        stages: None,
        rejected: (report.uniqueness == Uniqueness::Examined).then(|| rejected.collect()),
        source: source.to_owned(),
        made_by: concat!("carom ", env!("CARGO_PKG_VERSION")).to_owned(),
    })
}

/// The free body with its contacts; several bodies and an operator have no such picture.
fn sketch(problem: &ImpactProblem) -> Option<ImpactSketch> {
    let body = problem.body.as_ref()?;
    let contact = |(name, touch): (&String, &Touch)| SketchContact {
        name: name.clone(),
        point: [touch.arm.x, touch.arm.y],
        normal: [touch.normal.x, touch.normal.y],
    };
    Some(ImpactSketch {
        velocity: [body.velocity.x, body.velocity.y],
        spin: body.spin,
        contacts: problem.names.iter().zip(&body.touches).map(contact).collect(),
    })
}

fn contacts(end: &EndReport) -> Vec<RollContact> {
    let contact = |c: &carom_scene::EndContactReport| RollContact {
        name: c.name.clone(),
        state: c.state.to_string(),
        impulse: [c.normal_impulse, c.tangential_impulse],
        velocity: [c.normal_velocity_m_s, c.slip_m_s],
    };
    end.contacts.iter().map(contact).collect()
}

fn bodies(end: &EndReport) -> Vec<ImpactedBody> {
    let alone = end.velocity_m_s.zip(end.spin_rad_s);
    let alone = alone.map(|(velocity, spin)| ImpactedBody { name: "body".to_owned(), velocity, spin });
    let several = end.bodies.iter().map(|body| ImpactedBody {
        name: body.name.clone(),
        velocity: body.velocity_m_s,
        spin: body.spin_rad_s,
    });
    alone.into_iter().chain(several).collect()
}
