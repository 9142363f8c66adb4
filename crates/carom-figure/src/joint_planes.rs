//! The impulse planes of a joint walk: a panel a contact, all on one scale.

use crate::joint::JointWalk;
use crate::joint_drawing::{LEFT, RIGHT, dotted};
use crate::markup::{Markup, html, joined};
use crate::svg::{self, line, text};
use crate::text::{fixed, px, trimmed};
use crate::ticks::ticks;
use carom_impact::Phase;
use carom_num::Vec2;

/// Height of a panel's plane, and of a row with its names and ticks [px].
const PLANE: f64 = 190.0;
const HEAD: f64 = 26.0;
const ROW: f64 = PLANE + HEAD + 30.0;
const GAP: f64 = 18.0;
/// Dots nearer than this share a number [px].
const NEAR: f64 = 7.0;
/// Width of a digit of a number [px].
const LETTER: f64 = 7.2;

/// Panels of a row.
fn columns(contacts: usize) -> usize {
    match contacts {
        0..=3 => contacts.max(1),
        4 => 2,
        _ => 3,
    }
}

/// Height of all panels [px].
pub(crate) fn height(contacts: usize) -> f64 {
    ROW * contacts.div_ceil(columns(contacts)) as f64 + 8.0
}

/// One panel: where it lies and what it shows.
struct Panel {
    left: f64,
    top: f64,
    width: f64,
    half: f64,
    normal: f64,
}

impl Panel {
    fn at(&self, [tangential, normal]: [f64; 2]) -> [f64; 2] {
        let x = self.left + normal / self.normal * self.width;
        [x, self.top + 0.5 * PLANE * (1.0 - tangential / self.half)]
    }

    fn floor(&self) -> f64 {
        self.top + PLANE
    }
}

/// Where the panels lie in a figure of this width, from `top` down.
fn panels(walk: &JointWalk, width: f64, top: f64) -> Vec<Panel> {
    let (half, normal) = walk.extent();
    let columns = columns(walk.contacts.len());
    let free = width - LEFT - RIGHT - GAP * (columns - 1) as f64;
    let width = free / columns as f64;
    let panel = |i: usize| {
        let (column, row) = ((i % columns) as f64, (i / columns) as f64);
        let left = LEFT + column * (width + GAP);
        Panel { left, top: top + HEAD + row * ROW, width, half, normal }
    };
    (0..walk.contacts.len()).map(panel).collect()
}

/// All panels, in a figure of this width, from `top` down.
pub(crate) fn planes(walk: &JointWalk, width: f64, top: f64) -> Markup {
    let mut out = vec![text("name", [LEFT - 54.0, top], "start", "tangential impulse p\u{209c} [N s]")];
    let bottom = top + height(walk.contacts.len());
    out.push(text("name", [width - RIGHT, bottom - 4.0], "end", "normal impulse p\u{2099} [N s]"));
    for (i, panel) in panels(walk, width, top).iter().enumerate() {
        out.push(axes(panel, i % columns(walk.contacts.len()) == 0));
        out.push(cone(panel, walk.contacts[i].friction));
        out.push(heading(walk, i, panel));
        out.push(path(walk, i, panel));
    }
    joined(out)
}

/// Where each contact is in its panel: at the start, and at the end of each stage.
pub(crate) fn tracks(walk: &JointWalk, width: f64, top: f64) -> Vec<Vec<[f64; 2]>> {
    let first = |i: usize| walk.stages.first().map(|stage| stage.pieces[i].impulse[0]);
    let track = |(i, panel): (usize, &Panel)| {
        let ends = walk.stages.iter().map(|stage| stage.pieces[i].impulse[1]);
        first(i).into_iter().chain(ends).map(|impulse| panel.at(impulse)).collect()
    };
    panels(walk, width, top).iter().enumerate().map(track).collect()
}

fn heading(walk: &JointWalk, i: usize, panel: &Panel) -> Markup {
    let contact = &walk.contacts[i];
    let baseline = panel.top - 7.0;
    let friction = format!("μ = {}", trimmed(contact.friction, 4));
    html! {
        (text(&format!("contact k{}", i % 6), [panel.left, baseline], "start", &contact.name))
        (text("small", [panel.left + panel.width, baseline], "end", &friction))
    }
}

fn axes(panel: &Panel, is_first: bool) -> Markup {
    let right = panel.left + panel.width;
    let mut out: Vec<Markup> = vec![];
    let up = ticks(-panel.half, panel.half, 5);
    for v in &up.at {
        let [x, y] = panel.at([*v, 0.0]);
        out.push(line(if *v == 0.0 { "zero" } else { "grid" }, [x, y], [right, y]));
        if is_first {
            out.push(text("tick", [x - 6.0, y + 3.8], "end", &fixed(*v, up.decimals)));
        }
    }
    let across = ticks(0.0, panel.normal, 4);
    for v in &across.at {
        let x = panel.at([0.0, *v])[0];
        out.push(line("axis", [x, panel.floor()], [x, panel.floor() + 4.0]));
        out.push(text("tick", [x, panel.floor() + 16.0], "middle", &fixed(*v, across.decimals)));
    }
    let frame = format!("M{0} {1}V{2}H{3}", px(panel.left), px(panel.top), px(panel.floor()), px(right));
    out.push(svg::path("axis", &frame));
    joined(out)
}

fn cone(panel: &Panel, friction: f64) -> Markup {
    if friction == 0.0 {
        return html! {};
    }
    // Where the cone leaves the panel.
    let reach = (panel.half / friction).min(panel.normal);
    let o = panel.at([0.0, 0.0]);
    let (up, down) = (panel.at([friction * reach, reach]), panel.at([-friction * reach, reach]));
    let corner = panel.left + panel.width;
    let edge = |to: [f64; 2]| format!("M{} {}L{} {}", px(o[0]), px(o[1]), px(to[0]), px(to[1]));
    let far = format!("H{}V{}H{}Z", px(corner), px(down[1]), px(down[0]));
    html! {
        path.cone d=(edge(up) + &far) {}
        path.cone-edge d=(edge(up) + &edge(down)) {}
    }
}

/// The walked line of one contact with its dots: those that fall together share a number.
fn path(walk: &JointWalk, i: usize, panel: &Panel) -> Markup {
    let mut out: Vec<Markup> = vec![];
    let ends: Vec<[f64; 2]> = walk.stages.iter().map(|stage| panel.at(stage.pieces[i].impulse[1])).collect();
    for (phase, class) in [(Phase::Compression, "walk"), (Phase::Restitution, "walk restitution")] {
        let stages = walk.stages.iter().filter(|stage| stage.phase == phase);
        let mut pen: Option<[f64; 2]> = None;
        let mut d = String::new();
        for stage in stages {
            let [from, to] = stage.pieces[i].impulse.map(|p| panel.at(p));
            if pen != Some(from) {
                d += &format!("M{} {}", px(from[0]), px(from[1]));
            }
            if from != to {
                d += &format!("L{} {}", px(to[0]), px(to[1]));
            }
            pen = Some(to);
        }
        if d.contains('L') {
            out.push(svg::path(&format!("{class} k{}", i % 6), &d));
        }
    }
    let start = walk.stages.first().map_or([0.0; 2], |stage| stage.pieces[i].impulse[0]);
    let origin = panel.at(start);
    out.push(svg::circle(&format!("start k{}", i % 6), origin, 3.0));
    let mut drawn = origin;
    for (k, end) in ends.iter().enumerate() {
        // A dot on a dot says nothing.
        if k == 0 || distance(drawn, *end) >= 0.5 {
            out.push(dotted(i, *end));
            drawn = *end;
        }
    }
    for Number { words, at, .. } in numbers(&ends, origin, panel) {
        out.push(text(&format!("number k{}", i % 6), [at[0], at[1] + 4.0], "middle", &words));
    }
    joined(out)
}

/// The number of a dot, or of a run of neighbouring dots that have no room for one each.
struct Number {
    first: usize,
    words: String,
    /// Its middle.
    at: [f64; 2],
    /// The last of its dots.
    dot: [f64; 2],
}

impl Number {
    fn new((first, last): (usize, usize), ends: &[[f64; 2]], origin: [f64; 2], panel: &Panel) -> Self {
        let words =
            if first == last { (first + 1).to_string() } else { format!("{}–{}", first + 1, last + 1) };
        let before = if first == 0 { origin } else { ends[first - 1] };
        let [x, y] = beside(ends[last], before, ends.get(last + 1).copied());
        let x = x.clamp(panel.left + 5.0, panel.left + panel.width - 5.0);
        let y = y.clamp(panel.top + 4.0, panel.floor() - 7.0);
        Self { first, words, at: [x, y], dot: ends[last] }
    }

    /// True where the two cannot be told apart: dot on dot, or number over number.
    fn meets(&self, other: &Self) -> bool {
        let half = |number: &Self| 0.5 * LETTER * number.words.chars().count() as f64 + 1.0;
        let over = (self.at[0] - other.at[0]).abs() < half(self) + half(other)
            && (self.at[1] - other.at[1]).abs() < LETTER + 4.0;
        over || distance(self.dot, other.dot) < NEAR
    }
}

/// Numbers of all dots: each has its own, or shares one with those before it that it would meet.
fn numbers(ends: &[[f64; 2]], origin: [f64; 2], panel: &Panel) -> Vec<Number> {
    let mut out: Vec<Number> = vec![];
    for k in 0..ends.len() {
        let mut number = Number::new((k, k), ends, origin, panel);
        while let Some(met) = out.iter().position(|before| before.meets(&number)) {
            number = Number::new((out[met].first, k), ends, origin, panel);
            out.truncate(met);
        }
        out.push(number);
    }
    out
}

fn distance([a, b]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    Vec2::new(a - x, b - y).norm()
}

/// A place for a number outside the corner that a path makes at a point.
fn beside(point: [f64; 2], before: [f64; 2], after: Option<[f64; 2]>) -> [f64; 2] {
    let unit = |from: [f64; 2], to: [f64; 2]| {
        let length = distance(from, to);
        if length > 0.0 { [(to[0] - from[0]) / length, (to[1] - from[1]) / length] } else { [0.0; 2] }
    };
    let come = unit(before, point);
    let go = after.map_or(come, |after| unit(point, after));
    let out = [come[0] - go[0], come[1] - go[1]];
    let size = Vec2::new(out[0], out[1]).norm();
    // A straight path has no corner: beside it, on the upper side.
    let [x, y] = if come == [0.0; 2] {
        [0.0, -1.0]
    } else if size > 0.2 {
        [out[0] / size, out[1] / size]
    } else if come[0] >= 0.0 {
        [come[1], -come[0]]
    } else {
        [-come[1], come[0]]
    };
    [point[0] + 12.0 * x, point[1] + 12.0 * y]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_that_fall_together_share_a_number() {
        let panel = Panel { left: -50.0, top: -100.0, width: 400.0, half: 1.0, normal: 1.0 };
        let ends = [[0.0, 0.0], [1.0, 0.0], [8.0, 0.0], [60.0, 0.0], [120.0, 0.0], [121.0, 1.0]];
        let words: Vec<String> =
            numbers(&ends, [-20.0, 0.0], &panel).into_iter().map(|number| number.words).collect();
        assert_eq!(words, ["1–3", "4", "5–6"]);
    }

    #[test]
    fn a_number_stands_outside_a_corner() {
        // Down to the right, then up to the right: the corner points down.
        let [x, y] = beside([10.0, 10.0], [0.0, 0.0], Some([20.0, 0.0]));
        assert!((x - 10.0).abs() < 1e-12 && y > 20.0, "{x} {y}");
        let [_, above] = beside([10.0, 0.0], [0.0, 0.0], Some([20.0, 0.0]));
        assert!(above < 0.0, "beside a straight path");
    }
}
