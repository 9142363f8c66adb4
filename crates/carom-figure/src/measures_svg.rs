//! Measures as SVG: dimension lines with their heads, lines out to them, and texts that stay on the paper.

use crate::draft::Axis;
use crate::labels::Labels;
use crate::markup::{Markup, html, joined};
use crate::measures::Drawn;
use crate::svg;
use crate::text::px;
use crate::tolerance::ROUNDING;
use crate::view::View;
use carom_num::Vec2;
use carom_num::elementary::{cos, sin};

/// How far a dimension line stands outside of what it measures [px].
const OUTSIDE: f64 = 32.0;
/// How far one stands off a plate, beyond the plate's name.
const BEHIND: f64 = 38.0;
/// Nothing shorter than this has room for two heads.
const SHORTEST: f64 = 14.0;

/// All lengths, in their order: the first ones have the best places.
pub(crate) fn lengths_svg(lengths: &[Drawn], view: &View, labels: &mut Labels) -> Markup {
    joined(lengths.iter().map(|drawn| length_svg(drawn, view, labels)))
}

/// Lengths of the line from an arc to the text of its radius, and how far it may turn off the radius [rad].
const LEADERS: [f64; 3] = [26.0, 44.0, 66.0];
const LEADER_TURNS: [f64; 5] = [0.0, 0.5, -0.5, 1.0, -1.0];

/// The two ends of the dimension line on paper.
fn line_of(drawn: &Drawn, view: &View) -> (Vec2, Vec2) {
    let (from, to) = (view.at(drawn.from), view.at(drawn.to));
    let across = to - from;
    match drawn.axis {
        Axis::Plumb if across.x.abs() > SHORTEST => {
            let x = if to.x > 0.5 * view.width() { to.x + OUTSIDE } else { to.x - OUTSIDE };
            (Vec2::new(x, from.y), Vec2::new(x, to.y))
        }
        Axis::Plumb => (Vec2::new(to.x, from.y), to),
        Axis::Level if across.y.abs() > SHORTEST => {
            let y = from.y.min(to.y) - OUTSIDE;
            (Vec2::new(from.x, y), Vec2::new(to.x, y))
        }
        Axis::Level => (from, Vec2::new(to.x, from.y)),
        Axis::Along | Axis::Slope | Axis::Radius => {
            let down = across.unit().map(Vec2::turned_left).unwrap_or_default();
            let down = if down.y < 0.0 { -down } else { down };
            (from + down * BEHIND, to + down * BEHIND)
        }
    }
}

/// A length with its place on paper.
pub(crate) struct Placed {
    /// The ends of its dimension line.
    pub(crate) line: (Vec2, Vec2),
    /// The middle of its text.
    pub(crate) at: Vec2,
    /// The way its text runs.
    pub(crate) along: Vec2,
}

/// Where a length stands; `None` where its ends are at one place, or one of them is off the paper.
pub(crate) fn placed(drawn: &Drawn, view: &View, labels: &mut Labels) -> Option<Placed> {
    if drawn.axis == Axis::Radius {
        return radius_placed(drawn, view, labels);
    }
    let (a, b) = line_of(drawn, view);
    let along = (b - a).unit().filter(|_| labels.holds(a) && labels.holds(b))?;
    let right = if along.x < 0.0 { -along } else { along };
    let outside = (a - view.at(drawn.from)).norm() > 1.0 || (b - view.at(drawn.to)).norm() > 1.0;
    let text_along = match drawn.axis {
        // What is upright and outside is read from the right, as drawings have it.
        Axis::Plumb if outside => Vec2::new(0.0, -1.0),
        Axis::Plumb | Axis::Level => Vec2::new(1.0, 0.0),
        Axis::Along | Axis::Slope | Axis::Radius => right,
    };
    let room = Labels::room(&drawn.text, text_along);
    let off = off_line(along, room);
    // Outside of a wall its name and hatching are between the wall and the line.
    let off = if outside && drawn.axis == Axis::Plumb && a.x > 0.5 * view.width() { -off } else { off };
    let shares = [0.5, 0.62, 0.38, 0.75, 0.25, 0.9, 0.1];
    let mut places: Vec<Vec2> = vec![];
    if drawn.axis == Axis::Level && (b - a).norm() < room.x {
        // A text longer than its line ends where the line does, and stands below it: above is the plate.
        places.extend([-off, off].map(|off| b - along * (0.5 * room.x + 4.0) + off));
    }
    places.extend(shares.iter().flat_map(|share| [off, -off].map(|off| a + (b - a) * *share + off)));
    let at = labels.place(room, places);
    if drawn.axis != Axis::Along {
        labels.keep_off(a, b);
    }
    Some(Placed { line: (a, b), at, along: text_along })
}

/// Where the radius of an arc stands: at the end of a line that comes to the arc from outside.
fn radius_placed(drawn: &Drawn, view: &View, labels: &mut Labels) -> Option<Placed> {
    let (centre, a) = (view.at(drawn.from), view.at(drawn.to));
    let out = (a - centre).unit().filter(|_| labels.holds(a))?;
    let along = Vec2::new(1.0, 0.0);
    let room = Labels::room(&drawn.text, along);
    let end_and_text = |length: f64, turn: f64| {
        let end = a + out.rotated(cos(turn), sin(turn)) * length;
        let side = if end.x < a.x { -1.0 } else { 1.0 };
        (end, end + Vec2::new(side * (0.5 * room.x + 2.0), 0.0))
    };
    let places: Vec<_> =
        LEADERS.into_iter().flat_map(|length| LEADER_TURNS.map(|turn| end_and_text(length, turn))).collect();
    let at = labels.place(room, places.iter().map(|(_, text)| *text));
    // A text moved onto the paper has its line come from its near side.
    let moved = || at - Vec2::new(if at.x < a.x { -0.5 } else { 0.5 } * room.x, 0.0);
    let end = places.iter().find(|(_, text)| *text == at).map_or_else(moved, |(end, _)| *end);
    Some(Placed { line: (end, a), at, along })
}

fn length_svg(drawn: &Drawn, view: &View, labels: &mut Labels) -> Markup {
    let Some(placed) = placed(drawn, view, labels) else { return html! {} };
    let (a, b) = placed.line;
    let along = (b - a).unit().unwrap_or_default();
    // Lines out to a dimension line that lies on what it measures would only thicken it.
    let out = [(view.at(drawn.from), a), (view.at(drawn.to), b)];
    let is_radius = drawn.axis == Axis::Radius;
    let out = out.into_iter().filter(|(point, end)| !is_radius && (*end - *point).norm() > 1.0);
    let class = if drawn.written { "dim" } else { "dim follows" };
    html! {
        @for (point, end) in out { (svg::line("thin out", svg::xy(point), svg::xy(end))) }
        (svg::line("thin", svg::xy(a), svg::xy(b)))
        @if is_radius { (svg::path("head", &head(b, along))) }
        @else if (b - a).norm() > SHORTEST { (svg::path("head", &(head(b, along) + &head(a, -along)))) }
        text class=(class) text-anchor="middle" dominant-baseline="central"
            transform=(svg::placed(placed.at, placed.along)) { (drawn.text) }
    }
}

/// From a line to the middle of its text: above it, or to its left.
fn off_line(along: Vec2, room: Vec2) -> Vec2 {
    let normal = along.turned_left();
    let normal =
        if normal.y > ROUNDING || (normal.y.abs() <= ROUNDING && normal.x > 0.0) { -normal } else { normal };
    let reach = 0.5 * (room.x * normal.x.abs() + room.y * normal.y.abs());
    // A slanted text's own height is what keeps it off, not that of the box around it.
    let slanted = along.x.abs() > 0.1 && along.y.abs() > 0.1;
    normal * if slanted { 9.0 } else { reach + 2.0 }
}

fn head(tip: Vec2, direction: Vec2) -> String {
    let side = direction.turned_left() * 2.6;
    let (p, q) = (tip - direction * 8.0 + side, tip - direction * 8.0 - side);
    format!("M{} {}L{} {}L{} {}Z", px(tip.x), px(tip.y), px(p.x), px(p.y), px(q.x), px(q.y))
}
