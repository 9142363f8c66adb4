//! One picture of an impact at several contacts: their impulse planes side by side, their velocities over one clock, and the stages.

use crate::FIGURE_CSS;
use crate::joint::{JointWalk, slip_words};
use crate::text::{escape, px};
use crate::{joint_planes, joint_strips};
use carom_impact::planar::Phase;

/// Margins of panels and strips [px].
pub(crate) const LEFT: f64 = 56.0;
pub(crate) const RIGHT: f64 = 16.0;
const TOP: f64 = 62.0;
const LINE: f64 = 17.0;
/// Columns of the table [px].
const NUMBERS: f64 = 34.0;
const PHASE: f64 = 92.0;
const UNTIL: f64 = 150.0;
const WIDEST: f64 = 130.0;
/// Stages that have a line each; of more, the last ones have one too.
const MOST_LINES: usize = 16;
const LAST_LINES: usize = 2;

/// The walk of several contacts as a stand-alone SVG.
///
/// - A panel a contact, all on one scale: tangential over normal impulse, the friction cone, the walked line (solid in compression, dotted
///   in restitution). Stage k ends at dot k in every panel.
/// - Normal velocities and slips of all contacts over the normal impulse of all contacts, stage boundaries as vertical lines.
/// - The stages: what ended each, and what each contact did.
///
/// Empty where there is no impulse to draw.
///
/// # Example
/// Without stages there is no impulse to draw.
/// ```
/// # use carom_figure::{JointContact, JointWalk};
/// # use {carom_impact::planar::{Law, ContactSet2, Touch, staged}, carom_num::Vec2};
/// # let normal = Vec2::new(0.0, 1.0);
/// # let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.2, restitution: 0.0 };
/// # let velocity = Vec2::new(0.0, -3.0);
/// # let rod = ContactSet2::of_free_body(1.0, 1.0 / 12.0, velocity, -6.0, &[end(-0.5), end(0.5)]).unwrap();
/// # let mut stages = vec![];
/// # staged::resolve_observed(&rod, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
/// # let contacts = ["A", "B"].map(|name| JointContact { name: name.to_owned(), friction: 0.2 }).to_vec();
/// let walk = JointWalk::of_stages(contacts, &stages);
/// assert!(carom_figure::joint_svg(&walk).contains("The walk of 2 contacts"));
/// assert_eq!(carom_figure::joint_svg(&JointWalk { stages: vec![], ..walk }), "");
/// ```
pub fn joint_svg(walk: &JointWalk) -> String {
    joint_drawing(walk, true)
}

/// The drawing, with its style inside where it stands alone.
pub(crate) fn joint_drawing(walk: &JointWalk, alone: bool) -> String {
    if !walk.can_be_drawn() {
        return String::new();
    }
    let width = width(walk.contacts.len());
    let strips_top = TOP + joint_planes::height(walk.contacts.len());
    let table_top = strips_top + joint_strips::HEIGHT;
    let (table, bottom) = table(walk, table_top);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig joint\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"The walk of {2} contacts through an impact, stage by stage\">\n",
        px(width),
        px(bottom),
        walk.contacts.len()
    );
    if alone {
        out += &format!(
            "<style>{FIGURE_CSS}{JOINT_CSS}</style>\n<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n",
            px(width),
            px(bottom)
        );
    }
    out += &key();
    out += &joint_planes::planes(walk, width, TOP);
    out += &joint_strips::strips(walk, width, strips_top);
    out + &table + "</svg>\n"
}

fn width(contacts: usize) -> f64 {
    if contacts <= 2 { 760.0 } else { 900.0 }
}

/// What lines and dots mean.
fn key() -> String {
    let stroke = |class: &str, x: f64| line(class, [x, 20.0], [x + 30.0, 20.0]);
    let x = LEFT - 44.0;
    stroke("walk key", x)
        + &text("small", [x + 37.0, 24.0], "start", "compression")
        + &stroke("walk restitution key", x + 122.0)
        + &text("small", [x + 159.0, 24.0], "start", "restitution")
        + &format!(
            "<rect class=\"cone\" x=\"{0}\" y=\"13\" width=\"30\" height=\"14\"/><path class=\"cone-edge\" d=\"M{0} 13h30M{0} 27h30\"/>\n",
            px(x + 236.0)
        )
        + &text("small", [x + 273.0, 24.0], "start", "friction cone")
        + &text(
            "small",
            [x + 358.0, 24.0],
            "start",
            "all contacts are walked at once: stage k ends at every dot k",
        )
}

/// The stages in words, and where the table ends.
fn table(walk: &JointWalk, top: f64) -> (String, f64) {
    let left = LEFT - 44.0;
    let first = left + NUMBERS + PHASE + UNTIL;
    let room = ((width(walk.contacts.len()) - RIGHT - first) / walk.contacts.len() as f64).min(WIDEST);
    let mut y = top + 16.0;
    let column = |i: usize| first + room * i as f64;
    let mut out = text("head", [left + NUMBERS, y], "start", "stage");
    out += &text("head", [left + NUMBERS + PHASE, y], "start", "until");
    for (i, contact) in walk.contacts.iter().enumerate() {
        out += &text(&format!("contact k{}", i % 6), [column(i), y], "start", &contact.name);
    }
    y += 6.0;
    out += &line("axis", [left, y], [width(walk.contacts.len()) - RIGHT, y]);
    let count = walk.stages.len();
    let left_out = if count > MOST_LINES { MOST_LINES - LAST_LINES..count - LAST_LINES } else { 0..0 };
    let mut phase_before = None;
    for (k, stage) in walk.stages.iter().enumerate() {
        if left_out.contains(&k) {
            if k == left_out.start {
                y += LINE;
                let more = format!("… {} stages", left_out.len());
                out += &text("small", [left + NUMBERS + PHASE, y], "start", &more);
            }
            continue;
        }
        y += LINE;
        out += &text("stage", [left + NUMBERS - 8.0, y], "end", &(k + 1).to_string());
        if phase_before != Some(stage.phase) {
            let word = if stage.phase == Phase::Compression { "compression" } else { "restitution" };
            out += &text("cell", [left + NUMBERS, y], "start", word);
            phase_before = Some(stage.phase);
        }
        out += &text("cell", [left + NUMBERS + PHASE, y], "start", &walk.end_words(stage.ended_by));
        for (i, piece) in stage.pieces.iter().enumerate() {
            out += &text("cell", [column(i), y], "start", slip_words(piece.slip));
        }
    }
    (out, y + 14.0)
}

pub(crate) fn line(class: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> String {
    format!(
        "<line class=\"{class}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n",
        px(x1),
        px(y1),
        px(x2),
        px(y2)
    )
}

/// A dot in the colour of contact i.
pub(crate) fn dotted(i: usize, [x, y]: [f64; 2]) -> String {
    format!("<circle class=\"k{}\" cx=\"{}\" cy=\"{}\" r=\"3.2\"/>\n", i % 6, px(x), px(y))
}

pub(crate) fn text(class: &str, [x, y]: [f64; 2], anchor: &str, words: &str) -> String {
    let small =
        |c: &str| format!("<tspan dy=\"3\" font-size=\"78%\">{c}</tspan><tspan dy=\"-3\">\u{200b}</tspan>");
    let words = escape(words).replace('\u{209c}', &small("t")).replace('\u{2099}', &small("n"));
    format!(
        "<text class=\"{class}\" x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{words}</text>\n",
        px(x),
        px(y)
    )
}

/// What the style of every drawing lacks for this one.
pub(crate) const JOINT_CSS: &str = include_str!("joint.css");
