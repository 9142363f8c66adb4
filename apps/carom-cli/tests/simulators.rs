//! A scene for simulators through the command.

use crate::command;

use command::{Said, command, examples, folder};

#[test]
fn a_scene_is_written_for_simulators_where_that_is_asked() {
    let scene = examples().join("case_2_box.toml").display().to_string();
    for asked in [true, false] {
        let out = folder(if asked { "simulators" } else { "no_simulators" });
        let words = [&["draw", scene.as_str()][..], if asked { &["--simulators"] } else { &[] }].concat();
        let said: Said = command(&words, &out).output().unwrap().into();
        assert_eq!(said.code, 0, "{}", said.err);
        for name in ["scene.mjcf.xml", "part.urdf", "plates.urdf", "part-0.obj"] {
            assert_eq!(said.out.contains(name), asked, "{name}: {}", said.out);
            assert_eq!(out.join("case_2_box").join(name).exists(), asked, "{name}");
        }
    }
}
