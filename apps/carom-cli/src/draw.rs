//! `carom draw`: what a scene draws, without running it.

mod space;

use crate::args::{Format, Output};
use crate::failure::Failure;
use crate::printed::{notes, tell};
use crate::{faces, files, pipeline};
use carom_feeder::Form;
use carom_figure::senses::slope;
use carom_num::Vec2;
use carom_scene::{AnyScene, Approximation, FaceReport, Measure, Scene, unit::Dimension};
use carom_words::aligned;
use carom_words::part;
use clap::Args;
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub(crate) struct DrawOptions {
    /// Scene file.
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// Also write it for simulators: MJCF for MuJoCo, URDF and meshes for Bullet, Drake and others.
    #[arg(long)]
    pub(crate) simulators: bool,
    /// Open the drawing when it is written.
    #[arg(long)]
    pub(crate) open: bool,
}

/// A plate or wall as it lies.
#[derive(Serialize)]
struct Segment {
    name: String,
    /// What people call it.
    #[serde(skip)]
    label: String,
    from_m: [f64; 2],
    to_m: [f64; 2],
    /// Along its course.
    length_m: f64,
    /// At its free edge.
    slope_rad: f64,
    /// At its uphill end, where it is bent.
    #[serde(skip_serializing_if = "Option::is_none")]
    slope_uphill_rad: Option<f64>,
    edge_radius_m: f64,
    friction: f64,
    restitution: f64,
    /// True where the drawing gives no length.
    unbounded: bool,
    /// What the scene writes about it: `drop 150 ± 1 mm`.
    written: Vec<String>,
}

/// A scene as it is laid out.
#[derive(Serialize)]
struct Layout {
    scene: String,
    plates: Vec<Segment>,
    walls: Vec<Segment>,
    mass_kg: f64,
    inertia_kg_m2: f64,
    /// What the part can lie on.
    faces: Vec<FaceReport>,
    start: Start,
    notes: Vec<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    approximations: Vec<Approximation>,
}

/// Where the part lies at the start.
#[derive(Serialize)]
struct Start {
    x_m: f64,
    y_m: f64,
    angle_rad: f64,
}

fn layout(scene: &Scene) -> Layout {
    let feeder = scene.feeder();
    let segment = |name: &str, (from, to): (Vec2, Vec2), form: &Form, surface: (f64, f64)| Segment {
        name: name.to_owned(),
        label: String::new(),
        from_m: [from.x, from.y],
        to_m: [to.x, to.y],
        length_m: form.length(from, to),
        slope_rad: slope(from, to),
        slope_uphill_rad: None,
        edge_radius_m: form.edge_radius,
        friction: surface.0,
        restitution: surface.1,
        unbounded: false,
        written: vec![],
    };
    let measures = scene.measures();
    let pose = feeder.start_state().pose;
    Layout {
        scene: scene.name().to_owned(),
        plates: feeder
            .plates
            .iter()
            .enumerate()
            .map(|(i, p)| {
                let [begins, ends] = p.slopes();
                Segment {
                    written: written(&measures, i),
                    label: part::obstacle(feeder, i),
                    unbounded: p.unbounded,
                    slope_rad: ends,
                    slope_uphill_rad: (!p.form.course.is_empty()).then_some(begins),
                    ..segment(&p.name, (p.uphill, p.edge), &p.form, (p.friction, p.restitution))
                }
            })
            .collect(),
        walls: feeder
            .walls
            .iter()
            .enumerate()
            .map(|(i, w)| Segment {
                label: part::obstacle(feeder, feeder.plates.len() + i),
                ..segment(&w.name, (w.from, w.to), &w.form, (w.friction, w.restitution))
            })
            .collect(),
        mass_kg: feeder.part.body.mass,
        inertia_kg_m2: feeder.part.body.inertia,
        faces: FaceReport::of(&feeder.part.body.shape),
        start: Start { x_m: pose.centre.x, y_m: pose.centre.y, angle_rad: pose.angle },
        notes: scene.notes().to_vec(),
        approximations: scene.approximations().to_vec(),
    }
}

pub(crate) fn draw(options: &DrawOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    match AnyScene::read(&options.scene)? {
        AnyScene::Plane(scene) => in_the_plane(&scene, options, output, out),
        AnyScene::Space(scene) => space::draw(&scene, options, output, out),
    }
}

fn in_the_plane(
    scene: &Scene,
    options: &DrawOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let layout = layout(scene);
    let folder = output.folder(scene.name());
    let path = files::write(&folder, "layout.svg", &pipeline::layout(scene))?;
    let mut written = format!("drawing {}\n", path.display());
    for (name, drawing) in pipeline::drawings(scene) {
        let path = files::write(&folder, name, &drawing)?;
        written.push_str(&format!("1:1     {}\n", path.display()));
    }
    if options.simulators {
        for (name, text) in carom::tasks::simulator_files(scene) {
            let path = files::write(&folder, &name, &text)?;
            written.push_str(&format!("model   {}\n", path.display()));
        }
    }
    deliver(&layout, text, &written, output, out)?;
    if options.open { files::open(&path) } else { Ok(()) }
}

/// Says what is laid out, and which files were written.
fn deliver<L: Serialize>(
    layout: &L,
    text: impl FnOnce(&L) -> String,
    written: &str,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    match output.format {
        Format::Text => {
            out.write_all(text(layout).as_bytes())?;
            write!(out, "\n{written}")?;
        }
        Format::Json => {
            writeln!(out, "{}", serde_json::to_string_pretty(layout)?)?;
            tell(written.trim_end());
        }
    }
    Ok(())
}

/// What the scene writes about a plate, of all its measures.
fn written(measures: &[Measure], plate: usize) -> Vec<String> {
    let own = measures.iter().filter(|measure| measure.plate == Some(plate));
    own.map(|measure| format!("{} {}", measure.name, measure.text)).collect()
}

/// A place of the drawing.
fn point([x, y]: [f64; 2]) -> String {
    format!("{}, {}", Dimension::Length.show_digits(x, 5), Dimension::Length.show_digits(y, 5))
}

fn text(layout: &Layout) -> String {
    let length = |value: f64| Dimension::Length.show_digits(value, 5);
    let number = |value: f64| Dimension::Number.show_digits(value, 5);
    let mut rows = vec![
        ["plate", "slope", "length", "uphill end", "free edge", "friction", "restitution"]
            .map(str::to_owned)
            .to_vec(),
    ];
    let row = |segment: &Segment, slope: String| {
        vec![
            segment.label.clone(),
            slope,
            if segment.unbounded { "as needed".to_owned() } else { length(segment.length_m) },
            point(segment.from_m),
            point(segment.to_m),
            number(segment.friction),
            number(segment.restitution),
        ]
    };
    let angle = |value: f64| Dimension::Angle.show_digits(value, 5);
    let slopes = |plate: &Segment| match plate.slope_uphill_rad {
        Some(begins) => format!("{} to {}", angle(begins), angle(plate.slope_rad)),
        None => angle(plate.slope_rad),
    };
    rows.extend(layout.plates.iter().map(|p| row(p, slopes(p))));
    rows.extend(layout.walls.iter().map(|w| row(w, "wall".to_owned())));
    let mass = Dimension::Mass.show_digits(layout.mass_kg, 5);
    let inertia = Dimension::Inertia.show_digits(layout.inertia_kg_m2, 5);
    let start = &layout.start;
    let centre = point([start.x_m, start.y_m]);
    let angle = angle(start.angle_rad);
    let mut text = aligned(&rows);
    for plate in layout.plates.iter().filter(|plate| !plate.written.is_empty()) {
        text.push_str(&format!("{}, as written: {}\n", plate.label, plate.written.join(", ")));
    }
    text.push_str(&format!("\npart    {mass}, {inertia}\nstart   mass centre at {centre}, angle {angle}\n"));
    if !layout.faces.is_empty() {
        text.push_str(&format!("\n{}{}", aligned(&faces::table(&layout.faces)), faces::TABLE_NOTE));
    }
    text + &notes(&layout.notes)
}
