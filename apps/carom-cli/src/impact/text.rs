//! The answer to an impact for a person.

use crate::side_by_side::aligned;
use crate::table::fixed;
use carom_impact::planar::MOST_CONTACTS;
use carom_impact::planar::sharing::Sharing;
use carom_scene::{
    EndContactReport, EndReport, EndStateReport, ImpactAnswerReport, ImpactContacts, ImpactProblem,
    SharingReport, StagedReport,
};
use std::fmt::Write as _;

/// Rejected hypotheses shown to a person.
const MOST_REJECTED: usize = 16;
/// Stages shown to a person; of more, the last ones are.
const MOST_STAGES: usize = 20;
const LAST_STAGES: usize = 2;
/// Contacts whose states stand in the headline.
const MOST_IN_HEADLINE: usize = 6;

/// The answer without its pictures.
pub(super) fn text(problem: &ImpactProblem, report: &ImpactAnswerReport) -> String {
    let mut text = headline(problem, report);
    if let Some(end) = shown(report) {
        text.push_str(&end_text(end));
    }
    if report.uniqueness == "not examined" {
        return text + "\n" + &not_examined(problem, report).join("\n") + "\n";
    }
    text.push_str(&how_text(problem, report));
    text.push_str(&sharing_text(report));
    text.push_str("\nend states\n");
    for end in &report.end_states {
        let gained = if end.gained_energy { ", with more energy than before" } else { "" };
        // Writing to a String cannot fail.
        let _ = writeln!(text, "  {:<40} consistent{gained}", end.hypothesis);
    }
    for rejected in report.rejected.iter().take(MOST_REJECTED) {
        let _ = writeln!(text, "  {:<40} {}", rejected.hypothesis, rejected.because);
    }
    if let Some(more) = report.rejected.len().checked_sub(MOST_REJECTED).filter(|more| *more > 0) {
        let _ = writeln!(text, "  … {more} more rejected, all with --format json");
    }
    text
}

/// The one end state that was sought.
fn unexamined(report: &ImpactAnswerReport) -> Option<&EndStateReport> {
    report.end_states.first().filter(|_| report.uniqueness == "not examined")
}

fn headline(problem: &ImpactProblem, report: &ImpactAnswerReport) -> String {
    let (ends, law) = (ends(report), law(problem, report));
    match shown(report) {
        Some(end) => {
            let states = states(end, report.staged.as_ref());
            let (loud, rest) = states.split_once(": ").map_or((&*states, ""), |(loud, rest)| (loud, rest));
            let colon = if rest.is_empty() { "" } else { ": " };
            format!("{}{colon}{rest}   {ends}   {law}\n\n", loud.to_uppercase())
        }
        None => format!("NO ANSWER: {}   {ends}   {law}\n", report.not_staged.clone().unwrap_or_default()),
    }
}

/// Where it ends, if it does.
pub(super) fn shown(report: &ImpactAnswerReport) -> Option<&EndReport> {
    let staged = report.staged.as_ref().map(|staged| &staged.end);
    staged.or(unexamined(report).map(|found| &found.end))
}

/// How many end states there are.
pub(super) fn ends(report: &ImpactAnswerReport) -> String {
    match (report.end_states.len(), report.uniqueness) {
        (0, "not examined") => "no end state was found".to_owned(),
        (_, "not examined") => "one end state, others not searched for".to_owned(),
        (0, _) => "no end state is consistent".to_owned(),
        (1, _) => "one end state".to_owned(),
        (n, _) => format!("{n} end states"),
    }
}

/// The law that was used, and why it is not the one that was asked for.
pub(super) fn law(problem: &ImpactProblem, report: &ImpactAnswerReport) -> String {
    let asked = problem.law.to_string();
    let because = match problem.sharing {
        _ if report.law == asked => String::new(),
        Sharing::ByStiffness { .. } => {
            format!(" ({asked} was asked for: springs give back a share of their work)")
        }
        _ if report.staged.is_none() => format!(" ({asked} was asked for: an end state does not know work)"),
        _ => format!(" ({asked} was asked for: it is for one closing contact)"),
    };
    format!("{} law{because}", report.law)
}

/// What happens, in a few words.
pub(super) fn states(end: &EndReport, staged: Option<&StagedReport>) -> String {
    if end.contacts.iter().all(|c| c.normal_impulse == 0.0) {
        return "nothing happens: no contact approaches".to_owned();
    }
    if let Some((class, kind)) = staged.and_then(|staged| Some((staged.class.as_ref()?, staged.kind?))) {
        return format!("{class}, type {kind}");
    }
    if end.contacts.len() <= MOST_IN_HEADLINE {
        let each = end.contacts.iter().map(|c| format!("{} {}", c.name, c.state));
        return each.collect::<Vec<_>>().join(", ");
    }
    let count = |state: &str| (end.contacts.iter().filter(|c| c.state == state).count(), state.to_owned());
    let counts = ["separates", "sticks", "slips"].map(count);
    let words = counts.iter().filter(|(n, _)| *n > 0).map(|(n, state)| match (n, state.strip_suffix('s')) {
        (1, _) | (_, None) => format!("1 {state}"),
        (n, Some(plural)) => format!("{n} {plural}"),
    });
    let words = words.collect::<Vec<_>>().join(", ");
    format!("of {} contacts {words}", end.contacts.len())
}

/// True where a contact returns something of its impulse.
fn returns(problem: &ImpactProblem) -> bool {
    match &problem.contacts {
        ImpactContacts::Several(set) => set.restitution.iter().any(|e| *e > 0.0),
        ImpactContacts::Many(set) => set.restitution.iter().any(|e| *e > 0.0),
    }
}

/// What was not asked of more contacts than can be enumerated, a sentence each.
pub(super) fn not_examined(problem: &ImpactProblem, report: &ImpactAnswerReport) -> Vec<String> {
    if report.uniqueness != "not examined" {
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
        if end.indeterminate && (report.law == "newton" || !returns(problem)) {
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

/// What decided, and the stages.
fn how_text(problem: &ImpactProblem, report: &ImpactAnswerReport) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    if let Some(decided) = &report.decided_by {
        let _ = writeln!(
            text,
            "\ndecided by  {}\n            P_d = {}   P_q = {}   μ_s = {}",
            decided.because,
            plain(decided.p_d),
            plain(decided.p_q),
            plain(decided.mu_s)
        );
    }
    if let Some(staged) = &report.staged {
        text.push_str(if staged.stages.is_empty() { "\n" } else { "\nstages\n" });
        let count = staged.stages.len();
        let left_out =
            if count > MOST_STAGES { MOST_STAGES - LAST_STAGES..count - LAST_STAGES } else { 0..0 };
        for (k, stage) in staged.stages.iter().enumerate().filter(|(k, _)| !left_out.contains(k)) {
            if k == left_out.end && !left_out.is_empty() {
                let _ = writeln!(text, "  … {} stages, all with --format json", left_out.len());
            }
            let slips = stage.contacts.iter().zip(&problem.names);
            let slips: Vec<String> = slips.map(|(c, name)| format!("{name} {}", c.slip)).collect();
            let _ = writeln!(text, "  {:<12} {}, until {}", stage.phase, slips.join(", "), stage.ended_by);
        }
        if staged.path_dependent {
            text.push_str("  it ends in none of the end states below: the end depends on the way there\n");
        }
        if staged.branches > 1 {
            let _ = writeln!(text, "  up to {} ways on were consistent: one was chosen", staged.branches);
        }
        if staged.gained_energy {
            let _ = writeln!(text, "  {} law created energy", report.law);
        }
    }
    text
}

/// Six decimals, or a power of ten where there would be too many digits before them.
fn plain(number: f64) -> String {
    if number.abs() < 1e9 { format!("{number:.6}") } else { format!("{number:.6e}") }
}

/// What other conventions on sharing say, where several contacts act.
fn sharing_text(report: &ImpactAnswerReport) -> String {
    let mut text = String::new();
    if report.sharing.is_empty() {
        return text;
    }
    let all_agree = report.sharing.iter().all(|shared| shared.agrees);
    let verdict = if all_agree { "all conventions agree" } else { "the conventions disagree" };
    let _ = writeln!(text, "\nsharing     {verdict}");
    for shared in &report.sharing {
        let said = said(shared);
        let word = if shared.agrees { "agrees" } else { "differs" };
        let _ = writeln!(text, "  {:<13} {word:<8} {said}", shared.sharing);
    }
    text
}

/// Where a convention ends, or why it does not.
pub(super) fn said(shared: &SharingReport) -> String {
    match (&shared.end, &shared.because) {
        (Some(end), _) => {
            let contact = |c: &EndContactReport| {
                format!("{} u_n {} slip {}", c.name, six(c.normal_velocity_m_s), six(c.slip_m_s))
            };
            end.contacts.iter().map(contact).collect::<Vec<_>>().join("   ")
        }
        (None, because) => because.clone().unwrap_or_default(),
    }
}

fn end_text(end: &EndReport) -> String {
    let head = ["contact", "", "p_n N s", "p_t N s", "u_n m/s", "slip m/s"].map(str::to_owned).to_vec();
    let mut rows = vec![head];
    rows.extend(end.contacts.iter().map(|c| {
        let numbers = [c.normal_impulse, c.tangential_impulse, c.normal_velocity_m_s, c.slip_m_s];
        let mut row = vec![c.name.clone(), c.state.clone()];
        row.extend(numbers.map(|number| fixed(number, 6)));
        row
    }));
    let mut text = aligned(&rows);
    if let (Some([vx, vy]), Some(spin)) = (end.velocity_m_s, end.spin_rad_s) {
        let _ = writeln!(text, "\nbody        velocity {vx:.6}, {vy:.6} m/s   spin {spin:.6} 1/s");
    }
    if !end.bodies.is_empty() {
        text.push('\n');
    }
    for body in &end.bodies {
        let ([vx, vy], spin) = (body.velocity_m_s, body.spin_rad_s);
        let _ = writeln!(text, "{:<11} velocity {vx:.6}, {vy:.6} m/s   spin {spin:.6} 1/s", body.name);
    }
    if let (Some(before), Some(after)) = (end.energy_before, end.energy_after) {
        let _ = writeln!(text, "energy      {before:.6} → {after:.6} J");
    }
    text
}

/// Six decimals, and no minus before zero.
fn six(value: f64) -> String {
    let text = format!("{value:.6}");
    let zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    if zero { text.trim_start_matches('-').to_owned() } else { text }
}
