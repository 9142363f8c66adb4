//! The tilt against time, with strikes and closed series marked.

use crate::solid::{SolidFigure, SolidStrike};
use crate::text::{escape, fixed, px};
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
pub(crate) fn section(figure: &SolidFigure<'_>) -> String {
    let (Some(first), Some(last)) = (figure.instants.first(), figure.instants.last()) else {
        return String::new();
    };
    // A limit may lie after the last instant.
    let end = figure.series.iter().map(|s| s.to).fold(last.time, f64::max);
    if end <= first.time {
        return String::new();
    }
    let highest = figure.instants.iter().map(|i| i.tilt.to_degrees()).fold(0.0, f64::max);
    let scale = Scale { time: (first.time, end), degrees: widened(0.0, highest, 4) };
    let mut out = format!(
        "<svg class=\"fig tilt\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" aria-label=\"Tilt against time\" data-x0=\"{}\" data-x1=\"{}\" data-left=\"{LEFT}\" data-right=\"{}\">",
        first.time,
        end,
        WIDTH - RIGHT
    );
    out += &bands(figure, &scale);
    out += &axes(&scale);
    out += &marks(figure.strikes, &scale);
    out += &line(figure, &scale);
    out += &format!(
        "<text class=\"name\" x=\"{LEFT}\" y=\"14\">tilt</text><text class=\"unit\" x=\"{}\" y=\"14\">[°]</text><line class=\"now\" x1=\"0\" x2=\"0\" y1=\"{TOP}\" y2=\"{}\" visibility=\"hidden\"/></svg>",
        LEFT + 28.0,
        HEIGHT - BOTTOM
    );
    let series = if figure.series.is_empty() {
        ""
    } else {
        " Shaded: infinitely many strikes, closed at their limit."
    };
    format!(
        "<section id=\"tilt\"><h2>Tilt against time</h2><figure><div class=\"wide\">{out}</div><figcaption>The angle from flat of the face that is nearest to the plane. Red: strikes, by their numbers.{series} A click moves the animation there.</figcaption></figure></section>"
    )
}

fn bands(figure: &SolidFigure<'_>, scale: &Scale) -> String {
    let band = |from: f64, to: f64| {
        let (x, end) = (scale.x(from), scale.x(to));
        format!(
            "<rect class=\"series-band\" x=\"{}\" y=\"{TOP}\" width=\"{}\" height=\"{}\"/>",
            px(x),
            px((end - x).max(1.0)),
            HEIGHT - TOP - BOTTOM
        )
    };
    figure.series.iter().filter(|s| s.to.is_finite()).map(|s| band(s.from, s.to)).collect()
}

fn axes(scale: &Scale) -> String {
    let (mut out, base) = (String::new(), HEIGHT - BOTTOM);
    let degrees = ticks(scale.degrees.0, scale.degrees.1, 4);
    for v in &degrees.at {
        let y = scale.y(*v);
        let class = if *v == 0.0 { "zero" } else { "grid" };
        out += &format!(
            "<line class=\"{class}\" x1=\"{LEFT}\" x2=\"{0}\" y1=\"{1}\" y2=\"{1}\"/><text class=\"tick\" x=\"{2}\" y=\"{3}\" text-anchor=\"end\">{4}</text>",
            WIDTH - RIGHT,
            px(y),
            LEFT - 7.0,
            px(y + 3.8),
            fixed(*v, degrees.decimals)
        );
    }
    let times = ticks(scale.time.0, scale.time.1, 10);
    for v in &times.at {
        let x = scale.x(*v);
        out += &format!(
            "<line class=\"axis\" x1=\"{0}\" x2=\"{0}\" y1=\"{base}\" y2=\"{1}\"/><text class=\"tick\" x=\"{0}\" y=\"{2}\" text-anchor=\"middle\">{3}</text>",
            px(x),
            base + 4.0,
            base + 17.0,
            fixed(*v, times.decimals)
        );
    }
    out + &format!(
        "<text class=\"unit\" x=\"{}\" y=\"{}\" text-anchor=\"end\">time [s]</text>",
        WIDTH - RIGHT,
        HEIGHT - 6.0
    )
}

/// A mark at each strike; where they crowd, one for many.
fn marks(strikes: &[SolidStrike], scale: &Scale) -> String {
    let (mut out, mut last, mut numbered) = (String::new(), f64::NEG_INFINITY, f64::NEG_INFINITY);
    for (i, strike) in strikes.iter().enumerate().filter(|(_, s)| s.time.is_finite()) {
        let x = scale.x(strike.time);
        if x - last < CLOSE {
            continue;
        }
        last = x;
        out += &format!(
            "<line class=\"struck\" x1=\"{0}\" x2=\"{0}\" y1=\"{TOP}\" y2=\"{1}\"/>",
            px(x),
            HEIGHT - BOTTOM
        );
        if x - numbered >= ROOM {
            numbered = x;
            out += &format!(
                "<text class=\"struck\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                px(x),
                TOP - 4.0,
                i + 1
            );
        }
    }
    out
}

fn line(figure: &SolidFigure<'_>, scale: &Scale) -> String {
    let every = figure.instants.len().div_ceil(MOST_POINTS).max(1);
    let final_one = figure.instants.len().saturating_sub(1);
    let kept = figure.instants.iter().enumerate().filter(|(i, _)| i % every == 0 || *i == final_one);
    let points: Vec<String> = kept
        .filter(|(_, instant)| instant.time.is_finite() && instant.tilt.is_finite())
        .map(|(_, instant)| {
            format!("{},{}", px(scale.x(instant.time)), px(scale.y(instant.tilt.to_degrees())))
        })
        .collect();
    format!("<polyline class=\"series s0\" points=\"{}\"/>", escape(&points.join(" ")))
}
