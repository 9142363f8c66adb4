//! A feeder made ready, and its run.

use crate::check::check;
use crate::course::{Course, Watcher};
use crate::feeder::{Feeder, FeederProblem, PartKind, Plate, Wall};
use crate::form::{Form, FormProblem, Thick, before_end};
use crate::run::Run;
use crate::tolerance::{BEHIND_WALL, CROSSES_START, ON_WALL};
use carom_motion::MotionError;
use carom_motion::planar::{Observer, Obstacle, Options, Pose, Recorder, State, Twist, Walker, World};
use carom_num::Vec2;
use carom_num::elementary::atan2;
use thiserror::Error;

/// Why a feeder gave no run.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum RunError {
    /// The feeder cannot be run: every problem found.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))]
    Problems(Vec<FeederProblem>),
    /// A fault of the numbers.
    #[error(transparent)]
    Motion(#[from] MotionError),
}

/// So far above the part, as a share of its size, it is told on which side of each plate it starts.
const ABOVE: f64 = 1e-3;

/// A feeder that was checked and turned into a world, ready for any number of runs.
#[derive(Clone, Debug)]
pub struct Prepared<'f> {
    pub(crate) feeder: &'f Feeder,
    pub(crate) world: World,
    pub(crate) start: State,
    pub(crate) sides: Vec<bool>,
    pub(crate) options: Options,
}

impl Feeder {
    /// Checks the feeder and makes it ready to run.
    ///
    /// # Errors
    /// [`RunError::Problems`] with every problem found.
    pub fn prepare(&self, options: Options) -> Result<Prepared<'_>, RunError> {
        check(self).map_err(RunError::Problems)?;
        let world = self.world().map_err(RunError::Problems)?;
        let place = self.start_place().map(|place| self.on_outline(place, &world.obstacles[0]));
        let start = self.state_at(place);
        // A rod without thickness lies on what it starts on: a little above it is its side.
        let normal = place.map_or(Vec2::ZERO, |(_, downhill)| upward(downhill));
        let above = start.pose.centre + normal * (ABOVE * self.part.body.shape.size());
        let sides: Vec<bool> = world.obstacles.iter().map(|o| o.is_left_of(above)).collect();
        let crossing = self.crossings(&world, &start);
        if !crossing.is_empty() {
            return Err(RunError::Problems(crossing));
        }
        Ok(Prepared { feeder: self, world, start, sides, options })
    }

    /// Runs the feeder and keeps everything: stages, impacts, samples.
    ///
    /// # Errors
    /// As [`Feeder::prepare`]; [`RunError::Motion`] for a fault of the numbers.
    pub fn run(&self) -> Result<Run, RunError> {
        self.prepare(Options::default())?.run()
    }

    /// Runs the feeder without a trace: for its outcome, landings and margin.
    ///
    /// # Errors
    /// As [`Feeder::run`].
    pub fn run_untraced(&self) -> Result<Run, RunError> {
        self.prepare(Options::default())?.run_untraced()
    }

    fn world(&self) -> Result<World, Vec<FeederProblem>> {
        let mut problems = vec![];
        let mut obstacles = vec![];
        for i in 0..self.plates.len() + self.walls.len() {
            match self.obstacle(i) {
                Ok(obstacle) => obstacles.extend(obstacle),
                Err(found) => problems.push(found),
            }
        }
        if !problems.is_empty() {
            return Err(problems);
        }
        Ok(World::of_one(Vec2::new(0.0, -self.gravity), self.part.body.clone(), obstacles, self.law))
    }

    /// A plate or wall as the part meets it: plates first, then walls; none beyond them.
    ///
    /// # Errors
    /// [`FeederProblem::Form`] where what it looks like makes no shape.
    pub fn obstacle(&self, obstacle: usize) -> Result<Option<Obstacle>, FeederProblem> {
        let walls = obstacle.checked_sub(self.plates.len());
        let plate = self.plates.get(obstacle).map(|p| self.plate(p));
        let found = plate.or_else(|| walls.and_then(|i| self.walls.get(i)).map(|w| self.wall(w)));
        found.transpose().map_err(|why| FeederProblem::Form { path: self.obstacle_path(obstacle), why })
    }

    /// A plate as an obstacle; where an end lies on a wall it goes on behind it, a round one with all of its rounding.
    fn plate(&self, plate: &Plate) -> Result<Obstacle, FormProblem> {
        let Plate { uphill, edge, friction, restitution, .. } = *plate;
        let form = &plate.form;
        if form.is_plain() {
            let (from, to) = (self.joined(uphill, edge, 0.0), self.joined(edge, uphill, 0.0));
            return Ok(Obstacle::new(from, to, friction, restitution));
        }
        let mut course = plate.course();
        let last = course.len() - 1;
        // An arc keeps its ends: it would become another one.
        if course[0].sweep == 0.0 {
            course[0].at = self.joined(course[0].at, course[1].at, form.edge_radius);
        }
        if course[last - 1].sweep == 0.0 {
            course[last].at = self.joined(course[last].at, course[last - 1].at, form.edge_radius);
        }
        let form = Form { course, ..*form };
        let shape = form.shape(uphill, edge, plate.below(), self.skin())?;
        Ok(Obstacle::of_shape(shape, friction, restitution))
    }

    /// The skin of a part without thickness [m]; 0 of all others.
    fn skin(&self) -> f64 {
        let shape = &self.part.body.shape;
        shape.skin(0) - shape.radius_of(0)
    }

    fn wall(&self, wall: &Wall) -> Result<Obstacle, FormProblem> {
        let Wall { from, to, friction, restitution, .. } = *wall;
        if wall.form.is_plain() {
            return Ok(Obstacle::new(from, to, friction, restitution));
        }
        let shape = wall.form.shape(from, to, Thick::Both, self.skin())?;
        Ok(Obstacle::of_shape(shape, friction, restitution))
    }

    /// The end of a plate that comes from `from`, moved a little behind the wall where it lies on one, and by `more` [m]. A part without thickness that
    /// slides down the wall would find a way between ends that only touch.
    fn joined(&self, end: Vec2, from: Vec2, more: f64) -> Vec2 {
        let size = self.part.body.shape.size();
        let lies_on = |w: &Wall| {
            let (along, to_end) = (w.to - w.from, end - w.from);
            let (length, within) = (along.norm(), along.dot(to_end));
            along.cross(to_end).abs() <= ON_WALL * size * length && within > 0.0 && within < length * length
        };
        let beyond = (end - from).unit().filter(|_| self.walls.iter().any(lies_on));
        beyond.map_or(end, |along| end + along * (BEHIND_WALL * size + more))
    }

    /// Where on the first plate the part starts [m], and the unit direction down the plate there; `None` where there is no plate.
    pub fn start_place(&self) -> Option<(Vec2, Vec2)> {
        let plate = self.plates.first()?;
        let straight = || {
            let downhill = (plate.edge - plate.uphill) / (plate.edge - plate.uphill).norm();
            (plate.edge - downhill * self.start.to_edge, downhill)
        };
        let on = before_end(&plate.form.course, self.start.to_edge);
        Some(on.map_or_else(straight, |on| (on.at, on.direction)))
    }

    /// Pose and velocity at the start: lying flat on the first plate; at the origin where there is none.
    pub fn start_state(&self) -> State {
        self.state_at(self.start_place())
    }

    /// Pose and velocity where the part lies flat on a place of the first plate.
    fn state_at(&self, place: Option<(Vec2, Vec2)>) -> State {
        let Some((foot, downhill)) = place else { return State::default() };
        let normal = upward(downhill);
        let shape = &self.part.body.shape;
        let (height, angle) = if self.part.kind == PartKind::Disc {
            (shape.radius(), 0.0)
        } else {
            // A face that the part does not have is a problem of its own: the pose is then that on its first one.
            let rests = shape.rests();
            rests.get(self.start.face).or(rests.first()).map_or((shape.size(), 0.0), |rest| {
                (rest.depth, atan2(rest.normal.cross(-normal), rest.normal.dot(-normal)))
            })
        };
        let centre = foot + normal * height;
        State {
            pose: Pose { centre, angle },
            twist: Twist { velocity: downhill * self.start.speed, spin: 0.0 },
        }
    }

    /// A place on the drawing of the first plate and the direction there, as the part meets them: joints that are smooth but for rounding are smooth, and a
    /// stretch beside one runs a hair beside the drawn one. A part on the drawn one would start behind it.
    fn on_outline(&self, (foot, downhill): (Vec2, Vec2), plate: &Obstacle) -> (Vec2, Vec2) {
        let bent = self.plates.first().is_some_and(|plate| !plate.form.is_plain());
        let side = bent.then(|| plate.shape().side_by(foot, upward(downhill))).flatten();
        let Some((depth, normal)) = side else { return (foot, downhill) };
        let along = normal.turned_left();
        (foot + normal * depth, if along.dot(downhill) > 0.0 { along } else { -along })
    }

    /// Plates and walls that cross the part where it starts.
    fn crossings(&self, world: &World, start: &State) -> Vec<FeederProblem> {
        let slack = CROSSES_START * self.part.body.shape.size();
        let crosses = |i: &usize| world.may_touch(0, start, *i) && world.overlap(0, start, *i) > slack;
        (0..world.obstacles.len())
            .filter(crosses)
            .map(|i| FeederProblem::CrossesStart { path: self.obstacle_path(i) })
            .collect()
    }

    /// The name of an obstacle: plates first, then walls, then the parts of a feed.
    pub fn obstacle_name(&self, obstacle: usize) -> &str {
        match self.plates.get(obstacle) {
            Some(plate) => &plate.name,
            None => self.walls.get(obstacle - self.plates.len()).map_or("another part", |w| &w.name),
        }
    }

    pub(crate) fn obstacle_path(&self, obstacle: usize) -> String {
        let kind = if obstacle < self.plates.len() { "plate" } else { "wall" };
        format!("{kind}.{}", self.obstacle_name(obstacle))
    }
}

/// Out of a stretch of this direction, upwards.
fn upward(direction: Vec2) -> Vec2 {
    let left = direction.turned_left();
    if left.y >= 0.0 { left } else { -left }
}

impl<'f> Prepared<'f> {
    /// The world the part moves in: obstacles are the plates, then the walls.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// Runs and keeps everything.
    ///
    /// # Errors
    /// [`RunError::Motion`] for a fault of the numbers.
    pub fn run(&self) -> Result<Run, RunError> {
        let mut recorder = Recorder::default();
        let mut run = self.observed(&mut recorder)?;
        run.trace = recorder.into_trace();
        run.stages = crate::stages::stages(self.feeder, &self.world.obstacles, &run.trace);
        Ok(run)
    }

    /// Runs without a trace: for outcome, landings and margin.
    ///
    /// # Errors
    /// As [`Prepared::run`].
    pub fn run_untraced(&self) -> Result<Run, RunError> {
        self.observed(&mut ())
    }

    /// Runs while `observer` looks on.
    ///
    /// # Errors
    /// As [`Prepared::run`].
    pub fn observed(&self, observer: &mut dyn Observer) -> Result<Run, RunError> {
        let walker =
            Walker::new(&self.world, self.start, self.sides.clone(), self.options)?.ending_at_swings();
        let watcher = Watcher::new(self, 0.0, observer);
        Ok(Course::new(self).follow(walker, watcher)?)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::feeder::{Part, Start, Stop};

    #[test]
    fn a_plate_that_ends_on_a_wall_goes_on_a_little_behind_it() {
        let uphill = Vec2::new(-0.4, 0.3);
        let plate = Plate {
            name: "upper".to_owned(),
            uphill,
            edge: Vec2::ZERO,
            friction: 0.2,
            restitution: 0.0,
            unbounded: false,
            form: Default::default(),
        };
        let wall = Wall {
            name: "right".to_owned(),
            from: Vec2::new(0.0, -1.0),
            to: Vec2::new(0.0, 1.0),
            friction: 0.2,
            restitution: 0.0,
            form: Default::default(),
        };
        let part = Part::rod(0.1, 0.3, 2.5e-4).unwrap();
        let start = Start { to_edge: 0.2, speed: 0.0, face: 0 };
        let (law, stop) = (Default::default(), Stop::Landed);
        let feeder = Feeder { gravity: 9.81, stop, law, part, start, plates: vec![plate], walls: vec![wall] };
        let world = feeder.world().unwrap();
        let joined = &world.obstacles[0];
        assert_eq!(joined.from(), uphill, "the end that lies on no wall stays");
        // A part of half a length of 50 mm: a millionth of that, along the plate.
        let beyond = joined.to();
        assert!((beyond - Vec2::new(0.8, -0.6) * (1e-6 * 0.05)).norm() < 1e-18, "{beyond:?}");
        assert!(beyond.x > 0.0, "behind the wall, not before it");
    }
}
