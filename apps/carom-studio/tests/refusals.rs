//! Who is refused: foreign names and pages, missing tokens, paths that climb, bodies, slow clients.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use carom_studio::{Guard, Server, Site, TOKEN_HEADER, respond};
use hyper::{Method, Request, StatusCode};
use std::collections::BTreeMap;
use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

const PORT: u16 = 4711;

fn site() -> Site {
    let files: [(&str, &[u8]); 2] = [("index.html", b"<p>the page</p>"), ("studio.js", b"let a = 1;")];
    Site::new(files).with_scene("mine.toml", "gravity = 9.81", &BTreeMap::new())
}

fn get(path: &str) -> hyper::http::request::Builder {
    Request::builder().method(Method::GET).uri(path).header("host", format!("127.0.0.1:{PORT}"))
}

fn status(request: hyper::http::request::Builder, guard: &Guard) -> StatusCode {
    respond(&request.body(()).unwrap(), &site(), guard).status()
}

#[test]
fn the_page_is_served_with_a_policy_that_allows_nothing_inline() {
    let guard = Guard::new(PORT).unwrap();
    let response = respond(&get("/").body(()).unwrap(), &site(), &guard);
    assert_eq!(response.status(), StatusCode::OK, "the page");
    let header = |name: &str| response.headers()[name].to_str().unwrap().to_owned();
    assert!(!header("content-security-policy").contains("unsafe-inline"), "nothing inline");
    assert!(header("content-security-policy").starts_with("default-src 'none'"), "nothing from elsewhere");
    let fixed = ["x-content-type-options", "referrer-policy", "cross-origin-opener-policy", "cache-control"];
    assert_eq!(fixed.map(header), ["nosniff", "no-referrer", "same-origin", "no-store"], "headers");
    assert!(response.headers().get("access-control-allow-origin").is_none(), "no other page reads it");
}

#[test]
fn foreign_names_are_refused_before_anything_else() {
    let guard = Guard::new(PORT).unwrap();
    for host in ["evil.example", "127.0.0.1", "127.0.0.1:80", "127.0.0.1:4711.evil.example", "localhost", ""]
    {
        let request = Request::builder().uri("/").header("host", host);
        assert_eq!(status(request, &guard), StatusCode::FORBIDDEN, "host {host:?}");
    }
    assert_eq!(status(Request::builder().uri("/"), &guard), StatusCode::FORBIDDEN, "no host");
    assert_eq!(status(get("/").header("host", "evil.example"), &guard), StatusCode::FORBIDDEN, "two hosts");
    assert_eq!(
        status(Request::builder().uri("/").header("host", "localhost:4711"), &guard),
        StatusCode::OK,
        "ours"
    );
}

#[test]
fn foreign_pages_are_refused() {
    let guard = Guard::new(PORT).unwrap();
    for origin in ["http://evil.example", "null", "https://127.0.0.1:4711", "http://127.0.0.1:4712"] {
        assert_eq!(
            status(get("/").header("origin", origin), &guard),
            StatusCode::FORBIDDEN,
            "origin {origin}"
        );
    }
    for site in ["cross-site", "same-site"] {
        assert_eq!(
            status(get("/").header("sec-fetch-site", site), &guard),
            StatusCode::FORBIDDEN,
            "from {site}"
        );
    }
    let own = get("/").header("origin", "http://127.0.0.1:4711").header("sec-fetch-site", "same-origin");
    assert_eq!(status(own, &guard), StatusCode::OK, "its own page");
}

#[test]
fn the_scene_needs_the_whole_token() {
    let guard = Guard::new(PORT).unwrap();
    let token = guard.token().to_owned();
    assert_eq!(token.len(), 32, "128 bits");
    assert_ne!(token, Guard::new(PORT).unwrap().token(), "each start has its own");
    assert_eq!(status(get("/scene"), &guard), StatusCode::FORBIDDEN, "none");
    let wrong = ["", &token[1..], &format!("{token}0"), &"0".repeat(32), "é"];
    for wrong in wrong {
        assert_eq!(
            status(get("/scene").header(TOKEN_HEADER, wrong), &guard),
            StatusCode::FORBIDDEN,
            "{wrong:?}"
        );
    }
    assert_eq!(status(get("/scene").header(TOKEN_HEADER, &token), &guard), StatusCode::OK, "the right one");
}

#[test]
fn paths_lead_to_the_sites_own_files_alone() {
    let guard = Guard::new(PORT).unwrap();
    for path in [
        "/../etc/passwd",
        "/%2e%2e/etc/passwd",
        "//etc/passwd",
        "/index.html/..",
        "/studio.js/",
        "/Studio.js",
        "/scene/",
    ] {
        assert_eq!(status(get(path), &guard), StatusCode::NOT_FOUND, "{path}");
    }
    assert_eq!(status(get("/studio.js?x=../.."), &guard), StatusCode::OK, "a query means nothing");
}

#[test]
fn nothing_is_written_and_no_body_is_read() {
    let guard = Guard::new(PORT).unwrap();
    for method in [Method::POST, Method::PUT, Method::DELETE, Method::PATCH, Method::OPTIONS, Method::TRACE] {
        assert_eq!(status(get("/scene").method(&method), &guard), StatusCode::METHOD_NOT_ALLOWED, "{method}");
    }
    let huge = get("/").header("content-length", "99999999999");
    assert_eq!(status(huge, &guard), StatusCode::PAYLOAD_TOO_LARGE, "a huge body");
    let endless = get("/").header("transfer-encoding", "chunked");
    assert_eq!(status(endless, &guard), StatusCode::PAYLOAD_TOO_LARGE, "a body without end");
}

#[test]
fn on_a_socket_slow_clients_and_long_headers_are_let_go_while_others_are_served() {
    let server = Server::listen(0).unwrap();
    let address = server.address();
    let (host, token) = address.strip_prefix("http://").unwrap().split_once("/#token=").unwrap();
    let (host, token) = (host.to_owned(), token.to_owned());
    std::thread::spawn(move || server.run(site()));
    // One sends half a request and waits.
    let mut slow = TcpStream::connect(&host).unwrap();
    slow.write_all(b"GET / HTTP/1.1\r\nHost: ").unwrap();
    let whole = |head: &str| {
        let mut stream = TcpStream::connect(&host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        // What does not fit may be refused before it is sent whole.
        let _sent = stream.write_all(head.as_bytes());
        let mut answer = String::new();
        let _read = stream.read_to_string(&mut answer);
        answer
    };
    let page = whole(&format!("GET / HTTP/1.1\r\nHost: {host}\r\n\r\n"));
    assert!(page.starts_with("HTTP/1.1 200") && page.ends_with("<p>the page</p>"), "{page}");
    let scene = whole(&format!("GET /scene HTTP/1.1\r\nHost: {host}\r\n{TOKEN_HEADER}: {token}\r\n\r\n"));
    assert!(scene.ends_with(r#"{"files":{},"name":"mine.toml","text":"gravity = 9.81"}"#), "{scene}");
    let long = whole(&format!("GET / HTTP/1.1\r\nHost: {host}\r\nX: {}\r\n\r\n", "a".repeat(1 << 20)));
    assert!(!long.starts_with("HTTP/1.1 200"), "a megabyte of headers: {long}");
    slow.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
    let mut left = vec![];
    let waits = |error: &std::io::Error| matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut);
    let closed = slow.read_to_end(&mut left);
    assert!(!closed.as_ref().is_err_and(waits), "a client that says nothing more is let go: {closed:?}");
}
