//! Is this a feeder at all?

use crate::feeder::{Feeder, FeederProblem, PartKind};
use crate::form::{Form, before_end, course_length};
use crate::tolerance::{FARTHEST, NO_LENGTH, VERTICAL};
use carom_motion::spatial::Body;
use carom_num::{Vec2, Vec3};
use std::fmt;

const NEAR_ENOUGH: &str = "at most 4000 part sizes (largest distance from the mass centre) from the origin";

/// The plate, wall or part that a problem is about. Its path is written only where there is a problem: sweeps check millions of feeders.
#[derive(Clone, Copy)]
pub(crate) struct Of<'f> {
    pub(crate) kind: &'static str,
    pub(crate) name: &'f str,
}

impl Of<'_> {
    pub(crate) fn key(self, key: &str) -> impl fmt::Display {
        fmt::from_fn(move |f| write!(f, "{self}.{key}"))
    }
}

impl fmt::Display for Of<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.kind, self.name)
    }
}

/// What was found, in the plane or in space.
#[derive(Default)]
pub(crate) struct Findings {
    pub(crate) problems: Vec<FeederProblem>,
}

impl Findings {
    pub(crate) fn demand(&mut self, fine: bool, path: impl fmt::Display, value: f64, allowed: &'static str) {
        if !fine {
            self.problems.push(FeederProblem::OutOfRange { path: path.to_string(), value, allowed });
        }
    }

    pub(crate) fn segment(&mut self, of: Of<'_>, from: Vec2, to: Vec2, size: f64) {
        for (value, end) in [(from.x, "from.x"), (from.y, "from.y"), (to.x, "to.x"), (to.y, "to.y")] {
            self.demand(value.is_finite(), of.key(end), value, "a finite number");
            let far = value.is_finite() && value.abs() > FARTHEST * size;
            self.demand(!far, of.key(end), value, NEAR_ENOUGH);
        }
        let length = (to - from).norm();
        if length.is_finite() && length <= NO_LENGTH * size {
            self.problems.push(FeederProblem::NoLength { path: of.to_string() });
        }
    }

    fn form(&mut self, of: Of<'_>, form: &Form, size: f64) {
        let fine = form.edge_radius.is_finite() && form.edge_radius >= 0.0;
        self.demand(fine, of.key("edge_radius"), form.edge_radius, "0 or more");
        for (i, point) in form.course.iter().enumerate() {
            for (value, axis) in [(point.at.x, "x"), (point.at.y, "y")] {
                let key = format!("chain.{i}.{axis}");
                self.demand(value.is_finite(), of.key(&key), value, "a finite number");
                let far = value.is_finite() && value.abs() > FARTHEST * size;
                self.demand(!far, of.key(&key), value, NEAR_ENOUGH);
            }
        }
    }

    /// A round bar in space, beside the body that meets it.
    pub(crate) fn pin(&mut self, of: Of<'_>, ends: [Vec3; 2], radius: f64, body: &Body) {
        let size = body.reach();
        for (end, place) in ["from", "to"].into_iter().zip(ends) {
            for (axis, value) in ["x", "y", "z"].into_iter().zip(place.to_array()) {
                let near = value.abs() <= FARTHEST * size;
                self.demand(near, of.key(&format!("{end}.{axis}")), value, NEAR_ENOUGH);
            }
        }
        let told = radius >= Body::LEAST_ROUNDING * size && radius <= FARTHEST * size;
        self.demand(told, of.key("radius"), radius, "0.00001 to 4000 part sizes");
    }

    /// The radius of the edges of a sheet in space, whose shortest side is so long, beside the body that meets it.
    pub(crate) fn edge_radius(&mut self, of: Of<'_>, radius: f64, side: f64, body: &Body) {
        let told = radius == 0.0 || radius >= Body::LEAST_ROUNDING * body.reach();
        let fits = (0.0..0.5 * side).contains(&radius);
        let allowed = "0 for a thin sheet, or at least 0.00001 of the part's size, and less than half of the sheet's sides";
        self.demand(told && fits, of.key("edge_radius"), radius, allowed);
    }

    pub(crate) fn surface(&mut self, of: Of<'_>, friction: f64, restitution: f64) {
        let fine = friction.is_finite() && friction >= 0.0;
        self.demand(fine, of.key("friction"), friction, "0 or more");
        let fine = (0.0..=1.0).contains(&restitution);
        self.demand(fine, of.key("restitution"), restitution, "0 to 1");
    }

    /// On which face the part starts.
    pub(crate) fn face(&mut self, fine: bool, face: usize) {
        #[expect(clippy::cast_precision_loss, reason = "a face number is small")]
        let number = face as f64;
        self.demand(fine, "start.face", number, "one of the part's faces, counted from 0");
    }

    /// Whether the part starts over the first plate.
    pub(crate) fn over_plate(&mut self, fine: bool, to_edge: f64) {
        let allowed = "0 to the first plate's length: the mass centre must be over the plate";
        self.demand(fine, "start.to_edge", to_edge, allowed);
    }

    /// Whether the first plate is vertical where the part starts.
    pub(crate) fn upright(&mut self, vertical: bool) {
        let allowed = "a first plate that is not vertical where the part starts";
        self.demand(!vertical, "plate.0.slope", 90.0, allowed);
    }
}

/// Every problem of a feeder.
pub(crate) fn check(feeder: &Feeder) -> Result<(), Vec<FeederProblem>> {
    let mut found = Findings::default();
    let body = &feeder.part.body;
    let size = body.shape.size();
    let positive = |v: f64| v.is_finite() && v > 0.0;
    found.demand(positive(feeder.gravity), "gravity", feeder.gravity, "above 0 m/s²");
    found.demand(positive(body.mass), "part.mass", body.mass, "above 0 kg");
    let largest = body.mass * size * size;
    let inertia_fits =
        positive(body.inertia) && (body.inertia <= 1.000_001 * largest || !positive(body.mass));
    found.demand(
        inertia_fits,
        "part.inertia",
        body.inertia,
        "above 0 and at most mass × (largest distance from the centre)²",
    );
    for plate in &feeder.plates {
        let of = Of { kind: "plate", name: &plate.name };
        found.segment(of, plate.uphill, plate.edge, size);
        found.form(of, &plate.form, size);
        found.surface(of, plate.friction, plate.restitution);
    }
    for wall in &feeder.walls {
        let of = Of { kind: "wall", name: &wall.name };
        found.segment(of, wall.from, wall.to, size);
        found.form(of, &wall.form, size);
        found.surface(of, wall.friction, wall.restitution);
    }
    check_start(feeder, &mut found);
    if found.problems.is_empty() { Ok(()) } else { Err(found.problems) }
}

fn check_start(feeder: &Feeder, found: &mut Findings) {
    let start = &feeder.start;
    found.demand(start.speed.is_finite(), "start.speed", start.speed, "a finite number");
    let faces = feeder.part.body.shape.rests().len();
    let fine = start.face < faces || (feeder.part.kind == PartKind::Disc && start.face == 0);
    found.face(fine, start.face);
    let Some(first) = feeder.plates.first() else {
        found.problems.push(FeederProblem::NoPlates);
        return;
    };
    let course = first.course();
    let length = course_length(&course);
    let on_plate = start.to_edge >= 0.0 && (start.to_edge <= length || !length.is_finite());
    found.over_plate(on_plate, start.to_edge);
    let Some(place) = before_end(&course, start.to_edge).filter(|_| on_plate) else { return };
    let vertical = place.direction.x.abs() <= VERTICAL;
    found.upright(vertical);
    let lies = place.straight || feeder.part.kind == PartKind::Disc;
    found.demand(
        lies,
        "start.to_edge",
        start.to_edge,
        "a straight stretch of the first plate: only a disc starts on an arc",
    );
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::feeder::{Part, Plate, Start, Stop};

    /// The paths of what is wrong with a rod of 0.1 m and 0.3 kg that has this share of the largest inertia: all mass at its ends.
    fn wrong(share: f64) -> Vec<String> {
        let plate = Plate {
            name: "upper".to_owned(),
            uphill: Vec2::new(-0.4, 0.3),
            edge: Vec2::ZERO,
            friction: 0.2,
            restitution: 0.0,
            unbounded: false,
            form: Default::default(),
        };
        let part = Part::rod(0.1, 0.3, share * 0.3 * 0.05 * 0.05).unwrap();
        let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
        let (law, stop) = (Default::default(), Stop::Landed);
        let feeder = Feeder { gravity: 9.81, stop, law, part, start, plates: vec![plate], walls: vec![] };
        let path = |problem: FeederProblem| match problem {
            FeederProblem::OutOfRange { path, .. } => path,
            other => other.to_string(),
        };
        check(&feeder).err().unwrap_or_default().into_iter().map(path).collect()
    }

    #[test]
    fn no_inertia_exceeds_that_of_all_mass_at_the_farthest_point() {
        assert!(wrong(1.0 / 3.0).is_empty(), "a uniform rod");
        assert!(wrong(1.0).is_empty(), "two masses at its ends");
        for share in [1.01, 1.5, 2.0] {
            assert_eq!(wrong(share), ["part.inertia"], "{share} of the largest");
        }
    }
}
