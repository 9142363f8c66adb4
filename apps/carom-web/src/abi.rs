//! What the module exports: room for a request, the answer to it, and where that stands.
//!
//! The page writes the request where [`carom_room`] says, calls [`carom_answer`] and reads as many bytes as it returns from where
//! [`carom_place`] says. Both places are vectors of this module, so no pointer is followed here.
#![allow(
    unsafe_code,
    reason = "an exported or imported name is an attribute that counts as unsafe; nothing else here does"
)]

use crate::Watch;
use std::cell::RefCell;

// What the page is told while it waits.
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// A drop was computed.
    safe fn step();
    /// News: where they stand, and their bytes.
    safe fn told(place: *const u8, length: usize);
}

struct Page;

impl Watch for Page {
    fn step(&self) {
        step();
    }

    fn told(&self, news: &str) {
        told(news.as_ptr(), news.len());
    }
}

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
    static ANSWER: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
}

/// Room for a request of so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn carom_room(length: usize) -> *mut u8 {
    REQUEST.with_borrow_mut(|request| {
        request.clear();
        request.resize(length, 0);
        request.as_mut_ptr()
    })
}

/// Answers the request that was written there; returns the bytes of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn carom_answer() -> usize {
    std::panic::set_hook(Box::new(|panic| {
        let words = panic.to_string().into_bytes();
        ANSWER.with_borrow_mut(|answer| *answer = words);
    }));
    let answer = REQUEST.with_borrow(|request| crate::answer(&String::from_utf8_lossy(request), &Page));
    let length = answer.len();
    ANSWER.with_borrow_mut(|place| *place = answer.into_bytes());
    length
}

/// Where the answer stands; after a panic, its message.
#[unsafe(no_mangle)]
pub extern "C" fn carom_place() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.as_ptr())
}

/// The bytes of the answer, or of a panic's message.
#[unsafe(no_mangle)]
pub extern "C" fn carom_length() -> usize {
    ANSWER.with_borrow(Vec::len)
}
