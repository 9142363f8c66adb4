//! A request and the answer to it.

use crate::guard::Guard;
use bytes::Bytes;
use http_body_util::Full;
use hyper::header::{
    CACHE_CONTROL, CONTENT_SECURITY_POLICY, CONTENT_TYPE, HeaderName, HeaderValue, REFERRER_POLICY,
};
use hyper::{Method, Request, Response, StatusCode};
use std::collections::BTreeMap;

/// What the page may do: its own scripts and styles, its own engine, a worker that it makes itself. Nothing from elsewhere, nothing inline.
const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src data:; \
                      connect-src 'self'; worker-src blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// Sent with every answer.
const HEADERS: [(HeaderName, &str); 6] = [
    (CACHE_CONTROL, "no-store"),
    (CONTENT_SECURITY_POLICY, POLICY),
    (REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("x-content-type-options"), "nosniff"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
];

/// The files that are served, by the path they are asked for, and the scene.
#[derive(Clone, Debug, Default)]
pub struct Site {
    files: BTreeMap<String, Bytes>,
    scene: Option<Bytes>,
}

impl Site {
    /// These files; `index.html` is the page itself.
    pub fn new(files: impl IntoIterator<Item = (&'static str, &'static [u8])>) -> Self {
        let path = |name: &str| if name == "index.html" { "/".to_owned() } else { format!("/{name}") };
        let files = files.into_iter().map(|(name, bytes)| (path(name), Bytes::from_static(bytes)));
        Self { files: files.collect(), scene: None }
    }

    /// With this scene to open: its name, its text, and the files that it names.
    #[must_use]
    pub fn with_scene(self, name: &str, text: &str, files: &BTreeMap<String, String>) -> Self {
        let scene = serde_json::json!({ "name": name, "text": text, "files": files });
        Self { scene: Some(scene.to_string().into()), ..self }
    }
}

/// Answers a request; its body is not looked at.
pub fn respond<B>(request: &Request<B>, site: &Site, guard: &Guard) -> Response<Full<Bytes>> {
    let path = request.uri().path();
    let (status, kind, body) = match guard.admit(request) {
        Err((status, why)) => (status, "text/plain", Bytes::from_static(why.as_bytes())),
        Ok(()) if path == "/scene" => match &site.scene {
            Some(_) if !guard.knows(request.headers()) => {
                (StatusCode::FORBIDDEN, "text/plain", "the token is missing or wrong".into())
            }
            Some(scene) => (StatusCode::OK, "application/json", scene.clone()),
            None => missing(),
        },
        Ok(()) => {
            site.files.get(path).map_or_else(missing, |file| (StatusCode::OK, kind_of(path), file.clone()))
        }
    };
    let body = if request.method() == Method::HEAD { Bytes::new() } else { body };
    let mut response = Response::new(Full::new(body));
    *response.status_mut() = status;
    for (name, value) in HEADERS {
        response.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    response.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(kind));
    response
}

fn missing() -> (StatusCode, &'static str, Bytes) {
    (StatusCode::NOT_FOUND, "text/plain", Bytes::from_static(b"there is no such file"))
}

fn kind_of(path: &str) -> &'static str {
    match path.rsplit('.').next() {
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("wasm") => "application/wasm",
        _ => "text/html; charset=utf-8",
    }
}
