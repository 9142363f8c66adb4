//! Impulses of compression that are open, and what restitution makes of them.
//!
//! A body in the plane has three velocities. Where more than three reactions hold it at the end of compression, many sets of impulses give
//! the same motion: the *share* of each contact is open. Without restitution this is of no consequence. With it, contact i owes `eᵢ Pᵢ`,
//! Pᵢ its impulse of compression, so that the motion after depends on the share that is taken.
//!
//! [`staged::resolve`] takes the member that is farthest from every inequality ([`Share::Middle`]) and marks the contacts in
//! [`StagedOutcome::open_share`]. [`outcomes`] tells what the ends of the shares leave.

#[cfg(test)]
mod tests;

use super::sharing;
use super::staged::{self, StagedOutcome};
use crate::planar::contacts::set::ContactSet;
use crate::{ImpactError, Law};

/// Which member of an open family of impulses is taken.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Share {
    /// The member whose smallest slack is largest; of contacts that wedge the body, the smallest member.
    #[default]
    Middle,
    /// This contact takes the least normal impulse that the laws allow at every stage.
    Least(usize),
    /// This contact takes the largest normal impulse that the laws allow; where they set no limit, some more than it must.
    Most(usize),
}

/// The outcomes in which a contact takes its least or its largest share, where these move otherwise than [`staged::resolve`] says. Empty
/// where no share is open, or where none changes the motion.
///
/// Each contact of [`StagedOutcome::open_share`] takes its least share, then its largest; of outcomes that move alike the first is listed.
/// Shares in between give motions in between, as long as restitution goes through the same stages.
///
/// # Errors
/// As [`staged::resolve`]; an end without an answer of its own is left out.
///
/// # Example
/// A ball between a floor and a wall, struck once into the corner: two contacts share nothing that is open.
/// ```
/// use carom_impact::{Law, planar::{ContactSet2, Touch, share}};
/// use carom_num::Vec2;
/// let touch = |x: f64, y: f64| Touch {
///     arm: Vec2::new(x, y), normal: Vec2::new(-x, -y), friction: 0.2, restitution: 0.5,
/// };
/// let corner = [touch(0.0, -1.0), touch(1.0, 0.0)];
/// let ball = ContactSet2::of_free_body(1.0, 0.4, Vec2::new(1.0, -1.0), 0.0, &corner)?;
/// assert!(share::outcomes(&ball, Law::Poisson)?.is_empty());
/// # Ok::<(), carom_impact::ImpactError>(())
/// ```
pub fn outcomes<const N: usize, const M: usize>(
    set: &ContactSet<N, M>,
    law: Law,
) -> Result<Vec<(Share, StagedOutcome<N>)>, ImpactError> {
    let taken = staged::resolve(set, law)?;
    let open = (0..set.count).filter(|&i| taken.open_share[i]);
    let ends = open.flat_map(|i| [Share::Least(i), Share::Most(i)]);
    let mut found: Vec<(Share, StagedOutcome<N>)> = vec![];
    for share in ends {
        let Ok(out) = staged::resolve_as(set, law, share) else { continue };
        let known = |other: &StagedOutcome<N>| sharing::alike(set, &out, other);
        if !known(&taken) && !found.iter().any(|(_, other)| known(other)) {
            found.push((share, out));
        }
    }
    Ok(found)
}
