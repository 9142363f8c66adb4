//! What is asked of a scene, answered whole: run it, feed it, draw it, report on it.
//!
//! The command, the page in a browser and other programs ask here, so that all of them say the same, byte for byte. Files and schemas
//! know nothing of pictures, and pictures nothing of files: here they meet.

pub mod axes;
pub mod design;
pub mod feeds;
pub mod fits;
pub mod impact;
pub mod map;
pub mod records;
pub mod regions;
pub mod roll;
pub mod solid;
pub mod space;
pub mod sweep;
pub mod tolerance;
pub mod yields;

use carom_feeder::{Feed, FeedRun, Run, RunError};
use carom_figure::{Axis, Draft, Extra, QuantityLimit, Wish};
use carom_motion::planar::Options;
use carom_scene::{
    Drawn, FeedReport, FoundLimits, Limit, LimitEnd, MeasureAxis, Problems, RunReport, Scene, Want, labelled,
};
use carom_words::part::{self, Names};

/// What makes the pages, with its version.
pub const MADE_BY: &str = concat!("carom ", env!("CARGO_PKG_VERSION"));

/// Why a study has no answer.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks::{StudyError, design::design_space}};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// assert!(matches!(design_space(&scene), Err(StudyError::Input(_))), "it has no [design]");
/// # Ok::<(), carom::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StudyError {
    /// What was given has problems: all of them.
    #[error("{}", .0.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))]
    Input(Vec<Problems>),
    /// What is asked does not fit what was given.
    #[error("{0}")]
    Asked(String),
    /// What cannot be computed.
    #[error("{0}")]
    Undone(String),
}

impl From<Problems> for StudyError {
    fn from(problems: Problems) -> Self {
        Self::Input(vec![problems])
    }
}

/// Feeds several parts, where a scene wants that.
///
/// # Errors
/// A feeder that cannot be run; a fault of the numbers on the way.
pub fn feed(scene: &Scene) -> Result<Option<FeedRun>, RunError> {
    let Some(feed) = scene.feed() else { return Ok(None) };
    scene.feeder().prepare(Options::default())?.feed(feed).map(Some)
}

/// What a run says, with how it was fed and how far each quantity may move.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let report = tasks::run_report(&scene, &scene.feeder().run()?, None, None);
/// assert_eq!(report.outcome.as_str(), "landed");
/// # Ok::<(), carom::Error>(())
/// ```
pub fn run_report(
    scene: &Scene,
    run: &Run,
    fed: Option<&FeedRun>,
    limits: Option<&FoundLimits>,
) -> RunReport {
    let report = RunReport::new(scene, run, limits.map(|found| found.limits.clone()));
    let feed = scene.feed().zip(fed).map(|(feed, fed)| FeedReport::new(scene.feeder(), feed, fed));
    RunReport { limit_runs: limits.map(|found| found.runs), feed, ..report }
}

/// The report of a run, one HTML page.
pub fn report_page(scene: &Scene, run: &Run, limits: Option<&[Limit]>) -> String {
    carom_figure::report(scene.feeder(), run, scene.name(), &extra(scene, Some(run), limits))
}

/// The report of a run of a layout that was found, with what must be said of it.
pub fn design_page(scene: &Scene, run: &Run, mut said: Vec<String>) -> String {
    let extra = extra(scene, Some(run), None);
    said.extend(extra.notes.iter().cloned());
    carom_figure::report(scene.feeder(), run, scene.name(), &Extra { notes: said, ..extra })
}

/// The page of a feed.
pub fn feed_page(scene: &Scene, feed: &Feed, run: &FeedRun) -> String {
    carom_figure::feed_report(scene.feeder(), feed, run, scene.name(), &extra(scene, None, None))
}

/// What is wanted on the plates of a scene, and whether a run has it.
pub fn wishes(scene: &Scene, run: &Run) -> Vec<Wish> {
    let feeder = scene.feeder();
    let label = |name: String| match feeder.plates.iter().position(|plate| plate.name == name) {
        Some(plate) => part::obstacle(feeder, plate),
        None => name,
    };
    let wanted = scene.wanted(run).into_iter();
    wanted.map(|wanted| Wish { plate: label(wanted.plate), want: wanted.want, met: wanted.met }).collect()
}

/// What a page says of a scene beside its run.
pub fn extra(scene: &Scene, run: Option<&Run>, limits: Option<&[Limit]>) -> Extra {
    Extra {
        made_by: MADE_BY.to_owned(),
        scene: Some(scene.source().to_owned()),
        limits: limits.unwrap_or_default().iter().filter_map(|limit| shown(scene, limit)).collect(),
        notes: scene.notes().to_vec(),
        wanted: run.map(|run| wishes(scene, run)).unwrap_or_default(),
        draft: draft(scene),
    }
}

/// What a scene's author drew and wrote, for its pictures.
pub fn draft(scene: &Scene) -> Draft {
    Draft { outline: scene.outline(), measures: measures(scene.measures()) }
}

/// What is written of a layout, for its pictures.
pub(crate) fn measures(written: Vec<carom_scene::Measure>) -> Vec<carom_figure::Measure> {
    let of = |measure: carom_scene::Measure| carom_figure::Measure {
        plate: measure.plate,
        name: measure.name.to_owned(),
        text: measure.text,
        axis: match measure.axis {
            MeasureAxis::Level => Axis::Level,
            MeasureAxis::Plumb => Axis::Plumb,
            MeasureAxis::Along => Axis::Along,
            MeasureAxis::Slope => Axis::Slope,
            MeasureAxis::Radius => Axis::Radius,
        },
        from: measure.from,
        to: measure.to,
    };
    written.into_iter().map(of).collect()
}

/// A limit in the unit a drawing uses; `None` where the scene has no such quantity.
pub fn shown(scene: &impl Drawn, limit: &Limit) -> Option<QuantityLimit> {
    let quantity = scene.quantities().into_iter().find(|quantity| quantity.path == limit.quantity)?;
    let dimension = quantity.kind.dimension;
    let unit = dimension.unit(dimension.usual());
    let shown = |value: f64| unit.map_or(value, |unit| unit.of_si(value));
    Some(QuantityLimit {
        quantity: labelled(&limit.quantity).into_owned(),
        unit: dimension.usual().to_owned(),
        value: shown(quantity.value),
        low: limit.low.map(shown),
        high: limit.high.map(shown),
        possible: [(limit.low_kept, limit.low_end), (limit.high_kept, limit.high_end)]
            .map(|(kept, end)| (end == LimitEnd::NoSuchFeeder).then(|| shown(kept))),
    })
}

/// The drawings of a scene for a workshop, with their names.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// assert_eq!(tasks::drawings(&scene).map(|(name, _)| name), ["drawing.dxf", "drawing.svg"]);
/// # Ok::<(), carom::Error>(())
/// ```
pub fn drawings(scene: &Scene) -> [(&'static str, String); 2] {
    let (feeder, draft) = (scene.feeder(), draft(scene));
    [
        ("drawing.dxf", carom_figure::layout_dxf(feeder, &draft)),
        ("drawing.svg", carom_figure::drawing_svg(feeder, &draft)),
    ]
}

/// A scene for simulators, with the names of the files: MJCF, URDF and the meshes of the part.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks};
/// let scene = Scene::read("../../examples/case_2_box.toml".as_ref())?;
/// let names: Vec<String> = tasks::simulator_files(&scene).into_iter().map(|(name, _)| name).collect();
/// assert_eq!(names, ["scene.mjcf.xml", "part.urdf", "plates.urdf", "part-0.obj"]);
/// # Ok::<(), carom::Error>(())
/// ```
pub fn simulator_files(scene: &Scene) -> Vec<(String, String)> {
    carom_figure::simulator_files(scene.feeder(), scene.name())
}

/// The layout of a feeder as SVG.
pub fn layout(scene: &Scene) -> String {
    carom_figure::layout_svg(scene.feeder(), None, &draft(scene))
}

/// The files of a run, by their names: what it says, every sample, the page, and of a feed its own page. Those that `carom run` writes.
///
/// # Errors
/// A result that is not JSON, which none is.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// let files = tasks::run_files(&scene, &scene.feeder().run()?, None, None).unwrap();
/// let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
/// assert_eq!(names, ["run.json", "trace.csv", "report.html"]);
/// # Ok::<(), carom::Error>(())
/// ```
pub fn run_files(
    scene: &Scene,
    run: &Run,
    fed: Option<&FeedRun>,
    limits: Option<&FoundLimits>,
) -> Result<Vec<(&'static str, String)>, serde_json::Error> {
    let mut files = vec![];
    if let (Some(feed), Some(fed)) = (scene.feed(), fed) {
        files.push(("feed.html", feed_page(scene, feed, fed)));
    }
    let result = serde_json::to_string_pretty(&run_report(scene, run, fed, limits))?;
    files.push(("run.json", format!("{result}\n")));
    files.push(("trace.csv", carom_figure::trace_csv(scene.feeder(), run)));
    files.push(("report.html", report_page(scene, run, limits.map(|found| found.limits.as_slice()))));
    Ok(files)
}

/// The number of the plate that is looked at, by its name or its number; the last one where none is named.
///
/// # Errors
/// What there is, where that is none of it.
///
/// # Example
/// ```
/// use carom::{prelude::*, tasks};
/// let scene = Scene::read("../../examples/case_2.toml".as_ref())?;
/// assert_eq!((tasks::plate(&scene, Some("upper")), tasks::plate(&scene, None)), (Ok(0), Ok(1)));
/// assert!(tasks::plate(&scene, Some("third")).unwrap_err().starts_with("\"third\" is none of"));
/// # Ok::<(), carom::Error>(())
/// ```
pub fn plate(scene: &impl Drawn, named: Option<&str>) -> Result<usize, String> {
    let (feeder, count) = (scene.feeder(), scene.feeder().plate_count());
    let Some(named) = named else { return Ok(count - 1) };
    let by_name = (0..count).position(|plate| feeder.given(plate) == named);
    let found = by_name.or_else(|| named.parse().ok().filter(|number| *number < count));
    found.ok_or_else(|| {
        let names: Vec<String> = (0..count).map(|plate| part::obstacle(scene.feeder(), plate)).collect();
        format!("\"{named}\" is none of {}", names.join(", "))
    })
}

/// What is wanted of a part on each plate, in words; `None` where nothing is.
pub fn wants(feeder: &impl Names, wants: &[Option<Want>]) -> Option<String> {
    let wants = wants.iter().enumerate().filter_map(|(plate, want)| {
        let want = match want.as_ref()? {
            Want::Any => return None,
            Want::Same => "same side".to_owned(),
            Want::Turned => "turned".to_owned(),
            Want::Face(face) => format!("face {face}"),
        };
        Some(format!("{want} on \"{}\"", part::obstacle(feeder, plate)))
    });
    let wants: Vec<String> = wants.collect();
    (!wants.is_empty()).then(|| wants.join(", "))
}

/// A path as a shell takes it: nothing within single quotes means anything but itself.
pub fn quoted(path: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "/._-:".contains(c) || cfg!(windows) && c == '\\';
    if path.chars().all(plain) { path.to_owned() } else { format!("'{}'", path.replace('\'', r"'\''")) }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn a_path_reaches_the_command_as_it_is() {
        assert_eq!(quoted("out/designer/worst-stuck.toml"), "out/designer/worst-stuck.toml");
        assert_eq!(quoted("out/$HOME/a b.toml"), "'out/$HOME/a b.toml'");
        assert_eq!(quoted("it's.toml"), r"'it'\''s.toml'");
    }
}
