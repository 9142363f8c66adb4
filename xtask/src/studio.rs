//! The studio: the engine as WebAssembly, the site around it, and its tests in a browser.

use crate::steps::{cargo, said_by};
use crate::wasm;
use std::path::Path;
use std::process::Command;

const SITE: &str = "apps/carom-web/site";
/// The site in one file.
const PAGE: &str = "apps/carom-web/site/dist/single/carom-studio.html";

/// Builds the site in both of its forms and the command that serves it; the note says where they are.
pub(crate) fn build(root: &Path) -> Result<String, String> {
    let page = page(root)?;
    cargo(root, &["build", "--release", "--package", "carom-cli", "--features", "studio"])?;
    Ok(format!("{SITE}/dist/site, a folder for any web server; {page}, one file; and `carom studio`"))
}

/// Builds both modules and the site in both of its forms: where the one that is a single file is.
pub(crate) fn page(root: &Path) -> Result<&'static str, String> {
    let site = root.join(SITE);
    let place = site.join("engine");
    std::fs::create_dir_all(&place).map_err(|problem| format!("{}: {problem}", place.display()))?;
    // The bench alone is loaded first, the whole engine where it is asked for.
    for (name, features) in [("carom.wasm", &["--no-default-features"][..]), ("carom-whole.wasm", &[])] {
        let module = wasm::module(root, features)?;
        std::fs::copy(&module, place.join(name))
            .map_err(|problem| format!("{}: {problem}", module.display()))?;
    }
    for words in [
        &["npm", "ci", "--silent"][..],
        &["npm", "run", "--silent", "check"],
        &["npm", "run", "--silent", "build"],
        &["npm", "run", "--silent", "build:single"],
    ] {
        node(&site, words)?;
    }
    Ok(PAGE)
}

/// Builds it and tests it in Chromium, from a server and from the disk.
pub(crate) fn check(root: &Path) -> Result<String, String> {
    build(root)?;
    let said = node(&root.join(SITE), &["npm", "test", "--silent"])?;
    let after = |line: &str, mark: &str| line.split_once(mark).map(|(_, rest)| rest.to_owned());
    let measured: Vec<String> = said.lines().filter_map(|line| after(line, "measured: ")).collect();
    let passed = said.lines().find_map(|line| after(line, " pass ")).unwrap_or_default();
    Ok(format!("{passed} tests in a browser\n{}", measured.join("\n")))
}

fn node(site: &Path, words: &[&str]) -> Result<String, String> {
    let mut command = Command::new(words[0]);
    command.args(&words[1..]).current_dir(site);
    said_by(command)
}
