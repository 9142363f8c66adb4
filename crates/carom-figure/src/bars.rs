//! Bars of shares as HTML: a name, a bar with its interval, and the numbers; where there is little room, the bar goes below its name.

use crate::markup::{Markup, html, joined};
use crate::text::{percent, px, significant};
use carom_study::yields::Estimate;

/// One bar. Shares are of what the whole width stands for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bar {
    /// What it is.
    pub(crate) name: String,
    /// Where the bar ends.
    pub(crate) share: f64,
    /// Where a paler bar behind it ends.
    pub(crate) behind: Option<f64>,
    /// Ends of its interval.
    pub(crate) interval: Option<[f64; 2]>,
    /// Ends of the interval of the bar behind.
    pub(crate) behind_interval: Option<[f64; 2]>,
    /// The same in numbers.
    pub(crate) numbers: String,
    /// What its colour says: `wanted`, `unwanted`, `partly`; empty where it says nothing.
    pub(crate) class: &'static str,
}

/// Bars below each other; the whole width is `whole`.
pub(crate) fn bars(bars: &[Bar], whole: f64) -> Markup {
    html! { div.bars { @for bar in bars { (bar.row(whole)) } } }
}

/// The same under a heading, which says what the whole width is, to so many digits.
pub(crate) fn enlarged(heading: &str, list: &[Bar], whole: f64, digits: usize) -> Markup {
    html! {
        h3 { (heading) " " small { "the whole width is " (significant(100.0 * whole, digits)) " %" } }
        (bars(list, whole))
    }
}

impl Bar {
    /// A share with its interval, in numbers too; `cases` are what it counts.
    pub(crate) fn of(estimate: &Estimate, cases: &str) -> Self {
        let Estimate { share, low, high, count } = *estimate;
        let [of, from, to] = [share, low, high].map(percent);
        let numbers = format!("{of} % ({from} to {to}), {count} {cases}");
        Self { share, interval: Some([low, high]), numbers, ..Self::default() }
    }

    /// Half the height of a bracket's ends.
    fn tall(&self) -> i32 {
        if self.behind_interval.is_some() { 2 } else { 4 }
    }

    fn row(&self, whole: f64) -> Markup {
        let at = |share: f64| (100.0 * share / whole).clamp(0.0, 100.0);
        let rect = |class: &str, share: f64| {
            html! { rect class=(class) y="3" width=(px(at(share))) height="10" {} }
        };
        // Two brackets stand above each other.
        let heights = if self.behind_interval.is_some() { [5, 11] } else { [8, 8] };
        let brackets = [self.interval, self.behind_interval].into_iter().zip(heights);
        let brackets = brackets.filter_map(|(interval, y)| {
            let [low, high] = interval?.map(|end| px(at(end)));
            let (top, bottom) = (y - self.tall(), y + self.tall());
            let d = format!("M{low} {y}H{high}M{low} {top}V{bottom}M{high} {top}V{bottom}");
            Some(html! { path.interval vector-effect="non-scaling-stroke" d=(d) {} })
        });
        html! {
            div class={ "bar " (self.class) } {
                span.what { (self.name) }
                svg viewBox="0 0 100 16" preserveAspectRatio="none" aria-hidden="true" {
                    rect.whole y="3" width="100" height="10" {}
                    @if let Some(share) = self.behind { (rect("behind", share)) }
                    (rect("share", self.share))
                    (joined(brackets))
                }
                span.numbers { (self.numbers) }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_are_as_long_as_their_shares() {
        let bar = Bar {
            name: "a < b".into(),
            share: 0.25,
            behind: Some(2.0),
            interval: Some([-0.1, 0.375]),
            ..Bar::default()
        };
        let html = bars(&[bar], 0.5).into_string();
        assert!(html.contains("class=\"share\" y=\"3\" width=\"50\""), "half of a half: {html}");
        assert!(html.contains("class=\"behind\" y=\"3\" width=\"100\""), "not beyond the whole: {html}");
        assert!(html.contains("M0 8H75"), "the interval, cut at zero: {html}");
        assert!(html.contains("a &lt; b"), "escaped: {html}");
    }
}
