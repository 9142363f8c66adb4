//! `carom faces`: what a part can lie on, how surely it stays there, and on which face it comes to rest when it is thrown.

mod plane;
mod space;

use crate::args::{FacesOptions, Format, Output};
use crate::failure::Failure;
use crate::files;
use crate::pipeline::MADE_BY;
use crate::printed::{notes, tell};
use crate::progress::{Progress, spent};
use crate::thrown::{headline, range, sampling, until_rest, verdict, without_way};
use carom::tasks::axes::{Asker, Complaints, plate};
use carom_figure::{PoseBody, PoseEnd, PoseFigure, pose_report};
use carom_scene::{AnyScene, Drawn, FacesReport, PartThrows, SolidThrows, Thrown, unit::Dimension};
use carom_study::poses::{Plan, Pose, Posed, Poses};
use carom_study::yields::REPETITIONS;
use carom_words::aligned;
use carom_words::study::percent;
use carom_words::{part, study};
pub(crate) use plane::{TABLE_NOTE, table};
use serde::Serialize;
pub(crate) use space::{NOTE as SOLID_TABLE_NOTE, table as solid_table};
use std::io::Write;

/// A part that is thrown, as the command tells of it.
trait Told: Thrown<Face: Serialize> {
    /// Throws where nobody says how many.
    const THROWS: u64;
    /// Why there is nothing to tell of a part without faces.
    const NO_FACES: &'static str;
    /// How speed and spin go, after "speed" and "spin".
    const WAYS: [&'static str; 2];
    /// What the model leaves out.
    const MODEL: &'static str;
    /// What the columns of the table mean.
    const NOTE: &'static str;
    /// The faces as rows of a table, their heads first.
    fn table(faces: &[Self::Face]) -> Vec<Vec<String>>;
    /// The corners of a face, and its stance, as the page has them.
    fn on_page(face: &Self::Face) -> (String, Option<[f64; 2]>);
    /// Rows of faces that a text leaves out where there are many; the others are told.
    fn is_minor(face: &Self::Face) -> bool;
    /// The page with the part in it.
    fn page(&self, found: &Poses, page: impl Fn(PoseBody<'_>) -> String) -> String;
}

pub(crate) fn faces(options: &FacesOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    match AnyScene::read(&options.scene)? {
        AnyScene::Plane(scene) => of_scene(&*scene, PartThrows::new, options, output, out),
        AnyScene::Space(scene) => of_scene(&*scene, SolidThrows::new, options, output, out),
    }
}

/// The wrong ones of height, speed and spin, by their place, and why.
type Wrong = Vec<(usize, String)>;

/// The faces of a scene's part, in the plane or in space.
fn of_scene<'s, T: Told>(
    scene: &'s T::Scene,
    thrown: impl FnOnce(&'s T::Scene, usize, [&str; 3]) -> Result<T, Wrong>,
    options: &FacesOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let mut complaints = Complaints::of(Asker::Command);
    let plate = plate(scene, options.plate.as_deref(), &mut complaints);
    let texts = [&options.height, &options.speed, &options.spin].map(String::as_str);
    let throws = match thrown(scene, plate, texts) {
        Ok(throws) => Some(throws),
        Err(wrong) => {
            let names = ["height", "speed", "spin"];
            wrong.into_iter().for_each(|(place, message)| complaints.push(names[place], message));
            None
        }
    };
    // The plate and all three texts are told at once.
    complaints.finish()?;
    let Some(throws) = throws else { return Ok(()) };
    let name = scene.name();
    if throws.faces().is_empty() {
        return Err(Failure::Undone(format!("{name}: {}", T::NO_FACES)));
    }
    let plan = Plan {
        dimensions: T::DIMENSIONS,
        throws: options.throws.unwrap_or(T::THROWS).div_ceil(REPETITIONS as u64),
        seed: options.seed,
    };
    let progress = Progress::new("throws", Some(plan.rounded() as usize * REPETITIONS));
    let found = throws.throws(&plan, || progress.step());
    let found = found.map_err(|error| Failure::Usage(format!("{name}: {error}")))?;
    let run = spent(found.throws as usize, progress.seconds());
    drop(progress);
    let report = FacesReport::new(&throws, &plan, &found, run);
    deliver(&throws, &found, &report, options, output, out)
}

/// Writes everything and says what came out.
fn deliver<T: Told>(
    throws: &T,
    found: &Poses,
    report: &FacesReport<T::Face>,
    options: &FacesOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let json = format!("{}\n", serde_json::to_string_pretty(report)?);
    match output.format {
        Format::Text => out.write_all(text(throws, found, report).as_bytes())?,
        Format::Json => out.write_all(json.as_bytes())?,
    }
    let folder = output.folder(throws.scene().name());
    files::write(&folder, "faces.json", &json)?;
    let path = files::write(&folder, "faces.html", &page(throws, found, report))?;
    match output.format {
        Format::Text => writeln!(out, "page {}", path.display())?,
        // Stdout is the result's alone.
        Format::Json => tell(&format!("page {}", path.display())),
    }
    if options.open { files::open(&path) } else { Ok(()) }
}

/// Faces in the table of a text: of more those are told that matter.
const MOST_FACES: usize = 24;

fn text<T: Told>(throws: &T, found: &Poses, report: &FacesReport<T::Face>) -> String {
    let mut text = verdict(&report.scene, found);
    if let Some(line) = without_way(found) {
        text.push_str(&line);
        text.push('\n');
    }
    text.push_str(&format!("{}\n\n", varied(throws, report)));
    let mut rows = T::table(&report.faces);
    rows[0].extend(["thrown", "95 % interval"].map(str::to_owned));
    for (row, end) in rows.iter_mut().skip(1).zip(&found.ends) {
        let [share, interval] = percent(&end.probability);
        row.extend([format!("{share} %"), interval]);
    }
    // The hull of a surface with many facets has many faces that nothing ever lies on.
    let all = rows.len();
    if all > MOST_FACES + 1 {
        let is_told = |face: usize| !is_left_out::<T>(report, &found.ends[face]);
        let numbered = rows.into_iter().enumerate();
        rows = numbered.filter(|(row, _)| *row == 0 || is_told(row - 1)).map(|(_, row)| row).collect();
    }
    text.push_str(&aligned(&rows));
    if rows.len() < all {
        let left = all - rows.len();
        text.push_str(&format!(
            "{left} more faces, on which it does not stay and no throw ends: --format json has them\n"
        ));
    }
    let others = found.ends.iter().filter(|end| !end.pose.is_face());
    for end in others {
        let [share, interval] = percent(&end.probability);
        text.push_str(&format!("{}: {share} % ({interval})\n", study::pose(end.pose)));
    }
    text.push_str(T::NOTE);
    text.push_str(&until_rest(found));
    for approximation in &report.approximations {
        text.push_str(&format!("\n{}\n", approximation.text));
    }
    text.push_str(&notes(throws.scene().notes()));
    text.push('\n');
    text
}

/// True of a face of which there is little to tell, and on which no throw ends.
fn is_left_out<T: Told>(report: &FacesReport<T::Face>, end: &Posed) -> bool {
    let Pose::Face(face) = end.pose else { return false };
    end.probability.count == 0 && report.faces.get(face).is_some_and(T::is_minor)
}

/// What varies from throw to throw, and what the part falls on.
fn varied<T: Told>(throws: &T, report: &FacesReport<T::Face>) -> String {
    let number = |value: f64| Dimension::Number.show_digits(value, 5);
    let [speed, spin] = T::WAYS;
    format!(
        "let go above level ground of the surface of {} (friction {}, restitution {}, {}), every attitude alike; height {}, speed {} {speed}, spin {} {spin}; seed {}",
        part::obstacle(throws.scene().feeder(), throws.plate()),
        number(report.friction),
        number(report.restitution),
        report.law,
        range(&report.height_m, "m"),
        range(&report.speed_m_s, "m/s"),
        range(&report.spin_rate_rad_s, "rad/s"),
        report.seed
    )
}

fn page<T: Told>(throws: &T, found: &Poses, report: &FacesReport<T::Face>) -> String {
    let end = |end: &Posed| {
        let face = if let Pose::Face(face) = end.pose { report.faces.get(face) } else { None };
        let (vertices, stance) = face.map(T::on_page).unwrap_or_default();
        PoseEnd {
            name: study::pose(end.pose),
            vertices,
            is_face: end.pose.is_face(),
            probability: end.probability,
            of_resting: end.of_resting,
            stance,
            command: String::new(),
        }
    };
    // Bars of what nothing ever lies on would hide the others.
    let ends = found.ends.iter().filter(|end| !is_left_out::<T>(report, end));
    let ends: Vec<PoseEnd> = ends.map(end).collect();
    let scene = throws.scene();
    let mut told: Vec<String> = without_way(found).into_iter().collect();
    told.push(sampling(found.throws, report.seed));
    told.push(T::MODEL.to_owned());
    told.extend(report.approximations.iter().map(|approximation| approximation.text.clone()));
    told.extend(scene.notes().iter().cloned());
    throws.page(found, |body| {
        pose_report(&PoseFigure {
            title: scene.name(),
            verdict: &headline(found),
            lead: &varied(throws, report),
            notes: &told,
            source: scene.source(),
            made_by: MADE_BY,
            body,
            ends: &ends,
            resting: found.resting,
            time: found.time.as_ref(),
            strikes: found.impacts.as_ref(),
            throws: found.throws,
        })
    })
}
