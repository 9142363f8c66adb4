//! The answer to an impact for a person.

use crate::table::fixed;
use carom::tasks::impact::words::{law, not_examined, said, share_words, shown, states, velocities};
use carom_scene::{
    Certainty, EndReport, ImpactAnswerReport, ImpactProblem, SharingVerdict, Uniqueness, sharing_words,
};
use carom_words::aligned;
use std::fmt::Write as _;

/// Rejected hypotheses shown to a person.
const MOST_REJECTED: usize = 16;
/// Characters of a hypothesis, at least.
pub(crate) const HYPOTHESIS: usize = 40;
/// Stages shown to a person; of more, the last ones are.
const MOST_STAGES: usize = 20;
const LAST_STAGES: usize = 2;

/// The answer without its pictures.
pub(super) fn text(problem: &ImpactProblem, report: &ImpactAnswerReport, certainty: &Certainty) -> String {
    let mut text = headline(problem, report, certainty);
    if let Some(end) = shown(report) {
        text.push_str(&end_text(end));
    }
    if report.uniqueness == Uniqueness::NotExamined {
        return text + "\n" + &not_examined(problem, report).join("\n") + "\n";
    }
    text.push_str(&how_text(problem, report));
    text.push_str(&sharing_text(report));
    text.push_str("\nend states\n");
    let consistent = report.end_states.iter().map(|end| {
        let gained = if end.gained_energy { ", with more energy than before" } else { "" };
        [end.hypothesis.clone(), format!("consistent{gained}")]
    });
    let rejected = report.rejected.iter().map(|r| [&r.hypothesis, &r.because]);
    text + &hypotheses_text(consistent.collect(), rejected, report.rejected_left_out)
}

/// Hypotheses that are consistent and what is said of them, then those that are rejected, a line each; of many the first. `left_out`
/// counts those that JSON leaves out too.
pub(crate) fn hypotheses_text<'a>(
    mut rows: Vec<[String; 2]>,
    rejected: impl ExactSizeIterator<Item = [&'a String; 2]>,
    left_out: usize,
) -> String {
    let in_json = rejected.len().saturating_sub(MOST_REJECTED);
    rows.extend(rejected.take(MOST_REJECTED).map(|one| one.map(Clone::clone)));
    let mut text = in_two_columns(&rows, HYPOTHESIS);
    // Writing to a String cannot fail.
    let _ = match (in_json + left_out, left_out) {
        (0, _) => Ok(()),
        (more, 0) => writeln!(text, "  … {more} more rejected, all with --format json"),
        (more, _) => writeln!(text, "  … {more} more rejected, {in_json} of them with --format json"),
    };
    text
}

/// Rows of two cells, the second ones below each other, beyond so many characters at least.
pub(crate) fn in_two_columns(rows: &[[String; 2]], least: usize) -> String {
    let width = rows.iter().map(|[first, _]| first.chars().count()).fold(least, usize::max);
    rows.iter().map(|[first, second]| format!("  {first:<width$} {second}\n")).collect()
}

fn headline(problem: &ImpactProblem, report: &ImpactAnswerReport, certainty: &Certainty) -> String {
    let (ends, law) = (certainty.words(), law(problem, report));
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
        if staged.gained_energy {
            let _ = writeln!(text, "  {} law created energy", report.law);
        }
        for (i, share) in staged.open_shares.iter().enumerate() {
            let title =
                if i == 0 { "\nother shares of compression, which restitution multiplies\n" } else { "" };
            let _ = writeln!(text, "{title}  {:<24} {}", share_words(share), velocities(&share.end));
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
    let verdicts: Vec<SharingVerdict> = report.sharing.iter().map(|shared| shared.verdict).collect();
    let _ = writeln!(text, "\nsharing     {}", sharing_words(&verdicts));
    for shared in &report.sharing {
        let _ = writeln!(text, "  {:<13} {:<15} {}", shared.sharing, shared.verdict.words(), said(shared));
    }
    text
}

fn end_text(end: &EndReport) -> String {
    let head = ["contact", "", "p_n N s", "p_t N s", "u_n m/s", "slip m/s"].map(str::to_owned).to_vec();
    let mut rows = vec![head];
    rows.extend(end.contacts.iter().map(|c| {
        let numbers = [c.normal_impulse, c.tangential_impulse, c.normal_velocity_m_s, c.slip_m_s];
        let mut row = vec![c.name.clone(), c.state.to_string()];
        row.extend(numbers.map(|number| fixed(number, 6)));
        row
    }));
    let mut text = aligned(&rows);
    if let (Some([vx, vy]), Some(spin)) = (end.velocity_m_s, end.spin_rad_s) {
        let _ =
            writeln!(text, "\nbody        velocity {}, {} m/s   spin {} 1/s", six(vx), six(vy), six(spin));
    }
    if !end.bodies.is_empty() {
        text.push('\n');
    }
    for body in &end.bodies {
        let ([vx, vy], spin) = (body.velocity_m_s, body.spin_rad_s);
        let _ = writeln!(
            text,
            "{:<11} velocity {}, {} m/s   spin {} 1/s",
            body.name,
            six(vx),
            six(vy),
            six(spin)
        );
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

#[cfg(test)]
mod tests {
    use super::in_two_columns;

    #[test]
    fn what_is_said_of_hypotheses_stands_in_one_column() {
        let rows = ["A sticks", "A separates (slips+), B separates (sticks)", "Å öffnet"]
            .map(|first| [first, "because"]);
        let rows = rows.map(|row| row.map(str::to_owned));
        let text = in_two_columns(&rows, 12);
        let columns: Vec<Option<usize>> =
            text.lines().map(|line| line.find("because").map(|at| line[..at].chars().count())).collect();
        assert_eq!(columns, [Some(45); 3], "{text}");
    }
}
