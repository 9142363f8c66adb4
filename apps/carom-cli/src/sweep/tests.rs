//! A sweep of several part files, which are damaged in every way between two calls.

use crate::args::Arguments;
use crate::carry_out;
use crate::faults::{Fault, during};
use carom_scene::columns::{Column, about, read};
use clap::Parser;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// 20 designs: parts of 8, 8 and 4, steps of 4.
const GRID: &str = "contact.friction=0.5..0.9:20";

fn folder(test: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("carom-sweep-{}", std::process::id())).join(test);
    let _ = std::fs::remove_dir_all(&path);
    path
}

/// The summary, or what is wrong.
fn sweep(out: &Path, more: &[&str]) -> Result<Value, String> {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/designer.toml");
    let (scene, out) = (scene.display().to_string(), out.display().to_string());
    let words = ["carom", "sweep", &scene, "--grid", GRID, "--format", "json", "--out", &out];
    let arguments = Arguments::try_parse_from(words.iter().chain(more)).unwrap();
    let mut said = vec![];
    carry_out(arguments.command, &arguments.output, &mut said).map_err(|failure| failure.to_string())?;
    Ok(serde_json::from_slice(&said).unwrap())
}

fn place(out: &Path) -> PathBuf {
    out.join("designer/sweep")
}

fn parts(out: &Path) -> Vec<Vec<u8>> {
    (0..3).map(|k| std::fs::read(place(out).join(format!("part-{k:08}.parquet"))).unwrap()).collect()
}

fn numbers(rows: &[(String, Column)], name: &str) -> Vec<f64> {
    match &rows.iter().find(|(found, _)| found == name).unwrap().1 {
        Column::Number(values) => values.iter().map(|value| value.unwrap()).collect(),
        Column::Whole(values) => values.iter().map(|value| value.unwrap() as f64).collect(),
        Column::Word(_) => panic!("{name} holds words"),
    }
}

#[test]
fn parts_hold_their_designs_in_order_and_say_units() {
    let out = folder("order");
    let said = sweep(&out, &[]).unwrap();
    assert_eq!((&said["rows"], &said["run"]["drops"]), (&20.into(), &20.into()));
    let mut design = 0;
    for (bytes, rows) in parts(&out).into_iter().zip(["0..8", "8..16", "16..20"]) {
        let told = about(bytes.clone()).unwrap();
        let of = |key: &str| told.iter().find(|(found, _)| found == key).unwrap().1.clone();
        assert_eq!(of("rows"), rows);
        let units: Value = serde_json::from_str(&of("units")).unwrap();
        assert_eq!((&units["contact.friction"], &units["end_s"]), (&"".into(), &"s".into()), "{units}");
        let columns = read(bytes).unwrap();
        for (number, friction) in
            numbers(&columns, "design").into_iter().zip(numbers(&columns, "contact.friction"))
        {
            let asked = 0.5 + 0.4 * f64::from(design) / 19.0;
            assert!(number == f64::from(design) && (friction - asked).abs() < 1e-15, "{number}: {friction}");
            design += 1;
        }
    }
    assert_eq!(design, 20);
    assert!(!place(&out).join("unfinished").exists(), "no step is left");
}

#[test]
fn parts_that_are_damaged_swapped_or_doubled_are_swept_again() {
    let out = folder("damaged");
    sweep(&out, &[]).unwrap();
    let whole = parts(&out);
    let file = |k: usize| place(&out).join(format!("part-{k:08}.parquet"));
    let mut bent = whole[1].clone();
    let middle = bent.len() / 3;
    bent[middle] ^= 0x10;
    // What stands at the place of each part, and how many designs must be swept again.
    let cases: [([&[u8]; 3], u64); 5] = [
        ([&whole[1], &whole[1], &whole[2]], 8),
        ([&whole[1], &whole[0], &whole[2]], 16),
        ([&whole[0], &bent, &whole[2]], 8),
        ([&whole[0], &whole[1], &whole[2][..whole[2].len() - 1]], 4),
        ([&whole[2], &whole[2], &[]], 20),
    ];
    for (held, drops) in cases {
        for (k, bytes) in held.iter().enumerate() {
            std::fs::write(file(k), bytes).unwrap();
        }
        let said = sweep(&out, &[]).unwrap();
        assert_eq!((&said["rows"], &said["run"]["drops"]), (&20.into(), &drops.into()), "{said}");
        assert!(parts(&out) == whole, "byte for byte");
    }
}

#[test]
fn a_sweep_that_is_stopped_loses_one_step_at_most() {
    let out = folder("stopped");
    let (whole, calls) = during(Fault::Never, || sweep(&folder("whole"), &[]));
    let whole = whole.unwrap();
    for k in (0..calls.len()).step_by(7) {
        let out = out.join(k.to_string());
        let (stopped, _) = during(Fault::From(k), || sweep(&out, &[]));
        let left = |path: PathBuf| {
            std::fs::read_dir(path).map_or(0, |entries| {
                entries
                    .filter(|entry| {
                        entry.as_ref().unwrap().path().extension().is_some_and(|e| e == "parquet")
                    })
                    .count()
            })
        };
        // A part that is written may still have its steps.
        let finished = [8, 16, 20].map(|end| if left(place(&out)) > (end - 1) / 8 { end } else { 0 });
        let finished = finished.into_iter().max().unwrap();
        let steps = left(place(&out).join("unfinished"));
        let again = sweep(&out, &[]).unwrap();
        let drops = again["run"]["drops"].as_u64().unwrap() as usize;
        assert!(stopped.is_err() || drops == 0, "call {k} of {}", calls.len());
        assert!(
            drops <= 20 - finished.max(4 * steps),
            "call {k}: {drops} after {finished} and {steps} steps"
        );
        assert_eq!((&again["rows"], &again["endings"]), (&whole["rows"], &whole["endings"]), "call {k}");
    }
}

#[test]
fn a_manifest_that_is_cut_short_is_no_other_sweep() {
    let out = folder("manifest");
    sweep(&out, &[]).unwrap();
    let file = place(&out).join("_sweep.json");
    let manifest = std::fs::read(&file).unwrap();
    std::fs::write(&file, &manifest[..manifest.len() / 2]).unwrap();
    let said = sweep(&out, &[]).unwrap();
    assert_eq!(
        (&said["rows"], &said["run"]["drops"]),
        (&20.into(), &0.into()),
        "the parts say what they are"
    );
    assert!(std::fs::read(&file).unwrap() == manifest, "as it was");
    // Beside parts of another sweep it stays.
    std::fs::write(&file, &manifest[..9]).unwrap();
    let why = sweep(&out, &["--plate", "upper"]).unwrap_err();
    assert!(why.contains("damaged _sweep.json") && why.contains("--force"), "{why}");
}
