//! The project's chores: `cargo xtask check` is what continuous integration runs.
#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a chore reports to the person who runs it")]

mod arrows;
mod book;
mod c;
mod coverage;
mod digest;
mod docs;
mod examples;
mod fuzz;
mod house;
mod licences;
mod links;
mod markup;
mod metadata;
mod paths;
mod python;
mod rooms;
mod rules;
mod source;
mod steps;
mod studio;
mod tree;
mod wasm;

use std::process::ExitCode;
use steps::Step;

const HELP: &str = "\
cargo xtask COMMAND

  check                     every step below, one line each; exits 1 where one fails
  check --without STEP...   the same without the steps named
  arrows                    which crate depends on which, and on what from outside
  licences                  that deny.toml allows the licences of all packages from outside, on any
                            target, and that all come from crates.io
  rules                     what the sources may contain: no printing, files, threads or clocks in the
                            engine, no file above 400 lines, no machine's paths, no ignored test,
                            no text of a page escaped by hand, no link to a file that is not there, few hidden lines in doc examples, long
                            functions that say why, small numbers with a name
  house [--list]            what the last three of these count, for each crate; with --list each long
                            function without a why and each small number without a name
  examples                  every examples/*.toml through the command `carom`
  book                      makes the transcripts, figures and reference pages of the book anew, by running
                            `carom` as book/commands.txt says
  book check                compares them with what is there, and looks at the book's pages
  campaign [--share S] [--seed N] [--case N] [--out FILE]
                            10⁸ random impacts at one contact, 10⁶ at several and 3·10⁵ feeders, or a share
                            of them: what came out, the worst residuals; exits 1 where a promise broke
  digest                    one digest over a fixed set of runs, which must be the same in debug and
                            release builds and on 1, 2 and 8 threads
  digest wasm               the same in the release build and by the command as WebAssembly; needs Node.js
                            and a standard library for wasm32-wasip1, and says so where they are missing
  coverage                  how many lines of each engine crate their tests reach; needs cargo-llvm-cov;
                            exits 1 where it is less than 95 % of one
  fuzz [--seconds N] [TARGET...]
                            looks for inputs that break something, N seconds a target (60); needs a
                            nightly compiler and cargo-fuzz, and says so where they are missing
  studio                    builds the studio: the engine as WebAssembly, and the site around it; needs Node.js
                            and a standard library for wasm32-unknown-unknown, and says so where they are missing
  studio check              the same, and its tests in Chromium
  python wheels             builds the wheels for Python, with the studio in them, into target/wheels; needs what
                            `studio` needs, Python 3.11 and what pip fetches
  python check              builds the first of them, installs it into an environment of its own, and tries it there
  c check                   builds the libraries for C, and compiles, links and tries programs in C with both;
                            needs a C compiler, and uses c++ and valgrind where they are there
  help                      this page

  steps of `check`: format arrows licences rules clippy doc examples book digest tests";

/// The steps of `check`, the quick ones first.
const STEPS: [Step; 10] = [
    Step { name: "format", run: |root| steps::cargo(root, &["fmt", "--all", "--", "--check"]) },
    Step { name: "arrows", run: arrows::check },
    Step { name: "licences", run: licences::check },
    Step { name: "rules", run: rules::check },
    Step { name: "clippy", run: steps::clippy },
    Step { name: "doc", run: docs::check },
    Step { name: "examples", run: examples::check },
    Step { name: "book", run: book::check },
    Step { name: "digest", run: digest::check },
    Step { name: "tests", run: steps::tests },
];

/// A chore of its own: it writes, where the step of this name compares.
const BOOK: Step = Step { name: "book", run: book::write };

/// Chores of their own: they need more than Rust.
const STUDIO: [Step; 2] =
    [Step { name: "studio", run: studio::build }, Step { name: "studio", run: studio::check }];
const PYTHON: [Step; 2] =
    [Step { name: "python", run: python::wheels }, Step { name: "python", run: python::check }];
const C: Step = Step { name: "c", run: c::check };
const DIGEST_WASM: Step = Step { name: "digest wasm", run: digest::check_wasm };

/// What the command line asks for.
enum Task {
    Help,
    Coverage,
    Fuzz(fuzz::Plan),
    /// Figures of the sources, each place behind them too where true.
    House(bool),
    Run(Vec<&'static Step>),
    /// Random cases by the million, with these words.
    Campaign(Vec<String>),
}

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match task(&words) {
        Ok(Task::Help) => {
            println!("{HELP}");
            ExitCode::SUCCESS
        }
        Ok(Task::Coverage) => coverage::run(&tree::root()),
        Ok(Task::Fuzz(plan)) => fuzz::run(&tree::root(), &plan),
        Ok(Task::House(list)) => said(house::report(&tree::root(), list)),
        Ok(Task::Run(chosen)) => steps::run_all(&tree::root(), &chosen),
        Ok(Task::Campaign(words)) => steps::campaign(&tree::root(), &words),
        Err(problem) => {
            eprintln!("{problem}\n\n{HELP}");
            ExitCode::from(2)
        }
    }
}

/// Prints what a chore found.
fn said(found: Result<String, String>) -> ExitCode {
    match found {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

fn task(words: &[&str]) -> Result<Task, String> {
    match words {
        [] | ["help" | "--help" | "-h"] => Ok(Task::Help),
        ["check"] => Ok(Task::Run(STEPS.iter().collect())),
        ["check", "--without", without @ ..] => all_but(without).map(Task::Run),
        ["coverage"] => Ok(Task::Coverage),
        ["fuzz", rest @ ..] => fuzz::plan(rest).map(Task::Fuzz),
        ["house"] => Ok(Task::House(false)),
        ["house", "--list"] => Ok(Task::House(true)),
        [name @ ("arrows" | "licences" | "rules" | "examples" | "digest")] => {
            Ok(Task::Run(STEPS.iter().filter(|step| step.name == *name).collect()))
        }
        ["digest", "wasm"] => Ok(Task::Run(vec![&DIGEST_WASM])),
        ["python", "wheels"] => Ok(Task::Run(vec![&PYTHON[0]])),
        ["python", "check"] => Ok(Task::Run(vec![&PYTHON[1]])),
        ["c", "check"] => Ok(Task::Run(vec![&C])),
        ["book"] => Ok(Task::Run(vec![&BOOK])),
        ["book", "check"] => Ok(Task::Run(STEPS.iter().filter(|step| step.name == "book").collect())),
        ["studio"] => Ok(Task::Run(vec![&STUDIO[0]])),
        ["studio", "check"] => Ok(Task::Run(vec![&STUDIO[1]])),
        ["campaign", rest @ ..] => Ok(Task::Campaign(rest.iter().map(|&word| word.to_owned()).collect())),
        _ => Err(format!("not a command: {}", words.join(" "))),
    }
}

fn all_but(without: &[&str]) -> Result<Vec<&'static Step>, String> {
    if without.is_empty() {
        return Err("--without needs the name of a step".to_owned());
    }
    match without.iter().find(|name| STEPS.iter().all(|step| step.name != **name)) {
        Some(unknown) => Err(format!("not a step: {unknown}")),
        None => Ok(STEPS.iter().filter(|step| !without.contains(&step.name)).collect()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(words: &[&str]) -> Option<Vec<&'static str>> {
        match task(words) {
            Ok(Task::Run(chosen)) => Some(chosen.iter().map(|step| step.name).collect()),
            _ => None,
        }
    }

    #[test]
    fn check_runs_every_step_in_order() {
        let expected =
            ["format", "arrows", "licences", "rules", "clippy", "doc", "examples", "book", "digest", "tests"];
        assert_eq!(names(&["check"]).as_deref(), Some(&expected[..]), "the steps of check");
    }

    #[test]
    fn a_step_can_be_left_out_by_name() {
        let expected = ["format", "arrows", "licences", "rules", "doc", "examples", "book", "digest"];
        let got = names(&["check", "--without", "clippy", "tests"]);
        assert_eq!(got.as_deref(), Some(&expected[..]), "two steps left out");
    }

    #[test]
    fn unknown_words_are_refused() {
        for words in
            [&["chek"][..], &["check", "--without"], &["check", "--without", "claim"], &["rules", "x"]]
        {
            assert!(task(words).is_err(), "{words:?} must be refused");
        }
    }

    #[test]
    fn the_help_page_names_every_step() {
        for step in &STEPS {
            assert!(HELP.contains(step.name), "the help page does not name {}", step.name);
        }
    }
}
