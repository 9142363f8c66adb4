//! Whole drops through feeders with extreme numbers.

use crate::chains;
use crate::draw;
use crate::tally::{Tally, kind_of};
use carom_feeder::{Feeder, Form, Part, PartKind, Plate, RunError, Start, Stop, Wall};
use carom_motion::planar::observer::{ImpactFacts, PieceFacts};
use carom_motion::planar::{Body, Observer, Options, Shape, State};
use carom_num::Vec2;
use rand::RngExt;
use rand_pcg::Pcg64;

/// Events and time [s] of a run.
const BUDGET: (u64, f64) = (20_000, 600.0);
/// Growth of energy against the largest there was, or the tolerance of the integration where that is more.
const CLOSE: f64 = 1e-8;

/// Pieces of motion that end at one instant, but for rounding, after which a part has no way on: it strikes at most some tens of times at once.
const MOST_AT_ONCE: u32 = 1000;

/// Who watches the energy, and that time goes on.
#[derive(Default)]
struct Ledger {
    mass: f64,
    inertia: f64,
    gravity: f64,
    /// The lowest place counts from here.
    floor: f64,
    most: f64,
    growth: f64,
    /// The last time that was another one [s], how many pieces have ended at it, and how many did at most.
    instant: f64,
    at_once: u32,
    most_at_once: u32,
}

impl Ledger {
    fn energy(&self, s: &State) -> f64 {
        let kinetic =
            self.mass * s.twist.velocity.dot(s.twist.velocity) + self.inertia * s.twist.spin * s.twist.spin;
        0.5 * kinetic + self.mass * self.gravity * (s.pose.centre.y - self.floor)
    }

    fn compare(&mut self, before: &State, after: &State) {
        let (was, is) = (self.energy(before), self.energy(after));
        self.most = self.most.max(was.abs()).max(is.abs());
        let growth = (is - was) / self.most.max(f64::MIN_POSITIVE);
        // The larger of a number and none would be the number.
        self.growth =
            if growth.is_nan() || self.growth.is_nan() { f64::NAN } else { self.growth.max(growth) };
    }
}

impl Observer for Ledger {
    fn piece(&mut self, piece: &PieceFacts) {
        self.compare(&piece.start, &piece.end);
        if piece.end_time > self.instant * (1.0 + 8.0 * f64::EPSILON) {
            (self.instant, self.at_once) = (piece.end_time, 0);
        }
        self.at_once += 1;
        self.most_at_once = self.most_at_once.max(self.at_once);
    }

    fn impact(&mut self, facts: &ImpactFacts, _whole: Option<carom_motion::planar::trace::Impact>) {
        self.compare(&facts.before, &facts.after);
    }
}

/// One case: a random feeder of straight plates.
pub(crate) fn case(seed: u64, number: u64, tally: &mut Tally) {
    let rng = &mut draw::numbers(seed, number);
    judge(feeder(rng), rng, number, tally);
}

/// One case: a part of any outline through bent plates with rounded edges.
pub(crate) fn bent_case(seed: u64, number: u64, tally: &mut Tally) {
    let rng = &mut draw::numbers(seed, number);
    let feeder = feeder(rng).and_then(|feeder| chains::bent(rng, feeder));
    judge(feeder, rng, number, tally);
}

fn judge(feeder: Option<Feeder>, rng: &mut Pcg64, number: u64, tally: &mut Tally) {
    let Some(feeder) = feeder else { return tally.breaks("a part that is none", number) };
    let tolerance = if rng.random_bool(0.5) { 1e-11 } else { 1e-6 };
    let options = Options { tolerance, most_events: BUDGET.0, most_time: BUDGET.1 };
    let Some(prepared) = ready(feeder.prepare(options), number, tally) else { return };
    let body = &feeder.part.body;
    let low = feeder.plates.iter().map(|p| p.edge.y).fold(0.0, f64::min) - body.shape.size();
    let (mass, inertia, gravity) = (body.mass, body.inertia, feeder.gravity);
    let mut ledger = Ledger { mass, inertia, gravity, floor: low, ..Ledger::default() };
    match prepared.observed(&mut ledger) {
        Err(fault) => faulty(&fault, number, tally),
        Ok(run) => {
            tally.count(format!("{:?}", run.outcome));
            // Energy may grow by what the integration's tolerance leaves, and by no more.
            tally.residual("energy gained", ledger.growth, CLOSE.max(tolerance), number);
            if ledger.most_at_once > MOST_AT_ONCE {
                tally.breaks("events without end at one instant", number);
            }
            if !run.end_time.is_finite() || run.margin.is_nan() {
                tally.breaks("a result that is no number", number);
            }
        }
    }
}

/// A feeder that is ready to run; `None` where it is refused, which is counted.
pub(crate) fn ready<P>(prepared: Result<P, RunError>, number: u64, tally: &mut Tally) -> Option<P> {
    match prepared {
        Ok(prepared) => return Some(prepared),
        Err(RunError::Problems(problems)) => {
            let crosses = problems.iter().all(|p| p.to_string().contains("crosses"));
            let why = if crosses { "a plate crosses the start" } else { "out of range" };
            tally.count(format!("refused: {why}"));
        }
        Err(_) => tally.breaks("a fault before the start", number),
    }
    None
}

/// A run ends without an answer.
pub(crate) fn faulty(fault: &RunError, number: u64, tally: &mut Tally) {
    tally.count(format!("fault: {}", kind_of(&fault.to_string())));
    tally.breaks("a fault of the numbers", number);
}

/// Two to four plates that zigzag, walls now and then; slopes to 89.9°, now and then nearly parallel to each other.
fn feeder(rng: &mut Pcg64) -> Option<Feeder> {
    let body = draw::slender(rng);
    let size = body.half.x;
    let part = match rng.random_range(0..3) {
        0 => Part::rod(2.0 * size, body.mass, body.mass * size * size / 3.0)?,
        1 => Part::rectangle(2.0 * size, 2.0 * body.half.y, body.mass, body.inertia)?,
        _ => {
            let shape = Shape::new(vec![Vec2::ZERO], size).ok()?;
            let body = Body { shape, mass: body.mass, inertia: 0.5 * body.mass * size * size };
            Part { kind: PartKind::Disc, body }
        }
    };
    let mut plates: Vec<Plate> = vec![];
    let mut place = Vec2::ZERO;
    let mut slope = draw::between(rng, 0.5, 89.9);
    for i in 0..rng.random_range(2..5) {
        let nearly = i > 0 && rng.random_bool(0.1);
        // Plates that are parallel but for rounding: contacts with both say almost the same.
        slope = if nearly { slope + draw::between(rng, -1e-7, 1e-7) } else { draw::between(rng, 0.1, 89.9) };
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let down = Vec2::at_angle(-slope.to_radians());
        let down = Vec2::new(side * down.x, down.y);
        let (friction, restitution) = (draw::friction(rng), draw::restitution(rng));
        let uphill = place - down * (size * draw::between(rng, 1.5, 20.0));
        let edge = place + down * (size * draw::between(rng, 0.5, 10.0));
        let (uphill, edge) = if i == 0 { (uphill, place) } else { (uphill, edge) };
        let form = Form::default();
        plates.push(Plate {
            name: format!("p{i}"),
            uphill,
            edge,
            friction,
            restitution,
            unbounded: false,
            form,
        });
        place = edge
            + Vec2::new(side * size * draw::between(rng, 0.0, 3.0), -size * draw::between(rng, 0.5, 20.0));
    }
    let last = plates.last()?.clone();
    let wall = Wall {
        name: "w".into(),
        from: last.edge,
        to: last.edge + Vec2::new(0.0, size * draw::between(rng, 0.2, 5.0)),
        friction: draw::friction(rng),
        restitution: draw::restitution(rng),
        form: Form::default(),
    };
    let walls = if rng.random_bool(0.3) { vec![wall] } else { vec![] };
    let to_edge = size * draw::between(rng, 1e-3, 1.4);
    let start = Start { to_edge, speed: draw::speed(rng).abs().min(100.0), face: 0 };
    let stop = if rng.random_bool(0.5) { Stop::Landed } else { Stop::Delivered };
    Some(Feeder { gravity: 9.81, stop, law: draw::law(rng), part, start, plates, walls })
}
