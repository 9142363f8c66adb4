//! How sure an outcome is: the end states that the laws allow, beside the one that the staged impact reaches.

use carom_impact::planar::sharing::{self, Sharing};
#[cfg(doc)]
use carom_impact::planar::staged;
use carom_impact::planar::{ContactSet, end_states};
use carom_impact::{ImpactError, Law};

/// How many end states there are, and whether the staged impact ends in one of them.
///
/// # Example
/// A ball that slides with 1 m/s and is struck at its lowest point slides on or sticks, but not both.
/// ```
/// use carom_impact::{Law, planar::{ContactSet2, Touch}};
/// use carom_num::Vec2;
/// use carom_study::Ends;
/// let (arm, normal) = (Vec2::new(0.0, -1.0), Vec2::new(0.0, 1.0));
/// let lowest = Touch { arm, normal, friction: 0.3, restitution: 0.5 };
/// let ball = ContactSet2::of_free_body(1.0, 0.5, Vec2::new(1.0, -1.0), 0.0, &[lowest])?;
/// assert_eq!(Ends::of(&ball, Law::Poisson)?, Ends { count: 1, reached: true, branches: 1 });
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ends {
    /// End states that the laws allow, judged at the end alone.
    pub count: usize,
    /// True where the staged impact ends in one of them; else the end depends on the way there.
    pub reached: bool,
    /// Largest number of consistent ways on that the staged impact met: above 1 it chose.
    pub branches: usize,
}

impl Ends {
    /// Of an impact.
    ///
    /// # Errors
    /// As [`staged::resolve`].
    ///
    /// # Example
    /// One contact has one end state.
    /// ```
    /// use carom_impact::{Law, planar::{ContactSet2, Touch}};
    /// use carom_num::Vec2;
    /// let heel = Touch { arm: Vec2::new(0.0, -1.0), normal: Vec2::new(0.0, 1.0), friction: 0.3, restitution: 0.5 };
    /// let set = ContactSet2::of_free_body(1.0, 0.4, Vec2::new(1.0, -1.0), 0.0, &[heel])?;
    /// assert_eq!(carom_study::Ends::of(&set, Law::Poisson)?.count, 1);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn of<const N: usize, const M: usize>(set: &ContactSet<N, M>, law: Law) -> Result<Self, ImpactError> {
        Self::shared(set, law, &Sharing::Together)
    }

    /// As [`Ends::of`], of contacts that share the impact by a convention.
    ///
    /// # Errors
    /// As [`sharing::resolve`].
    ///
    /// # Example
    /// One contact shares with nobody.
    /// ```
    /// use carom_impact::{Law, planar::{ContactSet2, Touch, sharing::Sharing}};
    /// use carom_num::Vec2;
    /// use carom_study::Ends;
    /// let heel = Touch { arm: Vec2::new(0.0, -1.0), normal: Vec2::new(0.0, 1.0), friction: 0.3, restitution: 0.5 };
    /// let set = ContactSet2::of_free_body(1.0, 0.4, Vec2::new(1.0, -1.0), 0.0, &[heel])?;
    /// assert_eq!(Ends::shared(&set, Law::Poisson, &Sharing::InSequence)?, Ends::of(&set, Law::Poisson)?);
    /// # Ok::<(), carom_impact::ImpactError>(())
    /// ```
    pub fn shared<const N: usize, const M: usize>(
        set: &ContactSet<N, M>,
        law: Law,
        sharing: &Sharing<N>,
    ) -> Result<Self, ImpactError> {
        let outcome = sharing::resolve(set, law, sharing)?;
        let found = end_states::found(set, law);
        let reached = found.iter().any(|end| end.moves_as(set, &outcome.velocity));
        Ok(Self { count: found.len(), reached, branches: outcome.branches })
    }
}
