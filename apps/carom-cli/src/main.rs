//! The command `carom`.
//!
//! Results go to stdout, messages to stderr. It ends with 0 (done), 1 (could not be done) or 2 (bad input).
//! A stdout that cannot be written is not done; one that was closed before the start is `/dev/null`, which Rust opens in its place, and
//! cannot be told from it.

mod args;
mod contact;
mod design;
mod draw;
mod faces;
mod failure;
#[cfg(test)]
mod faults;
mod feed;
mod feeding;
mod files;
mod fitting;
mod folder_name;
mod helps;
mod impact;
mod limits;
mod lines;
mod map;
mod new;
mod paper;
mod pipeline;
mod printed;
mod progress;
mod referee;
mod regions;
mod roll;
mod run;
mod schema;
mod side_by_side;
mod space;
mod studio;
mod sweep;
mod table;
mod thrown;
mod tolerance;
mod validate;
mod watch;
mod yields;

#[cfg(test)]
mod broken_calls;

use args::{Arguments, Command, Format, Output, is_stdin};
use clap::{CommandFactory, Parser};
use failure::Failure;
use printed::{Visible, tell};
use std::io::{ErrorKind, Write};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    let done = Arguments::try_parse().map_or_else(
        |said| usage(&said),
        |arguments| {
            let out = std::io::stdout().lock();
            match arguments.output.format {
                Format::Text => print(arguments, Visible(out)),
                Format::Json => print(arguments, out),
            }?;
            Ok(ExitCode::SUCCESS)
        },
    );
    match done {
        Ok(code) => code,
        // Whoever read the output has had enough of it: the files are written.
        Err(Failure::Output(error)) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(failure) => {
            tell(&failure.to_string());
            ExitCode::from(failure.code())
        }
    }
}

/// What is wrong with the command line, or the help and the version that it asks for.
fn usage(said: &clap::Error) -> Result<ExitCode, Failure> {
    let printed = said.print().and_then(|()| std::io::stdout().flush());
    // There is nowhere to report that stderr is closed.
    if !said.use_stderr() {
        printed?;
    } else if let Err(problems) = run::read(&scenes_named()) {
        tell(&format!("\n{problems}"));
    }
    Ok(ExitCode::from(u8::try_from(said.exit_code()).unwrap_or(2)))
}

/// The scenes that a command line names which is wrong elsewhere: what is wrong with them is not hidden by that.
fn scenes_named() -> Vec<PathBuf> {
    let found = Arguments::command().ignore_errors(true).try_get_matches();
    let Some((_, words)) = found.ok().and_then(|mut found| found.remove_subcommand()) else { return vec![] };
    let named =
        ["scene", "scenes"].into_iter().filter_map(|name| words.try_get_many::<PathBuf>(name).ok()?);
    named.flatten().filter(|path| !is_stdin(path)).cloned().collect()
}

/// Carries out a command, and prints what it says once its files are written: they do not depend on who reads.
fn print(arguments: Arguments, mut out: impl Write) -> Result<(), Failure> {
    let Arguments { command, output } = arguments;
    if command.streams() {
        return carry_out(command, &output, &mut out).and_then(|()| Ok(out.flush()?));
    }
    let mut text = vec![];
    let done = carry_out(command, &output, &mut text);
    let printed = out.write_all(&text).and_then(|()| out.flush());
    done.and_then(|()| Ok(printed?))
}

fn carry_out(command: Command, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    match command {
        Command::Run(options) => run::run(&options, output, out),
        Command::Draw(options) => draw::draw(&options, output, out),
        Command::Faces(options) => faces::faces(&options, output, out),
        Command::New(options) => new::new(&options, output, out),
        Command::Watch(options) => watch::watch(&options, output, out),
        Command::Impact(options) => impact::impact(&options, output, out),
        Command::Contact(options) => contact::contact(&options, output, out),
        Command::Roll(options) => roll::roll(&options, output, out),
        Command::Regions(options) => regions::regions(&options, output, out),
        Command::Map(options) => map::map(&options, output, out),
        Command::Yield(options) => yields::yields(&options, output, out),
        Command::Fit(options) => fitting::fit(&options, output, out),
        Command::Feed(options) => feeding::feed(&options, output, out),
        Command::Sweep(options) => sweep::sweep(&options, output, out),
        Command::Design(options) => design::design(&options, output, out),
        Command::Validate(options) => validate::validate(&options, output, out),
        Command::Cases(options) => referee::cases(&options, output, out),
        Command::Judge(options) => referee::judge(&options, output, out),
        Command::Studio(options) => studio::studio(&options, output, out),
        Command::Schema(options) => schema::schema(&options, output, out),
    }
}
