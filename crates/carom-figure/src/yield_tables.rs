//! The tables of a yield study's page.

use crate::text::{capitalised, escape, fixed, percent, significant};
use crate::yield_page::YieldFigure;
use carom_impact::planar::Law;
use carom_study::Ending;
use carom_study::yields::Passage;

/// From plate to plate: which side becomes which.
pub(crate) fn passages(figure: &YieldFigure<'_>) -> String {
    let mut out = String::new();
    let mut before = figure.plates.first();
    for (name, passages) in figure.plates.iter().zip(&figure.found.passages).skip(1) {
        if !passages.is_empty() {
            let from = before.map(|plate| escape(plate)).unwrap_or_default();
            out += &format!(
                "<div><h3>From “{from}” to “{}”</h3>{}</div>",
                escape(name),
                matrix(passages, figure.found.drops)
            );
        }
        before = Some(name);
    }
    if out.is_empty() {
        return out;
    }
    format!(
        "<section id=\"passages\"><h2>From plate to plate</h2><p class=\"note\">Rows: how the part lies on the upper plate; columns: how it comes to lie on the lower one. Percent of the row, and how many drops. Sides count from the start.</p><div class=\"passages\">{out}</div></section>"
    )
}

fn matrix(passages: &[Passage], drops: u64) -> String {
    let mut from: Vec<Option<Ending>> = passages.iter().map(|passage| passage.from).collect();
    let mut to: Vec<Ending> = passages.iter().map(|passage| passage.to).collect();
    from.dedup();
    to.sort();
    to.dedup();
    let heads: String = to.iter().map(|ending| format!("<th>{}</th>", escape(&ending.to_string()))).collect();
    let mut out = format!(
        "<div class=\"wide\"><table class=\"matrix\"><thead><tr><th></th>{heads}<th>drops</th></tr></thead><tbody>"
    );
    for row in from {
        let of = |ending: Option<Ending>| {
            let same = passages
                .iter()
                .filter(|passage| passage.from == row && ending.is_none_or(|ending| passage.to == ending));
            same.map(|passage| passage.count).sum::<u64>()
        };
        let whole = of(None);
        let name = row.map_or("at the start".to_owned(), |ending| ending.to_string());
        out += &format!("<tr><th scope=\"row\">{}</th>", escape(&name));
        for ending in &to {
            let count = of(Some(*ending));
            let share = count as f64 / whole.max(1) as f64;
            out += &match count {
                0 => "<td>–</td>".to_owned(),
                _ => format!(
                    "<td style=\"--share:{}\">{} %<small>{count}</small></td>",
                    fixed(share, 3),
                    percent(share)
                ),
            };
        }
        out += &format!("<td>{whole}</td></tr>");
    }
    let followed: u64 = passages.iter().map(|passage| passage.count).sum();
    out += "</tbody></table></div>";
    if followed < drops {
        out += &format!("<p class=\"note\">{} drops could not be followed.</p>", drops - followed);
    }
    out
}

/// The drops to look at, each with the command that replays it.
pub(crate) fn worst(figure: &YieldFigure<'_>) -> String {
    if figure.worst.is_empty() {
        return String::new();
    }
    let mut out = String::from("<section id=\"worst\"><h2>Drops to look at</h2><div class=\"cases\">");
    for case in figure.worst {
        // Of plates that the part does not come to lie on no strike is known.
        let speed = match case.impact_speed {
            Some(speed) if speed > 0.0 => format!("strikes at {} m/s", significant(speed, 4)),
            Some(_) => "lies down without a strike".to_owned(),
            None => "comes to lie on no further plate".to_owned(),
        };
        out += &format!(
            "<article><h3>{} <small>{}</small></h3><p>{}.</p><pre>{}</pre></article>",
            escape(&capitalised(&case.ending)),
            escape(&speed),
            escape(&capitalised(&case.why)),
            escape(&case.command)
        );
    }
    out += "</div>";
    let heads: String =
        figure.worst.iter().map(|case| format!("<th>{}</th>", escape(case_name(case)))).collect();
    out += &format!(
        "<details><summary>Their values</summary><div class=\"wide\"><table class=\"small\"><thead><tr><th>quantity</th><th>as drawn</th>{heads}</tr></thead><tbody>"
    );
    for (i, quantity) in figure.quantities.iter().enumerate() {
        let cells = figure.worst.iter().map(|case| case.values.get(i).map_or("–", String::as_str));
        let cells: String = cells.map(|value| format!("<td>{}</td>", escape(value))).collect();
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td>{cells}</tr>",
            escape(&quantity.path),
            escape(&quantity.middle)
        );
    }
    out + "</tbody></table></div></details></section>"
}

/// A drop's name at the head of a column: its file's.
fn case_name(case: &crate::yield_page::YieldWorst) -> &str {
    let file = case.command.rsplit(['/', '\\', ' ']).next().unwrap_or_default();
    file.trim_matches(['\'', '"']).trim_start_matches("worst-").trim_end_matches(".toml")
}

/// Restitution by law.
pub(crate) fn laws(figure: &YieldFigure<'_>) -> String {
    let Some((first, ..)) = figure.laws.first() else { return String::new() };
    let restitutions = figure.laws.iter().filter(|(law, ..)| law == first).map(|(_, e, _)| *e);
    let mut laws: Vec<Law> = vec![];
    for (law, ..) in figure.laws {
        if !laws.contains(law) {
            laws.push(*law);
        }
    }
    let name = |law: &Law| escape(&capitalised(&law.to_string()));
    let heads: String = laws.iter().map(|law| format!("<th>{}</th>", name(law))).collect();
    let mut out = format!(
        "<section id=\"laws\"><h2>What the impact law says</h2><p class=\"note\">Nothing varies; restitution is the same on every plate and wall. As drawn, after {}, the drop ends <b>{}</b>; what differs from that is marked.</p><div class=\"wide\"><table class=\"laws\"><thead><tr><th>restitution</th>{heads}</tr></thead><tbody>",
        name(&figure.law),
        escape(&figure.drawn.to_string())
    );
    for restitution in restitutions {
        out += &format!("<tr><th scope=\"row\">{restitution}</th>");
        for law in &laws {
            let found = figure.laws.iter().find(|(other, e, _)| other == law && *e == restitution);
            let class = if found.is_some_and(|(.., ending)| *ending != figure.drawn) {
                " class=\"differs\""
            } else {
                ""
            };
            let ending = found.map_or("–".to_owned(), |(.., ending)| ending.to_string());
            out += &format!("<td{class}>{}</td>", escape(&ending));
        }
        out += "</tr>";
    }
    out + "</tbody></table></div></section>"
}

/// What varies, how it was sampled, and the scene.
pub(crate) fn inputs(figure: &YieldFigure<'_>) -> String {
    let mut out = String::from(
        "<section id=\"inputs\"><h2>What varies</h2><div class=\"wide\"><table class=\"small\"><thead><tr><th>quantity</th><th>as drawn</th><th>tolerance</th></tr></thead><tbody>",
    );
    for quantity in figure.quantities {
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>",
            escape(&quantity.path),
            escape(&quantity.middle),
            escape(&quantity.tolerance)
        );
    }
    out += "</tbody></table></div><ul>";
    out += &figure.notes.iter().map(|note| format!("<li>{}</li>", escape(note))).collect::<String>();
    out += "</ul>";
    if !figure.source.is_empty() {
        out += &format!(
            "<details><summary>The scene as written</summary><pre>{}</pre></details>",
            escape(figure.source)
        );
    }
    out + "</section>"
}
