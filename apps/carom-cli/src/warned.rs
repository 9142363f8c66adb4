//! What every answer about a scene says first where the part computed is not the part drawn.

use carom_scene::Scene;

/// What follows a verdict in its own line: nothing, or a comma and the warning in capitals.
pub(crate) fn beside(scene: &Scene) -> String {
    scene.warning().map_or(String::new(), |warning| format!(", {warning}"))
}

/// The warnings in full, a line each, without their full stops.
pub(crate) fn sentences(scene: &Scene) -> Vec<String> {
    let found = scene.approximations().iter().filter(|found| found.warning().is_some());
    found.map(|found| found.text.clone()).collect()
}

/// The warnings as lines of their own below a verdict.
pub(crate) fn below(scene: &Scene) -> String {
    sentences(scene).into_iter().map(|warning| format!("warning: {warning}\n")).collect()
}
