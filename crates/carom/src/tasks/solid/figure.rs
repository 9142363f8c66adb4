//! What the report of a body in space shows.

use super::{SolidStudy, words};
use crate::tasks::MADE_BY;
use carom_figure::{
    SolidContact, SolidDrawing, SolidFigure, SolidFork, SolidInstant, SolidSeries, SolidStage, SolidState,
    SolidStrike,
};
use carom_impact::spatial::Freedom;
use carom_motion::spatial::{Mode, State};
use carom_scene::{
    SpatialContactReport, SpatialForkReport, SpatialRollProblem, SpatialRollRun, SpatialStrikeReport,
};

pub(super) fn shown<T>(study: &SolidStudy, title: &str, show: impl FnOnce(&SolidFigure<'_>) -> T) -> T {
    let SolidStudy { problem, run, report } = study;
    let instants: Vec<SolidInstant> = instants(problem, run);
    let strikes: Vec<SolidStrike> = report.strikes.iter().map(strike).collect();
    let stages: Vec<SolidStage> = report
        .stages
        .iter()
        .map(|s| SolidStage { name: s.name.as_str(), on: s.held.join(", "), start: s.start_s, end: s.end_s })
        .collect();
    let series: Vec<SolidSeries> = report
        .accumulations
        .iter()
        .map(|s| SolidSeries {
            from: s.from_s,
            to: s.to_s,
            period: s.period,
            ratio: s.ratio,
            kept: s.kept.join(", "),
        })
        .collect();
    let about = report.body.as_ref().map_or(vec![], words::about);
    show(&SolidFigure {
        title,
        verdict: &words::headline(report),
        lead: &[words::lead(report), vec![report.end.words.clone()]].concat().join(" · "),
        notes: &notes(problem, &about),
        drawing: drawing(problem),
        around: &[],
        instants: &instants,
        stages: &stages,
        strikes: &strikes,
        series: &series,
        source: &problem.source,
        made_by: MADE_BY,
    })
}

/// The body as it is drawn.
pub fn drawing(problem: &SpatialRollProblem) -> SolidDrawing<'_> {
    SolidDrawing {
        corners: &problem.drawing.corners,
        faces: &problem.drawing.faces,
        numbers: None,
        seams: &[],
        lines: &problem.drawing.lines,
        points: problem.world.body().supports(),
        names: &problem.points,
    }
}

/// Sentences on the law and the body.
pub fn notes(problem: &SpatialRollProblem, about: &[String]) -> Vec<String> {
    let mut notes = vec![
        if problem.world.friction().is_some() {
            problem.law_in_words()
        } else {
            "The non-sliding law: a contact that keeps comes to rest, whatever friction that takes; the others take no impulse. Strikes are plastic.".to_owned()
        },
        "Spins are in body axes, velocities and impulses in world axes; tilt is the angle from flat of the face that is nearest to the plane.".to_owned(),
    ];
    notes.extend(about.iter().cloned());
    notes
}

fn instants(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Vec<SolidInstant> {
    let of = |time: f64, held: Vec<usize>, state: &State| SolidInstant {
        time,
        centre: state.centre,
        attitude: state.attitude,
        tilt: problem.tilt(state),
        held,
        places: vec![],
    };
    let held = |mode: &Mode| mode.held(&problem.world).iter().collect();
    if run.instants.is_empty() {
        return vec![of(0.0, vec![], &run.last)];
    }
    run.instants.iter().map(|(time, mode, state)| of(*time, held(mode), state)).collect()
}

fn strike(strike: &SpatialStrikeReport) -> SolidStrike {
    let contact = |c: &SpatialContactReport| SolidContact {
        name: c.name.clone(),
        strikes: c.strikes,
        state: c.state.to_string(),
        impulse: [c.normal_impulse, c.tangential_impulse],
        velocity: c.velocity_m_s,
    };
    let fork = |fork: &SpatialForkReport| SolidFork {
        when: format!("stage {}, {}", fork.stage, fork.phase),
        followed: fork.followed.clone(),
        others: fork.others.clone(),
    };
    let states = strike.end_states.iter().map(|end| SolidState {
        hypothesis: end.hypothesis.clone(),
        friction: end.friction_demand,
        friction_is_bound: end.friction_is_bound,
        followed: end.followed,
    });
    SolidStrike {
        time: strike.t_s,
        state: strike.state.clone(),
        outcome: strike.outcome.to_string(),
        struck: strike.struck.join(", "),
        places: vec![],
        tilt: strike.tilt_rad,
        spin: [strike.spin_before_rad_s, strike.spin_rad_s.unwrap_or([f64::NAN; 3])],
        energy: [strike.energy_before, strike.energy_after.unwrap_or(f64::NAN)],
        friction: strike.friction_demand,
        friction_is_bound: strike.friction_is_bound,
        contacts: strike.contacts.iter().map(contact).collect(),
        found: states.collect(),
        rejected: strike.rejected.iter().map(|r| [r.hypothesis.clone(), r.because.clone()]).collect(),
        left_out: strike.rejected_left_out,
        shared: strike.open.0 == Freedom::Motion,
        forks: strike.forks.iter().map(fork).collect(),
        closed_form: strike.closed_form.as_ref().map(|form| {
            let verdict = if form.agrees { "agrees" } else { "differs" };
            [
                form.case.clone(),
                form.words.clone(),
                format!("{verdict}: spins to {:.1e}", form.spin_difference),
            ]
        }),
    }
}
