//! A printed value against ours, with the reason in words.

use super::printed::{Entry, Remark};
use crate::table::fixed;

/// A printed value may be off by this share, or by one in its last digit, where it is called coarse.
const COARSE: f64 = 0.02;

/// What the comparison says.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Compared {
    pub(super) printed: &'static str,
    /// Ours less what is printed.
    pub(super) difference: String,
    /// agrees, coarse in print, misprint, wrong in print or fails.
    pub(super) verdict: &'static str,
    /// Why; empty where it agrees.
    pub(super) reason: String,
}

pub(super) fn compare(entry: &Entry, ours: f64, digits: usize) -> Compared {
    let printed = entry.printed;
    let difference = number(printed).map_or("-".to_owned(), |value| fixed(ours - value, digits));
    let (verdict, reason) = match entry.remark {
        Remark::None => judge(printed, ours),
        Remark::Misprint(meant, why) => {
            let (verdict, reason) = judge(meant, ours);
            let off = if reason.is_empty() { verdict.to_owned() } else { reason };
            ("misprint", format!("{why}: {meant} is meant ({off})"))
        }
        Remark::Wrong(why) => ("wrong in print", why.to_owned()),
    };
    Compared { printed, difference, verdict, reason }
}

fn number(printed: &str) -> Option<f64> {
    printed.replace(',', ".").parse().ok()
}

/// Agrees to the last printed digit, is coarse, or fails.
fn judge(printed: &str, ours: f64) -> (&'static str, String) {
    let Some(value) = number(printed) else { return ("fails", "what is printed is no number".to_owned()) };
    let decimals = printed.split_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
    let last_digit = (0..decimals).fold(1.0, |unit, _| unit / 10.0);
    let off = (value - ours).abs();
    let share = format!("{:.2} % off", 100.0 * off / ours.abs());
    if off <= 0.5001 * last_digit {
        ("agrees", String::new())
    } else if off <= COARSE * ours.abs() {
        ("coarse in print", format!("{share}: the paper's integration is coarse"))
    } else if off <= last_digit {
        ("coarse in print", format!("{share}: one in its last digit"))
    } else {
        ("fails", share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_digit_decides() {
        assert_eq!(judge("0.423", 0.42302).0, "agrees");
        assert_eq!(judge("0,269", 0.2684).0, "coarse in print");
        assert_eq!(judge("-1.0", 1.0).0, "fails");
    }

    #[test]
    fn a_lost_point_is_judged_by_what_is_meant() {
        let entry = Entry { printed: "1.169", remark: Remark::Misprint("0.1169", "its point is lost") };
        let found = compare(&entry, 0.116_713_5, 4);
        assert_eq!((found.verdict, found.difference.as_str()), ("misprint", "-1.0523"));
        assert_eq!(
            found.reason,
            "its point is lost: 0.1169 is meant (0.16 % off: the paper's integration is coarse)"
        );
    }
}
