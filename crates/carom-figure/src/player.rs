//! The animation: the scene as SVG, the motion as numbers, and a small player.

use crate::draft::Draft;
use crate::markup::{Markup, PreEscaped, html};
use crate::mechanism::{has_motion, obstacles_svg, path_svg, view_of};
use crate::motion::{instants, own_each, refined};
use crate::outline::outline_at_rest;
use crate::text::px;
use crate::view::View;

use carom_feeder::{Feeder, Run, Stage};
use carom_motion::planar::trace::{Piece, Sample};
use carom_words::{Words, part};

const WIDTH: f64 = 500.0;
const HEIGHT: f64 = 560.0;
/// Paper around the scene, for the marks at its border.
const FRAME: f64 = 14.0;
/// Pixels of an arrow for a force of the part's weight, and the longest arrow.
const ARROW: (f64, f64) = (34.0, 120.0);
/// Samples that the player keeps.
pub(crate) const MOST_SAMPLES: usize = 6000;

/// The player, and what starts it on a page of its own.
pub(crate) const SCRIPT: &str = concat!(
    include_str!("player.js"),
    "player(document).load(JSON.parse(document.getElementById(\"motion-numbers\").textContent));\n"
);

/// The section with the animation; empty where nothing moved.
pub(crate) fn section(feeder: &Feeder, run: &Run, draft: &Draft) -> Option<Markup> {
    if !has_motion(run) || run.stages.is_empty() {
        return None;
    }
    let view = view_of(feeder, &[run], WIDTH, HEIGHT);
    let scene = html! {
        svg.fig.scene viewBox=(view.framed(FRAME)) role="img" aria-label="The part on its way" {
            (scene(feeder, run, draft, &view))
        }
    };
    Some(html! {
        section id="motion" {
            h2 { "Motion" }
            div id="player" class="player" tabindex="0" role="group" aria-label="Animation of the part" {
                (scene)
                (controls(SPEED))
            }
            noscript { p.note { "The animation needs JavaScript; the layout above shows the same motion." } }
            (numbers_element("motion-numbers", numbers(feeder, run, &view)))
        }
    })
}

/// What moves, and what it moves among.
pub(crate) fn scene(feeder: &Feeder, run: &Run, draft: &Draft, view: &View) -> Markup {
    let part = outline_at_rest(feeder, draft, view);
    html! {
        (obstacles_svg(feeder, view))
        (path_svg(run, view))
        g id="forces" {}
        g id="part" { (part.svg()) circle.centre r="2.6" {} }
    }
}

/// The speeds of a motion in the plane, and the one at which it is played first.
const SPEEDS: [(f64, &str); 7] = [
    (0.01, "1/100"),
    (0.02, "1/50"),
    (0.05, "1/20"),
    (0.1, "1/10"),
    (0.2, "1/5"),
    (0.5, "1/2"),
    (1.0, "real time"),
];
pub(crate) const SPEED: f64 = 0.2;

/// What is under an animation: its clock, its ribbon of stages and its buttons.
pub(crate) struct Controls<'a> {
    /// What the clock shows at first.
    pub(crate) clock: &'a str,
    /// Speeds, as shares of real time, with their names.
    pub(crate) speeds: &'a [(f64, &'a str)],
    /// The speed at which it is played first.
    pub(crate) speed: f64,
    /// A box to tick: its name for the script, and for the reader.
    pub(crate) shown: [&'a str; 2],
    /// More on its keys.
    pub(crate) keys: &'a str,
}

impl Controls<'_> {
    pub(crate) fn html(&self) -> Markup {
        html! {
            p.readout { output id="clock" for="scrub" { (self.clock) } span id="stage" aria-live="polite" {} }
            div.ribbon id="ribbon" aria-hidden="true" {}
            input type="range" id="scrub" min="0" max="1000" value="0" step="1" aria-label="Time";
            div.controls {
                button type="button" id="back" title="Event before (comma)" { "‹ event" }
                button type="button" id="play" title="Play or pause (space)" { "Play" }
                button type="button" id="next" title="Next event (full stop)" { "event ›" }
                label {
                    "speed "
                    select id="speed" {
                        @for (speed, name) in self.speeds {
                            option value=(speed) selected[*speed == self.speed] { (name) }
                        }
                    }
                }
                label { input type="checkbox" id=(self.shown[0]) checked; " " (self.shown[1]) }
            }
            p.note.keys {
                "Space plays and pauses, ← → move by a frame (with shift by ten), comma and full stop step from event to event, Home and End go to the ends."
                (self.keys)
            }
        }
    }
}

/// The controls of a motion in the plane that is played at this speed at first.
pub(crate) fn controls(speed: f64) -> Markup {
    let (clock, shown) = ("0.0000 s", ["arrows", "forces"]);
    Controls { clock, speeds: &SPEEDS, speed, shown, keys: "" }.html()
}

/// Numbers for a script: JSON whose texts went through [`json_text`].
pub(crate) fn numbers_element(id: &str, json: String) -> Markup {
    html! { script type="application/json" id=(id) { (PreEscaped(json)) } }
}

/// The motion as JSON, in the scene's pixels and degrees (clockwise, as SVG turns).
pub(crate) fn numbers(feeder: &Feeder, run: &Run, view: &View) -> String {
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

/// A part that stands where it starts, as the motion of one instant.
pub(crate) fn standing(feeder: &Feeder, view: &View) -> String {
    let sample = Sample { time: 0.0, state: feeder.start_state(), contacts: vec![] };
    format!("{{\"samples\":[{}],\"stages\":[],\"strikes\":[]}}", sample_numbers(&sample, view, 0.0))
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
    let on = s.obstacle.map(|o| part::obstacle(feeder, o)).unwrap_or_default();
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
