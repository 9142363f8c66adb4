//! A drawing is a silhouette: where a part is not as thick everywhere, its scene says where its mass is.

use carom_scene::{Problems, Scene};

const TOLERANCE: f64 = 1e-14;

fn read(part: &str) -> Result<Scene, Problems> {
    let text = format!(
        "[part]\n{part}\n[contact]\nfriction = 0.2\n[start]\nto_edge = \"60 mm\"\n[[plate]]\nslope = \"25 deg\"\n[[plate]]\nslope = \"20 deg\"\nbelow = {{ x = \"20 mm\", y = \"-120 mm\" }}\n"
    );
    Scene::parse("tests/outlines/scene.toml", &text)
}

fn scene(part: &str) -> Scene {
    read(part).unwrap_or_else(|problems| panic!("{problems}"))
}

/// A hexagonal head, 17 mm across flats and 6.4 mm high, on a round shank of 10 × 40 mm, of steel: mass, centre from the head, inertia
/// across its axis.
fn bolt() -> [f64; 3] {
    let (density, flats, head, diameter, shank) = (7850.0, 0.017, 0.0064, 0.01, 0.04);
    let section = 3.0_f64.sqrt() / 2.0 * flats * flats;
    // About an axis in its plane a regular hexagon's second moment is 5·√3/16 of its side's fourth power.
    let side: f64 = flats / 3.0_f64.sqrt();
    let of_hexagon = 5.0 * 3.0_f64.sqrt() / 16.0 * side.powi(4);
    let round = std::f64::consts::PI / 4.0 * diameter * diameter;
    let pieces = [
        (density * section * head, 0.5 * head, of_hexagon / section + head * head / 12.0),
        (density * round * shank, head + 0.5 * shank, diameter * diameter / 16.0 + shank * shank / 12.0),
    ];
    let mass: f64 = pieces.iter().map(|(mass, ..)| mass).sum();
    let centre = pieces.iter().map(|(mass, at, _)| mass * at).sum::<f64>() / mass;
    let inertia = pieces.iter().map(|(mass, at, own)| mass * (own + (at - centre) * (at - centre))).sum();
    [mass, centre, inertia]
}

#[test]
fn a_bolt_drawn_as_a_silhouette_weighs_as_a_bolt() {
    let [mass, centre, inertia] = bolt();
    assert!((mass - 0.0372).abs() < 5e-5 && (centre - 0.0186).abs() < 5e-5, "{mass} kg, {centre} m");
    let bolt = scene(&format!(
        "shape = \"outline\"\nfile = \"bolt.svg\"\nmass = {mass}\nmass_centre = [{centre}, \"10 mm\"]\ninertia = {inertia}"
    ));
    let body = &bolt.feeder().part.body;
    assert_eq!((body.mass, body.inertia), (mass, inertia), "as given");
    let (left, right) = body
        .shape
        .vertices()
        .iter()
        .fold((0.0_f64, 0.0_f64), |(low, high), vertex| (low.min(vertex.x), high.max(vertex.x)));
    assert!((left + centre).abs() < TOLERANCE, "the head is {centre} behind the mass centre: {left}");
    assert!((right - (0.0464 - centre)).abs() < TOLERANCE, "the tip is the rest before it: {right}");
    let drawn = bolt.outline();
    let tip = drawn[0].iter().map(|point| point.x).fold(0.0, f64::max);
    assert!((tip - right).abs() < TOLERANCE, "a picture has it there too: {tip}");
    assert!(bolt.approximations().is_empty(), "{:?}", bolt.approximations());
    let moved = bolt.with("part.mass_centre.x", centre + 0.001).unwrap();
    let (long, half): (f64, f64) = (0.0464 - centre - 0.001, 0.005);
    let farthest = (long * long + half * half).sqrt();
    let size = moved.feeder().part.body.shape.size();
    assert!((size - farthest).abs() < TOLERANCE, "it can vary: {size}");
}

/// An SVG file counts y downwards, a polygon's corners upwards.
#[test]
fn a_mass_centre_is_where_the_drawing_has_it() {
    let given = "mass = 1\nmass_centre = [\"10 mm\", \"12 mm\"]\ninertia = \"200 kg mm^2\"";
    // 50 × 20 mm from (0, 0): the point is 8 mm above the lower side in one, below the upper one in the other.
    let heights = |part: &str| {
        let scene = scene(&format!("{part}\n{given}"));
        let ys: Vec<f64> = scene.feeder().part.body.shape.vertices().iter().map(|vertex| vertex.y).collect();
        (ys.iter().copied().fold(0.0, f64::min), ys.iter().copied().fold(0.0, f64::max))
    };
    let polygon = "shape = \"polygon\"\nvertices = [[0, 0], [0.05, 0], [0.05, 0.02], [0, 0.02]]";
    let (low, high) = heights(polygon);
    assert!((low + 0.012).abs() < TOLERANCE && (high - 0.008).abs() < TOLERANCE, "y up: {low} to {high}");
    let (low, high) = heights("shape = \"outline\"\nfile = \"slab.svg\"");
    assert!((low + 0.008).abs() < TOLERANCE && (high - 0.012).abs() < TOLERANCE, "y down: {low} to {high}");
    let (low, high) = heights("shape = \"box\"\nlength = \"50 mm\"\nheight = \"30 mm\"");
    assert!(
        (low + 0.027).abs() < TOLERANCE && (high - 0.003).abs() < TOLERANCE,
        "from the middle: {low} to {high}"
    );
}

#[test]
fn what_is_not_uniform_has_an_inertia_of_its_own() {
    let bar =
        "shape = \"box\"\nlength = \"60 mm\"\nheight = \"20 mm\"\nmass = 1\nmass_centre = [\"10 mm\", 0]";
    let text = read(bar).expect_err("no inertia").to_string();
    // (60² + 20²)/12 mm² and 10² mm² for the shift.
    assert!(text.contains("part.inertia") && text.contains("0.00043333 kg m^2"), "{text}");
}

#[test]
fn a_mass_centre_lies_within_its_part() {
    let part = |shape: &str, at: &str| {
        let found = read(&format!("{shape}\nmass = 1\nmass_centre = {at}\ninertia = \"10 kg mm^2\""));
        found.map(drop).map_err(|problems| problems.to_string())
    };
    let bar = "shape = \"box\"\nlength = \"60 mm\"\nheight = \"20 mm\"";
    assert!(part(bar, "[\"29 mm\", \"9 mm\"]").is_ok(), "in a corner");
    let rod = "shape = \"rod\"\nlength = \"60 mm\"";
    assert!(part(rod, "[\"29 mm\", 0]").is_ok(), "near the end of a rod");
    for (shape, at) in [
        (bar, "[\"31 mm\", 0]"),
        (bar, "[\"30 mm\", 0]"),
        (rod, "[\"10 mm\", \"1 mm\"]"),
        (rod, "[\"30 mm\", 0]"),
        ("shape = \"disc\"\nradius = \"10 mm\"", "[\"1 mm\", 0]"),
    ] {
        let text = part(shape, at).expect_err("no mass is there");
        assert!(text.contains("part.mass_centre"), "{shape} {at}: {text}");
    }
}

/// Balanced on its end a stick tips later: where the mass is decides when the part leaves the edge.
#[test]
fn a_rod_whose_mass_is_at_its_tail_overhangs_farther() {
    let rod = |x: f64| {
        let scene = scene(&format!(
            "shape = \"rod\"\nlength = \"60 mm\"\nmass = 1\nmass_centre = [{x}, 0]\ninertia = \"200 kg mm^2\""
        ));
        let feeder = scene.feeder();
        let front = feeder.part.body.shape.vertices()[1].x;
        // Until its mass centre is over the edge it slides, its front that far beyond.
        assert!((front - (0.03 - x)).abs() < TOLERANCE, "front {front}");
        let run = feeder.run().unwrap();
        run.stages[0].end.pose.centre.norm()
    };
    for x in [-0.02, 0.0, 0.02] {
        assert!(rod(x) < 1e-9, "tips about the edge with its mass centre over it");
    }
}

/// The faces are those about the mass centre that the scene gives, and so is the pose in which the part starts.
#[test]
fn a_box_with_its_mass_elsewhere_lies_by_its_own_centre() {
    let part = "shape = \"box\"\nlength = \"60 mm\"\nheight = \"20 mm\"\nmass = 1\ninertia = \"400 kg mm^2\"\nmass_centre = [\"10 mm\", \"4 mm\"]";
    let off = scene(part);
    let shape = &off.feeder().part.body.shape;
    let heights: Vec<f64> = shape.rests().iter().map(|rest| rest.depth).collect();
    for (face, (height, wanted)) in heights.iter().zip([0.014, 0.020, 0.006, 0.040]).enumerate() {
        assert!((height - wanted).abs() < TOLERANCE, "face {face}: {height} m above it, not {wanted}");
    }
}
