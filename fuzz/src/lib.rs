//! What must hold of any input: one function for each kind of input.
//!
//! Each takes bytes, makes an input of them, hands it to the project and panics where an assertion about the result fails. The fuzzer in
//! `targets/` looks for bytes that break one; what it found lies in `corpus/` and is replayed by `cargo test -p carom-fuzz`.

mod chains;
mod contacts;
mod draw;
mod feeders;
mod files;
mod rates;
mod texts;

pub use contacts::impact;
pub use feeders::planar;
pub use files::{outline, stl};
pub use rates::rate;
pub use texts::{impact_file, scene};

/// A target: its name, which is that of its folder in `corpus/`, and what it does with bytes.
pub type Target = (&'static str, fn(&[u8]));

/// Every target.
pub const TARGETS: [Target; 7] = [
    ("scene", scene),
    ("impact", impact),
    ("planar", planar),
    ("outline", outline),
    ("impact_file", impact_file),
    ("stl", stl),
    ("rate", rate),
];
