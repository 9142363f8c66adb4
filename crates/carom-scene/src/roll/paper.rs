//! The states by which the literature numbers such a strike, and the same in words of contacts.
//!
//! Source: Polukoshko, Viba and others, "Simultaneous collisions of rigid bodies in more than one point": states 1–7 of the cylinder, 1–8 of the
//! prism, variants 1–4 of the rod.

use super::RollKind;
use carom_impact::planar::ContactState;
use carom_words::Words;

/// The state of a strike with one contact that is touched before and one that closes.
///
/// `compressed` and `after` hold what the two do when compression is over and in the end. Without a rebound the states of the end alone
/// decide; a rebound is numbered by the state of compression it follows, as long as the touched contact does what that state's number says.
pub(super) fn number(kind: RollKind, compressed: [ContactState; 2], after: [ContactState; 2]) -> Option<u8> {
    let separates = |state: ContactState| state == ContactState::Separates;
    if !separates(after[1]) {
        return plastic(kind, after);
    }
    let first = plastic(kind, compressed)?;
    // A contact that is struck again, or let go in restitution, has no number.
    if separates(compressed[0]) != separates(after[0]) {
        return None;
    }
    match (kind, first) {
        (RollKind::Cylinder, 1 | 2) => Some(5),
        (RollKind::Cylinder, 3) => Some(6),
        (RollKind::Cylinder, 4) => Some(7),
        (RollKind::Prism, 3) => Some(5),
        (RollKind::Prism, 4) => Some(6),
        (RollKind::Prism, 2) => Some(7),
        (RollKind::Prism, 1) => Some(8),
        (RollKind::Rod, 1) => Some(3),
        (RollKind::Rod, 2) => Some(4),
        _ => None,
    }
}

fn plastic(kind: RollKind, [touched, struck]: [ContactState; 2]) -> Option<u8> {
    use ContactState::{Separates, Slips, Sticks};
    Some(match (kind, touched, struck) {
        (_, _, Separates) => return None,
        (RollKind::Cylinder, Separates, Sticks) => 1,
        (RollKind::Cylinder, Separates, Slips) => 2,
        (RollKind::Cylinder, Sticks, Sticks) => 4,
        (RollKind::Cylinder, ..) => 3,
        (RollKind::Prism, Separates, Sticks) => 3,
        (RollKind::Prism, Separates, Slips) => 4,
        (RollKind::Prism, Sticks, Sticks) => 1,
        (RollKind::Prism, ..) => 2,
        (RollKind::Rod, Separates, _) => 2,
        (RollKind::Rod, ..) => 1,
    })
}

/// What the literature says of a state: `a` is the contact it turned about, `k` the one that closed.
pub(super) fn words(kind: RollKind, number: u8, a: &str, k: &str) -> String {
    let both = |then: &str| format!("neither {a} nor {k} separates, {then}");
    let leaves = |then: &str| format!("{a} separates, {then}");
    match (kind, number) {
        (RollKind::Cylinder, 1) => leaves(&format!("the sliding at {k} ends within compression")),
        (RollKind::Cylinder, 2) => leaves(&format!("{k} keeps sliding")),
        (RollKind::Cylinder, 3) => both("both slide and the body turns about its centre"),
        (RollKind::Cylinder, 4) => both("sliding ends and the motion stops"),
        (RollKind::Cylinder, 5) => "elastic after state 1 or 2: free plane motion".to_owned(),
        (RollKind::Cylinder, 6) => format!("elastic after state 3: {k} rebounds, {a} keeps"),
        (RollKind::Cylinder, 7) => format!("elastic after state 4: {k} rebounds, {a} keeps"),
        (RollKind::Prism, 1) => both("no sliding: the motion stops"),
        (RollKind::Prism, 2) => both("it slides along the plane"),
        (RollKind::Prism, 3) => leaves(&format!("{k} sticks: it turns about {k}")),
        (RollKind::Prism, 4) => leaves(&format!("{k} slides: plane motion")),
        (RollKind::Prism, 5) => leaves(&format!("{k} sticks and rebounds: plane motion")),
        (RollKind::Prism, 6) => leaves(&format!("{k} slides and rebounds: plane motion")),
        (RollKind::Prism, 7) => format!("{a} does not separate and slides, {k} rebounds: plane motion"),
        (RollKind::Prism, _) => format!("{a} does not separate or slide, {k} rebounds: it turns about {a}"),
        (RollKind::Rod, 1) => both("the motion ends"),
        (RollKind::Rod, 2) => leaves(&format!("the rod turns about {k}")),
        (RollKind::Rod, 3) => format!("{a} does not separate, {k} rebounds: the rod turns about {a}"),
        (_, _) => leaves(&format!("{k} rebounds: plane motion")),
    }
}

/// "separates at A, sticks at K"; what two contacts do alike is said once.
pub(super) fn in_contacts<'a>(contacts: impl Iterator<Item = (&'a str, ContactState)>) -> String {
    let mut said: Vec<(ContactState, Vec<&str>)> = vec![];
    for (name, state) in contacts {
        match said.last_mut() {
            Some((last, names)) if *last == state => names.push(name),
            _ => said.push((state, vec![name])),
        }
    }
    let parts: Vec<String> =
        said.iter().map(|(state, names)| format!("{} at {}", state.word(), names.join(" and "))).collect();
    parts.join(", ")
}
