//! Who may ask.

use hyper::header::{CONTENT_LENGTH, HOST, HeaderName, ORIGIN, TRANSFER_ENCODING};
use hyper::{HeaderMap, Method, Request, StatusCode};

/// The header in which the page sends its token.
pub const TOKEN_HEADER: &str = "x-carom-token";

/// What a request must bring. A foreign page may lead a browser here by a name of its own, so the name that was asked for is held against a
/// list and not against the origin, which is the stranger's too.
#[derive(Clone, Debug)]
pub struct Guard {
    hosts: [String; 2],
    token: String,
}

impl Guard {
    /// For a server on this port, with a new token.
    ///
    /// # Errors
    /// Where the system gives no random numbers.
    pub fn new(port: u16) -> Result<Self, getrandom::Error> {
        let mut bits = [0; 16];
        getrandom::fill(&mut bits)?;
        let token = bits.iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(Self { hosts: [format!("127.0.0.1:{port}"), format!("localhost:{port}")], token })
    }

    /// What the page sends back to get the scene.
    pub fn token(&self) -> &str {
        &self.token
    }

    /// Whether a request may be answered at all.
    ///
    /// # Errors
    /// The status it is refused with, and why.
    pub fn admit<B>(&self, request: &Request<B>) -> Result<(), (StatusCode, &'static str)> {
        let headers = request.headers();
        let ours = |host: &str| self.hosts.iter().any(|own| own == host);
        let named: Vec<_> = headers.get_all(HOST).iter().collect();
        let known = matches!(named.as_slice(), [host] if host.to_str().is_ok_and(ours));
        if !known {
            return Err((StatusCode::FORBIDDEN, "not a name of this server"));
        }
        let own_origin = |origin: &str| origin.strip_prefix("http://").is_some_and(ours);
        if headers.get(ORIGIN).is_some_and(|origin| !origin.to_str().is_ok_and(own_origin)) {
            return Err((StatusCode::FORBIDDEN, "another page asks"));
        }
        let site = headers.get(HeaderName::from_static("sec-fetch-site"));
        if site.is_some_and(|site| !matches!(site.as_bytes(), b"none" | b"same-origin")) {
            return Err((StatusCode::FORBIDDEN, "another site asks"));
        }
        if !matches!(*request.method(), Method::GET | Method::HEAD) {
            return Err((StatusCode::METHOD_NOT_ALLOWED, "there are only files to read"));
        }
        let empty = headers.get(CONTENT_LENGTH).is_none_or(|length| length.as_bytes() == b"0");
        if !empty || headers.contains_key(TRANSFER_ENCODING) {
            return Err((StatusCode::PAYLOAD_TOO_LARGE, "no body is read"));
        }
        Ok(())
    }

    /// Whether the token came along. The time that it takes says nothing of how much of it was right.
    pub fn knows(&self, headers: &HeaderMap) -> bool {
        let given = headers.get(TOKEN_HEADER).map_or(&[][..], |token| token.as_bytes());
        let own = self.token.as_bytes();
        let differs = own.iter().zip(given).fold(0, |differs, (a, b)| differs | (a ^ b));
        given.len() == own.len() && std::hint::black_box(differs) == 0
    }
}
