//! Crates as WebAssembly: which compiler, standard library and linker build them.

use crate::steps::{cargo_program, said_by};
use std::path::{Path, PathBuf};
use std::process::Command;

/// A page's module.
const PAGE: &str = "wasm32-unknown-unknown";
/// A program that reads and writes files.
const PROGRAM: &str = "wasm32-wasip1";
/// Where Debian's packages `rust-web-src`, `rustc-web` and `wasi-libc` put the source of the standard library, its compiler and the C library.
const DEBIAN_SOURCE: &str = "/usr/lib/rustlib/src/rust/library";
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";
const DEBIAN_C: &str = "/usr/lib/wasm32-wasi";

/// The module of the page's engine with these features.
pub(crate) fn module(root: &Path, features: &[&str]) -> Result<PathBuf, String> {
    let target = root.join("target/web");
    let mut command = build(root, PAGE, "carom-web", "web", &target)?;
    command.args(features);
    said_by(command)?;
    Ok(target.join(PAGE).join("web/carom_web.wasm"))
}

/// The command itself as a WebAssembly program.
pub(crate) fn command(root: &Path) -> Result<PathBuf, String> {
    let target = root.join("target/web");
    said_by(build(root, PROGRAM, "carom-cli", "wasi", &target)?)?;
    Ok(target.join(PROGRAM).join("wasi/carom.wasm"))
}

/// Builds a package by the toolchain's own standard library for the target where it is installed, else from Debian's source of one.
fn build(root: &Path, target: &str, package: &str, profile: &str, folder: &Path) -> Result<Command, String> {
    let mut command = Command::new(cargo_program());
    command.args(["build", "--profile", profile, "--package", package, "--target", target]);
    command.env("CARGO_TARGET_DIR", folder).current_dir(root);
    if has(target) {
        return Ok(command);
    }
    let packages: &[(&str, &str)] = match target {
        PAGE => &[("rustc-web", DEBIAN_RUSTC), ("rust-web-src", DEBIAN_SOURCE)],
        _ => &[("rustc-web", DEBIAN_RUSTC), ("rust-web-src", DEBIAN_SOURCE), ("wasi-libc", DEBIAN_C)],
    };
    if packages.iter().any(|(_, place)| !Path::new(place).exists()) {
        let names: Vec<&str> = packages.iter().map(|(name, _)| *name).collect();
        return Err(format!(
            "there is no standard library for {target}: `rustup target add {target}`, or on Debian `apt-get install {}`",
            names.join(" ")
        ));
    }
    command.args(["-Zbuild-std=std,panic_abort"]);
    command.env("RUSTC_BOOTSTRAP", "1").env("RUSTC", DEBIAN_RUSTC);
    let variable = |name: &str| format!("CARGO_TARGET_{}_{name}", target.to_uppercase().replace('-', "_"));
    if let Some(linker) = linker() {
        command.env(variable("LINKER"), linker);
    }
    if target == PROGRAM {
        // Debian's C library has no threads: who asks for one is told so by the program that runs the module.
        command.env(
            variable("RUSTFLAGS"),
            format!(
                "-C link-self-contained=no -C link-arg={DEBIAN_C}/crt1-command.o -C link-arg=-L{DEBIAN_C} -C link-arg=--allow-undefined"
            ),
        );
    }
    Ok(command)
}

/// What rustc answers, without its last line's end.
fn rustc(words: &[&str]) -> Option<String> {
    let output = Command::new("rustc").args(words).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

fn has(target: &str) -> bool {
    let folder = rustc(&["--print", "target-libdir", "--target", target]);
    folder.is_some_and(|folder| Path::new(&folder).is_dir())
}

/// The linker that comes with the toolchain.
fn linker() -> Option<PathBuf> {
    let own = Path::new(&rustc(&["--print", "target-libdir"])?).parent()?.join("bin/rust-lld");
    own.is_file().then_some(own)
}
