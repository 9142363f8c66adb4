//! Numbers and names as text.

use crate::markup::{Markup, html};
use crate::svg;
pub(crate) use carom_words::number::{exponent, fixed, percent, signed, significant, trimmed};

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
    fn pixels_are_finite_and_have_no_minus_zero() {
        assert_eq!(px(f64::INFINITY), "0", "no infinite pixel");
        assert_eq!(px(-0.001), "0", "no minus zero pixel");
    }
}
