//! The studio on this machine: its page and one scene, for the browser of the person who started it.
//!
//! The page computes by itself; here are only files to read. Whoever else can reach the port, another page in the same browser for one, gets
//! nothing:
//!
//! - it listens on 127.0.0.1 alone, and answers to its own names alone ([`Guard`]);
//! - the scene needs a token that stands after the mark of the printed address, which browsers send to nobody;
//! - it reads no body, follows no path and writes nothing.
//!
//! [`respond`] is a plain function of a request, so all of this is tested without a socket; [`Server`] puts it on one.

mod guard;
mod respond;
mod serve;
#[cfg(feature = "site")]
mod site;

pub use guard::{Guard, TOKEN_HEADER};
pub use respond::{Site, respond};
pub use serve::{ServeError, Server};
#[cfg(feature = "site")]
pub use site::site;
