//! What a plane does to supports that slide and strike.

use carom_impact::planar::Law;
use thiserror::Error;

/// Coulomb friction and restitution between the supports of a body and the plane.
///
/// # Example
/// ```
/// use carom_motion::spatial::Friction;
/// let dry = Friction::new(0.3);
/// assert_eq!((dry.coefficient(7), dry.restitution()), (0.3, 0.0));
/// let bouncing = Friction::of_supports(vec![0.1, 0.5]).with_restitution(0.4);
/// assert_eq!((bouncing.coefficient(1), bouncing.restitution()), (0.5, 0.4));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    coefficients: Vec<f64>,
    restitution: f64,
    law: Law,
}

/// Numbers that no friction has.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum FrictionProblem {
    /// A friction coefficient that is not allowed.
    #[error("the friction coefficient is {value}: it must be finite and >= 0")]
    Coefficient {
        /// What it is.
        value: f64,
    },
    /// There are coefficients for another number of supports than the body has.
    #[error("{given} friction coefficients for {supports} supports")]
    Count {
        /// How many coefficients there are.
        given: usize,
        /// How many supports.
        supports: usize,
    },
    /// A coefficient of restitution that is not allowed.
    #[error("the coefficient of restitution is {value}: it must be in [0, 1]")]
    Restitution {
        /// What it is.
        value: f64,
    },
}

impl Friction {
    /// The same friction coefficient at every support; impacts are plastic.
    pub fn new(coefficient: f64) -> Self {
        Self::of_supports(vec![coefficient])
    }

    /// A friction coefficient for each support; impacts are plastic.
    pub fn of_supports(coefficients: Vec<f64>) -> Self {
        Self { coefficients, restitution: 0.0, law: Law::Poisson }
    }

    /// The same with a coefficient of restitution, in [0, 1].
    #[must_use]
    pub fn with_restitution(self, restitution: f64) -> Self {
        Self { restitution, ..self }
    }

    /// The same with a law of restitution; Poisson's is used where none is named.
    #[must_use]
    pub fn with_law(self, law: Law) -> Self {
        Self { law, ..self }
    }

    /// Friction coefficient of a support.
    pub fn coefficient(&self, support: usize) -> f64 {
        let own = if self.coefficients.len() == 1 { 0 } else { support };
        self.coefficients.get(own).copied().unwrap_or(0.0)
    }

    /// Coefficient of restitution.
    pub fn restitution(&self) -> f64 {
        self.restitution
    }

    /// Law of restitution.
    pub fn law(&self) -> Law {
        self.law
    }

    /// Whether a body of so many supports can have it.
    pub(super) fn check(&self, supports: usize) -> Result<(), FrictionProblem> {
        let given = self.coefficients.len();
        if given != 1 && given != supports {
            return Err(FrictionProblem::Count { given, supports });
        }
        if let Some(&value) = self.coefficients.iter().find(|mu| !(mu.is_finite() && **mu >= 0.0)) {
            return Err(FrictionProblem::Coefficient { value });
        }
        let value = self.restitution;
        if (0.0..=1.0).contains(&value) { Ok(()) } else { Err(FrictionProblem::Restitution { value }) }
    }
}
