//! The quantities of a fit, and their ranges.

use crate::tasks::axes::{Complaints, keys, named, read_axis};
use carom_scene::Scene;
use carom_scene::unit::Dimension;
use carom_study::fits::MOST_PARAMETERS;

/// A range of a quantity that is fitted.
pub(super) struct Over {
    /// Its path in the scene.
    pub(super) path: String,
    /// Low and high end, SI.
    pub(super) range: [f64; 2],
    pub(super) dimension: Dimension,
}

impl Over {
    /// `contact.friction from 0 to 1`
    pub(super) fn shown(&self) -> String {
        let [low, high] = self.range.map(|end| self.dimension.show(end));
        format!("{} from {low} to {high}", self.path)
    }

    /// `contact.friction = 0.2`
    pub(super) fn at(&self, value: f64) -> String {
        format!("{} = {}", self.path, self.dimension.show_digits(value, 4))
    }
}

/// Reads every range, or takes each friction and restitution that the scene writes.
pub(super) fn read(scene: &Scene, options: &[String], complaints: &mut Complaints) -> Vec<Over> {
    let found = if options.is_empty() { contacts(scene) } else { named_ones(scene, options, complaints) };
    if options.is_empty() && found.is_empty() {
        complaints.push("over", "missing: the scene writes no friction and no restitution".to_owned());
    }
    if found.len() > MOST_PARAMETERS {
        let paths: Vec<&str> = found.iter().map(|over| over.path.as_str()).collect();
        let message = format!(
            "{} quantities ({}): at most {MOST_PARAMETERS} are fitted at once",
            paths.len(),
            paths.join(", ")
        );
        complaints.push("over", message);
    }
    found
}

fn contacts(scene: &Scene) -> Vec<Over> {
    let quantities = scene.quantities().into_iter().filter(|quantity| {
        let last = quantity.path.rsplit('.').next();
        let contact = matches!(last, Some("friction" | "restitution"));
        contact && quantity.written && !quantity.path.starts_with("feed.")
    });
    let range = |value: f64| [0.0, if value > 1.0 { 2.0 * value } else { 1.0 }];
    quantities.map(|q| Over { range: range(q.value), dimension: q.kind.dimension, path: q.path }).collect()
}

fn named_ones(scene: &Scene, options: &[String], complaints: &mut Complaints) -> Vec<Over> {
    let keys = keys(scene, complaints.asker());
    let quantities = scene.quantities();
    let mut found: Vec<Over> = vec![];
    for text in options {
        let text = named(scene, text);
        let Some(axis) = read_axis(&keys, "over", &text, &("cells", 1..=1), complaints) else { continue };
        let key = &keys[axis.key];
        let option = format!("over {text}");
        if found.iter().any(|over| over.path == key.name) {
            complaints.push(&option, format!("{} is fitted already", key.name));
            continue;
        }
        if quantities.iter().any(|quantity| quantity.path == key.name && !quantity.written) {
            let message = "the scene does not write it: the fitted scene would have no place for it";
            complaints.push(&option, message.to_owned());
        }
        let range = [axis.range.from, axis.range.to].map(|end| axis.si(end));
        found.push(Over { path: key.name.clone(), range, dimension: key.dimension });
    }
    found
}
