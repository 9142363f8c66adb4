//! A body that rolls, rocks or pivots in the plane, followed and told: what `carom roll` says of it.

use super::MADE_BY;
use carom_figure::{LiveRoll, RollContact, RollFigure, RollStrike, View, live_roll, live_roll_view};
use carom_motion::MotionError;
use carom_scene::{RollProblem, RollReport, RollRun, RollStrikeReport};
use carom_words::number::with_sign;

/// A roll, and what a program is told of it.
///
/// # Example
/// ```
/// use carom::{scene::{RollKind, RollProblem}, tasks::roll::RollStudy};
/// let square = RollProblem::parse(RollKind::Prism, "square.toml", "sides = 4\nstrikes = 1", &[])?;
/// let study = RollStudy::of(square)?;
/// assert!(study.verdict().starts_with("strikes reached at"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct RollStudy {
    /// What rolls.
    pub problem: RollProblem,
    /// Its motion.
    pub run: RollRun,
    /// The same as data.
    pub report: RollReport,
}

impl RollStudy {
    /// Follows it.
    ///
    /// # Errors
    /// A fault of the numbers.
    pub fn of(problem: RollProblem) -> Result<Self, MotionError> {
        let run = problem.follow()?;
        Ok(Self::of_run(problem, run))
    }

    /// What a run that is there already says.
    pub fn of_run(problem: RollProblem, run: RollRun) -> Self {
        let report = RollReport::new(&problem, &run);
        Self { problem, run, report }
    }

    /// How it ends, and when.
    pub fn verdict(&self) -> String {
        format!("{} at {:.4} s", self.report.end.state, self.report.end.t_s)
    }

    /// Sentences on the law and the model.
    pub fn notes(&self) -> Vec<String> {
        let report = &self.report;
        let mut notes =
            vec![law(report), format!("Restitution {} after {}.", report.restitution, report.law)];
        notes.extend(report.accumulations.iter().map(|a| {
            format!(
                "From {:.5} s on the strikes follow each other without end; they were closed at their limit, {:.5} s.",
                a.from_s, a.to_s
            )
        }));
        notes
    }

    /// Its report, one HTML page.
    pub fn page(&self, name: &str) -> String {
        self.shown(name, carom_figure::roll_report)
    }

    /// A window around the motion of so many pixels.
    pub fn view(&self, size: [f64; 2]) -> View {
        self.shown("", |figure| live_roll_view(figure, size))
    }

    /// The report piece by piece, for a page that stays open.
    pub fn live(&self, view: &View) -> LiveRoll {
        self.shown("", |figure| live_roll(figure, view))
    }

    fn shown<T>(&self, title: &str, show: impl FnOnce(&RollFigure<'_>) -> T) -> T {
        let strikes: Vec<RollStrike> = self.report.strikes.iter().map(strike).collect();
        let problem = &self.problem;
        show(&RollFigure {
            title,
            verdict: &self.verdict(),
            lead: &lead(&self.report).join(" · "),
            notes: &self.notes(),
            world: &problem.world,
            obstacles: &problem.obstacles,
            unreached: &problem.unreached,
            start: problem.start,
            trace: &self.run.trace,
            strikes: &strikes,
            source: &problem.source,
            made_by: MADE_BY,
        })
    }
}

fn law(report: &RollReport) -> String {
    match report.friction {
        Some(friction) => format!("Friction {friction} after Coulomb, at every contact."),
        None => "The non-sliding law: a contact that keeps does not slide, whatever friction that takes."
            .to_owned(),
    }
}

fn strike(strike: &RollStrikeReport) -> RollStrike {
    let contacts = strike.contacts.iter().map(|c| RollContact {
        name: c.name.clone(),
        state: c.state.to_string(),
        impulse: [c.normal_impulse, c.tangential_impulse],
        velocity: [c.normal_velocity_m_s, c.slip_m_s],
    });
    RollStrike {
        time: strike.t_s,
        state: strike.state.clone(),
        words: strike.words.clone(),
        roll_rate: [strike.roll_rate_before_rad_s, strike.roll_rate_rad_s],
        velocity: [strike.velocity_before_m_s, strike.velocity_m_s],
        tilt: strike.tilt_rad,
        energy: [strike.energy_before, strike.energy_after],
        contacts: contacts.collect(),
        found: strike.end_states.iter().map(|end| end.hypothesis.clone()).collect(),
        rejected: strike.rejected.iter().map(|r| [r.hypothesis.clone(), r.because.clone()]).collect(),
    }
}

/// How many strikes, and what the first one is.
pub fn lead(report: &RollReport) -> Vec<String> {
    let strikes = match report.strikes.len() {
        0 => "no strike".to_owned(),
        1 => "one strike".to_owned(),
        n => format!("{n} strikes"),
    };
    let mut parts = vec![strikes];
    if let Some(first) = report.strikes.first() {
        let which = if report.strikes.len() > 1 { "first " } else { "" };
        parts.push(format!("{which}{}", first.state));
        parts.push(first.certainty().words());
        let change = 100.0 * (first.energy_after - first.energy_before) / first.energy_before;
        if change.is_finite() {
            parts.push(format!("{} % energy", with_sign(change, 1)));
        }
    }
    parts
}
