//! Table 1 of the gravity-impact feeder's paper, beside our values in its letters and frames.
//!
//! The frame of the first three stages has its origin at the upper plate's free edge, x along the plate downhill and y down through it; φ
//! turns x towards y. r and φ are polar: v_r and v_φ are along the part and across it. τ points down the lower plate, n out of it.

mod compare;
mod errata;
mod printed;

use crate::side_by_side::{Done, aligned};
use carom_feeder::{Feeder, Run, Stage, StageName};
use carom_figure::words::{forward_sense, slope};
use carom_motion::planar::{
    State,
    trace::{Impact, ImpactContact},
};
use carom_num::Vec2;
use carom_scene::{Scene, angle_to_normal};
use compare::{Compared, compare};
use printed::{Case, TABLE};
use std::f64::consts::PI;

/// The paper's frames for a feeder.
struct Frames<'a> {
    feeder: &'a Feeder,
    run: &'a Run,
    edge: Vec2,
    /// x and y of the first three stages.
    upper: [Vec2; 2],
    /// τ and n.
    lower: [Vec2; 2],
    /// +1 or −1: makes spins and angles count from x towards y.
    sense: f64,
}

impl<'a> Frames<'a> {
    fn new(feeder: &'a Feeder, run: &'a Run) -> Option<Self> {
        let [first, second] = feeder.plates.as_slice() else { return None };
        let x = (first.edge - first.uphill).unit()?;
        let tau = (second.edge - second.uphill).unit()?;
        let sense = forward_sense(feeder);
        let down = |along: Vec2| {
            let right = along.turned_right();
            if right.y < 0.0 { right } else { -right }
        };
        let (upper, lower) = ([x, down(x)], [tau, -down(tau)]);
        Some(Self { feeder, run, edge: first.edge, upper, lower, sense })
    }

    fn stage(&self, name: StageName) -> Option<&Stage> {
        self.run.stages.iter().find(|stage| stage.name == name)
    }

    /// The first impact on the lower plate.
    fn strike(&self) -> Option<(&Impact, &ImpactContact)> {
        let struck = |impact: &&Impact| impact.contacts.first().is_some_and(|c| c.obstacle == 1);
        let impact = self.run.trace.impacts.iter().find(struck)?;
        Some((impact, impact.contacts.first()?))
    }

    /// Angle from the upper plate to the part, x towards y [rad].
    fn phi(&self, state: &State) -> Option<f64> {
        let start = self.run.stages.first()?.start.pose.angle;
        Some(self.sense * (state.pose.angle - start))
    }

    /// Along the part and across it, in the sense of φ.
    fn polar(&self, state: &State) -> Option<[Vec2; 2]> {
        let phi = self.phi(state)?;
        let turn = Vec2::at_angle(phi);
        let [x, y] = self.upper;
        Some([x * turn.x + y * turn.y, y * turn.x - x * turn.y])
    }

    /// The value of a row.
    fn value(&self, key: &str) -> Option<f64> {
        let (stage, letter) = key.split_once('.')?;
        match stage {
            "slide" => self.slide(letter),
            "tip" => self.tip(letter),
            "flight" => self.flight(letter),
            "strike" => self.struck(letter),
            _ => self.fifth(letter),
        }
    }

    fn slide(&self, letter: &str) -> Option<f64> {
        let stage = self.stage(StageName::Slide)?;
        Some(match letter {
            "t" => stage.end_time - stage.start_time,
            _ => stage.end.twist.velocity.dot(self.upper[0]),
        })
    }

    fn tip(&self, letter: &str) -> Option<f64> {
        let stage = self.stage(StageName::Tip)?;
        let [letter, end] = [letter.trim_end_matches(['0', '1']), letter].map(str::to_owned);
        let state = if end.ends_with('0') { &stage.start } else { &stage.end };
        let [along, across] = self.polar(state)?;
        Some(match letter.as_str() {
            "t" => stage.end_time - stage.start_time,
            "r" => (state.pose.centre - self.edge).dot(along),
            "phi" => self.phi(state)?,
            "vr" => state.twist.velocity.dot(along),
            "vphi" => state.twist.velocity.dot(across),
            _ => self.sense * state.twist.spin,
        })
    }

    fn flight(&self, letter: &str) -> Option<f64> {
        let stage = self.stage(StageName::Flight)?;
        let state = if letter.ends_with('0') { &stage.start } else { &stage.end };
        let (place, velocity) = (state.pose.centre - self.edge, state.twist.velocity);
        Some(match letter.trim_end_matches(['0', '1']) {
            "t" => stage.end_time - stage.start_time,
            "x" => place.dot(self.upper[0]),
            "y" => place.dot(self.upper[1]),
            "phi" => self.phi(state)?,
            "vx" => velocity.dot(self.upper[0]),
            "vy" => velocity.dot(self.upper[1]),
            _ => self.sense * state.twist.spin,
        })
    }

    fn struck(&self, letter: &str) -> Option<f64> {
        let (impact, contact) = self.strike()?;
        let [tau, normal] = self.lower;
        let along = contact.normal.turned_right().dot(tau);
        let place = impact.pose.centre - contact.point;
        Some(match letter {
            "phi" => angle_to_normal(self.feeder, impact)?,
            "tau" => place.dot(tau),
            "n" => place.dot(normal),
            "v_tau0" => impact.before.velocity.dot(tau),
            "v_n0" => impact.before.velocity.dot(normal),
            "u_tau0" => contact.before.slip * along,
            "u_n0" => contact.before.normal,
            "type" => f64::from(impact.kind?.number()),
            "v_tau1" => impact.after.velocity.dot(tau),
            "v_n1" => impact.after.velocity.dot(normal),
            "spin1" => self.sense * impact.after.spin,
            "u_tau1" => contact.after.slip * along,
            _ => contact.after.normal,
        })
    }

    /// From the strike until the part is flat, just before it lies down.
    fn fifth(&self, letter: &str) -> Option<f64> {
        let (strike, _) = self.strike()?;
        let flat = self.run.landings.iter().find(|landing| landing.plate == 1)?.flat?;
        let last = self.run.trace.impacts.iter().rfind(|impact| impact.time <= flat)?;
        let [tau, normal] = self.lower;
        Some(match letter {
            "t" => flat - strike.time,
            "spin" => self.sense * last.before.spin,
            "v_tau" => last.before.velocity.dot(tau),
            _ => last.before.velocity.dot(normal),
        })
    }
}

/// Which of the paper's cases a scene is.
fn case(scene: &Scene) -> Option<Case> {
    let first = scene.feeder().plates.first()?;
    let [along, normal] = scene.paper_line()?;
    let degrees = slope(first.uphill, first.edge) * 180.0 / PI;
    let near = |a: f64, b: f64| (a - b).abs() < 1e-6;
    [(Case::One, 15.0, 0.347, 0.2), (Case::Two, 10.0, 0.428, 0.3)]
        .into_iter()
        .find(|(_, upper, x, y)| near(degrees, *upper) && near(along, *x) && near(normal, *y))
        .map(|(case, ..)| case)
}

/// One line of the table with ours beside it; a new stage has its heading.
struct Line {
    heading: Option<&'static str>,
    letter: &'static str,
    unit: &'static str,
    ours: String,
    compared: Option<Compared>,
}

fn lines(scene: &Scene, run: &Run) -> Vec<Line> {
    let Some(frames) = Frames::new(scene.feeder(), run) else { return vec![] };
    let case = case(scene);
    let line = |row: &'static printed::Row| {
        let ours =
            frames.value(row.key).map(|value| if row.unit == "deg" { value * 180.0 / PI } else { value });
        let digits = if row.unit.is_empty() { 0 } else { 4 };
        Line {
            heading: row.opens.then(|| row.stage()),
            letter: row.letter,
            unit: row.unit,
            ours: ours.map_or("-".to_owned(), |value| crate::table::fixed(value, digits)),
            compared: case.zip(ours).map(|(case, ours)| compare(&row.entry(case), ours, digits)),
        }
    };
    TABLE.iter().map(line).collect()
}

fn title(scene: &Scene) -> String {
    match case(scene) {
        Some(case) => format!("Table 1, case {}", case.number()),
        None => "Table 1's quantities (no case of the paper)".to_owned(),
    }
}

/// The table for a terminal; only ours where the scene is none of the paper's two cases.
pub(crate) fn text(scene: &Scene, run: &Run) -> String {
    let lines = lines(scene, run);
    let head = ["", "unit", "printed", "ours", "difference", "verdict"].map(str::to_owned).to_vec();
    let values = lines.iter().map(|line| {
        let [printed, difference, verdict] = line.compared.as_ref().map_or_else(Default::default, |found| {
            let reason = if found.reason.is_empty() { String::new() } else { format!(": {}", found.reason) };
            [found.printed.to_owned(), found.difference.clone(), format!("{}{reason}", found.verdict)]
        });
        vec![line.letter.to_owned(), line.unit.to_owned(), printed, line.ours.clone(), difference, verdict]
    });
    let table = aligned(&std::iter::once(head).chain(values).collect::<Vec<_>>());
    let mut rows = table.lines();
    let mut text = format!("{}\n\n{}\n", title(scene), rows.next().unwrap_or_default());
    for (line, row) in lines.iter().zip(rows) {
        if let Some(heading) = line.heading {
            text.push_str(&format!("  {heading}\n"));
        }
        text.push_str(&format!("{row}\n"));
    }
    text
}

/// The tables of several scenes as a page in Markdown, with the errata.
pub(crate) fn markdown(done: &[Done]) -> String {
    let mut page = errata::HEAD.to_owned();
    for (scene, run) in done {
        page.push_str(&format!("\n## {}\n", title(scene)));
        for line in lines(scene, run) {
            if let Some(heading) = line.heading {
                page.push_str(&format!(
                    "\n### {}\n\n| | unit | printed | ours | difference | verdict | why |\n|---|---|---|---|---|---|---|\n",
                    capital(heading)
                ));
            }
            let (printed, difference, verdict, reason) = match &line.compared {
                Some(found) => {
                    (found.printed, found.difference.as_str(), found.verdict, found.reason.as_str())
                }
                None => ("", "", "", ""),
            };
            page.push_str(&format!(
                "| {} | {} | {printed} | {} | {difference} | {verdict} | {reason} |\n",
                line.letter, line.unit, line.ours
            ));
        }
    }
    page.push_str(errata::ERRATA);
    page
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}
