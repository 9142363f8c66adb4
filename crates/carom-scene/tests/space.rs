//! Scenes whose part is a solid.

use carom_feeder::Outcome;
use carom_feeder::spatial::CrossSection;
use carom_scene::{AnyScene, ApproximationKind, Drawn, Problems, Scene, SpaceRunReport, SpaceScene, Word};
use carom_study::yields::{Plan, Points, sample};

const BAR: &str = r#"
    [part]
    box = ["40 mm", "10 mm", "20 mm"]
    density = "7850 kg/m^3"
    [contact]
    friction = "0.15 ± 0.03"
    [start]
    to_edge = "100 mm"
    turn = { low = "-10 deg", high = "10 deg" }
    [[plate]]
    name = "upper"
    slope = "15 deg"
    width = "60 mm"
    [[plate]]
    name = "lower"
    slope = "10 deg"
    downhill = "left"
    below = { x = "-50 mm", y = "-160 mm" }
    want = "turned"
"#;

fn problems(text: &str) -> Problems {
    SpaceScene::parse("solid.toml", text).unwrap_err()
}

#[test]
fn the_part_says_where_it_is_followed() {
    let space = |text: &str| matches!(AnyScene::parse("some.toml", text), Ok(AnyScene::Space(_)));
    assert!(space(BAR), "a box of three edges");
    assert!(space(&BAR.replace("[part]", "[part]\nshape = \"solid\"")), "by its word");
    let corners = r#"vertices = [[0, 0, 0], ["20 mm", 0, 0], [0, "20 mm", 0], [0, 0, "20 mm"]]"#;
    assert!(space(&BAR.replace(r#"box = ["40 mm", "10 mm", "20 mm"]"#, corners)), "by corners in space");
    assert!(!space("[part]\nshape = \"box\""), "a box of the plane");
    let refused = Scene::parse("solid.toml", BAR).unwrap_err().to_string();
    assert!(
        refused.contains("solid.toml:2:6: part: is a solid") && refused.contains("carom yield"),
        "{refused}"
    );
    let flat = SpaceScene::parse("flat.toml", "[part]\nshape = \"rod\"").unwrap_err().to_string();
    assert!(flat.contains("followed in the plane"), "{flat}");
}

/// A washer of 24 sides lands; one of 96 is refused before anything is followed.
#[test]
fn round_parts_may_have_many_sides() {
    let scene = |sides: u32| {
        let corner = |y: f64| {
            move |k: u32| {
                let at = std::f64::consts::TAU * f64::from(k) / f64::from(sides);
                let (sine, cosine) = carom_num::elementary::sin_cos(at);
                format!("[{}, {y}, {}]", 0.015 * cosine, 0.015 * sine)
            }
        };
        let corners: Vec<String> =
            (0..sides).map(corner(-2e-3)).chain((0..sides).map(corner(2e-3))).collect();
        let vertices = format!("vertices = [{}]", corners.join(", "));
        BAR.replace(r#"box = ["40 mm", "10 mm", "20 mm"]"#, &vertices)
    };
    let washer = SpaceScene::parse("washer.toml", &scene(24)).unwrap();
    assert_eq!(washer.feeder().run_untraced().unwrap().outcome, Outcome::Landed);
    let told = problems(&scene(96)).to_string();
    assert!(told.contains("part: has a face of 96 corners: at most 95 are followed"), "{told}");
}

#[test]
fn all_problems_of_a_scene_are_told() {
    let text = r#"
        [part]
        shape = "solid"
        box = ["40 mm", "0 mm", "20 mm"]
        [contact]
        friction = -1
        [start]
        to_edge = "100 mm"
        face = "restin"
        [[plate]]
        slope = "15 deg"
        side_walls = "10 mm"
        bend_radius = "1 mm"
        [feed]
        parts = 3
    "#;
    let found = problems(text);
    let paths: Vec<&str> = found.list.iter().map(|problem| problem.path.as_str()).collect();
    for path in [
        "part.box.y",
        "part.mass",
        "contact.friction",
        "start.face",
        "plate.0.width",
        "plate.0.bend_radius",
        "feed",
    ] {
        assert!(paths.contains(&path), "{path} is not among {paths:?}");
    }
}

#[test]
fn what_is_drawn_is_checked_as_a_whole() {
    let beyond = problems(&BAR.replace("[start]", "[start]\nface = 6")).to_string();
    assert!(beyond.contains("start.face") && beyond.contains("0 to 5"), "{beyond}");
    let aside = problems(&BAR.replace("[start]", "[start]\naside = \"40 mm\"")).to_string();
    assert!(aside.contains("start.aside") && aside.contains("half the first plate's width"), "{aside}");
    let groove = problems(&format!("groove = {{ width = \"19 mm\" }}\n{BAR}")).to_string();
    assert!(groove.contains("groove.width: 19 mm is too narrow: the part takes 20 mm across"), "{groove}");
    let walled = BAR.replace("turn = ", "# ").replacen(
        "width = \"60 mm\"",
        "width = \"18 mm\"\nside_walls = \"2 mm\"",
        1,
    );
    let walled = problems(&walled).to_string();
    assert!(walled.contains("plate.upper.width: 18 mm is too narrow: the part takes 20 mm"), "{walled}");
    let wanted = problems(&BAR.replace("want = \"turned\"", "want = 6")).to_string();
    assert!(wanted.contains("plate.lower.want"), "{wanted}");
}

/// A groove is drawn by one more key, and in place of walls.
#[test]
fn a_plate_may_be_a_v_groove() {
    let grooved = |more: &str| {
        let with = format!("width = \"60 mm\"\nv_angle = \"90 deg\"\n{more}");
        BAR.replacen("width = \"60 mm\"", &with, 1)
    };
    let scene = SpaceScene::parse("groove.toml", &grooved("")).unwrap();
    let CrossSection::Groove { angle } = scene.feeder().plates[0].cross_section else { panic!("a groove") };
    assert!((angle - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    let wider = scene.with("plate.upper.v_angle", 2.0).unwrap();
    assert_eq!(wider.feeder().plates[0].cross_section, CrossSection::Groove { angle: 2.0 });
    let walled = problems(&grooved("side_walls = \"2 mm\""));
    assert_eq!(walled.list.len(), 1, "{walled}");
    assert!(walled.to_string().contains("v_angle: does not go together with side_walls"), "{walled}");
    let aside = problems(&grooved("").replace("[start]", "[start]\naside = \"1 mm\"")).to_string();
    assert!(aside.contains("start.aside: 1 mm is out of range: 0 in a groove"), "{aside}");
    let narrow = problems(&grooved("").replace("90 deg", "9 deg")).to_string();
    assert!(narrow.contains("plate.upper.v_angle: 9 deg is out of range: 10° to 170°"), "{narrow}");
}

/// Its faces stay where they are, and what is filled is the rounded box.
#[test]
fn the_edges_of_a_part_may_be_round() {
    let sharp = SpaceScene::parse("bar.toml", BAR).unwrap();
    let text = BAR.replace("density", "corner_radius = \"2 mm\"\n    density");
    let round = SpaceScene::parse("round.toml", &text).unwrap();
    let [own, other] = [&round, &sharp].map(|scene| &scene.feeder().part);
    assert_eq!(own.body.rounding(), Some(2e-3));
    for (one, face) in own.faces.iter().zip(&other.faces) {
        assert!((one.depth - face.depth).abs() < 1e-15 && (one.normal - face.normal).norm() < 1e-12);
    }
    let (lost, whole) = (other.body.mass() - own.body.mass(), other.body.mass());
    assert!(lost > 0.0 && lost < 0.1 * whole, "{lost} of {whole} kg");
    let run = round.feeder().run().unwrap();
    assert_eq!(run.outcome, Outcome::Landed);
    let thick = problems(&text.replace("2 mm", "6 mm")).to_string();
    assert!(thick.contains("part.corner_radius: is too large: nothing of the face"), "{thick}");
    for (radius, said) in
        [("4.99999999 mm", "is too large: nothing of the part is left"), ("1e-6 mm", "is too small beside")]
    {
        let unfit = problems(&text.replace("2 mm", radius)).to_string();
        assert!(unfit.contains("part.corner_radius") && unfit.contains(said), "{unfit}");
    }
}

/// The part lies on the upper side of a sheet, wherever its middle is, and lands on the other one.
#[test]
fn plates_and_walls_may_be_sheets_with_round_edges() {
    let round = |radius: &str| {
        let walled =
            "[[wall]]\nname = \"stop\"\nfrom = [\"80 mm\", \"-170 mm\"]\nto = [\"80 mm\", \"-100 mm\"]";
        let text =
            BAR.replace("width = \"60 mm\"", &format!("width = \"60 mm\"\n    edge_radius = \"{radius}\""));
        format!("{text}\n{walled}\nedge_radius = \"{radius}\"\n")
    };
    let scene = SpaceScene::parse("round.toml", &round("2 ± 0.1 mm")).unwrap();
    let thin = SpaceScene::parse("bar.toml", BAR).unwrap();
    assert_eq!(scene.feeder().start_state(), thin.feeder().start_state());
    let paths: Vec<String> = scene.quantities().into_iter().map(|quantity| quantity.path).collect();
    for path in ["plate.upper.edge_radius", "wall.stop.edge_radius"] {
        assert!(paths.iter().any(|own| own == path), "{path} is not among {paths:?}");
    }
    let run = scene.feeder().run().unwrap();
    assert_eq!(run.outcome, Outcome::Landed);
    let thick = problems(&round("31 mm")).to_string();
    for said in ["plate.upper.edge_radius: 31 mm is out of range", "less than half of the sheet's sides"] {
        assert!(thick.contains(said), "{said}: {thick}");
    }
}

#[test]
fn pins_stand_where_a_scene_says() {
    let pinned = |radius: &str, name: &str| {
        let pin = format!(
            "[[pin]]\n{name}from = [\"60 mm\", \"-80 mm\", \"-30 mm\"]\nto = [\"60 mm\", \"-80 mm\", \"30 mm\"]\nradius = \"{radius}\""
        );
        format!("{BAR}\n{pin}\nrestitution = 0.2\n")
    };
    let scene = SpaceScene::parse("pin.toml", &pinned("5 ± 0.2 mm", "")).unwrap();
    let paths: Vec<String> = scene.quantities().into_iter().map(|quantity| quantity.path).collect();
    for path in ["pin.0.from.z", "pin.0.radius", "pin.0.restitution"] {
        assert!(paths.iter().any(|own| own == path), "{path} is not among {paths:?}");
    }
    let run = scene.feeder().run().unwrap();
    assert_eq!((scene.feeder().walls[0].name.as_str(), &run.walls_touched[..]), ("pin 1", &[0][..]));
    let free = SpaceScene::parse("bar.toml", BAR).unwrap().feeder().run().unwrap();
    assert!((run.impacts[0].time - free.impacts[0].time).abs() > 0.01, "it is struck first");
    let thin = problems(&pinned("1e-6 mm", "name = \"post\"\n")).to_string();
    assert!(thin.contains("pin.post.radius") && thin.contains("0.00001 to 4000 part sizes"), "{thin}");
    let bare = problems(&format!("{BAR}\n[[pin]]\nfrom = [\"1 mm\", 0]\n")).to_string();
    for said in ["pin.0.from", "pin.0.to", "pin.0.radius"] {
        assert!(bare.contains(said), "{said}: {bare}");
    }
}

#[test]
fn the_shape_of_a_solid_has_no_tolerance() {
    let text = BAR
        .replace("density", "corner_radius = \"2 ± 0.1 mm\"\n    density")
        .replace("\"40 mm\"", "\"40 ± 0.5 mm\"");
    let found = problems(&text);
    let paths: Vec<&str> = found.list.iter().map(|problem| problem.path.as_str()).collect();
    assert_eq!(paths, ["part.box", "part.corner_radius"]);
    assert!(found.to_string().contains("write its middle alone"), "{found}");
}

#[test]
fn faces_of_a_box_have_the_numbers_of_the_plane() {
    let scene = SpaceScene::parse("bar.toml", BAR).unwrap();
    let report = SpaceRunReport::new(&scene, &scene.feeder().run().unwrap());
    let normals: Vec<[f64; 3]> = report.faces.iter().map(|face| face.normal).collect();
    let wanted = [
        [0.0, -1.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [-1.0, 0.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.0, 0.0, -1.0],
    ];
    assert_eq!(normals, wanted);
    let heights: Vec<f64> = report.faces.iter().map(|face| face.centre_height_m).collect();
    for (height, wanted) in heights.iter().zip([0.005, 0.02, 0.005, 0.02, 0.01, 0.01]) {
        assert!((height - wanted).abs() < 1e-15, "{heights:?}");
    }
    assert_eq!(report.outcome, Word(Outcome::Landed));
    assert_eq!((report.plates[0].face, report.wanted[0].met), (Some(2), true), "the opposite face is down");
}

#[test]
fn a_hull_in_place_of_a_surface_is_said() {
    let folder = "../../examples/solid_bolt.toml";
    let AnyScene::Space(bolt) = AnyScene::read(folder.as_ref()).unwrap() else { panic!("a solid") };
    let [hull] = bolt.approximations() else { panic!("one approximation") };
    assert_eq!((hull.kind, hull.unit), (ApproximationKind::ConvexHull, "1"));
    assert!(hull.amount > 0.3 && hull.text.contains("convex hull"), "{hull:?}");
    let bar = SpaceScene::parse("bar.toml", BAR).unwrap();
    assert!(bar.approximations().is_empty());
}

#[test]
fn quantities_of_space_have_paths() {
    let scene = SpaceScene::parse("bar.toml", &format!("groove = {{ width = \"30 mm\" }}\n{BAR}")).unwrap();
    let paths: Vec<String> = scene.quantities().into_iter().map(|quantity| quantity.path).collect();
    for path in ["start.turn", "start.aside", "groove.width", "plate.upper.width", "plate.upper.roll"] {
        assert!(paths.iter().any(|found| found == path), "{path} is not among {paths:?}");
    }
    assert_eq!(scene.varied().unwrap().paths(), ["contact.friction", "start.turn"]);
}

/// Of each face from which parts come to a plate the shares sum to 1.
#[test]
fn a_yield_in_space_has_its_transitions() {
    let text = BAR.replace("[start]", "[start]\nface = [{ face = 0, share = 1 }, { face = 4, share = 1 }]");
    let scene = SpaceScene::parse("bar.toml", &text).unwrap();
    let varied = scene.varied().unwrap();
    let plan = Plan {
        dimensions: varied.dimensions(),
        samples: 4,
        seed: 1,
        points: Points::Sobol,
        plates: 2,
        plate: 1,
    };
    let wanted = |run: &_| scene.ends_as_wanted(run) == Some(true);
    let found = sample(&plan, |point| varied.feeder(point), wanted, |point| varied.distance(point)).unwrap();
    assert_eq!(found.drops, 64);
    for face in [0, 4] {
        let from = carom_study::Ending::Lies(carom_feeder::Verdict::Face(face));
        let shares =
            found.transitions.iter().filter(|found| found.from == from).map(|found| found.share.share);
        assert!((shares.sum::<f64>() - 1.0).abs() < 1e-12, "from face {face}: {:?}", found.transitions);
    }
}
