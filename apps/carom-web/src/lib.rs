//! Carom in a web page.
//!
//! The page has the engine as one WebAssembly module in a worker. It sends a request as JSON and gets an answer as JSON: [`answer`] is all
//! there is, and it needs no browser to be tested. The module has no clock, no disk and no network: it imports two functions, by which
//! the page hears how far long work is.
//!
//! There are two modules: the bench alone, which a page loads first, and the whole engine (feature `whole`), which it loads where the bench
//! answers that somebody else knows.
//!
//! Every request brings its scene as text, so a worker that dies takes nothing with it. The page draws what it gets: which values a
//! dragged plate needs, what a run does and how it looks is decided here.

#[cfg(target_arch = "wasm32")]
mod abi;
mod answer;
mod asked;
mod bench;
#[cfg(feature = "whole")]
mod design;
mod edit;
#[cfg(feature = "whole")]
mod fields;
#[cfg(feature = "whole")]
mod lab;
#[cfg(feature = "whole")]
mod portions;
#[cfg(feature = "whole")]
mod regions;
mod reply;
mod request;
#[cfg(feature = "whole")]
mod rolling;
#[cfg(feature = "whole")]
mod solid;
mod watch;
#[cfg(feature = "whole")]
mod whole;

pub use reply::{
    BesideShown, Candidate, DesignAsked, DesignFound, DesignLimit, Failure, ForcesShown, FreeRange, Grip,
    Headline, LabGrip, LabShown, NamedText, QuantityShown, Reply, Sections, Seen, SolidShown,
};
pub use request::{Ask, Change, Frame, Held, Pulled, PulledKey, Request, Shared, Side, Study, Table, Window};
pub use watch::Watch;

/// Answers one request; `watch` hears how far it is.
///
/// # Example
/// ```
/// let scene = std::fs::read_to_string("../../examples/case_2.toml")?;
/// let request = serde_json::json!({ "name": "case_2.toml", "text": scene, "ask": { "show": { "frame": { "size": [800.0, 600.0] } } } });
/// let answer: serde_json::Value = serde_json::from_str(&carom_web::answer(&request.to_string(), &()))?;
/// assert_eq!(answer["headline"]["word"], "turned");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn answer(request: &str, watch: &dyn Watch) -> String {
    let reply = match serde_json::from_str::<Request>(request) {
        Ok(request) => request.answer(watch).unwrap_or_else(Reply::of_failure),
        Err(error) => Reply::of_failure(Failure::of_page(&format!("the request cannot be read: {error}"))),
    };
    serde_json::to_string(&reply).unwrap_or_else(|_| "{}".to_owned())
}
