//! The worst of many drops: what limits on speed and time have to hold against, where quantities vary.

use super::judge::speeds;
use carom_feeder::Run;
use std::sync::atomic::{AtomicU64, Ordering};

/// The largest speeds and the longest time of drops, whatever order and thread they come from.
///
/// # Example
/// A disc slides 2 m down at 6 m/s², then falls 1.25 m: it strikes with `√(2·6·2 + 2·10·1.25)`, 7 m/s.
/// ```
/// # use {carom_feeder::*, carom_impact::planar::Law, carom_motion::planar::*, carom_num::Vec2};
/// # let shape = Shape::new(vec![Vec2::ZERO], 0.06).unwrap();
/// # let part = Part { kind: PartKind::Disc, body: Body { shape, mass: 1.0, inertia: 0.0018 } };
/// # let plate = |name: &str, uphill, edge| Plate {
/// #     name: name.into(), uphill, edge, friction: 0.0, restitution: 0.0, unbounded: false,
/// # };
/// # let slope = plate("slope", Vec2::new(-4.0, 3.0), Vec2::ZERO);
/// # let tray = plate("tray", Vec2::new(-1.0, -1.262), Vec2::new(9.0, -1.262));
/// # let start = Start { to_edge: 2.0, speed: 0.0, face: 0 };
/// # let (gravity, stop, law, walls) = (10.0, Stop::Landed, Law::Poisson, vec![]);
/// # let feeder = Feeder { gravity, stop, law, part, start, plates: vec![slope, tray], walls };
/// use carom_study::design::Worst;
/// let worst = Worst::default();
/// worst.see(&feeder.verdict().unwrap());
/// worst.see(&carom_feeder::Run { landings: vec![], ..feeder.verdict().unwrap() });
/// assert!((worst.found().impact_speed - 7.0).abs() < 1e-12);
/// assert_eq!(worst.found().drops, 2);
/// ```
#[derive(Debug, Default)]
pub struct Worst {
    /// Bits of numbers that are not negative: these are in the order of the numbers.
    measures: [AtomicU64; 3],
    drops: AtomicU64,
}

/// The worst of the drops that were seen.
///
/// # Example
/// ```
/// use carom_study::design::{Extremes, Worst};
/// assert_eq!(Worst::default().found(), Extremes::default());
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extremes {
    /// The hardest strike on a plate, the first or a later one [m/s].
    pub impact_speed: f64,
    /// The largest slip velocity on a plate [m/s].
    pub sliding_speed: f64,
    /// When the last of the runs ends [s].
    pub time: f64,
    /// How many drops were seen.
    pub drops: u64,
}

impl Worst {
    /// Looks at a drop.
    pub fn see(&self, run: &Run) {
        let [impact, slide] = speeds(run);
        for (most, value) in self.measures.iter().zip([impact, slide, run.end_time]) {
            if value > 0.0 {
                most.fetch_max(value.to_bits(), Ordering::Relaxed);
            }
        }
        self.drops.fetch_add(1, Ordering::Relaxed);
    }

    /// The worst of those seen so far.
    pub fn found(&self) -> Extremes {
        let [impact_speed, sliding_speed, time] =
            [0, 1, 2].map(|i: usize| f64::from_bits(self.measures[i].load(Ordering::Relaxed)));
        Extremes { impact_speed, sliding_speed, time, drops: self.drops.load(Ordering::Relaxed) }
    }
}
