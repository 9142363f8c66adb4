//! The clock of a joint walk: normal velocities and slips of every contact over the normal impulse of all of them.

use crate::joint::JointWalk;
use crate::joint_drawing::{LEFT, dotted};
use crate::markup::{Markup, html, joined};
use crate::svg::{self, line, text};
use crate::text::{fixed, px};
use crate::ticks::{ticks, widened};
use crate::tolerance::ROUNDING;
use carom_impact::Phase;

/// Height of a strip, and of a strip with its name [px].
const STRIP: f64 = 118.0;
const HEAD: f64 = 26.0;
/// Room above the first strip, and for the names at the end of lines [px].
const LEAD: f64 = 14.0;
const NAMES: f64 = 84.0;
/// Stage boundaries nearer than this are one line; a number stands where there is room [px].
const NEAR: f64 = 3.0;
const DIGIT: f64 = 7.2;

/// Height of both strips with their axis [px].
pub(crate) const HEIGHT: f64 = LEAD + 2.0 * (STRIP + HEAD) + 46.0;

struct Strip {
    top: f64,
    right: f64,
    /// Range of the clock.
    x: (f64, f64),
    /// Range of the ordinate.
    y: (f64, f64),
}

impl Strip {
    fn x(&self, clock: f64) -> f64 {
        LEFT + (clock - self.x.0) / (self.x.1 - self.x.0) * (self.right - LEFT)
    }

    fn y(&self, velocity: f64) -> f64 {
        self.top + (self.y.1 - velocity) / (self.y.1 - self.y.0) * STRIP
    }
}

/// The strips in a figure of this width, from `top` down: each with its axis of the velocities.
fn all(walk: &JointWalk, clock: &[f64], width: f64, top: f64) -> [(usize, Strip); 2] {
    let (from, to) = (clock.first().copied().unwrap_or(0.0), clock.last().copied().unwrap_or(1.0));
    let x = if to > from { (from, to) } else { (from, from + 1.0) };
    [(0, 1), (1, 0)].map(|(k, axis)| {
        let top = top + LEAD + HEAD * (k + 1) as f64 + STRIP * k as f64;
        (axis, Strip { top, right: width - NAMES, x, y: range(walk, axis) })
    })
}

/// Both strips, from `top` down.
pub(crate) fn strips(walk: &JointWalk, width: f64, top: f64) -> Markup {
    let clock = walk.clock();
    let strips = all(walk, &clock, width, top);
    let mut out: Vec<Markup> = vec![];
    let names = ["normal velocity u\u{2099} [m/s]", "slip u\u{209c} [m/s]"];
    for (k, ((axis, strip), name)) in strips.iter().zip(names).enumerate() {
        out.push(restitution(walk, &clock, strip));
        out.push(grid(strip, name));
        out.push(boundaries(&clock, strip, k == 0));
        for i in 0..walk.contacts.len() {
            out.push(course(walk, &clock, [i, *axis], strip));
        }
        out.push(end_names(walk, *axis, strip));
    }
    let (_, Strip { right, x, .. }) = &strips[0];
    out.push(clock_axis(*x, *right, top + LEAD + 2.0 * (HEAD + STRIP)));
    joined(out)
}

/// Where each contact is on both strips: at the start, and at the end of each stage.
pub(crate) fn tracks(walk: &JointWalk, width: f64, top: f64) -> Vec<(usize, Vec<[f64; 2]>)> {
    let clock = walk.clock();
    let strips = all(walk, &clock, width, top);
    let of = |(axis, strip): &(usize, Strip), i: usize| {
        let points = clock.iter().zip(velocities(walk, i, *axis));
        (i, points.map(|(clock, velocity)| [strip.x(*clock), strip.y(velocity)]).collect())
    };
    strips.iter().flat_map(|strip| (0..walk.contacts.len()).map(move |i| of(strip, i))).collect()
}

/// Velocities before the first stage and at the end of each.
fn velocities(walk: &JointWalk, i: usize, axis: usize) -> Vec<f64> {
    let first = walk.stages.first().map(|stage| stage.pieces[i].velocity[0][axis]);
    first.into_iter().chain(walk.stages.iter().map(|stage| stage.pieces[i].velocity[1][axis])).collect()
}

/// What a strip shows: all of its velocities and zero.
fn range(walk: &JointWalk, axis: usize) -> (f64, f64) {
    let all = |axis: usize| (0..walk.contacts.len()).flat_map(move |i| velocities(walk, i, axis));
    let (low, high) = all(axis).fold((0.0f64, 0.0f64), |(low, high), v| (low.min(v), high.max(v)));
    let largest = all(0).chain(all(1)).fold(0.0f64, |most, v| most.max(v.abs()));
    if high - low <= ROUNDING * largest {
        return widened(-0.1 * largest, 0.1 * largest, 3);
    }
    let pad = 0.06 * (high - low);
    (low - pad, high + pad)
}

/// The ground of restitution.
fn restitution(walk: &JointWalk, clock: &[f64], strip: &Strip) -> Markup {
    let mut out: Vec<Markup> = vec![];
    for (stage, ends) in walk.stages.iter().zip(clock.windows(2)) {
        if stage.phase == Phase::Restitution {
            let (left, right) = (strip.x(ends[0]), strip.x(ends[1]));
            out.push(svg::rect("restitution", [left, strip.top], [right - left, STRIP]));
        }
    }
    joined(out)
}

fn grid(strip: &Strip, name: &str) -> Markup {
    let mut out = vec![text("name", [LEFT - 54.0, strip.top - 7.0], "start", name)];
    let up = ticks(strip.y.0, strip.y.1, 4);
    for v in &up.at {
        let y = strip.y(*v);
        out.push(line(if *v == 0.0 { "zero" } else { "grid" }, [LEFT, y], [strip.right, y]));
        out.push(text("tick", [LEFT - 6.0, y + 3.8], "end", &fixed(*v, up.decimals)));
    }
    let frame = format!("M{} {}V{}H{}", px(LEFT), px(strip.top), px(strip.top + STRIP), px(strip.right));
    out.push(svg::path("axis", &frame));
    joined(out)
}

/// Where stages end, with their numbers above the first strip.
fn boundaries(clock: &[f64], strip: &Strip, is_numbered: bool) -> Markup {
    let mut out: Vec<Markup> = vec![];
    let (mut drawn, mut written) = (f64::NEG_INFINITY, f64::NEG_INFINITY);
    for (k, at) in clock.iter().enumerate().skip(1) {
        let x = strip.x(*at);
        if x - drawn >= NEAR {
            out.push(line("event", [x, strip.top], [x, strip.top + STRIP]));
            drawn = x;
        }
        let number = k.to_string();
        let half = 0.5 * DIGIT * number.len() as f64;
        if is_numbered && x - half >= written {
            out.push(text("stage", [x, strip.top - 5.0], "middle", &number));
            written = x + half + 4.0;
        }
    }
    joined(out)
}

/// One velocity of one contact. Lines that coincide show by their widths: the first is the widest.
fn course(walk: &JointWalk, clock: &[f64], [i, axis]: [usize; 2], strip: &Strip) -> Markup {
    let points = velocities(walk, i, axis);
    let mut d = String::new();
    for (velocity, at) in points.iter().zip(clock) {
        svg::to(&mut d, [strip.x(*at), strip.y(*velocity)]);
    }
    let others = (walk.contacts.len() - 1).max(1) as f64;
    let width = 1.5 + (1.2 * others).min(3.2) * (1.0 - i as f64 / others);
    let mut out = vec![html! { path class={ "velocity k" (i % 6) } stroke-width=(px(width)) d=(d) {} }];
    if let (Some(last), Some(at)) = (points.last(), clock.last()) {
        out.push(dotted(i, [strip.x(*at), strip.y(*last)]));
    }
    joined(out)
}

/// The names at the ends of lines; those of one value share a line, and none covers another.
fn end_names(walk: &JointWalk, axis: usize, strip: &Strip) -> Markup {
    const APART: f64 = 13.0;
    let last = |i: usize| velocities(walk, i, axis).last().copied().unwrap_or(0.0);
    let mut order: Vec<(f64, usize)> = (0..walk.contacts.len()).map(|i| (strip.y(last(i)), i)).collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let lowest = strip.top + STRIP;
    let mut floor = f64::NEG_INFINITY;
    let mut places: Vec<f64> = vec![];
    for (y, _) in &order {
        floor = y.max(floor + APART);
        places.push(floor);
    }
    // What ran over the floor is pushed up again.
    let mut ceiling = lowest;
    for place in places.iter_mut().rev() {
        *place = place.min(ceiling);
        ceiling = *place - APART;
    }
    let names = order.iter().zip(&places).map(|((_, i), y)| {
        let class = format!("contact k{}", i % 6);
        text(&class, [strip.right + 9.0, y + 4.0], "start", &walk.contacts[*i].name)
    });
    joined(names)
}

fn clock_axis(x: (f64, f64), right: f64, floor: f64) -> Markup {
    let mut out: Vec<Markup> = vec![];
    let strip = Strip { top: 0.0, right, x, y: (0.0, 1.0) };
    let across = ticks(x.0, x.1, 8);
    for v in &across.at {
        let at = strip.x(*v);
        out.push(line("axis", [at, floor], [at, floor + 4.0]));
        out.push(text("tick", [at, floor + 16.0], "middle", &fixed(*v, across.decimals)));
    }
    out.push(text("name", [right, floor + 30.0], "end", "the clock: normal impulse of all contacts [N s]"));
    joined(out)
}
