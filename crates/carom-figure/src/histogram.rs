//! The distribution of a measure as SVG: how many of the drops fall into each bin, the median and where 5 to 95 % of them are.

use crate::plot::{BOTTOM, HEIGHT, LEFT, Scale, TOP, WIDTH};
use crate::text::{escape, px, significant};
use crate::ticks::widened;
use carom_study::yields::Spread;

/// Room above the highest bin, for the words at the median.
const ABOVE: f64 = 1.14;
/// Letters of the word at the median are about so wide [px].
const LETTER: f64 = 5.4;

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

    /// The picture with its numbers below; empty of nothing.
    pub(crate) fn figure(&self) -> String {
        let Some(scale) = self.scale() else { return String::new() };
        let Spread { p05, median, p95, p01, p99, low, high, .. } = self.spread;
        let number = |value: &f64| significant(*value, 4);
        let range = |from: &f64, to: &f64| format!("{} to {}", number(from), number(to));
        format!(
            "<figure class=\"spread\"><h4>{}</h4>{}<dl><div><dt>median</dt><dd>{} {unit}</dd></div><div><dt>5 to 95 %</dt><dd>{} {unit}</dd></div><div><dt>1 to 99 %</dt><dd>{} {unit}</dd></div><div><dt>all</dt><dd>{} {unit}</dd></div></dl></figure>",
            escape(self.name),
            self.svg(&scale),
            number(median),
            range(p05, p95),
            range(p01, p99),
            range(low, high),
            unit = escape(self.unit)
        )
    }

    fn svg(&self, scale: &Scale) -> String {
        let mut out = format!(
            "<svg class=\"fig histogram\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Distribution: {}\">",
            px(WIDTH),
            px(HEIGHT),
            escape(self.name)
        );
        let Spread { p05, p95, .. } = *self.spread;
        let ((left, _), (right, _)) = (scale.at(p05, 0.0), scale.at(p95, 0.0));
        out += &format!(
            "<rect class=\"band\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
            px(left),
            px(TOP),
            px((right - left).max(1.0)),
            px(HEIGHT - BOTTOM - TOP)
        );
        out += &self.bars(scale);
        out += &scale.axes(self.unit);
        out += &self.median(scale);
        let unit = format!("% of {} drops", self.spread.count);
        out += &format!("<text class=\"unit\" x=\"{}\" y=\"18\">{unit}</text>", px(LEFT));
        out += &self.far();
        out + "</svg>"
    }

    /// How many drops lie outside the picture.
    fn far(&self) -> String {
        let histogram = &self.spread.histogram;
        let word = |count: u64, at: f64, anchor: &str, words: String| match count {
            0 => String::new(),
            _ => format!(
                "<text class=\"unit\" x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{words}</text>",
                px(at),
                px(HEIGHT - 6.0)
            ),
        };
        let (below, above) = (histogram.below, histogram.above);
        word(below, LEFT, "start", format!("← {below} more"))
            + &word(above, WIDTH - 40.0, "end", format!("{above} more →"))
    }

    /// One path of all bins.
    fn bars(&self, scale: &Scale) -> String {
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
        format!("<path class=\"bins\" d=\"{d}\"/>")
    }

    /// The median's line, with its word on the side where there is room.
    fn median(&self, scale: &Scale) -> String {
        let words = format!("median {}", significant(self.spread.median, 4));
        let (x, _) = scale.at(self.spread.median, 0.0);
        let fits_right = x + 4.0 + LETTER * words.chars().count() as f64 <= WIDTH;
        let (dx, anchor) = if fits_right { (4.0, "start") } else { (-4.0, "end") };
        format!(
            "<line class=\"median\" x1=\"{0}\" x2=\"{0}\" y1=\"{1}\" y2=\"{2}\"/><text class=\"median\" x=\"{3}\" y=\"{4}\" text-anchor=\"{anchor}\">{words}</text>",
            px(x),
            px(TOP),
            px(HEIGHT - BOTTOM),
            px(x + dx),
            px(TOP + 10.0)
        )
    }
}
