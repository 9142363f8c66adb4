//! The animation of a body in space: its motion as numbers, and a player whose view can be turned.

use crate::markup::{Markup, html};
use crate::player::{Controls, json_text, numbers_element};
use crate::solid::{SolidFigure, SolidInstant, SolidPlate};
use carom_num::Vec3;

/// Instants that the player keeps.
const MOST_SAMPLES: usize = 2000;
/// Stages and strikes that it names.
const MOST_EVENTS: usize = 1000;
/// Digits after the point: places are in units of the body's size, attitudes are quaternions.
const DECIMALS: usize = 5;
/// How long a run is played where no speed is chosen \[s\].
const LENGTH: f64 = 6.0;
const SPEEDS: [(f64, &str); 9] = [
    (0.001, "1/1000"),
    (0.005, "1/200"),
    (0.01, "1/100"),
    (0.02, "1/50"),
    (0.05, "1/20"),
    (0.1, "1/10"),
    (0.2, "1/5"),
    (0.5, "1/2"),
    (1.0, "real time"),
];

/// The player, and what starts it on a page of its own.
pub(crate) const SCRIPT: &str = concat!(
    include_str!("solid_camera.js"),
    include_str!("solid_plates.js"),
    include_str!("solid_view.js"),
    include_str!("solid.js"),
    "const numbers = document.getElementById(\"solid-numbers\");\n",
    "if (numbers) solidPlayer(document, JSON.parse(numbers.textContent));\n"
);

/// How long the motion lasts; `None` where there is no instant.
fn span(figure: &SolidFigure<'_>) -> Option<f64> {
    Some(figure.instants.last()?.time - figure.instants.first()?.time)
}

/// The section with the picture; it plays where something moves.
pub(crate) fn section(figure: &SolidFigure<'_>) -> Markup {
    let Some(span) = span(figure) else { return html! {} };
    html! {
        section id="motion" class=[(!figure.around.is_empty()).then_some("among")] {
            h2 { @if span > 0.0 { "Motion" } @else { "Picture" } }
            (player(figure))
            noscript { p.note { "The animation needs JavaScript; the chart below shows the same motion." } }
            (numbers_element("solid-numbers", numbers(figure)))
        }
    }
}

/// The canvas with what plays it; empty where there is no instant.
pub(crate) fn player(figure: &SolidFigure<'_>) -> Markup {
    let Some(span) = span(figure) else { return html! {} };
    let among = !figure.around.is_empty();
    let shown = if among { "The part among its plates." } else { "The body on its plane." };
    html! {
        div id="player" class="player solid" tabindex="0" role="group" aria-label="Animation of the body" {
            canvas id="solid" tabindex="0" role="application"
                aria-label={ (shown) " Arrow keys turn the view, plus and minus bring it nearer, zero puts it back." } {}
            (states(figure.around))
            @if span > 0.0 { (controls(span)) }
        }
    }
}

/// What the colours of the points say, what a cut plate looks like, and how the view is turned.
fn states(around: &[SolidPlate]) -> Markup {
    let is_cut = around.iter().any(|plate| plate.cut.contains(&true));
    html! {
        p.states {
            span { i.held {} "held" }
            span { i.struck {} "strikes" }
            @if around.is_empty() { span { i.free {} "free" } }
            @if is_cut { span { i.cut {} "the plate goes on: the picture cuts it" } }
            span.turns {
                "Drag to turn; wheel with Ctrl, or + and −, to come nearer; double click to put it back."
            }
        }
    }
}

fn controls(span: f64) -> Markup {
    let wanted = span / LENGTH;
    let off = |speed: f64| if speed > wanted { speed / wanted } else { wanted / speed };
    let nearest = SPEEDS.iter().map(|(speed, _)| *speed).min_by(|a, b| off(*a).total_cmp(&off(*b)));
    let (clock, shown, speed) = ("0.00000 s", ["names", "names"], nearest.unwrap_or(1.0));
    let keys = " In the picture itself the arrow keys turn it.";
    Controls { clock, speeds: &SPEEDS, speed, shown, keys }.html()
}

/// Body and motion as JSON, in units of the body's size.
pub(crate) fn numbers(figure: &SolidFigure<'_>) -> String {
    let drawing = &figure.drawing;
    let size = drawing.corners.iter().map(|r| r.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let places = |points: &[Vec3]| places(points, size);
    let faces: Vec<String> = drawing.faces.iter().map(|face| format!("{face:?}")).collect();
    let names: Vec<String> = drawing.names.iter().map(|name| json_text(name)).collect();
    let samples: Vec<String> = kept(figure.instants).map(|instant| sample(instant, size)).collect();
    let stages = figure.stages.iter().filter(|s| s.start.is_finite() && s.end.is_finite()).take(MOST_EVENTS);
    let stages: Vec<String> = stages
        .map(|s| format!("[{},{},{},{}]", json_text(s.name), json_text(&s.on), s.start, s.end))
        .collect();
    let strikes = figure.strikes.iter().filter(|s| s.time.is_finite()).take(MOST_EVENTS);
    let strikes: Vec<String> = strikes
        .map(|s| {
            // By name: a strike that has no way on has no contacts to list.
            let struck = s.struck.split(", ");
            let points = struck.filter_map(|struck| drawing.names.iter().position(|name| name == struck));
            format!("[{},{:?}{}]", s.time, points.collect::<Vec<_>>(), more(&s.places, size))
        })
        .collect();
    let own = drawing.numbers.filter(|numbers| !numbers.iter().copied().eq(0..faces.len()));
    let numbers = own.map(|numbers| format!("\"numbers\":{numbers:?},")).unwrap_or_default();
    let seams = match drawing.seams {
        [] => String::new(),
        seams => format!("\"seams\":{seams:?},"),
    };
    format!(
        "{{\"corners\":[{}],\"faces\":[{}],{numbers}{seams}\"lines\":{:?},\"points\":[{}],\"names\":[{}],\"samples\":[{}],\"stages\":[{}],\"strikes\":[{}]{}}}",
        places(drawing.corners),
        faces.join(","),
        drawing.lines,
        places(drawing.points),
        names.join(","),
        samples.join(","),
        stages.join(","),
        strikes.join(","),
        plates(figure.around, size)
    )
}

/// The plates, where there are any: each with its name, its corners, and which of its sides are cut.
fn plates(around: &[SolidPlate], size: f64) -> String {
    if around.is_empty() {
        return String::new();
    }
    let finite = around.iter().filter(|plate| plate.corners.iter().all(|corner| corner.is_finite()));
    let of = |plate: &SolidPlate| {
        format!("[{},[{}],{:?}]", json_text(&plate.name), places(&plate.corners, size), plate.cut)
    };
    format!(",\"plates\":[{}]", finite.map(of).collect::<Vec<_>>().join(","))
}

fn places(points: &[Vec3], size: f64) -> String {
    points.iter().map(|r| list(&(*r / size).to_array())).collect::<Vec<_>>().join(",")
}

/// Places at the end of a list, where there are any.
fn more(points: &[Vec3], size: f64) -> String {
    if points.is_empty() { String::new() } else { format!(",[{}]", places(points, size)) }
}

/// Few instants of many: but every one at which what is held changes.
fn kept(instants: &[SolidInstant]) -> impl Iterator<Item = &SolidInstant> {
    let every = instants.len().div_ceil(MOST_SAMPLES).max(1);
    let last = instants.len().saturating_sub(1);
    instants.iter().enumerate().filter_map(move |(i, instant)| {
        let differs = |j: usize| instants.get(j).is_some_and(|other| other.held != instant.held);
        let changes = differs(i + 1) || i > 0 && differs(i - 1);
        let finite = instant.time.is_finite() && instant.centre.is_finite();
        (finite && (changes || i % every == 0 || i == last)).then_some(instant)
    })
}

fn sample(instant: &SolidInstant, size: f64) -> String {
    format!(
        "[{},{},{},{:?}{}]",
        instant.time,
        numbers_of(&(instant.centre / size).to_array()),
        numbers_of(&instant.attitude.to_array()),
        instant.held,
        more(&instant.places, size)
    )
}

fn list(numbers: &[f64]) -> String {
    format!("[{}]", numbers_of(numbers))
}

fn numbers_of(numbers: &[f64]) -> String {
    let of = |x: &f64| if x.is_finite() { format!("{x:.DECIMALS$}") } else { "0".to_owned() };
    numbers.iter().map(of).collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_script_stays_inside_its_element() {
        assert!(!SCRIPT.contains("</script"), "the element would end early");
        assert!(!SCRIPT.contains("http"), "nothing from the network");
    }

    #[test]
    fn a_speed_is_chosen_by_the_length_of_the_run() {
        assert!(controls(0.6).into_string().contains("value=\"0.1\" selected"), "a tenth: six seconds");
        assert!(controls(60.0).into_string().contains("value=\"1\" selected"), "never faster than real");
    }
}
