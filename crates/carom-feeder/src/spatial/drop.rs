//! A feeder made ready, and its run.

use super::course::Watcher;
use super::feeder::{CrossSection, Feeder, Plate, Start, Wall, WallForm};
use super::run::Run;
use super::sheets::obstacle;
use crate::check::{Findings, Of};
use crate::drop::RunError;
use crate::feeder::FeederProblem;
use crate::tolerance::{CROSSES_START, FARTHEST, NO_LENGTH, ON_ONE_LINE, OPPOSITE, V_ANGLES, VERTICAL};
use carom_motion::spatial::{Friction, Options, State, Supports, Touch, World};
use carom_num::elementary::{atan2, sin};
use carom_num::{Rotation, Vec3};
use std::f64::consts::PI;

/// Strikes after which a run ends: so many, or so many times the square of the corners of a face.
const MOST_STRIKES: u64 = 5_000;
const WOBBLES: u64 = 10;
/// Steps after which it ends, for each of these strikes.
const STEPS_A_STRIKE: u64 = 10;

/// A feeder that was checked and turned into a world, ready for any number of runs.
#[derive(Clone, Debug)]
pub struct Prepared<'f> {
    pub(super) feeder: &'f Feeder,
    pub(super) world: World,
    pub(super) start: State,
    /// For each obstacle of the world the plate or wall that it is of: plates first, then walls.
    pub(super) owners: Vec<usize>,
    pub(super) options: Options,
}

impl Feeder {
    /// Checks the feeder and makes it ready to run.
    ///
    /// # Errors
    /// [`RunError::Problems`] with every problem found.
    pub fn prepare(&self, options: Options) -> Result<Prepared<'_>, RunError> {
        let problems = self.problems();
        if !problems.is_empty() {
            return Err(RunError::Problems(problems));
        }
        let (world, owners) = self.world().map_err(|found| RunError::Problems(vec![found]))?;
        let start = self.start_state();
        let spare = CROSSES_START * world.body().reach();
        let mut crossing: Vec<usize> =
            world.reaches_into(&start, spare).into_iter().map(|(obstacle, _)| owners[obstacle]).collect();
        crossing.dedup();
        if !crossing.is_empty() {
            let path = |owner: usize| FeederProblem::CrossesStart { path: self.path(owner) };
            return Err(RunError::Problems(crossing.into_iter().map(path).collect()));
        }
        Ok(Prepared { feeder: self, world, start, owners, options })
    }

    /// Runs the feeder and keeps everything: stages, impacts, samples.
    ///
    /// # Errors
    /// As [`Feeder::prepare`]; [`RunError::Motion`] for a fault of the numbers.
    pub fn run(&self) -> Result<Run, RunError> {
        self.prepare(self.options())?.run()
    }

    /// Runs the feeder without samples and stages: for its outcome and landings.
    ///
    /// # Errors
    /// As [`Feeder::run`].
    pub fn run_untraced(&self) -> Result<Run, RunError> {
        self.prepare(self.options())?.run_untraced()
    }

    /// Budgets of a run: what chatters longer than this never comes to lie flat. A part that wobbles to rest on a round face strikes with its corners by turns, some n² times of n corners.
    pub(crate) fn options(&self) -> Options {
        let corners = self.part.faces.iter().map(|face| face.corners.len() as u64).max().unwrap_or_default();
        let most_impacts = MOST_STRIKES.max(WOBBLES * corners * corners);
        Options {
            most_time: 60.0,
            most_steps: STEPS_A_STRIKE * most_impacts,
            most_impacts,
            ..Options::default()
        }
    }

    /// The name of a plate or wall: plates first, then walls.
    pub fn obstacle_name(&self, owner: usize) -> &str {
        let wall = || owner.checked_sub(self.plates.len()).and_then(|i| self.walls.get(i));
        self.plates.get(owner).map_or_else(|| wall().map_or("", |wall| &wall.name), |plate| &plate.name)
    }

    fn path(&self, owner: usize) -> String {
        let wall = owner.checked_sub(self.plates.len()).and_then(|i| self.walls.get(i));
        format!("{}.{}", wall.map_or("plate", Wall::kind), self.obstacle_name(owner))
    }

    /// The world the part moves in, and of which plate or wall each of its obstacles is.
    fn world(&self) -> Result<(World, Vec<usize>), FeederProblem> {
        let size = self.part.body.reach();
        let (mut obstacles, mut owners) = (vec![], vec![]);
        let flat = |path: &str| FeederProblem::NoLength { path: path.to_owned() };
        for (owner, plate) in self.plates.iter().enumerate() {
            for sheet in plate.sheets(size) {
                let found = obstacle(sheet).ok_or_else(|| flat(&self.path(owner)))?;
                obstacles.push(found.with_friction(plate.friction).with_restitution(plate.restitution));
                owners.push(owner);
            }
        }
        for (i, wall) in self.walls.iter().enumerate() {
            let owner = self.plates.len() + i;
            obstacles.push(wall.obstacle(size).ok_or_else(|| flat(&self.path(owner)))?);
            owners.push(owner);
        }
        let unfit = |why: String| FeederProblem::World { why };
        let friction = Friction::new(0.0).with_law(self.law);
        let world = World::new(self.part.body.clone(), Vec3::Y * -self.gravity);
        let world = world.map_err(|why| unfit(why.to_string()))?.with_friction(friction);
        let world = world.map_err(|why| unfit(why.to_string()))?.among(obstacles);
        Ok((world.map_err(|why| unfit(why.to_string()))?, owners))
    }

    /// Place, attitude and motion at the start: lying flat on the first plate; at the origin where there is none.
    pub fn start_state(&self) -> State {
        let still =
            State { centre: Vec3::ZERO, attitude: Rotation::NONE, velocity: Vec3::ZERO, spin: Vec3::ZERO };
        let Some(plate) = self.plates.first() else { return still };
        let carrying = plate.carrying();
        let Some(axes) = carrying.first() else { return still };
        let Start { to_edge, aside, turn, speed, face } = self.start;
        let Some(face) = self.part.faces.get(face) else { return still };
        let edge = Vec3::new(plate.edge.x, plate.edge.y, 0.0);
        let foot = edge - axes.downhill * to_edge + axes.across * aside;
        // The drawing's axes turned into the plate's: first its slope, about z, then its roll, then the turn of the part on it.
        let right = axes.up.cross(axes.across);
        let on_plate = rotation_to([right, axes.up, axes.across]);
        let attitude = Rotation::by(axes.up * turn).after(on_plate).after(laid_down(face.normal));
        let centre = foot + axes.up * face.depth;
        let lying = State { centre, attitude, velocity: axes.downhill * speed, spin: Vec3::ZERO };
        // In a groove it is pushed down its flank, which is across it, against the other one.
        let pushed = carrying
            .get(1)
            .map_or(0.0, |other| self.reaches(&lying, edge, -other.up) / other.up.dot(axes.across));
        State { centre: centre + axes.across * pushed, ..lying }
    }

    /// How wide the first plate must be between its side walls for the part where it starts \[m\].
    pub fn width_at_start(&self) -> f64 {
        let first = self.plates.first().and_then(|plate| Some((plate.edge, plate.axes()?.across)));
        first.map_or(0.0, |(edge, across)| self.between_at_start(Vec3::new(edge.x, edge.y, 0.0), across))
    }

    /// The same of a groove, whose middle is the plane of the drawing \[m\].
    pub fn groove_at_start(&self) -> f64 {
        self.between_at_start(Vec3::ZERO, Vec3::Z)
    }

    fn between_at_start(&self, middle: Vec3, across: Vec3) -> f64 {
        let start = self.start_state();
        2.0 * self.reaches(&start, middle, across).max(self.reaches(&start, middle, -across))
    }

    /// How far the part reaches along a direction, from a place on \[m\].
    fn reaches(&self, state: &State, from: Vec3, along: Vec3) -> f64 {
        let body = &self.part.body;
        let beyond = body.supports().iter().map(|corner| (state.place(*corner) - from).dot(along));
        beyond.fold(f64::NEG_INFINITY, f64::max) + body.rounding().unwrap_or_default()
    }

    /// All that is wrong with the numbers.
    fn problems(&self) -> Vec<FeederProblem> {
        let mut found = Findings::default();
        let size = self.part.body.reach();
        found.demand(self.gravity.is_finite() && self.gravity > 0.0, "gravity", self.gravity, "above 0 m/s²");
        for plate in &self.plates {
            self.plate_problems(&mut found, plate, size);
        }
        for wall in &self.walls {
            let of = Of { kind: wall.kind(), name: &wall.name };
            match wall.form {
                WallForm::Across { from, to, edge_radius } => {
                    found.segment(of, from, to, size);
                    found.edge_radius(of, edge_radius, (to - from).norm(), &self.part.body);
                }
                WallForm::Pin { ends, radius } => found.pin(of, ends, radius, &self.part.body),
                WallForm::Beside { z } => {
                    found.demand(z.is_finite() && z != 0.0, of, z, "a number but 0");
                }
            }
            found.surface(of, wall.friction, wall.restitution);
        }
        self.start_problems(&mut found);
        found.problems
    }

    fn plate_problems(&self, found: &mut Findings, plate: &Plate, size: f64) {
        let of = Of { kind: "plate", name: &plate.name };
        found.segment(of, plate.uphill, plate.edge, size);
        found.surface(of, plate.friction, plate.restitution);
        let width = plate.width.unwrap_or(size);
        let wide = width > NO_LENGTH * size && width <= FARTHEST * size;
        found.demand(wide, of.key("width"), width, "above 0, and at most 4000 part sizes");
        found.demand(plate.roll.abs() < 0.5 * PI, of.key("roll"), plate.roll, "between -90° and 90°");
        let open = plate.width.unwrap_or(f64::INFINITY);
        // How far what has round edges reaches from one side to the other.
        let side = match plate.cross_section {
            CrossSection::Flat => open,
            CrossSection::Walled { height } => {
                let high = height > 0.0 && height <= FARTHEST * size;
                found.demand(high, of.key("side_walls"), height, "above 0, and at most 4000 part sizes");
                f64::INFINITY
            }
            CrossSection::Groove { angle } => {
                let [least, most] = V_ANGLES;
                let fine = (least..=most).contains(&angle);
                found.demand(fine, of.key("v_angle"), angle, "10° to 170°");
                if fine { open * 0.5 / sin(0.5 * angle) } else { open }
            }
        };
        let least = (plate.edge - plate.uphill).norm().min(side);
        found.edge_radius(of, plate.edge_radius, least, &self.part.body);
    }

    fn start_problems(&self, found: &mut Findings) {
        let Start { to_edge, aside, turn, speed, face } = self.start;
        for (path, value) in [("start.speed", speed), ("start.turn", turn), ("start.aside", aside)] {
            found.demand(value.is_finite(), path, value, "a finite number");
        }
        found.face(face < self.part.faces.len(), face);
        let Some(first) = self.plates.first() else {
            found.problems.push(FeederProblem::NoPlates);
            return;
        };
        let run = first.edge - first.uphill;
        found.over_plate((0.0..=run.norm()).contains(&to_edge), to_edge);
        let half = first.width.map_or(f64::INFINITY, |width| 0.5 * width);
        let allowed = "at most half the first plate's width to either side";
        found.demand(aside.abs() <= half, "start.aside", aside, allowed);
        let beside = aside == 0.0 || !first.cross_section.is_groove();
        found.demand(beside, "start.aside", aside, "0 in a groove: the part lies against both flanks");
        found.upright(run.norm() > 0.0 && run.x.abs() <= VERTICAL * run.norm());
    }
}

/// The least turn that lays the face with this normal down, level; about z where it is half a turn.
fn laid_down(normal: Vec3) -> Rotation {
    let axis = normal.cross(-Vec3::Y);
    let sine = axis.norm();
    match axis.unit().filter(|_| sine > OPPOSITE) {
        Some(axis) => Rotation::by(axis * atan2(sine, -normal.y)),
        None if normal.y > 0.0 => Rotation::by(Vec3::Z * PI),
        None => Rotation::NONE,
    }
}

/// The rotation of x, y and z into these unit vectors.
fn rotation_to([x, y, z]: [Vec3; 3]) -> Rotation {
    // The largest of the four numbers is taken from the diagonal, the others follow from it.
    let diagonal =
        [1.0 + x.x + y.y + z.z, 1.0 + x.x - y.y - z.z, 1.0 - x.x + y.y - z.z, 1.0 - x.x - y.y + z.z];
    let rows = [
        [diagonal[0], y.z - z.y, z.x - x.z, x.y - y.x],
        [y.z - z.y, diagonal[1], x.y + y.x, z.x + x.z],
        [z.x - x.z, x.y + y.x, diagonal[2], y.z + z.y],
        [x.y - y.x, z.x + x.z, y.z + z.y, diagonal[3]],
    ];
    let largest = (0..4).max_by(|a, b| diagonal[*a].total_cmp(&diagonal[*b])).unwrap_or_default();
    Rotation::of(rows[largest]).unwrap_or(Rotation::NONE)
}

impl Prepared<'_> {
    /// The world the part moves in: each plate's sheet, then the walls along its sides; then the other walls.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// Supports that are not on one line.
    pub(super) fn are_wide(&self, supports: Supports, state: &State) -> bool {
        let places: Vec<Vec3> = supports.iter().filter_map(|i| self.world.touches_at(i, state)).collect();
        let reach = self.world.body().reach();
        let from = places.first().copied().unwrap_or(Vec3::ZERO);
        let wide = |(a, b): (usize, usize)| (places[a] - from).cross(places[b] - from).norm();
        let pairs = (0..places.len()).flat_map(|a| (0..a).map(move |b| (a, b)));
        pairs.map(wide).fold(0.0, f64::max) > ON_ONE_LINE * reach * reach
    }

    /// What of the part touches what of an obstacle, faces by their numbers among [`super::part::Part::faces`], and after those the faces in hollows; of a support that there is not, corner 0.
    pub fn touch(&self, support: usize) -> Touch {
        match self.world.touch(support).unwrap_or(Touch::Point { point: 0, face: 0 }) {
            Touch::Face { face, corner } => {
                let normal = self.world.face_normal(face).unwrap_or(Vec3::ZERO);
                Touch::Face { face: self.feeder.part.numbered(face, normal), corner }
            }
            other => other,
        }
    }

    /// The plate or wall that a support of the world is on: plates first, then walls.
    pub fn owner(&self, support: usize) -> usize {
        self.owners[self.world.obstacle_of(support)]
    }

    /// Runs and keeps everything.
    ///
    /// # Errors
    /// [`RunError::Motion`] for a fault of the numbers.
    pub fn run(&self) -> Result<Run, RunError> {
        Watcher::new(self, true).follow()
    }

    /// Runs without samples and stages: for outcome and landings.
    ///
    /// # Errors
    /// As [`Prepared::run`].
    pub fn run_untraced(&self) -> Result<Run, RunError> {
        Watcher::new(self, false).follow()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_turned_into_others() {
        for turn in [Vec3::ZERO, Vec3::X * PI, Vec3::Y * 3.1, Vec3::new(0.3, -2.0, 1.1), Vec3::Z * -PI] {
            let wanted = Rotation::by(turn);
            let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| wanted.apply(axis));
            let found = rotation_to(axes);
            for (axis, to) in [Vec3::X, Vec3::Y, Vec3::Z].into_iter().zip(axes) {
                assert!((found.apply(axis) - to).norm() < 1e-14, "{turn:?}");
            }
        }
    }

    #[test]
    fn a_face_is_laid_down_by_the_least_turn() {
        for normal in [Vec3::Y, -Vec3::Y, Vec3::X, Vec3::new(0.6, -0.8, 0.0), Vec3::new(0.0, 0.6, 0.8)] {
            let laid = laid_down(normal);
            assert!((laid.apply(normal) + Vec3::Y).norm() < 1e-15, "{normal:?}");
        }
        assert_eq!(laid_down(-Vec3::Y), Rotation::NONE);
    }
}
