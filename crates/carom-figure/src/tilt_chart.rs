//! The tilt against time, with strikes and closed series marked.

use crate::markup::{Markup, html, joined};
use crate::solid::{SolidFigure, SolidStrike};
use crate::text::{fixed, px};
use crate::ticks::{ticks, widened};

const WIDTH: f64 = 1000.0;
const HEIGHT: f64 = 290.0;
const LEFT: f64 = 56.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 36.0;
const BOTTOM: f64 = 42.0;
/// Points of the line.
const MOST_POINTS: usize = 2000;
/// Marks of strikes closer than this are one [px].
const CLOSE: f64 = 0.7;
/// A number stands beside a mark where the one before is this far [px].
const ROOM: f64 = 16.0;

/// Where values stand in the picture.
struct Scale {
    time: (f64, f64),
    degrees: (f64, f64),
}

impl Scale {
    fn x(&self, time: f64) -> f64 {
        LEFT + (time - self.time.0) / (self.time.1 - self.time.0) * (WIDTH - LEFT - RIGHT)
    }

    fn y(&self, degrees: f64) -> f64 {
        let share = (degrees - self.degrees.0) / (self.degrees.1 - self.degrees.0);
        HEIGHT - BOTTOM - share * (HEIGHT - TOP - BOTTOM)
    }
}

/// The section; empty where nothing moves.
pub(crate) fn section(figure: &SolidFigure<'_>) -> Markup {
    section_of(
        figure,
        "The angle from flat of the face that is nearest to the plane. Red: strikes, by their numbers.",
    )
}

/// The same with other words on what the tilt is.
pub(crate) fn section_of(figure: &SolidFigure<'_>, what: &str) -> Markup {
    let (Some(first), Some(last)) = (figure.instants.first(), figure.instants.last()) else {
        return html! {};
    };
    // A limit may lie after the last instant.
    let end = figure.series.iter().map(|s| s.to).fold(last.time, f64::max);
    if end <= first.time {
        return html! {};
    }
    let highest = figure.instants.iter().map(|i| i.tilt.to_degrees()).fold(0.0, f64::max);
    let scale = Scale { time: (first.time, end), degrees: widened(0.0, highest, 4) };
    html! {
        section id="tilt" {
            h2 { "Tilt against time" }
            figure {
                div.wide tabindex="0" { (chart(figure, &scale)) }
                figcaption {
                    (what)
                    @if !figure.series.is_empty() {
                        " Shaded: infinitely many strikes, closed at their limit."
                    }
                    " A click moves the animation there."
                }
            }
        }
    }
}

fn chart(figure: &SolidFigure<'_>, scale: &Scale) -> Markup {
    html! {
        svg.fig.tilt viewBox={ "0 0 " (WIDTH) " " (HEIGHT) } role="img" aria-label="Tilt against time"
            data-x0=(scale.time.0) data-x1=(scale.time.1) data-left=(LEFT) data-right=(WIDTH - RIGHT) {
            (bands(figure, scale))
            (axes(scale))
            (marks(figure.strikes, scale))
            (line(figure, scale))
            text.name x=(LEFT) y="14" { "tilt" }
            text.unit x=(LEFT + 28.0) y="14" { "[°]" }
            line.now x1="0" x2="0" y1=(TOP) y2=(HEIGHT - BOTTOM) visibility="hidden" {}
        }
    }
}

fn bands(figure: &SolidFigure<'_>, scale: &Scale) -> Markup {
    let band = |from: f64, to: f64| {
        let (x, end) = (scale.x(from), scale.x(to));
        html! {
            rect.series-band x=(px(x)) y=(TOP) width=(px((end - x).max(1.0))) height=(HEIGHT - TOP - BOTTOM) {}
        }
    };
    joined(figure.series.iter().filter(|s| s.to.is_finite()).map(|s| band(s.from, s.to)))
}

fn axes(scale: &Scale) -> Markup {
    let (mut out, base) = (vec![], HEIGHT - BOTTOM);
    let degrees = ticks(scale.degrees.0, scale.degrees.1, 4);
    for v in &degrees.at {
        let y = scale.y(*v);
        let class = if *v == 0.0 { "zero" } else { "grid" };
        out.push(html! {
            line class=(class) x1=(LEFT) x2=(WIDTH - RIGHT) y1=(px(y)) y2=(px(y)) {}
            text.tick x=(LEFT - 7.0) y=(px(y + 3.8)) text-anchor="end" { (fixed(*v, degrees.decimals)) }
        });
    }
    let times = ticks(scale.time.0, scale.time.1, 10);
    for v in &times.at {
        let x = scale.x(*v);
        out.push(html! {
            line.axis x1=(px(x)) x2=(px(x)) y1=(base) y2=(base + 4.0) {}
            text.tick x=(px(x)) y=(base + 17.0) text-anchor="middle" { (fixed(*v, times.decimals)) }
        });
    }
    out.push(html! { text.unit x=(WIDTH - RIGHT) y=(HEIGHT - 6.0) text-anchor="end" { "time [s]" } });
    joined(out)
}

/// A mark at each strike; where they crowd, one for many.
fn marks(strikes: &[SolidStrike], scale: &Scale) -> Markup {
    let (mut out, mut last, mut numbered) = (vec![], f64::NEG_INFINITY, f64::NEG_INFINITY);
    for (i, strike) in strikes.iter().enumerate().filter(|(_, s)| s.time.is_finite()) {
        let x = scale.x(strike.time);
        if x - last < CLOSE {
            continue;
        }
        last = x;
        out.push(html! { line.struck x1=(px(x)) x2=(px(x)) y1=(TOP) y2=(HEIGHT - BOTTOM) {} });
        if x - numbered >= ROOM {
            numbered = x;
            out.push(html! { text.struck x=(px(x)) y=(TOP - 4.0) text-anchor="middle" { (i + 1) } });
        }
    }
    joined(out)
}

fn line(figure: &SolidFigure<'_>, scale: &Scale) -> Markup {
    let every = figure.instants.len().div_ceil(MOST_POINTS).max(1);
    let final_one = figure.instants.len().saturating_sub(1);
    let kept = figure.instants.iter().enumerate().filter(|(i, _)| i % every == 0 || *i == final_one);
    let points: Vec<String> = kept
        .filter(|(_, instant)| instant.time.is_finite() && instant.tilt.is_finite())
        .map(|(_, instant)| {
            format!("{},{}", px(scale.x(instant.time)), px(scale.y(instant.tilt.to_degrees())))
        })
        .collect();
    html! { polyline.series.s0 points=(points.join(" ")) {} }
}
