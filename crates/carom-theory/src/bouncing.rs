//! A ball that bounces on a level table: infinitely many impacts in finite time.
//!
//! Source of all: Galilean fall and Newton's restitution; see Falcon, Laroche, Fauve and Coste, Eur. Phys. J. B 3 (1998) 45.

use crate::OutsideDomain;
use crate::domain::{require, require_not_negative, require_positive};

/// A ball dropped from rest.
///
/// # Example
/// Without loss it comes back to where it was dropped, however often.
/// ```
/// use carom_theory::bouncing::Drop;
/// let ball = Drop { height: 5.0, gravity: 10.0, restitution: 1.0 };
/// assert_eq!((ball.rebound_height(7), ball.end_of_bouncing()), (5.0, None));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drop {
    /// Height of the ball's lowest point h ≥ 0 \[m\].
    pub height: f64,
    /// g > 0 [m/s²].
    pub gravity: f64,
    /// e in 0…1.
    pub restitution: f64,
}

impl Drop {
    /// Checks that every quantity lies in its domain.
    ///
    /// # Errors
    ///
    /// The first quantity outside its domain.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bouncing::Drop;
    /// let ball = Drop { height: 5.0, gravity: 10.0, restitution: 1.5 };
    /// assert_eq!(ball.check().map_err(|error| error.quantity), Err("restitution"));
    /// assert_eq!(Drop { restitution: 1.0, ..ball }.check(), Ok(()));
    /// ```
    pub fn check(&self) -> Result<(), OutsideDomain> {
        require_not_negative("height", self.height)?;
        require_positive("gravity", self.gravity)?;
        let e = self.restitution;
        require((0.0..=1.0).contains(&e), "restitution", e, "0 <= e <= 1")
    }

    /// Time of the first touch, √(2h/g) \[s\].
    ///
    /// # Example
    /// ```
    /// use carom_theory::bouncing::Drop;
    /// assert_eq!(Drop { height: 5.0, gravity: 10.0, restitution: 0.5 }.fall_time(), 1.0);
    /// ```
    pub fn fall_time(&self) -> f64 {
        (2.0 * self.height / self.gravity).sqrt()
    }

    /// Time of the n-th touch, n ≥ 1 \[s\].
    ///
    /// ```text
    /// t_n = √(2h/g) (1 + 2(e + e² + … + e^(n−1))) = √(2h/g) (1 + 2e (1 − e^(n−1))/(1 − e))
    /// ```
    ///
    /// The geometric sum is formed by doubling, without the division by 1 − e: full accuracy for e → 1 as well.
    /// n = 0 is the release, at 0.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bouncing::Drop;
    /// let ball = Drop { height: 5.0, gravity: 10.0, restitution: 0.5 };
    /// assert_eq!((ball.touch_time(1), ball.touch_time(2), ball.touch_time(3)), (1.0, 2.0, 2.5));
    /// ```
    pub fn touch_time(&self, n: u32) -> f64 {
        match n {
            0 => 0.0,
            n => self.fall_time() * (1.0 + 2.0 * self.restitution * geometric_sum(self.restitution, n - 1)),
        }
    }

    /// Height reached between touch n and touch n + 1, e^(2n) h \[m\].
    ///
    /// # Example
    /// ```
    /// use carom_theory::bouncing::Drop;
    /// assert_eq!(Drop { height: 16.0, gravity: 10.0, restitution: 0.5 }.rebound_height(2), 1.0);
    /// ```
    pub fn rebound_height(&self, n: u32) -> f64 {
        let power = power(self.restitution, n);
        power * power * self.height
    }

    /// Speed right after touch n ≥ 1, eⁿ √(2gh) [m/s].
    ///
    /// # Example
    /// ```
    /// use carom_theory::bouncing::Drop;
    /// assert_eq!(Drop { height: 5.0, gravity: 10.0, restitution: 0.5 }.rebound_speed(3), 1.25);
    /// ```
    pub fn rebound_speed(&self, n: u32) -> f64 {
        power(self.restitution, n) * (2.0 * self.gravity * self.height).sqrt()
    }

    /// When the bouncing ends, √(2h/g) (1 + e)/(1 − e) \[s\]; `None` for e = 1.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bouncing::Drop;
    /// assert_eq!(Drop { height: 5.0, gravity: 10.0, restitution: 0.5 }.end_of_bouncing(), Some(3.0));
    /// ```
    pub fn end_of_bouncing(&self) -> Option<f64> {
        let e = self.restitution;
        (e < 1.0).then(|| self.fall_time() * (1.0 + e) / (1.0 - e))
    }

    /// Way travelled until the bouncing ends, h (1 + e²)/(1 − e²) \[m\]; `None` for e = 1.
    ///
    /// # Example
    /// ```
    /// use carom_theory::bouncing::Drop;
    /// assert_eq!(Drop { height: 3.0, gravity: 10.0, restitution: 0.5 }.way_travelled(), Some(5.0));
    /// ```
    pub fn way_travelled(&self) -> Option<f64> {
        let e = self.restitution;
        (e < 1.0).then(|| self.height * (1.0 + e * e) / ((1.0 - e) * (1.0 + e)))
    }
}

/// eⁿ by squaring.
fn power(e: f64, n: u32) -> f64 {
    let (mut result, mut square, mut left) = (1.0, e, n);
    while left > 0 {
        if left & 1 == 1 {
            result *= square;
        }
        square *= square;
        left >>= 1;
    }
    result
}

/// 1 + e + … + e^(n−1): each pass appends a block of 2^k terms, whose sum is Π(1 + e^(2^i)).
fn geometric_sum(e: f64, n: u32) -> f64 {
    let (mut sum, mut block_sum, mut block_power, mut left) = (0.0, 1.0, e, n);
    while left > 0 {
        if left & 1 == 1 {
            sum = block_sum + block_power * sum;
        }
        block_sum *= 1.0 + block_power;
        block_power *= block_power;
        left >>= 1;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sum_of_many_bounces_matches_adding_them_one_by_one() {
        for e in [0.0, 0.1, 0.5, 0.9, 0.999, 1.0] {
            let (mut sum, mut term) = (0.0, 1.0);
            for n in 0..500 {
                let ours = geometric_sum(e, n);
                assert!((ours - sum).abs() <= 1e-13 * sum, "e {e} n {n}: {ours} {sum}");
                sum += term;
                term *= e;
            }
        }
    }

    #[test]
    fn the_last_touches_approach_the_end_of_bouncing() {
        let ball = Drop { height: 1.0, gravity: 9.81, restitution: 0.8 };
        let end = ball.end_of_bouncing().expect("e < 1");
        assert!((ball.touch_time(400) - end).abs() <= 1e-15 * end, "accumulates at the limit");
        assert!((ball.touch_time(u32::MAX) - end).abs() <= 1e-15 * end, "and stays there");
    }
}
