//! Round numbers along an axis.

use crate::text::exponent;
use crate::tolerance::ROUNDING;

/// Round ticks that cover `[low, high]`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ticks {
    /// The ticks, ascending.
    pub(crate) at: Vec<f64>,
    /// Decimals that tell neighbouring ticks apart.
    pub(crate) decimals: usize,
}

fn power_of_ten(e: i32) -> f64 {
    format!("1e{e}").parse().unwrap_or(1.0)
}

/// The smallest of 1, 2, 2.5, 5 × 10ⁿ that is at least `raw`.
fn round_step(raw: f64) -> (f64, usize) {
    let e = exponent(raw, 15);
    let unit = power_of_ten(e);
    for (factor, more) in [(1.0, 0), (2.0, 0), (2.5, 1), (5.0, 0)] {
        if raw <= factor * unit * (1.0 + ROUNDING) {
            return (factor * unit, usize::try_from(more - e).unwrap_or(0));
        }
    }
    (power_of_ten(e + 1), usize::try_from(-e - 1).unwrap_or(0))
}

/// About `count` round ticks inside `[low, high]`; one tick where the range is empty.
pub(crate) fn ticks(low: f64, high: f64, count: usize) -> Ticks {
    let span = high - low;
    if !(span.is_finite() && span > 0.0 && low.is_finite()) {
        return Ticks { at: vec![if low.is_finite() { low } else { 0.0 }], decimals: 2 };
    }
    let (step, decimals) = round_step(span / count.max(1) as f64);
    let first = (low / step - ROUNDING).ceil();
    let last = (high / step + ROUNDING).floor();
    let mut at = vec![];
    let mut k = first;
    while k <= last && at.len() < 50 {
        at.push(k * step);
        k += 1.0;
    }
    Ticks { at, decimals }
}

/// `[low, high]` widened to whole ticks; a range of no width gets one.
pub(crate) fn widened(low: f64, high: f64, count: usize) -> (f64, f64) {
    let (low, high) = if low.is_finite() && high.is_finite() { (low, high) } else { (0.0, 1.0) };
    let size = low.abs().max(high.abs());
    if high - low <= ROUNDING * size || high <= low {
        let pad = if size > 0.0 { 0.2 * size } else { 1.0 };
        return widened(low - pad, high + pad, count);
    }
    let (step, _) = round_step((high - low) / count.max(1) as f64);
    ((low / step + ROUNDING).floor() * step, (high / step - ROUNDING).ceil() * step)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        let t = ticks(0.0, 116.7, 5);
        assert_eq!(t.at, [0.0, 25.0, 50.0, 75.0, 100.0], "quarters of a hundred");
        let t = ticks(-0.52, 0.11, 4);
        assert_eq!(t.at.len(), 3, "{t:?}");
        assert!(t.at.iter().all(|x| (-0.52..=0.11).contains(x)), "{t:?}");
        assert_eq!(ticks(1.0, 1.0, 5).at, [1.0], "empty range");
        assert_eq!(ticks(f64::NAN, 1.0, 5).at, [0.0], "not a number");
    }

    #[test]
    fn ranges_grow_to_whole_ticks() {
        assert_eq!(widened(0.0, 2.9, 4), (0.0, 3.0), "up");
        let (low, high) = widened(3.0, 3.0, 4);
        assert!(low < 3.0 && high > 3.0, "a constant has room");
        assert_eq!(widened(f64::NAN, 0.0, 4), (0.0, 1.0), "not a number");
    }
}
