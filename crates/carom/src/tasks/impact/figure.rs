//! What the report of an impact shows.

use super::{ImpactStudy, words};
use crate::tasks::MADE_BY;
use carom_figure::{
    ImpactFigure, ImpactShared, ImpactSketch, ImpactedBody, RollContact, SketchBody, SketchContact,
};
use carom_impact::planar::Touch;
use carom_impact::planar::{Meeting, RigidBody};
use carom_num::Vec2;
use carom_scene::{EndReport, ImpactProblem, Uniqueness};

/// Everything that the report of an impact shows; `source` is the file as written.
pub(super) fn figure(study: &ImpactStudy, title: &str, source: &str) -> ImpactFigure {
    let ImpactStudy { problem, answer, report } = study;
    let end = words::shown(report);
    let verdict = end.map_or_else(
        || format!("no answer: {}", report.not_staged.clone().unwrap_or_default()),
        |end| words::states(end, report.staged.as_ref()),
    );
    let mut notes = words::not_examined(problem, report);
    if let Some(decided) = &report.decided_by {
        notes.push(format!("Decided by {}.", decided.because));
    }
    for share in report.staged.iter().flat_map(|staged| &staged.open_shares) {
        let (takes, leaves) = (words::share_words(share), words::velocities(&share.end));
        notes.push(format!(
            "Another share of compression, where {takes}, leaves {leaves} (m/s): restitution multiplies the share."
        ));
    }
    let shared = report.sharing.iter().map(|shared| ImpactShared {
        name: shared.sharing.to_string(),
        verdict: shared.verdict.words().to_owned(),
        said: words::said(shared),
    });
    let rejected = report.rejected.iter().map(|r| [r.hypothesis.clone(), r.because.clone()]);
    ImpactFigure {
        title: title.to_owned(),
        verdict,
        lead: format!("{} · {}", answer.certainty().words(), words::law(problem, report)),
        notes,
        contacts: end.map_or(vec![], contacts),
        bodies: end.map_or(vec![], bodies),
        energy: end.and_then(|end| Some([end.energy_before?, end.energy_after?])),
        sketch: sketch(problem),
        picture: study.picture(),
        shared: shared.collect(),
        found: report.end_states.iter().map(|end| end.hypothesis.clone()).collect(),
        stages: None,
        rejected: (report.uniqueness == Uniqueness::Examined).then(|| rejected.collect()),
        left_out: report.rejected_left_out,
        source: source.to_owned(),
        made_by: MADE_BY.to_owned(),
    }
}

/// The bodies with their contacts; an operator has no such picture.
pub(super) fn sketch(problem: &ImpactProblem) -> Option<ImpactSketch> {
    let pair = |v: Vec2| [v.x, v.y];
    let names = problem.names.iter();
    if let Some(body) = &problem.body {
        let contact = |(name, touch): (&String, &Touch)| SketchContact {
            name: name.clone(),
            point: pair(touch.arm),
            normal: pair(touch.normal),
            bodies: vec![0],
        };
        let alone = SketchBody {
            name: String::new(),
            centre: [0.0; 2],
            velocity: pair(body.velocity),
            spin: body.spin,
        };
        return Some(ImpactSketch {
            bodies: vec![alone],
            contacts: names.zip(&body.touches).map(contact).collect(),
        });
    }
    let group = problem.group.as_ref()?;
    let body = |(name, body): (&String, &RigidBody)| SketchBody {
        name: name.clone(),
        centre: pair(body.centre),
        velocity: pair(body.velocity),
        spin: body.spin,
    };
    let contact = |(name, meeting): (&String, &Meeting)| SketchContact {
        name: name.clone(),
        point: pair(meeting.point),
        normal: pair(meeting.normal),
        bodies: vec![meeting.into, meeting.out_of],
    };
    Some(ImpactSketch {
        bodies: group.names.iter().zip(&group.bodies).map(body).collect(),
        contacts: names.zip(&group.meetings).map(contact).collect(),
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
