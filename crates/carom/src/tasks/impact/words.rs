//! What is said of an impact, in words that the text, the page and the studio share.

use carom_impact::Law;
use carom_impact::planar::MOST_CONTACTS;
use carom_impact::planar::sharing::Sharing;
use carom_scene::{
    Certainty, Convention, EndContactReport, EndReport, EndStateReport, ForceAnswerReport,
    ImpactAnswerReport, ImpactContacts, ImpactProblem, OpenShareReport, ShareTaken, SharingReport,
    StagedReport, Uniqueness,
};
use carom_words::Words;
use carom_words::number::ascii;

/// Contacts whose states stand in the headline.
const MOST_IN_HEADLINE: usize = 6;

/// How closing contacts are asked to share.
pub(super) fn convention(problem: &ImpactProblem) -> Convention {
    match problem.sharing {
        Sharing::Together => Convention::Together,
        Sharing::InSequence => Convention::InSequence,
        Sharing::ByStiffness { .. } => Convention::ByStiffness,
    }
}

/// The one end state that was sought.
fn unexamined(report: &ImpactAnswerReport) -> Option<&EndStateReport> {
    report.end_states.first().filter(|_| report.uniqueness == Uniqueness::NotExamined)
}

/// Where it ends, if it does.
pub fn shown(report: &ImpactAnswerReport) -> Option<&EndReport> {
    let staged = report.staged.as_ref().map(|staged| &staged.end);
    staged.or(unexamined(report).map(|found| &found.end))
}

/// The law that was used, and why it is not the one that was asked for.
pub fn law(problem: &ImpactProblem, report: &ImpactAnswerReport) -> String {
    let asked = problem.law.word();
    let because = match problem.sharing {
        _ if report.law.0 == problem.law => String::new(),
        Sharing::ByStiffness { .. } => {
            format!(" ({asked} was asked for: springs give back a share of their work)")
        }
        _ if report.staged.is_none() => format!(" ({asked} was asked for: an end state does not know work)"),
        _ => format!(" ({asked} was asked for: it is for one closing contact)"),
    };
    format!("{} law{because}", report.law)
}

/// What happens, in a few words.
pub fn states(end: &EndReport, staged: Option<&StagedReport>) -> String {
    if end.contacts.iter().all(|c| c.normal_impulse == 0.0) {
        return "nothing happens: no contact approaches".to_owned();
    }
    let forced = staged.is_some_and(|staged| staged.without_approach);
    let forced = if forced { ": no contact approaches, friction forces the impact" } else { "" };
    if let Some((class, kind)) = staged.and_then(|staged| Some((staged.class.as_ref()?, staged.kind?))) {
        return format!("{class}, type {kind}{forced}");
    }
    if end.contacts.len() <= MOST_IN_HEADLINE {
        let each = end.contacts.iter().map(|c| format!("{} {}", c.name, c.state));
        return each.collect::<Vec<_>>().join(", ") + forced;
    }
    let count =
        |state: &str| (end.contacts.iter().filter(|c| c.state.as_str() == state).count(), state.to_owned());
    let counts = ["separates", "sticks", "slips"].map(count);
    let words = counts.iter().filter(|(n, _)| *n > 0).map(|(n, state)| match (n, state.strip_suffix('s')) {
        (1, _) | (_, None) => format!("1 {state}"),
        (n, Some(plural)) => format!("{n} {plural}"),
    });
    let words = words.collect::<Vec<_>>().join(", ");
    format!("of {} contacts {words}{forced}", end.contacts.len())
}

/// True where a contact returns something of its impulse.
fn returns(problem: &ImpactProblem) -> bool {
    match &problem.contacts {
        ImpactContacts::Several(set) => set.restitution.iter().any(|e| *e > 0.0),
        ImpactContacts::Many(set) => set.restitution.iter().any(|e| *e > 0.0),
    }
}

/// What was not asked of more contacts than can be enumerated, a sentence each.
pub fn not_examined(problem: &ImpactProblem, report: &ImpactAnswerReport) -> Vec<String> {
    if report.uniqueness == Uniqueness::Examined {
        return vec![];
    }
    let (count, limit) = (problem.contacts.count(), MOST_CONTACTS);
    let mut said = vec![
        format!(
            "With {count} contacts one end state is sought, by pivoting. Whether there are others was not examined: this may be one of several."
        ),
        format!(
            "Stages, every end state, and what other conventions on sharing say are for up to {limit} contacts."
        ),
    ];
    for end in &report.end_states {
        if end.indeterminate && (report.law.0 == Law::Newton || !returns(problem)) {
            said.push("The impulses are one choice of many that give this motion.".to_owned());
        } else if end.indeterminate {
            said.push(
                "The impulses of compression are one choice of many, and restitution multiplies that choice: another may leave another motion."
                    .to_owned(),
            );
        }
        if end.gained_energy {
            said.push(format!("Restitution created energy: {} law at these contacts.", report.law));
        }
    }
    said
}

/// Where a convention ends, or why it does not.
pub fn said(shared: &SharingReport) -> String {
    match (&shared.end, &shared.because) {
        (Some(end), _) => velocities(end),
        (None, because) => because.clone().unwrap_or_default(),
    }
}

/// The velocities of all contacts.
pub fn velocities(end: &EndReport) -> String {
    let contact = |c: &EndContactReport| {
        format!("{} u_n {} slip {}", c.name, ascii(c.normal_velocity_m_s, 6), ascii(c.slip_m_s, 6))
    };
    end.contacts.iter().map(contact).collect::<Vec<_>>().join("   ")
}

/// Which share a contact takes: "A takes the least".
pub fn share_words(share: &OpenShareReport) -> String {
    let takes = match share.takes {
        ShareTaken::Least => "the least",
        ShareTaken::Middle => "the middle",
        ShareTaken::Most => "the most",
    };
    format!("{} takes {takes}", share.contact)
}

/// What follows under forces, in a few words.
pub fn forces_headline(report: &ForceAnswerReport, certainty: &Certainty) -> String {
    match (report.count, report.uniqueness) {
        (0, Uniqueness::Examined) => {
            "NO MOTION IS CONSISTENT: Painlevé's paradox; an impact without approach may follow".to_owned()
        }
        (0, Uniqueness::NotExamined) => "NO MOTION WAS FOUND".to_owned(),
        (1, _) => {
            let others = if certainty.examined {
                "the only consistent motion"
            } else {
                "one motion, others not searched for"
            };
            let motion = report.solutions.first().map_or("", |motion| motion.hypothesis.as_str());
            format!("{}   {others}", motion.to_uppercase())
        }
        (n, _) => format!("{n} MOTIONS ARE CONSISTENT: the laws leave open which of them follows"),
    }
}
