//! `carom-campaign [--share S] [--seed N] [--case N] [--out FILE]`: random cases by the million; 1 is 10⁸ single impacts, 10⁶ at several contacts and 3·10⁵ feeders.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it reports to the person who runs it")]

mod chains;
mod draw;
mod feeders;
mod several;
mod singles;
mod spatial;
mod tally;

use rayon::prelude::*;
use std::process::ExitCode;
use std::time::Instant;
use tally::Tally;

/// What is asked of each kind of case, and how many there are in a whole campaign.
struct Kind {
    title: &'static str,
    cases: f64,
    case: fn(u64, u64, &mut Tally),
}

const KINDS: [Kind; 5] = [
    Kind { title: "Impacts at one contact", cases: 1e8, case: singles::case },
    Kind { title: "Impacts at two to four contacts", cases: 1e6, case: several::case },
    Kind { title: "Feeders", cases: 1e5, case: feeders::case },
    Kind { title: "Feeders of any outline", cases: 1e5, case: feeders::bent_case },
    Kind { title: "Feeders of solid parts", cases: 1e5, case: spatial::case },
];

/// Cases that a thread takes at a time: the tally of each is made once.
const CHUNK: u64 = 256;
/// Parts of a kind after which it is told how far it has come.
const PARTS: u64 = 20;

struct Asked {
    share: f64,
    seed: u64,
    case: Option<u64>,
    out: Option<String>,
}

const USAGE: &str = "usage: cargo xtask campaign [--share S] [--seed N] [--case N] [--out FILE]
  --share S   of 10⁸ impacts at one contact, 10⁶ at several and 3·10⁵ feeders; above 0, at most 1000 [default: 1]
  --seed N    other cases; a whole number from 0 [default: 1]
  --case N    of each kind the case of this number alone, as a page names it
  --out FILE  writes the page into a file as well";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if words.iter().any(|word| word == "--help" || word == "-h") {
        println!("{USAGE}");
        return ExitCode::SUCCESS;
    }
    match asked(&words) {
        Ok(asked) => run(&asked),
        Err(problem) => {
            eprintln!("{problem}\n{USAGE}");
            ExitCode::from(2)
        }
    }
}

fn asked(words: &[String]) -> Result<Asked, String> {
    let mut asked = Asked { share: 1.0, seed: 1, case: None, out: None };
    for pair in words.chunks(2) {
        let [key, value] = pair else { return Err(format!("{} needs a value", pair[0])) };
        let bad = |allowed: &str| format!("{key} {value}: {allowed}");
        match key.as_str() {
            "--share" => {
                let share = value.parse().ok().filter(|s| *s > 0.0 && *s <= 1000.0);
                asked.share = share.ok_or_else(|| bad("a number above 0, at most 1000"))?;
            }
            "--seed" => asked.seed = value.parse().map_err(|_| bad("a whole number from 0"))?,
            "--case" => asked.case = Some(value.parse().map_err(|_| bad("a whole number from 0"))?),
            "--out" => asked.out = Some(value.clone()),
            _ => return Err(format!("not an option: {key}")),
        }
    }
    Ok(asked)
}

fn run(asked: &Asked) -> ExitCode {
    // What a case breaks is named in the tally; the messages of panics would drown it.
    std::panic::set_hook(Box::new(|_| {}));
    let mut page = format!(
        "# A campaign of random cases\n\nMade by `cargo xtask campaign --share {} --seed {}{}`, on {} threads.\n",
        asked.share,
        asked.seed,
        asked.case.map_or_else(String::new, |case| format!(" --case {case}")),
        rayon::current_num_threads()
    );
    let mut sound = true;
    for kind in &KINDS {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most 10¹¹")]
        let all = (kind.cases * asked.share).ceil() as u64;
        let (first, cases) = asked.case.map_or((0, all), |case| (case, 1));
        let (tally, seconds) = campaign(kind, asked.seed, (first, cases));
        sound &= tally.broken.is_empty();
        page += &format!("\n## {}\n\n{cases} cases in {seconds:.0} s.\n\n{}", kind.title, tally.page());
    }
    print!("{page}");
    if let Some(file) = &asked.out
        && let Err(problem) = std::fs::write(file, &page)
    {
        eprintln!("{file}: {problem}");
        return ExitCode::FAILURE;
    }
    if sound { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// So many cases of a kind, from the first one's number on.
fn campaign(kind: &Kind, seed: u64, (first, cases): (u64, u64)) -> (Tally, f64) {
    let started = Instant::now();
    let mut tally = Tally::default();
    for part in 0..PARTS {
        let [from, to] = [part, part + 1].map(|part| first + cases * part / PARTS);
        let chunks = (to - from).div_ceil(CHUNK);
        let own = (0..chunks).into_par_iter().map(|chunk| {
            let mut own = Tally::default();
            for number in from + chunk * CHUNK..(from + (chunk + 1) * CHUNK).min(to) {
                own.guarded(number, |tally| (kind.case)(seed, number, tally));
            }
            own
        });
        tally.take(own.reduce(Tally::default, Tally::merged));
        eprint!("\r{}: {} of {cases}, {:.0} s", kind.title, to - first, started.elapsed().as_secs_f64());
    }
    eprintln!();
    (tally, started.elapsed().as_secs_f64())
}
