//! The answers on a socket.

use crate::guard::Guard;
use crate::respond::{Site, respond};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use std::convert::Infallible;
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::Arc;
use std::time::Duration;
use thiserror::Error;
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

/// A client may take so long over its headers.
const MOST_OVER_HEADERS: Duration = Duration::from_secs(5);
/// And so long over the whole of a request and its answer.
const MOST_IN_ALL: Duration = Duration::from_secs(20);
/// Bytes of headers.
const MOST_HEADERS: usize = 16 << 10;
/// Connections at a time; more wait.
const MOST_AT_ONCE: usize = 64;

/// Why nothing can be served.
#[derive(Debug, Error)]
pub enum ServeError {
    /// The system does not give the port, or no port at all.
    #[error("cannot listen on {address}: {error}")]
    Port {
        /// What was asked for.
        address: SocketAddr,
        /// The system's own words.
        error: std::io::Error,
    },
    /// The system gives no random numbers.
    #[error("no token can be made: {0}")]
    Token(getrandom::Error),
    /// The system gives no event loop.
    #[error("no event loop can be made: {0}")]
    Loop(std::io::Error),
}

/// A server that listens already, and has yet to answer.
#[derive(Debug)]
pub struct Server {
    runtime: tokio::runtime::Runtime,
    listener: TcpListener,
    port: u16,
    guard: Guard,
}

impl Server {
    /// Listens on 127.0.0.1, on a free port where `port` is 0.
    ///
    /// # Errors
    /// See [`ServeError`].
    pub fn listen(port: u16) -> Result<Self, ServeError> {
        let runtime = tokio::runtime::Builder::new_current_thread()
            .enable_io()
            .enable_time()
            .build()
            .map_err(ServeError::Loop)?;
        let address = SocketAddr::from((Ipv4Addr::LOCALHOST, port));
        let refused = |error| ServeError::Port { address, error };
        let listener = runtime.block_on(TcpListener::bind(address)).map_err(refused)?;
        let port = listener.local_addr().map_err(refused)?.port();
        let guard = Guard::new(port).map_err(ServeError::Token)?;
        Ok(Self { runtime, listener, port, guard })
    }

    /// The address of the page. What stands after its mark is the token: the page sends it back, the browser sends it to nobody.
    pub fn address(&self) -> String {
        format!("http://127.0.0.1:{}/#token={}", self.port, self.guard.token())
    }

    /// Answers until the process ends.
    pub fn run(self, site: Site) {
        let Self { runtime, listener, guard, .. } = self;
        let (shared, room) = (Arc::new((site, guard)), Arc::new(Semaphore::new(MOST_AT_ONCE)));
        runtime.block_on(async {
            loop {
                let Ok(place) = room.clone().acquire_owned().await else { return };
                let Ok((stream, _)) = listener.accept().await else {
                    // As many files are open as may be: some will close.
                    tokio::time::sleep(Duration::from_millis(50)).await;
                    continue;
                };
                let shared = shared.clone();
                runtime.spawn(async move {
                    let answer = service_fn(move |request| {
                        let response = respond(&request, &shared.0, &shared.1);
                        async move { Ok::<_, Infallible>(response) }
                    });
                    let connection = http1::Builder::new()
                        .timer(TokioTimer::new())
                        .header_read_timeout(MOST_OVER_HEADERS)
                        .keep_alive(false)
                        .max_buf_size(MOST_HEADERS)
                        .serve_connection(TokioIo::new(stream), answer);
                    // A client that is slow or breaks off loses its answer, and nobody else does.
                    let _ended = tokio::time::timeout(MOST_IN_ALL, connection).await;
                    drop(place);
                });
            }
        });
    }
}
