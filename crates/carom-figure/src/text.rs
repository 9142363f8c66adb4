//! Numbers and names as text: real minus signs, chosen digits. Never "NaN".

use crate::markup::{Markup, html};
use crate::svg;

/// What stands where a number is not finite.
const NO_NUMBER: &str = "–";

/// The decimal exponent of `x` rounded to `digits` significant digits; 0 for zero.
pub(crate) fn exponent(x: f64, digits: usize) -> i32 {
    let text = format!("{:.*e}", digits.saturating_sub(1), x);
    text.split_once('e').and_then(|(_, e)| e.parse().ok()).unwrap_or(0)
}

/// `x` with a fixed number of decimals.
pub(crate) fn fixed(x: f64, decimals: usize) -> String {
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

/// A share in percent, with two decimals: enough for 1 in 10 000.
pub(crate) fn percent(share: f64) -> String {
    fixed(100.0 * share, 2)
}

/// `x` to `digits` significant digits; powers of ten outside 10⁻⁴…10⁶.
pub(crate) fn significant(x: f64, digits: usize) -> String {
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
pub(crate) fn trimmed(x: f64, digits: usize) -> String {
    let text = significant(x, digits);
    if text.contains('.') && !text.contains('·') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// `x` to `digits` significant digits, always with its sign.
pub(crate) fn signed(x: f64, digits: usize) -> String {
    let text = significant(x, digits);
    if x > 0.0 && x.is_finite() { format!("+{text}") } else { text }
}

fn superscript(n: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let digits = n.unsigned_abs().to_string();
    let sign = if n < 0 { "⁻" } else { "" };
    let raised = digits.bytes().map(|b| DIGITS.get(usize::from(b - b'0')).copied().unwrap_or(' '));
    sign.chars().chain(raised).collect()
}

/// A length in pixels for SVG: two decimals, no trailing zeros, an ASCII minus.
pub(crate) fn px(x: f64) -> String {
    if !x.is_finite() {
        return "0".to_owned();
    }
    let text = format!("{x:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" || short.is_empty() { "0".to_owned() } else { short.to_owned() }
}

/// A letter with an index (`v_r`) for HTML.
pub(crate) fn html_symbol(symbol: &str) -> Markup {
    match symbol.split_once('_') {
        Some((letter, index)) => html! { i { (letter) } sub { (index) } },
        None => html! { i { (symbol) } },
    }
}

/// A letter with an index (`v_r`) for SVG.
pub(crate) fn svg_symbol(symbol: &str) -> Markup {
    match symbol.split_once('_') {
        Some((letter, index)) => html! { tspan font-style="italic" { (letter) } (svg::index(index)) },
        None if symbol.chars().count() == 1 => html! { tspan font-style="italic" { (symbol) } },
        None => html! { (symbol) },
    }
}

/// The same text with its first letter in upper case.
pub(crate) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
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
        assert_eq!(px(f64::INFINITY), "0", "no infinite pixel");
        assert_eq!(px(-0.001), "0", "no minus zero pixel");
    }
}
