//! One impact in the plane, resolved and told: what `carom impact` says of it.

mod figure;
mod planes;
pub mod space;
pub mod words;

use carom_figure::{ImpactFigure, ImpactPicture, ImpactSketch, ImpulsePlane, JointWalk};
use carom_impact::Law;
use carom_impact::planar::forces::Applied;
use carom_scene::{
    EndReport, ForceAnswerReport, ForceContactReport, ForceMotionReport, ImpactAnswer, ImpactAnswerReport,
    ImpactProblem, Problems,
};
use carom_words::Words;
use carom_words::number::ascii;

/// An impact, its answer, and what a program is told of it.
///
/// # Example
/// ```
/// use carom::tasks::impact::ImpactStudy;
/// let ball = "body = { mass = 2, inertia = 0.4, velocity = [0, -3] }\ncontact = [{ point = [0, -1], normal = [0, 1], friction = 0.3 }]";
/// let study = ImpactStudy::of(carom::scene::ImpactProblem::parse("ball.toml", ball)?);
/// assert!(study.page("ball", ball).contains("The walk in impulse space"));
/// # Ok::<(), carom::scene::Problems>(())
/// ```
pub struct ImpactStudy {
    /// The impact.
    pub problem: ImpactProblem,
    /// Its answer.
    pub answer: ImpactAnswer,
    /// The same as data.
    pub report: ImpactAnswerReport,
}

/// What follows under forces, where something is applied to a body.
#[derive(Clone, Debug, PartialEq)]
pub struct UnderForces {
    /// In a few words.
    pub headline: String,
    /// Motions that all laws allow, each with what its contacts take.
    pub motions: Vec<[String; 2]>,
    /// What rejects the others.
    pub rejected: Vec<[String; 2]>,
}

/// What another law, or another way to share, makes of an impact.
#[derive(Clone, Debug, PartialEq)]
pub struct Beside {
    /// Its name.
    pub name: String,
    /// Where it ends, or why it has no answer.
    pub said: String,
    /// Kinetic energy before and after [J], where bodies are known.
    pub energy: Option<[f64; 2]>,
    /// True for the one that the impact asks for.
    pub asked: bool,
}

impl ImpactStudy {
    /// Resolves an impact.
    pub fn of(problem: ImpactProblem) -> Self {
        let answer = problem.solve();
        let report = ImpactAnswerReport::new(&problem, &answer);
        Self { problem, answer, report }
    }

    /// Everything that its report shows; `source` is the file as written.
    pub fn figure(&self, title: &str, source: &str) -> ImpactFigure {
        figure::figure(self, title, source)
    }

    /// Its report, one HTML page.
    pub fn page(&self, title: &str, source: &str) -> String {
        carom_figure::impact_report(&self.figure(title, source))
    }

    /// The files that `carom impact` writes, by their names; `title` is the name of its file without what comes after the point.
    ///
    /// # Errors
    /// A result that is not JSON, which none is.
    pub fn files(&self, title: &str, source: &str) -> Result<Vec<(String, String)>, serde_json::Error> {
        let mut files = vec![];
        match self.joint() {
            Some(walk) => files.push(("impulse-walk.svg".to_owned(), carom_figure::joint_svg(&walk))),
            None => files.extend(self.planes().iter().map(|(name, plane)| {
                (format!("impulse-plane-{}.svg", plain(name)), carom_figure::impulse_svg(plane))
            })),
        }
        files.push(("impact.json".to_owned(), format!("{}\n", serde_json::to_string_pretty(&self.report)?)));
        files.push(("report.html".to_owned(), self.page(title, source)));
        Ok(files)
    }

    /// The bodies before it, as a picture; `None` where only the operator is known.
    pub fn sketch(&self) -> Option<ImpactSketch> {
        figure::sketch(&self.problem)
    }

    /// The walk of several contacts as one picture; `None` where there is one contact, or no walk.
    pub fn joint(&self) -> Option<JointWalk> {
        planes::joint(&self.problem, &self.answer)
    }

    /// The impulse plane of each contact.
    pub fn planes(&self) -> Vec<(String, ImpulsePlane)> {
        planes::planes(&self.problem, &self.answer)
    }

    /// The walk in one picture.
    pub fn picture(&self) -> Option<ImpactPicture> {
        let alone = || self.planes().into_iter().next().map(|(_, plane)| ImpactPicture::Plane(plane));
        self.joint().map(ImpactPicture::Walk).or_else(alone)
    }

    /// The bodies at the beginning and after each stage of the walk, or at its end where it has no stages: velocity [m/s] and spin [rad/s] of
    /// each.
    pub fn motion(&self) -> Vec<Vec<([f64; 2], f64)>> {
        let count = self.problem.names.len();
        let walk = self.answer.walk();
        let stages = walk.map(|walk| walk.stages.as_slice()).unwrap_or_default();
        let whole = walk.filter(|_| stages.is_empty()).map(|walk| &walk.outcome.impulse);
        let impulses = stages.iter().map(|stage| &stage.end.impulse).chain(whole);
        let impulses = impulses.map(|impulse| impulse.get(..count).unwrap_or_default());
        std::iter::once([].as_slice()).chain(impulses).map(|impulse| self.bodies_after(impulse)).collect()
    }

    fn bodies_after(&self, impulse: &[[f64; 2]]) -> Vec<([f64; 2], f64)> {
        if let Some((velocity, spin)) = self.problem.body_after(impulse) {
            return vec![([velocity.x, velocity.y], spin)];
        }
        let Some(group) = &self.problem.group else { return vec![] };
        let after = if impulse.is_empty() { Ok(group.bodies.clone()) } else { group.after(impulse) };
        after.unwrap_or_default().iter().map(|body| ([body.velocity.x, body.velocity.y], body.spin)).collect()
    }

    /// What every law of restitution makes of it.
    pub fn laws(&self) -> Vec<Beside> {
        let one = |law: &Law| {
            let other = Self::of(ImpactProblem { law: *law, ..self.problem.clone() });
            let asked = *law == self.problem.law;
            let used = other.report.law.0;
            let name = if used == *law {
                law.word().to_owned()
            } else {
                format!("{} (here {})", law.word(), used.word())
            };
            beside(name, words::shown(&other.report), other.report.not_staged.as_deref(), asked)
        };
        Law::ALL.iter().map(one).collect()
    }

    /// What follows at this instant under the forces that are written, the weight among them; `None` where nothing is applied.
    ///
    /// # Errors
    /// Contacts that do not touch.
    pub fn under_forces(&self, file: &str) -> Result<Option<UnderForces>, Problems> {
        if self.problem.applied.iter().all(|applied| *applied == Applied::default()) {
            return Ok(None);
        }
        let answer = self.problem.under_forces(file)?;
        let report = ForceAnswerReport::new(&self.problem, &answer);
        let forces = |c: &ForceContactReport| {
            format!("{}: N = {} N, T = {} N", c.name, ascii(c.normal_force, 4), ascii(c.tangential_force, 4))
        };
        let motion = |motion: &ForceMotionReport| {
            let all: Vec<String> = motion.contacts.iter().map(forces).collect();
            [motion.hypothesis.clone(), all.join("; ")]
        };
        Ok(Some(UnderForces {
            headline: words::forces_headline(&report, &answer.certainty()),
            motions: report.solutions.iter().map(motion).collect(),
            rejected: report.rejected.iter().map(|r| [r.hypothesis.clone(), r.because.clone()]).collect(),
        }))
    }

    /// What every way to share makes of it; empty where one contact closes.
    pub fn sharings(&self) -> Vec<Beside> {
        let asked = words::convention(&self.problem);
        let shared = self.report.sharing.iter();
        shared
            .map(|one| {
                beside(
                    one.sharing.to_string(),
                    one.end.as_ref(),
                    one.because.as_deref(),
                    one.sharing.0 == asked,
                )
            })
            .collect()
    }
}

/// A contact's name as part of a file's name.
fn plain(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect()
}

fn beside(name: String, end: Option<&EndReport>, because: Option<&str>, asked: bool) -> Beside {
    let said = end.map_or_else(|| because.unwrap_or_default().to_owned(), words::velocities);
    let energy = end.and_then(|end| Some([end.energy_before?, end.energy_after?]));
    Beside { name, said, energy, asked }
}
