//! The first place in a step where a smooth function of the motion falls through zero.

use crate::tolerance::RESOLVED_SHAPE;
use carom_num::poly::{NODES, Quartic};

/// Halvings of a step after which a function that stays positive at its nodes is taken as positive.
const MOST_HALVINGS: u32 = 12;

/// The first fall of `f` on [0, 1]; it starts at or above zero.
///
/// # Guarantees
/// None is passed over, if what the five nodes of an interval do not show is at most as large as the highest term that they do show; where that
/// term is not small the interval is halved, at most twelve times.
pub(super) fn first_fall(f: &mut impl FnMut(f64) -> f64) -> Option<f64> {
    let values = NODES.map(&mut *f);
    fall_in(f, values, (0.0, 1.0), 0)
}

fn fall_in(
    f: &mut impl FnMut(f64) -> f64,
    values: [f64; 5],
    (from, to): (f64, f64),
    depth: u32,
) -> Option<f64> {
    let quartic = Quartic::through(&values);
    if quartic.lower_bound() > quartic.highest {
        return None;
    }
    let largest = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    if quartic.highest <= RESOLVED_SHAPE * largest || quartic.certainly_falls() || depth == MOST_HALVINGS {
        return quartic.first_fall().map(|x| from + (to - from) * x);
    }
    let middle = 0.5 * (from + to);
    for (part, [a, b]) in [(from, middle), (middle, to)].into_iter().zip([[0, 2], [2, 4]]) {
        let mut own = [values[a], 0.0, 0.0, 0.0, values[b]];
        for node in 1..4 {
            own[node] = f(part.0 + (part.1 - part.0) * NODES[node]);
        }
        let found = fall_in(f, own, part, depth + 1);
        if found.is_some() {
            return found;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use carom_num::elementary::cos;

    #[test]
    fn the_first_of_many_falls_is_found() {
        let place = first_fall(&mut |x| 0.5 + cos(40.0 * x)).unwrap();
        let wanted = 2.0 * std::f64::consts::FRAC_PI_3 / 40.0;
        assert!((place - wanted).abs() < 1e-4, "{place} {wanted}");
    }

    #[test]
    fn a_short_dip_is_seen() {
        let dip = |x: f64| (x - 0.3) * (x - 0.3) - 1e-6;
        let place = first_fall(&mut { dip }).unwrap();
        assert!((place - 0.299).abs() < 1e-6, "{place}");
        assert_eq!(first_fall(&mut |x| dip(x) + 2e-6), None);
    }

    #[test]
    fn what_rises_from_zero_does_not_fall() {
        assert_eq!(first_fall(&mut |x| x * (2.0 - x)), None);
    }
}
