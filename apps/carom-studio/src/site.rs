//! The site that `cargo xtask studio` built.

use crate::respond::Site;

macro_rules! file {
    ($name:literal) => {
        ($name, include_bytes!(concat!("../../carom-web/site/dist/site/", $name)).as_slice())
    };
}

/// The files of the studio.
pub fn site() -> Site {
    Site::new([
        file!("index.html"),
        file!("studio.js"),
        file!("studio.css"),
        file!("carom.wasm"),
        file!("carom-whole.wasm"),
    ])
}
