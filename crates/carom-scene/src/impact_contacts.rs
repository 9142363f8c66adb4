//! The contacts of an impact: how many there are decides what can be asked of them.

use carom_impact::planar::end_states::EndState;
use carom_impact::planar::pivoting::Many;
use carom_impact::planar::{
    ContactSet, ImpactError, MOST_CONTACTS, Meeting, RigidBody, Several, Slip, Touch,
};
use carom_num::Vec2;
use carom_num::solve::solve_any;

/// As many contacts as an impact file may have.
pub const MOST_PIVOTED: usize = 24;

/// The contacts of an impact with their operator.
#[derive(Clone, Debug, PartialEq)]
pub enum ImpactContacts {
    /// Up to [`MOST_CONTACTS`]: walked in stages, and every end state is enumerated.
    Several(Box<Several>),
    /// Up to [`MOST_PIVOTED`]: one end state is found by pivoting.
    Many(Box<Many>),
}

impl ImpactContacts {
    /// Contacts of a free body.
    pub(crate) fn of_free_body(
        mass: f64,
        inertia: f64,
        (velocity, spin): (Vec2, f64),
        touches: &[Touch],
    ) -> Result<Self, ImpactError> {
        if touches.len() > MOST_CONTACTS {
            let set = Many::of_free_body(mass, inertia, velocity, spin, touches)?;
            return Ok(Self::Many(Box::new(set)));
        }
        Several::of_free_body(mass, inertia, velocity, spin, touches).map(Self::from)
    }

    /// Contacts between bodies.
    pub(crate) fn of_bodies(bodies: &[RigidBody], meetings: &[Meeting]) -> Result<Self, ImpactError> {
        if meetings.len() > MOST_CONTACTS {
            return Ok(Self::Many(Box::new(Many::of_bodies(bodies, meetings)?)));
        }
        Several::of_bodies(bodies, meetings).map(Self::from)
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Self::Several(set) => set.count,
            Self::Many(set) => set.count,
        }
    }

    /// Velocities (slip, normal) before [m/s].
    pub fn before(&self) -> Vec<[f64; 2]> {
        fn of<const N: usize, const M: usize>(set: &ContactSet<N, M>) -> Vec<[f64; 2]> {
            set.slip.iter().zip(&set.normal).map(|(t, n)| [*t, *n]).take(set.count).collect()
        }
        match self {
            Self::Several(set) => of(set),
            Self::Many(set) => of(set),
        }
    }
}

/// Pivots below this fraction of the largest entry are rounding.
const RANK: f64 = 1e-10;

/// True where other impulses give the same motion: the response to those that act, each slipping one with its friction, has a direction
/// that it does not answer to.
pub(crate) fn impulses_are_open(set: &Many, end: &EndState<MOST_PIVOTED>) -> bool {
    // (contact, along its tangent?)
    let mut acting: Vec<(usize, bool)> = vec![];
    for i in (0..set.count).filter(|&i| end.impulse[i][1] > 0.0) {
        acting.push((i, false));
        if end.guess[i].slip == Slip::Sticks && set.friction[i] > 0.0 {
            acting.push((i, true));
        }
    }
    let mut rows = [[0.0; 2 * MOST_PIVOTED]; 2 * MOST_PIVOTED];
    for (row, &(i, along)) in rows.iter_mut().zip(&acting) {
        for (entry, &(j, tangential)) in row.iter_mut().zip(&acting) {
            let b = &set.operator[i][j];
            let [t, n] = if along { [b.tt, b.tn] } else { [b.nt, b.nn] };
            *entry = if tangential { t } else { n + end.guess[j].slip.pull(set.friction[j]) * t };
        }
    }
    let none = [0.0; 2 * MOST_PIVOTED];
    solve_any(rows, none, acting.len(), RANK).is_none_or(|all| all.freedom > 0)
}

impl From<Several> for ImpactContacts {
    fn from(set: Several) -> Self {
        Self::Several(Box::new(set))
    }
}
