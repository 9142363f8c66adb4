//! What a scene with a solid part draws.

use super::{DrawOptions, deliver, point, written};
use crate::args::Output;
use crate::failure::Failure;
use crate::printed::notes;
use crate::{faces, files};
use carom::tasks::space;
use carom_feeder::spatial::{CrossSection, Plate, WallForm};
use carom_figure::senses::slope;
use carom_num::{Mat3, Vec2};
use carom_scene::{Approximation, SolidFaceReport, SpaceScene, unit::Dimension};
use carom_words::{aligned, part};
use serde::Serialize;
use std::io::Write;

/// A plate as it lies.
#[derive(Serialize)]
struct Sheet {
    name: String,
    /// What people call it.
    #[serde(skip)]
    label: String,
    from_m: [f64; 2],
    to_m: [f64; 2],
    length_m: f64,
    slope_rad: f64,
    roll_rad: f64,
    /// Null where it is as wide as needed.
    width_m: Option<f64>,
    side_walls_m: f64,
    /// Of a V groove.
    #[serde(skip_serializing_if = "Option::is_none")]
    v_angle_rad: Option<f64>,
    /// What people read of both.
    #[serde(skip)]
    sides: String,
    /// Of a sheet with round edges.
    #[serde(skip_serializing_if = "Option::is_none")]
    edge_radius_m: Option<f64>,
    friction: f64,
    restitution: f64,
    /// True where the drawing gives no length.
    unbounded: bool,
    /// What the scene writes about it.
    written: Vec<String>,
}

/// A wall across the drawing, or beside it.
#[derive(Serialize)]
struct Wall {
    name: String,
    /// Its ends in the drawing; null of a wall beside it.
    ends_m: Option<[[f64; 2]; 2]>,
    /// Where a wall beside the drawing is; null of one across it.
    z_m: Option<f64>,
    /// Of a pin: its radius, and how far out of the drawing its ends are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pin_radius_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pin_ends_z_m: Option<[f64; 2]>,
    /// Of a wall with round edges.
    #[serde(skip_serializing_if = "Option::is_none")]
    edge_radius_m: Option<f64>,
    friction: f64,
    restitution: f64,
}

/// A scene as it is laid out.
#[derive(Serialize)]
struct Layout {
    scene: String,
    plates: Vec<Sheet>,
    walls: Vec<Wall>,
    mass_kg: f64,
    /// About the mass centre, in the part's axes, by rows.
    inertia_kg_m2: [[f64; 3]; 3],
    /// What the part can lie on.
    faces: Vec<SolidFaceReport>,
    start: Start,
    notes: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    approximations: Vec<Approximation>,
}

/// Where the part lies at the start.
#[derive(Serialize)]
struct Start {
    /// Mass centre.
    position_m: [f64; 3],
    /// The rotation of the part's axes into the world's, as a unit quaternion: w, x, y, z.
    attitude: [f64; 4],
    /// The face that is down.
    face: usize,
}

pub(super) fn draw(
    scene: &SpaceScene,
    options: &DrawOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    if options.simulators {
        let message = "--simulators is for parts that move in the plane: this scene has a solid part";
        return Err(Failure::Usage(format!("{}: {message}", scene.name())));
    }
    let layout = layout(scene);
    let path = files::write(&output.folder(scene.name()), "layout.svg", &space::layout(scene))?;
    deliver(&layout, text, &format!("drawing {}\n", path.display()), output, out)?;
    if options.open { files::open(&path) } else { Ok(()) }
}

fn pair(at: Vec2) -> [f64; 2] {
    [at.x, at.y]
}

/// The radius of round edges; none of sharp ones.
fn is_round(radius: f64) -> Option<f64> {
    (radius > 0.0).then_some(radius)
}

/// A wall or pin as it is laid out.
fn laid(wall: &carom_feeder::spatial::Wall) -> Wall {
    let bare = Wall {
        name: wall.name.clone(),
        ends_m: None,
        z_m: None,
        pin_radius_m: None,
        pin_ends_z_m: None,
        edge_radius_m: None,
        friction: wall.friction,
        restitution: wall.restitution,
    };
    match wall.form {
        WallForm::Across { from, to, edge_radius } => {
            Wall { ends_m: Some([from, to].map(pair)), edge_radius_m: is_round(edge_radius), ..bare }
        }
        WallForm::Pin { ends, radius } => Wall {
            ends_m: Some(ends.map(|end| [end.x, end.y])),
            pin_radius_m: Some(radius),
            pin_ends_z_m: Some(ends.map(|end| end.z)),
            ..bare
        },
        WallForm::Beside { z } => Wall { z_m: Some(z), ..bare },
    }
}

fn length(metres: f64) -> String {
    Dimension::Length.show_digits(metres, 5)
}

fn angle(radians: f64) -> String {
    Dimension::Angle.show_digits(radians, 5)
}

fn layout(scene: &SpaceScene) -> Layout {
    let feeder = scene.feeder();
    let measures = scene.measures();
    let sheet = |(i, plate): (usize, &Plate)| Sheet {
        name: plate.name.clone(),
        label: part::obstacle(feeder, i),
        from_m: pair(plate.uphill),
        to_m: pair(plate.edge),
        length_m: (plate.edge - plate.uphill).norm(),
        slope_rad: slope(plate.uphill, plate.edge),
        roll_rad: plate.roll,
        width_m: plate.width,
        side_walls_m: if let CrossSection::Walled { height } = plate.cross_section { height } else { 0.0 },
        v_angle_rad: match plate.cross_section {
            CrossSection::Groove { angle } => Some(angle),
            CrossSection::Flat | CrossSection::Walled { .. } => None,
        },
        sides: part::sides(plate, length, angle),
        edge_radius_m: is_round(plate.edge_radius),
        friction: plate.friction,
        restitution: plate.restitution,
        unbounded: plate.unbounded,
        written: written(&measures, i),
    };
    // The start of a single drop, on the most probable face where the scene has several.
    let state = feeder.start_state();
    let Mat3 { rows } = feeder.part.body.inertia();
    Layout {
        scene: scene.name().to_owned(),
        plates: feeder.plates.iter().enumerate().map(sheet).collect(),
        walls: feeder.walls.iter().map(laid).collect(),
        mass_kg: feeder.part.body.mass(),
        inertia_kg_m2: rows.map(|row| row.to_array()),
        faces: SolidFaceReport::of(scene),
        start: Start {
            position_m: state.centre.to_array(),
            attitude: state.attitude.to_array(),
            face: feeder.start.face,
        },
        notes: scene.notes().to_vec(),
        approximations: scene.approximations().to_vec(),
    }
}

fn text(layout: &Layout) -> String {
    let mut text = aligned(&rows(layout));
    for plate in layout.plates.iter().filter(|plate| !plate.written.is_empty()) {
        text.push_str(&format!("{}, as written: {}\n", plate.label, plate.written.join(", ")));
    }
    let mass = Dimension::Mass.show_digits(layout.mass_kg, 5);
    let [x, y, z] = layout.start.position_m.map(length);
    text.push_str(&format!(
        "\npart    {mass}\nstart   on face {}, mass centre at {x}, {y}, {z}\n",
        layout.start.face
    ));
    text.push_str(&format!("\n{}{}", aligned(&faces::solid_table(&layout.faces)), faces::SOLID_TABLE_NOTE));
    for approximation in &layout.approximations {
        text.push_str(&format!("\n{}\n", approximation.text));
    }
    text + &notes(&layout.notes)
}

/// Plates and walls as rows of a table, their heads first.
fn rows(layout: &Layout) -> Vec<Vec<String>> {
    let number = |value: f64| Dimension::Number.show_digits(value, 5);
    let needed = || "as needed".to_owned();
    let heads = [
        "plate",
        "slope",
        "roll",
        "length",
        "width",
        "sides",
        "uphill end",
        "free edge",
        "friction",
        "restitution",
    ];
    let plate = |plate: &Sheet| {
        vec![
            plate.label.clone(),
            angle(plate.slope_rad),
            angle(plate.roll_rad),
            if plate.unbounded { needed() } else { length(plate.length_m) },
            plate.width_m.map_or_else(needed, length),
            plate.sides.clone(),
            point(plate.from_m),
            point(plate.to_m),
            number(plate.friction),
            number(plate.restitution),
        ]
    };
    // A wall beside the drawing has no ends there: its place across stands where the others have the first of theirs.
    let wall = |wall: &Wall| {
        let dash = || "–".to_owned();
        let [from, to] = match (wall.ends_m, wall.z_m) {
            (Some(ends), _) => ends.map(point),
            (None, z) => [z.map_or_else(dash, |z| format!("z {}", length(z))), dash()],
        };
        let surface = [number(wall.friction), number(wall.restitution)];
        let (kind, width) = match wall.pin_radius_m {
            Some(radius) => ("pin", length(2.0 * radius)),
            None => ("wall", needed()),
        };
        let mut row = vec![wall.name.clone(), kind.to_owned(), dash(), dash(), width, dash(), from, to];
        row.extend(surface);
        row
    };
    let head = heads.map(str::to_owned).to_vec();
    let plates = layout.plates.iter().map(plate);
    std::iter::once(head).chain(plates).chain(layout.walls.iter().map(wall)).collect()
}
