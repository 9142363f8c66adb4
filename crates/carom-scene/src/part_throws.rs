//! Throws of a part on level ground: on which face it comes to a feeder that nothing sorts before.

use crate::approximation::Approximation;
use crate::drawn::Drawn;
use crate::face_report::FaceReport;
use crate::grammar::kind::{LENGTH_OR_NONE, SPEED, SPIN_RATE};
use crate::grammar::read_quantity;
use crate::map_report::StudyRunReport;
use crate::node::{Node, Value};
use crate::quantity::{Kind, Quantity};
use crate::roll::spatial::ThrowRangeReport;
use crate::scene::Scene;
use crate::word::PoseWord;
use crate::yield_report::{ProbabilityReport, SpreadReport};
use carom_motion::planar::{Obstacle, Options, Pose as Place, State, Twist, World};
use carom_num::Vec2;
use carom_study::poses::{Plan, Pose, Poses, PosesError, sample, thrown_in_plane};
use carom_words::Words;
use carom_words::part::Names;
use schemars::JsonSchema;
use serde::Serialize;
use std::f64::consts::TAU;

/// Half the ground, in sizes of the part: what slides farther runs off it, and is said to move still.
const GROUND: f64 = 1e3;

/// A part that is thrown on level ground, in the plane or in space, in any attitude.
///
/// # Example
/// A rod has two faces, and lies on either.
/// ```
/// use carom_scene::{PartThrows, Scene, Thrown};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let throws = PartThrows::new(&scene, 0, ["50 mm", "0 m/s", "0 rad/s"]).unwrap();
/// assert_eq!((throws.faces().len(), throws.ranges()[0].value), (2, 0.05));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
pub trait Thrown: Sync {
    /// What the part is of.
    type Scene: Drawn;
    /// What is said of one of its faces.
    type Face;
    /// Coordinates of a throw.
    const DIMENSIONS: usize;
    /// What the part is of.
    fn scene(&self) -> &Self::Scene;
    /// The plate whose surface the ground has.
    fn plate(&self) -> usize;
    /// Friction and restitution of the ground.
    fn surface(&self) -> (f64, f64);
    /// Height of the lowest point above the ground \[m\], level speed [m/s] and spin [rad/s].
    fn ranges(&self) -> [&Quantity; 3];
    /// The faces of the part, by their numbers.
    fn faces(&self) -> Vec<Self::Face>;
    /// Throws the part; `done` is called after every throw. Every face is in the result, whether a throw comes to rest on it or not.
    ///
    /// # Errors
    /// [`PosesError`].
    fn throws(&self, plan: &Plan, done: impl Fn() + Sync) -> Result<Poses, PosesError>;
}

/// Reads height, speed and spin rate.
///
/// # Errors
/// Which of the texts are wrong, by their place, and why.
pub(crate) fn read_ranges(texts: [&str; 3]) -> Result<[Quantity; 3], Vec<(usize, String)>> {
    let mut wrong = vec![];
    let mut read = |place: usize, kind: Kind| {
        let node = Node { value: Value::Text(texts[place].to_owned()), span: 0..0 };
        let found = read_quantity("", &node, kind, None);
        let told =
            found.map_err(|list| wrong.extend(list.into_iter().map(|problem| (place, problem.message))));
        told.unwrap_or_else(|()| Quantity::default_of(0.0, kind))
    };
    let ranges = [read(0, LENGTH_OR_NONE), read(1, SPEED), read(2, SPIN_RATE)];
    if wrong.is_empty() { Ok(ranges) } else { Err(wrong) }
}

/// A part that is thrown on level ground in the plane, in any attitude.
///
/// # Example
/// A bar of 40 mm × 20 mm that is let go just above the ground lies on a long side in three throws of four.
/// ```
/// use carom_scene::{PartThrows, Scene, Thrown};
/// use carom_study::poses::{Plan, Pose};
/// let text = "[part]\nshape = \"box\"\nlength = \"40 mm\"\nheight = \"20 mm\"\nmass = 0.1\n[[plate]]\nslope = \"20 deg\"\n[contact]\nfriction = 0.4\nrestitution = 0\n[start]\nto_edge = 0.2\n";
/// let scene = Scene::parse("bar.toml", text)?;
/// let throws = PartThrows::new(&scene, 0, ["1 mm", "0 m/s", "0 rad/s"]).unwrap();
/// let plan = Plan { dimensions: PartThrows::DIMENSIONS, throws: 16, seed: 1 };
/// let found = throws.throws(&plan, || ()).unwrap();
/// let long = found.ends.iter().filter(|end| matches!(end.pose, Pose::Face(0 | 2)));
/// let share: f64 = long.map(|end| end.probability.share).sum();
/// assert!((0.65..0.8).contains(&share), "{share}");
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug)]
pub struct PartThrows<'s> {
    scene: &'s Scene,
    plate: usize,
    world: World,
    /// Of the lowest point above the ground \[m\].
    pub height: Quantity,
    /// Level speed, to either side \[m/s\].
    pub speed: Quantity,
    /// Spin, in either sense \[rad/s\].
    pub spin_rate: Quantity,
}

impl<'s> PartThrows<'s> {
    /// Throws of the part of a scene on ground of the surface of one of its plates. `texts` are height, speed and spin rate, each with unit and perhaps
    /// a tolerance: `50 ± 10 mm`.
    ///
    /// # Errors
    /// Which of the texts are wrong, by their place, and why.
    pub fn new(scene: &'s Scene, plate: usize, texts: [&str; 3]) -> Result<Self, Vec<(usize, String)>> {
        let [height, speed, spin_rate] = read_ranges(texts)?;
        let feeder = scene.feeder();
        let surface = feeder.plates.get(plate).map_or((0.0, 0.0), |p| (p.friction, p.restitution));
        let body = feeder.part.body.clone();
        let half = Vec2::new(GROUND * body.shape.size(), 0.0);
        let ground = Obstacle::new(-half, half, surface.0, surface.1);
        let world = World::of_one(Vec2::new(0.0, -feeder.gravity), body, vec![ground], feeder.law);
        Ok(Self { scene, plate, world, height, speed, spin_rate })
    }

    /// The start of the throw at a point of the unit cube: every attitude is as probable as any other, and so is either sense of speed and spin.
    pub fn release(&self, point: &[f64]) -> State {
        let &[attitude, height, speed, to_the_left, rate, backward] = point else { return State::default() };
        let turned = Place { angle: TAU * attitude, ..Place::default() };
        let above = self.world.bodies[0].shape.centre_height(turned.down());
        let centre = Vec2::new(0.0, self.height.at(height) + above);
        let either = |share: f64, size: f64| if share < 0.5 { -size } else { size };
        let velocity = Vec2::new(either(to_the_left, self.speed.at(speed)), 0.0);
        let spin = either(backward, self.spin_rate.at(rate));
        State { pose: Place { centre, ..turned }, twist: Twist { velocity, spin } }
    }
}

impl Thrown for PartThrows<'_> {
    type Scene = Scene;
    type Face = FaceReport;
    /// Attitude, height, speed and its sense, spin and its sense.
    const DIMENSIONS: usize = 6;

    fn scene(&self) -> &Scene {
        self.scene
    }

    fn plate(&self) -> usize {
        self.plate
    }

    fn surface(&self) -> (f64, f64) {
        let ground = &self.world.obstacles[0];
        (ground.friction, ground.restitution)
    }

    fn ranges(&self) -> [&Quantity; 3] {
        [&self.height, &self.speed, &self.spin_rate]
    }

    fn faces(&self) -> Vec<FaceReport> {
        FaceReport::of(&self.world.bodies[0].shape)
    }

    fn throws(&self, plan: &Plan, done: impl Fn() + Sync) -> Result<Poses, PosesError> {
        let options = Options::default();
        let faces: Vec<usize> = (0..self.world.bodies[0].shape.rests().len()).collect();
        sample(plan, |point| thrown_in_plane((&self.world, &options), &self.release(point)), &faces, done)
    }
}

/// A way in which throws of a part end.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PartEndReport {
    /// How.
    pub end: PoseWord,
    /// The face that is down; null of the other ends.
    pub face: Option<usize>,
    /// With what probability a throw ends so.
    pub probability: ProbabilityReport,
    /// Of the throws that come to rest on a face, the share on this one, with Wilson's interval of independent throws; null of other ends.
    pub of_resting: Option<ProbabilityReport>,
}

/// The faces of a part, and on which of them it comes to rest when it is thrown.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "carom faces")]
pub struct FacesReport<Face = FaceReport> {
    /// Name of the scene.
    pub scene: String,
    /// What was read from the part's file, taken from tables, or assumed; absent where there is nothing to say.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub notes: Vec<String>,
    /// How the computed part differs from the drawn one; absent where it does not.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub approximations: Vec<Approximation>,
    /// The faces, by their numbers.
    pub faces: Vec<Face>,
    /// The plate whose surface the ground has.
    pub plate: String,
    /// Friction of the ground.
    pub friction: f64,
    /// Restitution of the ground.
    pub restitution: f64,
    /// Law of restitution.
    #[schemars(extend("enum" = ["poisson", "stronge", "newton"]))]
    pub law: &'static str,
    /// Of the lowest point above the ground [m].
    pub height_m: ThrowRangeReport,
    /// Level speed, to either side [m/s].
    pub speed_m_s: ThrowRangeReport,
    /// Spin, in either sense [rad/s].
    pub spin_rate_rad_s: ThrowRangeReport,
    /// Throws, in 16 repetitions.
    pub throws: u64,
    /// What every random number comes from.
    pub seed: u64,
    /// Every way in which throws end; their counts add up to all of them. Faces come first.
    pub ends: Vec<PartEndReport>,
    /// With what probability a throw comes to rest on a face.
    pub resting: ProbabilityReport,
    /// When those come to rest [s].
    pub time_s: Option<SpreadReport>,
    /// Their strikes.
    pub strikes: Option<SpreadReport>,
    /// What it took.
    pub run: StudyRunReport,
}

impl<Face> FacesReport<Face> {
    /// The report of a sampling.
    pub fn new(throws: &impl Thrown<Face = Face>, plan: &Plan, found: &Poses, run: StudyRunReport) -> Self {
        let scene = throws.scene();
        let [height, speed, spin_rate] = throws.ranges();
        let (friction, restitution) = throws.surface();
        // Every face is among the ends, and so at its own place there.
        let ends = found.ends.iter().map(|posed| PartEndReport {
            end: PoseWord(posed.pose),
            face: if let Pose::Face(face) = posed.pose { Some(face) } else { None },
            probability: posed.probability.into(),
            of_resting: posed.of_resting.map(Into::into),
        });
        Self {
            scene: scene.name().to_owned(),
            notes: scene.notes().to_vec(),
            approximations: scene.approximations().to_vec(),
            faces: throws.faces(),
            plate: scene.feeder().given(throws.plate()).to_owned(),
            friction,
            restitution,
            law: scene.law().word(),
            height_m: height.into(),
            speed_m_s: speed.into(),
            spin_rate_rad_s: spin_rate.into(),
            throws: found.throws,
            seed: plan.seed,
            ends: ends.collect(),
            resting: found.resting.into(),
            time_s: found.time.as_ref().map(Into::into),
            strikes: found.impacts.as_ref().map(Into::into),
            run,
        }
    }
}
