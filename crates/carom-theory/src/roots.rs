//! Where something ends along a line.

/// Halvings of an interval. 64 lead to neighbouring numbers beside its longer end; the rest is for borders close to zero.
const HALVINGS: u32 = 128;

/// The border between `inside`, where `holds`, and `outside`, where it does not: the last number found inside.
///
/// With several borders between them it is one of these.
pub(crate) fn border(holds: impl Fn(f64) -> bool, mut inside: f64, mut outside: f64) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inside + outside);
        if middle == inside || middle == outside {
            break;
        }
        *(if holds(middle) { &mut inside } else { &mut outside }) = middle;
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_border_is_found_to_the_last_digit_from_either_side() {
        let root = border(|x| x * x <= 2.0, 0.0, 2.0);
        assert!(root * root <= 2.0 && root.next_up() * root.next_up() > 2.0, "from below: {root}");
        let root = border(|x| x * x >= 2.0, 2.0, 0.0);
        assert!(root * root >= 2.0 && root.next_down() * root.next_down() < 2.0, "from above: {root}");
    }

    #[test]
    fn what_holds_nowhere_but_at_the_start_ends_there() {
        assert!(border(|_| false, 0.0, 1.0).abs() < 1e-38, "2 to the power −128 is left");
        assert_eq!(border(|_| false, 1.0, 2.0), 1.0, "at the start");
    }
}
