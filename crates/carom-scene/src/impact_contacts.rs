//! The contacts of an impact: how many there are decides what can be asked of them.

use carom_impact::ImpactError;
use carom_impact::planar::pivoting::ContactSet24;
use carom_impact::planar::{ContactSet, ContactSet6, MOST_CONTACTS, Meeting, RigidBody, Touch};
use carom_num::Vec2;

/// As many contacts as an impact file may have.
///
/// # Example
/// A table on 24 legs is asked, one on 25 is not.
/// ```
/// use carom_scene::*;
/// let legs = |count: usize| {
///     let leg = |i: usize| format!("{{ point = [{i}, -1], normal = [0, 1], friction = 0.3 }}");
///     let legs = (0..count).map(leg).collect::<Vec<_>>().join(", ");
///     let body = "body = { mass = 2, inertia = 9, velocity = [0, -3] }";
///     ImpactProblem::parse("table.toml", &format!("{body}\ncontact = [{legs}]"))
/// };
/// assert_eq!(legs(MOST_PIVOTED)?.contacts.count(), 24);
/// assert!(legs(MOST_PIVOTED + 1).is_err());
/// # Ok::<(), carom_scene::Problems>(())
/// ```
pub const MOST_PIVOTED: usize = 24;

/// The contacts of an impact with their operator.
///
/// # Example
/// ```
/// use carom_scene::*;
/// let ball = ImpactProblem::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// assert!(matches!(ball.contacts, ImpactContacts::Several(_)));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum ImpactContacts {
    /// Up to [`MOST_CONTACTS`]: walked in stages, and every end state is enumerated.
    Several(Box<ContactSet6>),
    /// Up to [`MOST_PIVOTED`]: one end state is found by pivoting.
    Many(Box<ContactSet24>),
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
            let set = ContactSet24::of_free_body(mass, inertia, velocity, spin, touches)?;
            return Ok(Self::Many(Box::new(set)));
        }
        ContactSet6::of_free_body(mass, inertia, velocity, spin, touches).map(Self::from)
    }

    /// Contacts between bodies.
    pub(crate) fn of_bodies(bodies: &[RigidBody], meetings: &[Meeting]) -> Result<Self, ImpactError> {
        if meetings.len() > MOST_CONTACTS {
            return Ok(Self::Many(Box::new(ContactSet24::of_bodies(bodies, meetings)?)));
        }
        ContactSet6::of_bodies(bodies, meetings).map(Self::from)
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

impl From<ContactSet6> for ImpactContacts {
    fn from(set: ContactSet6) -> Self {
        Self::Several(Box::new(set))
    }
}
