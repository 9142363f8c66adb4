//! Calls that fail because a test says so.

use carom_sweep::disk::{Call, heard_by};
use std::cell::RefCell;
use std::io::{Error, ErrorKind, Result, Write};
use std::path::{Path, PathBuf};

/// How the system says why.
pub(crate) const CAUSE: ErrorKind = ErrorKind::StorageFull;

/// Which call fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fault {
    /// None: calls are counted.
    Never,
    /// This one alone.
    At(usize),
    /// This one and every later one: the disk is gone, or the process was ended.
    From(usize),
}

/// The calls of a test so far, and which of them fails.
struct Book {
    fault: Fault,
    calls: Vec<(Call, PathBuf)>,
}

thread_local! {
    /// The command runs on the thread of its test: every test has a book of its own.
    static BOOK: RefCell<Book> = const { RefCell::new(Book { fault: Fault::Never, calls: vec![] }) };
}

/// Notes a call, which fails where it is its turn.
fn meet(call: Call, path: &Path) -> Result<()> {
    BOOK.with_borrow_mut(|book| {
        let k = book.calls.len();
        book.calls.push((call, path.to_owned()));
        let fails = match book.fault {
            Fault::Never => false,
            Fault::At(at) => k == at,
            Fault::From(first) => k >= first,
        };
        if fails { Err(Error::from(CAUSE)) } else { Ok(()) }
    })
}

/// Does something with this fault; returns what came of it, and the calls.
pub(crate) fn during<R>(fault: Fault, work: impl FnOnce() -> R) -> (R, Vec<(Call, PathBuf)>) {
    BOOK.set(Book { fault, calls: vec![] });
    heard_by(Some(Box::new(meet)));
    let done = work();
    heard_by(None);
    (done, BOOK.replace(Book { fault: Fault::Never, calls: vec![] }).calls)
}

/// Where the calls of the output are said to go.
pub(crate) const OUTPUT: &str = "the output";

/// An output that fails in its turn as files do.
#[derive(Default)]
pub(crate) struct Printed(pub(crate) Vec<u8>);

impl Write for Printed {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        meet(Call::Write, Path::new(OUTPUT))?;
        self.0.write(bytes)
    }

    fn flush(&mut self) -> Result<()> {
        meet(Call::Sync, Path::new(OUTPUT))
    }
}
