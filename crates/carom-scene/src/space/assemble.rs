//! From a drawing to a feeder in space.

use super::rests::{rests, shares};
use crate::approximation::Approximation;
use crate::assemble::{crossing_notes, engine_problems, laid_out, plate as flat_plate, walls as flat_walls};
use crate::drawing::{Drawing, MassSpec, Outline, PlateDrawing, Want};
use crate::part_drawing::SolidDrawing;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::roll::spatial::ThrownShape;
use crate::scene::quantities;
use crate::surfaces::{contact_notes, surface_of};
use crate::tolerance::ONE_FACE;
use crate::unit::Dimension;
use carom_feeder::spatial::{CrossSection, Feeder, Part, Plate, Start, Wall, WallForm};
use carom_motion::spatial::{Body, BodyProblem, Options, Polyhedron, Supports};
use carom_num::Vec3;

/// A feeder and what is known about its drawing.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SpaceAssembled {
    pub(crate) feeder: Feeder,
    pub(crate) shape: ThrownShape,
    /// The mass centre, in the axes of the drawing \[m\].
    pub(crate) centre: carom_num::Vec3,
    pub(crate) notes: Vec<String>,
    pub(crate) approximations: Vec<Approximation>,
    pub(crate) wants: Vec<Option<Want>>,
}

/// Lays out a drawing whose part is a solid.
pub(crate) fn assemble(drawing: &Drawing) -> Result<SpaceAssembled, Vec<Problem>> {
    let Outline::Solid(solid) = &drawing.part.outline else { return Err(vec![]) };
    let mut problems = vec![];
    let part = build(solid, drawing).map_err(|found| problems.extend(found)).ok();
    let size = part.as_ref().map_or(0.0, |part| 2.0 * part.body.reach());
    let run = drawing.start.to_edge.value + size;
    let (placed, found) = laid_out(drawing, run);
    problems.extend(found);
    let (Some(part), Some(placed)) = (part, placed) else { return Err(problems) };
    let drawn = &drawing.plates;
    let faces = part.faces.len();
    problems.extend(drawing.start.faces.problems(faces, &drawing.start));
    problems.extend(drawn.iter().filter_map(|plate| unwanted(plate, faces)));
    let plates =
        drawn.iter().zip(&placed).map(|(drawn, placed)| wide(drawn, flat_plate(drawing, drawn, placed)));
    let value = |quantity: &Option<Quantity>| quantity.as_ref().map_or(0.0, |quantity| quantity.value);
    let centre = solid.centre.unwrap_or(solid.shape.solid.centre);
    let start = Start {
        to_edge: drawing.start.to_edge.value,
        aside: value(&drawing.start.aside),
        turn: value(&drawing.start.turn),
        speed: drawing.start.speed.value,
        face: drawing.start.faces.usual(|| shares(&part, &solid.shape, centre)),
    };
    let feeder = Feeder {
        gravity: drawing.gravity.value,
        stop: drawing.stop,
        law: drawing.contact.law,
        start,
        plates: plates.collect(),
        walls: walls(drawing, flat_walls(drawing, &placed, run)),
        part,
    };
    if problems.is_empty() {
        let found = feeder.prepare(Options::default()).err();
        let found = found.into_iter().flat_map(|found| engine_problems(found, drawn));
        problems.extend(found.map(|problem| placed_in_file(problem, drawing, &feeder)));
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let wants = drawn.iter().map(|plate| plate.want).collect();
    let shape = solid.shape.clone();
    let approximations = hull_of(&shape);
    let mut notes = contact_notes(drawing);
    notes.extend(crossing_notes(&feeder));
    let grooved = feeder.plates.iter().any(|plate| plate.cross_section.is_groove());
    notes.extend(grooved.then(|| IN_A_GROOVE.to_owned()));
    Ok(SpaceAssembled { feeder, notes, approximations, shape, centre, wants })
}

/// What a verdict says where two faces of the part may lie on one plate.
const IN_A_GROOVE: &str = "in a V groove the verdict names the face on the flank behind the drawing; where none lies on that flank, the face on the flank in front";

/// The faces of a box by their numbers: round it as in the plane, lower long side first; then those before and behind the drawing.
const BOX_FACES: [Vec3; 6] = [
    Vec3::new(0.0, -1.0, 0.0),
    Vec3::new(1.0, 0.0, 0.0),
    Vec3::new(0.0, 1.0, 0.0),
    Vec3::new(-1.0, 0.0, 0.0),
    Vec3::new(0.0, 0.0, 1.0),
    Vec3::new(0.0, 0.0, -1.0),
];

/// What is wrong with a radius that leaves nothing within it, or that no edge is told from a sharp one by.
fn unfit_radius(shape: &ThrownShape, centre: Vec3) -> Option<String> {
    let (inner, radius) = shape.touching();
    if radius == 0.0 {
        return None;
    }
    let reach = inner.vertices().iter().map(|r| (*r - centre).norm()).fold(0.0, f64::max) + radius;
    let width = |face: &carom_motion::spatial::Face| {
        let along = inner.vertices().iter().map(|r| face.normal.dot(*r));
        let [low, high] = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
        high - low
    };
    let thin = inner.faces().iter().map(width).fold(f64::INFINITY, f64::min);
    let show = |length| Dimension::Length.show(length);
    let least = Body::LEAST_ROUNDING * reach;
    if thin <= least {
        return Some(format!("{} is too large: nothing of the part is left between the balls", show(radius)));
    }
    let message = || {
        format!(
            "{} is too small beside the part: write {} or more, or leave it out",
            show(radius),
            show(least)
        )
    };
    (radius < least).then(message)
}

/// Why a hull has a face that cannot be followed, and what to do instead; `None` where it has none.
fn too_wide(hull: &Polyhedron) -> Option<(String, String)> {
    let largest = hull.faces().iter().map(|face| face.corners.len()).max().unwrap_or_default();
    let most = Supports::TOGETHER;
    let message =
        || format!("has a face of {largest} corners: at most {most} are followed, as all may touch at once");
    (largest > most).then(|| (message(), format!("draw its circles with at most {most} sides")))
}

/// The part: its hull, and what fills it.
fn build(solid: &SolidDrawing, drawing: &Drawing) -> Result<Part, Vec<Problem>> {
    let own = solid.shape.solid;
    let mass = match &drawing.part.mass {
        MassSpec::Mass(mass) => mass.value,
        MassSpec::Density { density, .. } => density.value * own.volume,
    };
    let inertia = solid.inertia.unwrap_or(own.inertia * (mass / own.volume));
    let centre = solid.centre.unwrap_or(own.centre);
    let span = Some(drawing.part.span.clone());
    let problem =
        |path: &str, message: String| Problem::new(ProblemKind::Geometry, path, message, span.clone());
    if let Some(message) = unfit_radius(&solid.shape, centre) {
        return Err(vec![problem("part.corner_radius", message)]);
    }
    if let Some((message, help)) = too_wide(solid.shape.touching().0) {
        return Err(vec![problem("part", message).with_help(help)]);
    }
    let found = if solid.shape.pieces.is_empty() {
        Part::about(solid.shape.touching(), centre, (mass, inertia))
    } else {
        Part::of_pieces((&solid.shape.hull, &solid.shape.pieces), centre, (mass, inertia))
    };
    let mut part = found.map_err(|problems| {
        let path = |found: &BodyProblem| match found {
            BodyProblem::Mass(_) => "part.mass",
            BodyProblem::Hidden { .. } => "part.hollows",
            _ => "part",
        };
        let told = |found: &BodyProblem| match found {
            BodyProblem::Count { count } => {
                format!("its hull has {count} corners: at most {} are followed", Body::MOST)
            }
            other => other.to_string(),
        };
        problems.iter().map(|found| problem(path(found), told(found))).collect::<Vec<_>>()
    })?;
    if solid.shape.word == "box" {
        part.faces.sort_by_key(|face| {
            BOX_FACES.iter().position(|normal| (*normal - face.normal).norm() < ONE_FACE)
        });
    }
    let least = part.faces.iter().min_by(|a, b| a.depth.total_cmp(&b.depth));
    let is_on_surface = || rests(&part, &solid.shape, centre).is_empty();
    if let Some(face) = least.filter(|face| face.depth <= 0.0 || is_on_surface()) {
        let out = Dimension::Length.show((-face.depth).max(0.0));
        return Err(vec![problem(
            "part.centre",
            format!("is {out} outside the hull: no body has its mass centre there"),
        )]);
    }
    Ok(part)
}

/// A problem of the whole by the key that it comes from, with the value as it is written.
fn placed_in_file(problem: Problem, drawing: &Drawing, feeder: &Feeder) -> Problem {
    let narrow = |path: &str, width: &Quantity, least: f64| {
        let show = |value| Dimension::Length.show(value);
        let (own, least) = (show(width.value), show(least));
        let message = format!("{own} is too narrow: the part takes {least} across where it starts");
        Problem::new(ProblemKind::Geometry, path, message, width.span.clone())
    };
    if problem.path == "wall.front wall" || problem.path == "wall.back wall" {
        let groove = drawing.groove.as_ref();
        return groove
            .map_or(problem, |groove| narrow("groove.width", &groove.width, feeder.groove_at_start()));
    }
    // The part lies on its plate: what crosses it there is a side wall.
    let first = drawing.plates.first().filter(|first| problem.path == format!("plate.{}", first.name));
    let walled = first.filter(|first| problem.kind == ProblemKind::Geometry && first.side_walls.is_some());
    let least = feeder.width_at_start();
    if let Some(width) = walled.and_then(|first| first.width.as_ref()).filter(|width| least >= width.value) {
        return narrow(&format!("{}.width", problem.path), width, least);
    }
    let quantities = quantities(drawing);
    let Some(of) = quantities.iter().find(|quantity| quantity.path == problem.path) else { return problem };
    let shown = of.kind.dimension.show(of.value);
    let allowed = problem.message.split_once(": ").map_or(problem.message.as_str(), |(_, allowed)| allowed);
    let message = format!("{shown} is out of range: {allowed}");
    Problem::new(ProblemKind::OutOfRange, &problem.path, message, of.span.clone().or(problem.span))
}

/// A plate of the drawing with its width.
fn wide(drawn: &PlateDrawing, plate: carom_feeder::Plate) -> Plate {
    let value = |quantity: &Option<Quantity>| quantity.as_ref().map(|quantity| quantity.value);
    Plate {
        name: plate.name,
        uphill: plate.uphill,
        edge: plate.edge,
        width: value(&drawn.width),
        roll: value(&drawn.roll).unwrap_or(0.0),
        cross_section: match (value(&drawn.v_angle), value(&drawn.side_walls)) {
            (Some(angle), _) => CrossSection::Groove { angle },
            (None, Some(height)) if height > 0.0 => CrossSection::Walled { height },
            (None, _) => CrossSection::Flat,
        },
        edge_radius: plate.form.edge_radius,
        friction: plate.friction,
        restitution: plate.restitution,
        unbounded: plate.unbounded,
    }
}

/// Walls across the drawing, then those beside it, then pins.
fn walls(drawing: &Drawing, flat: Vec<carom_feeder::Wall>) -> Vec<Wall> {
    let across = flat.into_iter().map(|wall| Wall {
        form: WallForm::Across { from: wall.from, to: wall.to, edge_radius: wall.form.edge_radius },
        name: wall.name,
        friction: wall.friction,
        restitution: wall.restitution,
    });
    let beside = drawing.groove.iter().flat_map(|groove| {
        let (_, restitution) = surface_of(drawing, &groove.surface);
        // Walls that only guide: what nobody says to rub is smooth.
        let friction = groove.surface.friction.as_ref().map_or(0.0, |friction| friction.value);
        [("front wall", 0.5), ("back wall", -0.5)].map(|(name, side)| Wall {
            name: name.to_owned(),
            form: WallForm::Beside { z: side * groove.width.value },
            friction,
            restitution,
        })
    });
    let pins = drawing.pins.iter().enumerate().map(|(i, pin)| {
        let (friction, restitution) = surface_of(drawing, &pin.surface);
        let ends = pin.ends.each_ref().map(|[x, y, z]| Vec3::new(x.value, y.value, z.value));
        let name = if pin.name == i.to_string() { format!("pin {}", i + 1) } else { pin.name.clone() };
        Wall { name, form: WallForm::Pin { ends, radius: pin.radius.value }, friction, restitution }
    });
    across.chain(beside).chain(pins).collect()
}

/// What is wanted of a plate that this part cannot do.
fn unwanted(plate: &PlateDrawing, faces: usize) -> Option<Problem> {
    let Some(Want::Face(face)) = plate.want.filter(|want| matches!(want, Want::Face(face) if *face >= faces))
    else {
        return None;
    };
    let message = format!("{face} is no face of this part: its faces are 0 to {}", faces.saturating_sub(1));
    let path = format!("plate.{}.want", plate.name);
    Some(Problem::new(ProblemKind::OutOfRange, path, message, Some(plate.span.clone())))
}

/// What the hull adds to a surface that is not convex.
fn hull_of(shape: &ThrownShape) -> Vec<Approximation> {
    let hull = shape.hull.solid().map_or(0.0, |hull| hull.volume);
    if shape.convex || !shape.pieces.is_empty() || hull <= 0.0 {
        return vec![];
    }
    vec![Approximation::hull_of_surface(1.0 - shape.solid.volume / hull)]
}
