//! Free flight, and the first touch of one of the rod's ends on the lower plate.
//!
//! In the plate's frame, with the height y of the centre, the axis (cos a, sin a) from tail to front and the spin w, the height of an end K is
//!
//! ```text
//! y + ẏ t − γ_n t²/2 − k sin(a + w t),   k = 1 for the tail, −1 for the front
//! ```

use crate::answer::{Prepared, Uncovered};
use crate::plate::OnEnd;
use crate::series::newton;
use crate::strike::Strike;
use crate::tolerance::{BOTH_ENDS, HARDLY_LIFTS};
use carom_num::elementary::sin_cos;
use carom_num::poly::first_root;

/// Steps of the march after which the flight counts as grazing.
const MOST_STEPS: usize = 200;

/// The rod in the air.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Flight {
    pub(crate) time: f64,
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) vx: f64,
    pub(crate) vy: f64,
    /// Cosine and sine of the axis from tail to front.
    pub(crate) cos: f64,
    pub(crate) sin: f64,
    pub(crate) w: f64,
}

impl Flight {
    /// The flight of a rod whose end lifts off.
    pub(crate) fn of(at: &OnEnd) -> Self {
        Self {
            time: at.time,
            x: at.x + at.c,
            y: at.s,
            vx: at.u - at.s * at.w,
            vy: at.c * at.w,
            cos: at.end * at.c,
            sin: at.end * at.s,
            w: at.w,
        }
    }

    /// Cosine and sine of the axis after `t`.
    #[inline(always)]
    fn turned(&self, t: f64) -> (f64, f64) {
        let (s, c) = sin_cos(self.w * t);
        (self.cos * c - self.sin * s, self.sin * c + self.cos * s)
    }

    /// Height and its rate of the end k.
    #[inline(always)]
    fn height(&self, gn: f64, k: f64, t: f64) -> (f64, f64) {
        let (cos, sin) = self.turned(t);
        let (y, vy) = (self.y + t * (self.vy - 0.5 * gn * t), self.vy - gn * t);
        (y - k * sin, vy - k * self.w * cos)
    }

    /// The first touch: marching on both ends by what they cannot fall faster than, then Newton's steps.
    pub(crate) fn touch(&self, drop: &Prepared, left: Option<f64>) -> Result<Strike, Uncovered> {
        let gn = drop.lower.1;
        let bend = gn + self.w * self.w;
        let away = left.map_or(Ok(0.0), |end| self.stays_open(gn, end))?;
        // No end reaches farther down than half the rod.
        let mut t = if self.y > 1.0 {
            (self.vy + (self.vy * self.vy + 2.0 * gn * (self.y - 1.0)).sqrt()) / gn
        } else {
            0.0
        };
        for _ in 0..MOST_STEPS {
            let (cos, sin) = self.turned(t);
            let (y, vy) = (self.y + t * (self.vy - 0.5 * gn * t), self.vy - gn * t);
            // The lower end; while one stays up, the other.
            let held_up = left.filter(|_| t < away);
            let k = held_up.map_or(sin.signum(), |end| -end);
            let (value, rate) = (y - k * sin, vy - k * self.w * cos);
            if rate < 0.0 && 4.0 * bend * value < rate * rate {
                return self.strike(drop, k, newton(|t| self.height(gn, k, t), t - value / rate));
            }
            let step = first_root(value, rate, bend);
            t = match held_up {
                Some(_) => (t + step).min(away),
                None => t + step.min(first_root(y + k * sin, vy + k * self.w * cos, bend)),
            };
        }
        Err(Uncovered::Grazes)
    }

    /// For how long an end that has just lifted off stays up: with its height's second and third derivative a ≥ 0 and b, and w⁴ the bound of the
    /// fourth, that is up to the root of 12 a + 4 b t − w⁴ t². Less is taken, so that it is clearly up by then.
    fn stays_open(&self, gn: f64, end: f64) -> Result<f64, Uncovered> {
        let (c, s, ww) = (end * self.cos, end * self.sin, self.w * self.w);
        let (second, third, fourth) = ((s * ww - gn).max(0.0), c * ww * self.w, ww * ww);
        let root = (2.0 * third + (4.0 * third * third + 12.0 * second * fourth).sqrt()) / fourth;
        if root > HARDLY_LIFTS { Ok(0.75 * root) } else { Err(Uncovered::Tie) }
    }

    fn strike(&self, drop: &Prepared, k: f64, t: f64) -> Result<Strike, Uncovered> {
        let (gt, gn) = drop.lower;
        let (cos, sin) = self.turned(t);
        let y = self.y + t * (self.vy - 0.5 * gn * t);
        if y < BOTH_ENDS {
            return Err(Uncovered::Tie);
        }
        Ok(Strike {
            time: self.time + t,
            lasted: t,
            end: k,
            c: k * cos,
            s: k * sin,
            w: self.w,
            x: self.x + t * (self.vx - 0.5 * gt * t) - k * cos,
            vx: self.vx - gt * t,
            vy: self.vy - gn * t,
        })
    }
}
