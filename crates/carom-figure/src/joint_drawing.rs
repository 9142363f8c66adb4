//! One picture of an impact at several contacts: their impulse planes side by side, their velocities over one clock, and the stages.

use crate::FIGURE_CSS;
use crate::joint::JointWalk;
use crate::markup::{Markup, document, html, joined};
use crate::svg::{self, line, text};
use crate::text::px;
use crate::{joint_planes, joint_strips};
use carom_impact::Phase;
use carom_words::{
    Words,
    impact::{brief_slip, stage_end},
};

/// Margins of panels and strips [px].
pub(crate) const LEFT: f64 = 66.0;
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
/// # use carom_impact::{Law, planar::{ContactSet2, Touch, staged}};
/// # use carom_num::Vec2;
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
    joint_drawing(walk, true).map(document).unwrap_or_default()
}

/// The drawing, with its style inside where it stands alone.
pub(crate) fn joint_drawing(walk: &JointWalk, alone: bool) -> Option<Markup> {
    if !walk.can_be_drawn() {
        return None;
    }
    let width = width(walk.contacts.len());
    let strips_top = TOP + joint_planes::height(walk.contacts.len());
    let table_top = strips_top + joint_strips::HEIGHT;
    let (table, bottom) = table(walk, table_top);
    let inside = html! {
        @if alone { (svg::styled([width, bottom], &[FIGURE_CSS, JOINT_CSS])) }
        (key())
        (joint_planes::planes(walk, width, TOP))
        (joint_strips::strips(walk, width, strips_top))
        (table)
    };
    let label = format!("The walk of {} contacts through an impact, stage by stage", walk.contacts.len());
    Some(svg::drawing("fig joint", [width, bottom], &label, inside))
}

/// Where the contacts are in panels and on strips, at the start and at the end of each stage; each with the number of its contact.
pub(crate) fn joint_tracks(walk: &JointWalk) -> Vec<(usize, Vec<[f64; 2]>)> {
    let (contacts, width) = (walk.contacts.len(), width(walk.contacts.len()));
    let mut tracks: Vec<_> = joint_planes::tracks(walk, width, TOP).into_iter().enumerate().collect();
    tracks.extend(joint_strips::tracks(walk, width, TOP + joint_planes::height(contacts)));
    tracks
}

fn width(contacts: usize) -> f64 {
    if contacts <= 2 { 760.0 } else { 900.0 }
}

/// What lines and dots mean.
fn key() -> Markup {
    let stroke = |class: &str, x: f64| line(class, [x, 20.0], [x + 30.0, 20.0]);
    let words = |x: f64, words: &str| text("small", [x, 24.0], "start", words);
    let x = LEFT - 54.0;
    html! {
        (stroke("walk key", x))
        (words(x + 37.0, Phase::Compression.word()))
        (stroke("walk restitution key", x + 122.0))
        (words(x + 159.0, Phase::Restitution.word()))
        (svg::rect("cone", [x + 236.0, 13.0], [30.0, 14.0]))
        path.cone-edge d=(format!("M{0} 13h30M{0} 27h30", px(x + 236.0))) {}
        (words(x + 273.0, "friction cone"))
        (words(x + 358.0, "all contacts are walked at once: stage k ends at every dot k"))
    }
}

/// The stages in words, and where the table ends.
fn table(walk: &JointWalk, top: f64) -> (Markup, f64) {
    let left = LEFT - 54.0;
    let first = left + NUMBERS + PHASE + UNTIL;
    let room = ((width(walk.contacts.len()) - RIGHT - first) / walk.contacts.len() as f64).min(WIDEST);
    let mut y = top + 16.0;
    let column = |i: usize| first + room * i as f64;
    let mut out = vec![text("head", [left + NUMBERS, y], "start", "stage")];
    out.push(text("head", [left + NUMBERS + PHASE, y], "start", "until"));
    for (i, contact) in walk.contacts.iter().enumerate() {
        out.push(text(&format!("contact k{}", i % 6), [column(i), y], "start", &contact.name));
    }
    y += 6.0;
    out.push(line("axis", [left, y], [width(walk.contacts.len()) - RIGHT, y]));
    let count = walk.stages.len();
    let left_out = if count > MOST_LINES { MOST_LINES - LAST_LINES..count - LAST_LINES } else { 0..0 };
    let names: Vec<&str> = walk.contacts.iter().map(|c| c.name.as_str()).collect();
    let mut phase_before = None;
    for (k, stage) in walk.stages.iter().enumerate() {
        if left_out.contains(&k) {
            if k == left_out.start {
                y += LINE;
                let more = format!("… {} stages", left_out.len());
                out.push(text("small", [left + NUMBERS + PHASE, y], "start", &more));
            }
            continue;
        }
        y += LINE;
        out.push(text("stage", [left + NUMBERS - 8.0, y], "end", &(k + 1).to_string()));
        if phase_before != Some(stage.phase) {
            out.push(text("cell", [left + NUMBERS, y], "start", stage.phase.word()));
            phase_before = Some(stage.phase);
        }
        out.push(text("cell", [left + NUMBERS + PHASE, y], "start", &stage_end(&names, stage.ended_by)));
        for (i, piece) in stage.pieces.iter().enumerate() {
            out.push(text("cell", [column(i), y], "start", brief_slip(piece.slip)));
        }
    }
    (joined(out), y + 14.0)
}

/// A dot in the colour of contact i.
pub(crate) fn dotted(i: usize, at: [f64; 2]) -> Markup {
    svg::circle(&format!("k{}", i % 6), at, 3.2)
}

/// What the style of every drawing lacks for this one.
pub(crate) const JOINT_CSS: &str = include_str!("joint.css");
