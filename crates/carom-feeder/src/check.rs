//! Is this a feeder at all?

use crate::feeder::{Feeder, FeederProblem, PartKind};
use carom_num::Vec2;

/// Part sizes from the origin beyond which the rounding of a position exceeds the gap at which features meet.
const FARTHEST: f64 = 4000.0;
const NEAR_ENOUGH: &str = "at most 4000 part sizes (largest distance from the mass centre) from the origin";

struct Findings {
    problems: Vec<FeederProblem>,
}

impl Findings {
    fn demand(&mut self, fine: bool, path: &str, value: f64, allowed: &'static str) {
        if !fine {
            self.problems.push(FeederProblem::OutOfRange { path: path.to_owned(), value, allowed });
        }
    }

    fn segment(&mut self, path: &str, from: Vec2, to: Vec2, size: f64) {
        for (value, end) in [(from.x, "from.x"), (from.y, "from.y"), (to.x, "to.x"), (to.y, "to.y")] {
            let path = format!("{path}.{end}");
            self.demand(value.is_finite(), &path, value, "a finite number");
            let far = value.is_finite() && value.abs() > FARTHEST * size;
            self.demand(!far, &path, value, NEAR_ENOUGH);
        }
        let length = (to - from).norm();
        if length.is_finite() && length <= 1e-9 * size {
            self.problems.push(FeederProblem::NoLength { path: path.to_owned() });
        }
    }

    fn surface(&mut self, path: &str, friction: f64, restitution: f64) {
        self.demand(
            friction.is_finite() && friction >= 0.0,
            &format!("{path}.friction"),
            friction,
            "0 or more",
        );
        self.demand(
            (0.0..=1.0).contains(&restitution),
            &format!("{path}.restitution"),
            restitution,
            "0 to 1",
        );
    }
}

/// Every problem of a feeder.
pub(crate) fn check(feeder: &Feeder) -> Result<(), Vec<FeederProblem>> {
    let mut found = Findings { problems: vec![] };
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
        let path = format!("plate.{}", plate.name);
        found.segment(&path, plate.uphill, plate.edge, size);
        found.surface(&path, plate.friction, plate.restitution);
    }
    for wall in &feeder.walls {
        let path = format!("wall.{}", wall.name);
        found.segment(&path, wall.from, wall.to, size);
        found.surface(&path, wall.friction, wall.restitution);
    }
    check_start(feeder, &mut found);
    if found.problems.is_empty() { Ok(()) } else { Err(found.problems) }
}

fn check_start(feeder: &Feeder, found: &mut Findings) {
    let start = &feeder.start;
    found.demand(start.speed.is_finite(), "start.speed", start.speed, "a finite number");
    #[expect(clippy::cast_precision_loss, reason = "a face number is small")]
    let (face, faces) = (start.face as f64, feeder.part.body.shape.faces());
    let fine = start.face < faces || (feeder.part.kind == PartKind::Disc && start.face == 0);
    found.demand(fine, "start.face", face, "one of the part's faces, counted from 0");
    let Some(first) = feeder.plates.first() else {
        found.problems.push(FeederProblem::NoPlates);
        return;
    };
    let length = (first.edge - first.uphill).norm();
    let on_plate = start.to_edge >= 0.0 && (start.to_edge <= length || !length.is_finite());
    found.demand(
        on_plate,
        "start.to_edge",
        start.to_edge,
        "0 to the first plate's length: the mass centre must be over the plate",
    );
    let vertical = (first.edge.x - first.uphill.x).abs() <= 1e-9 * length;
    found.demand(!vertical, "plate.0.slope", 90.0, "a first plate that is not vertical");
}
