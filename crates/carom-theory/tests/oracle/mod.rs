//! Independent answers for the tests: arithmetic with twice the digits, a seeded stream of numbers, and a walk along the impact that
//! knows events but no classes.
#![allow(unreachable_pub, reason = "a module shared by test files")]

pub mod double;
pub mod two_points;
pub mod walk;

/// SplitMix64 (Steele, Lea and Flood 2014).
pub struct Stream(pub u64);

impl Stream {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform exponent of ten.
    pub fn decades(&mut self, low: f64, high: f64) -> f64 {
        libm::exp10(self.within(low, high))
    }

    pub fn sign(&mut self) -> f64 {
        if self.bits() & 1 == 0 { 1.0 } else { -1.0 }
    }

    pub fn one_of<const N: usize>(&mut self, choices: [f64; N]) -> f64 {
        choices[(self.bits() % N as u64) as usize]
    }
}
