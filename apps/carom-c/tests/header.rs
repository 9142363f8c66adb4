//! The header that is committed is the one that the sources say.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::Path;

/// `write` in this variable of the environment writes the header anew.
const WRITE: &str = "CAROM_HEADER";

#[test]
fn the_header_is_what_the_sources_say() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).unwrap();
    let sources = ["src/plain.rs", "src/impact.rs", "src/abi.rs"];
    let builder = sources.iter().fold(cbindgen::Builder::new().with_config(config), |builder, path| {
        builder.with_src(root.join(path))
    });
    let mut made = vec![];
    builder.generate().unwrap().write(&mut made);
    // What Rust has a heading for is a sentence in C.
    let made = String::from_utf8(made).unwrap().replace("// # Safety\n// ", "// Memory: ");
    let place = root.join("include/carom.h");
    if std::env::var(WRITE).is_ok_and(|asked| asked == "write") {
        std::fs::write(&place, &made).unwrap();
    }
    let committed = std::fs::read_to_string(&place).unwrap_or_default();
    assert!(
        committed == made,
        "include/carom.h is not what the sources say: {WRITE}=write cargo test -p carom-c --test header writes it anew"
    );
}
