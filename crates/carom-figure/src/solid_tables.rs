//! The tables of a body in space: its strikes, its series, and every state of each strike.

use crate::solid::{SolidContact, SolidFork, SolidSeries, SolidStrike};
use crate::text::{escape, fixed, significant};

/// Strikes shown with their contacts and states.
const MOST_IN_FULL: usize = 12;
/// Strikes in the table.
const MOST_ROWS: usize = 200;
/// Velocities below this part of the fastest contact's are rounding.
const ROUNDING: f64 = 1e-12;
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
pub(crate) fn strikes(strikes: &[SolidStrike]) -> String {
    if strikes.is_empty() {
        return "<section id=\"strikes\"><h2>Strikes</h2><p class=\"note\">Nothing was struck.</p></section>"
            .to_owned();
    }
    // With friction there is no least coefficient: the strike had the one that it had.
    let demanded = strikes.iter().any(|s| s.friction.is_some());
    let head = if demanded { "<th>friction</th>" } else { "" };
    let mut out = format!(
        "<section id=\"strikes\"><h2>Strikes</h2><div class=\"wide\"><table class=\"stages\"><thead><tr><th>#</th><th>state</th><th>strikes</th><th>at <span class=\"u\">s</span></th><th>tilt <span class=\"u\">°</span></th><th>spin <span class=\"u\">1/s</span></th><th>energy <span class=\"u\">J</span></th>{head}<th>ways on</th></tr></thead><tbody>",
    );
    for (i, s) in strikes.iter().enumerate().take(MOST_ROWS) {
        out += &format!(
            "<tr class=\"stage\" data-t=\"{}\"><td>{}</td><td class=\"words\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{} → {}</td><td>{} → {}</td>{}<td>{}</td></tr>",
            s.time,
            i + 1,
            escape(&s.state),
            escape(&s.struck),
            fixed(s.time, 6),
            fixed(s.tilt.to_degrees(), 3),
            significant(size(s.spin[0]), 4),
            significant(size(s.spin[1]), 4),
            significant(s.energy[0], 4),
            significant(s.energy[1], 4),
            if demanded {
                format!("<td>{}</td>", friction(s.friction, s.friction_is_bound))
            } else {
                String::new()
            },
            escape(&s.outcome)
        );
    }
    out += "</tbody></table></div>";
    if strikes.len() > MOST_ROWS {
        out += &format!("<p class=\"note\">and {} after them.</p>", strikes.len() - MOST_ROWS);
    }
    let least = if demanded {
        "Friction is the least coefficient with which no contact slides in the strike; ≤ where the impulses are open in more than one direction and less may do. "
    } else {
        ""
    };
    out + &format!("<p class=\"note\">{least}A row moves the animation to its strike.</p></section>")
}

/// The series that were closed.
pub(crate) fn series(series: &[SolidSeries]) -> String {
    if series.is_empty() {
        return String::new();
    }
    let mut out = String::from(
        "<section id=\"series\"><h2>Infinitely many strikes</h2><p class=\"note\">A body that chatters or rocks strikes without end in finite time; such a series is closed at its limit.</p><div class=\"wide\"><table class=\"small\"><thead><tr><th>stay</th><th>last strike resolved <span class=\"u\">s</span></th><th>limit <span class=\"u\">s</span></th><th>strikes a period</th><th>ratio of periods</th></tr></thead><tbody>",
    );
    for s in series.iter().take(MOST_ROWS) {
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escape(&s.kept),
            fixed(s.from, 8),
            fixed(s.to, 8),
            s.period,
            significant(s.ratio, DIGITS)
        );
    }
    out + "</tbody></table></div></section>"
}

/// Every strike with its contacts and states.
pub(crate) fn in_full(strikes: &[SolidStrike]) -> String {
    if strikes.is_empty() {
        return String::new();
    }
    let shown: String =
        strikes.iter().enumerate().take(MOST_IN_FULL).map(|(i, strike)| one(i, strike)).collect();
    format!("<section id=\"hypotheses\"><h2>Each strike</h2>{shown}</section>")
}

fn one(i: usize, strike: &SolidStrike) -> String {
    let spin = |spin: [f64; 3]| spin.map(|x| significant(x, DIGITS)).join(", ");
    let mut out = format!(
        "<article class=\"strike\"><h3><i class=\"key strike\"></i>Strike {} <small>{} s</small></h3><p class=\"kind\">{}</p><p class=\"note\">Spin ({}) → ({}) rad/s</p>",
        i + 1,
        fixed(strike.time, 6),
        escape(&strike.state),
        spin(strike.spin[0]),
        spin(strike.spin[1])
    );
    if let Some([case, words, agrees]) = &strike.closed_form {
        out += &format!(
            "<p class=\"note\">Closed form, {}. {}. <strong>{}</strong>.</p>",
            escape(case),
            escape(&crate::text::capitalised(words)),
            escape(&crate::text::capitalised(agrees))
        );
    }
    if !strike.contacts.is_empty() {
        out += &contacts(&strike.contacts);
    }
    out + &states(strike) + "</article>"
}

fn contacts(contacts: &[SolidContact]) -> String {
    let mut out = String::from(
        "<div class=\"wide\"><table class=\"small\"><thead><tr><th>contact</th><th>before</th><th>afterwards</th><th>impulse, normal <span class=\"u\">N s</span></th><th>tangential <span class=\"u\">N s</span></th><th>normal velocity <span class=\"u\">m/s</span></th><th>slip <span class=\"u\">m/s</span></th></tr></thead><tbody>",
    );
    let fastest = contacts.iter().map(|c| size(c.velocity)).fold(0.0, f64::max);
    for c in contacts {
        let [x, y, z] = c.velocity.map(|v| if v.abs() <= ROUNDING * fastest { 0.0 } else { v });
        let numbers = [c.impulse[0], c.impulse[1], z, (x * x + y * y).sqrt()];
        let cells: String = numbers.iter().map(|x| format!("<td>{}</td>", significant(*x, DIGITS))).collect();
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td>{cells}</tr>",
            escape(&c.name),
            if c.strikes { "strikes" } else { "stands" },
            escape(&c.state)
        );
    }
    out + "</tbody></table></div>"
}

/// What else a strike with friction could have done.
fn forks(forks: &[SolidFork]) -> String {
    if forks.is_empty() {
        return String::new();
    }
    let mut out = "<details open><summary>Several ways on are consistent</summary><div class=\"wide\"><table class=\"small\"><tbody>".to_owned();
    for fork in forks {
        let when = escape(&fork.when);
        let mut row = |way: &str, what: &str| {
            out += &format!(
                "<tr><th scope=\"row\">{when}</th><td class=\"words\">{}</td><td>{what}</td></tr>",
                escape(way)
            );
        };
        if let Some(way) = &fork.followed {
            row(way, "followed");
        }
        fork.others.iter().for_each(|way| row(way, "as consistent"));
    }
    out + "</tbody></table></div></details>"
}

/// The states: those that the law allows, and what refuses the others.
fn states(strike: &SolidStrike) -> String {
    // A strike with friction is walked through, and has none.
    if strike.found.is_empty() && strike.rejected.is_empty() {
        return forks(&strike.forks);
    }
    let found = match strike.found.len() {
        0 => "No state is consistent".to_owned(),
        1 => "One state is consistent".to_owned(),
        n => format!("{n} states are consistent"),
    };
    let refused = strike.rejected.len() + strike.left_out;
    let mut out = format!(
        "<details open><summary>{found}, {refused} {} refused</summary><div class=\"wide\"><table class=\"small\"><tbody>",
        if refused == 1 { "is" } else { "are" }
    );
    for state in &strike.found {
        let followed = if strike.found.len() > 1 && state.followed { ", followed" } else { "" };
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td class=\"words\">consistent{followed}; not to slide takes friction {}</td></tr>",
            escape(&state.hypothesis),
            friction(state.friction, state.friction_is_bound)
        );
    }
    for [hypothesis, because] in &strike.rejected {
        out +=
            &format!("<tr><td>{}</td><td class=\"words\">{}</td></tr>", escape(hypothesis), escape(because));
    }
    out += "</tbody></table></div>";
    if strike.left_out > 0 {
        out += &format!("<p class=\"note\">and {} more.</p>", strike.left_out);
    }
    out + "</details>"
}
