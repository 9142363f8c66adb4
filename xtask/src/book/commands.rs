//! What the book shows of the program: `book/commands.txt`, read.

/// One transcript: a few commands and what they leave behind.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Transcript {
    pub(crate) name: String,
    pub(crate) steps: Vec<Step>,
}

/// One line of a transcript.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Step {
    /// A command as a reader types it, and whether it must succeed.
    Run { line: String, succeeds: bool },
    /// A drawing that a command wrote: the file, and on a page the label of the drawing.
    Figure { name: String, file: String, label: Option<String> },
    /// A text file that a command wrote, kept under its own name.
    Keep(String),
}

/// Reads the list; every line that is none of these is a problem, named by its number.
pub(crate) fn parse(text: &str) -> Result<Vec<Transcript>, String> {
    let mut transcripts: Vec<Transcript> = vec![];
    let mut problems = vec![];
    for (n, line) in text.lines().map(str::trim).enumerate() {
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            transcripts.push(Transcript { name: name.to_owned(), steps: vec![] });
        } else {
            match (transcripts.last_mut(), step(line)) {
                (Some(transcript), Some(step)) => transcript.steps.push(step),
                _ => problems.push(format!("line {}: {line}", n + 1)),
            }
        }
    }
    problems.extend(twice(&transcripts).map(|name| format!("[{name}] stands twice")));
    if problems.is_empty() { Ok(transcripts) } else { Err(problems.join("\n")) }
}

fn step(line: &str) -> Option<Step> {
    if line.starts_with("carom ") {
        return Some(Step::Run { line: line.to_owned(), succeeds: true });
    }
    if let Some(command) = line.strip_prefix("fails ") {
        let is_ours = command.starts_with("carom ");
        return is_ours.then(|| Step::Run { line: command.to_owned(), succeeds: false });
    }
    if let Some(file) = line.strip_prefix("keep ") {
        return Some(Step::Keep(file.to_owned()));
    }
    let (name, from) = line.strip_prefix("figure ")?.split_once(" < ")?;
    let (file, label) = from.split_once(' ').map_or((from, None), |(file, label)| (file, Some(label)));
    Some(Step::Figure { name: name.to_owned(), file: file.to_owned(), label: label.map(str::to_owned) })
}

fn twice(transcripts: &[Transcript]) -> impl Iterator<Item = &str> {
    let is_repeated = |n: usize| transcripts[..n].iter().any(|before| before.name == transcripts[n].name);
    (0..transcripts.len()).filter(move |&n| is_repeated(n)).map(|n| transcripts[n].name.as_str())
}

/// The words of a command, without its first; double quotes hold words together.
pub(crate) fn words(line: &str) -> Vec<String> {
    let mut words = vec![];
    let (mut word, mut quoted, mut begun) = (String::new(), false, false);
    for c in line.chars() {
        match c {
            '"' => (quoted, begun) = (!quoted, true),
            ' ' if !quoted => {
                if begun {
                    words.push(std::mem::take(&mut word));
                }
                begun = false;
            }
            _ => {
                word.push(c);
                begun = true;
            }
        }
    }
    if begun {
        words.push(word);
    }
    words.into_iter().skip(1).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transcript_has_commands_figures_and_files() {
        let text = "# a comment\n[first]\ncarom new a.toml\nkeep a.toml\n\n[second]\nfails carom run b.toml\n\
                    figure a < out/a/map.svg\nfigure b < out/b/report.html Layout to scale\n";
        let read = parse(text).expect("every line is known");
        let run = |line: &str, succeeds| Step::Run { line: line.to_owned(), succeeds };
        assert_eq!(read[0].name, "first", "the name in brackets");
        assert_eq!(read[0].steps, [run("carom new a.toml", true), Step::Keep("a.toml".to_owned())], "steps");
        assert_eq!(read[1].steps[0], run("carom run b.toml", false), "a command that must fail");
        let label = Some("Layout to scale".to_owned());
        assert_eq!(
            read[1].steps[2],
            Step::Figure { name: "b".to_owned(), file: "out/b/report.html".to_owned(), label },
            "a drawing of a page"
        );
    }

    #[test]
    fn lines_that_say_nothing_are_all_named() {
        let error = parse("carom run a.toml\n[a]\nls\nfails ls\n[a]\n").expect_err("four problems");
        assert_eq!(error.lines().count(), 4, "{error}");
    }

    #[test]
    fn quotes_hold_words_together() {
        let line = "carom map a.toml --x \"plate.1.drop=8..9 mm:4\"  --y=\"\"";
        assert_eq!(words(line), ["map", "a.toml", "--x", "plate.1.drop=8..9 mm:4", "--y="], "words");
    }
}
