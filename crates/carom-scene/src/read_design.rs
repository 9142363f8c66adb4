//! `[design]`: what may be chosen, what must be kept, what to aim at.

use crate::drawing::{Design, Free};
use crate::grammar::Section;
use crate::node::{Entry, Node, Value};
use crate::problem::{Problem, ProblemKind};
use crate::quantity::{Kind, parse_range};
use crate::suggest::nearest;
use crate::visit::canonical;

/// Reads `[design]`. `known` are the quantities of the scene; `None` where the scene has problems that leave them unknown.
pub(crate) fn read_design(root: &Section<'_>, known: Option<&[(String, Kind)]>) -> Option<Design> {
    let section = root.section_if_known("design")?;
    let ranges = section.get("free").map(|node| &node.value);
    let free = match (ranges, known) {
        (Some(Value::Table(entries)), Some(known)) => flat("", entries)
            .into_iter()
            .filter_map(|(path, node)| read_free(&path, node, known, &section))
            .collect(),
        _ => vec![],
    };
    Some(Design {
        free,
        max_impact_speed: section.quantity("max_impact_speed"),
        max_sliding_speed: section.quantity("max_sliding_speed"),
        max_height: section.quantity("max_height"),
        max_width: section.quantity("max_width"),
        max_time: section.quantity("max_time"),
        forbid_walls: section.flag("forbid_walls"),
        aim: section.word_or_default("aim"),
    })
}

/// Paths written with and without quotes: `"plate.lower.slope" = ..` and `plate.lower.slope = ..`.
fn flat<'n>(path: &str, entries: &'n [Entry]) -> Vec<(String, &'n Node)> {
    let mut found = vec![];
    for entry in entries {
        let path = if path.is_empty() { entry.key.clone() } else { format!("{path}.{}", entry.key) };
        match &entry.node.value {
            Value::Table(entries) => found.extend(flat(&path, entries)),
            _ => found.push((path, &entry.node)),
        }
    }
    found
}

fn read_free(path: &str, node: &Node, known: &[(String, Kind)], section: &Section<'_>) -> Option<Free> {
    let span = Some(node.span.clone());
    let place = format!("design.free.\"{path}\"");
    let paths: Vec<&str> = known.iter().map(|(path, _)| path.as_str()).collect();
    let plain = canonical(path, &paths);
    let Some((_, kind)) = known.iter().find(|(known, _)| *known == plain) else {
        let message = "is no quantity that this scene writes down";
        let problem = Problem::new(ProblemKind::Name, place, message, span);
        section.push(match nearest(path, &paths) {
            Some(near) => problem.with_help(format!("did you mean \"{near}\"?")),
            None => problem.with_help(format!("it writes down {}", paths.join(", "))),
        });
        return None;
    };
    let Value::Text(text) = &node.value else { return None };
    let (low, high) = match parse_range(text, kind.dimension) {
        Ok(range) => range,
        Err(problem) => {
            let message = format!("\"{text}\": {}", problem.in_words(kind.dimension));
            section.push(Problem::new(ProblemKind::Quantity, place, message, span));
            return None;
        }
    };
    if let Some(bad) = [low, high].into_iter().find(|end| !kind.holds(*end)) {
        let message = format!("reaches {}: it {}", kind.dimension.show(bad), kind.rule_for(bad));
        section.push(Problem::new(ProblemKind::OutOfRange, place, message, span));
        return None;
    }
    Some(Free { path: plain, low, high })
}
