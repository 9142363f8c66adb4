//! `carom faces`: what a part can lie on, how surely it stays there, and on which face it comes to rest when it is thrown.

use crate::args::{FacesOptions, Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::pipeline::{MADE_BY, draft};
use crate::printed::{notes, tell};
use crate::progress::{Progress, spent};
use crate::table::fixed;
use crate::thrown::{headline, range, sampling, until_rest, verdict, without_way};
use carom::tasks::axes::{Asker, Complaints, plate};
use carom_figure::{PoseBody, PoseEnd, PoseFigure, pose_report};
use carom_motion::planar::RestKind;
use carom_scene::{FaceReport, FacesReport, PartThrows, Scene, unit::Dimension};
use carom_study::poses::{Plan, Poses};
use carom_study::yields::REPETITIONS;
use carom_words::aligned;
use carom_words::study::percent;
use carom_words::{part, study};
use std::io::Write;

/// What a part without faces is told.
const NO_FACES: &str = "a disc lies alike on all its rim: it has no faces";

pub(crate) fn faces(options: &FacesOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let scene = Scene::read(&options.scene)?;
    let mut complaints = Complaints::of(Asker::Command);
    let plate = plate(&scene, options.plate.as_deref(), &mut complaints);
    let texts = [&options.height, &options.speed, &options.spin].map(String::as_str);
    let throws = match PartThrows::new(&scene, plate, texts) {
        Ok(throws) => Some(throws),
        Err(wrong) => {
            let names = ["height", "speed", "spin"];
            wrong.into_iter().for_each(|(place, message)| complaints.push(names[place], message));
            None
        }
    };
    complaints.finish()?;
    let Some(throws) = throws else { return Ok(()) };
    let name = scene.name();
    if scene.feeder().part.body.shape.rests().is_empty() {
        return Err(Failure::Undone(format!("{name}: {NO_FACES}")));
    }
    let plan = Plan {
        dimensions: PartThrows::DIMENSIONS,
        throws: options.throws.div_ceil(REPETITIONS as u64),
        seed: options.seed,
    };
    let progress = Progress::new("throws", Some(plan.rounded() as usize * REPETITIONS));
    let found = throws.throws(&plan, || progress.step());
    let found = found.map_err(|error| Failure::Usage(format!("{name}: {error}")))?;
    let run = spent(found.throws as usize, progress.seconds());
    drop(progress);
    let report = FacesReport::new(&throws, &plan, &found, run);
    let json = format!("{}\n", serde_json::to_string_pretty(&report)?);
    match output.format {
        Format::Text => out.write_all(text(&scene, &found, &report).as_bytes())?,
        Format::Json => out.write_all(json.as_bytes())?,
    }
    let folder = output.folder(name);
    files::write(&folder, "faces.json", &json)?;
    let path = files::write(&folder, "faces.html", &page(&scene, &found, &report))?;
    match output.format {
        Format::Text => writeln!(out, "page {}", path.display())?,
        // Stdout is the result's alone.
        Format::Json => tell(&format!("page {}", path.display())),
    }
    if options.open { files::open(&path) } else { Ok(()) }
}

/// The faces of a part as rows of a table: lengths in millimetres, angles in degrees.
pub(crate) fn table(faces: &[FaceReport]) -> Vec<Vec<String>> {
    let heads =
        ["face", "lies on", "width", "centre above", "inside the ends", "tips after", "tips onto it gently"];
    let millimetres = |length: f64| fixed(1e3 * length, 2);
    let row = |face: &FaceReport| {
        let [first, second] = face.inside_m.map(millimetres);
        let [clockwise, counter] = face.tips_after_rad.map(|angle| fixed(angle.to_degrees(), 1));
        let arc = face.kind.0 == RestKind::Arc;
        let dash = || "–".to_owned();
        vec![
            face.face.to_string(),
            face.kind.to_string(),
            if arc { dash() } else { format!("{} mm", millimetres(face.width_m)) },
            format!("{} mm", millimetres(face.centre_height_m)),
            if arc { dash() } else { format!("{first} | {second} mm") },
            if face.stable { format!("{clockwise} | {counter} deg") } else { "does not stay".to_owned() },
            format!("{} %", fixed(100.0 * face.quasi_static_share, 2)),
        ]
    };
    std::iter::once(heads.map(str::to_owned).to_vec()).chain(faces.iter().map(row)).collect()
}

/// What the two numbers of a column mean.
pub(crate) const TABLE_NOTE: &str = "two numbers: towards the end that comes first counter-clockwise and the other one; tilted clockwise and counter-clockwise\n\
     tips onto it gently: the share of all attitudes from which it tips onto the face too slowly to swing on\n";

fn text(scene: &Scene, found: &Poses, report: &FacesReport) -> String {
    let mut text = verdict(&report.scene, found);
    if let Some(line) = without_way(found) {
        text.push_str(&line);
        text.push('\n');
    }
    text.push_str(&format!("{}\n\n", varied(scene, report)));
    let mut rows = table(&report.faces);
    rows[0].extend(["thrown", "95 % interval"].map(str::to_owned));
    for (row, end) in rows.iter_mut().skip(1).zip(&found.ends) {
        let [share, interval] = percent(&end.probability);
        row.extend([format!("{share} %"), interval]);
    }
    text.push_str(&aligned(&rows));
    let others = found.ends.iter().filter(|end| !end.pose.is_face());
    for end in others {
        let [share, interval] = percent(&end.probability);
        text.push_str(&format!("{}: {share} % ({interval})\n", study::pose(end.pose)));
    }
    text.push_str(TABLE_NOTE);
    text.push_str(&until_rest(found));
    text.push_str(&notes(scene.notes()));
    text.push('\n');
    text
}

/// What varies from throw to throw, and what the part falls on.
fn varied(scene: &Scene, report: &FacesReport) -> String {
    let feeder = scene.feeder();
    let number = |value: f64| Dimension::Number.show_digits(value, 5);
    let plate = feeder.plates.iter().position(|plate| plate.name == report.plate).unwrap_or(0);
    format!(
        "let go above level ground of the surface of {} (friction {}, restitution {}, {}), every attitude alike; height {}, speed {} to either side, spin {} in either sense; seed {}",
        part::obstacle(feeder, plate),
        number(report.friction),
        number(report.restitution),
        report.law,
        range(&report.height_m, "m"),
        range(&report.speed_m_s, "m/s"),
        range(&report.spin_rate_rad_s, "rad/s"),
        report.seed
    )
}

fn page(scene: &Scene, found: &Poses, report: &FacesReport) -> String {
    let ends: Vec<PoseEnd> = found
        .ends
        .iter()
        .map(|end| PoseEnd {
            name: study::pose(end.pose),
            vertices: String::new(),
            is_face: end.pose.is_face(),
            probability: end.probability,
            of_resting: end.of_resting,
            stance: None,
            command: String::new(),
        })
        .collect();
    let mut told: Vec<String> = without_way(found).into_iter().collect();
    told.push(sampling(found.throws, report.seed));
    told.push(
        "The model: plane motion, rigid part, level ground, dry friction after Coulomb; tolerances of the scene are not used. A part that rolls to and fro for ever, because nothing takes energy from it, counts as being on the face of that arc.".to_owned(),
    );
    told.extend(scene.notes().iter().cloned());
    pose_report(&PoseFigure {
        title: scene.name(),
        verdict: &headline(found),
        lead: &varied(scene, report),
        notes: &told,
        source: scene.source(),
        made_by: MADE_BY,
        body: PoseBody::Part(scene.feeder(), &draft(scene)),
        ends: &ends,
        resting: found.resting,
        time: found.time.as_ref(),
        strikes: found.impacts.as_ref(),
        throws: found.throws,
    })
}
