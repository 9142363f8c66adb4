//! The impulse planes of an answer.

use carom_figure::{ImpulsePlane, ImpulsePoint, JointContact, JointWalk};
use carom_impact::Phase;
use carom_impact::planar::{Slip, StageEnd};
use carom_scene::{ImpactAnswer, ImpactContacts, ImpactProblem};
use carom_words::{Words, impact};

/// The walk of several contacts as one picture; `None` where there is one contact, or no walk.
pub(crate) fn joint(problem: &ImpactProblem, answer: &ImpactAnswer) -> Option<JointWalk> {
    let walk = answer.walk().filter(|walk| !walk.stages.is_empty())?;
    let ImpactContacts::Several(set) = &problem.contacts else { return None };
    let contacts = problem.names.iter().zip(set.friction);
    let contacts: Vec<_> =
        contacts.map(|(name, friction)| JointContact { name: name.clone(), friction }).collect();
    (contacts.len() > 1).then(|| JointWalk::of_stages(contacts, &walk.stages))
}

/// The impulse plane of each contact.
pub(crate) fn planes(problem: &ImpactProblem, answer: &ImpactAnswer) -> Vec<(String, ImpulsePlane)> {
    let Some(walk) = answer.walk().filter(|walk| !walk.stages.is_empty()) else { return vec![] };
    let ImpactContacts::Several(set) = &problem.contacts else { return vec![] };
    let one = |(i, name): (usize, &String)| {
        let points = walk.stages.iter().map(|stage| ImpulsePoint {
            normal: stage.end.impulse[i][1],
            tangential: stage.end.impulse[i][0],
            phase: stage.phase,
            label: label(problem, stage.phase, stage.slip[i], stage.ended_by),
        });
        let block = &set.operator[i][i];
        let plane = ImpulsePlane {
            operator: (set.count == 1).then_some([block.tt, block.tn, block.nn]),
            slip: set.slip[i],
            approach: set.normal[i],
            friction: set.friction[i],
            points: points.collect(),
        };
        (name.clone(), plane)
    };
    problem.names.iter().enumerate().map(one).collect()
}

fn label(problem: &ImpactProblem, phase: Phase, slip: Slip, end: StageEnd) -> String {
    let (slip, end) = (impact::brief_slip(slip), impact::stage_end(&problem.names, end));
    format!("{}: {slip}, until {end}", phase.word())
}
