//! Time of a drop: all programs in turn, round by round.

use crate::{PROGRAMS, Ready};
use carom_feeder::Feeder;
use carom_floor::Design;
use std::time::Instant;

/// Rounds; in each every program does every drop once, all programs one drop in turn.
const ROUNDS: usize = 200;

/// Nanoseconds of a drop: of each program the least and the median over the rounds, each drop by itself, and their means over the drops.
/// A drop is so short that a busy machine leaves most of them alone.
pub(crate) fn measure(designs: &[Design], feeders: &[Feeder]) -> Result<Vec<(f64, f64)>, String> {
    let ready: Result<Vec<_>, _> =
        PROGRAMS.iter().map(|(_, program)| Ready::new(*program, designs, feeders)).collect();
    let mut programs: Vec<_> =
        ready?.into_iter().map(|program| (program, vec![vec![]; designs.len()])).collect();
    for _ in 0..ROUNDS {
        for number in 0..designs.len() {
            for (program, times) in &mut programs {
                let start = Instant::now();
                program.run(number)?;
                times[number].push(1e9 * start.elapsed().as_secs_f64());
            }
        }
    }
    #[expect(clippy::cast_precision_loss, reason = "far below 2^52")]
    let drops = designs.len() as f64;
    let mean = |(_, mut times): (_, Vec<Vec<f64>>)| {
        times.iter_mut().for_each(|t| t.sort_by(f64::total_cmp));
        let over = |of: &dyn Fn(&[f64]) -> f64| times.iter().map(|t| of(t)).sum::<f64>() / drops;
        (over(&|t| t[0]), over(&|t| t[t.len() / 2]))
    };
    Ok(programs.into_iter().map(mean).collect())
}

/// Prints the table: each of Carom's rows with the floor's below and the ratio.
pub(crate) fn report(times: &[(f64, f64)], counts: &[Option<f64>]) {
    println!("| program | ns a drop, least | median | instructions a drop |\n|---|---|---|---|");
    let shown = |count: Option<f64>| count.map_or("-".to_owned(), |c| format!("{c:.0}"));
    for pair in 0..PROGRAMS.len() / 2 {
        let (carom, floor) = (2 * pair, 2 * pair + 1);
        for k in [carom, floor] {
            println!("| {} | {:.0} | {:.0} | {} |", PROGRAMS[k].0, times[k].0, times[k].1, shown(counts[k]));
        }
        let ratio = counts[carom].zip(counts[floor]).map_or("-".to_owned(), |(c, f)| format!("{:.1}", c / f));
        println!(
            "| ratio | {:.1} | {:.1} | {ratio} |",
            times[carom].0 / times[floor].0,
            times[carom].1 / times[floor].1
        );
    }
}
