//! The commands, each on an empty folder or over an earlier result.

use super::{CAUSE, empty, every_call_fails};
use crate::lines::answer_lines;
use std::io::{BufReader, Read};

/// Commands that make so many calls at least, each of which may fail: on an empty folder, or after another command.
macro_rules! fails {
    ($($name:ident: $least:literal, $words:expr $(, after $before:expr)* $(, by $long:ident)?;)*) => { $(
        #[test]
        fn $name() {
            let long = [$(stringify!($long))?].contains(&"turns");
            let calls = every_call_fails(stringify!($name), &[$(&$before),*], &$words, long);
            assert!(calls >= $least, "{calls} calls");
        }
    )* };
}

fails! {
    run: 21, ["run", "case_1.toml"];
    run_over_others: 21, ["run", "case_1.toml"], after ["run", "case_1.toml", "--limits"];
    run_of_several: 42, ["run", "--paper", "case_1.toml", "case_2.toml"], after ["run", "case_1.toml"];
    run_with_a_feed: 24, ["run", "feed_closely.toml"], by turns;
    run_with_an_outline: 18, ["run", "bracket.toml", "--format", "json"], by turns;
    watch: 18, ["watch", "case_1.toml", "--runs", "1"], by turns;
    draw: 6, ["draw", "case_1.toml"];
    new: 6, ["new", "mine.toml"];
    schema: 6, ["schema", "run"];
    impact: 18, ["impact", "impact_box.toml"];
    contact: 6, ["contact", "contact_painleve.toml"];
    impact_in_space: 12, ["impact", "impact_twist.toml"];
    roll_of_a_prism: 12, ["roll", "prism", "roll_prism.toml"], after ["roll", "prism"];
    roll_of_a_pyramid: 12, ["roll", "pyramid"];
    throws: 12, ["roll", "body", "roll_body.toml", "--throws", "16"];
    regions: 30, ["regions", "--file", "impact_box.toml", "--depth", "0",
        "--x", "body.spin=-9..9:3", "--y", "contact.0.friction=0.1..1:3"];
    map: 30, ["map", "designer.toml", "--depth", "0", "--accuracy", "0.01",
        "--x", "plate.lower.slope=5..40 deg:3", "--y", "contact.friction=0.05..0.5:3"], by turns;
    yields: 20, ["yield", "designer.toml", "--samples", "64"],
        after ["yield", "designer.toml", "--samples", "32", "--seed", "3"], by turns;
    feed: 20, ["feed", "zigzag.toml", "--intervals", "16", "--parts", "2", "--accuracy", "0.01"], by turns;
    validate: 12, ["validate", "incline"];
    sweep: 34, SWEEP;
    sweep_by_shards: 20, SHARD, after ["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.9:20", "--shard", "1/2"], by turns;
    sweep_of_another_kind: 40, [&SWEEP[..], &["--force"]].concat(), after OTHER, by turns;
}

/// Cheap designs for three part files.
const SWEEP: [&str; 4] = ["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.9:20"];
const SHARD: [&str; 6] =
    ["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.9:20", "--shard", "2/2"];
const OTHER: [&str; 4] = ["sweep", "designer.toml", "--grid", "contact.friction=0.6..0.9:12"];

#[test]
fn sweep_of_a_list() {
    let folder = empty("list");
    let list = folder.join("designs.csv");
    // Longer than what is read at once.
    let rows = (0..20).map(|i| format!("{}{}\n", " ".repeat(1000), 0.5 + 0.02 * f64::from(i)));
    std::fs::write(&list, format!("contact.friction\n{}", rows.collect::<String>())).unwrap();
    let words = ["sweep", "designer.toml", "--list", list.to_str().unwrap()];
    let calls = every_call_fails("sweep_of_a_list", &[], &words, false);
    assert!(calls >= 45, "{calls} calls");
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn a_stream_of_impacts_that_breaks_off() {
    let impact = r#"{"body":{"mass":1,"inertia":1,"velocity":[0,-1],"spin":0},"contact":[{"point":[0,-1],"normal":[0,1],"friction":0.1,"restitution":0.5}]}"#;
    let text = format!("{impact}\n").repeat(3);
    let stream = |reads: Option<usize>| {
        let mut input = BufReader::with_capacity(64, Breaking { text: text.as_bytes(), reads });
        let mut out = vec![];
        (answer_lines(&mut input, &mut out, crate::impact::answer), String::from_utf8(out).unwrap())
    };
    let (done, whole) = stream(None);
    done.unwrap_or_else(|failure| panic!("{failure}: {whole}"));
    for k in 0..text.len().div_ceil(64) {
        let (done, said) = stream(Some(k));
        let failure = done.unwrap_err();
        assert!(failure.code() == 1 && failure.to_string().contains("stdin"), "read {k}: {failure}");
        assert!(whole.starts_with(&said) && (said.is_empty() || said.ends_with('\n')), "read {k}: {said}");
    }
}

/// A text that can be read so many times.
struct Breaking<'t> {
    text: &'t [u8],
    reads: Option<usize>,
}

impl Read for Breaking<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        match &mut self.reads {
            Some(0) => Err(CAUSE.into()),
            reads => {
                *reads = reads.map(|left| left - 1);
                self.text.read(buffer)
            }
        }
    }
}
