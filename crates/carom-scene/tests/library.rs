//! Parts that are known by their name: their dimensions, what they weigh, how they lie, and what is said of wrong ones.

use crate::held;

use carom_feeder::PartKind;
use carom_scene::{Form, Problems, Scene};
use carom_theory::solids;
use std::f64::consts::PI;

/// Rounding of some tens of sums.
const ROUNDING: f64 = 1e-12;
const DENSITY: f64 = 7850.0;

fn text(part: &str) -> String {
    format!(
        "[part]\n{part}\n[contact]\nfriction = 0.2\n[start]\nto_edge = \"60 mm\"\n[[plate]]\nslope = \"20 deg\"\n[[plate]]\nslope = \"15 deg\"\nbelow = {{ x = \"30 mm\", y = \"-150 mm\" }}\n"
    )
}

fn read(part: &str) -> Result<Scene, Problems> {
    let text = text(part);
    held::file(Form::Scene, &text);
    Scene::parse("scene.toml", &text)
}

fn steel(part: &str) -> Scene {
    read(&format!("{part}\ndensity = \"7.85 g/cm^3\"")).unwrap_or_else(|problems| panic!("{problems}"))
}

fn value(scene: &Scene, path: &str) -> f64 {
    let found = scene.quantities().into_iter().find(|quantity| quantity.path == path);
    found.unwrap_or_else(|| panic!("no {path}")).value
}

fn close(found: f64, known: f64, what: &str) {
    assert!((found - known).abs() <= ROUNDING * known.abs(), "{what}: {found} is not {known}");
}

/// Well-known rows of ISO 4017, ISO 4762, ISO 7089 and ISO 2338.
#[test]
fn sizes_have_the_dimensions_of_their_standards() {
    let mm = |part: &str, path: &str| 1e3 * value(&steel(part), &format!("part.{path}"));
    let bolt = |size: &str, head: &str| format!("shape = \"bolt\"\nsize = \"{size}\"\nhead = \"{head}\"");
    for (size, width, height) in
        [("M3 x 10", 5.5, 2.0), ("M8 x 30", 13.0, 5.3), ("M8×30", 13.0, 5.3), ("M16x80", 24.0, 10.0)]
    {
        close(mm(&bolt(size, "hexagon"), "head_width"), width, size);
        close(mm(&bolt(size, "hexagon"), "head_height"), height, size);
    }
    for (size, width, socket, depth) in [("M5 x 20", 8.5, 4.0, 2.5), ("M8 x 30", 13.0, 6.0, 4.0)] {
        let bolt = bolt(size, "socket");
        close(mm(&bolt, "head_width"), width, size);
        close(mm(&bolt, "socket_width"), socket, size);
        close(mm(&bolt, "socket_depth"), depth, size);
        close(mm(&bolt, "head_height"), mm(&bolt, "diameter"), size);
    }
    for (size, inner, outer, thick) in
        [("M5", 5.3, 10.0, 1.0), ("M8", 8.4, 16.0, 1.6), ("M20", 21.0, 37.0, 3.0)]
    {
        let washer = format!("shape = \"washer\"\nsize = \"{size}\"");
        close(mm(&washer, "inner_diameter"), inner, size);
        close(mm(&washer, "outer_diameter"), outer, size);
        close(mm(&washer, "thickness"), thick, size);
    }
    close(mm("shape = \"pin\"\nsize = \"8 x 30\"", "chamfer"), 1.6, "8 x 30");
}

#[test]
fn a_bolt_weighs_its_head_and_its_thread() {
    let part = &steel("shape = \"bolt\"\nsize = \"M8 x 30\"").to_feeder().part.body;
    let (hexagon, k) = (0.5 * 3f64.sqrt() * 0.013 * 0.013, 0.0053);
    let pitch_diameter = 0.008 - 0.375 * 3f64.sqrt() * 0.00125;
    let thread = solids::cylinder(0.5 * pitch_diameter, 0.03);
    let (head, shank) = (DENSITY * hexagon * k, DENSITY * thread.volume);
    close(part.mass, head + shank, "mass");
    // A regular hexagon: 5√3/144 s⁴ about each axis through its middle.
    let own = head * (5.0 * 3f64.sqrt() / 144.0 * 0.013f64.powi(4) / hexagon + k * k / 12.0);
    let apart = 0.5 * k + 0.015;
    let reduced = head * shank / (head + shank);
    close(part.inertia, own + shank * thread.gyration_squared + reduced * apart * apart, "inertia");
}

#[test]
fn a_washer_is_a_ring_that_stands_in_the_plane_as_a_box() {
    let part = steel("shape = \"washer\"\nsize = \"M8\"").to_feeder().part;
    let ring = solids::ring(0.0042, 0.008, 0.0016);
    close(part.body.mass, DENSITY * ring.volume, "mass");
    close(part.body.inertia, DENSITY * ring.volume * ring.gyration_squared, "inertia");
    assert_eq!(part.kind, PartKind::Box, "it lies on a flat side or the other");
    let long = part.body.shape.face_length(0);
    close(long, 0.016, "face 0");
}

/// A cap without rounding is a disc and a ring.
#[test]
fn a_cap_weighs_its_wall_and_touches_with_its_shadow() {
    let part =
        steel("shape = \"cap\"\ndiameter = \"30 mm\"\nheight = \"12 mm\"\nwall = \"2 mm\"\nbase = \"3 mm\"");
    let body = &part.feeder().part.body;
    let (base, wall) = (solids::cylinder(0.015, 0.003), solids::ring(0.013, 0.015, 0.009));
    let volume = base.volume + wall.volume;
    close(body.mass, DENSITY * volume, "mass");
    let apart = 0.0015 + 0.0045;
    let reduced = base.volume * wall.volume / volume;
    let moment =
        base.volume * base.gyration_squared + wall.volume * wall.gyration_squared + reduced * apart * apart;
    close(body.inertia, DENSITY * moment, "inertia");
    let rests = body.shape.rests();
    assert_eq!(rests.len(), 4, "its opening is no hollow for a plate: {rests:?}");
    let deep = [0, 2].map(|face: usize| rests[face].depth);
    close(deep[0] + deep[1], 0.012, "from its open end to its closed one");
}

#[test]
fn revolved_profiles_are_balls_cones_and_what_other_shapes_are() {
    let ball = steel(
        "shape = \"revolved\"\nprofile = [[\"-10 mm\", 0], { arc = { radius = \"10 mm\", turn = \"right\" } }, [\"10 mm\", 0]]",
    );
    let part = &ball.feeder().part;
    assert_eq!(part.kind, PartKind::Disc, "a ball rolls");
    close(part.body.inertia, DENSITY * 4.0 / 3.0 * PI * 1e-6 * 0.4e-4, "a ball");
    let cone = steel("shape = \"revolved\"\nprofile = [[0, 0], [0, \"12 mm\"], [\"40 mm\", 0]]");
    let known = solids::cone(0.012, 0.04);
    let body = &cone.feeder().part.body;
    close(body.mass, DENSITY * known.volume, "a cone");
    close(body.inertia, body.mass * known.gyration_squared, "a cone");
    let cap = "shape = \"cap\"\ndiameter = \"30 mm\"\nheight = \"12 mm\"\nwall = \"2 mm\"";
    let same = "shape = \"revolved\"\nprofile = [[0, 0], [0, \"15 mm\"], [\"12 mm\", \"15 mm\"], [\"12 mm\", 0]]\nbore = [[\"2 mm\", 0], [\"2 mm\", \"13 mm\"], [\"12 mm\", \"13 mm\"]]";
    let [a, b] = [cap, same].map(|part| steel(part).to_feeder().part);
    close(a.body.inertia, b.body.inertia, "a cap by its profile");
    assert_eq!(a.body.shape, b.body.shape, "the same shadow");
}

#[test]
fn pins_may_have_chamfers_round_ends_or_none() {
    let pin =
        |ends: &str| steel(&format!("shape = \"pin\"\ndiameter = \"8 mm\"\nlength = \"30 mm\"\n{ends}"));
    let sharp = pin("").to_feeder().part;
    let known = solids::cylinder(0.004, 0.03);
    close(sharp.body.inertia, DENSITY * known.volume * known.gyration_squared, "sharp");
    assert_eq!(sharp.kind, PartKind::Box, "four faces");
    let round = pin("corner_radius = \"4 mm\"").to_feeder().part;
    let ends = solids::ball(0.004).volume + solids::cylinder(0.004, 0.022).volume;
    close(round.body.mass, DENSITY * ends, "round");
    let cut = pin("chamfer = \"1 mm\"").to_feeder().part;
    let less = 2.0 * (PI * 0.004f64.powi(2) * 0.001 - PI / 3.0 * 0.001 * (16.0 + 12.0 + 9.0) * 1e-6);
    close(cut.body.mass, DENSITY * (known.volume - less), "chamfered");
}

/// Two rectangles, and with radii a square less a quarter of a disc at the corner, less or more.
#[test]
fn a_bracket_is_two_legs_and_lies_on_one_of_them() {
    let bracket = |radii: &str| {
        steel(&format!(
            "shape = \"bracket\"\nlegs = [\"40 mm\", \"30 mm\"]\nthickness = \"3 mm\"\ndepth = \"20 mm\"\n{radii}"
        ))
    };
    let sharp = bracket("").to_feeder().part.body;
    close(sharp.mass, DENSITY * 0.02 * (0.04 * 0.003 + 0.027 * 0.003), "sharp");
    let rests = sharp.shape.rests();
    close((rests[0].to - rests[0].from).norm(), 0.04, "face 0 is the longer leg");
    let bent = bracket("inner_radius = \"2 mm\"\nouter_radius = \"5 mm\"").to_feeder().part.body;
    let corners = (1.0 - 0.25 * PI) * (4e-6 - 25e-6);
    close(bent.mass, DENSITY * 0.02 * (0.04 * 0.003 + 0.027 * 0.003 + corners), "bent");
}

#[test]
fn dimensions_of_a_standard_can_be_varied() {
    let scene = steel("shape = \"bolt\"\nsize = \"M8\"\nlength = \"30 ± 0.5 mm\"");
    let wider = scene.with("part.head_width", 0.014).unwrap();
    assert!(wider.feeder().part.body.mass > scene.feeder().part.body.mass, "a wider head is heavier");
    assert!(scene.with("part.head_width", 0.007).is_err(), "narrower than its thread");
    let length = scene.quantities().into_iter().find(|quantity| quantity.path == "part.length").unwrap();
    assert!(length.written && length.tolerance.is_some(), "{length:?}");
    let bore = "shape = \"revolved\"\nprofile = [[0, 0], [0, 0.01], [0.02, 0.01], [0.02, 0]]\nbore = [[0, 0.004], [0.02, 0.004]]";
    assert!((steel(bore).with("part.bore.0.y", 0.002)).is_ok(), "points by their numbers");
}

/// Far from the drawing's zero the moments keep their digits.
#[test]
fn it_does_not_matter_where_a_profile_is_drawn() {
    let cylinder = |from: f64| {
        let to = from + 0.03125;
        steel(&format!(
            "shape = \"revolved\"\nprofile = [[{from}, 0], [{from}, 0.0078125], [{to}, 0.0078125], [{to}, 0]]"
        ))
    };
    let [near, far] = [0.0, 4.0].map(|from| cylinder(from).to_feeder().part.body);
    close(far.inertia, near.inertia, "inertia");
    assert_eq!(far.shape, near.shape, "the same body");
}

/// What is wrong, and what is said.
#[test]
fn wrong_parts_are_told_what_is_wrong() {
    let parts = [
        "shape = \"bolt\"\nsize = \"M7 x 30\"",
        "shape = \"bolt\"\nsize = \"8-30\"",
        "shape = \"bolt\"\nsize = \"M8\"",
        "shape = \"bolt\"\nsize = \"M8 x 30\"\nlength = \"30 mm\"",
        "shape = \"bolt\"\nsize = \"M8 x 30\"\ndiameter = \"8 mm\"",
        "shape = \"bolt\"\nlength = \"30 mm\"",
        "shape = \"bolt\"\nsize = \"M8 x 30\"\nhead_width = \"7 mm\"\nthread_length = \"40 mm\"\npitch = \"9 mm\"",
        "shape = \"bolt\"\nsize = \"M8 x 30\"\nsocket_width = \"6 mm\"",
        "shape = \"bolt\"\nsize = \"M8 x 30\"\nhead = \"socket\"\nsocket_depth = \"9 mm\"\nsocket_width = \"12 mm\"",
        "shape = \"bolt\"\nsize = \"M8 x 30\"\ndepth = \"8 mm\"",
        "shape = \"washer\"\nsize = \"M8 x 2\"",
        "shape = \"washer\"\ninner_diameter = \"8 mm\"",
        "shape = \"washer\"\nsize = \"M8\"\ninner_diameter = \"16 mm\"",
        "shape = \"pin\"\nsize = \"7 x 30\"",
        "shape = \"pin\"\ndiameter = \"8 mm\"\nlength = \"30 mm\"\nchamfer = \"1 mm\"\ncorner_radius = \"1 mm\"",
        "shape = \"pin\"\ndiameter = \"8 mm\"\nlength = \"30 mm\"\nchamfer = \"5 mm\"",
        "shape = \"pin\"\ndiameter = \"8 mm\"\nlength = \"30 mm\"\nchamfer = \"20 mm\"",
        "shape = \"pin\"\ndiameter = \"8 mm\"\nlength = \"30 mm\"\nchamfer_angle = \"15 deg\"",
        "shape = \"cap\"\ndiameter = \"30 mm\"\nheight = \"12 mm\"\nwall = \"15 mm\"\ncorner_radius = \"20 mm\"",
        "shape = \"cap\"\ndiameter = \"30 mm\"\nwall = \"2 mm\"",
        "shape = \"bracket\"\nlegs = [\"40 mm\", \"3 mm\"]\nthickness = \"3 mm\"\ndepth = \"20 mm\"",
        "shape = \"bracket\"\nlegs = [\"40 mm\", \"30 mm\"]\nthickness = \"3 mm\"\ninner_radius = \"27 mm\"\ndepth = \"20 mm\"",
        "shape = \"bracket\"\nlegs = [\"40 mm\", \"30 mm\"]\nthickness = \"3 mm\"\nouter_radius = \"4 mm\"\ndepth = \"20 mm\"",
        "shape = \"bracket\"\nlegs = [\"40 mm\", \"30 mm\"]\nthickness = \"3 mm\"",
        "shape = \"revolved\"\nprofile = [[0, 0.01], [0.02, 0.01], [0.02, 0]]",
        "shape = \"revolved\"\nprofile = [[0, 0], [0, 0.01], [0.02, 0.01], [0.01, 0.005], [0.01, 0]]",
        "shape = \"revolved\"\nprofile = [[0, 0], [0, 0.01], [0.02, -0.01], [0.02, 0]]",
        "shape = \"revolved\"\nprofile = [[0, 0], [0, 0.01], [0.02, 0.01], [0.02, 0]]\nbore = [[0, 0.004], [0.02, 0.011]]",
        "shape = \"revolved\"\nbore = [[0, 0.004], [0.02, 0.004]]",
        "shape = \"revolved\"\nprofile = [[0, 0], [1, 0]]",
        "shape = \"revolved\"\nprofile = [[-1, 0], { arc = { radius = 1, turn = \"right\" } }, [1, 0]]\nbore = [[0, 0.1], [0.2, 0.1]]",
        "shape = \"bolt\"\nsize = \"M8 x 30000000000000\"",
    ];
    let told: Vec<String> = parts
        .iter()
        .map(|part| {
            let found = read(&format!("{part}\ndensity = \"7.85 g/cm^3\"")).err();
            let found = found.unwrap_or_else(|| panic!("{part}\nis read"));
            let lines = found.list.iter().map(|problem| {
                let help = problem.help.as_ref().map_or(String::new(), |help| format!("\n    {help}"));
                format!("  {}: {}{help}", problem.path, problem.message)
            });
            format!("{part}\n{}", lines.collect::<Vec<_>>().join("\n"))
        })
        .collect();
    insta::assert_snapshot!(told.join("\n\n"));
}
