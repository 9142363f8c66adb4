//! In numbers as in the report of the run.

use super::*;
use carom::tasks;
use carom_scene::Scene;
use std::path::Path;

#[test]
fn a_drop_in_numbers_is_the_run_of_the_report() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let mut outcomes = vec![];
    for name in ["case_1", "case_2", "case_2_box", "bracket", "hexagon", "disc", "zigzag", "too_flat"] {
        let path = folder.join(name).with_extension("toml");
        let text = std::fs::read_to_string(&path).unwrap();
        let found = drop(path.to_str().unwrap(), &text).unwrap();
        let scene = Scene::read(&path).unwrap();
        let report = tasks::run_report(&scene, &scene.feeder().run().unwrap(), None, None);
        assert_eq!(found.end_time.to_bits(), report.end_s.to_bits(), "{name}: time");
        assert_eq!(found.strikes, report.impacts.len() as u64, "{name}: strikes");
        assert_eq!(
            format!("{:?}", found.verdict == Verdict::None),
            format!("{}", found.face == -1),
            "{name}"
        );
        outcomes.push((name, found.outcome, found.verdict));
    }
    assert!(outcomes.contains(&("case_2", DropOutcome::Landed, Verdict::Turned)), "{outcomes:?}");
}
