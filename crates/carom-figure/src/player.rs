//! The animation: the scene as SVG, the motion as numbers, and a small player.

use crate::draft::Draft;
use crate::mechanism::{has_motion, obstacles_svg, path_svg, view_of};
use crate::motion::{instants, own_each, refined};
use crate::outline::outline_at_rest;
use crate::text::px;
use crate::view::View;

use carom_feeder::{Feeder, Run, Stage};
use carom_motion::planar::trace::{Piece, Sample};

const WIDTH: f64 = 500.0;
const HEIGHT: f64 = 560.0;
/// Paper around the scene, for the marks at its border.
const FRAME: f64 = 14.0;
/// Pixels of an arrow for a force of the part's weight, and the longest arrow.
const ARROW: (f64, f64) = (34.0, 120.0);
/// Samples that the player keeps.
pub(crate) const MOST_SAMPLES: usize = 6000;

pub(crate) const SCRIPT: &str = include_str!("player.js");

/// The section with the animation; empty where nothing moved.
pub(crate) fn section(feeder: &Feeder, run: &Run, draft: &Draft) -> String {
    if !has_motion(run) || run.stages.is_empty() {
        return String::new();
    }
    let view = view_of(feeder, &[run], WIDTH, HEIGHT);
    let part = outline_at_rest(feeder, draft, &view);
    let mut out = String::from(
        "<section id=\"motion\"><h2>Motion</h2><div id=\"player\" class=\"player\" tabindex=\"0\" role=\"group\" aria-label=\"Animation of the part\">",
    );
    out += &format!(
        "<svg class=\"fig scene\" viewBox=\"{} {0} {} {}\" role=\"img\" aria-label=\"The part on its way\">{}{}<g id=\"forces\"></g><g id=\"part\">{}<circle class=\"centre\" r=\"2.6\"/></g></svg>",
        px(-FRAME),
        px(view.width() + 2.0 * FRAME),
        px(view.height() + 2.0 * FRAME),
        obstacles_svg(feeder, &view),
        path_svg(run, &view),
        part.svg()
    );
    out += CONTROLS;
    out += "</div><noscript><p class=\"note\">The animation needs JavaScript; the layout above shows the same motion.</p></noscript>";
    out += &format!(
        "<script type=\"application/json\" id=\"motion-numbers\">{}</script>",
        numbers(feeder, run, &view)
    );
    out + "</section>"
}

pub(crate) const CONTROLS: &str = "<p class=\"readout\"><output id=\"clock\" for=\"scrub\">0.0000 s</output><span id=\"stage\" aria-live=\"polite\"></span></p><div class=\"ribbon\" id=\"ribbon\" aria-hidden=\"true\"></div>\
<input type=\"range\" id=\"scrub\" min=\"0\" max=\"1000\" value=\"0\" step=\"1\" aria-label=\"Time\">\
<div class=\"controls\"><button type=\"button\" id=\"back\" title=\"Event before (comma)\">‹ event</button>\
<button type=\"button\" id=\"play\" title=\"Play or pause (space)\">Play</button>\
<button type=\"button\" id=\"next\" title=\"Next event (full stop)\">event ›</button>\
<label>speed <select id=\"speed\"><option value=\"0.01\">1/100</option><option value=\"0.02\">1/50</option><option value=\"0.05\">1/20</option>\
<option value=\"0.1\">1/10</option><option value=\"0.2\" selected>1/5</option><option value=\"0.5\">1/2</option><option value=\"1\">real time</option></select></label>\
<label><input type=\"checkbox\" id=\"arrows\" checked> forces</label>\
</div>\
<p class=\"note keys\">Space plays and pauses, ← → move by a frame (with shift by ten), comma and full stop step from event to event, Home and End go to the ends.</p>";

/// The motion as JSON, in the scene's pixels and degrees (clockwise, as SVG turns).
fn numbers(feeder: &Feeder, run: &Run, view: &View) -> String {
    let weight = feeder.part.body.mass * feeder.gravity;
    let samples = all_samples(&run.trace.pieces, MOST_SAMPLES, view, weight);
    let stages: Vec<String> = run.stages.iter().filter_map(|s| stage_numbers(feeder, s)).collect();
    let impacts = run.trace.impacts.iter().filter(|i| i.time.is_finite()).take(1000);
    let strikes: Vec<String> = impacts.map(|i| format!("{}", i.time)).collect();
    format!(
        "{{\"samples\":[{samples}],\"stages\":[{}],\"strikes\":[{}]}}",
        stages.join(","),
        strikes.join(",")
    )
}

/// The samples of all pieces as JSON, with commas between; `most` of them where each piece can do with its share, or two of each.
///
/// They are the run's own, which the player joins by cubics; more only where forces need them.
pub(crate) fn all_samples(pieces: &[Piece], most: usize, view: &View, weight: f64) -> String {
    let each = own_each(pieces, most, most);
    let mut out = String::new();
    for piece in pieces {
        let few = instants(piece).count() <= each;
        let samples: &mut dyn Iterator<Item = Sample> =
            if few { &mut instants(piece).map(|at| at.sample()) } else { &mut refined(piece, each) };
        for sample in samples {
            if !out.is_empty() {
                out.push(',');
            }
            out += &sample_numbers(&sample, view, weight);
        }
    }
    out
}

fn number(x: f64) -> String {
    px(x)
}

fn sample_numbers(s: &Sample, view: &View, weight: f64) -> String {
    let (at, v) = (view.at(s.state.pose.centre), view.along(s.state.twist.velocity));
    let contacts: Vec<String> = s
        .contacts
        .iter()
        .filter(|c| c.point.is_finite() && c.normal.is_finite() && weight > 0.0)
        .map(|c| {
            let force = c.normal * c.normal_force + c.normal.turned_right() * c.tangential_force;
            let long = force * (ARROW.0 / weight);
            let shown = if long.norm() > ARROW.1 { long * (ARROW.1 / long.norm()) } else { long };
            let p = view.at(c.point);
            format!("[{},{},{},{}]", number(p.x), number(p.y), number(shown.x), number(-shown.y))
        })
        .collect();
    format!(
        "[{},{},{},{},{},{},{},[{}]]",
        s.time,
        number(at.x),
        number(at.y),
        number(-s.state.pose.angle.to_degrees()),
        number(v.x),
        number(v.y),
        number(-s.state.twist.spin.to_degrees()),
        contacts.join(",")
    )
}

fn stage_numbers(feeder: &Feeder, s: &Stage) -> Option<String> {
    if !(s.start_time.is_finite() && s.end_time.is_finite()) {
        return None;
    }
    let on = s.obstacle.map(|o| feeder.obstacle_label(o)).unwrap_or_default();
    Some(format!("[{},{},{},{}]", json_text(s.name.word()), json_text(&on), s.start_time, s.end_time))
}

/// A JSON string that is safe inside a script element.
pub(crate) fn json_text(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => {
                out.push('\\');
                out.push(c);
            }
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => out += &format!("\\u{:04x}", u32::from(c)),
            c if c.is_control() => {}
            c => out.push(c),
        }
    }
    out + "\""
}

/// The player's script element.
pub(crate) fn script() -> String {
    format!("<script>{SCRIPT}</script>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_cannot_close_the_script_element() {
        assert_eq!(json_text("a</script>\"\\"), "\"a\\u003c/script\\u003e\\\"\\\\\"", "escaped");
    }

    #[test]
    fn the_script_stays_inside_its_element() {
        assert!(!SCRIPT.contains("</script"), "the element would end early");
        assert!(!SCRIPT.contains("http"), "nothing from the network");
    }
}
