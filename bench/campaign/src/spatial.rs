//! Whole drops of solid parts through feeders in space.

use crate::draw;
use crate::feeders::{faulty, ready};
use crate::tally::Tally;
use carom_feeder::Stop;
use carom_feeder::spatial::{CrossSection, Feeder, Part, Plate, Run, Start, Wall, WallForm};
use carom_motion::spatial::{Face, Options, Plane, Polyhedron, Solid, State, World};
use carom_num::segment::distance;
use carom_num::{Mat3, Vec2, Vec3};
use rand::RngExt;
use rand_pcg::Pcg64;

/// Budgets of a run: steps, impacts, time [s].
const BUDGET: (u64, u64, f64) = (20_000, 2_000, 30.0);
/// Growth of energy against the largest there was.
const CLOSE: f64 = 1e-8;
/// Deepest overlap, in units of the part's size.
const DEEP: f64 = 1e-9;
/// Looks for a touch after which a drop counts as slow; a usual one takes 10⁴.
const SLOW: u64 = 10_000_000;
/// Points of a body are one face within this part of its size.
const FLAT: f64 = 1e-9;

/// One case: a random solid through a random feeder.
pub(crate) fn case(seed: u64, number: u64, tally: &mut Tally) {
    let rng = &mut draw::numbers(seed, number);
    let Some((feeder, pieces)) = feeder(rng) else { return tally.count("drawn: no solid") };
    let (most_steps, most_impacts, most_time) = BUDGET;
    let options = Options { most_time, most_steps, most_impacts, ..Options::default() };
    let Some(prepared) = ready(feeder.prepare(options), number, tally) else { return };
    match prepared.run() {
        Err(fault) => faulty(&fault, number, tally),
        Ok(run) => {
            tally.count(format!("{:?}", run.outcome));
            tally.residual("energy gained", gained(prepared.world(), &run), CLOSE, number);
            tally.residual("deepest overlap", deepest(&feeder, &pieces, &run), DEEP, number);
            if run.effort.event_evaluations > SLOW {
                tally.breaks("a search without end", number);
            }
            if !run.end_time.is_finite() {
                tally.breaks("a result that is no number", number);
            }
        }
    }
}

/// How much energy any instant has more than one before it, in units of the largest kinetic one. Where a series of impacts is closed, the friction of its last ones is
/// taken back, and works again until the limit: until then nothing is compared.
fn gained(world: &World, run: &Run) -> f64 {
    let (mut least, mut most, mut gained) = (f64::INFINITY, f64::MIN_POSITIVE, 0.0_f64);
    let (mut closings, mut until) = (run.closings.iter().peekable(), 0.0);
    for (time, _, state) in &run.samples.instants {
        while let Some(closing) = closings.next_if(|closing| closing.time <= *time) {
            until = closing.limit.max(until);
        }
        if *time < until {
            continue;
        }
        let kinetic = state.kinetic(world.body());
        let energy = kinetic + state.potential(world);
        most = most.max(kinetic);
        gained = gained.max(energy - least);
        least = least.min(energy);
    }
    gained / most
}

/// The deepest that the part is in a plate at any instant, in units of its size.
fn deepest(feeder: &Feeder, pieces: &[Polyhedron], run: &Run) -> f64 {
    let body = &feeder.part.body;
    let size = body.reach();
    let radius = body.rounding().unwrap_or_default();
    let mut sheets: Vec<([Vec3; 4], f64)> =
        feeder.plates.iter().flat_map(|plate| plate.sheets(size)).collect();
    // A pin is a sheet without width.
    sheets.extend(feeder.walls.iter().filter_map(|wall| match wall.form {
        WallForm::Pin { ends: [from, to], radius } => Some(([from, from, to, to], radius)),
        _ => None,
    }));
    let mut deepest = 0.0_f64;
    for (_, _, state) in &run.samples.instants {
        let solids: Vec<Convex> = pieces.iter().map(|piece| Convex::of(piece, state)).collect();
        let near = |(sheet, round): &&([Vec3; 4], f64)| is_near(state, size + round, sheet);
        let depth = |(sheet, round): &([Vec3; 4], f64)| {
            solids.iter().map(|solid| solid.depth(sheet, radius + round)).fold(0.0, f64::max)
        };
        deepest = sheets.iter().filter(near).map(depth).fold(deepest, f64::max);
        for wall in &feeder.walls {
            if let WallForm::Beside { z } = wall.form {
                let beyond = |corner: &Vec3| corner.z * z.signum() - z.abs();
                let corners = solids.iter().flat_map(|solid| &solid.corners);
                deepest = corners.map(|r| beyond(r) + radius).fold(deepest, f64::max);
            }
        }
    }
    deepest / size
}

/// The plane of a sheet passes through the ball about the part.
fn is_near(state: &State, size: f64, sheet: &[Vec3; 4]) -> bool {
    let normal = (sheet[1] - sheet[0]).cross(sheet[3] - sheet[0]);
    normal.dot(state.centre - sheet[0]).abs() <= size * normal.norm()
}

/// A convex solid in its place.
struct Convex {
    corners: Vec<Vec3>,
    edges: Vec<[Vec3; 2]>,
    normals: Vec<Vec3>,
    faces: Vec<Vec<Vec3>>,
}

impl Convex {
    fn of(piece: &Polyhedron, state: &State) -> Self {
        let place = |i: usize| state.place(piece.vertices()[i]);
        let faces = || piece.faces().iter();
        let of_face = |face: &Face| {
            let next = |k: usize| face.corners[(k + 1) % face.corners.len()];
            (0..face.corners.len()).map(|k| [face.corners[k], next(k)]).collect::<Vec<_>>()
        };
        let edges = faces().flat_map(of_face).filter(|[a, b]| a < b);
        Self {
            corners: (0..piece.vertices().len()).map(place).collect(),
            edges: edges.map(|ends| ends.map(place)).collect(),
            normals: faces().map(|face| state.attitude.apply(face.normal)).collect(),
            faces: faces().map(|face| face.corners.iter().map(|i| place(*i)).collect()).collect(),
        }
    }

    /// How far a sheet has to be moved at least to leave it, where balls of these radii, together, are about all places of both; 0 where it is beside it.
    fn depth(&self, sheet: &[Vec3; 4], radius: f64) -> f64 {
        let sharp = self.sharp_depth(sheet);
        if radius == 0.0 || sharp > 0.0 {
            return if sharp > 0.0 { sharp + radius } else { 0.0 };
        }
        (radius - self.distance(sheet)).max(0.0)
    }

    /// How far a sheet beside the sharp one is from it: between edges, or from a corner of one to a face of the other.
    fn distance(&self, sheet: &[Vec3; 4]) -> f64 {
        let of_sheet: Vec<[Vec3; 2]> = sides(sheet).collect();
        let edges = self.edges.iter().flat_map(|own| of_sheet.iter().map(|side| distance(*own, *side)));
        let own = self.corners.iter().map(|corner| over(sheet, *corner));
        let faces = self.faces.iter().flat_map(|face| sheet.iter().map(|corner| over(face, *corner)));
        edges.chain(own).chain(faces).fold(f64::INFINITY, f64::min)
    }

    /// The depth of the sharp one, by the axes along which two convex bodies can be apart.
    fn sharp_depth(&self, sheet: &[Vec3; 4]) -> f64 {
        let sides = [sheet[1] - sheet[0], sheet[3] - sheet[0]];
        let crossed = self.edges.iter().flat_map(|[a, b]| sides.map(|side| (*b - *a).cross(side)));
        let own = self.normals.iter().copied().chain([sides[0].cross(sides[1])]);
        let mut least = f64::INFINITY;
        for axis in own.chain(crossed).filter_map(Vec3::unit) {
            let range = |points: &[Vec3]| {
                let along = points.iter().map(|point| axis.dot(*point - sheet[0]));
                along.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)])
            };
            let ([a, b], [c, d]) = (range(&self.corners), range(sheet));
            least = least.min((b - c).min(d - a));
            if least <= 0.0 {
                return 0.0;
            }
        }
        least
    }
}

fn sides(corners: &[Vec3]) -> impl Iterator<Item = [Vec3; 2]> {
    (0..corners.len()).map(|k| [corners[k], corners[(k + 1) % corners.len()]])
}

/// How far a place is from a face that it is above or below; infinite of others.
fn over(face: &[Vec3], place: Vec3) -> f64 {
    let Some(normal) = (face[1] - face[0]).cross(face[2] - face[1]).unit() else { return f64::INFINITY };
    let inside = sides(face).all(|[a, b]| normal.cross(b - a).dot(place - a) >= 0.0);
    if inside { normal.dot(place - face[0]).abs() } else { f64::INFINITY }
}

/// The same part with round edges, now and then: where three faces meet at every corner.
fn rounded(rng: &mut Pcg64, part: Part) -> Part {
    let thin = part.faces.iter().map(|face| face.depth).fold(f64::INFINITY, f64::min);
    let (round, radius) = (rng.random_bool(0.3), thin * draw::across(rng, 0.01, 0.9));
    let hull = Polyhedron::of_points(part.body.supports(), FLAT * part.body.reach());
    let rounding = hull.ok().filter(|_| round).and_then(|hull| hull.rounded(radius).ok());
    let density = 7850.0;
    let made = rounding.and_then(|rounding| {
        let heft = (rounding.solid.volume * density, rounding.solid.inertia * density);
        Part::about((&rounding.inner, radius), rounding.solid.centre, heft).ok()
    });
    made.filter(|made| made.faces.len() == part.faces.len()).unwrap_or(part)
}

/// A box, a tetrahedron, a prism or the hull of some points.
fn solid(rng: &mut Pcg64) -> Option<Part> {
    let size = draw::across(rng, 2e-3, 0.1);
    let mut point = |half: Vec3| {
        let [x, y, z] = [half.x, half.y, half.z].map(|half| draw::between(rng, -half, half));
        Vec3::new(x, y, z)
    };
    let cube = Vec3::new(size, size, size);
    let cloud: Vec<Vec3> = (0..9).map(|_| point(cube)).collect();
    let points = match rng.random_range(0..4) {
        0 => {
            let [x, y, z] = [0; 3].map(|_: i32| size * draw::across(rng, 0.02, 1.0));
            let sign = |bit: usize| if bit == 0 { -1.0 } else { 1.0 };
            (0..8).map(|i: usize| Vec3::new(sign(i & 1) * x, sign(i & 2) * y, sign(i & 4) * z)).collect()
        }
        1 => cloud[..4].to_vec(),
        2 => {
            let (sides, high) = (rng.random_range(3..33), size * draw::across(rng, 0.02, 3.0));
            let corner = |i: u32| {
                let at = Vec2::at_angle(std::f64::consts::TAU * f64::from(i / 2) / f64::from(sides));
                Vec3::new(size * at.x, size * at.y, if i.is_multiple_of(2) { -high } else { high })
            };
            (0..2 * sides).map(corner).collect()
        }
        _ => cloud,
    };
    let hull = Polyhedron::of_points(&points, FLAT).ok()?;
    Part::of(&hull, &hull.solid().ok()?, 7850.0).ok()
}

/// The part by convex pieces, in its axes from the mass centre: now and then with a hollow, of what is beyond two planes; else one.
fn hollowed(rng: &mut Pcg64, part: Part) -> Option<(Part, Vec<Polyhedron>)> {
    let hull = Polyhedron::of_points(part.body.supports(), FLAT * part.body.reach()).ok()?;
    let reach = part.body.reach();
    let mut plane = || {
        let normal = Vec3::new(
            draw::between(rng, -1.0, 1.0),
            draw::between(rng, -1.0, 1.0),
            draw::between(rng, -1.0, 1.0),
        );
        Plane::new(normal.unit().unwrap_or(Vec3::Z), reach * draw::between(rng, -0.4, 0.4)).ok()
    };
    let (first, second) = (plane()?, plane()?);
    let round = part.body.rounding() != Some(0.0);
    let whole = (part, vec![hull.clone()]);
    if round || rng.random_bool(0.7) {
        return Some(whole);
    }
    Some(in_pieces(&hull, [first, second], FLAT * reach).unwrap_or(whole))
}

/// What of a solid is behind one of two planes at least.
fn in_pieces(
    hull: &Polyhedron,
    [first, second]: [Plane; 2],
    flatness: f64,
) -> Option<(Part, Vec<Polyhedron>)> {
    let flipped = Plane::new(-first.normal(), first.height(Vec3::ZERO)).ok()?;
    let beyond = hull.behind(&flipped, flatness)?;
    let pieces = vec![hull.behind(&first, flatness)?, beyond.behind(&second, flatness)?];
    let solids: Vec<Solid> = pieces.iter().map(|piece| piece.solid().ok()).collect::<Option<_>>()?;
    let volume: f64 = solids.iter().map(|solid| solid.volume).sum();
    let centre = solids.iter().fold(Vec3::ZERO, |sum, solid| sum + solid.centre * (solid.volume / volume));
    let about = |solid: &Solid| {
        let arm = solid.centre - centre;
        let square = arm.dot(arm);
        solid.inertia + (Mat3::diagonal(square, square, square) - Mat3::dyad(arm, arm)) * solid.volume
    };
    let inertia = solids.iter().map(about).fold(Mat3::ZERO, |sum, inertia| sum + inertia);
    let places: Vec<Vec3> = pieces.iter().flat_map(Polyhedron::vertices).copied().collect();
    let hull = Polyhedron::of_points(&places, flatness).ok()?;
    let density = 7850.0;
    let part = Part::of_pieces((&hull, &pieces), centre, (density * volume, inertia * density)).ok()?;
    Some((part, pieces.iter().map(|piece| piece.moved_by(-centre)).collect()))
}

/// A round bar, long or short, below the free edge of the first plate.
fn pin(rng: &mut Pcg64, i: usize, size: f64, edge: Vec2) -> Wall {
    let radius = size * draw::across(rng, 0.02, 1.0);
    let mut near = |far: f64| size * draw::between(rng, -far, far);
    let from = Vec3::new(edge.x + near(3.0), edge.y - 4.0 * size + near(1.5), near(2.0));
    let to = from + Vec3::new(near(2.0), near(1.0), near(4.0));
    Wall {
        name: format!("pin{i}"),
        form: WallForm::Pin { ends: [from, to], radius },
        friction: draw::friction(rng),
        restitution: draw::restitution(rng).min(0.95),
    }
}

/// Now and then all plates are sheets with round edges; now and then some are V grooves.
fn rounded_or_bent(rng: &mut Pcg64, plates: &mut [Plate], size: f64) {
    if rng.random_bool(0.2) {
        for plate in &mut *plates {
            let short = plate.width.unwrap_or(size).min((plate.edge - plate.uphill).norm()).min(size);
            plate.edge_radius = short * draw::across(rng, 0.01, 0.4);
        }
    }
    if rng.random_bool(0.2) {
        for plate in plates {
            if rng.random_bool(0.5) {
                plate.cross_section = CrossSection::Groove { angle: draw::between(rng, 0.4, 2.8) };
                plate.edge_radius *= 0.5;
            }
        }
    }
}

/// Two to four plates that zigzag, with a roll, ends and side walls now and then, now and then V grooves, and now and then a groove about all.
fn feeder(rng: &mut Pcg64) -> Option<(Feeder, Vec<Polyhedron>)> {
    let part = solid(rng)?;
    let size = part.body.reach();
    let (mut plates, mut place) = (vec![], Vec2::ZERO);
    for i in 0..rng.random_range(2..5) {
        let slope = draw::between(rng, 2.0, if i == 0 { 50.0 } else { 30.0 });
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let down = Vec2::at_angle(-slope.to_radians());
        let down = Vec2::new(side * down.x, down.y);
        let uphill = place - down * (size * draw::between(rng, 4.0, 12.0));
        let edge = if i == 0 { place } else { place + down * (size * draw::between(rng, 0.5, 10.0)) };
        let width = rng.random_bool(0.7).then(|| size * draw::between(rng, 2.2, 6.0));
        plates.push(Plate {
            name: format!("p{i}"),
            uphill,
            edge,
            width,
            roll: if rng.random_bool(0.5) { draw::between(rng, -0.2, 0.2) } else { 0.0 },
            edge_radius: 0.0,
            cross_section: if width.is_some() && rng.random_bool(0.5) {
                CrossSection::Walled { height: size * draw::between(rng, 0.2, 2.0) }
            } else {
                CrossSection::Flat
            },
            friction: draw::friction(rng),
            restitution: draw::restitution(rng).min(0.95),
            unbounded: false,
        });
        place = edge
            + Vec2::new(side * size * draw::between(rng, 0.5, 3.0), -size * draw::between(rng, 1.0, 10.0));
    }
    let groove = size * draw::between(rng, 1.1, 3.0);
    let walls = if rng.random_bool(0.2) { vec![-groove, groove] } else { vec![] };
    let beside = |(i, z): (usize, f64)| Wall {
        name: format!("w{i}"),
        form: WallForm::Beside { z },
        friction: draw::friction(rng),
        restitution: draw::restitution(rng).min(0.95),
    };
    let mut walls: Vec<Wall> = walls.into_iter().enumerate().map(beside).collect();
    let start = Start {
        to_edge: size * draw::between(rng, 1.1, 3.5),
        aside: if rng.random_bool(0.5) { size * draw::between(rng, -0.3, 0.3) } else { 0.0 },
        turn: if rng.random_bool(0.7) { draw::between(rng, -3.2, 3.2) } else { 0.0 },
        speed: draw::between(rng, 0.0, 1.0),
        face: rng.random_range(0..part.faces.len()),
    };
    let stop = if rng.random_bool(0.5) { Stop::Landed } else { Stop::Delivered };
    let law = draw::law(rng);
    let part = rounded(rng, part);
    if rng.random_bool(0.2) {
        let edge = plates[0].edge;
        walls.extend((0..rng.random_range(1..4)).map(|i| pin(rng, i, size, edge)));
    }
    rounded_or_bent(rng, &mut plates, size);
    let start = Start { aside: if plates[0].cross_section.is_groove() { 0.0 } else { start.aside }, ..start };
    let (part, pieces) = hollowed(rng, part)?;
    let start = Start { face: start.face % part.faces.len(), ..start };
    Some((Feeder { gravity: 9.81, stop, law, part, start, plates, walls }, pieces))
}
