//! The boundaries that `carom map` draws against whole runs, bisected one by one.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    reason = "a test fails by panicking; how near they come is a measurement"
)]

use carom_num::sobol::random;
use carom_scene::Scene;
use carom_study::Ending;
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
    /// The two verdicts whose boundary is asked.
    pair: [&'static str; 2],
}

/// A line of `map.csv`.
struct Line {
    pair: [String; 2],
    points: Vec<[f64; 2]>,
}

impl Plane {
    fn lines(&self, out: &Path) -> Vec<Line> {
        let [x, y] =
            [format!("{}={}", self.slope, self.ranges[0]), format!("{}={}", self.distance, self.ranges[1])];
        let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
        command
            .arg("map")
            .arg(&self.scene)
            .args(["--x", &x, "--y", &y, "--accuracy", "1e-9", "--out"])
            .arg(out);
        let output = command.output().unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let name = self.scene.file_stem().unwrap();
        let text = std::fs::read_to_string(out.join(name).join("map.csv")).unwrap();
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
        lines.into_iter().map(|(_, line)| line).filter(|line| line.pair == self.pair).collect()
    }

    /// How a whole run ends, followed as `carom run` does.
    fn ending(&self, scene: &Scene, slope_deg: f64, distance: f64) -> String {
        let set = scene.with(self.slope, slope_deg.to_radians()).unwrap();
        let Ok(set) = set.with(self.distance, distance) else { return Ending::Impossible.short() };
        Ending::of(&set.feeder().run().unwrap(), 1).short()
    }

    /// How far along the distance [m] the verdict changes from a place on the line; `None` where it does not within a centimetre.
    fn off(&self, scene: &Scene, [slope_deg, distance_mm]: [f64; 2]) -> Option<f64> {
        let middle = 1e-3 * distance_mm;
        let at = |off: f64| self.ending(scene, slope_deg, middle + off);
        let mut reach = AGREES;
        loop {
            let [low, high] = [at(-reach), at(reach)];
            let mut pair = [low.clone(), high];
            pair.sort();
            if pair == self.pair {
                return Some(bisected([-reach, reach], |off| at(off) == low));
            }
            reach *= 2.0;
            if reach > 1e-2 {
                return None;
            }
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

/// A place on the lines, by the number of a draw: anywhere along their length, the plane being a unit square.
fn place(lines: &[Line], draw: u64) -> [f64; 2] {
    let all = || lines.iter().flat_map(|line| line.points.windows(2));
    let span = |axis: usize| {
        let values = all().flatten().map(move |point| point[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        high - low
    };
    let spans = [span(0), span(1)];
    let length = |ends: &[[f64; 2]]| {
        [0, 1].map(|axis| ((ends[1][axis] - ends[0][axis]) / spans[axis]).powi(2)).iter().sum::<f64>().sqrt()
    };
    let mut left = random(SEED, draw, 0) * all().map(length).sum::<f64>();
    for ends in all() {
        let here = length(ends);
        if left <= here {
            let share = left / here;
            return [0, 1].map(|axis| ends[0][axis] * (1.0 - share) + ends[1][axis] * share);
        }
        left -= here;
    }
    *lines.last().unwrap().points.last().unwrap()
}

fn largest(offs: &[f64]) -> f64 {
    offs.iter().fold(0.0, |largest, off| largest.max(off.abs()))
}

fn compare(name: &str, plane: &Plane) {
    let lines = plane.lines(&Path::new(env!("CARGO_TARGET_TMPDIR")).join("boundary").join(name));
    let scene = Scene::read(&plane.scene).unwrap();
    let points: Vec<[f64; 2]> = lines.iter().flat_map(|line| line.points.iter().copied()).collect();
    let located: Vec<f64> = (0..PLACES)
        .map(|draw| points[(random(SEED, draw, 1) * points.len() as f64) as usize])
        .map(|place| plane.off(&scene, place).unwrap())
        .collect();
    let mut between: Vec<f64> =
        (0..PLACES).map(|draw| plane.off(&scene, place(&lines, draw)).unwrap()).collect();
    between.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    println!(
        "{name}: {} points in {} lines; {PLACES} of them {:.1e} m off at most; {PLACES} places between them {:.1e} m at most, half within {:.1e} m, {:?}",
        points.len(),
        lines.len(),
        largest(&located),
        largest(&between),
        between[between.len() / 2].abs(),
        &between[40..]
    );
    assert!(largest(&located) < AGREES, "{located:?}");
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
            ranges: ["10..17 deg:70", "190..400 mm:4"],
            pair: ["S", "T"],
        },
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
            ranges: ["5..40 deg:70", "-400..-60 mm:4"],
            pair: ["S", "T"],
        },
    );
}
