//! The command line.

use crate::draw::DrawOptions;
use crate::fitting::FitOptions;
use crate::folder_name::folder_name;
use crate::helps::{CONTACT_HELP, FEED_HELP, FIT_HELP, IMPACT_HELP, MAP_HELP};
use crate::referee::{CasesOptions, JUDGE_HELP, JudgeOptions};
use crate::schema::SchemaOptions;
use crate::studio::StudioOptions;
use crate::validate::{VALIDATE_HELP, ValidateOptions};
use crate::yields::YieldOptions;
use carom::tasks::{feeds::INTERVALS, tolerance};
use clap::{Args, Parser, Subcommand, ValueEnum};
use std::path::{Path, PathBuf};

/// Exact contact and impact of rigid parts, and the gravity-impact part feeder.
#[derive(Debug, Parser)]
#[command(name = "carom", version, max_term_width = 100)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    pub(crate) command: Command,
    #[command(flatten)]
    pub(crate) output: Output,
}

/// Where results go: the same for every command.
#[derive(Args, Debug)]
pub(crate) struct Output {
    /// How results are printed.
    #[arg(long, value_enum, default_value_t, global = true)]
    pub(crate) format: Format,
    /// Folder of what is written; runs and drawings make a folder of the scene's name in it [default: out].
    #[arg(long, value_name = "DIR", global = true)]
    pub(crate) out: Option<PathBuf>,
}

impl Output {
    /// The folder of a scene, always inside the output folder; an empty name is the output folder itself.
    pub(crate) fn folder(&self, scene: &str) -> PathBuf {
        self.out.as_deref().unwrap_or(Path::new("out")).join(folder_name(scene))
    }
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run scenes: does the part land turned over?
    Run(RunOptions),
    /// Draw a scene without running it.
    Draw(DrawOptions),
    /// What the part can lie on, how surely it stays there, and on which face it comes to rest when it is thrown.
    Faces(FacesOptions),
    /// Write a scene to start from.
    New(NewOptions),
    /// Run a scene again at each save.
    Watch(WatchOptions),
    /// Resolve one impact: what happens, and every end state.
    #[command(after_help = IMPACT_HELP)]
    Impact(ImpactOptions),
    /// Which motions are consistent where bodies touch, under forces: one, several or none.
    #[command(after_help = CONTACT_HELP)]
    Contact(ContactOptions),
    /// Follow a body that rolls, rocks or pivots through its strikes.
    Roll(RollOptions),
    /// Draw the regions of a plane of two quantities in which the same thing happens.
    Regions(RegionsOptions),
    /// Map how a drop ends over two quantities of a scene.
    #[command(after_help = MAP_HELP)]
    Map(MapOptions),
    /// How surely a drop ends as wanted, under the tolerances that the scene writes.
    Yield(YieldOptions),
    /// Which friction, restitution or other quantity agrees with drops that were observed.
    #[command(after_help = FIT_HELP)]
    Fit(FitOptions),
    /// How closely parts may follow each other: the smallest interval without touch, and what happens below it.
    #[command(after_help = FEED_HELP)]
    Feed(FeedOptions),
    /// Drop the part in any number of designs; stopped at any moment, it goes on where it was.
    Sweep(SweepOptions),
    /// Which layout makes drops end as wanted, by the scene's [design].
    Design(DesignOptions),
    /// Compare published results with what the engine computes, entry by entry.
    #[command(after_help = VALIDATE_HELP)]
    Validate(ValidateOptions),
    /// Cases whose answers are known, for engines to answer: single impacts to drops, one a line.
    Cases(CasesOptions),
    /// Judge the answers of other engines to these cases.
    #[command(after_help = JUDGE_HELP)]
    Judge(JudgeOptions),
    /// Open the studio in the browser: drag the plates of a feeder and see what the part does.
    Studio(StudioOptions),
    /// Print the JSON Schema of what Carom reads and writes.
    Schema(SchemaOptions),
}

impl Command {
    /// Whether what it prints is read while it works.
    pub(crate) fn streams(&self) -> bool {
        match self {
            Self::Watch(_) | Self::Studio(_) => true,
            Self::Run(options) => options.scenes.iter().any(|path| is_stdin(path)),
            Self::Roll(options) => options.file.as_deref().is_some_and(is_stdin),
            Self::Impact(options) => is_stdin(&options.file),
            Self::Contact(options) => is_stdin(&options.file),
            _ => false,
        }
    }
}

/// Whether a file that is named is a stream of lines from stdin.
pub(crate) fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// How results are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For a person.
    #[default]
    Text,
    /// For a program.
    Json,
}

#[derive(Args, Debug)]
pub(crate) struct RunOptions {
    /// Scene files; or - for one scene a line from stdin, as a JSON object with the same keys, and one result a line to stdout.
    #[arg(required = true, value_name = "SCENE")]
    pub(crate) scenes: Vec<PathBuf>,
    /// Open the reports when they are written.
    #[arg(long)]
    pub(crate) open: bool,
    /// Print the paper's letters and frames beside its Table 1.
    #[arg(long)]
    pub(crate) paper: bool,
    /// Add how far each quantity may move before the verdict flips.
    #[arg(long)]
    pub(crate) limits: bool,
}

#[derive(Args, Debug)]
pub(crate) struct FacesOptions {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// Throws, in any attitude, on level ground; rounded up to 16 times a power of two [default: 4096; of a solid part 512].
    #[arg(long, value_parser = clap::value_parser!(u64).range(16..=1 << 28))]
    pub(crate) throws: Option<u64>,
    /// From what height its lowest point falls, perhaps with a tolerance: "50 ± 10 mm".
    #[arg(long, value_name = "LENGTH", default_value = "100 mm", allow_hyphen_values = true)]
    pub(crate) height: String,
    /// Level speed with which it is thrown, to either side.
    #[arg(long, value_name = "SPEED", default_value = "0 m/s", allow_hyphen_values = true)]
    pub(crate) speed: String,
    /// Spin with which it is thrown, in either sense.
    #[arg(long, value_name = "SPIN", default_value = "0 rad/s", allow_hyphen_values = true)]
    pub(crate) spin: String,
    /// The plate whose surface the ground has, by name or number from 0 [default: the last].
    #[arg(long, value_name = "PLATE")]
    pub(crate) plate: Option<String>,
    /// What every random number comes from: the same seed gives the same result.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Open the page when it is written.
    #[arg(long)]
    pub(crate) open: bool,
}

#[derive(Args, Debug)]
pub(crate) struct NewOptions {
    /// File to write; - for stdout.
    #[arg(value_name = "FILE", default_value = "feeder.toml")]
    pub(crate) file: PathBuf,
    /// How many plates it has.
    #[arg(long, default_value_t = 2, value_parser = clap::value_parser!(u32).range(1..=50))]
    pub(crate) plates: u32,
}

#[derive(Args, Debug)]
pub(crate) struct WatchOptions {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// Open the report after the first run.
    #[arg(long)]
    pub(crate) open: bool,
    /// Stop after so many runs.
    #[arg(long, value_name = "N")]
    pub(crate) runs: Option<u64>,
}

#[derive(Args, Debug)]
pub(crate) struct ImpactOptions {
    /// Impact file in TOML, or - for one JSON object a line from stdin and one a line to stdout.
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
}

#[derive(Args, Debug)]
pub(crate) struct ContactOptions {
    /// File in TOML, or - for one JSON object a line from stdin and one a line to stdout.
    #[arg(value_name = "FILE")]
    pub(crate) file: PathBuf,
}

/// What rolls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum RollWord {
    /// A cylinder, hoop or ball that meets a step or a second surface.
    Cylinder,
    /// A prism that turns about its edges.
    Prism,
    /// A rod on two point supports.
    Rod,
    /// A pyramid that turns about a lateral edge.
    Pyramid,
    /// A body on n supports that rocks and wobbles to rest.
    Stool,
    /// A polyhedron, of vertices or from an STL file, thrown on a plane.
    Body,
}

#[derive(Args, Debug)]
pub(crate) struct RollOptions {
    /// What rolls.
    #[arg(value_enum, value_name = "KIND")]
    pub(crate) kind: RollWord,
    /// Roll file in TOML; without it every key has its default or comes from --set. With - one JSON object a line from stdin, and one result a line to stdout.
    #[arg(value_name = "FILE")]
    pub(crate) file: Option<PathBuf>,
    /// Sets a key, whatever the file says: gamma="40 deg".
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) set: Vec<String>,
    /// Of a body: makes so many throws in any attitude, rounded up to 16 times a power of two, and says how often it rests on which face.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(16..=1 << 28))]
    pub(crate) throws: Option<u64>,
    /// In JSON: poses and velocities at all multiples of this interval, "10 ms" or seconds, and just before and after each strike; a million at most.
    #[arg(long, value_name = "DT")]
    pub(crate) poses: Option<String>,
    /// Of throws: what every random number comes from; the same seed gives the same result.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Open the report when it is written.
    #[arg(long)]
    pub(crate) open: bool,
}

/// What strikes in a region diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum RegionsWord {
    /// A cylinder that rolls against a step or a second plane.
    Cylinder,
    /// A prism that rolls on over its next edge.
    Prism,
    /// A rod that turns about one of two supports and falls on the other.
    Rod,
    /// A corner of a rod or box that strikes a plate.
    Strike,
    /// A pyramid that rolls over a lateral edge onto its next face: its shape decides.
    Pyramid,
    /// A rod that slides with one end on a plate, under gravity: which motions are consistent.
    Contact,
    /// A stool that is let go on one support: what it strikes with first, and how it ends.
    Stool,
    /// A stool that comes down from one support on the next: which of the two it keeps.
    StoolStrike,
}

#[derive(Args, Debug)]
pub(crate) struct RegionsOptions {
    /// What strikes; or --file.
    #[arg(value_enum, value_name = "KIND", conflicts_with = "file")]
    pub(crate) of: Option<RegionsWord>,
    /// An impact file in TOML, any two numbers of which may be axes.
    #[arg(long, value_name = "IMPACT")]
    pub(crate) file: Option<PathBuf>,
    /// A quantity that is not at its default: inertia_ratio=0.5, gamma="60 deg".
    #[arg(long, value_name = "KEY=VALUE")]
    pub(crate) set: Vec<String>,
    /// Abscissa: friction=0..1.5:75, body.spin=-10..10:80.
    #[arg(long, value_name = "KEY=A..B[:CELLS]", allow_hyphen_values = true)]
    pub(crate) x: Option<String>,
    /// Ordinate: gamma="1..89 deg:88".
    #[arg(long, value_name = "KEY=A..B[:CELLS]", allow_hyphen_values = true)]
    pub(crate) y: Option<String>,
    /// Label the whole impact with this restitution, not the end of compression (cylinder, prism, rod).
    #[arg(long, value_name = "R")]
    pub(crate) elastic: Option<f64>,
    /// How often a cell is halved where something in it does not fit.
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(0..=8))]
    pub(crate) depth: u32,
}

#[derive(Args, Debug)]
pub(crate) struct MapOptions {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// Abscissa: "plate.lower.slope=2..38 deg:100".
    #[arg(long, value_name = "PATH=A..B[:CELLS]", allow_hyphen_values = true)]
    pub(crate) x: String,
    /// Ordinate.
    #[arg(long, value_name = "PATH=A..B[:CELLS]", allow_hyphen_values = true)]
    pub(crate) y: String,
    /// A quantity that is not as in the scene: contact.friction=0.2.
    #[arg(long, value_name = "PATH=VALUE")]
    pub(crate) set: Vec<String>,
    /// The plate to look at, by name or number from 0 [default: the last].
    #[arg(long, value_name = "PLATE")]
    pub(crate) plate: Option<String>,
    /// How finely boundaries are located, as a share of the axes [default: 1e-7; with --cells a tenth of a cell, and never coarser than that].
    #[arg(long, value_name = "SHARE")]
    pub(crate) accuracy: Option<f64>,
    /// How often a cell is halved where something in it does not fit.
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u32).range(0..=8))]
    pub(crate) depth: u32,
    /// Say how the drop at the middle of every cell ends as well. Boundaries are followed on a grid eight times as coarse; only cells beside a boundary have a drop of their own.
    #[arg(long)]
    pub(crate) cells: bool,
}

#[derive(Args, Debug)]
pub(crate) struct FeedOptions {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// How many parts, 2 to 100; not for solid parts, of which one is followed [default: as the scene's [feed], or 3].
    #[arg(long, value_name = "N")]
    pub(crate) parts: Option<usize>,
    /// Intervals that are asked all over the range.
    #[arg(long, default_value_t = INTERVALS, value_name = "N")]
    pub(crate) intervals: usize,
    /// How finely changes are located [s].
    #[arg(long, default_value_t = tolerance::INTERVAL_ACCURACY, value_name = "SECONDS")]
    pub(crate) accuracy: f64,
}

#[derive(Args, Debug)]
pub(crate) struct SweepOptions {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// A quantity and its points, both ends included; of several, every combination: "plate.lower.slope=5..40 deg:71".
    #[arg(long, value_name = "PATH=A..B:POINTS", allow_hyphen_values = true, conflicts_with = "list")]
    pub(crate) grid: Vec<String>,
    /// A CSV file: the first line names quantities, each other one is a design, with units or in SI.
    #[arg(long, value_name = "FILE")]
    pub(crate) list: Option<PathBuf>,
    /// The plate to look at, by name or number from 0 [default: the last].
    #[arg(long, value_name = "PLATE")]
    pub(crate) plate: Option<String>,
    /// Do this part of the work only: 2/8 is the second of eight. All of them write into one folder.
    #[arg(long, value_name = "I/N", default_value = "1/1")]
    pub(crate) shard: String,
    /// Replace what the folder holds of another sweep.
    #[arg(long)]
    pub(crate) force: bool,
}

#[derive(Args, Debug)]
pub(crate) struct DesignOptions {
    /// Scene file with [design], `want` on plates, and tolerances.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// Layouts of the first look [default: 4096, of a solid part 512].
    #[arg(long, value_parser = clap::value_parser!(u64).range(16..=1 << 24))]
    pub(crate) scan: Option<u64>,
    /// Drops that the winner's yield is confirmed with; rounded up to 16 times a power of two [default: 16384, of a solid part 1024].
    #[arg(long, value_parser = clap::value_parser!(u64).range(16..=1 << 34))]
    pub(crate) samples: Option<u64>,
    /// What every random number comes from.
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
}
