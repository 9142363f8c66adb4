//! How far one value may move alone before something flips.

/// The first step away from a value, as a share of its scale; each next one is twice as long.
const FIRST_STEP: f64 = 1.0 / 1024.0;
/// Steps before the search ends: 2^17 first steps are 128 scales.
const STEPS: u32 = 18;
/// The share of a value that it is made smaller to at most.
const LEAST: f64 = 1e-3;
/// Bisections of the last step.
const BISECTIONS: u32 = 30;

/// What a changed value does.
///
/// # Example
/// ```
/// use carom_study::limits::Effect;
/// assert_ne!(Effect::Flips, Effect::Impossible);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// What is watched stays.
    Same,
    /// It flips.
    Flips,
    /// There is nothing to watch: no such feeder.
    Impossible,
}

/// What ended a search.
///
/// # Example
/// ```
/// use carom_study::limits::End;
/// assert_ne!(End::Flips, End::OfSearch);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// Beyond the last value it flips.
    Flips,
    /// Beyond the last value there is nothing to watch.
    Impossible,
    /// It stays down to a thousandth of the value, or up to 128 scales away.
    OfSearch,
}

/// The last value with the same effect, going from `value` in steps of `scale`, and what ended the search there.
///
/// Found by steps that double, then by bisection: an island of another effect that is narrower than a step can be missed.
///
/// # Example
/// ```
/// use carom_study::limits::{Effect, End, limit};
/// let effect = |x: f64| if x < 0.176 { Effect::Same } else { Effect::Flips };
/// let (last, end) = limit(0.15, 0.15, &effect);
/// assert!(end == End::Flips && (last - 0.176).abs() < 1e-9);
/// ```
pub fn limit(value: f64, scale: f64, effect: &impl Fn(f64) -> Effect) -> (f64, End) {
    let mut inside = value;
    // Towards zero a value shrinks to a thousandth: a part of no mass is no part.
    let least = value * LEAST;
    for step in 0..STEPS {
        let next = value + scale * FIRST_STEP * f64::from(1u32 << step);
        let at_end = value * scale < 0.0 && (next - least) * value < 0.0;
        let outside = if at_end { least } else { next };
        match effect(outside) {
            Effect::Same => inside = outside,
            other => return bisect(inside, (outside, other), effect),
        }
        if at_end {
            break;
        }
    }
    (inside, End::OfSearch)
}

fn bisect(mut inside: f64, mut outside: (f64, Effect), effect: &impl Fn(f64) -> Effect) -> (f64, End) {
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside.0);
        match effect(middle) {
            Effect::Same => inside = middle,
            other => outside = (middle, other),
        }
    }
    (inside, if outside.1 == Effect::Flips { End::Flips } else { End::Impossible })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_edge_of_a_verdict_is_found() {
        let effect = |x: f64| if (0.055..0.176).contains(&x) { Effect::Same } else { Effect::Flips };
        let [(low, _), (high, end)] = [-0.15, 0.15].map(|scale| limit(0.15, scale, &effect));
        assert_eq!(end, End::Flips);
        assert!((low - 0.055).abs() < 1e-9 && effect(low) == Effect::Same, "{low}");
        assert!((high - 0.176).abs() < 1e-9 && effect(high) == Effect::Same, "{high}");
    }

    #[test]
    fn a_verdict_that_never_changes_has_no_limit() {
        assert_eq!(limit(1.0, 1.0, &|_| Effect::Same).1, End::OfSearch);
        let until_zero = |x: f64| if x > 0.0 { Effect::Same } else { Effect::Impossible };
        assert_eq!(limit(1.0, -1.0, &until_zero), (LEAST, End::OfSearch));
        let until_two = |x: f64| if x < 2.0 { Effect::Same } else { Effect::Impossible };
        let (kept, end) = limit(1.0, 1.0, &until_two);
        assert!((2.0 - kept).abs() < 1e-8 && end == End::Impossible, "{kept}: it cannot be drawn beyond");
        let near_zero = |x: f64| if x > 1e-5 { Effect::Same } else { Effect::Flips };
        assert_eq!(limit(1.0, -1.0, &near_zero).1, End::OfSearch, "not searched below a thousandth");
    }
}
