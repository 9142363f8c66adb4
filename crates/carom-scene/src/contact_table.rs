//! Contacts of two materials by their names: `contact = "steel on steel, dry"`.

use crate::grammar::kind::{FRICTION, RESTITUTION};
use crate::quantity::{Kind, Quantity, Tolerance};
use serde::Deserialize;
use std::sync::LazyLock;

/// The table, with its sources.
const TABLE: &str = include_str!("contacts.toml");

static CONTACTS: LazyLock<Vec<NamedContact>> = LazyLock::new(|| {
    let read: Result<Contacts, _> = toml::from_str(TABLE);
    debug_assert!(read.is_ok(), "the table of contacts: {read:?}");
    read.map(|contacts| contacts.contact).unwrap_or_default()
});

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Contacts {
    contact: Vec<NamedContact>,
}

/// Friction and restitution of two materials: each from its lowest usual value to its highest.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct NamedContact {
    name: String,
    friction: [f64; 2],
    friction_source: String,
    restitution: [f64; 2],
    restitution_source: String,
}

impl NamedContact {
    /// The contact of this name.
    pub(crate) fn of_name(name: &str) -> Option<&'static Self> {
        CONTACTS.iter().find(|contact| contact.name == name)
    }

    pub(crate) fn friction(&self) -> Quantity {
        within(self.friction, FRICTION)
    }

    pub(crate) fn restitution(&self) -> Quantity {
        within(self.restitution, RESTITUTION)
    }

    /// What is taken for it, and from where; `path` is the key that names it.
    pub(crate) fn told(&self, path: &str) -> String {
        let Self { name, friction, friction_source, restitution, restitution_source } = self;
        let range = |[low, high]: &[f64; 2]| format!("{low} to {high}");
        format!(
            "{path}: {name}: friction {} ({friction_source}); restitution {} ({restitution_source})",
            range(friction),
            range(restitution)
        )
    }
}

/// As if `{ low, high }` were written: a run takes the middle.
fn within([low, high]: [f64; 2], kind: Kind) -> Quantity {
    let tolerance = Some(Tolerance::Uniform { low, high });
    Quantity { tolerance, ..Quantity::default_of(0.5 * (low + high), kind) }
}

/// The names of the table, in its order.
pub(crate) fn contact_names() -> Vec<&'static str> {
    CONTACTS.iter().map(|contact| contact.name.as_str()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_contact_of_the_table_is_one() {
        assert!(CONTACTS.len() >= 12, "a good dozen");
        let names = contact_names();
        for (i, contact) in CONTACTS.iter().enumerate() {
            let name = &contact.name;
            assert!(!names[..i].contains(&name.as_str()), "{name} is there once");
            assert!(name.contains(" on ") && name.contains(", "), "{name}: materials and state");
            for ([low, high], kind) in [(contact.friction, FRICTION), (contact.restitution, RESTITUTION)] {
                assert!(low < high && kind.holds(low) && kind.holds(high), "{name}: {low} to {high}");
            }
            assert!(!contact.friction_source.is_empty() && !contact.restitution_source.is_empty(), "{name}");
        }
    }
}
