//! The layout to scale: plates, walls, dimensions, and of a run the path with the part's poses.

use crate::FIGURE_CSS;
use crate::draft::Draft;
use crate::labels::Labels;
use crate::markup::{Markup, PreEscaped, document, html, joined};
use crate::measures::{lengths, slope_text};
use crate::measures_svg::lengths_svg;
use crate::mechanism::{Drawn, drawn, obstacles_svg, path_svg, view_of};
use crate::motion::poses;
use crate::outline::outline;
use crate::senses::slope;
use crate::sight::seen;
use crate::svg;
use crate::text::{fixed, px};
use crate::ticks::ticks;
use crate::view::View;
use carom_feeder::{Feeder, Run, StageName};
use carom_motion::planar::Pose;
use carom_num::Vec2;
use carom_words::part;

/// Largest drawing, alone and in a report [px].
const ALONE: (f64, f64) = (900.0, 700.0);
const IN_REPORT: (f64, f64) = (500.0, 560.0);
/// Paper for labels beside the drawing, and above and below it [px].
const FRAME: (f64, f64) = (52.0, 26.0);
/// Paper for the scale under it [px].
const FOOT: f64 = 22.0;
/// Corners that are drawn of the part in all its places between stages, and as many at their starts: about a megabyte.
const MOST_OUTLINE_POINTS: usize = 1 << 16;
/// Stages that are numbered, where they are no more.
const LABELLED: usize = 24;

/// The layout as a stand-alone SVG drawing to scale, with slopes, plumb drops, gaps to walls and a scale bar.
///
/// With a run it also shows the path of the mass centre, the part at the start of every stage (numbered as in the stage table) and
/// between, and where it strikes. Plates that the drawing gives no length are cut to the neighbourhood of the motion.
///
/// # Example
/// Of a plate that falls 3 in 4 the slope is written, 36.9°; a run adds the part at the start of every stage.
/// ```
/// # use carom_feeder::{Feeder, Part, Plate, Start, Stop};
/// # use carom_impact::Law;
/// # use carom_num::Vec2;
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let form = Default::default();
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded, form }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// let draft = carom_figure::Draft::default();
/// let (layout, run) = (carom_figure::layout_svg(&feeder, None, &draft), feeder.run().unwrap());
/// assert!(layout.contains("36.9°"));
/// let moves = carom_figure::layout_svg(&feeder, Some(&run), &draft);
/// assert_eq!(moves.matches("class=\"ghost stage\"").count(), run.stages.len());
/// ```
pub fn layout_svg(feeder: &Feeder, run: Option<&Run>, draft: &Draft) -> String {
    document(layout(feeder, run, draft, true))
}

/// The layout, with its style inside where it stands alone.
pub(crate) fn layout(feeder: &Feeder, run: Option<&Run>, draft: &Draft, alone: bool) -> Markup {
    let part = |view: &View, labels: &mut Labels| match run.filter(|run| !run.trace.pieces.is_empty()) {
        Some(run) => motion(feeder, run, draft, view, labels),
        None => ghost(feeder, draft, feeder.start_state().pose, view, "ghost stage"),
    };
    laid_out(feeder, run, draft, alone, part)
}

/// The layout with a picture of the part in it.
pub(crate) fn laid_out(
    feeder: &Feeder,
    run: Option<&Run>,
    draft: &Draft,
    alone: bool,
    part: impl FnOnce(&View, &mut Labels) -> Markup,
) -> Markup {
    let (width, height) = if alone { ALONE } else { IN_REPORT };
    let view = view_of(feeder, run.as_slice(), width, height);
    let paper = Paper::around(&view);
    let mut labels = Labels::within(paper.low, paper.high - Vec2::new(0.0, FOOT));
    // Lengths first: they have the fewest places to go to, and names give way.
    let mut out = vec![
        obstacles_svg(feeder, &view),
        lengths_svg(&lengths(feeder, draft, false), &view, &mut labels),
        names_and_slopes(feeder, draft, &view, &mut labels),
    ];
    out.push(part(&view, &mut labels));
    out.push(scale_bar(&view));
    let [x, y, width, height] = [paper.low.x, paper.low.y, paper.size().x, paper.size().y].map(px);
    html! {
        svg xmlns="http://www.w3.org/2000/svg" class="fig layout" viewBox=(format!("{x} {y} {width} {height}"))
            width=(width) height=(height) role="img" aria-label="Layout to scale" {
            @if alone { style { (PreEscaped(FIGURE_CSS)) } (paper.svg()) }
            (joined(out))
        }
    }
}

/// The sheet on which a view is drawn, with room for labels around it.
pub(crate) struct Paper {
    pub(crate) low: Vec2,
    pub(crate) high: Vec2,
}

impl Paper {
    pub(crate) fn around(view: &View) -> Self {
        let low = Vec2::new(-FRAME.0, -FRAME.1);
        Self { low, high: Vec2::new(view.width() + FRAME.0, view.height() + FRAME.1 + FOOT) }
    }

    pub(crate) fn size(&self) -> Vec2 {
        self.high - self.low
    }

    fn svg(&self) -> Markup {
        svg::rect("paper", svg::xy(self.low), svg::xy(self.size()))
    }
}

pub(crate) fn ghost(feeder: &Feeder, draft: &Draft, pose: Pose, view: &View, class: &str) -> Markup {
    html! { g class=(class) { (outline(feeder, draft, pose, view).svg()) } }
}

fn motion(feeder: &Feeder, run: &Run, draft: &Draft, view: &View, labels: &mut Labels) -> Markup {
    let mut out = vec![ghosts_between(feeder, run, draft, view), path_svg(run, view)];
    let most = most_ghosts(feeder);
    for (i, stage) in run.stages.iter().enumerate() {
        if !stage.start.is_finite() {
            continue;
        }
        if i < most {
            out.push(ghost(feeder, draft, stage.start.pose, view, "ghost stage"));
        }
        let at = view.at(stage.start.pose.centre);
        out.push(svg::circle("centre", svg::xy(at), 2.6));
        if run.stages.len() <= LABELLED {
            out.push(stage_number(labels, at, i + 1));
        }
    }
    if let Some(last) = run.stages.last().filter(|s| s.end.is_finite() && inside(view, s.end.pose.centre)) {
        out.push(ghost(feeder, draft, last.end.pose, view, "ghost stage end"));
    }
    for impact in &run.trace.impacts {
        if let Some(contact) = impact.contacts.first().filter(|c| c.point.is_finite()) {
            out.push(svg::circle("strike", svg::xy(view.at(contact.point)), 4.5));
        }
    }
    joined(out)
}

fn inside(view: &View, p: Vec2) -> bool {
    p.x >= view.low.x && p.x <= view.high.x && p.y >= view.low.y && p.y <= view.high.y
}

/// How many times the part is drawn between its stages, and at their starts.
fn most_ghosts(feeder: &Feeder) -> usize {
    (MOST_OUTLINE_POINTS / feeder.part.body.shape.vertices().len().max(1)).max(LABELLED)
}

/// The part between stage boundaries, wherever it has moved or turned enough to be told apart; of too many every k-th.
fn ghosts_between(feeder: &Feeder, run: &Run, draft: &Draft, view: &View) -> Markup {
    let size = feeder.part.body.shape.size();
    let mut apart: Vec<Pose> = vec![];
    for stage in &run.stages {
        let step = if stage.name == StageName::Slide { 0.9 * size } else { 0.62 * size };
        let mut last = stage.start.pose;
        for piece in run.trace.pieces.get(stage.pieces.clone()).unwrap_or_default() {
            for pose in poses(piece, 200) {
                let moved = (pose.centre - last.centre).norm() / step + (pose.angle - last.angle).abs() / 0.9;
                let to_end = (pose.centre - stage.end.pose.centre).norm() / step
                    + (pose.angle - stage.end.pose.angle).abs() / 0.9;
                if moved >= 1.0 && to_end >= 0.5 && inside(view, pose.centre) {
                    apart.push(pose);
                    last = pose;
                }
            }
        }
    }
    let stride = apart.len().div_ceil(most_ghosts(feeder)).max(1);
    joined(apart.iter().step_by(stride).map(|pose| ghost(feeder, draft, *pose, view, "ghost")))
}

/// The number of a stage beside where it begins.
fn stage_number(labels: &mut Labels, at: Vec2, number: usize) -> Markup {
    let directions =
        [(-1.0, -1.0), (1.0, -1.0), (-1.4, 0.0), (1.4, 0.0), (-1.0, 1.0), (1.0, 1.0), (0.0, -1.4)];
    let places =
        [11.0, 18.0, 26.0].into_iter().flat_map(|r| directions.map(|(x, y)| at + Vec2::new(x, y) * r));
    let place = labels.place(Vec2::new(16.0, 16.0), places);
    html! {
        g.number {
            circle cx=(px(place.x)) cy=(px(place.y)) r="8" {}
            text x=(px(place.x)) y=(px(place.y + 3.8)) text-anchor="middle" { (number) }
        }
    }
}

/// Slopes and names of what is drawn.
pub(crate) fn names_and_slopes(feeder: &Feeder, draft: &Draft, view: &View, labels: &mut Labels) -> Markup {
    let mut out: Vec<Markup> = vec![];
    for (i, plate) in feeder.plates.iter().enumerate() {
        if let Some(d) = drawn(feeder, i, view).filter(|_| plate.form.course.is_empty()) {
            let text = slope_text(feeder, draft, i);
            out.push(slope_mark(&d, slope(plate.uphill, plate.edge), &text, labels));
        }
    }
    for i in 0..feeder.plates.len() + feeder.walls.len() {
        if let Some(d) = drawn(feeder, i, view) {
            out.push(plate_label(&d, &part::obstacle(feeder, i), labels));
        }
    }
    joined(out)
}

/// A length in millimetres, to 0.01 mm.
pub(crate) fn millimetres(length: f64) -> String {
    let text = fixed(1e3 * length, 2);
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    format!("{text} mm")
}

/// The point of the nearest wall level with a plate's free edge, on its downhill side.
pub(crate) fn wall_beside(feeder: &Feeder, plate: usize) -> Option<Vec2> {
    let plate = feeder.plates.get(plate)?;
    let ahead = if plate.edge.x < plate.uphill.x { -1.0 } else { 1.0 };
    let walls = feeder.plates.len()..feeder.plates.len() + feeder.walls.len();
    let level = walls.filter_map(|wall| seen(feeder, wall, plate.edge, Vec2::new(ahead, 0.0)));
    level.min_by(|a, b| (a.x - plate.edge.x).abs().total_cmp(&(b.x - plate.edge.x).abs()))
}

/// Where the slope under a plate's lower end stands on paper.
pub(crate) struct SlopeMark {
    /// Radius of the arc.
    pub(crate) radius: f64,
    /// Ends of the arc: on the level line, on the plate.
    pub(crate) ends: (Vec2, Vec2),
    /// The middle of its text.
    pub(crate) at: Vec2,
}

/// A level line from the free edge, an arc, the angle; `None` where there is no room or no slope.
pub(crate) fn slope_place(d: &Drawn, slope: f64, text: &str, labels: &mut Labels) -> Option<SlopeMark> {
    let length = (d.to - d.from).norm();
    let r = 64.0_f64.min(0.6 * length);
    let back = (d.from - d.to).unit().filter(|_| slope.abs() > 0.01 && r > 24.0)?;
    let level = Vec2::new(if back.x < 0.0 { -1.0 } else { 1.0 }, 0.0);
    let room = Labels::room(text, Vec2::new(1.0, 0.0));
    let beside = level * (r + 0.5 * room.x);
    // Beside the arc, below the level line, and farther away where measures stand there.
    let places = [
        (5.0, 12.0),
        (12.0, 0.0),
        (5.0, -12.0),
        (-r, 14.0),
        (30.0, 6.0),
        (-0.5 * r, 18.0),
        (5.0, 28.0),
        (-r, 30.0),
        (40.0, 22.0),
        (60.0, 6.0),
        (5.0, 44.0),
        (60.0, 30.0),
    ];
    let at = labels.place(room, places.map(|(x, y)| d.to + beside + level * x + Vec2::new(0.0, y)));
    Some(SlopeMark { radius: r, ends: (d.to + level * r, d.to + back * r), at })
}

fn slope_mark(d: &Drawn, slope: f64, text: &str, labels: &mut Labels) -> Markup {
    let Some(mark) = slope_place(d, slope, text, labels) else { return html! {} };
    let (a, b) = mark.ends;
    let sweep = if (a - d.to).cross(b - d.to) > 0.0 { 1 } else { 0 };
    let [at, level, end] = [d.to, a, b].map(|p| format!("{} {}", px(p.x), px(p.y)));
    let data = format!("M{at}L{level}M{level}A{0} {0} 0 0 {sweep} {end}", px(mark.radius));
    html! {
        (svg::path("thin", &data))
        (svg::text("dim", [mark.at.x, mark.at.y + 4.0], "middle", text))
    }
}

/// The name along the back of a plate.
fn plate_label(d: &Drawn, name: &str, labels: &mut Labels) -> Markup {
    let (at, right) = name_place(d, name, labels);
    let turned = svg::placed(at, right);
    html! { text.name text-anchor="middle" dominant-baseline="middle" transform=(turned) { (name) } }
}

/// The middle of a name along the back of a plate, and which way it runs.
pub(crate) fn name_place(d: &Drawn, name: &str, labels: &mut Labels) -> (Vec2, Vec2) {
    let along = d.to - d.from;
    let share = if along.norm() > 320.0 { 0.3 } else { 0.42 };
    let right = if along.x < 0.0 { -along } else { along };
    let room = Labels::room(name, right.unit().unwrap_or_default());
    // Beyond the measures of a short plate, where no place along its back is clear of them.
    let shares = [share, 0.25, 0.6, 0.75, 0.5, 0.15];
    let places = [21.0, 50.0].map(|off| shares.map(|share| d.from + along * share + d.back * off));
    (labels.place(room, places.into_iter().flatten()), right)
}

/// One millimetre \[m\].
const MILLIMETRE: f64 = 1e-3;

/// A length to scale.
pub(crate) fn scale_bar(view: &View) -> Markup {
    let width = (view.high.x - view.low.x) * 1e3;
    let length = ticks(0.0, 0.3 * width, 2).at.last().copied().unwrap_or(0.0);
    let (bar, y) = (length * MILLIMETRE * view.scale, view.height() + FRAME.1 + 4.0);
    html! {
        path.axis d=(format!("M0 {0}v6M0 {1}H{2}M{2} {0}v6", px(y - 3.0), px(y), px(bar))) {}
        text.dim x=(px(bar + 8.0)) y=(px(y + 4.0)) { (millimetres(MILLIMETRE * length)) }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;

    #[test]
    fn a_slope_keeps_clear_of_the_measures_around_it() {
        let plate = Drawn {
            from: Vec2::new(100.0, 60.0),
            to: Vec2::new(250.0, 115.0),
            cut: [false; 2],
            back: Vec2::new(-0.34, 0.94),
        };
        // `below x 10 mm` and its kin, on either side of the level line and behind the arc.
        let measures = [(100.0, 104.0, 195.0, 140.0), (190.0, 118.0, 300.0, 134.0)];
        let mut labels = Labels::within(Vec2::ZERO, Vec2::new(500.0, 400.0));
        for (x, y, right, bottom) in measures {
            labels.keep_off(Vec2::new(x, y), Vec2::new(right, bottom));
        }
        let SlopeMark { at, .. } = slope_place(&plate, 0.35, "20°", &mut labels).unwrap();
        let half = Labels::room("20°", Vec2::new(1.0, 0.0)) * 0.5;
        for (x, y, right, bottom) in measures {
            let apart =
                at.x + half.x <= x || right <= at.x - half.x || at.y + half.y <= y || bottom <= at.y - half.y;
            assert!(apart, "20° at {at:?} lies on a measure from {x}, {y} to {right}, {bottom}");
        }
    }
}
