//! `carom cases` and `carom judge`: the referee of engines.

use crate::args::{Format, Output, is_stdin};
use crate::failure::Failure;
use crate::files;
use crate::printed::tell;
use carom_referee::{
    Case, JudgeReport, cases as known_cases, judge as judged, of_group, read_answers, read_cases, twice,
};
use carom_words::aligned;
use clap::Args;
use std::collections::BTreeMap;
use std::io::{Read, Write};
use std::path::PathBuf;

/// What is read of stdin at most [bytes]: as of a file.
const MOST_BYTES: u64 = 64 << 20;

/// What answers look like, for those who have none yet.
pub(crate) const JUDGE_HELP: &str = "\
An answer is one JSON object a line, of one engine or of several:

  {\"case\": \"ball/001\", \"engine\": \"mine 1.0\", \"velocity_m_s\": [0.31, 0], \"spin_rad_s\": -4.2}
  {\"case\": \"two-discs/001\", \"bodies\": [{\"velocity_m_s\": [..], \"spin_rad_s\": ..}, ..]}
  {\"case\": \"drop/001\", \"verdict\": \"turned\"}              # or same, or none: no rest was found
  {\"case\": \"ball/002\", \"refused\": \"no restitution\"}

The cases are those of `carom cases --format json`. `carom impact -` answers them as well: what it does is what it is judged by.";

#[derive(Args, Debug)]
pub(crate) struct CasesOptions {
    /// Only the group of this name, or those that have it in theirs.
    #[arg(long, value_name = "TEXT")]
    pub(crate) group: Option<String>,
}

#[derive(Args, Debug)]
pub(crate) struct JudgeOptions {
    /// Files of answers, one JSON object a line; or - for stdin.
    #[arg(required = true, value_name = "ANSWERS")]
    pub(crate) answers: Vec<PathBuf>,
    /// Judge by these cases, one JSON object a line, and not by those of `carom cases`.
    #[arg(long, value_name = "FILE")]
    pub(crate) cases: Option<PathBuf>,
    /// How far an answer may be off and still agree, as a share of the motion before: 0.001 [default: the tolerance of each case].
    #[arg(long, value_name = "SHARE", value_parser = share)]
    pub(crate) within: Option<f64>,
    /// Print every case that has an answer.
    #[arg(long)]
    pub(crate) all: bool,
}

/// A share that an answer may be off.
fn share(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|share: &f64| (0.0..=1.0).contains(share));
    number.ok_or_else(|| "a number from 0 to 1 is asked".to_owned())
}

/// Prints the cases: a table of their groups for a person, one case a line for a program.
pub(crate) fn cases(options: &CasesOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let cases = of_group(known_cases(), options.group.as_deref());
    if cases.is_empty() {
        let part = options.group.as_deref().unwrap_or_default();
        return Err(Failure::Usage(format!(
            "no group of cases has {part:?} in its name: `carom cases` lists them"
        )));
    }
    let mut lines = String::new();
    for case in &cases {
        lines.push_str(&serde_json::to_string(case)?);
        lines.push('\n');
    }
    match output.format {
        Format::Text => out.write_all(groups(&cases).as_bytes())?,
        Format::Json => out.write_all(lines.as_bytes())?,
    }
    if let Some(folder) = &output.out {
        let path = files::write(folder, "cases.jsonl", &lines)?;
        tell(&format!("cases {}", path.display()));
    }
    Ok(())
}

fn groups(cases: &[Case]) -> String {
    let mut rows: Vec<(&str, [usize; 3])> = vec![];
    let mut places = BTreeMap::new();
    for case in cases {
        let place = *places.entry(case.group.as_str()).or_insert_with(|| {
            rows.push((&case.group, [0; 3]));
            rows.len() - 1
        });
        let counts = &mut rows[place].1;
        counts[0] += 1;
        counts[1] += usize::from(case.expected.answers.len() > 1);
        counts[2] += usize::from(!case.expected.others.is_empty());
    }
    let head =
        ["group", "cases", "several answers", "laws or conventions differ"].map(str::to_owned).to_vec();
    let row = |(group, counts): &(&str, [usize; 3])| {
        std::iter::once((*group).to_owned()).chain(counts.map(|count| count.to_string())).collect()
    };
    let table: Vec<Vec<String>> = std::iter::once(head).chain(rows.iter().map(row)).collect();
    format!("{}\n{} cases; one a line with --format json\n", aligned(&table), cases.len())
}

/// Judges answers.
pub(crate) fn judge(options: &JudgeOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let cases = match &options.cases {
        None => known_cases(),
        Some(path) => read_cases(&path.display().to_string(), &files::read_input(path)?)?,
    };
    let (mut answers, mut wrong) = (vec![], vec![]);
    for path in &options.answers {
        let (name, text) = if is_stdin(path) {
            ("stdin".to_owned(), std::io::read_to_string(std::io::stdin().lock().take(MOST_BYTES)))
        } else {
            (path.display().to_string(), Ok(files::read_input(path)?))
        };
        let text = text.map_err(|error| Failure::file("read", path, &error))?;
        // Every file's problems are told at once.
        match read_answers(&name, &text, &cases) {
            Ok(read) => answers.extend(read),
            Err(problems) => wrong.push(problems),
        }
    }
    if !wrong.is_empty() {
        return Err(Failure::Input(wrong));
    }
    if let Some(problem) = twice(&answers) {
        return Err(Failure::Usage(problem));
    }
    if answers.is_empty() {
        return Err(Failure::Usage("there is no answer to judge".to_owned()));
    }
    let report = judged(&cases, &answers, options.within);
    let json = format!("{}\n", serde_json::to_string_pretty(&report)?);
    match output.format {
        Format::Text => {
            if options.all {
                out.write_all(every(&report).as_bytes())?;
            }
            out.write_all(report.text().as_bytes())?;
        }
        Format::Json => out.write_all(json.as_bytes())?,
    }
    if let Some(folder) = &output.out {
        let path = files::write(folder, "judge.json", &json)?;
        tell(&format!("judged {}", path.display()));
    }
    Ok(())
}

/// Every case that has an answer, worst last.
fn every(report: &JudgeReport) -> String {
    let head = ["engine", "case", "verdict", "follows", "difference"].map(str::to_owned).to_vec();
    let mut rows = vec![head];
    for engine in &report.engines {
        let mut judged: Vec<_> = engine.judged.iter().filter(|one| one.verdict.answered()).collect();
        judged.sort_by(|a, b| a.difference.unwrap_or(0.0).total_cmp(&b.difference.unwrap_or(0.0)));
        rows.extend(judged.into_iter().map(|one| {
            let difference = one.difference.map_or("-".to_owned(), |share| format!("{share:.1e}"));
            let follows = one.nearest.clone().unwrap_or("-".to_owned());
            vec![engine.engine.clone(), one.case.clone(), one.verdict.word().to_owned(), follows, difference]
        }));
    }
    format!("{}\n", aligned(&rows))
}
