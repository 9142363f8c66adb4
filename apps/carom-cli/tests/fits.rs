//! Fits as a user meets them: what comes out of the shipped runs, and what is said of bad ones.

use crate::command;

use carom_scene::Scene;
use command::{Said, command, empty, examples, folder};
use serde_json::Value;

fn fit(words: &[&str], out: &str) -> Said {
    let words = [&["fit", "measured.toml"], words].concat();
    command(&words, &folder(out)).output().unwrap().into()
}

/// Writes a file of runs and fits it.
fn fit_text(name: &str, text: &str) -> Said {
    let folder = folder(name);
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("runs.csv");
    std::fs::write(&file, text).unwrap();
    fit(&[file.to_str().unwrap(), "--samples", "16", "--nodes", "100"], name)
}

#[test]
fn shipped_runs_tell_what_they_were_made_from() {
    let said = fit(&["measured.csv", "--samples", "64", "--nodes", "400", "--format", "json"], "fit");
    assert_eq!(said.code, 0, "{}", said.err);
    let json: Value = serde_json::from_str(&said.out).unwrap();
    for (parameter, (name, truth)) in json["parameters"]
        .as_array()
        .unwrap()
        .iter()
        .zip([("contact.friction", 0.16), ("contact.restitution", 0.05)])
    {
        let number = |key: &str| parameter[key].as_f64().unwrap();
        assert_eq!(parameter["name"], name, "in the order of the scene");
        assert!(number("low") <= truth && truth <= number("high"), "{name} was {truth}: {parameter}");
        assert!(number("low") <= number("best") && number("best") <= number("high"), "{parameter}");
        assert_eq!(number("level"), 0.95, "{parameter}");
    }
    assert!(json["likelihood"].is_f64() && json["not_told_apart"].is_array(), "the agreed keys: {json}");
    let scene = Scene::read(&folder("fit").join("measured/fitted.toml")).unwrap();
    let friction = scene.quantities().into_iter().find(|q| q.path == "contact.friction").unwrap();
    let best = json["parameters"][0]["best"].as_f64().unwrap();
    assert!(friction.tolerance.is_some(), "the interval is its tolerance: {friction:?}");
    // It is written to a hundredth of its standard deviation, which is below 0.002.
    assert!((friction.value - best).abs() < 2e-5, "{} is {best}", friction.value);
    assert!(examples().join("measured.csv").exists(), "shipped beside its scene");
}

/// A part that starts on either side is turned in half of its drops, whatever its friction is, where it stays on the side that it starts on.
#[test]
fn drops_that_start_on_several_faces_are_mixed() {
    let place = empty("faces");
    let scene = std::fs::read_to_string(examples().join("measured.toml")).unwrap();
    let mixed = "[start]\nface = [{ face = 0, share = 0.25 }, { face = 2, share = 0.75 }]";
    std::fs::write(place.join("mixed.toml"), scene.replace("[start]", mixed)).unwrap();
    std::fs::write(place.join("mixed.csv"), "face,drops\n0,10\n2,30\n").unwrap();
    let json = |samples: &str| -> Value {
        let words =
            ["fit", "mixed.toml", "mixed.csv", "--samples", samples, "--nodes", "100", "--format", "json"];
        let said: Said = command(&words, &place).current_dir(&place).output().unwrap().into();
        assert_eq!(said.code, 0, "both faces come up: {}", said.err);
        serde_json::from_str(&said.out).unwrap()
    };
    assert_eq!(json("64")["few_samples"], true, "64 samples for 40 drops");
    assert_eq!(json("512")["few_samples"], false, "512 samples for 40 drops");
}

#[test]
fn bad_runs_are_told_all_at_once() {
    let text = "outcome,face,time,scatter,drops,plate.upper.slope\n\
                turnd,9,nan,0 s,0,200 deg\n\
                failed,,-1 s,,-3,12 deg\n\
                same,,,,1\n\
                ,,,,2,12 deg\n";
    let said = fit_text("bad", text);
    assert_eq!(said.code, 2, "bad input: {}", said.err);
    for place in ["2:1", "2:7", "2:9", "2:13", "2:17", "2:19", "3:1", "3:9", "3:15", "4:1", "5:1"] {
        assert!(said.err.contains(&format!("runs.csv:{place}: ")), "{place} is wrong: {}", said.err);
    }
    for (name, text, message) in [
        ("empty", "", "the file is empty"),
        ("head", "outcome,drops\n", "there are no rows"),
        ("silent", "drops\n3\n", "no column says how drops ended"),
        ("column", "outcome,frob\nturned,1\n", "there is no quantity \"frob\""),
        ("twice", "outcome,outcome\nturned,turned\n", "is named twice"),
        ("fitted", "outcome,contact.friction\nturned,0.2\n", "is fitted (--over)"),
    ] {
        let said = fit_text(name, text);
        let told = said.err.contains(message) || said.err.contains("frob") && name == "column";
        assert!(said.code == 2 && told, "{name}: {}", said.err);
    }
}

#[test]
fn a_time_that_no_drop_takes_is_named_with_its_row() {
    let said = fit_text("late", "outcome,time\nturned,0.7 s\nturned,99 s\n");
    assert_eq!(said.code, 2, "{}", said.err);
    let told = said.err.contains("runs.csv:3:1") && said.err.contains("they take 0.");
    assert!(told && !said.err.contains("runs.csv:2:"), "the third line: {}", said.err);
}

#[test]
fn an_outcome_that_never_happens_is_named_with_its_row() {
    let said = fit_text("never", "outcome,drops\nturned,3\non end,1\n");
    assert_eq!(said.code, 2, "{}", said.err);
    let told = said.err.contains("runs.csv:3:1") && said.err.contains("never happens");
    assert!(told && !said.err.contains("runs.csv:2:"), "the third line: {}", said.err);
}
