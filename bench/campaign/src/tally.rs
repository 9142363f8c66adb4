//! What a campaign counts.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Counts by name, and the largest of each residual with the case it came from.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tally {
    counts: BTreeMap<String, u64>,
    worst: BTreeMap<&'static str, (f64, u64)>,
    /// Cases that broke a promise: what, and which.
    pub(crate) broken: BTreeMap<&'static str, Vec<u64>>,
}

/// Cases of one kind that are named; the others are only counted.
const NAMED: usize = 8;

/// An error without its numbers, so that errors of one kind count as one.
pub(crate) fn kind_of(error: &str) -> String {
    let without = |word: &str| {
        if word.contains(|c: char| c.is_ascii_digit()) { "n".to_owned() } else { word.to_owned() }
    };
    error.split(' ').map(without).collect::<Vec<_>>().join(" ")
}

impl Tally {
    pub(crate) fn count(&mut self, what: impl Into<String>) {
        *self.counts.entry(what.into()).or_default() += 1;
    }

    /// Notes a residual; one above `most`, or one that is no number, breaks a promise.
    pub(crate) fn residual(&mut self, what: &'static str, value: f64, most: f64, case: u64) {
        let worst = self.worst.entry(what).or_insert((0.0, case));
        if value > worst.0 || value.is_nan() {
            *worst = (value, case);
        }
        if value > most || value.is_nan() {
            self.breaks(what, case);
        }
    }

    pub(crate) fn breaks(&mut self, what: &'static str, case: u64) {
        self.broken.entry(what).or_default().push(case);
        self.count(format!("BROKEN: {what}"));
    }

    /// Runs one case; a panic breaks a promise and does not end the campaign.
    pub(crate) fn guarded(&mut self, case: u64, work: impl FnOnce(&mut Self)) {
        let mut own = Self::default();
        match catch_unwind(AssertUnwindSafe(|| {
            work(&mut own);
            own
        })) {
            Ok(own) => self.take(own),
            Err(_) => self.breaks("a panic", case),
        }
    }

    /// Takes another's counts in.
    pub(crate) fn take(&mut self, other: Self) {
        for (what, n) in other.counts {
            *self.counts.entry(what).or_default() += n;
        }
        for (what, (value, case)) in other.worst {
            let worst = self.worst.entry(what).or_insert((value, case));
            // Of equals the first case, whichever thread was quicker.
            if value > worst.0 || value.is_nan() || (value == worst.0 && case < worst.1) {
                *worst = (value, case);
            }
        }
        for (what, cases) in other.broken {
            self.broken.entry(what).or_default().extend(cases);
        }
    }

    pub(crate) fn merged(mut self, other: Self) -> Self {
        self.take(other);
        self
    }

    /// As a piece of Markdown.
    pub(crate) fn page(&self) -> String {
        let mut page = "| outcome | cases |\n|---|---|\n".to_owned();
        for (what, n) in &self.counts {
            page += &format!("| {what} | {n} |\n");
        }
        page += "\n| residual | largest | in case |\n|---|---|---|\n";
        for (what, (value, case)) in &self.worst {
            page += &format!("| {what} | {value:.1e} | {case} |\n");
        }
        for (what, cases) in &self.broken {
            let mut cases = cases.clone();
            cases.sort_unstable();
            let named: Vec<String> = cases.iter().take(NAMED).map(u64::to_string).collect();
            page += &format!(
                "\n{what}: cases {}{}\n",
                named.join(", "),
                if cases.len() > NAMED { ", …" } else { "" }
            );
        }
        page
    }
}
