//! The tables of a body in space: its strikes, its series, and every state of each strike.

use crate::impact_page::refused;
use crate::markup::{Markup, html, table};
use crate::solid::{SolidContact, SolidFork, SolidSeries, SolidStrike};
use crate::text::{capitalised, fixed, significant};
use crate::tolerance::SOLVED;
use carom_words::roll_space;

/// Strikes shown with their contacts and states.
const MOST_IN_FULL: usize = 12;
/// Strikes in the table.
const MOST_ROWS: usize = 200;
/// Digits of a number in a table.
const DIGITS: usize = 6;

fn size([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

fn friction(least: Option<f64>, is_bound: bool) -> String {
    let bound = if is_bound { "≤ " } else { "" };
    least.map_or_else(|| "–".to_owned(), |mu| format!("{bound}{}", significant(mu, 4)))
}

/// The table of strikes; a row moves the animation.
pub(crate) fn strikes(strikes: &[SolidStrike]) -> Markup {
    if strikes.is_empty() {
        return html! { section id="strikes" { h2 { "Strikes" } p.note { "Nothing was struck." } } };
    }
    // With friction there is no least coefficient: the strike had the one that it had.
    let demanded = strikes.iter().any(|s| s.friction.is_some());
    let pair = |values: [f64; 2]| values.map(|value| significant(value, 4)).join(" → ");
    let row = |(i, s): (usize, &SolidStrike)| {
        html! {
            tr.stage data-t=(s.time) {
                td { (i + 1) }
                td.words { (s.state) }
                td { (s.struck) }
                td { (fixed(s.time, 6)) }
                td { (fixed(s.tilt.to_degrees(), 3)) }
                td { (pair(s.spin.map(size))) }
                td { (pair(s.energy)) }
                @if demanded { td { (friction(s.friction, s.friction_is_bound)) } }
                td { (s.outcome) }
            }
        }
    };
    let heads = ["#", "state", "strikes", "at [s]", "tilt [°]", "spin [1/s]", "energy [J]"];
    let last: &[&str] = if demanded { &["friction", "ways on"] } else { &["ways on"] };
    html! {
        section id="strikes" {
            h2 { "Strikes" }
            (table("stages", &[&heads, last].concat(), strikes.iter().enumerate().take(MOST_ROWS).map(row)))
            @if strikes.len() > MOST_ROWS { p.note { "and " (strikes.len() - MOST_ROWS) " after them." } }
            p.note {
                @if demanded {
                    "Friction is the least coefficient with which no contact slides in the strike; ≤ where the impulses are open in more than one direction and less may do. "
                }
                "A row moves the animation to its strike."
            }
        }
    }
}

/// The series that were closed.
pub(crate) fn series(series: &[SolidSeries]) -> Markup {
    if series.is_empty() {
        return html! {};
    }
    let row = |s: &SolidSeries| {
        html! {
            tr {
                th scope="row" { (s.kept) }
                td { (fixed(s.from, 8)) }
                td { (fixed(s.to, 8)) }
                td { (s.period) }
                td { (significant(s.ratio, DIGITS)) }
            }
        }
    };
    let heads = ["stay", "last strike resolved [s]", "limit [s]", "strikes a period", "ratio of periods"];
    html! {
        section id="series" {
            h2 { "Infinitely many strikes" }
            p.note {
                "A body that chatters or rocks strikes without end in finite time; such a series is closed at its limit."
            }
            (table("small", &heads, series.iter().take(MOST_ROWS).map(row)))
        }
    }
}

/// Every strike with its contacts and states.
pub(crate) fn in_full(strikes: &[SolidStrike]) -> Markup {
    html! {
        @if !strikes.is_empty() {
            section id="hypotheses" {
                h2 { "Each strike" }
                @for (i, strike) in strikes.iter().enumerate().take(MOST_IN_FULL) { (one(i, strike)) }
            }
        }
    }
}

fn one(i: usize, strike: &SolidStrike) -> Markup {
    let spin = |spin: [f64; 3]| spin.map(|x| significant(x, DIGITS)).join(", ");
    html! {
        article.strike {
            h3 { i.key.strike {} "Strike " (i + 1) " " small { (fixed(strike.time, 6)) " s" } }
            p.kind { (strike.state) }
            p.note { "Spin (" (spin(strike.spin[0])) ") → (" (spin(strike.spin[1])) ") rad/s" }
            @if let Some([case, words, agrees]) = &strike.closed_form {
                p.note {
                    "Closed form, " (case) ". " (capitalised(words)) ". " strong { (capitalised(agrees)) } "."
                }
            }
            @if !strike.contacts.is_empty() { (contacts(&strike.contacts)) }
            (states(strike))
        }
    }
}

fn contacts(contacts: &[SolidContact]) -> Markup {
    let fastest = contacts.iter().map(|c| size(c.velocity)).fold(0.0, f64::max);
    let row = |c: &SolidContact| {
        let [x, y, z] = c.velocity.map(|v| if v.abs() <= SOLVED * fastest { 0.0 } else { v });
        let numbers = [c.impulse[0], c.impulse[1], z, (x * x + y * y).sqrt()];
        html! {
            tr {
                th scope="row" { (c.name) }
                td { @if c.strikes { "strikes" } @else { "stands" } }
                td { (c.state) }
                @for number in numbers { td { (significant(number, DIGITS)) } }
            }
        }
    };
    let heads = [
        "contact",
        "before",
        "afterwards",
        "impulse, normal [N s]",
        "tangential [N s]",
        "normal velocity [m/s]",
        "slip [m/s]",
    ];
    table("small", &heads, contacts.iter().map(row))
}

/// What else a strike with friction could have done.
fn forks(forks: &[SolidFork]) -> Markup {
    if forks.is_empty() {
        return html! {};
    }
    let ways = forks.iter().flat_map(|fork| {
        let row = |way: &String, what: &str| {
            html! { tr { th scope="row" { (fork.when) } td.words { (way) } td { (what) } } }
        };
        let others = fork.others.iter().map(move |way| row(way, "as consistent"));
        fork.followed.iter().map(move |way| row(way, "followed")).chain(others)
    });
    html! { details open { summary { "Several ways on are consistent" } (table("small", &[], ways)) } }
}

/// The states: those that the law allows, and what refuses the others.
fn states(strike: &SolidStrike) -> Markup {
    // A strike with friction is walked through, and has none.
    if strike.found.is_empty() && strike.rejected.is_empty() {
        return html! {
            @if strike.shared { p.note { (capitalised(roll_space::SHARED)) "." } }
            (forks(&strike.forks))
        };
    }
    let words = match strike.found.len() {
        0 => "No state is consistent".to_owned(),
        1 => "One state is consistent".to_owned(),
        n => format!("{n} states are consistent"),
    };
    let count = strike.rejected.len() + strike.left_out;
    let found = strike.found.iter().map(|state| {
        let followed = if strike.found.len() > 1 && state.followed { ", followed" } else { "" };
        let least = friction(state.friction, state.friction_is_bound);
        html! {
            tr {
                th scope="row" { (state.hypothesis) }
                td.words { "consistent" (followed) "; not to slide takes friction " (least) }
            }
        }
    });
    html! {
        details open {
            summary { (words) ", " (count) @if count == 1 { " is refused" } @else { " are refused" } }
            (table("small", &[], found.chain(strike.rejected.iter().map(refused))))
            @if strike.left_out > 0 { p.note { "and " (strike.left_out) " more." } }
        }
    }
}
