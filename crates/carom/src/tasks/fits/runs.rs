//! The runs of a fit: a CSV file of drops that were observed.

use super::over::Over;
use crate::tasks::axes::{Asker, Key, keys, quantity, unknown};
use crate::tasks::records::placed;
use carom_feeder::Outcome;
use carom_scene::unit::Dimension;
use carom_scene::{Drawn, Problem, ProblemKind, Problems, Scene};
use carom_study::Ending;
use carom_study::fits::{Observation, Seen, Timed};
use carom_words::study;
use std::ops::Range;

/// Problems of the runs that are told one by one.
const MOST_TOLD: usize = 50;
/// Most drops that one row tells of.
const MOST_DROPS: u64 = 1_000_000_000;

/// Drops that were observed.
#[derive(Debug)]
pub(super) struct Runs {
    pub(super) file: String,
    pub(super) source: String,
    /// Quantities that rows set, by path.
    pub(super) columns: Vec<String>,
    /// Their values, SI: all that differ.
    pub(super) conditions: Vec<Vec<f64>>,
    pub(super) observations: Vec<Observation>,
    /// Where the row of each observation stands.
    pub(super) places: Vec<Range<usize>>,
}

/// What a column holds.
enum Column {
    Outcome,
    Face,
    Time,
    Scatter,
    Drops,
    Quantity(Key),
}

/// The columns that are no quantities.
const WORDS: [&str; 5] = ["outcome", "face", "time", "scatter", "drops"];

/// Reads and checks a whole file.
struct Reader<'s> {
    scene: &'s Scene,
    /// Faces of the part; none of a disc.
    faces: usize,
    /// Scatter of times that have none of their own [s].
    scatter: Option<f64>,
    asker: Asker,
    problems: Vec<Problem>,
}

/// Reads the runs; `scatter` is that of times that have none of their own.
pub(super) fn read(
    scene: &Scene,
    (file, text): (&str, &str),
    (scatter, asker): (Option<f64>, Asker),
    over: &[Over],
) -> Result<Runs, Problems> {
    let source = text.trim_start_matches('\u{feff}').to_owned();
    let faces = scene.feeder().part.body.shape.rests().len();
    let mut reader = Reader { scene, faces, scatter, asker, problems: vec![] };
    let mut runs = Runs {
        file: file.to_owned(),
        columns: vec![],
        conditions: vec![],
        observations: vec![],
        places: vec![],
        source: source.clone(),
    };
    reader.read(&source, over, &mut runs);
    let mut problems = reader.problems;
    if problems.is_empty() {
        return Ok(runs);
    }
    let more = problems.len().saturating_sub(MOST_TOLD);
    problems.truncate(MOST_TOLD);
    Err(Problems::new(&runs.file, &source, problems).and_more(more))
}

/// Lines with the byte at which each begins, without their ends.
fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut start = 0;
    text.split_inclusive('\n').map(move |line| {
        let at = start;
        start += line.len();
        (at, line.trim_end_matches(['\n', '\r']))
    })
}

impl Reader<'_> {
    fn push(&mut self, kind: ProblemKind, column: &str, message: String, place: Range<usize>) {
        self.problems.push(Problem::new(kind, column, message, Some(place)));
    }

    fn read(&mut self, source: &str, over: &[Over], runs: &mut Runs) {
        let mut lines = lines(source).filter(|(_, line)| !line.trim().is_empty());
        let Some((at, head)) = lines.next() else {
            let message =
                format!("the file is empty: its first line names the columns, {}", WORDS.join(", "));
            self.problems.push(Problem::new(ProblemKind::File, "", message, None));
            return;
        };
        let columns = self.columns(at, head, over);
        if self.problems.is_empty() {
            runs.columns = columns.iter().filter_map(|(_, column)| column.path()).collect();
            for (at, line) in lines {
                self.row((at, line), &columns, runs);
            }
            if runs.observations.is_empty() && self.problems.is_empty() {
                let message = "there are no rows below the names of the columns".to_owned();
                self.push(ProblemKind::File, "", message, at..at + head.len());
            }
        }
    }

    /// The columns that the first line names.
    fn columns(&mut self, at: usize, head: &str, over: &[Over]) -> Vec<(String, Column)> {
        let cells = match placed(head) {
            Ok(cells) => cells,
            Err(message) => {
                self.push(ProblemKind::Syntax, "", message, at..at + head.len());
                return vec![];
            }
        };
        let keys = keys(self.scene, self.asker);
        let mut found: Vec<(String, Column)> = vec![];
        for (name, place) in cells {
            let place = at + place.start..at + place.end;
            let name = self.scene.canonical(&name);
            let column = match name.as_str() {
                "outcome" => Column::Outcome,
                "face" => Column::Face,
                "time" => Column::Time,
                "scatter" => Column::Scatter,
                "drops" => Column::Drops,
                _ => match keys.iter().find(|key| key.name == name) {
                    Some(key) => Column::Quantity(key.clone()),
                    None => {
                        let message = format!("{}; or {}", unknown(&keys, &name), WORDS.join(", "));
                        self.push(ProblemKind::UnknownKey, &name, message, place);
                        continue;
                    }
                },
            };
            if found.iter().any(|(known, _)| *known == name) {
                self.push(ProblemKind::Conflict, &name, "is named twice".to_owned(), place.clone());
            }
            if over.iter().any(|over| over.path == name) {
                let option = self.asker.option("over");
                let message = format!("is fitted ({option}): it cannot be set by rows as well");
                self.push(ProblemKind::Conflict, &name, message, place);
            }
            found.push((name, column));
        }
        let says = |name: &str| found.iter().any(|(known, _)| known == name);
        if self.problems.is_empty() && !["outcome", "face", "time"].iter().any(|name| says(name)) {
            let message = "no column says how drops ended: outcome, face or time".to_owned();
            self.push(ProblemKind::MissingKey, "", message, at..at + head.len());
        }
        if self.problems.is_empty() && says("scatter") && !says("time") {
            let message = "is the scatter of times, but there is no column time".to_owned();
            self.push(ProblemKind::Conflict, "scatter", message, at..at + head.len());
        }
        found
    }

    fn row(&mut self, (at, line): (usize, &str), columns: &[(String, Column)], runs: &mut Runs) {
        let whole = at..at + line.len();
        let cells = match placed(line) {
            Ok(cells) => cells,
            Err(message) => return self.push(ProblemKind::Syntax, "", message, whole),
        };
        if cells.len() != columns.len() {
            let message = format!("{} values for {} columns", cells.len(), columns.len());
            return self.push(ProblemKind::WrongValue, "", message, whole);
        }
        let before = self.problems.len();
        let mut seen = Seen { ending: None, face: None };
        let (mut time, mut scatter, mut count, mut values) = (None, self.scatter, 1, vec![]);
        for ((name, column), (cell, place)) in columns.iter().zip(&cells) {
            // What is blank was not looked at.
            if cell.is_empty() && !matches!(column, Column::Quantity(_)) {
                continue;
            }
            let read = match column {
                Column::Outcome => self.outcome(cell).map(|ending| seen.ending = Some(ending)),
                Column::Face => self.face(cell).map(|face| seen.face = Some(face)),
                Column::Time => seconds(cell).map(|found| time = Some(found)),
                Column::Scatter => seconds(cell).map(|found| scatter = Some(found)),
                Column::Drops => drops(cell).map(|found| count = found),
                Column::Quantity(key) => setting(key, cell).map(|value| values.push(value)),
            };
            if let Err(message) = read {
                let place = at + place.start..at + place.end.max(place.start);
                self.push(ProblemKind::WrongValue, name, format!("\"{cell}\": {message}"), place);
            }
        }
        let nothing = seen == Seen { ending: None, face: None } && time.is_none();
        if nothing && self.problems.len() == before {
            let message = "says neither outcome nor face nor time".to_owned();
            self.push(ProblemKind::MissingKey, "", message, whole.clone());
        }
        if self.problems.len() > before {
            return;
        }
        let known = runs.conditions.iter().position(|condition| *condition == values);
        let condition = known.unwrap_or(runs.conditions.len());
        if known.is_none() {
            runs.conditions.push(values);
        }
        let time = time.map(|time| Timed { time, scatter });
        runs.observations.push(Observation { condition, seen, time, count });
        runs.places.push(whole);
    }

    /// An ending that can be observed of this part.
    fn outcome(&self, cell: &str) -> Result<Ending, String> {
        let words = cell.replace('_', " ").to_lowercase();
        let words = if words == "same" { "same side" } else { &words };
        let possible = |ending: &Ending| match ending {
            Ending::Lies(carom_feeder::Verdict::Face(face)) => *face < self.faces,
            Ending::Lies(_) => self.faces > 0,
            Ending::Stays => self.faces == 0,
            // Those are no ends of a real drop.
            Ending::Otherwise(Outcome::NeverFlat | Outcome::Unresolved | Outcome::Blocked) => false,
            Ending::Otherwise(_) => true,
            Ending::Impossible | Ending::Failed => false,
        };
        study::ending_of(words).filter(possible).ok_or_else(|| {
            let mut all: Vec<String> = study::endings().filter(possible).map(study::ending).collect();
            if self.faces > 0 {
                all.push(format!("face 0 to face {}", self.faces - 1));
            }
            format!("is no end of a drop of this part: it is one of {}", all.join(", "))
        })
    }

    fn face(&self, cell: &str) -> Result<usize, String> {
        let face = cell.parse().ok().filter(|face| *face < self.faces);
        face.ok_or_else(|| match self.faces {
            0 => "the part has no faces: leave the column out".to_owned(),
            faces => format!("must be a whole number from 0 to {}, a face of the part", faces - 1),
        })
    }
}

impl Column {
    fn path(&self) -> Option<String> {
        match self {
            Self::Quantity(key) => Some(key.name.clone()),
            _ => None,
        }
    }
}

fn seconds(cell: &str) -> Result<f64, String> {
    let value = quantity(cell, Dimension::Time)?;
    if value > 0.0 { Ok(value) } else { Err("must be above 0 s".to_owned()) }
}

fn drops(cell: &str) -> Result<u64, String> {
    let count = cell.parse().ok().filter(|count| (1..=MOST_DROPS).contains(count));
    count.ok_or_else(|| format!("must be a whole number of drops from 1 to {MOST_DROPS}"))
}

fn setting(key: &Key, cell: &str) -> Result<f64, String> {
    let value = quantity(cell, key.dimension)?;
    key.outside(value).map_or(Ok(value), Err)
}
