//! Numbers as text for people: real minus signs, chosen digits. Never "NaN".

/// What stands where a number is not finite.
const NO_NUMBER: &str = "–";

/// The decimal exponent of `x` rounded to `digits` significant digits; 0 for zero.
pub fn exponent(x: f64, digits: usize) -> i32 {
    let text = format!("{:.*e}", digits.saturating_sub(1), x);
    text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}

/// `x` with a fixed number of decimals.
pub fn fixed(x: f64, decimals: usize) -> String {
    if !x.is_finite() {
        return NO_NUMBER.to_owned();
    }
    let text = format!("{x:.decimals$}");
    let is_zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
    match text.strip_prefix('-') {
        Some(rest) if is_zero => rest.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

/// A fixed number of digits with an ASCII minus, without the sign of a zero, and a plain 0: for terminals.
///
/// # Example
/// ```
/// use carom_words::number::ascii;
/// assert_eq!((ascii(-1.5, 2), ascii(-0.001, 2)), ("-1.50".to_owned(), "0".to_owned()));
/// ```
pub fn ascii(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) { "0".to_owned() } else { text }
}

/// A fixed number of digits with its sign, the minus being a minus.
///
/// # Example
/// ```
/// use carom_words::number::with_sign;
/// assert_eq!((with_sign(-71.25, 1), with_sign(3.0, 1)), ("−71.2".to_owned(), "+3.0".to_owned()));
/// ```
pub fn with_sign(value: f64, digits: usize) -> String {
    let size = format!("{:.digits$}", value.abs());
    if value < 0.0 { format!("−{size}") } else { format!("+{size}") }
}

/// A share in percent, with two decimals: enough for 1 in 10 000.
pub fn percent(share: f64) -> String {
    fixed(100.0 * share, 2)
}

/// `x` to `digits` significant digits; powers of ten outside 10⁻⁴…10⁶.
pub fn significant(x: f64, digits: usize) -> String {
    if !x.is_finite() {
        return NO_NUMBER.to_owned();
    }
    if x == 0.0 {
        return "0".to_owned();
    }
    let e = exponent(x, digits);
    if !(-4..6).contains(&e) {
        let text = format!("{:.*e}", digits.saturating_sub(1), x);
        let mantissa = text.split('e').next().unwrap_or(NO_NUMBER).replace('-', "−");
        return format!("{mantissa}·10{}", superscript(e));
    }
    let decimals = usize::try_from(digits as i32 - 1 - e).unwrap_or(0);
    fixed(x, decimals)
}

/// `x` to at most `digits` significant digits: zeros at the end of the decimals are left out.
pub fn trimmed(x: f64, digits: usize) -> String {
    let text = significant(x, digits);
    if text.contains('.') && !text.contains('·') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// `x` to `digits` significant digits, always with its sign.
pub fn signed(x: f64, digits: usize) -> String {
    let text = significant(x, digits);
    if x > 0.0 && x.is_finite() { format!("+{text}") } else { text }
}

/// Numbers below this are shown with a power of ten.
const PLAIN_FROM: f64 = 1e-4;
/// And those from here on.
const PLAIN_TO: f64 = 1e7;
/// And, where six digits are told, those from here on: further digits are not known.
const SIX_DIGITS_TO: f64 = 1e6;

/// A number with at most so many significant digits and no trailing zeros, as files and the terminal have it.
pub fn plain(value: f64, digits: usize) -> String {
    let decimals = digits.saturating_sub(1);
    let rounded: f64 = format!("{value:.decimals$e}").parse().unwrap_or(value);
    // Without the sign of a zero.
    let rounded = if rounded == 0.0 { 0.0 } else { rounded };
    let size = rounded.abs();
    if size != 0.0 && !(PLAIN_FROM..PLAIN_TO).contains(&size) {
        format!("{rounded:e}")
    } else {
        format!("{rounded}")
    }
}

/// Six digits, with zeros at the end, as hypotheses show their numbers.
///
/// # Example
/// ```
/// use carom_words::number::six_digits;
/// assert_eq!([-0.25, 31.4159265, 2e-5].map(six_digits), ["-0.250000", "31.41593", "2.00000e-5"]);
/// ```
pub fn six_digits(x: f64) -> String {
    let size = x.abs();
    if (PLAIN_FROM..SIX_DIGITS_TO).contains(&size) {
        let decimals = if size >= 1.0 { 5 } else { 6 };
        format!("{x:.decimals$}")
    } else {
        format!("{x:.5e}")
    }
}

fn superscript(n: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = n.unsigned_abs().to_string();
    let sign = if n < 0 { "⁻" } else { "" };
    let raised = digits.bytes().map(|b| DIGITS.get(usize::from(b - b'0')).copied().unwrap_or(' '));
    sign.chars().chain(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_digits_and_lose_nan() {
        assert_eq!(significant(0.035_248, 4), "0.03525", "small");
        assert_eq!(significant(-31.857_95, 4), "−31.86", "negative");
        assert_eq!(significant(99.999, 3), "100", "rounding carries");
        assert_eq!(significant(2.5e-7, 2), "2.5·10⁻⁷", "power of ten");
        assert_eq!(significant(f64::NAN, 3), "–", "not a number");
        assert_eq!(fixed(-0.000_1, 2), "0.00", "no minus zero");
        assert_eq!(trimmed(0.25, 4), "0.25", "no zeros at the end");
        assert_eq!(trimmed(300.0, 3), "300", "whole");
        assert_eq!(signed(7.615, 3), "+7.62", "sign");
    }
}
