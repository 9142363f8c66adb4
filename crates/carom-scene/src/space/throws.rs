//! Throws of a solid part on level ground.

use super::SpaceScene;
use crate::face_report::SolidFaceReport;
use crate::part_throws::{Thrown, read_ranges};
use crate::quantity::Quantity;
use crate::roll::spatial::{THROW_DIMENSIONS, Throw, lying, options_of_throws};
use carom_motion::spatial::{Friction, Options, State, Supports, World};
use carom_num::Vec3;
use carom_study::poses::{Plan, Poses, PosesError, sample, thrown_in_space};

/// A solid part that is thrown on level ground, in any attitude: z is up, the ground is z = 0.
///
/// # Example
/// A bar of 40 × 10 × 20 mm that is let go just above the ground lies on one of its two largest faces in most throws.
/// ```
/// use carom_scene::{SolidThrows, SpaceScene, Thrown};
/// use carom_study::poses::{Plan, Pose};
/// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
/// let scene = SpaceScene::parse("bar.toml", text)?;
/// let throws = SolidThrows::new(&scene, 0, ["1 mm", "0 m/s", "0 rad/s"]).unwrap();
/// let plan = Plan { dimensions: SolidThrows::DIMENSIONS, throws: 4, seed: 1 };
/// let found = throws.throws(&plan, || ()).unwrap();
/// let large = found.ends.iter().filter(|end| matches!(end.pose, Pose::Face(0 | 2)));
/// let share: f64 = large.map(|end| end.probability.share).sum();
/// assert!(share > 0.6, "{share}");
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug)]
pub struct SolidThrows<'s> {
    scene: &'s SpaceScene,
    plate: usize,
    world: World,
    options: Options,
    throw: Throw,
}

impl<'s> SolidThrows<'s> {
    /// Throws of the part of a scene on ground of the surface of one of its plates. `texts` are height, speed and spin rate, each with unit and perhaps a tolerance.
    ///
    /// # Errors
    /// Which of the texts are wrong, by their place, and why.
    pub fn new(scene: &'s SpaceScene, plate: usize, texts: [&str; 3]) -> Result<Self, Vec<(usize, String)>> {
        let [height, speed, spin_rate] = read_ranges(texts)?;
        let feeder = scene.feeder();
        let surface = feeder.plates.get(plate).map_or((0.0, 0.0), |p| (p.friction, p.restitution));
        let friction = Friction::new(surface.0).with_restitution(surface.1).with_law(feeder.law);
        let unfit = |message: String| vec![(0, message)];
        let world = World::new(feeder.part.body.clone(), Vec3::Z * -feeder.gravity);
        let world = world.map_err(|found| unfit(found.to_string()))?.with_friction(friction);
        let world = world.map_err(|found| unfit(found.to_string()))?;
        let options = options_of_throws(&world);
        Ok(Self { scene, plate, world, options, throw: Throw { height, speed, spin_rate, rise: 0.0 } })
    }

    /// The start of the throw at a point of the unit cube: every attitude and every axis of the spin is as probable as any other, height, speed and spin rate are within their
    /// tolerances; the speed is level. `None` at a point of another number of coordinates.
    pub fn release(&self, point: &[f64]) -> Option<State> {
        self.throw.release(self.world.body(), point)
    }

    /// The part at rest on one of its faces; `None` where there is no such face.
    pub fn resting_on(&self, face: usize) -> Option<State> {
        let normal = self.scene.feeder().part.faces.get(face)?.normal;
        Some(lying(self.world.body(), normal))
    }
}

impl Thrown for SolidThrows<'_> {
    type Scene = SpaceScene;
    type Face = SolidFaceReport;
    const DIMENSIONS: usize = THROW_DIMENSIONS;

    fn scene(&self) -> &SpaceScene {
        self.scene
    }

    fn plate(&self) -> usize {
        self.plate
    }

    fn surface(&self) -> (f64, f64) {
        self.scene.feeder().plates.get(self.plate).map_or((0.0, 0.0), |p| (p.friction, p.restitution))
    }

    fn ranges(&self) -> [&Quantity; 3] {
        [&self.throw.height, &self.throw.speed, &self.throw.spin_rate]
    }

    fn faces(&self) -> Vec<SolidFaceReport> {
        SolidFaceReport::of(self.scene)
    }

    fn throws(&self, plan: &Plan, done: impl Fn() + Sync) -> Result<Poses, PosesError> {
        let part = &self.scene.feeder().part;
        let faces: Vec<usize> = (0..part.faces.len()).collect();
        let below = |held: Supports| part.face_of(held.iter());
        let throw = |point: &[f64]| match self.release(point) {
            Some(release) => thrown_in_space((&self.world, &self.options), &release, below),
            None => carom_study::poses::Thrown::LOST,
        };
        sample(plan, throw, &faces, done)
    }
}
