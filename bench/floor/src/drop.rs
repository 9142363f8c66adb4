//! The drop, straight through: slide, tip, fly, strike, and on the plate until it lies flat.

use crate::answer::{Answer, GRAVITY, HALF_LENGTH, Landing, Prepared, Uncovered};
use crate::flight::Flight;
use crate::plate::{End, Mode, OnEnd, mode, slide, stay};
use crate::strike::Strike;
use crate::tip::{Tip, tip};
use crate::upper::{clear_at_first, clear_in_flight};

/// Pieces on the lower plate after which a drop is too long.
const MOST_PIECES: usize = 200;

/// The drop, with times and speeds right to 1e-9 s and m/s: of all orders the cheapest that is.
pub fn fine(drop: &Prepared) -> Answer {
    drop.run::<11>(3e-10)
}

/// The drop, with times and speeds right to 1e-6 s and m/s: of all orders the cheapest that is.
pub fn coarse(drop: &Prepared) -> Answer {
    drop.run::<8>(1e-7)
}

impl Prepared {
    /// Runs the drop with series of `P` coefficients whose last may add `tolerance` of the rod's own units a step.
    ///
    /// ```
    /// use carom_floor::{Answer, Design};
    /// let case_1 = Design {
    ///     upper_slope: 15f64.to_radians(),
    ///     lower_slope: 0.2f64.atan2(0.347) - 15f64.to_radians(),
    ///     line_b: 0.2,
    ///     to_edge: 0.1,
    ///     friction: 0.15,
    /// };
    /// let Answer::Lands(landing) = case_1.prepare().run::<16>(1e-13) else { panic!("it lands") };
    /// // The slide alone takes √(2 · 0.1/(9.81 (sin 15° − 0.15 cos 15°))) = 0.423 s.
    /// assert!(!landing.turned && 0.423 < landing.first_touch && landing.first_touch < landing.flat);
    /// ```
    pub fn run<const P: usize>(&self, tolerance: f64) -> Answer {
        let (sin, cos) = self.upper;
        let pull = sin - self.friction * cos;
        if pull <= 0.0 {
            return Answer::Stuck;
        }
        match self.land::<P>(pull, tolerance) {
            Ok(landing) => Answer::Lands(landing),
            Err(why) => Answer::NotCovered(why),
        }
    }

    fn land<const P: usize>(&self, pull: f64, tolerance: f64) -> Result<Landing, Uncovered> {
        let time = (2.0 * self.to_edge / pull).sqrt();
        let (sin, cos) = self.upper;
        let start = Tip { time, reach: 0.0, slip: pull * time, turning: 0.0, cos, sin };
        let (released, runs_off) = tip::<P>(self, start, tolerance)?;
        let flight = self.leaves(&released)?;
        let strike = flight.touch(self, None)?;
        clear_at_first(self, (&released, runs_off), &strike)?;
        let (along, across) = strike.velocity();
        let (unit_time, unit_speed) = ((HALF_LENGTH / GRAVITY).sqrt(), (GRAVITY * HALF_LENGTH).sqrt());
        let flat = self.settle::<P>(&strike, tolerance)?;
        Ok(Landing {
            turned: flat.end * flat.c < 0.0,
            first_touch: strike.time * unit_time,
            impact_speed: (along * along + across * across).sqrt() * unit_speed,
            flat: flat.time * unit_time,
        })
    }

    /// The flight that begins where the rod lifts off the edge, in the lower plate's frame.
    fn leaves(&self, at: &Tip) -> Result<Flight, Uncovered> {
        let (sin, cos) = self.lower;
        // Tilt against the lower plate.
        let (s, c) = (at.sin * cos + at.cos * sin, at.cos * cos - at.sin * sin);
        let below = (at.reach + 1.0) * if c > 0.0 { s } else { 1.0 };
        if below >= self.edge_height {
            return Err(Uncovered::TouchesWhileTipping);
        }
        Ok(Flight {
            time: at.time,
            x: at.reach * c,
            y: self.edge_height - at.reach * s,
            vx: at.slip * c - at.reach * at.turning * s,
            vy: -at.slip * s - at.reach * at.turning * c,
            cos: c,
            sin: -s,
            w: -at.turning,
        })
    }

    /// From the first strike to lying flat.
    fn settle<const P: usize>(&self, strike: &Strike, tolerance: f64) -> Result<OnEnd, Uncovered> {
        let mut at = strike.after(self.friction)?;
        let mut next = mode(self, &at)?;
        let mut orders = usize::from(at.u == 0.0);
        for _ in 0..MOST_PIECES {
            let ended = match next {
                Mode::Slides(direction) => slide::<P>(self, &mut at, (direction, orders), tolerance)?,
                Mode::Stays => stay::<P>(self, &mut at, tolerance)?,
                Mode::LiftsOff => Some(End::LiftsOff),
            };
            orders = 0;
            match ended {
                None => {}
                Some(End::LiesFlat) => return Ok(at),
                Some(End::LiftsOff) => {
                    let flight = Flight::of(&at);
                    let strike = flight.touch(self, Some(at.end))?;
                    clear_in_flight(self, &flight)?;
                    at = strike.after(self.friction)?;
                    next = mode(self, &at)?;
                    orders = usize::from(at.u == 0.0);
                }
                Some(End::SlipStops) => {
                    next = mode(self, &at)?;
                    orders = 1;
                }
                Some(End::Slips(direction)) => {
                    next = Mode::Slides(direction);
                    orders = 2;
                }
            }
        }
        Err(Uncovered::TooLong)
    }
}
