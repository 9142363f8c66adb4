//! Drops of parts with hollows: what becomes of each, and how near it is to becoming something else.

use crate::feeders;
use carom_feeder::{Decided, Feeder, Outcome, Part, PartKind, Run, Start};
use carom_impact::planar::ImpactType;
use carom_motion::planar::{Body, ChainPoint, MassProperties, Options, Shape};
use carom_num::Vec2;

/// Mass of a part [kg].
const MASS: f64 = 0.02;
/// By how much a scene is moved to see whether the part ends otherwise: so many mm of distances, or per cent of friction.
const MOVED: [f64; 9] = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0];
/// Time after the first touch at which the spin is noted [s].
const AFTER: f64 = 0.005;

/// A scene: the plates and the start; the outline of the part [m].
#[derive(Clone)]
struct Scene {
    slope_deg: f64,
    along: f64,
    normal: f64,
    to_edge: f64,
    friction: f64,
    face: usize,
    outline: Vec<Vec2>,
}

/// What became of it.
#[derive(PartialEq)]
enum End {
    Lies(usize),
    Other(Outcome),
}

/// Answers a list of scenes as one line of JSON.
pub fn write(text: &str) -> Result<(), String> {
    let drops = text.lines().skip(1).map(|line| answer(&read(line)?)).collect::<Result<Vec<_>, _>>()?;
    println!("{{\"drops\": [{}]}}", drops.join(", "));
    Ok(())
}

fn read(line: &str) -> Result<Scene, String> {
    let wrong = || format!("no scene: {line}");
    let fields: Vec<&str> = line.split(',').collect();
    let [slope_deg, along, normal, to_edge, friction, face, _, outline] = fields[..] else {
        return Err(wrong());
    };
    let number = |word: &str| word.parse::<f64>().map_err(|_| wrong());
    let outline = outline.split(' ').map(number).collect::<Result<Vec<_>, _>>()?;
    Ok(Scene {
        slope_deg: number(slope_deg)?,
        along: number(along)?,
        normal: number(normal)?,
        to_edge: number(to_edge)?,
        friction: number(friction)?,
        face: face.parse().map_err(|_| wrong())?,
        outline: outline.chunks(2).map(|xy| Vec2::new(xy[0], xy[1])).collect(),
    })
}

impl Scene {
    /// The part as one outline with its hollows, about its mass centre.
    fn part(&self) -> Result<Part, String> {
        let shape = |about: Vec2| {
            let chain: Vec<ChainPoint> =
                self.outline.iter().map(|p| ChainPoint::straight(*p - about)).collect();
            Shape::of_chain(&chain).map_err(|problems| format!("{problems:?}"))
        };
        let drawn = MassProperties::of(&shape(Vec2::ZERO)?);
        let inertia = MASS * drawn.gyration_squared;
        Ok(Part {
            kind: PartKind::Polygon,
            body: Body { shape: shape(drawn.centroid)?, mass: MASS, inertia },
        })
    }

    fn feeder(&self) -> Result<Feeder, String> {
        let design = feeders::Design { slope_deg: self.slope_deg, along: self.along, normal: self.normal };
        let mut feeder = feeders::feeder(design, 0.0).ok_or("no feeder")?;
        for plate in &mut feeder.plates {
            plate.friction = self.friction;
        }
        feeder.part = self.part()?;
        feeder.start = Start { to_edge: self.to_edge, speed: 0.0, face: self.face };
        Ok(feeder)
    }

    fn end(&self) -> Result<End, String> {
        let feeder = self.feeder()?;
        let prepared = feeder.prepare(Options::default()).map_err(|error| error.to_string())?;
        Ok(end(&prepared.run_untraced().map_err(|error| error.to_string())?))
    }

    /// The smallest of `MOVED` with which the part ends otherwise, and what was moved.
    fn flips(&self) -> Result<Option<(f64, &'static str)>, String> {
        let own = self.end()?;
        for by in MOVED {
            for sign in [-1.0, 1.0] {
                let (mm, share) = (sign * by * 1e-3, 1.0 + sign * by * 1e-2);
                // The lower plate keeps its slope.
                let nearer = (self.normal + mm) / self.normal;
                let plate = Self { normal: self.normal * nearer, along: self.along * nearer, ..self.clone() };
                let start = Self { to_edge: self.to_edge + mm, ..self.clone() };
                let friction = Self { friction: self.friction * share, ..self.clone() };
                for (scene, what) in [(plate, "plate"), (start, "start"), (friction, "friction")] {
                    if scene.end()? != own {
                        return Ok(Some((by, what)));
                    }
                }
            }
        }
        Ok(None)
    }
}

fn end(run: &Run) -> End {
    let landing = run.landings.last().filter(|landing| landing.plate == 1);
    match landing.and_then(|landing| landing.face) {
        Some(face) if run.outcome == Outcome::Landed => End::Lies(face),
        _ => End::Other(run.outcome),
    }
}

fn answer(scene: &Scene) -> Result<String, String> {
    let feeder = scene.feeder()?;
    let run = feeder.prepare(Options::default()).and_then(|prepared| prepared.run());
    let run = run.map_err(|error| error.to_string())?;
    let struck = run.trace.impacts.iter().find(|impact| impact.contacts.iter().any(|c| c.obstacle == 1));
    let touch = struck.map(|impact| impact.time);
    let spins = struck.map(|impact| {
        let after = spin_at(&run, impact.time + AFTER);
        format!("[{}, {after}]", impact.before.spin)
    });
    let (down, up) = feeder.plates.get(1).map_or((Vec2::ZERO, Vec2::ZERO), |p| (p.edge, p.uphill));
    let plate = carom_num::elementary::atan2((up - down).y, (up - down).x);
    let lies = run.landings.last().and_then(|landing| landing.flat);
    let (face, outcome) = match end(&run) {
        End::Lies(face) => (Some(face.to_string()), "Landed".to_string()),
        End::Other(outcome) => (None, format!("{outcome:?}")),
    };
    let (decided, decided_at) = match run.margin_of {
        Decided::Nothing => ("nothing", None),
        Decided::Contacts { time } => ("contacts", Some(time)),
        Decided::Impact { time } => ("impact", Some(time)),
    };
    let flips = scene.flips()?;
    Ok(format!(
        "{{\"face\": {}, \"outcome\": \"{outcome}\", \"touch\": {}, \"lies\": {}, \"tilt\": {}, \"spins\": {}, \
         \"margin\": {}, \"decided\": \"{decided}\", \"decided_at\": {}, \"hooks\": {}, \"strikes\": {}, \"reversals\": {}, \
         \"flips_by\": {}, \"flips_what\": \"{}\", \"inertia\": {}}}",
        or_null(face),
        or_null(touch),
        or_null(lies.filter(|_| run.outcome == Outcome::Landed)),
        or_null(struck.map(|impact| impact.pose.angle - plate)),
        or_null(spins),
        run.margin,
        or_null(decided_at),
        strikes(&run, 0),
        strikes(&run, 1),
        reversals(&run),
        or_null(flips.map(|(by, _)| by)),
        flips.map_or("", |(_, what)| what),
        feeder.part.body.inertia,
    ))
}

/// The spin at a time, between samples counted on straight; none once the part lies, where the run ends.
fn spin_at(run: &Run, time: f64) -> f64 {
    if time >= run.end_time {
        return 0.0;
    }
    let piece = run.trace.pieces.iter().rfind(|piece| piece.start_time <= time);
    let samples = piece.map_or(&[][..], |piece| &piece.samples);
    let before = samples.iter().rfind(|sample| sample.time <= time);
    let after = samples.iter().find(|sample| sample.time > time).or(before);
    let (Some(before), Some(after)) = (before, after) else { return 0.0 };
    let span = after.time - before.time;
    let share = if span > 0.0 { (time - before.time) / span } else { 0.0 };
    before.state.twist.spin + share * (after.state.twist.spin - before.state.twist.spin)
}

/// How many strikes on a plate there are.
fn strikes(run: &Run, plate: usize) -> usize {
    run.trace.impacts.iter().filter(|impact| impact.contacts.iter().any(|c| c.obstacle == plate)).count()
}

/// In how many strikes of one contact the slip reverses.
fn reversals(run: &Run) -> usize {
    let reverses =
        |kind| matches!(kind, ImpactType::ReversesInCompression | ImpactType::ReversesInRestitution);
    run.trace.impacts.iter().filter(|impact| impact.kind.is_some_and(reverses)).count()
}

fn or_null(value: Option<impl ToString>) -> String {
    value.map_or("null".to_string(), |value| value.to_string())
}
