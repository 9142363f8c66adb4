//! Numbers that a test spoils.

use super::Quantity;
use std::cell::Cell;

/// Which evaluation gives no number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// None: they are counted.
    Never,
    /// This one alone.
    At(u64),
    /// This one and every later one.
    From(u64),
}

/// The quantity that is spoiled, which of its evaluations, how many there were, and how many there may be.
#[derive(Clone, Copy)]
struct Book {
    of: Quantity,
    fault: Fault,
    count: u64,
    most: u64,
}

const CLOSED: Book = Book { of: Quantity::Turn, fault: Fault::Never, count: 0, most: u64::MAX };

thread_local! {
    static BOOK: Cell<Book> = const { Cell::new(CLOSED) };
}

/// The number, or none where it is its turn.
///
/// # Panics
/// Where there are more evaluations than the test allows: whoever asks does not end.
pub(super) fn met(of: Quantity, value: f64) -> f64 {
    let mut book = BOOK.get();
    if book.of != of {
        return value;
    }
    let k = book.count;
    book.count += 1;
    BOOK.set(book);
    assert!(k < book.most, "{of:?} is evaluated without end with {:?}", book.fault);
    let spoiled = match book.fault {
        Fault::Never => false,
        Fault::At(at) => k == at,
        Fault::From(first) => k >= first,
    };
    if spoiled { f64::NAN } else { value }
}

/// Does something while evaluations of a quantity fail so; returns what came of it, and how many evaluations there were.
pub(crate) fn during<R>(of: Quantity, fault: Fault, most: u64, work: impl FnOnce() -> R) -> (R, u64) {
    BOOK.set(Book { of, fault, count: 0, most });
    let done = work();
    (done, BOOK.replace(CLOSED).count)
}
