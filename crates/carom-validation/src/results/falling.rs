//! Bodies that move in time: a stick that falls, a ball that bounces, discs and blocks on slopes and edges.

use super::rolling::border;
use crate::failure::ValidationError;
use crate::value::Values;
use carom_impact::Law;
use carom_impact::planar::Slip;
use carom_motion::planar::trace::{Piece, PieceEnd, Trace};
use carom_motion::planar::{
    Body, Happening, Obstacle, Options, Pose, Recorder, Shape, State, Twist, Walker, World,
};
use carom_num::Vec2;
use carom_num::elementary::{atan2, sin_cos};

/// [m/s²].
const G: f64 = 9.81;
/// [kg].
const MASS: f64 = 1.0;

fn walk(
    what: &str,
    shape: Option<Shape>,
    inertia: f64,
    obstacle: Obstacle,
    start: State,
    most_events: u64,
) -> Result<Trace, ValidationError> {
    let shape = shape.ok_or_else(|| ValidationError::input(what, "no shape"))?;
    let body = Body { shape, mass: MASS, inertia };
    let world = World::of_one(Vec2::new(0.0, -G), body, vec![obstacle], Law::Poisson);
    let options = Options { most_events, ..Options::default() };
    let fails = |e| ValidationError::engine(what, e);
    let mut walker = Walker::new(&world, start, vec![true], options).map_err(fails)?;
    let mut recorder = Recorder::default();
    while walker.advance(&mut recorder).map_err(fails)? == Happening::Moves {}
    Ok(recorder.into_trace())
}

fn floor(friction: f64, restitution: f64) -> Obstacle {
    Obstacle::new(Vec2::new(-50.0, 0.0), Vec2::new(50.0, 0.0), friction, restitution)
}

/// At rest unless it turns about the origin, at this spin.
fn about_origin(centre: Vec2, angle: f64, spin: f64) -> State {
    State { pose: Pose { centre, angle }, twist: Twist { velocity: centre.turned_left() * spin, spin } }
}

/// Tilt from the upright at which a stick is let go, with the rate that it has there when it falls from the upright [rad].
const LEAN: f64 = 0.02;
/// Events of a fall that is over on the floor.
const FALL: u64 = 40;

/// A stick of 1 m with its foot on the floor, leaning to the right.
fn stick(friction: f64, lean: f64, rate: f64) -> Result<Trace, ValidationError> {
    let shape = Shape::new(vec![Vec2::new(-0.5, 0.0), Vec2::new(0.5, 0.0)], 0.0).ok();
    let (sin, cos) = sin_cos(lean);
    let start = about_origin(Vec2::new(sin, cos) * 0.5, std::f64::consts::FRAC_PI_2 - lean, -rate);
    let start = if rate == 0.0 { State { twist: Twist::default(), ..start } } else { start };
    walk("a falling stick", shape, MASS / 12.0, floor(friction, 0.0), start, FALL)
}

fn fallen_from_upright(friction: f64) -> Result<Trace, ValidationError> {
    // θ̇² = (3g/L)(1 − cos θ), in the form that keeps its digits.
    let (half, _) = sin_cos(0.5 * LEAN);
    stick(friction, LEAN, (6.0 * G).sqrt() * half)
}

/// Tilt from the upright [deg].
fn tilt(state: &State) -> f64 {
    90.0 - state.pose.angle.to_degrees()
}

/// Where the foot starts to slip, and how.
fn foot_slips(friction: f64) -> Result<(f64, Slip), ValidationError> {
    let trace = fallen_from_upright(friction)?;
    let sticks = |piece: &Piece| piece.held.len() == 1 && piece.held[0].slip == Slip::Sticks;
    let missing = || ValidationError::missing(format!("a slip of the foot with friction {friction}"));
    let last = trace.pieces.iter().position(sticks).ok_or_else(missing)?;
    let (piece, next) = (&trace.pieces[last], trace.pieces.get(last + 1).ok_or_else(missing)?);
    let slip = next.held.first().ok_or_else(missing)?.slip;
    Ok((tilt(&piece.end), slip))
}

/// Friction at which slips of the foot are asked.
const FEET: [f64; 5] = [0.1, 0.3, 0.36, 0.5, 1.0];
/// Leans from which a stick falls on a smooth floor [deg].
const SMOOTH: [u32; 2] = [5, 30];

/// A stick that falls: when its foot slips, and how it arrives.
pub(crate) fn falling_stick() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for friction in FEET {
        let (angle, slip) = foot_slips(friction)?;
        values.put(format!("angle.{friction}"), angle);
        values.put(format!("way.{friction}"), if slip == Slip::Backward { "backward" } else { "forward" });
    }
    values.put("friction", border([0.2, 0.5], |f| Ok(foot_slips(f)?.1 == Slip::Backward))?);
    for lean in SMOOTH {
        let trace = stick(0.0, f64::from(lean).to_radians(), 0.0)?;
        let strike = trace
            .impacts
            .first()
            .ok_or_else(|| ValidationError::missing("the stick's other end on the floor"))?;
        values.put(format!("smooth.spin.{lean}"), -strike.before.spin);
        let falls = trace.pieces.iter().take_while(|piece| piece.end_time <= strike.time);
        let forces = falls.flat_map(|piece| &piece.samples).filter_map(|sample| sample.contacts.first());
        let force = forces.last().map_or(f64::NAN, |contact| contact.normal_force);
        values.put(format!("smooth.force.{lean}"), force / (MASS * G));
    }
    Ok(values)
}

/// Coefficients of restitution of the ball, and the rebounds that are compared.
const BALLS: [f64; 3] = [0.5, 0.7, 0.9];
const REBOUNDS: [usize; 3] = [1, 2, 5];
/// Height from which it falls [m].
const HEIGHT: f64 = 0.5;

/// A ball that bounces to rest.
pub(crate) fn bouncing_ball() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    for e in BALLS {
        let radius = 0.02;
        let start = State {
            pose: Pose { centre: Vec2::new(0.0, HEIGHT + radius), angle: 0.0 },
            twist: Twist::default(),
        };
        let shape = Shape::new(vec![Vec2::ZERO], radius).ok();
        let trace = walk("a ball", shape, 0.4 * MASS * radius * radius, floor(0.0, e), start, 10_000)?;
        for n in REBOUNDS {
            let missing = || ValidationError::missing(format!("rebound {n} of the ball"));
            let speed = trace.impacts.get(n - 1).ok_or_else(missing)?.after.velocity.y;
            values.put(format!("height.{e}.{n}"), speed * speed / (2.0 * G));
        }
        let last = trace.pieces.last().ok_or_else(|| ValidationError::missing("rest of the ball"))?;
        values.put(format!("time.{e}"), last.end_time);
    }
    Ok(values)
}

/// Radius of the discs [m].
const RADIUS: f64 = 0.05;
/// J/(m r²) of what rolls.
const ROUNDS: [(&str, f64); 3] = [("hoop", 1.0), ("disc", 0.5), ("sphere", 0.4)];
/// Friction at the edge where the start of slipping is asked.
const EDGES: [f64; 3] = [0.3, 0.5, 1.0];
/// Friction that stands for as much as it takes.
const UNBOUNDED: f64 = 1e5;

fn round() -> Option<Shape> {
    Shape::new(vec![Vec2::ZERO], RADIUS).ok()
}

/// It turns over an edge as if it had started from the upright: where it ends to stick, and where it leaves [deg].
fn over_edge(ratio: f64, friction: f64) -> Result<[f64; 2], ValidationError> {
    let (half, _) = sin_cos(0.5 * LEAN);
    // (1 + b) r² θ̇²/2 = g r (1 − cos θ) where it rolls; a smooth edge lets it slide without a spin.
    let turns = if friction > 0.0 { 1.0 + ratio } else { 1.0 };
    let rate = 2.0 * half * (G / (turns * RADIUS)).sqrt();
    let (sin, cos) = sin_cos(LEAN);
    let start = about_origin(Vec2::new(sin, cos) * RADIUS, 0.0, -rate);
    let spin = if friction > 0.0 { -rate } else { 0.0 };
    let start = State { twist: Twist { spin, ..start.twist }, ..start };
    let table = Obstacle::new(Vec2::new(-1.0, 0.0), Vec2::ZERO, friction, 0.0);
    let trace = walk("a disc on an edge", round(), ratio * MASS * RADIUS * RADIUS, table, start, FALL)?;
    let angle = |piece: &Piece| {
        let centre = piece.end.pose.centre;
        atan2(centre.x, centre.y).to_degrees()
    };
    let on_edge = |piece: &&Piece| piece.held.len() == 1;
    let sticks = |piece: &&Piece| on_edge(piece) && piece.held[0].slip == Slip::Sticks;
    let left = trace.pieces.iter().rfind(|p| on_edge(p) && matches!(p.ended_by, PieceEnd::ForceZero(_)));
    let left = left.ok_or_else(|| ValidationError::missing("a disc that leaves the edge"))?;
    let stuck = trace.pieces.iter().find(sticks).map_or(f64::NAN, angle);
    Ok([stuck, angle(left)])
}

/// A round body that rolls or slides off the edge of a table.
pub(crate) fn rolling_off() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    values.put("smooth", over_edge(0.5, 0.0)?[1]);
    for (name, ratio) in ROUNDS {
        values.put(format!("leaves.{name}"), over_edge(ratio, UNBOUNDED)?[1]);
        for friction in EDGES {
            values.put(format!("slips.{name}.{friction}"), over_edge(ratio, friction)?[0]);
        }
    }
    Ok(values)
}

/// Slope of the plates [deg] and way to their edge [m].
const SLOPE: f64 = 20.0;
const WAY: f64 = 0.5;
/// Friction of the blocks that slide.
const BLOCKS: [f64; 3] = [0.0, 0.15, 0.3];

/// What a body does that is let go on a plate, 0.5 m before its edge at the origin, down to the right.
fn on_slope(
    shape: Option<Shape>,
    inertia: f64,
    height: f64,
    slope: f64,
    friction: f64,
) -> Result<Trace, ValidationError> {
    let along = Vec2::at_angle(-slope);
    let plate = Obstacle::new(along * -2.0, Vec2::ZERO, friction, 0.0);
    let pose = Pose { centre: along * -WAY + along.turned_left() * height, angle: -slope };
    walk("a body on a slope", shape, inertia, plate, State { pose, twist: Twist::default() }, FALL)
}

fn block(slope: f64, friction: f64) -> Result<Trace, ValidationError> {
    // Without thickness it begins to tip where its centre is over the edge.
    let rod = Shape::new(vec![Vec2::new(-0.05, 0.0), Vec2::new(0.05, 0.0)], 0.0).ok();
    on_slope(rod, MASS * 0.01 / 12.0, 0.0, slope, friction)
}

fn first(trace: &Trace) -> Result<&Piece, ValidationError> {
    trace.pieces.first().ok_or_else(|| ValidationError::missing("a motion on the slope"))
}

/// Blocks that slide down an incline, and round bodies that roll.
pub(crate) fn incline() -> Result<Values, ValidationError> {
    let mut values = Values::default();
    let slope = SLOPE.to_radians();
    for friction in BLOCKS {
        let trace = block(slope, friction)?;
        let slide = trace.pieces.iter().find(|piece| matches!(piece.ended_by, PieceEnd::ForceZero(_)));
        let slide = slide.ok_or_else(|| ValidationError::missing("a block that gets to the edge"))?;
        values.put(format!("time.{friction}"), slide.end_time);
        values.put(format!("speed.{friction}"), slide.end.twist.velocity.norm());
    }
    let rests = |degrees: f64| Ok(first(&block(degrees.to_radians(), 0.3)?)?.ended_by == PieceEnd::Rests);
    values.put("angle", border([1.0, 60.0], rests)?);
    for (name, ratio) in ROUNDS {
        let inertia = ratio * MASS * RADIUS * RADIUS;
        let roll = on_slope(round(), inertia, RADIUS, slope, 0.5)?;
        values.put(format!("roll.{name}"), first(&roll)?.end.twist.velocity.norm());
        let rolls = |degrees: f64| {
            let trace = on_slope(round(), inertia, RADIUS, degrees.to_radians(), 0.1)?;
            Ok(first(&trace)?.held.first().is_some_and(|held| held.slip == Slip::Sticks))
        };
        values.put(format!("limit.{name}"), border([1.0, 60.0], rolls)?);
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_num::elementary::cos;

    #[test]
    fn a_stick_let_go_from_rest_leans_as_it_is_told() {
        let trace = stick(0.5, 0.3, 0.0).unwrap();
        let start = trace.pieces[0].start;
        assert!((tilt(&start) - 0.3_f64.to_degrees()).abs() < 1e-12, "{start:?}");
        assert!((start.pose.centre.y - 0.5 * cos(0.3)).abs() < 1e-15, "{start:?}");
    }
}
