//! A printed entry against ours.

use crate::table::{Coarse, Row, Verdict};
use crate::value::Value;

/// Half of the last printed digit, and a little for entries that are themselves rounded from a half.
const HALF_DIGIT: f64 = 0.5001;

/// What a comparison says.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// From the numbers; the table's word only where the numbers bear it out.
    pub verdict: Verdict,
    /// Ours less what is printed, in the row's unit.
    pub difference: Option<f64>,
    /// Why; empty where it agrees.
    pub reason: String,
}

/// Judges one row.
///
/// A row that is declared a misprint, wrong or beyond the model must disagree as it is printed, and what is meant must agree or be coarse; otherwise the row *fails*.
/// One that agrees as it is printed is none of these, whatever is declared.
///
/// # Example
/// ```
/// use carom_validation::{Value, Verdict, compare, table};
/// let table = table("feeder_table_1")?;
/// let row = table.rows.iter().find(|row| row.key == "case_2.tip.t").expect("in the table");
/// assert_eq!(row.printed, "1.169"); // its decimal point is lost
/// let found = compare(row, table.coarse.as_ref(), &Value::Number(0.1167135));
/// assert_eq!(found.verdict, Verdict::Misprint);
/// assert_eq!(compare(row, table.coarse.as_ref(), &Value::Number(1.169)).verdict, Verdict::Agrees);
/// # Ok::<(), carom_validation::ValidationError>(())
/// ```
pub fn compare(row: &Row, coarse: Option<&Coarse>, ours: &Value) -> Compared {
    let as_printed = measure(row, &row.printed, coarse, ours);
    let difference = as_printed.difference;
    let plain = |found: Measured| Compared { verdict: found.verdict, difference, reason: found.reason };
    if !row.expected.needs_evidence() || as_printed.verdict == Verdict::Agrees {
        return plain(as_printed);
    }
    let meant = row.meant.as_deref().map(|meant| (meant, measure(row, meant, coarse, ours)));
    let borne_out = match &meant {
        None => row.expected != Verdict::Misprint && !row.evidence.is_empty(),
        Some((_, meant)) => meant.verdict != Verdict::Fails,
    };
    if !borne_out {
        let which = meant.map_or("nothing is said of what is right".to_owned(), |(text, found)| {
            format!("what is said to be right, {text}, is not: {}", found.reason)
        });
        return Compared { verdict: Verdict::Fails, difference, reason: which };
    }
    let reason = match meant {
        Some((text, found)) if row.expected == Verdict::Misprint => {
            let off = if found.reason.is_empty() { found.verdict.word().to_owned() } else { found.reason };
            format!("{}: {text} is meant ({off})", row.evidence)
        }
        _ => row.evidence.clone(),
    };
    Compared { verdict: row.expected, difference, reason }
}

/// An entry against ours, whatever is known of it.
struct Measured {
    verdict: Verdict,
    difference: Option<f64>,
    reason: String,
}

fn measure(row: &Row, entry: &str, coarse: Option<&Coarse>, ours: &Value) -> Measured {
    let fails = |reason: String| Measured { verdict: Verdict::Fails, difference: None, reason };
    match (ours, number(entry)) {
        (Value::Number(ours), Some(value)) => in_numbers(row, entry, value, coarse, *ours),
        (Value::Word(ours), _) if ours == entry => {
            Measured { verdict: Verdict::Agrees, difference: None, reason: String::new() }
        }
        (Value::Word(ours), _) => fails(format!("ours is {ours}")),
        (Value::Number(_), None) => fails("what is printed is no number".to_owned()),
    }
}

fn in_numbers(row: &Row, entry: &str, value: f64, coarse: Option<&Coarse>, ours: f64) -> Measured {
    let unit = last_digit(entry);
    let off = (value - ours).abs();
    let share = format!("{:.2} % off", 100.0 * off / ours.abs());
    let exact = row.tolerance.as_ref().map_or(HALF_DIGIT * unit, |tolerance| tolerance.within);
    let (verdict, reason) = match coarse {
        _ if off <= exact => (Verdict::Agrees, String::new()),
        Some(coarse) if off <= coarse.share * ours.abs() => {
            (Verdict::Coarse, format!("{share}: {}", coarse.why))
        }
        Some(_) if off <= unit && row.tolerance.is_none() => {
            (Verdict::Coarse, format!("{share}: one in its last digit"))
        }
        _ => (Verdict::Fails, share),
    };
    Measured { verdict, difference: Some(ours - value), reason }
}

/// An entry as a number; a comma may stand for the point.
pub(crate) fn number(entry: &str) -> Option<f64> {
    entry.replace(',', ".").parse().ok()
}

/// One in the last digit of an entry.
fn last_digit(entry: &str) -> f64 {
    let mantissa = entry.split(['e', 'E']).next().unwrap_or(entry);
    let power: i32 = entry.split_once(['e', 'E']).and_then(|(_, power)| power.parse().ok()).unwrap_or(0);
    let decimals = mantissa.split_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len());
    let point = (0..decimals).fold(1.0, |unit, _| unit / 10.0);
    let ten = if power < 0 { 0.1 } else { 10.0 };
    (0..power.unsigned_abs()).fold(point, |unit, _| unit * ten)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Tolerance;

    fn row(printed: &str, expected: Verdict) -> Row {
        Row {
            key: "k".to_owned(),
            letter: String::new(),
            what: "a quantity".to_owned(),
            unit: "m".to_owned(),
            printed: printed.to_owned(),
            expected,
            meant: None,
            evidence: String::new(),
            tolerance: None,
        }
    }

    fn coarse() -> Coarse {
        Coarse { share: 0.02, why: "long steps".to_owned() }
    }

    fn verdict(row: &Row, ours: f64) -> Verdict {
        compare(row, Some(&coarse()), &Value::Number(ours)).verdict
    }

    #[test]
    fn the_last_digit_decides() {
        assert_eq!(verdict(&row("0.423", Verdict::Agrees), 0.423_02), Verdict::Agrees, "rounds to it");
        assert_eq!(verdict(&row("0,269", Verdict::Agrees), 0.2684), Verdict::Coarse, "one in its last digit");
        assert_eq!(verdict(&row("-1.0", Verdict::Agrees), 1.0), Verdict::Fails, "the sign");
        let exact = compare(&row("0.50", Verdict::Agrees), None, &Value::Number(0.506));
        assert_eq!(exact.verdict, Verdict::Fails, "without a share nothing is coarse");
        assert_eq!(last_digit("-1.20e-3"), 1e-5, "powers of ten count");
    }

    #[test]
    fn a_tolerance_takes_the_place_of_the_last_digit() {
        let zero = Tolerance { within: 1e-9, why: "exact".to_owned() };
        let row = Row { tolerance: Some(zero), ..row("0", Verdict::Agrees) };
        assert_eq!(verdict(&row, 1e-12), Verdict::Agrees, "rounding");
        assert_eq!(verdict(&row, 0.1), Verdict::Fails, "half of the digit would hide it");
    }

    #[test]
    fn a_misprint_must_be_one() {
        let meant = |text: &str| Some(text.to_owned());
        let evidence = "its point is lost".to_owned();
        let lost = Row { meant: meant("0.1169"), evidence, ..row("1.169", Verdict::Misprint) };
        let found = compare(&lost, Some(&coarse()), &Value::Number(0.116_713_5));
        assert_eq!(found.verdict, Verdict::Misprint, "{found:?}");
        assert_eq!(found.reason, "its point is lost: 0.1169 is meant (0.16 % off: long steps)");
        assert_eq!(verdict(&lost, 1.169), Verdict::Agrees, "printed right after all");
        assert_eq!(verdict(&lost, 0.5), Verdict::Fails, "neither is right");
    }

    #[test]
    fn an_error_needs_evidence() {
        let bare = row("1.0", Verdict::Wrong);
        assert_eq!(verdict(&bare, 2.0), Verdict::Fails, "nothing says why");
        let evidence = "breaks the balance of momentum".to_owned();
        assert_eq!(verdict(&Row { evidence, ..bare }, 2.0), Verdict::Wrong, "said");
    }

    #[test]
    fn what_was_measured_may_be_beyond_the_model() {
        let measured = Row { evidence: "rubber gives way".to_owned(), ..row("0.67", Verdict::Beyond) };
        assert_eq!(verdict(&measured, 1.0), Verdict::Beyond, "said");
        assert_eq!(verdict(&measured, 0.67), Verdict::Agrees, "not so after all");
        assert_eq!(verdict(&row("0.67", Verdict::Beyond), 1.0), Verdict::Fails, "nothing says why");
    }

    #[test]
    fn words_agree_or_do_not() {
        let word = Value::Word("slides".to_owned());
        assert_eq!(compare(&row("slides", Verdict::Agrees), None, &word).verdict, Verdict::Agrees, "same");
        assert_eq!(compare(&row("sticks", Verdict::Agrees), None, &word).verdict, Verdict::Fails, "other");
    }
}
