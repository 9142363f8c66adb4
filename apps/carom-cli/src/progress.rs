//! How far long work is, on a terminal.

use crate::tolerance::SHORTEST_SPENT;
use carom_scene::StudyRunReport;
use std::io::{IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Between two lines.
const PAUSE: Duration = Duration::from_millis(200);

/// What a study took, for its result.
pub(crate) fn spent(drops: usize, seconds: f64) -> StudyRunReport {
    StudyRunReport { drops, seconds, threads: carom_study::threads() }
}

/// Counts what has been done and says so on stderr, where that is a terminal, until it is dropped.
pub(crate) struct Progress {
    done: Arc<AtomicUsize>,
    over: Arc<AtomicBool>,
    teller: Option<JoinHandle<()>>,
    begun: Instant,
}

impl Progress {
    /// Begins to count; `whole` is how many there will be, where that is known.
    pub(crate) fn new(what: &'static str, whole: Option<usize>) -> Self {
        let (done, over) = (Arc::new(AtomicUsize::new(0)), Arc::new(AtomicBool::new(false)));
        let begun = Instant::now();
        let teller = std::io::stderr().is_terminal().then(|| {
            let (done, over) = (Arc::clone(&done), Arc::clone(&over));
            std::thread::spawn(move || tell(what, whole, begun, &done, &over))
        });
        Self { done, over, teller, begun }
    }

    /// One more is done.
    pub(crate) fn step(&self) {
        self.steps(1);
    }

    /// So many more are done.
    pub(crate) fn steps(&self, count: usize) {
        self.done.fetch_add(count, Ordering::Relaxed);
    }

    /// Time since the beginning [s].
    pub(crate) fn seconds(&self) -> f64 {
        self.begun.elapsed().as_secs_f64()
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
        if let Some(teller) = self.teller.take() {
            // It has nothing to say but its lines.
            let _ = teller.join();
        }
    }
}

fn tell(what: &str, whole: Option<usize>, begun: Instant, done: &AtomicUsize, over: &AtomicBool) {
    let mut said = Instant::now();
    while !over.load(Ordering::Relaxed) {
        std::thread::sleep(Duration::from_millis(20));
        if said.elapsed() >= PAUSE {
            said = Instant::now();
            let text = line(what, done.load(Ordering::Relaxed), whole, begun.elapsed());
            // There is nowhere to report that stderr is closed.
            let _ = write!(std::io::stderr(), "\r\x1b[K{text}");
        }
    }
    let _ = write!(std::io::stderr(), "\r\x1b[K");
}

/// `12000 of 48000 drops, 23000/s, 2 s left`
fn line(what: &str, done: usize, whole: Option<usize>, spent: Duration) -> String {
    let rate = done as f64 / spent.as_secs_f64().max(SHORTEST_SPENT);
    match whole {
        Some(whole) if rate > 0.0 => {
            let left = whole.saturating_sub(done) as f64 / rate;
            format!("{done} of {whole} {what}, {rate:.0}/s, {left:.0} s left")
        }
        _ => format!("{done} {what}, {rate:.0}/s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_says_how_long_it_will_take() {
        let two = Duration::from_secs(2);
        assert_eq!(line("drops", 1000, Some(5000), two), "1000 of 5000 drops, 500/s, 8 s left");
        assert_eq!(line("drops", 1000, None, two), "1000 drops, 500/s");
    }
}
