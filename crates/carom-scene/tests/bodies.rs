//! Bodies that are thrown: what files say of them, from vertices and from surfaces, and what is wrong with them.

use crate::held;

use carom_motion::spatial::{Mesh, Polyhedron, Solid};
use carom_num::{Rotation, Vec3};
use carom_scene::{Form, SpatialRollKind, SpatialRollProblem, SpatialRollReport};
use std::fs;
use std::path::PathBuf;
use stl_io::{Normal, Triangle, Vertex};

/// A file of this test's own.
fn place(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("bodies");
    fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

/// Reads a roll file that would stand beside the surfaces.
fn parse(source: &str) -> Result<SpatialRollProblem, String> {
    let file = place("body.toml");
    let found = SpatialRollProblem::parse(SpatialRollKind::Body, file.to_str().unwrap(), source, &[]);
    found.map_err(|problems| problems.to_string())
}

fn report(problem: &SpatialRollProblem) -> SpatialRollReport {
    SpatialRollReport::new(problem, &problem.follow().unwrap())
}

fn triangles(mesh: &Mesh) -> Vec<Triangle> {
    let corner = |i: usize| Vertex::new(mesh.vertices[i].to_array().map(|x| (1e3 * x) as f32));
    let facet = |f: &[usize; 3]| Triangle { normal: Normal::new([0.0, 0.0, 0.0]), vertices: f.map(corner) };
    mesh.facets.iter().map(facet).collect()
}

/// A surface as a binary file in millimetres.
fn binary(name: &str, mesh: &Mesh) {
    let mut bytes = vec![];
    stl_io::write_stl(&mut bytes, triangles(mesh).iter()).unwrap();
    fs::write(place(name), bytes).unwrap();
}

/// The same as text.
fn ascii(name: &str, mesh: &Mesh) {
    let mut text = "solid part\n".to_owned();
    for triangle in triangles(mesh) {
        text += "facet normal 0 0 0\nouter loop\n";
        for vertex in triangle.vertices {
            let [x, y, z] = vertex.0;
            text += &format!("vertex {x:e} {y:e} {z:e}\n");
        }
        text += "endloop\nendfacet\n";
    }
    fs::write(place(name), text + "endsolid part\n").unwrap();
}

/// A brick of 60 × 40 × 25 mm, turned and moved.
fn brick(turn: Vec3, shift: Vec3) -> Mesh {
    let sign = |i: u32, k: u32| f64::from(2 * (i >> k & 1)) - 1.0;
    let corner = |i: u32| Vec3::new(0.03 * sign(i, 0), 0.02 * sign(i, 1), 0.0125 * sign(i, 2));
    let corners: Vec<Vec3> = (0..8).map(|i| Rotation::by(turn).apply(corner(i)) + shift).collect();
    Polyhedron::of_points(&corners, 1e-10).unwrap().mesh()
}

#[test]
fn a_surface_that_is_written_and_read_is_the_same_body() {
    let (turn, shift) = (Vec3::new(0.3, -1.2, 0.5), Vec3::new(0.05, -0.02, 0.01));
    let mesh = brick(turn, shift);
    binary("brick.stl", &mesh);
    ascii("brick-text.STL", &mesh);
    let of = |file: &str| parse(&format!("file = \"{file}\"\nmass = 0.3\n")).unwrap();
    let (first, second) = (of("brick.stl"), of("brick-text.STL"));
    assert_eq!(first.world, second.world, "binary and text");
    let thrown = first.thrown.as_ref().unwrap();
    assert!(thrown.shape.convex && thrown.homogeneous);
    assert_eq!((thrown.shape.hull.vertices().len(), thrown.shape.hull.faces().len()), (8, 6));
    // 24 binary digits of 0.1 m are 6 nm.
    assert!((thrown.centre - shift).norm() < 1e-8, "{:?}", thrown.centre);
    assert!(
        thrown.shape.hull.unevenness() < 1e-16,
        "its faces are plane: {}",
        thrown.shape.hull.unevenness()
    );
    let body = report(&first).body.unwrap();
    let [a, b, c] = [0.06_f64, 0.04, 0.025].map(|l| l * l);
    let expected = [b + c, a + c, a + b].map(|s| 0.3 * s / 12.0);
    for (moment, expected) in body.principal_moments_kg_m2.iter().zip(expected) {
        assert!((moment / expected - 1.0).abs() < 1e-6, "{moment} {expected}");
    }
    assert!((body.density_kg_m3 / (0.3 / 6e-5) - 1.0).abs() < 1e-6, "{}", body.density_kg_m3);
}

#[test]
fn a_surface_that_is_not_convex_weighs_what_it_encloses_and_stands_on_its_hull() {
    // An L of three cubes of 10 mm, as two boxes that share no face: its surface is a prism on an L.
    let l = [[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [10.0, 10.0], [10.0, 20.0], [0.0, 20.0]];
    let at = |i: usize, z: f64| Vec3::new(1e-3 * l[i][0], 1e-3 * l[i][1], z);
    let vertices: Vec<Vec3> = (0..6).map(|i| at(i, 0.0)).chain((0..6).map(|i| at(i, 0.01))).collect();
    let mut facets = vec![[0, 3, 1], [1, 3, 2], [0, 5, 3], [3, 5, 4]];
    facets.extend(facets.clone().iter().map(|[a, b, c]| [a + 6, c + 6, b + 6]));
    for i in 0..6 {
        let j = (i + 1) % 6;
        facets.extend([[i, j, j + 6], [i, j + 6, i + 6]]);
    }
    binary("l.stl", &Mesh { vertices, facets });
    let problem = parse("file = \"l.stl\"\ndensity = 1000\n").unwrap();
    let thrown = problem.thrown.as_ref().unwrap();
    assert!(!thrown.shape.convex);
    // Three cubes: the centre is at (5 + 15 + 5)/3 mm.
    let centre = Vec3::new(25.0 / 3.0, 25.0 / 3.0, 5.0) * 1e-3;
    assert!((thrown.centre - centre).norm() < 1e-9, "{:?}", thrown.centre);
    assert!((problem.world.body().mass() - 3e-3).abs() < 1e-9, "{}", problem.world.body().mass());
    assert_eq!(problem.points.len(), 10, "the inner corners touch nothing");
    // About z: three cubes of 1 g, 10⁻⁴ m² m/6 each, and their distances.
    let own = 3.0 * 1e-3 * 1e-4 / 6.0;
    let far = |x: f64, y: f64| 1e-6 * ((x - 25.0 / 3.0).powi(2) + (y - 25.0 / 3.0).powi(2));
    let expected = own + 1e-3 * (far(5.0, 5.0) + far(15.0, 5.0) + far(5.0, 15.0));
    let found = problem.world.body().inertia().rows[2].z;
    assert!((found / expected - 1.0).abs() < 1e-6, "{found} {expected}");
}

#[test]
fn a_body_that_falls_flat_loses_all_of_its_motion() {
    // A box let go level: m g h is lost in one strike.
    let problem = parse("box = [0.06, 0.04, 0.025]\nmass = 0.3\nturn = 0\nheight = 0.1\n").unwrap();
    let report = report(&problem);
    let resting = report.resting.unwrap();
    assert_eq!((report.end.state.as_str(), resting.face), ("at rest", Some(1)));
    assert_eq!(resting.normal, Some([0.0, 0.0, -1.0]));
    let weight = 0.3 * 9.81;
    assert!((resting.energy_start - weight * 0.1125).abs() < 1e-14, "{resting:?}");
    assert!((resting.energy_end - weight * 0.0125).abs() < 1e-14, "{resting:?}");
    assert!((report.end.t_s - (2.0_f64 * 0.1 / 9.81).sqrt()).abs() < 1e-14, "{:?}", report.end);
}

#[test]
fn vertices_with_points_within_are_their_hull() {
    let source = "vertices = [[0, 0, 0], [\"10 mm\", 0, 0], [0, \"10 mm\", 0], [\"2 mm\", \"2 mm\", \"2 mm\"], [0, 0, \"1 cm\"]]\nmass = \"20 g\"\n";
    let problem = parse(source).unwrap();
    assert_eq!(problem.points, ["0", "1", "2", "4"], "named as they are written");
    let body = report(&problem).body.unwrap();
    assert_eq!((body.points, body.vertices.len(), body.faces.len()), (5, 4, 4));
    assert!((body.volume_m3 - 1e-6 / 6.0).abs() < 1e-20, "{}", body.volume_m3);
}

/// Every part of a message, in a file that must have so many problems.
fn refused(source: &str, count: usize, parts: &[&str]) {
    held::file(Form::SpatialRoll(SpatialRollKind::Body), source);
    let said = parse(source).err();
    let Some(said) = said else { panic!("nothing is wrong with {source}") };
    let head = format!("{count} problem{} in", if count == 1 { "" } else { "s" });
    assert!(said.starts_with(&head), "{source}\n{said}");
    for part in parts {
        assert!(said.contains(part), "{part}\n{source}\n{said}");
    }
}

#[test]
fn every_problem_of_a_file_is_named_at_once() {
    let many = "vertices = [[0, 0, 0], [1, 0], [\"1 mm\", \"1 mm\", \"2 kg\"], 3]\nmass = -1\ndensity = 3\naxis = [0, 0, 0]\nhight = 3\nheight = \"-1 mm\"\n";
    let parts = [
        "body.toml:1:24: vertices.1: expected three numbers [x, y, z], found 2",
        "vertices.2.z: \"2 kg\"",
        "vertices.3: expected three numbers [x, y, z], found a number",
        "body.toml:2:8: mass: -1 kg must be above 0",
        "density: does not go together with mass",
        "axis: must have a direction",
        "did you mean \"height\"?",
        "height: -1 mm must be 0 or more",
    ];
    refused(many, 8, &parts);
}

#[test]
fn bodies_that_cannot_be_are_refused() {
    refused("vertices = []\n", 1, &["0 different points"]);
    refused("vertices = [[0,0,0],[1,0,0],[0,1,0],[1,1,0],[2,3,0]]\n", 1, &["all points lie on one plane"]);
    refused("vertices = [[0,0,0],[1,0,0],[nan,1,0],[0,0,1]]\n", 1, &["vertices.2.x", "finite"]);
    refused("box = [1, 1, 0]\n", 1, &["box.z: 0 mm must be above 0"]);
    refused("box = [1e-200, 1e-200, 1e-200]\n", 3, &["box.x", "must be at"]);
    refused("box = [1e200, 1e200, 1e200]\n", 3, &["box.x", "must be at"]);
    refused("box = [1, 1, 1]\nvertices = [[0, 0, 0]]\n", 2, &["does not go together with box"]);
    refused(
        "inertia = [1, 1, 3]\n",
        1,
        &[
            "inertia: the sum of its two lesser principal moments less the largest [kg m²] is -1, allowed is >= 0",
        ],
    );
    refused(
        "inertia = [1, 1, 1]\ninertia_products = [2, 0, 0]\n",
        1,
        &["inertia: its least principal moment [kg m²]"],
    );
    refused("inertia_products = [1, 1, 3]\n", 1, &["inertia: missing"]);
    refused("centre = [0, 0, 0.02]\ninertia = [1, 1, 1]\n", 1, &["centre: is 0.007500 m outside the hull"]);
    refused("unit = \"mm\"\n", 1, &["file: missing: unit is that of an STL file"]);
    refused("turn = 0\nheight = 0\nvelocity = [1, 0, 0]\n", 1, &["velocity: would let", "slide along it"]);
    refused("restitution = 0.3\n", 1, &["friction: missing: a friction, beside a restitution"]);
    refused("friction = -0.3\n", 1, &["friction: -0.3 must be 0 or more"]);
    refused("friction = 0.3\nlaw = \"newton\"\n", 1, &["law: \"newton\" is none of poisson, stronge"]);
    let ring = |n: u32, z: &str| {
        let at = |i: u32| f64::from(i) * std::f64::consts::TAU / f64::from(n);
        let place = |i| {
            format!("[{}, {}, {z}]", carom_num::elementary::cos(at(i)), carom_num::elementary::sin(at(i)))
        };
        (0..n).map(place).collect::<Vec<_>>().join(", ")
    };
    let wide = format!("vertices = [{}, {}]\nflatness = 1e-9\n", ring(20, "0"), ring(20, "1"));
    refused(
        &wide,
        1,
        &["2 of its faces have more than 12 corners, up to 20", "fewer sides, at most 12; with friction 95"],
    );
    let coin = format!("vertices = [{}, {}]\nflatness = 1e-9\n", ring(9, "0"), ring(9, "0.2"));
    assert!(parse(&coin).is_ok(), "without friction it is followed");
    assert!(parse(&format!("friction = 0.3\n{coin}")).is_ok(), "and with it");
    assert!(parse(&format!("friction = 0.3\n{wide}")).is_ok(), "with friction it is followed");
    let wider =
        format!("friction = 0.3\nvertices = [{}, {}]\nflatness = 1e-9\n", ring(96, "0"), ring(96, "1"));
    let said = "2 of its faces have more than 95 corners, up to 96: all corners of a face can touch at once";
    refused(&wider, 1, &[said, "with friction at most 95 contacts", "without friction 12"]);
    let mut many: Vec<String> = vec![];
    for i in 0..1100 {
        let z = -0.99 + 0.0018 * f64::from(i);
        let r = (1.0 - z * z).sqrt();
        let angle = 2.4 * f64::from(i);
        let (x, y) = (r * carom_num::elementary::cos(angle), r * carom_num::elementary::sin(angle));
        many.push(format!("[{x}, {y}, {z}]"));
    }
    refused(&format!("vertices = [{}]\n", many.join(", ")), 1, &["its hull has 1100 vertices: at most 1024"]);
}

/// A bolt whose head is a hexagon and whose shank has twelve sides, as it is shipped.
#[test]
fn the_bolt_of_the_examples_may_have_friction() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/roll_body_bolt.toml");
    let text = fs::read_to_string(file).unwrap();
    let read = |set: &[String]| {
        SpatialRollProblem::parse(SpatialRollKind::Body, file, &text, set).map_err(|e| e.to_string())
    };
    assert!(read(&[]).is_ok(), "without friction it is followed");
    let rough = read(&["friction=0.3".to_owned(), "restitution=0.3".to_owned()]).unwrap();
    let end = report(&rough).end;
    assert_eq!(end.state, "at rest", "{}", end.words);
}

/// A coin of sixteen sides slides, spins and comes to rest on the whole of its face, which is all of its sixteen corners at once.
#[test]
fn a_coin_of_sixteen_sides_comes_to_rest_on_its_face() {
    let ring = |z: &str| {
        let at = |i: i32| f64::from(i) * std::f64::consts::TAU / 16.0;
        let place = |i: i32| {
            format!("[{}, {}, {z}]", carom_num::elementary::cos(at(i)), carom_num::elementary::sin(at(i)))
        };
        (0..16).map(place).collect::<Vec<_>>().join(", ")
    };
    let moved = "velocity = [0.2, 0.1, 0]\nspin = [0, 0, 2]\nheight = 0.2\n";
    let text = format!(
        "vertices = [{}, {}]\nflatness = 1e-9\nfriction = 0.3\nrestitution = 0\n{moved}",
        ring("0"),
        ring("0.6")
    );
    let run = report(&parse(&text).unwrap());
    // It falls flat, and slides until friction has stopped its turn and its drift.
    assert!(run.stages.iter().any(|stage| stage.name == "slide"), "it slides first");
    let all = (0..15).map(|i| i.to_string()).collect::<Vec<_>>().join(", ");
    assert_eq!(run.end.words, format!("it slid to rest on {all} and 15"));
}

/// A surface all of whose facets run clockwise encloses the same, and one with a facet that has no length is closed.
#[test]
fn surfaces_turned_inside_out_or_with_facets_without_length_are_read() {
    let whole = brick(Vec3::ZERO, Vec3::ZERO);
    let solid = |name: &str, change: &dyn Fn(&mut Mesh)| {
        let mut mesh = whole.clone();
        change(&mut mesh);
        binary(name, &mesh);
        parse(&format!("file = \"{name}\"\n")).unwrap().thrown.unwrap().shape.solid
    };
    let own = solid("own.stl", &|_| ());
    let moments = |solid: &Solid| [0, 1, 2].map(|axis| solid.inertia.rows[axis].to_array()[axis]);
    let alike = |name: &str, other: &Solid| {
        let apart = |a: f64, b: f64| (a / b - 1.0).abs();
        let worst = moments(other).into_iter().zip(moments(&own)).map(|(a, b)| apart(a, b));
        let worst = worst.fold(apart(other.volume, own.volume), f64::max);
        // The sums of a dozen facets, in another order.
        assert!(worst < 1e-14, "{name}: {worst:e}");
    };
    alike("inside", &solid("inside.stl", &|mesh| mesh.facets.iter_mut().for_each(|f| f.swap(0, 1))));
    alike("sliver", &solid("sliver.stl", &|mesh| mesh.facets.insert(4, [0, 1, 1])));
}

#[test]
fn surfaces_that_enclose_nothing_are_refused() {
    let whole = brick(Vec3::ZERO, Vec3::ZERO);
    let write = |name: &str, change: &dyn Fn(&mut Mesh)| {
        let mut mesh = whole.clone();
        change(&mut mesh);
        binary(name, &mesh);
    };
    write("open.stl", &|mesh| mesh.facets.truncate(11));
    refused(
        "file = \"open.stl\"\n",
        3,
        &["open.stl: the surface is open at facet", "no other facet is beside"],
    );
    write("flipped.stl", &|mesh| mesh.facets[5].swap(0, 1));
    refused("file = \"flipped.stl\"\n", 1, &["flipped.stl: facet 5 is turned round"]);
    write("flat.stl", &|mesh| mesh.vertices.iter_mut().for_each(|r| r.z = 0.0));
    refused("file = \"flat.stl\"\n", 1, &["flat.stl: all points lie on one plane"]);
    write("lost.stl", &|mesh| mesh.vertices[3].y = f64::NAN);
    refused("file = \"lost.stl\"\n", 1, &["is not at a finite place"]);
    refused("file = \"none.stl\"\nunit = \"kg\"\n", 2, &["there is no such file", "\"kg\" is none of m, mm"]);
    fs::write(place("no.stl"), "this is no surface").unwrap();
    refused("file = \"no.stl\"\n", 1, &["no.stl: it ends within a facet, or is no STL file"]);
    write("twice.stl", &|mesh| mesh.facets.extend(mesh.facets.clone()));
    refused("file = \"twice.stl\"\n", 1, &["it cuts itself, or has a facet twice"]);
}

#[test]
fn bodies_that_are_far_longer_than_wide_are_refused() {
    // Of a box a by a by L the moments are as 2 a² to a² + L²: radii of gyration as √((1 + (L/a)²)/2), 990 for 1400 and 1061 for 1500.
    assert!(parse("box = [0.01, 0.01, 14]").is_ok(), "990 to 1");
    refused("box = [0.01, 0.01, 15]", 1, &["as 1060 to 1", "up to 1000 to 1"]);
    assert!(parse("box = [1, 1, 0.001]").is_ok(), "a sheet is not slender: its radii are as √2 to 1");
    // A vertex at a kilometre beside 10 mm: a unit that was left out.
    let slip =
        "vertices = [[0.01, 0.01, 0.01], [1000, -0.01, -0.01], [-0.01, 0.01, -0.01], [-0.01, -0.01, 0.01]]";
    refused(slip, 1, &["radii of gyration", "in one unit"]);
    // Masses elsewhere than in the shape count as well: these moments are as 4 × 10⁶ to 1.
    refused("box = [0.1, 0.1, 0.1]\nmass = 1\ninertia = [4, 4, 1e-6]", 1, &["as 2000 to 1"]);
}

/// A die with round edges weighs what is left of it, stands on the plane parts of its faces, and comes to rest on one.
#[test]
fn a_die_with_round_edges_rolls_to_rest() {
    let die = "box = ['16 mm', '16 mm', '16 mm']\ncorner_radius = '2 mm'\ndensity = '1200 kg/m^3'\nfriction = 0.3\n";
    let problem =
        parse(&format!("{die}restitution = 0.3\nheight = '60 mm'\nvelocity = ['0.5 m/s', 0, 0]")).unwrap();
    let body = problem.world.body();
    let (edge, radius) = (0.012_f64, 0.002_f64);
    let round = std::f64::consts::PI * radius * radius * (3.0 * edge + 4.0 / 3.0 * radius);
    let volume = edge.powi(3) + 6.0 * edge * edge * radius + round;
    assert!((body.mass() / (1200.0 * volume) - 1.0).abs() < 1e-14, "{}", body.mass());
    let thrown = problem.thrown.as_ref().unwrap();
    assert!(
        thrown.stances.iter().all(|s| (s.height - 0.008).abs() < 1e-15 && (s.margin - 0.006).abs() < 1e-15)
    );
    let lowest = problem.start.centre.z + body.lowest(problem.start.attitude);
    assert!((lowest - 0.06).abs() < 1e-15, "{lowest}");
    let report = report(&problem);
    assert_eq!((report.end.state.to_string().as_str(), report.end.words.contains("rest")), ("at rest", true));
    assert!(report.resting.as_ref().unwrap().face.is_some(), "{:?}", report.resting);
    assert!((report.tilt.tilt_rad.last().unwrap()).abs() < 1e-9, "{:?}", report.tilt.tilt_rad.last());
    assert_eq!(report.body.as_ref().unwrap().corner_radius_m, Some(0.002));
}

#[test]
fn what_cannot_be_rounded_is_told() {
    let told = |source: &str| parse(source).unwrap_err();
    let large = told("box = ['16 mm', '16 mm', '16 mm']\ncorner_radius = '8 mm'\nfriction = 0.3");
    assert!(
        large.contains("corner_radius: is too large: nothing of the face 0, 1, 5, 4 would stay plane"),
        "{large}"
    );
    let frictionless = told("corner_radius = '1 mm'");
    assert!(frictionless.contains("a friction, beside a corner_radius"), "{frictionless}");
    let pyramid =
        "vertices = [[0, 0, 0.1], [0.1, 0.1, 0], [-0.1, 0.1, 0], [-0.1, -0.1, 0], [0.1, -0.1, 0]]\n";
    let four = told(&format!("{pyramid}corner_radius = '1 mm'\nfriction = 0.3"));
    assert!(four.contains("at point 0 there are 4"), "{four}");
}
