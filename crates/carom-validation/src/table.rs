//! A published result as it stands in its file.

use serde::{Deserialize, Serialize};
use std::fmt;

/// What a printed entry is worth beside ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Verdict {
    /// To the last printed digit, or within the row's tolerance.
    #[serde(rename = "agrees")]
    Agrees,
    /// Off by more than the last digit, within the share that the table states.
    #[serde(rename = "coarse in print")]
    Coarse,
    /// Lost or changed in print: what is meant follows from the rest of the source, and agrees.
    #[serde(rename = "misprint")]
    Misprint,
    /// Does not follow from the source's own assumptions.
    #[serde(rename = "wrong in print")]
    Wrong,
    /// Measured, and off by more than the measurement's own scatter: real bodies are not what the model takes them for.
    #[serde(rename = "beyond the model")]
    Beyond,
    /// None of these: a fault of ours or of the table.
    #[serde(rename = "fails")]
    Fails,
}

impl Verdict {
    /// Every verdict, the best first.
    pub const ALL: [Self; 6] =
        [Self::Agrees, Self::Coarse, Self::Misprint, Self::Wrong, Self::Beyond, Self::Fails];

    /// True of the verdicts that are declared: each disagrees with the print, and its row says how that shows.
    pub(crate) fn needs_evidence(self) -> bool {
        matches!(self, Self::Misprint | Self::Wrong | Self::Beyond)
    }

    /// Its name in tables and results.
    pub fn word(self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Coarse => "coarse in print",
            Self::Misprint => "misprint",
            Self::Wrong => "wrong in print",
            Self::Beyond => "beyond the model",
            Self::Fails => "fails",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// Up to which share entries of a table are coarse.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Coarse {
    /// Of our value.
    pub share: f64,
    /// Why the source is coarse.
    pub why: String,
}

/// How far ours may be from a row's entry in place of half its last digit.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tolerance {
    /// In the row's unit.
    pub within: f64,
    /// Why so much.
    pub why: String,
}

/// One printed entry, and what is known of it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    /// Its name in results.
    pub key: String,
    /// The source's letter for it, where it has one.
    #[serde(default)]
    pub letter: String,
    /// What it is, in words.
    pub what: String,
    /// Its unit; empty of pure numbers and of words.
    #[serde(default)]
    pub unit: String,
    /// As it is printed, to the letter; of a formula its value. What is printed may have been measured.
    pub printed: String,
    /// What the comparison is expected to say.
    pub expected: Verdict,
    /// Of a misprint what is meant; of a wrong entry what is right, where that is known apart from our value.
    #[serde(default)]
    pub meant: Option<String>,
    /// How a misprint or an error shows, or what of the measured bodies the model leaves out.
    #[serde(default)]
    pub evidence: String,
    /// Where half of the last printed digit is not what counts.
    #[serde(default)]
    pub tolerance: Option<Tolerance>,
}

/// A published result.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// In a few words.
    pub title: String,
    /// Where it is published.
    pub citation: String,
    /// What went in, SI.
    pub went_in: Vec<String>,
    /// What of it cannot be checked, and why.
    #[serde(default)]
    pub cannot_be_checked: Vec<String>,
    /// Up to which share entries are coarse; absent: none is.
    #[serde(default)]
    pub coarse: Option<Coarse>,
    /// The printed entries.
    #[serde(rename = "row")]
    pub rows: Vec<Row>,
}
