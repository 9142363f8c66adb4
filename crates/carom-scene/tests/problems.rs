//! Every kind of problem, with the exact text a user reads.

use crate::held;

use carom_scene::{Form, ProblemKind, Problems, Scene};

const GOOD: &str = r#"gravity = "9.81 m/s^2"

[part]
shape  = "box"
length = "100 mm"
height = "10 mm"
mass   = "0.3 kg"

[contact]
friction    = 0.15
restitution = 0.1

[start]
to_edge = "100 mm"

[channel]
width = "300 mm"

[[plate]]
name  = "upper"
wall  = "left"
slope = "15 deg"
gap   = "60 mm"

[[plate]]
name  = "lower"
wall  = "right"
drop  = "150 mm"
slope = "15 deg"
gap   = "60 mm"
"#;

/// Refused for its form where the schema refuses it, and only there.
fn problems(text: &str) -> Problems {
    held::file(Form::Scene, text);
    Scene::parse("scene.toml", text).expect_err("this scene has problems")
}

/// The good scene with some of its text replaced.
fn with(changes: &[(&str, &str)]) -> Problems {
    let mut text = GOOD.to_owned();
    for (old, new) in changes {
        assert!(text.contains(old), "{old} is not in the good scene");
        text = text.replacen(old, new, 1);
    }
    problems(&text)
}

/// The good scene with the part of another drawing.
fn part(part: &str) -> Problems {
    let old = "shape  = \"box\"\nlength = \"100 mm\"\nheight = \"10 mm\"\nmass   = \"0.3 kg\"\n";
    with(&[(old, part)])
}

/// The good scene with another second plate.
fn lower(plate: &str) -> Problems {
    let at = GOOD.find("name  = \"lower\"").unwrap();
    problems(&format!("{}name  = \"lower\"\n{plate}", &GOOD[..at]))
}

/// One file with one problem of each kind that a designer makes.
const ALL_AT_ONCE: &str = r#"gravity = "9.81 furlong/s^2"

[part]
shape    = "polygon"
vertices = [["0 mm", "0 mm"], ["40 mm", "0 mm"], ["10 mm", "10 mm"], ["0 mm", "40 mm"]]
mass     = "-0.3 kg"

[contact]
friction    = -1
restitution = nan

[start]
to_edge = "100 mm"
sped    = "1 m/s"

[[plate]]
name  = "upper"
slope = "10 deg"

[[plate]]
name     = "lower"
line     = { along = "428 mm", normal = "300 mm" }
below    = { x = "120 mm", y = "-150 mm" }

[[plate]]
name = "point"
from = ["0 m", "-1 m"]
to   = ["0 m", "-1 m"]
"#;

/// The same with an outline that crosses itself.
fn crossed_outline() -> Problems {
    let notch = "[\"40 mm\", \"0 mm\"], [\"10 mm\", \"10 mm\"]";
    assert!(ALL_AT_ONCE.contains(notch), "the notch is there");
    problems(&ALL_AT_ONCE.replace(notch, "[\"40 mm\", \"40 mm\"], [\"40 mm\", \"0 mm\"]"))
}

/// A good outline of no mass: what crosses it at the start is found all the same.
fn crossing_with_other_problems() -> Problems {
    let notch = ", [\"10 mm\", \"10 mm\"]";
    let ends = "from = [\"0 m\", \"-1 m\"]\nto   = [\"0 m\", \"-1 m\"]";
    assert!(ALL_AT_ONCE.contains(notch) && ALL_AT_ONCE.contains(ends), "both are there");
    let through = "from = [\"-200 mm\", \"40 mm\"]\nto   = [\"0 mm\", \"20 mm\"]";
    problems(&ALL_AT_ONCE.replace(notch, "").replace(ends, through))
}

macro_rules! says {
    ($($name:ident: $problems:expr;)*) => { $(
        #[test]
        fn $name() {
            insta::assert_snapshot!($problems.to_string());
        }
    )* };
}

says! {
    one_of_each_kind: problems(ALL_AT_ONCE);
    an_outline_that_crosses_itself: crossed_outline();
    crossing_beside_other_problems: crossing_with_other_problems();
    unknown_unit: with(&[("100 mm", "100 furlong")]);
    wrong_dimension: with(&[("0.3 kg", "0.3 mm"), ("friction    = 0.15", "friction = \"0.15 mm\"")]);
    no_unit: with(&[("\"100 mm\"", "\"100\"")]);
    not_a_quantity: with(&[("\"100 mm\"", "\"long\""), ("\"0.3 kg\"", "true")]);
    negative_mass: with(&[("0.3 kg", "-0.3 kg")]);
    not_finite: with(&[("\"100 mm\"", "nan"), ("\"0.3 kg\"", "\"inf kg\""), ("0.15", "inf")]);
    friction_below_zero: with(&[("0.15", "-1")]);
    restitution_above_one: with(&[("0.1\n", "1.2\n")]);
    tolerance_reaches_below_zero: with(&[("0.15", "\"0.15 ± 0.2\"")]);
    plain_number_of_degrees: with(&[("\"15 deg\"", "15")]);
    bad_tolerances: with(&[
        ("\"0.3 kg\"", "{ value = \"0.3 kg\" }"),
        ("\"100 mm\"", "{ low = \"2 mm\", high = \"1 mm\" }"),
        ("\"10 mm\"", "\"10 ± 0 mm\""),
    ]);
    misspelt_keys: with(&[("friction ", "fricton "), ("length", "lenght"), ("[start]", "[strat]")]);
    unknown_word: with(&[("\"box\"", "\"bx\""), ("restitution = 0.1", "law = \"poison\"")]);
    missing_keys: problems("[part]\nshape = \"rod\"\n\n[start]\n\n[[plate]]\nname = \"upper\"\n");
    missing_tables: problems("gravity = 9.81\n");
    wrong_types: with(&[("[channel]\nwidth = \"300 mm\"\n", ""), ("gravity", "channel = 3\nfeed = [1]\ngravity")]);
    feed_of_too_many: with(&[("gravity", "feed = { parts = 101, interval = \"0 s\", friction = -1, sped = 3 }\ngravity")]);
    crosses_itself: part("shape = \"polygon\"\nmass = \"1 kg\"\nvertices = [[0, 0.1], [-0.059, -0.081], [0.095, 0.031], [-0.095, 0.031], [0.059, -0.081]]\n");
    two_corners: part("shape = \"polygon\"\nmass = \"1 kg\"\nvertices = [[0, 0], [0.1, 0]]\n");
    same_corners: part("shape = \"polygon\"\nmass = \"1 kg\"\nvertices = [[0, 0], [0.1, 0], [0.1, 0], [0, 0.1]]\n");
    crooked_corner: part("shape = \"polygon\"\nmass = \"1 kg\"\nvertices = [[0, 0], [0.1], [0, 0.1]]\n");
    too_round: part("shape = \"box\"\nlength = \"100 mm\"\nheight = \"10 mm\"\ncorner_radius = \"5 mm\"\nmass = 1\n");
    outline_file: part("shape = \"outline\"\nfile = \"bracket.dxf\"\nmass = 1\n");
    impossible_inertia: part("shape = \"rod\"\nlength = \"100 mm\"\nmass = \"0.3 kg\"\ninertia = \"1 kg m^2\"\n");
    forgotten_millimetres: with(&[("\"100 mm\"\nheight = \"10 mm\"", "100\nheight = 4"), ("to_edge = \"100 mm\"", "to_edge = 80"), ("drop  = \"150 mm\"", "drop  = \"150 m\"")]);
    density_of_a_rod: part("shape = \"rod\"\nlength = \"100 mm\"\ndensity = \"7800 kg/m^3\"\ndepth = \"1 mm\"\n");
    mass_and_density: part("shape = \"box\"\nlength = 0.1\nheight = 0.01\nmass = 1\ndensity = \"7800 kg/m^3\"\ndepth = \"1 mm\"\n");
    two_ways: lower("line = { along = 0.3, normal = 0.2 }\nwall = \"right\"\ndrop = 0.1\nslope = 0.2\ngap = 0.1\n");
    two_ways_inside_one: lower("wall = \"right\"\nheight = -0.2\ndrop = 0.1\nslope = 0.2\ngap = 0.1\nlength = 0.1\n");
    a_key_of_another_way: lower("edge = [0, 0]\nslope = 0.2\nlength = 0.1\ngap = 0.02\n");
    no_place: lower("slope = 0.2\n");
    hinge_without_its_keys: lower("wall = \"right\"\n");
    plate_without_length: lower("from = [0.2, -0.2]\nto = [0.2, -0.2]\n");
    plate_uphill: lower("from = [0, -0.3]\nto = [0.2, -0.2]\n");
    plate_vertical: lower("from = [0, -0.2]\nto = [0, -0.4]\n");
    plate_across_the_start: lower("from = [0.3, 0.2]\nto = [0.1, -0.2]\n");
    line_the_other_way: lower("downhill = \"right\"\nline = { along = 0.347, normal = 0.2 }\n");
    line_above_the_edge: lower("slope = 0.2\nbelow = { x = 0, y = \"20 mm\" }\n");
    wall_across_the_start: problems(&format!("{GOOD}\n[[wall]]\nfrom = [0.15, 0.2]\nto = [0.15, -0.2]\n"));
    channel_too_narrow: with(&[("300 mm", "50 mm")]);
    start_beyond_the_plate: with(&[("to_edge = \"100 mm\"", "to_edge = \"900 mm\"")]);
    no_such_face: with(&[("to_edge = \"100 mm\"", "to_edge = \"100 mm\"\nface = 4")]);
    names: with(&[("\"lower\"", "\"upper\""), ("\"upper\"", "\"a.b\"")]);
    same_name: with(&[("\"lower\"", "\"upper\"")]);
    zigzag_and_plates: problems(&format!("{GOOD}\n[zigzag]\nplates = 2.5\ndrop = 0.1\nslope = 0.2\ngap = 0.1\n"));
    design_of_nothing: problems(&format!(
        "{GOOD}\n[design]\naim = \"speed\"\nfree = {{ \"plate.lower.slop\" = \"1..2 deg\", \"contact.friction\" = \"0.5..0.1\", \"part.mass\" = \"1..2 deg\", \"zebra\" = \"1..2\" }}\n"
    ));
    empty: problems("");
    only_a_comment: problems("# nothing\n");
    syntax: problems("[part\nshape = \"rod\"\nlength = = 3\n");
    twice_the_same_key: problems("gravity = 9.81\ngravity = 3\n");
    all_at_once: problems(
        "[part]\nshape = \"rod\"\nlength = \"100 m\"\nmass = \"-3 kg\"\nmas = 3\n\n[contact]\nfriction = -1\nrestitution = 1.2\n\n[start]\nto_edge = \"1 kg\"\n\n[[plate]]\nslope = \"95 deg\"\n\n[[plate]]\nslope = \"10 deg\"\n"
    );
}

#[test]
fn missing_file() {
    let problems = Scene::read(std::path::Path::new("no/such/file.toml")).expect_err("there is none");
    insta::assert_snapshot!(problems.to_string());
}

#[test]
fn the_good_scene_is_good() {
    let scene = Scene::parse("scene.toml", GOOD).unwrap();
    assert_eq!(scene.feeder().plates.len(), 2);
}

#[test]
fn problems_carry_their_kind_place_and_value() {
    let found = with(&[("0.3 kg", "-0.3 kg")]);
    let [problem] = &found.list[..] else { panic!("one problem: {found}") };
    assert_eq!(problem.kind, ProblemKind::OutOfRange);
    assert_eq!(problem.path, "part.mass");
    assert_eq!(found.value(problem), Some("\"-0.3 kg\""));
    assert_eq!(found.line_and_column(problem.span.clone().unwrap().start), (7, 10));
}

#[test]
fn no_cut_of_a_good_scene_panics() {
    for end in 0..GOOD.len() {
        if let Err(found) = Scene::parse("scene.toml", &GOOD[..end]) {
            assert!(!found.list.is_empty(), "cut at {end}");
            assert!(!found.to_string().is_empty(), "cut at {end}");
        }
    }
}

#[test]
fn no_wrong_letter_in_a_good_scene_panics() {
    for (at, letter) in GOOD.char_indices() {
        for wrong in ["\"", "=", "[", "{", "\n", "-", "9e999", "\u{b5}"] {
            let text = format!("{}{wrong}{}", &GOOD[..at], &GOOD[at + letter.len_utf8()..]);
            if let Err(found) = Scene::parse("scene.toml", &text) {
                assert!(!found.to_string().is_empty(), "{text}");
            }
        }
    }
}

#[test]
fn a_plate_out_of_reach_is_named_by_the_key_that_puts_it_there() {
    let found = with(&[("150 mm", "20 km")]).to_string();
    assert!(found.contains("unknown unit"), "{found}");
    let found = with(&[("150 mm", "20000 m")]);
    let ends: Vec<_> = found.list.iter().filter(|problem| problem.path == "plate.lower.drop").collect();
    assert_eq!(ends.len(), 2, "both of its ends: {found}");
    let allowed = "at most 4000 part sizes (largest distance from the mass centre) from the origin";
    assert_eq!(ends[0].message, format!("its uphill end would be at y = -20000 m: {allowed}"));
    assert_eq!(found.value(ends[0]), Some("\"20000 m\""), "the place in the file");
    assert!(!found.to_string().contains("from.y"), "a key that the file does not have: {found}");
}
