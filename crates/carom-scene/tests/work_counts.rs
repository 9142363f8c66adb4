//! The work of runs and studies, counted: a slowdown shows here without a clock, and on a busy machine too.
//!
//! `INSTA_UPDATE=always cargo test -p carom-scene --test all work_counts::` writes the counts anew. A change of them belongs in the changelog.

use carom_feeder::{Effort, Feeder, Plate};
use carom_motion::planar::Options;
use carom_num::{Vec2, elementary::tan};
use carom_scene::{AnyScene, Scene};
use carom_study::map;
use carom_study::regions::{self, Range};
use carom_study::rocking::Rolling;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Tolerance of the single runs.
const TOLERANCE: f64 = 1e-10;

/// Ends of stages are as close as this to those of the whole run [s].
const SAME_TIME: f64 = 1e-12;

/// The example scenes, by name; the files of impacts and of rolling bodies are none.
fn scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
    let is_scene = |path: &PathBuf| {
        let name = name(path);
        name.ends_with(".toml") && !["impact_", "contact_", "roll_"].iter().any(|kind| name.starts_with(kind))
    };
    let mut found: Vec<PathBuf> = entries.filter(is_scene).collect();
    found.sort_by_key(|path| name(path));
    found
}

fn options() -> Options {
    Options { tolerance: TOLERANCE, ..Options::default() }
}

fn work(feeder: &Feeder) -> Effort {
    feeder.prepare(options()).unwrap().run_untraced().unwrap().effort
}

/// What each stage of a run costs: the same run, ended by its budget after one event, after two, and so on.
fn stages(table: &mut String, feeder: &Feeder) {
    let run = feeder.prepare(options()).unwrap().run().unwrap();
    let mut before = Effort::default();
    for most_events in 1..=run.effort.events {
        let ended = Options { most_events, ..options() };
        let now = feeder.prepare(ended).unwrap().run_untraced().unwrap();
        let stage = run.stages.iter().find(|stage| stage.end_time > now.end_time - SAME_TIME);
        let name = format!("  {:?}, to {:.4} s", stage.unwrap().name, now.end_time);
        let own = Effort {
            rhs_evaluations: now.effort.rhs_evaluations - before.rhs_evaluations,
            steps: now.effort.steps - before.steps,
            event_evaluations: now.effort.event_evaluations - before.event_evaluations,
            rate_problems: now.effort.rate_problems - before.rate_problems,
            events: now.effort.events - before.events,
            impacts: now.effort.impacts - before.impacts,
        };
        row(table, &name, &own);
        before = now.effort;
    }
    assert_eq!(before.rhs_evaluations, run.effort.rhs_evaluations, "the stages are the whole run");
}

fn row(table: &mut String, name: &str, work: &Effort) {
    let Effort { rhs_evaluations, steps, event_evaluations, rate_problems, events, impacts, .. } = work;
    writeln!(
        table,
        "{name:<24}{rhs_evaluations:>12}{steps:>8}{event_evaluations:>12}{rate_problems:>10}{events:>8}{impacts:>8}"
    )
    .unwrap();
}

fn sum(all: impl Iterator<Item = Effort>) -> Effort {
    all.fold(Effort::default(), |a, b| Effort {
        rhs_evaluations: a.rhs_evaluations + b.rhs_evaluations,
        steps: a.steps + b.steps,
        event_evaluations: a.event_evaluations + b.event_evaluations,
        rate_problems: a.rate_problems + b.rate_problems,
        events: a.events + b.events,
        impacts: a.impacts + b.impacts,
    })
}

/// The paper's feeder with its lower plate replaced by that of every row of the grid.
fn grid(paper: &Feeder) -> Vec<Feeder> {
    let text = include_str!("../../carom-feeder/tests/reference/feeder_grid.csv");
    let upper = &paper.plates[0];
    let x = (upper.edge - upper.uphill).unit().unwrap();
    let design = |line: &str| {
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let (slope, line_b): (f64, f64) = (fields[0].parse().unwrap(), fields[1].parse().unwrap());
        let (high, low) = (x * (line_b / tan((slope + 15.0).to_radians())), x.turned_right() * line_b);
        let (high, low) = (upper.edge + high, upper.edge + low);
        let down: Vec2 = (low - high).unit().unwrap();
        let lower = Plate { uphill: high - down * 3.0, edge: low + down * 3.0, ..paper.plates[1].clone() };
        Feeder { plates: vec![upper.clone(), lower], ..paper.clone() }
    };
    text.lines().skip(1).map(design).collect()
}

/// Drops of a map of the paper's first case, and strikes of a region diagram.
fn studies(table: &mut String, paper: &Scene) {
    let variants = paper.variants(&["contact.friction", "start.to_edge"]).unwrap();
    let (friction, reach) =
        (Range { from: 0.05, to: 0.25, count: 12 }, Range { from: 0.06, to: 0.2, count: 12 });
    let looking = regions::Options { accuracy: 1e-6, depth: 2 };
    let found = map::draw(friction, reach, &looking, 1, |x, y| variants.feeder(&[x, y]).ok()).unwrap();
    writeln!(table, "map, 12 × 12 cells: {} drops", found.drops).unwrap();
    let friction = Range { from: 0.0, to: 1.5, count: 30 };
    let half_angle = Range { from: 1.0, to: 89.0, count: 30 };
    let state = |friction: f64, half_angle: f64| {
        Rolling::cylinder(0.5, half_angle.to_radians(), friction, 0.0).strike().unwrap().cylinder_state()
    };
    let found = regions::find(friction, half_angle, &regions::Options::default(), state).unwrap();
    writeln!(table, "regions, 30 × 30 cells: {} strikes", found.evaluations).unwrap();
}

#[test]
fn runs_and_studies_cost_this_much() {
    let mut table = format!(
        "{:<24}{:>12}{:>8}{:>12}{:>10}{:>8}{:>8}\n",
        "", "derivatives", "steps", "event fns", "problems", "events", "impacts"
    );
    let mut paper = None;
    for path in scenes() {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let scene = match AnyScene::read(&path).unwrap() {
            AnyScene::Plane(scene) => *scene,
            AnyScene::Space(scene) => {
                row(&mut table, &name, &scene.feeder().run_untraced().unwrap().effort);
                continue;
            }
        };
        match scene.feed() {
            Some(feed) => {
                let fed = scene.feeder().prepare(options()).unwrap().feed(feed).unwrap();
                for (n, part) in fed.parts.iter().enumerate() {
                    row(&mut table, &format!("{name}, part {}", n + 1), &part.run.effort);
                }
            }
            None => row(&mut table, &name, &work(scene.feeder())),
        }
        if name == "case_1.toml" {
            stages(&mut table, scene.feeder());
            paper = Some(scene);
        }
    }
    let paper = paper.expect("the paper's first case is an example");
    let designs = grid(paper.feeder());
    row(&mut table, &format!("grid, {} designs", designs.len()), &sum(designs.iter().map(work)));
    studies(&mut table, &paper);
    insta::assert_snapshot!(table);
}
