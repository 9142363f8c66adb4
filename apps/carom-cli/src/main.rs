//! The command `carom`.
//!
//! Results go to stdout, messages to stderr. It ends with 0 (done), 1 (could not be done) or 2 (bad input).

mod args;
mod contact;
mod design;
mod disk;
mod draw;
mod failure;
mod feed;
mod feeding;
mod files;
mod folder_name;
mod impact;
mod limits;
mod lines;
mod map;
mod new;
mod paper;
mod pipeline;
mod progress;
mod quantities;
mod regions;
mod roll;
mod run;
mod schema;
mod side_by_side;
mod sweep;
mod table;
mod validate;
mod warned;
mod watch;
mod yields;

#[cfg(test)]
mod broken_calls;

use args::{Arguments, Command, Output};
use clap::Parser;
use failure::Failure;
use std::io::Write;
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let mut out = std::io::stdout().lock();
    let done = carry_out(arguments.command, &arguments.output, &mut out).and_then(|()| Ok(out.flush()?));
    match done {
        Ok(()) => ExitCode::SUCCESS,
        // Whoever read the output has had enough of it.
        Err(Failure::Output(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(failure) => {
            // There is nowhere to report that stderr is closed.
            let _ = writeln!(std::io::stderr(), "{}", failure.to_string().trim_end());
            ExitCode::from(failure.code())
        }
    }
}

fn carry_out(command: Command, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    match command {
        Command::Run(options) => run::run(&options, output, out),
        Command::Draw(options) => draw::draw(&options, output, out),
        Command::New(options) => new::new(&options, output, out),
        Command::Watch(options) => watch::watch(&options, output, out),
        Command::Impact(options) => impact::impact(&options, output, out),
        Command::Contact(options) => contact::contact(&options, output, out),
        Command::Roll(options) => roll::roll(&options, output, out),
        Command::Regions(options) => regions::regions(&options, output, out),
        Command::Map(options) => map::map(&options, output, out),
        Command::Yield(options) => yields::yields(&options, output, out),
        Command::Feed(options) => feeding::feed(&options, output, out),
        Command::Sweep(options) => sweep::sweep(&options, output, out),
        Command::Design(options) => design::design(&options, output, out),
        Command::Validate(options) => validate::validate(&options, output, out),
        Command::Schema(options) => schema::schema(&options, output, out),
    }
}
