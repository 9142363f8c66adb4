//! Throws of a body that differ in attitude, height, speed and spin.

use super::body::{Throw, released};
use super::follow::MOST_STRIKES;
use super::read::FALLS;
use super::{MOST_STEPS, SpatialRollProblem};
use carom_motion::spatial::{Body, Options, State, Supports, World};
use carom_num::elementary::atan2;
use carom_num::{Rotation, Vec3};
use carom_study::poses::{Plan, Poses, PosesError, attitude, direction, sample, thrown_in_space};

/// Coordinates of a throw: attitude, height, speed, spin rate, axis of the spin.
///
/// # Example
/// A point with fewer coordinates is no throw: then the start is the one that is written.
/// ```
/// use carom_scene::*;
/// let text = "box = [0.06, 0.04, 0.02]\nmass = 1\nturn = 0\nheight = 0.2";
/// let brick = SpatialRollProblem::parse(SpatialRollKind::Body, "brick.toml", text, &[])?;
/// assert_eq!(THROW_DIMENSIONS, 3 + 1 + 1 + 1 + 2);
/// assert_eq!(brick.release(&[0.5; THROW_DIMENSIONS - 1]), brick.start);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub const THROW_DIMENSIONS: usize = 8;

impl SpatialRollProblem {
    /// Throws the body, each time from [`Self::release`] at a point of the plan, which has [`THROW_DIMENSIONS`]; `done` is called after every throw. Every stable face is in
    /// the result, whether a throw comes to rest on it or not. A throw is followed through as many strikes as a single run.
    ///
    /// # Errors
    /// [`PosesError`].
    pub fn throws(&self, plan: &Plan, done: impl Fn() + Sync) -> Result<Poses, PosesError> {
        let most_impacts = u64::from(self.strikes.unwrap_or(MOST_STRIKES));
        let options = Options { most_impacts, ..self.options() };
        let body = self.thrown.as_ref();
        let face_of = |held| body.and_then(|body| body.face_of(held));
        let stances = body.map_or(&[][..], |body| &body.stances);
        let stable: Vec<usize> = (0..stances.len()).filter(|face| stances[*face].margin > 0.0).collect();
        let throw = |point: &[f64]| thrown_in_space((&self.world, &options), &self.release(point), face_of);
        sample(plan, throw, &stable, done)
    }

    /// The start of the throw at a point of the unit cube of [`THROW_DIMENSIONS`] coordinates: every attitude and every axis of the spin is as probable as any other, height, speed and
    /// spin rate are within their tolerances; the speed is horizontal. Where no body is thrown, the start as written.
    pub fn release(&self, point: &[f64]) -> State {
        let throw = self.thrown.as_ref().map(|thrown| &thrown.throw);
        throw.and_then(|throw| throw.release(self.world.body(), point)).unwrap_or(self.start)
    }

    /// The body at rest on one of its faces; `None` where there is no such face.
    pub fn resting_on(&self, face: usize) -> Option<State> {
        let normal = self.thrown.as_ref()?.shape.hull.faces().get(face)?.normal;
        Some(lying(self.world.body(), normal))
    }

    /// The overrides that make a body start there: `--set` each of them.
    pub fn overrides(&self, start: &State) -> Vec<String> {
        let (axis, turn) = axis_and_turn(start.attitude);
        // Adding zero leaves no −0.
        let list = |v: Vec3| format!("[{:?}, {:?}, {:?}]", v.x + 0.0, v.y + 0.0, v.z + 0.0);
        let lowest = start.centre.z + self.world.body().lowest(start.attitude);
        vec![
            format!("axis={}", list(axis)),
            format!("turn={turn:?}"),
            format!("height={lowest:?}"),
            format!("velocity={}", list(start.velocity)),
            format!("spin={}", list(start.spin)),
        ]
    }
}

impl Throw {
    /// The start of the throw of a body at a point of the unit cube of [`THROW_DIMENSIONS`] coordinates; `None` at a point of another one.
    pub(crate) fn release(&self, body: &Body, point: &[f64]) -> Option<State> {
        let &[a, b, c, height, speed, rate, d, e] = point else { return None };
        let velocity = Vec3::new(self.speed.at(speed), 0.0, self.rise);
        let spin = direction([d, e]) * self.spin_rate.at(rate);
        Some(released(body, attitude([a, b, c]), self.height.at(height), velocity, spin))
    }
}

/// A body at rest on the plane, with this normal of its downwards.
pub(crate) fn lying(body: &Body, normal: Vec3) -> State {
    released(body, turned_down(normal), 0.0, Vec3::ZERO, Vec3::ZERO)
}

/// How long a throw is followed that says nothing else.
pub(crate) fn options_of_throws(world: &World) -> Options {
    Options {
        most_time: FALLS * world.scales().time,
        most_steps: MOST_STEPS,
        most_impacts: u64::from(MOST_STRIKES),
        ..Options::default()
    }
}

/// Which of some faces, each given by its corners, a body rests on that holds these supports; `None` where they belong to no face together.
pub(super) fn face_of<'a>(mut faces: impl Iterator<Item = &'a [usize]>, held: Supports) -> Option<usize> {
    let on = |corners: &[usize]| corners.iter().copied().collect::<Supports>();
    faces.position(|corners| held.difference(on(corners)).is_empty())
}

/// The shortest turn that brings a direction of the body down.
fn turned_down(normal: Vec3) -> Rotation {
    let cross = normal.cross(-Vec3::Z);
    let half_turn = Rotation { w: 0.0, v: Vec3::X };
    Rotation::of([1.0 - normal.z, cross.x, cross.y, cross.z]).unwrap_or(half_turn)
}

/// Unit axis and angle in [0, π] \[rad\] of a rotation.
fn axis_and_turn(rotation: Rotation) -> (Vec3, f64) {
    let (w, v) = if rotation.w < 0.0 { (-rotation.w, -rotation.v) } else { (rotation.w, rotation.v) };
    match v.unit() {
        Some(axis) => (axis, 2.0 * atan2(v.norm(), w)),
        None => (Vec3::Z, 0.0),
    }
}

#[cfg(test)]
mod tests {
    use super::super::SpatialRollKind;
    use super::*;

    #[test]
    fn a_body_lies_on_the_face_that_is_asked_for() {
        let brick = SpatialRollProblem::parse(SpatialRollKind::Body, "brick.toml", "", &[]).unwrap();
        for (face, shape) in brick.thrown.as_ref().unwrap().shape.hull.faces().iter().enumerate() {
            let state = brick.resting_on(face).unwrap();
            for corner in &shape.corners {
                let height = state.place(brick.world.body().supports()[*corner]).z;
                assert!(height.abs() < 1e-16, "corner {corner} of face {face}: {height}");
            }
        }
        assert_eq!(brick.resting_on(6), None);
    }

    #[test]
    fn a_throw_is_made_again_from_its_overrides() {
        let source = "height = { low = 0.01, high = 0.05 }\nspeed = 0.2\nspin_rate = \"9 ± 3 rad/s\"\n";
        let parse = |set: &[String]| {
            SpatialRollProblem::parse(SpatialRollKind::Body, "brick.toml", source, set).unwrap()
        };
        let problem = parse(&[]);
        for k in 0..20 {
            let point: Vec<f64> =
                (0..THROW_DIMENSIONS).map(|d| (0.37 * f64::from(k) + 0.61 * d as f64).fract()).collect();
            let start = problem.release(&point);
            let again = parse(&problem.overrides(&start)).start;
            let apart = (again.attitude.apply(Vec3::X) - start.attitude.apply(Vec3::X)).norm();
            assert!(apart < 1e-15 * 8.0, "{k}: {apart:e}");
            assert!((again.centre - start.centre).norm() < 1e-16, "{k}: {again:?} {start:?}");
            assert_eq!((again.velocity, again.spin), (start.velocity, start.spin), "{k}");
            let lowest = problem.world.body().supports().iter().map(|r| start.place(*r).z);
            let lowest = lowest.fold(f64::INFINITY, f64::min);
            assert!((0.01 - 1e-15..=0.05 + 1e-15).contains(&lowest), "{k}: {lowest}");
            assert!((start.spin.norm() - 9.0).abs() <= 3.0 + 1e-12, "{k}: {start:?}");
        }
    }
}
