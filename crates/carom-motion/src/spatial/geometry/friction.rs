//! What a plane does to supports that slide and strike.

use carom_impact::Law;
use thiserror::Error;

/// Coulomb friction and restitution between the supports of a body and the plane.
///
/// # Example
/// ```
/// use carom_motion::spatial::Friction;
/// let dry = Friction::new(0.3);
/// assert_eq!((dry.coefficient(7), dry.restitution(7)), (0.3, 0.0));
/// let bouncing = Friction::of_supports(vec![0.1, 0.5]).with_restitution(0.4);
/// assert_eq!((bouncing.coefficient(1), bouncing.restitution(1)), (0.5, 0.4));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    /// Of all supports, or of each.
    coefficients: Vec<f64>,
    /// Of all supports, or of each.
    restitutions: Vec<f64>,
    law: Law,
}

/// Numbers that no friction has.
///
/// # Example
/// A coefficient below zero would push what slides on.
/// ```
/// use carom_motion::spatial::{Friction, FrictionProblem, World, examples};
/// use carom_num::Vec3;
/// let rod = examples::rod();
/// let world = World::new(rod, Vec3::Z * -10.0).unwrap();
/// let problem = world.with_friction(Friction::new(-0.1)).unwrap_err();
/// assert_eq!(problem, FrictionProblem::Coefficient { value: -0.1 });
/// ```
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
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Friction;
    /// let friction = Friction::new(0.3);
    /// assert_eq!((friction.coefficient(0), friction.coefficient(5)), (0.3, 0.3));
    /// ```
    pub fn new(coefficient: f64) -> Self {
        Self::of_supports(vec![coefficient])
    }

    /// A friction coefficient for each support; impacts are plastic.
    ///
    /// # Example
    /// One leg of rubber, two of steel.
    /// ```
    /// use carom_motion::spatial::Friction;
    /// let friction = Friction::of_supports(vec![0.8, 0.2, 0.2]);
    /// assert_eq!((friction.coefficient(0), friction.coefficient(2)), (0.8, 0.2));
    /// ```
    pub fn of_supports(coefficients: Vec<f64>) -> Self {
        Self { coefficients, restitutions: vec![0.0], law: Law::Poisson }
    }

    /// The same with a coefficient of restitution, in [0, 1].
    ///
    /// # Example
    /// ```
    /// use carom_motion::spatial::Friction;
    /// let bouncing = Friction::new(0.3).with_restitution(0.5);
    /// assert_eq!((bouncing.coefficient(0), bouncing.restitution(0)), (0.3, 0.5));
    /// ```
    #[must_use]
    pub fn with_restitution(self, restitution: f64) -> Self {
        Self { restitutions: vec![restitution], ..self }
    }

    /// The same with a law of restitution; Poisson's is used where none is named.
    ///
    /// # Example
    /// ```
    /// use carom_impact::Law;
    /// use carom_motion::spatial::Friction;
    /// let friction = Friction::new(0.3).with_law(Law::Stronge);
    /// assert_eq!((friction.law(), friction.coefficient(0)), (Law::Stronge, 0.3));
    /// ```
    #[must_use]
    pub fn with_law(self, law: Law) -> Self {
        Self { law, ..self }
    }

    /// Friction coefficient of a support.
    ///
    /// # Example
    /// A support that has no coefficient of its own has none.
    /// ```
    /// use carom_motion::spatial::Friction;
    /// let friction = Friction::of_supports(vec![0.8, 0.2]);
    /// assert_eq!([0, 1, 2].map(|support| friction.coefficient(support)), [0.8, 0.2, 0.0]);
    /// ```
    pub fn coefficient(&self, support: usize) -> f64 {
        of_support(&self.coefficients, support)
    }

    /// Coefficient of restitution of a support.
    ///
    /// # Example
    /// Impacts are plastic where nothing else is said.
    /// ```
    /// use carom_motion::spatial::Friction;
    /// assert_eq!(Friction::new(0.3).restitution(0), 0.0);
    /// ```
    pub fn restitution(&self, support: usize) -> f64 {
        of_support(&self.restitutions, support)
    }

    /// With numbers of each support.
    pub(in crate::spatial) fn of_all(coefficients: Vec<f64>, restitutions: Vec<f64>, law: Law) -> Self {
        Self { coefficients, restitutions, law }
    }

    /// Law of restitution.
    ///
    /// # Example
    /// ```
    /// use carom_impact::Law;
    /// use carom_motion::spatial::Friction;
    /// assert_eq!(Friction::new(0.3).law(), Law::Poisson);
    /// ```
    pub fn law(&self) -> Law {
        self.law
    }

    /// Whether a body of so many supports can have it.
    pub(in crate::spatial) fn check(&self, supports: usize) -> Result<(), FrictionProblem> {
        let given = self.coefficients.len();
        if given != 1 && given != supports {
            return Err(FrictionProblem::Count { given, supports });
        }
        if let Some(&value) = self.coefficients.iter().find(|mu| !(mu.is_finite() && **mu >= 0.0)) {
            return Err(FrictionProblem::Coefficient { value });
        }
        match self.restitutions.iter().find(|value| !(0.0..=1.0).contains(*value)) {
            Some(&value) => Err(FrictionProblem::Restitution { value }),
            None => Ok(()),
        }
    }
}

/// The number of a support among those of each, or the one of all.
fn of_support(numbers: &[f64], support: usize) -> f64 {
    let own = if numbers.len() == 1 { 0 } else { support };
    numbers.get(own).copied().unwrap_or(0.0)
}
