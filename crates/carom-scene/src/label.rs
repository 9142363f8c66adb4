//! Paths as people read them: what has no name of its own has its label beside its number.

use std::borrow::Cow;

/// A path with the label of its plate or wall beside it, where that goes by its number: paths count from 0, people from 1.
///
/// # Example
/// ```
/// use carom_scene::labelled;
/// assert_eq!(labelled("plate.1.slope"), "plate.1.slope (plate 2)");
/// assert_eq!(labelled("plate.lower.slope"), "plate.lower.slope");
/// ```
pub fn labelled(path: &str) -> Cow<'_, str> {
    match label_beside(path).as_str() {
        "" => Cow::Borrowed(path),
        label => Cow::Owned(format!("{path}{label}")),
    }
}

/// What stands beside a path: a space and the label in parentheses, or nothing.
///
/// # Example
/// ```
/// use carom_scene::label_beside;
/// assert_eq!((label_beside("wall.0.to.x"), label_beside("wall.left.to.x")), (" (wall 1)".into(), String::new()));
/// ```
pub fn label_beside(path: &str) -> String {
    label(path).map_or(String::new(), |label| format!(" ({label})"))
}

/// `plate 2` of `plate.1.slope`. No plate has a name that is another's number, so a number is always a place in the list.
fn label(path: &str) -> Option<String> {
    let mut parts = path.split('.');
    let kind = parts.next().filter(|kind| ["plate", "wall", "pin"].contains(kind))?;
    let number: usize = parts.next()?.parse().ok()?;
    Some(format!("{kind} {}", number.checked_add(1)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_goes_by_its_number_has_a_label() {
        assert_eq!(labelled("wall.0"), "wall.0 (wall 1)", "a wall by itself");
        for path in
            ["plate", "plate.lower.slope", "part.vertices.1.x", "contact.0.normal", "start.to_edge", ""]
        {
            assert_eq!(labelled(path), path, "{path:?} stands alone");
        }
    }
}
