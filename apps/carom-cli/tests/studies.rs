//! Studies as a user meets them: maps and yields.

use crate::command;

use command::{Said, command, examples, folder};
use serde_json::Value;
use std::path::Path;

fn carom(words: &[&str], out: &str, threads: &str) -> Said {
    command(words, &folder(out)).env("RAYON_NUM_THREADS", threads).output().unwrap().into()
}

/// A result without what differs from run to run.
fn result(said: &Said) -> Value {
    assert_eq!(said.code, 0, "{}", said.err);
    let mut json: Value = serde_json::from_str(&said.out).unwrap();
    json.as_object_mut().unwrap().remove("run").unwrap();
    json
}

#[test]
fn a_seed_gives_the_same_result_on_any_number_of_threads() {
    let words = ["yield", "designer.toml", "--samples", "2048", "--format", "json"];
    let one = result(&carom(&words, "one", "1"));
    assert_eq!(one, result(&carom(&words, "three", "3")));
    let other = [&words[..], &["--seed", "2"]].concat();
    assert_ne!(one, result(&carom(&other, "other", "1")), "another seed, other samples");
    let files = |name: &str| {
        let text = |file: &str| std::fs::read(folder(name).join("designer").join(file)).unwrap();
        (text("worst-stuck.toml"), text("worst-hardest.toml"))
    };
    assert_eq!(files("one"), files("three"), "byte for byte");
    // The page names the saved scenes where they are.
    let page = |name: &str| {
        let text = std::fs::read_to_string(folder(name).join("designer/yield.html")).unwrap();
        text.replace(folder(name).to_str().unwrap(), "out")
    };
    assert_eq!(page("one"), page("three"), "byte for byte");
    assert!(page("one").contains("carom run out/designer/worst-stuck.toml"), "the command that replays it");
}

#[test]
fn a_yield_counts_every_drop_in_its_histograms() {
    let words = ["yield", "designer.toml", "--samples", "1024", "--format", "json"];
    let found = result(&carom(&words, "histograms", "2"));
    let lower = &found["plates"][1];
    let spreads =
        [&lower["impact_speed_m_s"], &lower["sliding_speed_m_s"], &lower["flat_s"], &found["time_s"]];
    for spread in spreads {
        let number = |key: &str| spread[key].as_f64().unwrap();
        let keys = ["low", "p01", "p05", "p25", "median", "p75", "p95", "p99", "high"];
        assert!(keys.windows(2).all(|pair| number(pair[0]) <= number(pair[1])), "ascending: {spread}");
        let histogram = &spread["histogram"];
        let counts = histogram["counts"].as_array().unwrap();
        assert_eq!(histogram["edges"].as_array().unwrap().len(), counts.len() + 1, "edges around bins");
        let inside: u64 = counts.iter().map(|count| count.as_u64().unwrap()).sum();
        let outside = histogram["below"].as_u64().unwrap() + histogram["above"].as_u64().unwrap();
        assert_eq!(inside + outside, spread["count"].as_u64().unwrap(), "{spread}");
    }
    let said = carom(&["yield", "designer.toml", "--samples", "64"], "histograms", "1");
    assert!(said.out.contains("yield.html"), "the page is named: {}", said.out);
}

#[test]
fn a_yield_removes_its_own_files_and_no_others() {
    let place = folder("own").join("designer");
    std::fs::create_dir_all(&place).unwrap();
    let [own, users] = [
        ["worst-missed.toml", "worst-face_3.toml", "worst-no_such_feeder.toml"],
        ["worst-mine.toml", "worst-.toml", "worst-stuck.toml.old"],
    ];
    own.iter().chain(&users).for_each(|name| std::fs::write(place.join(name), "# of before\n").unwrap());
    let said = carom(&["yield", "designer.toml", "--samples", "64"], "own", "1");
    assert_eq!(said.code, 0, "{}", said.err);
    own.iter().for_each(|name| assert!(!place.join(name).exists(), "{name} is of an earlier study"));
    users.iter().for_each(|name| assert!(place.join(name).exists(), "{name} is the user's"));
}

/// Width and height of a PNG [px].
fn size(png: &[u8]) -> [u32; 2] {
    assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n", "a PNG");
    [16, 20].map(|at| u32::from_be_bytes(png[at..at + 4].try_into().unwrap()))
}

#[test]
fn worst_cases_replay() {
    let words = ["yield", "designer.toml", "--samples", "1024", "--format", "json"];
    let found = result(&carom(&words, "worst", "2"));
    let worst = found["worst"].as_array().unwrap();
    assert_eq!(worst.len(), 2, "{worst:?}");
    for worst in worst {
        let file = folder("worst").join("designer").join(worst["file"].as_str().unwrap());
        let said = carom(&["run", file.to_str().unwrap(), "--format", "json"], "replayed", "1");
        let run: Value = serde_json::from_str(&said.out).unwrap();
        let plate = run["plates"].as_array().unwrap().iter().find(|plate| plate["plate"] == "lower");
        let ending = match plate {
            Some(plate) => plate["verdict"].as_str().unwrap(),
            None => run["outcome"].as_str().unwrap(),
        };
        assert_eq!(ending, worst["ending"].as_str().unwrap(), "{}", said.out);
        let speed = plate.map(|plate| plate["impact_speed_m_s"].as_f64().unwrap());
        assert_eq!(speed, worst["impact_speed_m_s"].as_f64());
    }
}

#[test]
fn a_map_is_the_same_on_any_number_of_threads() {
    let axes = ["--x", "plate.lower.slope=5..40 deg:10", "--y", "contact.friction=0.05..0.5:8"];
    let words = [&["map", "designer.toml"][..], &axes, &["--format", "json"]].concat();
    let one = result(&carom(&words, "map_one", "1"));
    assert_eq!(one, result(&carom(&words, "map_two", "2")));
    let file = |name: &str, file: &str| std::fs::read(folder(name).join("designer").join(file)).unwrap();
    for name in ["map.svg", "map.png", "map.csv"] {
        assert_eq!(file("map_one", name), file("map_two", name), "{name}");
    }
    let csv = String::from_utf8(file("map_one", "map.csv")).unwrap();
    assert!(csv.starts_with("plate.lower.slope [deg],contact.friction,label_a,"), "{csv}");
    let svg = String::from_utf8(file("map_one", "map.svg")).unwrap();
    let [width, height] = size(&file("map_one", "map.png"));
    let sides = format!("width=\"{}\" height=\"{}\"", width / 2, height / 2);
    assert!(svg.contains(&sides), "twice as large as the SVG: {sides}");
    let share: f64 =
        one["labels"].as_array().unwrap().iter().map(|l| l["area_share"].as_f64().unwrap()).sum();
    assert!((share - 1.0).abs() < 1e-9, "the outcomes cover the plane: {share}");
}

#[test]
fn every_cell_of_a_map_ends_as_the_drop_at_its_middle() {
    let axes = ["--x", "contact.friction=0.05..0.17:40", "--y", "start.to_edge=60..140 mm:40"];
    let words =
        |more: &[&'static str]| [&["map", "case_2.toml", "--format", "json"], &axes[..], more].concat();
    let found = carom(&words(&["--cells"]), "cells", "2");
    let drops = serde_json::from_str::<Value>(&found.out).unwrap()["run"]["drops"].as_u64().unwrap();
    let found = result(&found);
    assert!(drops < 40 * 40, "{drops} drops");
    assert_eq!(found["axes"][0]["cells"], 5, "regions are sought on an eighth of the cells");
    let text = std::fs::read_to_string(folder("cells").join("case_2/map-cells.csv")).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("contact.friction,start.to_edge [mm],ending"));
    // The same places as a list of designs, each followed on its own.
    let mut list = "contact.friction,start.to_edge\n".to_owned();
    let cells: Vec<&str> = lines.map(|line| line.rsplit_once(',').unwrap().1).collect();
    for line in text.lines().skip(1) {
        let [x, y, _] = line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
        list += &format!("{x},{y} mm\n");
    }
    std::fs::write(folder("cells").join("list.csv"), list).unwrap();
    let list = folder("cells").join("list.csv");
    let words_of_list = ["sweep", "case_2.toml", "--format", "json", "--list", list.to_str().unwrap()];
    fresh("cells_swept");
    let swept = result(&carom(&words_of_list, "cells_swept", "2"));
    for ending in found["cells"]["endings"].as_array().unwrap() {
        let word = ending["ending"].as_str().unwrap();
        assert_eq!(swept["endings"][word], ending["cells"], "each cell is what its own drop says");
        let count = cells.iter().filter(|cell| **cell == word).count();
        assert_eq!(count as u64, ending["cells"].as_u64().unwrap(), "{ending}");
    }
    assert_eq!(cells.len(), 40 * 40, "all cells");
    // Without cells the files of another map are gone.
    result(&carom(&words(&["--depth", "0"]), "cells", "2"));
    assert!(!folder("cells").join("case_2/map-cells.csv").exists(), "cells of another map");
}

#[test]
fn a_yield_is_located_where_samples_find_it() {
    let words = ["yield", "designer.toml", "--locate", "--format", "json"];
    let located = result(&carom(&words, "located", "1"));
    assert_eq!(located, result(&carom(&words, "located", "3")), "whatever the threads");
    let sampled = result(&carom(&["yield", "designer.toml", "--format", "json"], "sampled", "2"));
    let [low, high] = ["low", "high"].map(|end| located["yield"][end].as_f64().unwrap());
    let of_samples = ["low", "high"].map(|end| sampled["yield"][end].as_f64().unwrap());
    assert!(high - low < 2e-3, "{low} to {high}");
    assert!(low <= of_samples[1] && of_samples[0] <= high, "{low} to {high}, {of_samples:?}");
    let said = carom(&["yield", "designer.toml", "--locate", "--lines", "8"], "located", "1");
    assert_eq!(said.code, 2, "fewer lines than repetitions: {}", said.out);
}

#[test]
fn what_is_wrong_with_a_study_is_said_at_once() {
    let map = ["map", "designer.toml", "--plate", "3", "--accuracy", "2", "--x", "plate.lower.slop=1..2 deg"];
    let said = carom(&[&map[..], &["--y", "contact.friction=-1..0.5:0"]].concat(), "bad", "1");
    assert_eq!(said.code, 2);
    for problem in ["--plate", "--accuracy", "plate.lower.slop", "cells", "5 problems"] {
        assert!(said.err.contains(problem), "{problem}: {}", said.err);
    }
    assert!(said.err.contains("did you mean \"plate.lower.slope\"?"), "{}", said.err);
    let grid = ["sweep", "designer.toml", "--grid", "contact.friction=0.1..0.3:1", "--grid"];
    let said = carom(&[&grid[..], &["plate.lower.slope=5..40:4"]].concat(), "bad", "1");
    assert!(said.err.contains("\"1\" points: 2 to 1000000 are allowed"), "{}", said.err);
    assert!(said.err.contains("\"5..40\" has no unit: write \"5..40 deg\""), "{}", said.err);
    let said = carom(&["yield", "case_1.toml"], "bad", "1");
    assert_eq!(said.code, 2);
    assert!(said.err.contains("nothing varies") && said.err.contains("±"), "{}", said.err);
    let said = carom(&["yield", "designer.toml", "--samples", "0"], "bad", "1");
    assert_eq!(said.code, 2, "{}", said.err);
}

#[test]
fn the_interval_of_a_feed_is_the_same_on_any_number_of_threads_and_replays() {
    let words = ["feed", "zigzag.toml", "--intervals", "24", "--parts", "2", "--format", "json"];
    let found = result(&carom(&words, "feed_one", "1"));
    assert_eq!(found, result(&carom(&words, "feed_three", "3")));
    let place = |name: &str| folder(name).join("zigzag/feed");
    for file in ["feed.svg", "feed.csv", "touches.toml", "free.toml"] {
        let [one, three] =
            ["feed_one", "feed_three"].map(|name| std::fs::read(place(name).join(file)).unwrap());
        assert!(one == three, "{file}");
    }
    let smallest = &found["smallest"];
    let [free, touching] = ["interval_s", "touching_s"].map(|key| smallest[key].as_f64().unwrap());
    assert!(touching < free && free - touching <= 1e-6, "{smallest}");
    for (file, interval) in [("free.toml", free), ("touches.toml", touching)] {
        let path = place("feed_one").join(file);
        let said = carom(&["run", path.to_str().unwrap(), "--format", "json"], "feed_replayed", "1");
        let run: Value = serde_json::from_str(&said.out).unwrap();
        assert_eq!(run["feed"]["interval_s"].as_f64().unwrap(), interval);
        let parts = run["feed"]["parts"].as_array().unwrap();
        let blocked = parts.iter().any(|part| part["outcome"] == "blocked");
        let touch = blocked || !run["feed"]["contacts"].as_array().unwrap().is_empty();
        assert_eq!(touch, file == "touches.toml", "{}", said.out);
    }
}

#[test]
fn solid_parts_are_fed_until_they_touch() {
    let words = ["feed", "solid.toml", "--intervals", "24", "--format", "json"];
    let found = result(&carom(&words, "feed_solid", "1"));
    assert_eq!(found, result(&carom(&words, "feed_solid_three", "3")));
    let smallest = &found["smallest"];
    assert_eq!((&smallest["below"], &smallest["limited_by"]), (&"touch".into(), &"lower".into()));
    let [free, own] = [&smallest["interval_s"], &found["own_meeting"]["low_s"]].map(|x| x.as_f64().unwrap());
    assert!(free - own < 2e-6, "{free} {own}");
    assert!(found["parts"].is_null() && found["saved"].as_array().unwrap().is_empty());
    let said = carom(&["feed", "solid.toml", "--parts", "2"], "feed_solid_parts", "1");
    assert!(said.code != 0 && said.err.contains("--parts: 2 is not taken"), "{}", said.err);
}

#[test]
fn what_is_wrong_with_a_feed_is_said_at_once() {
    let words = ["feed", "zigzag.toml", "--intervals", "3", "--parts", "1", "--accuracy", "0"];
    let said = carom(&words, "bad", "1");
    assert_eq!(said.code, 2);
    for problem in ["--intervals", "--parts", "--accuracy", "3 problems"] {
        assert!(said.err.contains(problem), "{problem}: {}", said.err);
    }
}

/// Every design is stuck on the upper plate: cheap ones, for four steps of one part file.
const CHEAP: [&str; 6] = [
    "sweep",
    "designer.toml",
    "--grid",
    "contact.friction=0.5..0.9:200",
    "--grid",
    "plate.lower.slope=5..40 deg:200",
];

/// The part files of a sweep, by name.
fn parts(name: &str) -> Vec<(String, Vec<u8>)> {
    let place = folder(name).join("designer/sweep");
    let entries = std::fs::read_dir(place).unwrap().map(|entry| entry.unwrap().path());
    let tables = entries.filter(|path| path.extension().is_some_and(|ending| ending == "parquet"));
    let mut found: Vec<(String, Vec<u8>)> = tables
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(&path).unwrap()))
        .collect();
    found.sort();
    found
}

fn fresh(name: &str) {
    let _ = std::fs::remove_dir_all(folder(name));
}

#[test]
fn a_sweep_is_the_same_on_any_number_of_threads_and_in_shards() {
    for name in ["sweep_one", "sweep_three", "sweep_shards"] {
        fresh(name);
    }
    let one = carom(&[&CHEAP[..], &["--format", "json"]].concat(), "sweep_one", "1");
    let whole: Value = serde_json::from_str(&one.out).unwrap();
    assert_eq!((&whole["rows"], &whole["endings"]["stuck"]), (&40000.into(), &40000.into()), "{}", one.err);
    assert_eq!(carom(&CHEAP, "sweep_three", "3").code, 0);
    for shard in ["2/3", "3/3", "1/3"] {
        assert_eq!(carom(&[&CHEAP[..], &["--shard", shard]].concat(), "sweep_shards", "2").code, 0);
    }
    let parts_of = ["sweep_one", "sweep_three", "sweep_shards"].map(parts);
    assert_eq!(parts_of[0].len(), 1, "40 000 of 1 000 000 designs");
    assert!(parts_of[0] == parts_of[1] && parts_of[0] == parts_of[2], "byte for byte");
}

#[test]
fn a_sweep_that_is_killed_goes_on_where_it_was() {
    fresh("sweep_whole");
    fresh("sweep_killed");
    carom(&CHEAP, "sweep_whole", "2");
    // Killed without notice after a while that differs from time to time, until one comes to its end.
    let mut ended = false;
    for pause in 1..200 {
        let mut command = command(&CHEAP, &folder("sweep_killed"));
        let mut child = command.stdout(std::process::Stdio::null()).spawn().unwrap();
        std::thread::sleep(std::time::Duration::from_millis(20 * pause));
        child.kill().unwrap();
        if child.wait().unwrap().success() {
            ended = true;
            break;
        }
    }
    assert!(ended, "it never came to its end");
    assert!(parts("sweep_whole") == parts("sweep_killed"), "byte for byte");
}

#[test]
fn a_part_that_cannot_be_written_loses_nothing() {
    fresh("sweep_blocked");
    let place = folder("sweep_blocked").join("designer/sweep");
    // A folder stands where the part belongs.
    std::fs::create_dir_all(place.join("part-00000000.parquet/x")).unwrap();
    let said = carom(&CHEAP, "sweep_blocked", "2");
    assert_eq!(said.code, 1);
    assert!(
        said.err.contains("part-00000000") && said.err.contains("goes on where this one stopped"),
        "{}",
        said.err
    );
    std::fs::remove_dir_all(place.join("part-00000000.parquet")).unwrap();
    let again = carom(&[&CHEAP[..], &["--format", "json"]].concat(), "sweep_blocked", "2");
    let again: Value = serde_json::from_str(&again.out).unwrap();
    assert_eq!((&again["rows"], &again["run"]["drops"]), (&40000.into(), &0.into()), "no drop was lost");
    assert_eq!(parts("sweep_blocked").len(), 1);
    assert!(!place.join("unfinished").exists(), "no step is left");
    let left = std::fs::read_dir(&place).unwrap().filter(|entry| {
        entry.as_ref().is_ok_and(|entry| entry.path().extension().is_some_and(|ending| ending == "part"))
    });
    assert_eq!(left.count(), 0, "no broken file is left");
}

/// Everything in the folder of a sweep that is no part file.
fn beside_parts(name: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder(name).join("designer/sweep")).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned());
    let mut found: Vec<String> = names.filter(|name| !name.ends_with(".parquet")).collect();
    found.sort();
    found
}

#[test]
fn a_second_run_did_nothing_and_leaves_nothing_behind() {
    fresh("sweep_again");
    let small = ["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.9:3", "--format", "json"];
    let drops = |said: &Said| {
        let json: Value = serde_json::from_str(&said.out).unwrap();
        (json["run"]["drops"].as_u64().unwrap(), json["rows"].as_u64().unwrap())
    };
    assert_eq!(drops(&carom(&small, "sweep_again", "1")), (3, 3));
    let place = folder("sweep_again").join("designer/sweep");
    for rest in ["part-00000000.77.part", "_sweep.77.part", "mine.part"] {
        std::fs::write(place.join(rest), "half").unwrap();
    }
    assert_eq!(drops(&carom(&small, "sweep_again", "1")), (0, 3), "it was there");
    let left = beside_parts("sweep_again");
    let left: Vec<&str> = left.iter().map(String::as_str).filter(|name| !name.ends_with(".lock")).collect();
    assert_eq!(left, ["_sweep.json", "mine.part"], "what a killed write left is gone");
    #[cfg(unix)]
    assert_eq!(beside_parts("sweep_again").len(), 2, "no lock is left");
}

#[test]
fn a_shard_without_steps_says_so_and_other_counts_are_refused() {
    fresh("sweep_idle");
    let words = ["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.9:3", "--shard"];
    let said = carom(&[&words[..], &["2/8"]].concat(), "sweep_idle", "1");
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(said.out.contains("this shard has no step: 3 designs make 1 of 10000"), "{}", said.out);
    let place = folder("sweep_idle").join("designer/sweep");
    let other = std::fs::File::create(place.join(".shard-1-of-4.lock")).unwrap();
    other.lock().unwrap();
    let said = carom(&[&words[..], &["1/8"]].concat(), "sweep_idle", "1");
    assert_eq!(said.code, 1);
    assert!(said.err.contains("one of 4 shards"), "{}", said.err);
    drop(other);
    assert_eq!(carom(&[&words[..], &["1/8"]].concat(), "sweep_idle", "1").code, 0);
    assert_eq!(parts("sweep_idle").len(), 1);
}

#[test]
fn a_folder_of_another_sweep_is_not_touched() {
    fresh("sweep_other");
    let small = |points: &str| carom(&["sweep", "designer.toml", "--grid", points], "sweep_other", "1");
    assert_eq!(small("contact.friction=0.5..0.9:3").code, 0);
    let before = parts("sweep_other");
    let said = small("contact.friction=0.5..0.8:3");
    assert_eq!(said.code, 2);
    assert!(said.err.contains("--force"), "{}", said.err);
    assert_eq!(parts("sweep_other"), before);
    let words = ["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.8:3", "--force"];
    assert_eq!(carom(&words, "sweep_other", "1").code, 0);
    assert_ne!(parts("sweep_other"), before);
}

#[test]
fn parts_that_never_were_whole_are_written_anew_and_those_of_another_sweep_refused() {
    for name in ["sweep_broken", "sweep_foreign"] {
        fresh(name);
    }
    let small = ["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.9:300"];
    assert_eq!(carom(&small, "sweep_broken", "2").code, 0);
    let whole = parts("sweep_broken");
    let place = folder("sweep_broken").join("designer/sweep");
    for bytes in [&[][..], &whole[0].1[..whole[0].1.len() / 2]] {
        std::fs::write(place.join(&whole[0].0), bytes).unwrap();
        let said = carom(&small, "sweep_broken", "2");
        assert_eq!(said.code, 0, "{}", said.err);
        assert!(said.err.contains("part-00000000.parquet is damaged"), "{}", said.err);
        assert!(parts("sweep_broken") == whole, "byte for byte");
    }
    let other =
        carom(&["sweep", "designer.toml", "--grid", "contact.friction=0.5..0.9:3"], "sweep_foreign", "1");
    assert_eq!(other.code, 0, "{}", other.err);
    let foreign = &parts("sweep_foreign")[0].1;
    std::fs::write(place.join(&whole[0].0), foreign).unwrap();
    let said = carom(&small, "sweep_broken", "2");
    assert_eq!(said.code, 2);
    assert!(said.err.contains("part-00000000") && said.err.contains("another sweep"), "{}", said.err);
    assert!(parts("sweep_broken")[0].1 == *foreign, "it is not touched");
}

#[test]
fn a_list_may_be_quoted() {
    std::fs::create_dir_all(folder("")).unwrap();
    let mut found = vec![];
    for (name, text) in [
        ("plain", "plate.1.slope,contact.friction\n25 deg,0.15\n30 deg,0.6\n"),
        (
            "quoted",
            "\u{feff}\"plate.1.slope\",\"contact.friction\"\r\n\"25 deg\",0.15\r\n\"30 deg\", \"0.6\"\r\n",
        ),
    ] {
        fresh(&format!("list_{name}"));
        let list = folder(&format!("{name}.csv"));
        std::fs::write(&list, text).unwrap();
        let words = ["sweep", "designer.toml", "--format", "json", "--list", list.to_str().unwrap()];
        let mut told = result(&carom(&words, &format!("list_{name}"), "1"));
        told.as_object_mut().unwrap().remove("folder");
        found.push(told);
    }
    assert_eq!(found[0], found[1]);
    assert_eq!(found[0]["endings"], serde_json::json!({ "stuck": 1, "turned": 1 }));
}

#[test]
fn what_is_wrong_with_a_list_is_said_line_by_line() {
    let list = folder("list.csv");
    std::fs::create_dir_all(folder("")).unwrap();
    std::fs::write(&list, "plate.1.slope,contact.friction\n25 deg,-0.15\n95 deg,x\n1\n\"25 deg,0.1\n")
        .unwrap();
    let said = carom(&["sweep", "designer.toml", "--list", list.to_str().unwrap()], "bad_list", "1");
    assert_eq!(said.code, 2);
    for problem in [
        "line 2: contact.friction",
        "line 3: plate.lower.slope",
        "line 3: contact.friction",
        "line 4: 1 values",
        "line 5: the quotes of",
    ] {
        assert!(said.err.contains(problem), "{problem}: {}", said.err);
    }
    let said = carom(&["sweep", "designer.toml", "--shard", "3/2"], "bad_list", "1");
    assert!(said.err.contains("--grid") && said.err.contains("--shard"), "{}", said.err);
}

#[test]
fn a_design_is_found_and_keeps_what_it_claims() {
    fresh("design");
    let words = ["design", "designer.toml", "--scan", "64", "--samples", "512", "--format", "json"];
    let found = result(&carom(&words, "design", "2"));
    assert_eq!(found["outcome"], "found");
    fresh("design_one");
    assert_eq!(found, result(&carom(&words, "design_one", "1")), "on any number of threads");
    let place = folder("design").join("designer/design");
    // The winner is a scene like any other: its drop is as wanted, its yield is the one it was chosen for.
    let scene = place.join("design.toml");
    let run: Value = serde_json::from_str(
        &carom(&["run", scene.to_str().unwrap(), "--format", "json"], "design_run", "1").out,
    )
    .unwrap();
    assert_eq!(run["plates"][0]["verdict"], "turned");
    assert_eq!(found["ends"], "delivered");
    assert!(found["exit"]["t_s"].as_f64().unwrap() > run["plates"][0]["flat_s"].as_f64().unwrap());
    let yields = result(&carom(&["yield", scene.to_str().unwrap(), "--format", "json"], "design_yield", "2"));
    let interval = |of: &Value| (of["low"].as_f64().unwrap(), of["high"].as_f64().unwrap());
    let (claimed, found_again) =
        (interval(&found["winner"]["yield"]), interval(&yields["yield_within_limits"]));
    assert!(claimed.0 <= found_again.1 && found_again.0 <= claimed.1, "{claimed:?} {found_again:?}");
    // What limits hold against is the worst of its drops, not the one where nothing varies.
    let speed = |of: &Value| of["impact_speed_m_s"].as_f64().unwrap();
    let (worst, winner) = (&found["worst"], &found["winner"]);
    assert!(speed(worst) >= speed(winner), "{worst} {winner}");
    assert_eq!(worst["limits_hold"], speed(worst) <= 3.0, "the scene's limit");
    let walls =
        run["impacts"].as_array().unwrap().iter().filter(|i| i["contacts"].to_string().contains("wall\""));
    assert_eq!(found["wall_strikes"].as_object().unwrap().is_empty(), walls.count() == 0, "{found}");
    let drawing = std::fs::read_to_string(place.join("drawing.dxf")).unwrap();
    assert!(drawing.contains("0\r\nDIMENSION\r\n"), "measures are dimensions");
    let sheet = std::fs::read_to_string(place.join("drawing.svg")).unwrap();
    assert!(sheet.contains("mm\" viewBox=\"0 0 ") && sheet.contains("length ("), "one to one, with lengths");
    assert!(drawing.contains("PLATES") && drawing.ends_with("EOF\r\n"));
}

#[test]
fn not_possible_is_an_answer() {
    let text = std::fs::read_to_string(examples().join("designer.toml")).unwrap();
    let file = folder("low.toml");
    std::fs::create_dir_all(folder("")).unwrap();
    std::fs::write(&file, text.replace("max_impact_speed = \"3 m/s\"", "max_height = \"0.1 m\"")).unwrap();
    let said = carom(&["design", file.to_str().unwrap(), "--scan", "64"], "design_low", "2");
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(
        said.out.contains("NOT POSSIBLE: height forbids it") && said.out.contains("at most 0.1 m"),
        "{}",
        said.out
    );
    // Most layouts end otherwise, but not all: what forbids it is the speed of those that end as wanted.
    let gentle =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../bench/studies/designs/hex_bar_gentle_turn.toml");
    let said = carom(&["design", gentle.to_str().unwrap(), "--scan", "512"], "design_gentle", "2");
    assert!(said.out.contains("NOT POSSIBLE: impact speed forbids it"), "{}", said.out);
    let said = carom(&["design", "case_1.toml"], "design_none", "1");
    assert!(said.code == 2 && said.err.contains("[design]"), "{}", said.err);
}

#[test]
fn a_list_says_how_many_problems_it_has() {
    fresh("sweep_wrong");
    let list = folder("sweep_wrong").join("wrong.csv");
    std::fs::create_dir_all(list.parent().unwrap()).unwrap();
    std::fs::write(&list, format!("contact.friction\n{}0.2\n", "-1\n".repeat(1234))).unwrap();
    let said = carom(&["sweep", "designer.toml", "--list", list.to_str().unwrap()], "sweep_wrong", "1");
    assert_eq!(said.code, 2);
    assert!(said.err.starts_with("1234 problems in "), "{}", said.err);
    assert!(
        said.err.contains("of which the first 50:") && said.err.contains("and 1184 more"),
        "{}",
        said.err
    );
    assert_eq!(said.err.matches("contact.friction: -1").count(), 50, "{}", said.err);
    // A line without an end is no list.
    std::fs::write(&list, vec![b'0'; 3 << 20]).unwrap();
    let said = carom(&["sweep", "designer.toml", "--list", list.to_str().unwrap()], "sweep_wrong", "1");
    assert!(said.code == 2 && said.err.contains("has a line of more than 1 MiB"), "{}", said.err);
}

#[cfg(unix)]
#[test]
fn a_list_may_come_from_a_pipe_that_the_shell_has_opened() {
    use std::io::Write;
    fresh("sweep_piped");
    let text = "contact.friction\n0.5\n0.6\n0.7\n";
    let mut command = command(&["sweep", "designer.toml", "--list", "/dev/stdin"], &folder("sweep_piped"));
    let mut child =
        command.stdin(std::process::Stdio::piped()).stdout(std::process::Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    let said: Said = child.wait_with_output().unwrap().into();
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(said.out.contains("3 of 3 designs"), "{}", said.out);
    // The same list in a file is the same sweep.
    let list = folder("sweep_piped").join("list.csv");
    std::fs::write(&list, text).unwrap();
    let said = carom(
        &["sweep", "designer.toml", "--list", list.to_str().unwrap(), "--format", "json"],
        "sweep_piped",
        "1",
    );
    let json: Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!((&json["rows"], &json["run"]["drops"]), (&3.into(), &0.into()), "{}", said.err);
}

#[test]
fn a_map_marks_the_scene_and_what_it_wants() {
    let plane =
        ["--x", "plate.lower.slope=5..40 deg:4", "--y", "contact.friction=0.05..0.5:4", "--depth", "0"];
    let said = carom(&[&["map", "designer.toml"][..], &plane].concat(), "map_marks", "2");
    assert_eq!(said.code, 0, "{}", said.err);
    assert!(
        said.out.contains("turned, as wanted") && !said.out.contains("same side, as wanted"),
        "{}",
        said.out
    );
    let svg = std::fs::read_to_string(folder("map_marks").join("designer/map.svg")).unwrap();
    // 25° of 5 to 40° and 0.15 of 0.05 to 0.5, on 470 by 410 px from (62, 82) on.
    let (x, y) = (62.0 + 470.0 * 20.0 / 35.0, 82.0 + 410.0 * (1.0 - 0.1 / 0.45));
    let at = svg.split_once("class=\"boundary here\" d=\"M").unwrap().1;
    let at: Vec<f64> = at.split(['h', 'M', ' ']).take(2).map(|number| number.parse().unwrap()).collect();
    // Pixels have two decimals.
    assert!((at[0] + 6.0 - x).abs() < 0.01 && (at[1] - y).abs() < 0.01, "{at:?} is not about {x}, {y}");
    assert!(svg.contains("turned, as wanted"), "the legend says which region is wanted");
}
