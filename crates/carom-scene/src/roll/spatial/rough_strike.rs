//! A strike with friction: what its contacts do before it, and what else the law would have allowed on the way through it.

use super::SpatialRollProblem;
use super::states::States;
use super::strike_report::SpatialForkReport;
use crate::word::Word;
use carom_impact::spatial::{Conclusion, ContactSet, MOST_EXAMINED, Solution, staged};
use carom_motion::spatial::{Friction, State, Supports, frictional_contacts};
use carom_words::impact_space;

type Contacts = ContactSet<MOST_EXAMINED>;
type Way = Solution<MOST_EXAMINED>;

/// A strike that finds the body in this state, where these points touch and those of them are held; `None` where the law cannot be asked.
pub(super) fn states(
    problem: &SpatialRollProblem,
    before: &State,
    [touching, held]: [Supports; 2],
    conclusion: Conclusion,
) -> Option<States> {
    let set: Contacts = frictional_contacts(&problem.world, before, touching, held).ok()?;
    let velocities = (0..set.count).map(|k| set.frame[k].transposed() * set.velocity[k]);
    let names = problem.names_of(touching);
    Some(States {
        touching,
        conclusion,
        before: velocities.collect(),
        consistent: vec![],
        rejected: vec![],
        left_out: 0,
        forks: if conclusion == Conclusion::Several { forks(problem, &set, &names) } else { vec![] },
    })
}

/// The stages of the walk at whose start several ways on are consistent.
fn forks(problem: &SpatialRollProblem, set: &Contacts, names: &[String]) -> Vec<SpatialForkReport> {
    let law = problem.world.friction().map_or_else(Default::default, Friction::law);
    let mut stages = vec![];
    let preference = problem.choice.preference();
    // A walk that is given up has been told as far as it goes.
    let _ = staged::resolve_observed(set, law, preference, &mut |stage| stages.push(*stage));
    let told = stages.iter().enumerate().filter_map(|(i, stage)| fork(set, names, i, stage));
    told.collect()
}

fn fork(
    set: &Contacts,
    names: &[String],
    i: usize,
    stage: &staged::Stage<MOST_EXAMINED>,
) -> Option<SpatialForkReport> {
    let answer = stage.question(set).solve();
    let does = |s: &Way| s.guess.map(|g| g.mode);
    let (followed, others): (Vec<_>, Vec<_>) = answer.iter().partition(|s| does(s) == stage.mode);
    let modes = |s: &&Way| s.guess[..names.len()].iter().map(|guess| Word(guess.mode)).collect();
    let words = |s: &&Way| impact_space::hypothesis(names, &s.guess);
    (answer.count > 1).then(|| SpatialForkReport {
        stage: i + 1,
        phase: Word(stage.phase),
        followed: followed.first().map(words),
        others: others.iter().map(words).collect(),
        ways: followed.iter().chain(&others).map(modes).collect(),
    })
}
