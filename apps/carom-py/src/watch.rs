//! Long work: on all cores, without the lock of the interpreter, told of and stopped.

use crate::failure::of_fault;
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::Duration;

/// How often the interpreter is asked whether it was told to stop, and the caller hears how far the work is.
const PAUSE: Duration = Duration::from_millis(50);

/// How far some work is, and whether it should go on.
#[derive(Default)]
pub(crate) struct Watch {
    done: AtomicUsize,
    stopped: AtomicBool,
}

impl Watch {
    /// One more piece is done. Where nobody waits for the answer any more, the work ends here: it unwinds to where [`long`] began it, and what
    /// it has so far is dropped. No hook of a panic is called.
    pub(crate) fn step(&self) {
        self.steps(1);
    }

    /// So many more pieces are done.
    pub(crate) fn steps(&self, pieces: usize) {
        self.done.fetch_add(pieces, Ordering::Relaxed);
        if self.stopped.load(Ordering::Relaxed) {
            std::panic::resume_unwind(Box::new("stopped"));
        }
    }
}

/// The threads, and the process that started them.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// This process's threads. A process that is forked has none of its parent's, though it remembers them: it starts its own.
pub(crate) fn pool() -> PyResult<Arc<ThreadPool>> {
    let own = std::process::id();
    let mut known = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((process, pool)) = &*known
        && *process == own
    {
        return Ok(Arc::clone(pool));
    }
    let pool = Arc::new(ThreadPoolBuilder::new().build().map_err(of_fault)?);
    // Who drops the parent's waits for threads that are not there.
    std::mem::forget(known.replace((own, Arc::clone(&pool))));
    Ok(pool)
}

/// Gives this process so many threads, in place of one for each core: where several processes share a machine.
#[pyfunction]
pub(crate) fn use_threads(threads: usize) -> PyResult<()> {
    let pool = Arc::new(ThreadPoolBuilder::new().num_threads(threads).build().map_err(of_fault)?);
    let mut known = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    std::mem::forget(known.replace((std::process::id(), pool)));
    Ok(())
}

/// Does some work, of so many pieces, on all cores. `progress` is called with how many are done and how many there are.
///
/// # Errors
/// What a signal's handler or `progress` raises: the work is stopped first.
pub(crate) fn long<T: Send>(
    py: Python<'_>,
    pieces: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Watch) -> T + Send,
) -> PyResult<T> {
    let pool = pool()?;
    let (watch, over) = (Watch::default(), (Mutex::new(false), Condvar::new()));
    std::thread::scope(|scope| {
        let worker = scope.spawn(|| {
            // However it ends, who waits is told.
            let _told = Told(&over);
            pool.install(|| work(&watch))
        });
        while !py.detach(|| waited(&over)) {
            let told = || progress.map(|hear| hear.call1((watch.done.load(Ordering::Relaxed), pieces)));
            if let Err(error) = py.check_signals().and_then(|()| told().transpose().map(drop)) {
                watch.stopped.store(true, Ordering::Relaxed);
                let _ = py.detach(|| worker.join());
                return Err(error);
            }
        }
        let found = worker.join().map_err(|panic| {
            let words = panic.downcast_ref::<String>().map(String::as_str);
            of_fault(words.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("it panicked"))
        })?;
        // The end is told too: a bar that stops before it looks as if something was lost.
        let done = watch.done.load(Ordering::Relaxed);
        progress.map(|hear| hear.call1((done.max(pieces.unwrap_or(done)), pieces))).transpose()?;
        Ok(found)
    })
}

/// Says that the work is over when it is dropped.
struct Told<'a>(&'a (Mutex<bool>, Condvar));

impl Drop for Told<'_> {
    fn drop(&mut self) {
        *self.0.0.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.0.1.notify_all();
    }
}

/// Waits for a while; true where the work is over.
fn waited((over, tell): &(Mutex<bool>, Condvar)) -> bool {
    let over = over.lock().unwrap_or_else(PoisonError::into_inner);
    *tell.wait_timeout_while(over, PAUSE, |over| !*over).unwrap_or_else(PoisonError::into_inner).0
}
