//! The studio: the engine as WebAssembly, the site around it, and its tests in a browser.

use crate::steps::{cargo, cargo_program, said_by};
use std::path::{Path, PathBuf};
use std::process::Command;

const TARGET: &str = "wasm32-unknown-unknown";
/// Where Debian's package `rust-web-src` puts the source of the standard library, and its compiler.
const DEBIAN_SOURCE: &str = "/usr/lib/rustlib/src/rust/library";
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";
const SITE: &str = "apps/carom-web/site";

/// Builds both modules and the site in both of its forms; the note says where they are and how large the engine is.
pub(crate) fn build(root: &Path) -> Result<String, String> {
    let site = root.join(SITE);
    let place = site.join("engine");
    std::fs::create_dir_all(&place).map_err(|problem| format!("{}: {problem}", place.display()))?;
    // The bench alone is loaded first, the whole engine where it is asked for.
    for (name, features) in [("carom.wasm", &["--no-default-features"][..]), ("carom-whole.wasm", &[])] {
        let module = module(root, features)?;
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
    cargo(root, &["build", "--release", "--package", "carom-cli", "--features", "studio"])?;
    Ok(format!(
        "{SITE}/dist/site, a folder for any web server; {SITE}/dist/single/carom-studio.html, one file; and `carom studio`"
    ))
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

/// The module with these features, built by the toolchain's own standard library for the target where it is installed, else from Debian's source of one.
fn module(root: &Path, features: &[&str]) -> Result<PathBuf, String> {
    let target = root.join("target/web");
    let mut command = Command::new(cargo_program());
    command.args(["build", "--profile", "web", "--package", "carom-web", "--target", TARGET]);
    command.args(features);
    command.env("CARGO_TARGET_DIR", &target).current_dir(root);
    if !has_target() {
        if !Path::new(DEBIAN_SOURCE).is_dir() || !Path::new(DEBIAN_RUSTC).is_file() {
            return Err(format!(
                "there is no standard library for {TARGET}: `rustup target add {TARGET}`, or on Debian `apt-get install rustc-web rust-web-src`"
            ));
        }
        command.args(["-Zbuild-std=std,panic_abort"]);
        command.env("RUSTC_BOOTSTRAP", "1").env("RUSTC", DEBIAN_RUSTC);
        if let Some(linker) = linker() {
            command.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker);
        }
    }
    said_by(command)?;
    Ok(target.join(TARGET).join("web/carom_web.wasm"))
}

/// What rustc answers, without its last line's end.
fn rustc(words: &[&str]) -> Option<String> {
    let output = Command::new("rustc").args(words).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

fn has_target() -> bool {
    let folder = rustc(&["--print", "target-libdir", "--target", TARGET]);
    folder.is_some_and(|folder| Path::new(&folder).is_dir())
}

/// The linker that comes with the toolchain.
fn linker() -> Option<PathBuf> {
    let own = Path::new(&rustc(&["--print", "target-libdir"])?).parent()?.join("bin/rust-lld");
    own.is_file().then_some(own)
}
