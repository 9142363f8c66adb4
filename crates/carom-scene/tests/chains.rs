//! Plates, walls and parts that are chains: what they do, and what is said of chains that are none.

use carom_feeder::{Outcome, Run, StageEnd};
use carom_num::elementary::{cos, sin};
use carom_scene::{MeasureAxis, Scene};

/// Of a radius between two points that are computed [m].
const SAME: f64 = 1e-15;

const START: &str = "[contact]\nfriction = 0.2\nrestitution = 0.1\n[start]\nto_edge = \"222 mm\"\n";
const BOX: &str = "[part]\nshape = \"box\"\nlength = \"30 mm\"\nheight = \"4 mm\"\nmass = \"0.02 kg\"\n";
const DISC: &str = "[part]\nshape = \"disc\"\nradius = \"6 mm\"\nmass = \"0.02 kg\"\n";

fn read(text: &str) -> Scene {
    Scene::parse("chains.toml", text).unwrap_or_else(|problems| panic!("{problems}"))
}

fn run(text: &str) -> Run {
    let scene = read(text);
    scene.feeder().run().unwrap_or_else(|problem| panic!("{problem}"))
}

/// What is said of a file that is refused.
fn refused(text: &str) -> String {
    Scene::parse("chains.toml", text).expect_err("it is refused").to_string()
}

/// A chute that falls by 50°, 40°, 30°, 20°, 10° and 0°: five bends of 60 mm, each between two straight stretches.
fn five_bends() -> String {
    let (mut x, mut y) = (-213.0, 150.0);
    let mut points = vec![];
    for slope in [50.0_f64, 40.0, 30.0, 20.0, 10.0, 0.0] {
        points.push(format!("[\"{x} mm\", \"{y} mm\"]"));
        x += 40.0 * cos(slope.to_radians());
        y -= 40.0 * sin(slope.to_radians());
    }
    points.push(format!("[\"{x} mm\", \"{y} mm\"]"));
    format!("chain = [{}]\nbend_radius = \"60 mm\"\n", points.join(", "))
}

/// The part is handed on from stretch to arc to stretch: no strike before it leaves the chute.
#[test]
fn a_chute_of_five_arcs_has_no_strike_at_its_smooth_joints() {
    let lower =
        "[[plate]]\nname = \"lower\"\nfrom = [\"-100 mm\", \"-100 mm\"]\nto = [\"200 mm\", \"-120 mm\"]\n";
    for part in [BOX, DISC] {
        let run = run(&format!("{part}{START}[[plate]]\nname = \"chute\"\n{}{lower}", five_bends()));
        let strikes: Vec<usize> =
            run.trace.impacts.iter().flat_map(|impact| &impact.contacts).map(|c| c.obstacle).collect();
        assert!(!strikes.contains(&0), "strikes on the chute: {strikes:?} of {part}");
        assert!(strikes.contains(&1), "it comes down on the lower plate: {strikes:?}");
    }
}

/// A part whose end is in a bend that rises does not lie on the plate.
#[test]
fn a_part_that_reaches_into_a_bend_at_its_start_is_refused() {
    let start = START.replace("222", "216");
    let message = refused(&format!("{BOX}{start}[[plate]]\nname = \"chute\"\n{}", five_bends()));
    assert!(message.contains("plate.chute: crosses the part where it starts"), "{message}");
}

/// Time at which the part first touches the lower plate.
fn first_touch(edge_radius: &str) -> f64 {
    let text = format!(
        "{BOX}{START}[[plate]]\nname = \"upper\"\nslope = \"25 deg\"\n{edge_radius}\n[[plate]]\nslope = \"20 deg\"\nbelow = {{ x = \"20 mm\", y = \"-120 mm\" }}\n"
    );
    run(&text).landings.last().expect("it lands").first_touch
}

/// The smaller the radius of the edge, the nearer the sharp edge's numbers: in proportion to it.
#[test]
fn a_rounded_edge_comes_to_the_sharp_one_with_its_radius() {
    let sharp = first_touch("");
    let off = [20.0, 10.0, 5.0].map(|radius| first_touch(&format!("edge_radius = \"{radius} um\"")) - sharp);
    assert!(off[0].abs() > 1e-7 && off[0].abs() < 1e-3, "a radius of 20 µm changes {off:?} s");
    for pair in off.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((ratio - 2.0).abs() < 0.2, "half the radius, half the difference: {off:?}");
    }
}

/// A chain of straight stretches is what its points say, written as a polygon or as a chain.
#[test]
fn a_chain_without_arcs_is_a_polygon() {
    let points = "[[\"0 mm\", \"0 mm\"], [\"30 mm\", \"0 mm\"], [\"30 mm\", \"4 mm\"], [\"4 mm\", \"4 mm\"], [\"4 mm\", \"20 mm\"], [\"0 mm\", \"20 mm\"]]";
    let of = |shape: &str| {
        let part = format!("[part]\n{shape} = {points}\nmass = \"0.02 kg\"\n");
        read(&format!("{part}{START}[[plate]]\nslope = \"25 deg\"\n")).feeder().part.clone()
    };
    let (chain, polygon) = (of("shape = \"chain\"\npoints"), of("shape = \"polygon\"\nvertices"));
    assert_eq!(chain.body, polygon.body, "the same body");
}

/// A disc that is left in a trough rolls to and fro without loss: that is said, and at once.
#[test]
fn a_disc_in_a_trough_swings_for_ever() {
    let trough = "[[plate]]\nname = \"trough\"\nchain = [[\"-100 mm\", \"0 mm\"], { arc = { radius = \"100 mm\", turn = \"left\" } }, [\"99 mm\", \"10 mm\"]]\n";
    let start = START.replace("222", "250").replace("0.2", "0.9");
    let run = run(&format!("{DISC}{start}{trough}"));
    assert_eq!(run.outcome, Outcome::NeverFlat, "it never comes to rest");
    assert_eq!(run.stages.last().map(|s| s.ended_by.clone()), Some(StageEnd::Swings), "and why");
    assert!(run.end_time < 3.0, "{} s", run.end_time);
}

#[test]
fn what_is_wrong_with_chains_is_said_all_at_once() {
    let plate = |name: &str, chain: &str| format!("[[plate]]\nname = \"{name}\"\n{chain}\n");
    let text = [
        BOX.to_owned(),
        START.to_owned(),
        plate("short", "chain = [[\"0 mm\", \"0 mm\"]]"),
        plate("arcs", "chain = [{ arc = { radius = \"1 mm\", turn = \"left\" } }, [\"0 mm\", \"0 mm\"], [\"9 mm\", \"-9 mm\"]]"),
        plate("small", "chain = [[\"0 mm\", \"0 mm\"], { arc = { radius = \"1 mm\", turn = \"left\" } }, [\"90 mm\", \"-9 mm\"]]"),
        plate("tight", "chain = [[\"0 mm\", \"0 mm\"], [\"5 mm\", \"-5 mm\"], [\"90 mm\", \"-9 mm\"]]\nbend_radius = \"1 m\""),
        plate("alone", "from = [\"0 mm\", \"0 mm\"]\nto = [\"50 mm\", \"-9 mm\"]\nbend_radius = \"1 mm\""),
        plate("twice", "chain = [[\"0 mm\", \"0 mm\"], { arc = { through = [\"4 mm\", \"1 mm\"], radius = \"9 mm\", turn = \"left\" } }, [\"9 mm\", \"-9 mm\"]]"),
    ]
    .concat();
    insta::assert_snapshot!("chains_that_are_none", refused(&text));
}

#[test]
fn a_sheet_whose_edge_does_not_fit_its_bends_is_refused() {
    let text = |middle: &str, more: &str| {
        let chain = format!("[[\"-233 mm\", \"90 mm\"], {middle}, [\"0 mm\", \"0 mm\"]]");
        format!("{BOX}{START}[[plate]]\nname = \"sheet\"\nchain = {chain}\n{more}\n")
    };
    let arc = "[\"-100 mm\", \"10 mm\"], { arc = { radius = \"90 mm\", turn = \"right\" } }";
    let kinked = refused(&text(arc, "edge_radius = \"1 mm\""));
    assert!(kinked.contains("smooth joints"), "{kinked}");
    let bend = "[\"-100 mm\", \"70 mm\"]";
    let thick = refused(&text(bend, "bend_radius = \"4 mm\"\nedge_radius = \"60 mm\""));
    assert!(thick.contains("edge radius"), "{thick}");
    read(&text(bend, "bend_radius = \"4 mm\"\nedge_radius = \"1 mm\""));
}

#[test]
fn radii_are_measured_as_they_are_written() {
    let scene = Scene::parse(
        "chute.toml",
        r#"
        part = { shape = "disc", radius = "5 mm", mass = "10 g" }
        contact = { friction = 0.2 }
        start = { to_edge = "200 mm" }
        [[plate]]
        name = "chute"
        bend_radius = "40 ± 1 mm"
        edge_radius = "2 ± 0.1 mm"
        chain = [["-400 mm", "280 mm"], ["-300 mm", "200 mm"], ["-100 mm", "200 mm"], { arc = { radius = "80 mm", turn = "right" } }, ["-20 mm", "120 mm"], ["-20 mm", "100 mm"]]
        [[wall]]
        name = "stop"
        from = ["100 mm", "0 mm"]
        to = ["100 mm", "100 mm"]
        edge_radius = "3 mm"
        "#,
    );
    let measures = scene.unwrap().measures();
    let radii = measures.iter().filter(|measure| measure.axis == MeasureAxis::Radius);
    let found: Vec<_> = radii.map(|m| (m.plate, m.name, m.text.as_str(), (m.to - m.from).norm())).collect();
    let expected = [
        (Some(0), "bend R", "40 ± 1 mm", 0.04),
        (Some(0), "bend R", "80 mm", 0.08),
        (Some(0), "edge R", "2 ± 0.1 mm", 0.002),
        (None, "edge R", "3 mm", 0.003),
    ];
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!((found.0, found.1, found.2), (expected.0, expected.1, expected.2), "what is written");
        assert!((found.3 - expected.3).abs() < SAME, "{} reaches {}", found.2, found.3);
    }
}

#[test]
fn a_half_disc_that_swings_for_ever_is_told_with_the_face_of_its_arc() {
    let text = format!(
        "{START}face = 1\nspeed = \"0.3 m/s\"\n[part]\nshape = \"chain\"\nmass = \"20 g\"\npoints = [[\"-15 mm\", \"0 mm\"], {{ arc = {{ radius = \"15 mm\", turn = \"left\" }} }}, [\"15 mm\", \"0 mm\"]]\n[[plate]]\nname = \"level\"\nfrom = [\"-500 mm\", \"0 mm\"]\nto = [\"500 mm\", \"0 mm\"]\n"
    );
    let (scene, run) = (read(&text), run(&text));
    assert_eq!(
        (run.outcome, run.swings_on(scene.feeder())),
        (Outcome::NeverFlat, Some(1)),
        "the arc is face 1"
    );
    let told = carom_words::run::headline(scene.feeder(), &run);
    assert_eq!(told.plate.as_deref(), Some("level"));
    assert_eq!(told.because, "it swings to and fro on face 1, and nothing takes energy from it");
}

/// A bowl without friction whose left end is this high.
fn smooth_bowl(left: &str) -> String {
    format!(
        "[[plate]]\nname = \"bowl\"\nfriction = 0\nchain = [{left}, {{ arc = {{ radius = \"250 mm\", turn = \"left\" }} }}, [\"200 mm\", \"100 mm\"]]\n[[plate]]\nname = \"below\"\nslope = \"20 deg\"\nbelow = {{ x = \"20 mm\", y = \"-220 mm\" }}\n"
    )
}

#[test]
fn a_disc_that_slides_to_and_fro_in_a_bowl_without_friction_swings_for_ever() {
    let bowl = smooth_bowl("[\"-200 mm\", \"100 mm\"]");
    // It starts 22 mm from the lowest point; of small swings the period is 2π √(244 mm/g).
    let period = std::f64::consts::TAU * (0.244 / 9.80665_f64).sqrt();
    for (speed, swings) in [("0 m/s", 1.0), ("0.3 m/s", 0.75)] {
        let text = format!("{START}speed = \"{speed}\"\n{DISC}{bowl}");
        let (scene, run) = (read(&text), run(&text));
        assert_eq!(run.outcome, Outcome::NeverFlat, "from {speed}");
        let told = carom_words::run::headline(scene.feeder(), &run);
        assert_eq!(told.because, "it swings to and fro, and nothing takes energy from it", "from {speed}");
        let share = run.end_time / period;
        assert!(share > 0.9 * swings && share < 1.3, "it was at both ends: after {share} periods");
    }
}

#[test]
fn what_turns_round_once_and_leaves_does_not_swing() {
    let out = format!(
        "{START}speed = \"0.469 m/s\"\n{DISC}{}",
        smooth_bowl("[\"-60 mm\", \"7.306778009768067 mm\"]")
    );
    assert_eq!(run(&out).outcome, Outcome::Landed, "over the low end");
    let plates = "[[plate]]\nname = \"upper\"\nfrom = [\"-300 mm\", \"80 mm\"]\nto = [\"0 mm\", \"0 mm\"]\n[[plate]]\nname = \"lower\"\nfrom = [\"400 mm\", \"-40 mm\"]\nto = [\"-100 mm\", \"-120 mm\"]\n[[plate]]\nname = \"third\"\nfrom = [\"-300 mm\", \"-160 mm\"]\nto = [\"300 mm\", \"-250 mm\"]\n";
    for part in [DISC, BOX] {
        for to_edge in [100, 103, 109, 115, 133, 160, 190, 217] {
            let start =
                format!("[contact]\nfriction = 0\nrestitution = 0.1\n[start]\nto_edge = \"{to_edge} mm\"\n");
            let zigzag = run(&format!("{start}{part}{plates}"));
            assert_eq!(zigzag.outcome, Outcome::Landed, "{to_edge} mm from the edge: down the three plates");
        }
    }
}

#[test]
fn a_chain_that_crosses_itself_or_only_rises_or_has_nothing_to_round_is_refused() {
    for (chain, says) in [
        (
            r#"[["-300 mm", "100 mm"], ["0 mm", "0 mm"], ["20 mm", "100 mm"], ["-100 mm", "100 mm"], ["-80 mm", "-40 mm"], ["60 mm", "-80 mm"]]"#,
            "plate.chute.chain: crosses itself",
        ),
        (r#"[["0 mm", "0 mm"], ["500 mm", "50 mm"]]"#, "plate.chute.chain: goes uphill"),
    ] {
        let said = refused(&format!("{START}{BOX}[[plate]]\nname = \"chute\"\nchain = {chain}\n"));
        assert!(said.contains(says), "{says}: {said}");
    }
    let straight = "[[plate]]\nname = \"chute\"\nchain = [[\"-500 mm\", \"50 mm\"], [\"0 mm\", \"0 mm\"]]\nbend_radius = \"9 mm\"\n";
    let said = refused(&format!("{START}{BOX}{straight}"));
    assert!(said.contains("plate.chute.bend_radius: rounds nothing"), "{said}");
}
