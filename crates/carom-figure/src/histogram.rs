//! The distribution of a measure as SVG: how many of the drops fall into each bin, the median and where 5 to 95 % of them are.

use crate::markup::{Markup, html};
use crate::plot::{BOTTOM, HEIGHT, LEFT, Scale, TOP, WIDTH};
use crate::svg;
use crate::text::{px, significant};
use crate::ticks::widened;
use carom_study::yields::Spread;

/// Room above the highest bin, for the words at the median.
const ABOVE: f64 = 1.14;
/// Letters of the word at the median are at most so wide, on a narrow screen [px].
const LETTER: f64 = 7.4;

/// A measure to draw.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measure<'a> {
    /// What it is.
    pub(crate) name: &'a str,
    /// Its unit.
    pub(crate) unit: &'a str,
    /// Its values.
    pub(crate) spread: &'a Spread,
}

impl Measure<'_> {
    fn scale(&self) -> Option<Scale> {
        let histogram = &self.spread.histogram;
        let (from, to) = (*histogram.edges.first()?, *histogram.edges.last()?);
        let most = histogram.counts.iter().copied().map(|count| self.share(count)).fold(0.0, f64::max);
        (from < to && most > 0.0).then(|| Scale { x: (from, to), y: (0.0, widened(0.0, most * ABOVE, 4).1) })
    }

    /// A count in percent of all.
    fn share(&self, count: u64) -> f64 {
        100.0 * count as f64 / self.spread.count as f64
    }

    /// The picture with its numbers below; none of nothing.
    pub(crate) fn figure(&self) -> Option<Markup> {
        let scale = self.scale()?;
        let Spread { p05, median, p95, p01, p99, low, high, .. } = self.spread;
        let number = |value: &f64| significant(*value, 4);
        let range = |from: &f64, to: &f64| format!("{} to {}", number(from), number(to));
        let numbers = [
            ("median", number(median)),
            ("5 to 95 %", range(p05, p95)),
            ("1 to 99 %", range(p01, p99)),
            ("all", range(low, high)),
        ];
        Some(html! {
            figure.spread {
                h4 { (self.name) }
                (self.svg(&scale))
                dl {
                    @for (what, number) in numbers { div { dt { (what) } dd { (number) " " (self.unit) } } }
                }
            }
        })
    }

    fn svg(&self, scale: &Scale) -> Markup {
        let Spread { p05, p95, .. } = *self.spread;
        let ((left, _), (right, _)) = (scale.at(p05, 0.0), scale.at(p95, 0.0));
        // Where all values are one the band would have no width, and not be seen.
        let band = [(right - left).max(1.0), HEIGHT - BOTTOM - TOP];
        html! {
            svg.fig.histogram viewBox={ "0 0 " (px(WIDTH)) " " (px(HEIGHT)) } role="img"
                aria-label={ "Distribution: " (self.name) } {
                (svg::rect("band", [left, TOP], band))
                (self.bars(scale))
                (scale.axes(self.unit))
                (self.median(scale))
                text.unit x=(px(LEFT)) y="18" { "% of " (self.spread.count) " drops" }
                (self.far())
            }
        }
    }

    /// How many drops lie outside the picture.
    fn far(&self) -> Markup {
        let (below, above) = (self.spread.histogram.below, self.spread.histogram.above);
        let y = HEIGHT - 6.0;
        html! {
            @if below > 0 { (svg::text("unit", [LEFT, y], "start", &format!("← {below} more"))) }
            @if above > 0 { (svg::text("unit", [WIDTH - 40.0, y], "end", &format!("{above} more →"))) }
        }
    }

    /// One path of all bins.
    fn bars(&self, scale: &Scale) -> Markup {
        let histogram = &self.spread.histogram;
        let mut d = String::new();
        for (edges, count) in histogram.edges.windows(2).zip(&histogram.counts) {
            if *count == 0 {
                continue;
            }
            let (left, base) = scale.at(edges[0], 0.0);
            let (right, top) = scale.at(edges[1], self.share(*count));
            d += &format!("M{0} {1}V{2}H{3}V{1}Z", px(left), px(base), px(top), px(right));
        }
        svg::path("bins", &d)
    }

    /// The median's line, with its word on the side where there is room.
    fn median(&self, scale: &Scale) -> Markup {
        let words = format!("median {}", significant(self.spread.median, 4));
        let (x, _) = scale.at(self.spread.median, 0.0);
        let fits_right = x + 4.0 + LETTER * words.chars().count() as f64 <= WIDTH;
        let (dx, anchor) = if fits_right { (4.0, "start") } else { (-4.0, "end") };
        html! {
            line.median x1=(px(x)) x2=(px(x)) y1=(px(TOP)) y2=(px(HEIGHT - BOTTOM)) {}
            (svg::text("median", [x + dx, TOP + 10.0], anchor, &words))
        }
    }
}
