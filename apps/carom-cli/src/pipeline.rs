//! The one place where the command calls the engine and the picture writers.

use crate::failure::Failure;
use carom_feeder::{Feed, FeedRun, Feeder, Run, RunError};
use carom_figure::{Axis, Draft, Extra, ImpactFigure, ImpulsePlane, JointWalk, QuantityLimit, Wish};
use carom_motion::planar::Options;
use carom_scene::{Limit, LimitEnd, MeasureAxis, Scene, labelled};
use carom_words::part;

/// What makes the pages, with its version.
pub(crate) const MADE_BY: &str = concat!("carom ", env!("CARGO_PKG_VERSION"));

/// Runs a feeder and keeps everything.
pub(crate) fn run(scene: &Scene) -> Result<Run, Failure> {
    scene.feeder().run().map_err(|error| Failure::Undone(format!("{}: {error}", scene.name())))
}

/// Feeds several parts, where a scene wants that.
pub(crate) fn feed(scene: &Scene) -> Result<Option<FeedRun>, Failure> {
    let Some(feed) = scene.feed() else { return Ok(None) };
    let undone = |error: RunError| Failure::Undone(format!("{}: the feed: {error}", scene.name()));
    let prepared = scene.feeder().prepare(Options::default()).map_err(undone)?;
    prepared.feed(feed).map(Some).map_err(undone)
}

/// The page of a feed.
pub(crate) fn feed_report(scene: &Scene, feed: &Feed, run: &FeedRun) -> String {
    carom_figure::feed_report(scene.feeder(), feed, run, scene.name(), &extra(scene, None))
}

/// Runs a feeder for its verdict alone; `None` where it cannot be run.
pub(crate) fn verdict(feeder: &Feeder) -> Option<Run> {
    feeder.run_untraced().ok()
}

/// The report of a run, one HTML page.
pub(crate) fn report(scene: &Scene, run: &Run, limits: Option<&[Limit]>) -> String {
    let wanted = wishes(scene, run);
    carom_figure::report(scene.feeder(), run, scene.name(), &Extra { wanted, ..extra(scene, limits) })
}

/// The report of a run of a layout that was found, with what must be said of it.
pub(crate) fn design_report(scene: &Scene, run: &Run, mut said: Vec<String>) -> String {
    let extra = extra(scene, None);
    said.extend(extra.notes.iter().cloned());
    let wanted = wishes(scene, run);
    carom_figure::report(scene.feeder(), run, scene.name(), &Extra { wanted, notes: said, ..extra })
}

fn wishes(scene: &Scene, run: &Run) -> Vec<Wish> {
    let feeder = scene.feeder();
    let label = |name: String| match feeder.plates.iter().position(|plate| plate.name == name) {
        Some(plate) => part::obstacle(feeder, plate),
        None => name,
    };
    let wanted = scene.wanted(run).into_iter();
    wanted.map(|wanted| Wish { plate: label(wanted.plate), want: wanted.want, met: wanted.met }).collect()
}

/// What a page says of a scene beside its run.
fn extra(scene: &Scene, limits: Option<&[Limit]>) -> Extra {
    Extra {
        made_by: MADE_BY.to_owned(),
        scene: Some(scene.source().to_owned()),
        limits: limits.unwrap_or_default().iter().filter_map(|limit| shown(scene, limit)).collect(),
        notes: scene.notes().to_vec(),
        wanted: vec![],
        draft: draft(scene),
    }
}

/// What a scene's author drew and wrote, for its pictures.
pub(crate) fn draft(scene: &Scene) -> Draft {
    let measures = scene.measures().into_iter().map(|measure| carom_figure::Measure {
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
    });
    Draft { outline: scene.outline(), measures: measures.collect() }
}

/// A limit in the unit a drawing uses.
fn shown(scene: &Scene, limit: &Limit) -> Option<QuantityLimit> {
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

/// The layout of a feeder as SVG.
pub(crate) fn layout(scene: &Scene) -> String {
    carom_figure::layout_svg(scene.feeder(), None, &draft(scene))
}

/// The drawings of a scene for a workshop, with their names.
pub(crate) fn drawings(scene: &Scene) -> [(&'static str, String); 2] {
    let (feeder, draft) = (scene.feeder(), draft(scene));
    [
        ("drawing.dxf", carom_figure::layout_dxf(feeder, &draft)),
        ("drawing.svg", carom_figure::drawing_svg(feeder, &draft)),
    ]
}

/// An impulse plane as SVG.
pub(crate) fn impulse_svg(plane: &ImpulsePlane) -> String {
    carom_figure::impulse_svg(plane)
}

/// The walk of several contacts as SVG.
pub(crate) fn joint_svg(walk: &JointWalk) -> String {
    carom_figure::joint_svg(walk)
}

/// The report of an impact, one HTML page.
pub(crate) fn impact_report(figure: &ImpactFigure) -> String {
    carom_figure::impact_report(figure)
}

/// An impulse plane for a terminal.
pub(crate) fn impulse_text(plane: &ImpulsePlane) -> String {
    carom_figure::impulse_text(plane, 60, 18)
}

/// Every sample of a run as CSV.
pub(crate) fn trace(feeder: &Feeder, run: &Run) -> String {
    carom_figure::trace_csv(feeder, run)
}
