//! Instructions of a drop, counted by valgrind: the same every time, on a busy machine too.

use crate::PROGRAMS;
use std::process::Command;

/// Passes over all drops of the longer of both runs; what preparing takes cancels out.
const PASSES: usize = 5;

/// Instructions of a drop for each program; `None` without valgrind.
pub(crate) fn count(drops: usize) -> Vec<Option<f64>> {
    PROGRAMS
        .iter()
        .map(|(name, _)| {
            let (one, many) = (counted(name, 1)?, counted(name, PASSES)?);
            #[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
            let each = (many - one) as f64 / ((PASSES - 1) * drops) as f64;
            Some(each)
        })
        .collect()
}

/// Instructions of this program when it runs one of the programs over all drops.
fn counted(name: &str, passes: usize) -> Option<u64> {
    let this = std::env::current_exe().ok()?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(this)
        .args([name, &passes.to_string()])
        .output()
        .ok()?;
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = said.lines().find_map(|line| line.split_once("Collected :"))?.1;
    line.trim().parse().ok()
}
