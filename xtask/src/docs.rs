//! The documentation without warnings, and without broken links.

use crate::steps::cargo_program;
use serde_json::Value;
use std::path::Path;
use std::process::Command;

/// What stands in brackets as a unit and not as a link. Composed units such as `[m/s]` are no links to rustdoc either.
const UNITS: [&str; 14] = ["1", "A", "deg", "g", "Hz", "J", "K", "kg", "m", "mm", "ms", "N", "rad", "s"];

/// Builds the documentation of the libraries: every warning is a fault, and every link that leads nowhere.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    let output = Command::new(cargo_program())
        .args(["doc", "--workspace", "--no-deps", "--lib", "--message-format", "json"])
        .env("RUSTDOCFLAGS", "-Dwarnings --force-warn rustdoc::broken-intra-doc-links")
        .current_dir(root)
        .output()
        .map_err(|problem| format!("cargo doc: {problem}"))?;
    let said = String::from_utf8_lossy(&output.stdout);
    let faults: Vec<String> = said.lines().filter_map(fault).collect();
    if output.status.success() && faults.is_empty() {
        return Ok(String::new());
    }
    let errors = String::from_utf8_lossy(&output.stderr);
    Err(if output.status.success() { faults.concat() } else { format!("{}{errors}", faults.concat()) })
}

/// A line of cargo's messages, as a person reads it, where it is a fault.
fn fault(line: &str) -> Option<String> {
    let json: Value = serde_json::from_str(line).ok()?;
    if json["reason"] != "compiler-message" {
        return None;
    }
    let message = &json["message"];
    let is_unit = linked_to(message["message"].as_str()?)
        .is_some_and(|name| UNITS.contains(&name.trim_end_matches(['²', '³', '⁴', '⁵'])));
    (!is_unit).then(|| message["rendered"].as_str().unwrap_or_default().to_owned())
}

/// The target of a broken link.
fn linked_to(message: &str) -> Option<&str> {
    message.strip_prefix("unresolved link to `")?.strip_suffix('`')
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn message(text: &str) -> String {
        let message = json!({ "message": text, "rendered": format!("warning: {text}\n") });
        json!({ "reason": "compiler-message", "message": message }).to_string()
    }

    #[test]
    fn units_are_no_links() {
        for unit in ["rad", "m²", "m⁵"] {
            assert!(fault(&message(&format!("unresolved link to `{unit}`"))).is_none(), "{unit} is a unit");
        }
        assert!(fault("{\"reason\": \"build-finished\"}").is_none(), "no message");
    }

    #[test]
    fn broken_links_and_other_warnings_are_faults() {
        for text in ["unresolved link to `Shap`", "missing documentation for a module"] {
            let found = fault(&message(text));
            assert_eq!(found.as_deref(), Some(format!("warning: {text}\n").as_str()), "{text}");
        }
    }
}
