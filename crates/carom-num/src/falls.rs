//! Where smooth functions fall through zero first.
//!
//! Functions are looked at at the five [`NODES`] of an interval. What these do not show of a function is taken to be a term of the next degree, at most as
//! large as the highest that they do show; where that is not small, or the function comes nearer to zero than that, the interval is halved. So no fall between
//! two places is passed over, and a function that falls and rises again within an interval is found.

use crate::ode8::Vector;
use crate::poly::{NODES, Quartic};
use crate::tolerance::RESOLVED_SHAPE;

/// Halvings of an interval after which a function that stays positive at its nodes is taken as positive.
pub const MOST_HALVINGS: u32 = 12;

/// What nodes do not show of a function is at most this many times its highest term: the Chebyshev term of the next degree looks like one of a lower degree there, and differs
/// from that by twice its size.
const UNSEEN: f64 = 2.0;

/// What the values of a function at the [`NODES`] of an interval say.
///
/// # Example
/// ```
/// use carom_num::falls::{Shown, shown};
/// use carom_num::poly::NODES;
/// assert_eq!(shown(&NODES.map(|x| 2.0 - x), true), Shown::Stays);
/// let Shown::Falls(x) = shown(&NODES.map(|x| 0.5 - x), true) else { panic!("it falls") };
/// assert!((x - 0.5).abs() < 1e-9);
/// // It may dip below zero between two nodes.
/// assert_eq!(shown(&NODES.map(|x| (30.0 * x).cos()), true), Shown::Doubtful);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shown {
    /// It is not seen to fall. Nothing is said of a function with a value that is no number.
    Stays,
    /// It falls through zero first at this fraction of the interval.
    Falls(f64),
    /// The nodes do not show enough.
    Doubtful,
}

/// What five values say; where the interval may not be halved any more there is no doubt.
///
/// # Example
/// ```
/// use carom_num::falls::{Shown, shown};
/// let values = carom_num::poly::NODES.map(|x| (30.0 * x).cos());
/// assert!(matches!(shown(&values, false), Shown::Falls(_)));
/// ```
pub fn shown(values: &[f64; 5], may_halve: bool) -> Shown {
    if !values.iter().all(|value| value.is_finite()) {
        return Shown::Stays;
    }
    let quartic = Quartic::through(values);
    if quartic.lower_bound() > UNSEEN * quartic.highest {
        return Shown::Stays;
    }
    let largest = values.iter().fold(0.0, |m: f64, value| m.max(value.abs()));
    if may_halve && quartic.highest > RESOLVED_SHAPE * largest && !quartic.certainly_falls() {
        return Shown::Doubtful;
    }
    let fall = quartic.first_fall();
    // It comes nearer to zero, or dips below it by less, than what the nodes do not show.
    if may_halve && quartic.surely_falls() != Some(fall.is_some()) {
        return Shown::Doubtful;
    }
    match fall {
        // What leaves zero as a higher power does is positive at the first node: the quartic alone dips before it.
        Some(x) if values[0] == 0.0 && x < NODES[1] && values[1] > 0.0 => {
            if may_halve {
                Shown::Doubtful
            } else {
                Shown::Stays
            }
        }
        Some(x) => Shown::Falls(x),
        None => Shown::Stays,
    }
}

/// The first fall of one of several functions.
///
/// # Example
/// ```
/// let fall = carom_num::falls::first_fall(&mut |x| [1.0 - x * x, 0.25 - x]).unwrap();
/// assert!(fall.of == 1 && (fall.at - 0.25).abs() < 1e-9);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fall {
    /// Which function falls.
    pub of: usize,
    /// Where: a fraction of the interval.
    pub at: f64,
}

/// The first fall on [0, 1] of functions that start at or above zero.
///
/// # Guarantees
/// None is passed over, if what five nodes do not show of a function is a Chebyshev term of degree 5 that is at most as large as that of degree 4, which they do show. Where
/// that term is not small the interval is halved, at most [`MOST_HALVINGS`] times. The place is known to about 1e-9; the first of two falls that are nearer to
/// each other than the error of an interpolant may be told as the second.
///
/// # Example
/// A dip of a thousandth of the interval is found.
/// ```
/// use carom_num::falls::first_fall;
/// let dip = |x: f64| [(x - 0.3) * (x - 0.3) - 2.5e-7];
/// let fall = first_fall(&mut { dip }).unwrap();
/// assert!((fall.at - 0.2995).abs() < 1e-6);
/// ```
pub fn first_fall<V: Vector>(of: &mut impl FnMut(f64) -> V) -> Option<Fall> {
    let values = NODES.map(&mut *of);
    fall_in(of, values, (0.0, 1.0), 0)
}

fn fall_in<V: Vector>(
    of: &mut impl FnMut(f64) -> V,
    values: [V; 5],
    (from, to): (f64, f64),
    depth: u32,
) -> Option<Fall> {
    let (mut first, mut doubtful) = (None::<Fall>, false);
    for i in 0..V::COUNT {
        let own: [f64; 5] = std::array::from_fn(|node| values[node].at(i));
        let finite = own.iter().filter(|value| value.is_finite()).count();
        // It may fall where it still is a number.
        doubtful |= 0 < finite && finite < own.len() && depth < MOST_HALVINGS;
        match shown(&own, depth < MOST_HALVINGS) {
            Shown::Stays => {}
            Shown::Falls(x) => {
                let at = from + (to - from) * x;
                first = first.filter(|known| known.at <= at).or(Some(Fall { of: i, at }));
            }
            Shown::Doubtful => doubtful = true,
        }
    }
    // Where one is doubtful, what the nodes say of the others is not believed either.
    if !doubtful {
        return first;
    }
    let middle = 0.5 * (from + to);
    for (part, [a, b]) in [(from, middle), (middle, to)].into_iter().zip([[0, 2], [2, 4]]) {
        let mut own = [values[a]; 5];
        for node in 1..4 {
            own[node] = of(part.0 + (part.1 - part.0) * NODES[node]);
        }
        own[4] = values[b];
        let found = fall_in(of, own, part, depth + 1);
        if found.is_some() {
            return found;
        }
    }
    None
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failure is a failed test")]

    use super::*;
    use crate::elementary::{cos, pow};

    #[test]
    fn the_first_of_many_falls_is_found() {
        let fall = first_fall(&mut |x| [0.5 + cos(40.0 * x)]).unwrap();
        let wanted = 2.0 * std::f64::consts::FRAC_PI_3 / 40.0;
        assert!((fall.at - wanted).abs() < 1e-4, "{fall:?} {wanted}");
    }

    #[test]
    fn a_short_dip_is_seen_beside_a_later_fall() {
        let dip = |x: f64| (x - 0.3) * (x - 0.3) - 1e-6;
        let fall = first_fall(&mut |x| [0.9 - x, dip(x)]).unwrap();
        assert!(fall.of == 1 && (fall.at - 0.299).abs() < 1e-6, "{fall:?}");
        let later = first_fall(&mut |x| [0.9 - x, dip(x) + 2e-6]).unwrap();
        assert!(later.of == 0 && (later.at - 0.9).abs() < 1e-8, "{later:?}");
    }

    /// A dip beside a node, which the quartic hides: a term of degree 5 as large as that of degree 4.
    #[test]
    fn a_dip_that_the_interpolant_hides_is_found() {
        let f = |x: f64| {
            let t = |n: f64| cos(n * crate::elementary::atan2((4.0 * x * (1.0 - x)).sqrt(), 2.0 * x - 1.0));
            (x - 0.04) * (x - 0.04) + 1e-4 * (t(4.0) - t(5.0) + t(3.0)) + 3e-5
        };
        assert!(f(0.0414) < 0.0 && NODES.iter().all(|x| f(*x) > 0.0), "{:e}", f(0.0414));
        let fall = first_fall(&mut |x| [f(x)]).unwrap();
        // As near as the interpolant of the last half tells it.
        assert!((fall.at - 0.034_165).abs() < 1e-5, "{fall:?}");
    }

    #[test]
    fn what_rises_from_zero_does_not_fall() {
        assert_eq!(first_fall(&mut |x| [x * (2.0 - x)]), None);
        for power in [1.5, 2.0, 2.1, 2.5, 2.9, 3.0] {
            for size in [1e-9, 0.3, 7.0] {
                let rises = first_fall(&mut |x| [size * pow(x, power)]);
                assert_eq!(rises, None, "x to the power {power}, times {size}");
            }
            let falls = first_fall(&mut |x| [pow(x, power) * (0.25 - x)]).unwrap();
            assert!((falls.at - 0.25).abs() < 1e-6, "power {power}: {falls:?}");
        }
    }

    #[test]
    fn a_function_falls_while_it_is_a_number() {
        let fall = first_fall(&mut |x| [if x > 0.5 { f64::NAN } else { 1.0 - 3.0 * x }]).unwrap();
        assert!((fall.at - 1.0 / 3.0).abs() < 1e-9, "{fall:?}");
        assert_eq!(first_fall(&mut |_| [f64::NAN]), None);
    }
}
