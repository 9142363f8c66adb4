//! `carom roll KIND --poses DT`: poses as a program meets them.

use crate::command;

use command::{Said, answers, command, examples, folder, result_on};
use serde_json::Value;

const KINDS: [(&str, &str); 6] = [
    ("cylinder", "roll_cylinder.toml"),
    ("prism", "roll_prism.toml"),
    ("rod", "roll_rod.toml"),
    ("pyramid", "roll_pyramid.toml"),
    ("stool", "roll_stool.toml"),
    ("body", "roll_body.toml"),
];

fn refused(test: &str, words: &[&str]) -> String {
    let said: Said = command(words, &folder(test)).output().unwrap().into();
    assert_eq!((said.code, said.out.as_str()), (2, ""), "{words:?}: {}", said.err);
    said.err
}

#[test]
fn every_kind_has_poses_and_is_the_same_without() {
    for (kind, file) in KINDS {
        let without = result_on("0", &format!("poses_{kind}_without"), &["roll", kind, file]);
        let mut with = result_on("0", &format!("poses_{kind}"), &["roll", kind, file, "--poses", "20 ms"]);
        let poses = with.as_object_mut().unwrap().remove("poses").unwrap();
        assert!(with == without, "{kind}: nothing else changes");
        let poses = poses.as_array().unwrap();
        let is = |at: &str| poses.iter().filter(|pose| pose["at"] == at).count();
        let strikes = with["strikes"].as_array().unwrap().len();
        assert_eq!((is("before_strike"), is("after_strike"), is("end")), (strikes, strikes, 1), "{kind}");
        let angle =
            if poses[0]["position_m"].as_array().unwrap().len() == 2 { "angle_rad" } else { "attitude" };
        for pose in poses {
            assert!(pose.get(angle).is_some(), "{kind}: {pose}");
            let Some(strike) = pose["strike"].as_u64() else { continue };
            let strike = &with["strikes"][strike as usize];
            let key = if pose["at"] == "before_strike" { "velocity_before_m_s" } else { "velocity_m_s" };
            assert_eq!((&pose["t_s"], &pose["velocity_m_s"]), (&strike["t_s"], &strike[key]), "{kind}");
        }
    }
}

#[test]
fn a_line_has_the_poses_that_its_file_has() {
    for (kind, file) in [KINDS[1], KINDS[4]] {
        let text = std::fs::read_to_string(examples().join(file)).unwrap();
        let line = serde_json::to_string(&toml::from_str::<toml::Table>(&text).unwrap()).unwrap();
        let input = format!("{line}\n{{\"strikes\": \"many\"}}\n{line}\n");
        let (code, said) = answers("poses_lines", &["roll", kind, "-", "--poses", "1e-4"], &input);
        assert_eq!((code, said.len()), (2, 3), "{kind}: one has a problem");
        let words = ["roll", kind, file, "--poses", "0.1 ms"];
        let expected: Value = result_on("0", &format!("poses_line_{kind}"), &words);
        assert!(said[0] == expected && said[2] == expected, "{kind}");
        assert_eq!(said[1]["error"]["problems"][0]["path"], "strikes", "{kind}");
    }
}

#[test]
fn what_poses_do_not_go_with_is_said() {
    let throws = ["roll", "body", "roll_body.toml", "--throws", "32", "--poses", "1 ms"];
    assert!(refused("poses_throws", &throws).contains("--poses does not go with --throws"), "throws");
    let many = refused("poses_many", &["roll", "prism", "--poses", "1e-9"]);
    assert!(many.contains("1000000 are allowed") && many.contains("or more"), "{many}");
    let wrong = refused("poses_wrong", &["roll", "stool", "--poses", "3 mm"]);
    assert!(wrong.contains("--poses: \"3 mm\""), "{wrong}");
}
