//! Comparing the engine's strikes with closed forms, and counting them by name.
//!
//! *Scales.* Velocities are compared relative to that before and what the largest impulse makes of it where it acts, impulses relative to
//! what makes that velocity.

use super::Rocking;
use carom_theory::rocking::{Strike, Tangential};
use std::collections::BTreeMap;

/// Largest scaled difference.
pub const AGREEMENT: f64 = 1e-10;

/// The largest scaled differences of motion and of impulses between the engine and a closed form.
///
/// Where it ends wedged, a push along the chord between the contacts changes nothing and is not determined: impulses are compared but
/// for that.
pub fn differences(body: &Rocking, strike: &Strike, wedged: bool) -> [f64; 2] {
    let out = body.strike();
    let [x, y] = strike.velocity;
    let velocity = body.velocities([x, y, strike.roll_rate]);
    let mut off = [0, 1].map(|i| [out.impulse[i][0], out.impulse[i][1] - strike.normal[i]]);
    match strike.tangential {
        Tangential::Each([a, k]) => (off[0][0], off[1][0]) = (off[0][0] - a, off[1][0] - k),
        Tangential::Sum(sum) => (off[0][0], off[1][0]) = (off[0][0] + off[1][0] - sum, 0.0),
    }
    if wedged {
        let chord = body.chord();
        let along: f64 = (0..4).map(|i| off[i / 2][i % 2] * chord[i / 2][i % 2]).sum();
        for i in 0..4 {
            off[i / 2][i % 2] -= along * chord[i / 2][i % 2];
        }
    }
    let most = |all: &[[f64; 2]; 2]| all.iter().flatten().fold(0.0, |m: f64, v| m.max(v.abs()));
    let response = body.response();
    let largest = strike.normal[0].max(strike.normal[1]);
    let speed = body.speed() + response * largest;
    let slower = [0, 1].map(|i| [0, 1].map(|axis| out.velocity[i][axis] - velocity[i][axis]));
    // What is left of impulses that cancel is relative to them.
    let pressed = if wedged { most(&out.impulse) } else { 0.0 };
    [most(&slower) / speed, most(&off) / (speed / response + pressed)]
}

/// Counts by name, and the worst agreement.
#[derive(Debug, Default)]
pub struct Tally {
    pub counts: BTreeMap<String, usize>,
    pub worst: [f64; 2],
}

impl Tally {
    pub fn count(&mut self, name: &str) {
        *self.counts.entry(name.to_owned()).or_default() += 1;
    }

    pub fn of(&self, name: &str) -> usize {
        self.counts.get(name).copied().unwrap_or(0)
    }

    /// Compares, and counts the case under `name`.
    pub fn compare(&mut self, name: &str, body: &Rocking, strike: &Strike, wedged: bool) {
        self.compare_within(AGREEMENT, name, body, strike, wedged);
    }

    pub fn compare_within(&mut self, within: f64, name: &str, body: &Rocking, strike: &Strike, wedged: bool) {
        let found = differences(body, strike, wedged);
        for (kept, new) in self.worst.iter_mut().zip(found) {
            assert!(new <= within, "{name}: {found:?} {body:?}\n{strike:?}\n{:?}", body.strike());
            *kept = kept.max(new);
        }
        self.count(name);
    }
}
