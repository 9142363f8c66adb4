//! The boundaries that `carom map` draws against whole runs, bisected one by one.
//!
//! Points of a boundary are located by the map itself; between them it is straight, so the grids are fine enough for the bends of these
//! boundaries: chords leave a curve y(x) by up to y″ h²/8 over a column of width h.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking; how near they come is a measurement"
)]

use carom_num::sobol::random;
use carom_scene::Scene;
use carom_study::Ending;
use carom_words::study::letters;
use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a boundary and the change of verdict may differ by [m].
const AGREES: f64 = 1e-6;
/// Places on each map.
const PLACES: u64 = 50;
/// Where they are follows from it.
const SEED: u64 = 20_260_901;

/// A plane over slope [deg] and distance [mm] of a scene.
struct Plane {
    scene: PathBuf,
    slope: &'static str,
    distance: &'static str,
    ranges: [&'static str; 2],
}

/// A line of `map.csv`.
struct Line {
    pair: [String; 2],
    points: Vec<[f64; 2]>,
}

impl Plane {
    /// The lines of the map and the points where three outcomes meet.
    fn drawn(&self, out: &Path) -> (Vec<Line>, Vec<[f64; 2]>) {
        let [x, y] =
            [format!("{}={}", self.slope, self.ranges[0]), format!("{}={}", self.distance, self.ranges[1])];
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        command.arg("map").arg(&self.scene).args(["--x", &x, "--y", &y, "--out"]).arg(out);
        let output = command.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let read = |file: &str| {
            std::fs::read_to_string(out.join(self.scene.file_stem().unwrap()).join(file)).unwrap()
        };
        let (text, summary) = (read("map.csv"), read("map.json"));
        let mut lines: Vec<(String, Line)> = vec![];
        for row in text.lines().skip(1) {
            let cells: Vec<&str> = row.split(',').collect();
            let point = [0, 1].map(|axis| cells[axis].parse().unwrap());
            match lines.last_mut() {
                Some((number, line)) if number == cells[4] => line.points.push(point),
                _ => {
                    let pair = [cells[2], cells[3]].map(str::to_owned);
                    lines.push((cells[4].to_owned(), Line { pair, points: vec![point] }));
                }
            }
        }
        let summary: Value = serde_json::from_str(&summary).unwrap();
        let junctions = summary["junctions"].as_array().unwrap().iter();
        let junctions = junctions.map(|junction| ["x", "y"].map(|axis| junction[axis].as_f64().unwrap()));
        (lines.into_iter().map(|(_, line)| line).collect(), junctions.collect())
    }

    /// How a whole run ends, followed as `carom run` does.
    fn ending(&self, scene: &Scene, slope_deg: f64, distance: f64) -> String {
        let set = scene.with(self.slope, slope_deg.to_radians()).unwrap();
        let Ok(set) = set.with(self.distance, distance) else { return letters(Ending::Impossible) };
        letters(Ending::of(&set.feeder().run().unwrap(), 1))
    }

    /// How far along the distance [m] a verdict changes to the other from a place on the line between them.
    fn off(&self, scene: &Scene, pair: &[String; 2], [slope_deg, distance_mm]: [f64; 2]) -> f64 {
        let at = |off: f64| self.ending(scene, slope_deg, 1e-3 * distance_mm + off);
        let mut reach = AGREES;
        loop {
            let [low, high] = [at(-reach), at(reach)];
            if [[&low, &high], [&high, &low]].contains(&[&pair[0], &pair[1]]) {
                return bisected([-reach, reach], |off| at(off) == low);
            }
            reach *= 2.0;
            assert!(
                reach < 1e-2,
                "no change from {} to {} at {slope_deg} deg, {distance_mm} mm",
                pair[0],
                pair[1]
            );
        }
    }
}

fn bisected([mut low, mut high]: [f64; 2], is_low: impl Fn(f64) -> bool) -> f64 {
    while high - low > 1e-12 {
        let middle = 0.5 * (low + high);
        if is_low(middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// A place on the lines, by the number of a draw: anywhere along their length, each axis measured by what the lines span of it.
fn place(lines: &[&Line], draw: u64) -> [f64; 2] {
    let all = || lines.iter().flat_map(|line| line.points.windows(2));
    let spans = [0, 1].map(|axis| {
        let values = all().flatten().map(|point| point[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        high - low
    });
    let length = |ends: &[[f64; 2]]| {
        [0, 1].map(|axis| ((ends[1][axis] - ends[0][axis]) / spans[axis]).powi(2)).iter().sum::<f64>().sqrt()
    };
    let mut left = random(SEED, draw, 0) * all().map(length).sum::<f64>();
    for ends in all() {
        let here = length(ends);
        if left <= here {
            return between(ends[0], ends[1], left / here);
        }
        left -= here;
    }
    *lines.last().unwrap().points.last().unwrap()
}

fn between(a: [f64; 2], b: [f64; 2], share: f64) -> [f64; 2] {
    [0, 1].map(|axis| a[axis] * (1.0 - share) + b[axis] * share)
}

/// Places next to the junctions that lines end in: on the last piece of each, a half, a quarter and a tenth of it away. Nearer to one the
/// third outcome stands within [`AGREES`] of the line, so that there is nothing to compare with.
fn beside_junctions(lines: &[&Line], junctions: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let ends = lines.iter().flat_map(|line| {
        let points = &line.points;
        [[points[0], points[1]], [points[points.len() - 1], points[points.len() - 2]]]
    });
    let meeting = ends.filter(|[end, _]| junctions.contains(end));
    meeting.flat_map(|[end, next]| [0.5, 0.25, 0.1].map(|share| between(end, next, share))).collect()
}

fn largest(offs: &[f64]) -> f64 {
    offs.iter().fold(0.0, |largest, off| largest.max(off.abs()))
}

fn compare(name: &str, plane: &Plane, meeting: usize) {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("boundary").join(name);
    let (lines, junctions) = plane.drawn(&out);
    let scene = Scene::read(&plane.scene).unwrap();
    let points: Vec<(&[String; 2], [f64; 2])> =
        lines.iter().flat_map(|line| line.points.iter().map(|point| (&line.pair, *point))).collect();
    // A junction is a point of three lines, each of which may be the nearest.
    let points: Vec<_> = points.into_iter().filter(|(_, point)| !junctions.contains(point)).collect();
    let drawn = (0..PLACES).map(|draw| points[(random(SEED, draw, 1) * points.len() as f64) as usize]);
    let located: Vec<f64> = drawn.map(|(pair, point)| plane.off(&scene, pair, point)).collect();

    let verdict = ["S", "T"].map(str::to_owned);
    let turns: Vec<&Line> = lines.iter().filter(|line| line.pair == verdict).collect();
    let anywhere: Vec<f64> =
        (0..PLACES).map(|draw| plane.off(&scene, &verdict, place(&turns, draw))).collect();
    let beside = beside_junctions(&turns, &junctions);
    assert_eq!(beside.len(), 3 * meeting, "{junctions:?}");
    let beside: Vec<f64> = beside.into_iter().map(|place| plane.off(&scene, &verdict, place)).collect();
    println!(
        "{name}: {} lines of {} points; {PLACES} points are {:.1e} m off at most, {PLACES} places anywhere between same and turned {:.1e} m, {} beside junctions {:.1e} m",
        lines.len(),
        points.len(),
        largest(&located),
        largest(&anywhere),
        beside.len(),
        largest(&beside)
    );
    for offs in [located, anywhere, beside] {
        assert!(largest(&offs) < AGREES, "{offs:?}");
    }
}

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)
}

#[test]
fn over_slope_and_distance_of_the_papers_first_case_the_drawn_boundary_is_where_runs_change() {
    compare(
        "upper_slope",
        &Plane {
            scene: example("case_1.toml"),
            slope: "plate.upper.slope",
            distance: "plate.lower.line.normal",
            ranges: ["10..17 deg:240", "190..400 mm:2"],
        },
        0,
    );
}

#[test]
fn over_the_lower_plates_slope_and_its_distance_too() {
    // The paper's first case with its lower plate turned about a point under the upper one's edge.
    let text = std::fs::read_to_string(example("case_1.toml")).unwrap();
    let line = "downhill = \"left\"\nline     = { along = \"347 mm\", normal = \"200 mm\" }";
    assert!(text.contains(line));
    let text = text.replace(line, "slope    = \"15 deg\"\nbelow    = { x = \"0 mm\", y = \"-200 mm\" }");
    let scene = Path::new(env!("CARGO_TARGET_TMPDIR")).join("lower_slope.toml");
    std::fs::write(&scene, text).unwrap();
    compare(
        "lower_slope",
        &Plane {
            scene,
            slope: "plate.lower.slope",
            distance: "plate.lower.below.y",
            ranges: ["5..40 deg:400", "-400..-60 mm:2"],
        },
        1,
    );
}
