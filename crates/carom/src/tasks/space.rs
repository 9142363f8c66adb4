//! A part in space on its way through a feeder: its page, and the files of its run.

use super::{MADE_BY, shown as shown_limit};
use carom_feeder::spatial::Run;
use carom_figure::{Draft, LiveSolid, SpaceFigure, Wish, live_space, space_report};
use carom_scene::{FoundLimits, SpaceRunReport, SpaceScene};
use carom_words::part;
use std::fmt::Write as _;

/// What a run says, with how far each quantity may move.
///
/// # Example
/// ```
/// use carom::{scene::{FoundLimits, SpaceScene}, tasks::space::run_report};
/// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
/// let scene = SpaceScene::parse("stays.toml", text)?;
/// let none = FoundLimits { limits: vec![], runs: 1 };
/// assert_eq!(run_report(&scene, &scene.feeder().run()?, Some(&none)).limit_runs, Some(1));
/// # Ok::<(), carom::Error>(())
/// ```
pub fn run_report(scene: &SpaceScene, run: &Run, limits: Option<&FoundLimits>) -> SpaceRunReport {
    let (found, runs) = (limits.map(|found| found.limits.clone()), limits.map(|found| found.runs));
    SpaceRunReport { limits: found, limit_runs: runs, ..SpaceRunReport::new(scene, run) }
}

/// The files of a run, the one to look at last: the way as CSV, the result as JSON, the report as one HTML page.
///
/// # Errors
/// None in practice: what is written are numbers and names.
///
/// # Example
/// ```
/// use carom::{scene::SpaceScene, tasks::space::run_files};
/// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
/// let scene = SpaceScene::parse("stays.toml", text)?;
/// let files = run_files(&scene, &scene.feeder().run()?, None).unwrap();
/// assert!(files.iter().any(|(name, text)| *name == "run.json" && text.contains("stuck")));
/// assert!(files.last().is_some_and(|(name, text)| *name == "report.html" && text.contains("Stuck")));
/// # Ok::<(), carom::Error>(())
/// ```
pub fn run_files(
    scene: &SpaceScene,
    run: &Run,
    limits: Option<&FoundLimits>,
) -> Result<Vec<(&'static str, String)>, serde_json::Error> {
    let report = run_report(scene, run, limits);
    let result = serde_json::to_string_pretty(&report)?;
    Ok(vec![
        ("trace.csv", trace(run)),
        ("run.json", format!("{result}\n")),
        ("report.html", shown(scene, run, &report, space_report)),
    ])
}

/// The report of a run piece by piece, for a page that stays open.
///
/// # Example
/// ```
/// use carom::{scene::SpaceScene, tasks::space::live};
/// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
/// let scene = SpaceScene::parse("stays.toml", text)?;
/// let live = live(&scene, &scene.feeder().run()?);
/// assert!(live.sections.verdict.contains("Stuck"));
/// # Ok::<(), carom::Error>(())
/// ```
pub fn live(scene: &SpaceScene, run: &Run) -> LiveSolid {
    shown(scene, run, &SpaceRunReport::new(scene, run), live_space)
}

/// The report of a run of a layout that was found, with what must be said of it.
pub fn design_page(scene: &SpaceScene, run: &Run, mut said: Vec<String>) -> String {
    said.extend(scene.notes().iter().cloned());
    let page = |figure: &SpaceFigure<'_>| space_report(&SpaceFigure { notes: &said, ..*figure });
    shown(scene, run, &SpaceRunReport::new(scene, run), page)
}

/// The layout of a feeder as SVG, seen from the side, with the part at the start.
///
/// # Example
/// ```
/// use carom::{scene::SpaceScene, tasks::space::layout};
/// let text = "part = { box = [0.04, 0.01, 0.02], mass = 0.06 }\ncontact = { friction = 0.5 }\nstart = { to_edge = 0.1 }\n[[plate]]\nslope = \"15 deg\"";
/// assert!(layout(&SpaceScene::parse("stays.toml", text)?).contains("15°"));
/// # Ok::<(), carom::Error>(())
/// ```
pub fn layout(scene: &SpaceScene) -> String {
    let draft = Draft { outline: vec![], measures: super::measures(scene.measures()) };
    carom_figure::space_layout_svg(scene.feeder(), &draft)
}

/// A run as a figure shows it.
fn shown<T>(
    scene: &SpaceScene,
    run: &Run,
    report: &SpaceRunReport,
    show: impl FnOnce(&SpaceFigure<'_>) -> T,
) -> T {
    let feeder = scene.feeder();
    let label = |name: &str| match feeder.plates.iter().position(|plate| plate.name == name) {
        Some(plate) => part::obstacle(feeder, plate),
        None => name.to_owned(),
    };
    let wish = |wanted: &carom_scene::Wanted| Wish {
        plate: label(&wanted.plate),
        want: wanted.want.clone(),
        met: wanted.met,
    };
    let limits = report.limits.iter().flatten();
    show(&SpaceFigure {
        title: scene.name(),
        feeder,
        run,
        wanted: &report.wanted.iter().map(wish).collect::<Vec<_>>(),
        margins: &report.faces.iter().map(|face| face.margin_m).collect::<Vec<_>>(),
        limits: &limits.filter_map(|limit| shown_limit(scene, limit)).collect::<Vec<_>>(),
        approximations: &report.approximations.iter().map(|found| found.text.clone()).collect::<Vec<_>>(),
        notes: scene.notes(),
        source: scene.source(),
        made_by: MADE_BY,
    })
}

/// Time, place, attitude, velocity and spin at every sample.
fn trace(run: &Run) -> String {
    let mut text = String::from(
        "t_s,x_m,y_m,z_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,spin_x_rad_s,spin_y_rad_s,spin_z_rad_s\n",
    );
    for (time, _, state) in &run.samples.instants {
        let numbers = [
            &state.centre.to_array()[..],
            &state.attitude.to_array()[..],
            &state.velocity.to_array()[..],
            &state.spin.to_array()[..],
        ];
        let cells: Vec<String> = numbers.iter().flat_map(|of| of.iter()).map(ToString::to_string).collect();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{time},{}", cells.join(","));
    }
    text
}
