//! A step along a Taylor series.

use super::Expanded;
use super::expansion::{Expansion, Given, Spreads};
use crate::planar::contact::{World, bounds::Bounds, world::Scales};
use crate::planar::geometry::State;
use crate::planar::modes::watch::Watched;
use crate::planar::walk::path::Stretch;
use carom_impact::planar::Slip;
use carom_num::taylor::{first_fall, value};

/// A step along a series.
#[derive(Clone, Debug)]
pub(super) struct Along<const P: usize> {
    pub(super) expansion: Expansion<P>,
    /// How far it changes within the length it had at first.
    pub(super) spreads: Spreads,
    pub(super) length: f64,
}

impl<const P: usize> Along<P> {
    /// A step from here on, without a length yet. It takes the place of a step of the same mode that is over: the series are long.
    pub(super) fn from(given: Given, place: &mut Option<Self>) -> &mut Self {
        if let Some(over) = place {
            over.expansion.expand_from(given);
        }
        place.get_or_insert_with(|| Self {
            expansion: Expansion::of(given),
            spreads: Spreads::default(),
            length: 0.0,
        })
    }

    /// Gives it a length [s].
    pub(super) fn set_length(&mut self, length: f64) {
        (self.spreads, self.length) = (self.expansion.spreads(length), length);
    }
}

impl<const P: usize, const B: usize> Stretch<B> for Along<P> {
    fn length(&self) -> f64 {
        self.length
    }

    fn start(&self) -> [State; B] {
        [self.expansion.given.start; B]
    }

    fn states(&self, fraction: f64) -> [State; B] {
        [self.expansion.state(fraction * self.length); B]
    }
}

impl<const P: usize, const B: usize> Expanded<B> for Along<P> {
    fn shorten(&mut self, length: f64) {
        self.length = length;
    }

    fn fall(&self, known: (&World, &Scales), watched: &Watched, now: f64) -> Option<f64> {
        if self.expansion.stays(known.0, watched, &self.spreads) {
            return None;
        }
        self.expansion.fall(known, watched, (now, self.length))
    }

    fn bounds(&self, world: &World) -> Bounds {
        let (expansion, spreads) = (&self.expansion, &self.spreads);
        let given = &expansion.given;
        let force = expansion.force[0].abs() + expansion.friction[0].abs() + spreads.force + spreads.friction;
        let acceleration = world.gravity.norm() + force / given.mass;
        Bounds {
            horizon: self.length,
            acceleration,
            angular: expansion.most_angular(self.length),
            spin: expansion.spin[0].abs() + spreads.spin,
            speed: given.start.twist.velocity.norm() + acceleration * self.length,
            steady: None,
            left: None,
        }
    }

    fn slips(&self) -> f64 {
        value(&self.expansion.slip, self.length).abs()
    }

    fn fastest_within(&self) -> Option<f64> {
        let (slip, held) = (&self.expansion.slip, &self.expansion.given.held);
        let sign = match held.slip {
            Slip::Forward => 1.0,
            Slip::Backward => -1.0,
            Slip::Sticks | Slip::Open => return None,
        };
        let mut rate = [0.0; P];
        for i in 1..P {
            rate[i - 1] = sign * i as f64 * slip[i];
        }
        let at = first_fall(&rate, self.length).filter(|t| *t > 0.0)?;
        Some(value(slip, at).abs())
    }
}
