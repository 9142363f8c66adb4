//! Table 1 of the gravity-impact feeder's paper: its quantities in its letters and frames, of any run on two plates.
//!
//! The frame of the first three stages has its origin at the upper plate's free edge, x along the plate downhill and y down through it; φ
//! turns x towards y. r and φ are polar: v_r and v_φ are along the part and across it. τ points down the lower plate, n out of it.

use crate::failure::ValidationError;
use crate::value::Values;
use carom_feeder::{Feeder, Run, Stage, StageName};
use carom_motion::planar::{
    State,
    trace::{Impact, ImpactContact},
};
use carom_num::Vec2;
use carom_scene::{Scene, angle_to_normal};

/// Name of the result.
pub const NAME: &str = "feeder_table_1";

/// The two cases: the scenes that are validated.
const CASES: [(&str, &str); 2] = [
    ("case_1", include_str!("../../../../validation/feeder_table_1/case_1.toml")),
    ("case_2", include_str!("../../../../validation/feeder_table_1/case_2.toml")),
];

/// Each stage by the key under which its rows stand, with its heading.
pub const STAGES: [(&str, &str); 5] = [
    ("slide", "first stage: sliding"),
    ("tip", "second stage: tipping until lift-off"),
    ("flight", "third stage: flight"),
    ("strike", "fourth stage: impact"),
    ("fifth", "fifth stage: until the part lies down"),
];

/// Letters of each stage, as the keys name them.
const LETTERS: [(&str, &[&str]); 5] = [
    ("slide", &["t", "v"]),
    ("tip", &["r0", "phi0", "vr0", "vphi0", "spin0", "t", "r1", "phi1", "vr1", "vphi1", "spin1"]),
    ("flight", &["x0", "y0", "vx0", "vy0", "spin0", "t", "x1", "y1", "phi1", "vx1", "vy1"]),
    (
        "strike",
        &[
            "phi", "tau", "n", "v_tau0", "v_n0", "u_tau0", "u_n0", "type", "v_tau1", "v_n1", "spin1",
            "u_tau1", "u_n1",
        ],
    ),
    ("fifth", &["t", "spin", "v_tau", "v_n"]),
];

/// The paper's frames for a feeder.
#[derive(Clone, Copy, Debug)]
pub struct Frames<'a> {
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
    /// `None` for a feeder that does not have two plates.
    pub fn new(feeder: &'a Feeder, run: &'a Run) -> Option<Self> {
        let [first, second] = feeder.plates.as_slice() else { return None };
        let x = (first.edge - first.uphill).unit()?;
        let tau = (second.edge - second.uphill).unit()?;
        let down = |along: Vec2| {
            let right = along.turned_right();
            if right.y < 0.0 { right } else { -right }
        };
        let (upper, lower) = ([x, down(x)], [tau, -down(tau)]);
        let sense = if upper[1].dot(x.turned_left()) > 0.0 { 1.0 } else { -1.0 };
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

    /// The value of a row, `stage.letter` (without the case), in SI and degrees.
    ///
    /// `None` where the run has no such stage.
    pub fn value(&self, key: &str) -> Option<f64> {
        let (stage, letter) = key.split_once('.')?;
        let value = match stage {
            "slide" => self.slide(letter),
            "tip" => self.tip(letter),
            "flight" => self.flight(letter),
            "strike" => self.struck(letter),
            _ => self.fifth(letter),
        }?;
        Some(if letter.starts_with("phi") { value.to_degrees() } else { value })
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
        let state = if letter.ends_with('0') { &stage.start } else { &stage.end };
        let [along, across] = self.polar(state)?;
        Some(match letter.trim_end_matches(['0', '1']) {
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

/// Runs both cases.
pub(crate) fn compute() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for (case, text) in CASES {
        let scene =
            Scene::parse(&format!("{case}.toml"), text).map_err(|e| ValidationError::input(case, e))?;
        let run = scene.feeder().run().map_err(|e| ValidationError::engine(case, e))?;
        let frames = Frames::new(scene.feeder(), &run)
            .ok_or_else(|| ValidationError::missing(format!("{case}: a second plate")))?;
        for (stage, letters) in LETTERS {
            for letter in letters {
                let key = format!("{stage}.{letter}");
                let value =
                    frames.value(&key).ok_or_else(|| ValidationError::missing(format!("{case}: {key}")))?;
                values.put(format!("{case}.{key}"), value);
            }
        }
    }
    Ok(values)
}
