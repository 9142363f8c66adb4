//! The limit of periods that shrink geometrically.

use crate::tolerance::{MOST_PERIOD_RATIO, STEADY_RATIO};

/// What is left of a series after three periods, which begin and end at these times, and the ratio of the last two. `None` where they are not those of a series.
pub(crate) fn left([first, early, middle, late]: [f64; 4]) -> Option<(f64, f64)> {
    let [late, middle, early] = [late - middle, middle - early, early - first];
    let [ratio, before] = [late / middle, middle / early];
    let left = late * left_of(ratio, before);
    let steady = (ratio - before).abs() <= STEADY_RATIO;
    // The limit of a closed series may lie after the next impact: times of limits need not ascend.
    (ratio > 0.0 && ratio < MOST_PERIOD_RATIO && steady && left >= 0.0).then_some((left, ratio))
}

/// What is left of a series, in units of its last interval, by the last two ratios of intervals.
///
/// Were each interval r times the one before, `r/(1 − r)` would be left. But angles, and centrifugal beside gravity's accelerations, fall as the square of the
/// intervals, and so does what they add to the ratio: with `q = r²` it is `r (1 + ε), r (1 + ε q), …`, and to first order in ε is left
///
/// ```text
/// r/(1 − r) + ε/(1 − q) (r/(1 − r) − r q/(1 − r q))
/// ```
fn left_of(ratio: f64, before: f64) -> f64 {
    let q = ratio * ratio;
    let beyond = (before - ratio) * q / (1.0 - q);
    let limit = ratio - beyond;
    let whole = limit / (1.0 - limit);
    let next = beyond * q / limit;
    if limit > 0.0 && limit < MOST_PERIOD_RATIO {
        whole + next / (1.0 - q) * (whole - limit * q / (1.0 - limit * q))
    } else {
        ratio / (1.0 - ratio)
    }
}
