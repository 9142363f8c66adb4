//! A line plot as SVG: a few series over one axis, round ticks, event markers, a line for the player's time.

use crate::markup::{Markup, html, joined};
use crate::svg;
use crate::text::{fixed, px, svg_symbol};
use crate::ticks::{ticks, widened};
use crate::tolerance::CONSTANT;

pub(crate) const WIDTH: f64 = 360.0;
pub(crate) const HEIGHT: f64 = 222.0;
pub(crate) const LEFT: f64 = 50.0;
pub(crate) const RIGHT: f64 = 14.0;
pub(crate) const TOP: f64 = 32.0;
pub(crate) const BOTTOM: f64 = 38.0;

/// One line of a plot. Points that are not finite break it.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    /// Its symbol (`v_r`) or name.
    pub(crate) name: String,
    /// Abscissa and ordinate.
    pub(crate) points: Vec<(f64, f64)>,
}

/// An instant worth a line.
#[derive(Clone, Debug)]
pub(crate) struct Marker {
    /// Abscissa.
    pub(crate) at: f64,
    /// What happens there.
    pub(crate) label: String,
}

/// A plot over time in milliseconds from an instant.
#[derive(Clone, Debug, Default)]
pub(crate) struct Plot {
    /// What it shows, for those who cannot see it.
    pub(crate) title: String,
    /// Unit of the ordinate.
    pub(crate) unit: String,
    /// More words after the unit.
    pub(crate) remark: String,
    /// Where the abscissa starts [s].
    pub(crate) from_time: f64,
    /// The lines.
    pub(crate) series: Vec<Series>,
    /// Instants worth a line.
    pub(crate) markers: Vec<Marker>,
    /// True: the ordinate starts at or below zero and ends at or above it.
    pub(crate) with_zero: bool,
}

/// Where values stand in the picture.
pub(crate) struct Scale {
    /// Ends of the abscissa.
    pub(crate) x: (f64, f64),
    /// Ends of the ordinate.
    pub(crate) y: (f64, f64),
}

impl Scale {
    /// Pixels of a point.
    pub(crate) fn at(&self, x: f64, y: f64) -> (f64, f64) {
        let u = (x - self.x.0) / (self.x.1 - self.x.0);
        let v = (y - self.y.0) / (self.y.1 - self.y.0);
        (LEFT + u * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - v * (HEIGHT - TOP - BOTTOM))
    }

    /// Grid, ticks and the line below them, under which `below` stands at the right.
    pub(crate) fn axes(&self, below: &str) -> Markup {
        let (y, x) = (ticks(self.y.0, self.y.1, 4), ticks(self.x.0, self.x.1, 5));
        let (right, base) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        let grid = |v: &f64| {
            let (_, at) = self.at(self.x.0, *v);
            let class = if *v == 0.0 { "zero" } else { "grid" };
            html! {
                (svg::line(class, [LEFT, at], [right, at]))
                (svg::text("tick", [LEFT - 6.0, at + 3.8], "end", &fixed(*v, y.decimals)))
            }
        };
        let mark = |v: &f64| {
            let (at, _) = self.at(*v, self.y.0);
            html! {
                (svg::line("axis", [at, base], [at, base + 4.0]))
                (svg::text("tick", [at, base + 16.0], "middle", &fixed(*v, x.decimals)))
            }
        };
        html! {
            (joined(y.at.iter().map(grid)))
            (joined(x.at.iter().map(mark)))
            (svg::line("axis", [LEFT, base], [right, base]))
            (svg::text("tick", [right, HEIGHT - 6.0], "end", below))
        }
    }
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

impl Plot {
    fn scale(&self) -> Option<Scale> {
        let points = || self.series.iter().flat_map(|s| s.points.iter());
        let (mut x0, mut x1) = range(points().map(|p| p.0));
        let (mut low, mut high) = range(points().map(|p| p.1));
        if !(x0.is_finite() && x1.is_finite() && low.is_finite() && high.is_finite()) {
            return None;
        }
        if x1 <= x0 {
            (x0, x1) = (x0 - 1.0, x1 + 1.0);
        }
        if self.with_zero {
            (low, high) = (low.min(0.0), high.max(0.0));
        }
        // A quantity that is constant but for rounding is drawn as constant.
        if high - low < CONSTANT * low.abs().max(high.abs()) {
            (low, high) = (low, low);
        }
        Some(Scale { x: (x0, x1), y: widened(low, high, 4) })
    }

    /// The SVG element; none where no point is finite.
    pub(crate) fn svg(&self) -> Option<Markup> {
        let scale = self.scale()?;
        let [width, height, left, right] = [WIDTH, HEIGHT, LEFT, WIDTH - RIGHT].map(px);
        Some(html! {
            svg.fig.plot viewBox={ "0 0 " (width) " " (height) } role="img" aria-label=(self.title)
                data-from=(self.from_time) data-x0=(scale.x.0) data-x1=(scale.x.1)
                data-left=(left) data-right=(right) {
                (scale.axes(&format!("ms after {} s", fixed(self.from_time, 4))))
                (self.marker_lines(&scale))
                @for (i, series) in self.series.iter().enumerate() { (line(series, i, &scale)) }
                (self.legend())
                line.now x1="0" x2="0" y1=(px(TOP)) y2=(px(HEIGHT - BOTTOM)) visibility="hidden" {}
            }
        })
    }

    fn marker_lines(&self, scale: &Scale) -> Markup {
        let shown = self.markers.iter().filter(|m| m.at >= scale.x.0 && m.at <= scale.x.1);
        joined(shown.map(|marker| {
            let (x, _) = scale.at(marker.at, scale.y.0);
            // Near the right border the words would leave the picture.
            let (dx, anchor) = if x > 0.6 * WIDTH { (-4.0, "end") } else { (4.0, "start") };
            html! {
                (svg::line("event", [x, TOP], [x, HEIGHT - BOTTOM]))
                (svg::text("event", [x + dx, TOP + 9.0], anchor, &marker.label))
            }
        }))
    }

    fn legend(&self) -> Markup {
        let mut out: Vec<Markup> = vec![];
        let mut x = LEFT;
        let many = self.series.len() > 1;
        for (i, series) in self.series.iter().enumerate() {
            if many {
                out.push(svg::line(&format!("series s{i}"), [x, 14.0], [x + 14.0, 14.0]));
                x += 19.0;
            }
            out.push(html! { text.name x=(px(x)) y="18" { (svg_symbol(&series.name)) } });
            let letters = series.name.chars().filter(|c| *c != '_').count() as f64;
            x += 7.2 * letters + 12.0;
        }
        out.push(html! { text.unit x=(px(x)) y="18" { "[" (self.unit) "]  " (self.remark) } });
        joined(out)
    }
}

/// The polyline of a series, broken where a point is not finite.
fn line(series: &Series, index: usize, scale: &Scale) -> Markup {
    let mut d = String::new();
    let mut drawing = false;
    for (x, y) in &series.points {
        if !(x.is_finite() && y.is_finite()) {
            drawing = false;
            continue;
        }
        let (u, v) = scale.at(*x, *y);
        d += &format!("{}{} {}", if drawing { "L" } else { "M" }, px(u), px(v));
        drawing = true;
    }
    svg::path(&format!("series s{index}"), &d)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plot(points: Vec<(f64, f64)>) -> Plot {
        let series = vec![Series { name: "N".into(), points }];
        Plot { title: "force".into(), unit: "N".into(), series, with_zero: true, ..Plot::default() }
    }

    #[test]
    fn a_gap_breaks_the_line() {
        let svg = plot(vec![(0.0, 1.0), (1.0, 1.0), (2.0, f64::NAN), (3.0, 2.0), (4.0, 2.0)])
            .svg()
            .unwrap()
            .into_string();
        let d = svg.split("series s0\" d=\"").nth(1).and_then(|s| s.split('"').next()).unwrap();
        assert_eq!(d.matches('M').count(), 2, "{d}");
        assert!(!svg.contains("NaN"), "{svg}");
    }

    #[test]
    fn nothing_finite_draws_nothing() {
        assert!(plot(vec![(0.0, f64::NAN)]).svg().is_none(), "no plot");
        assert!(plot(vec![]).svg().is_none(), "no plot");
    }
}
