//! The page of a run in space is whole in itself, names what there is, and says what limits its verdict.

use carom_feeder::spatial::{Feeder, Run, Wall, WallForm, examples};
use carom_figure::{SpaceFigure, SpaceRow, Wish, space_report, space_rows};
use carom_words::{Words, part};

fn figure<'a>(feeder: &'a Feeder, run: &'a Run) -> SpaceFigure<'a> {
    SpaceFigure {
        title: "a <feeder>",
        feeder,
        run,
        wanted: &[],
        margins: &[],
        limits: &[],
        approximations: &[],
        notes: &[],
        source: "",
        made_by: "test",
    }
}

fn page(feeder: &Feeder) -> String {
    let run = feeder.run().unwrap();
    space_report(&figure(feeder, &run))
}

/// The numbers of the player.
fn numbers(page: &str) -> &str {
    let (_, after) = page.split_once("id=\"solid-numbers\">").expect("the player has numbers");
    after.split_once("</script>").expect("they end").0
}

#[test]
fn the_page_is_whole_in_itself_and_names_every_plate_and_every_stage() {
    let mut feeder = examples::two_plates();
    feeder.plates[0].name = "</script><b>".to_owned();
    feeder.walls = vec![Wall {
        name: "front & back".to_owned(),
        form: WallForm::Beside { z: 0.03 },
        friction: 0.0,
        restitution: 0.0,
    }];
    let run = feeder.run().unwrap();
    let page = space_report(&figure(&feeder, &run));
    assert!(!page.contains("http"), "nothing from the network");
    assert_eq!(page.matches("</script>").count(), 2, "the numbers and the player");
    for name in ["a &lt;feeder&gt;", "&lt;/script&gt;&lt;b&gt;", "lower", "front &amp; back"] {
        assert!(page.contains(name), "{name}");
    }
    for stage in &run.stages {
        assert!(page.contains(&format!("</i>{}</th>", stage.name.word())), "{:?}", stage.name);
    }
    let strikes = space_rows(&run).iter().filter(|row| matches!(row, SpaceRow::Strike(..))).count();
    assert!(strikes > 0, "there is something to tell");
    assert_eq!(page.matches("<tr class=\"stage strike\"").count(), strikes, "a row each");
}

#[test]
fn every_strike_is_told_with_its_contacts_and_their_impulses() {
    let feeder = examples::two_plates();
    let run = feeder.run().unwrap();
    let page = space_report(&figure(&feeder, &run));
    for (k, impact) in run.impacts.iter().enumerate().take(12) {
        let (_, told) = page.split_once(&format!("id=\"strike-{}\"", k + 1)).expect("it is told");
        let told = told.split_once("</article>").unwrap().0;
        let rows = told.matches("<th scope=\"row\">").count();
        assert_eq!(rows, impact.impulses.len(), "strike {}: {told}", k + 1);
        assert!(told.contains(&part::obstacle(&feeder, run.struck[k])), "on what: {told}");
    }
}

#[test]
fn the_numbers_of_the_player_are_numbers() {
    let mut feeder = examples::two_plates();
    feeder.plates[1].width = Some(0.08);
    feeder.plates[1].cross_section = carom_feeder::spatial::CrossSection::Walled { height: 0.02 };
    let page = page(&feeder);
    let numbers = numbers(&page);
    for word in ["NaN", "inf", "null", "Vec3", "Some"] {
        assert!(!numbers.contains(word), "{word}");
    }
    let (_, plates) = numbers.split_once("\"plates\":").expect("there are plates");
    assert!(plates.contains("[\"upper\",") && plates.contains("[\"lower\","), "{plates}");
    assert_eq!(plates.matches("[\"\",").count(), 2, "the walls along its sides: {plates}");
    assert!(plates.contains("true"), "what is as wide as needed is cut: {plates}");
}

/// Two sides, and four facets along each of four edges, of which one has the name.
#[test]
fn a_sheet_with_round_edges_is_drawn_as_thick_as_it_is() {
    let mut feeder = examples::two_plates();
    feeder.plates[1].width = Some(0.08);
    feeder.plates[1].edge_radius = 0.003;
    let polygons = feeder.plates[1].polygons(feeder.part.body.reach());
    assert_eq!(polygons.len(), 2 + 4 * 4);
    let down = feeder.plates[1].edge - feeder.plates[1].uphill;
    let up = carom_num::Vec3::new(-down.y, down.x, 0.0).unit().unwrap();
    let up = if up.y > 0.0 { up } else { -up };
    let ends = feeder.plates[1].uphill;
    let low =
        polygons.iter().flatten().map(|corner| up.dot(*corner - carom_num::Vec3::new(ends.x, ends.y, 0.0)));
    let [low, high] = low.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
    assert!(high.abs() < 1e-15 && (low + 0.006).abs() < 1e-15, "{low} {high}");
    let page = page(&feeder);
    let (_, plates) = numbers(&page).split_once("\"plates\":").expect("there are plates");
    assert!(plates.matches("[\"\",").count() > 12, "its facets: {plates}");
}

#[test]
fn what_limits_the_verdict_stands_below_it() {
    let feeder = examples::two_plates();
    let run = Run { forks: 1, ..feeder.run().unwrap() };
    let (approximations, notes) = (["the part is a hull".to_owned()], ["friction is assumed".to_owned()]);
    let wanted = [Wish { plate: "lower".to_owned(), want: "same".to_owned(), met: false }];
    let (approximations, notes, wanted) = (&approximations[..], &notes[..], &wanted[..]);
    let page = space_report(&SpaceFigure { approximations, notes, wanted, ..figure(&feeder, &run) });
    let (verdict, _) = page.split_once("<section id=\"motion\"").expect("the animation follows");
    let told = [
        "The part is a hull.",
        "Friction is assumed.",
        "has several consistent outcomes",
        "Not as wanted: same on “lower”.",
    ];
    for words in told {
        assert!(verdict.contains(words), "{words}");
    }
}

#[test]
fn the_faces_are_listed_with_how_the_part_stands_on_them() {
    let feeder = examples::two_plates();
    let run = feeder.run().unwrap();
    let margins = [0.01, -0.001];
    let page = space_report(&SpaceFigure { margins: &margins, ..figure(&feeder, &run) });
    let (_, faces) = page.split_once("id=\"faces\"").expect("there is a table");
    assert!(faces.contains("face 0</th>") && faces.contains("face 5</th>"), "all of them");
    assert!(faces.contains("<td>5.000</td><td>10.000</td><td>yes</td>"), "it lies on its wide face");
    assert!(faces.contains("at the start"), "it was down then");
    assert!(faces.contains("<td>−1.000</td><td>no</td>"), "where the mass centre is beside it");
}

#[test]
fn a_part_that_misses_is_shown_until_it_is_past_the_plates() {
    let mut feeder = examples::two_plates();
    let lower = &mut feeder.plates[1];
    lower.uphill.x -= 0.6;
    lower.edge.x -= 0.6;
    let run = feeder.run().unwrap();
    let page = space_report(&figure(&feeder, &run));
    assert!(page.contains("<strong>Missed</strong>"), "{:?}", run.outcome);
    assert!(
        page.contains("It fell past the last plate.") && page.contains("the picture ends there"),
        "why, and until when"
    );
}

#[test]
fn a_part_that_stays_where_it_is_has_a_picture() {
    let mut feeder = examples::two_plates();
    feeder.plates[0].friction = 0.8;
    let page = page(&feeder);
    assert!(
        page.contains("<strong>Stuck</strong>") && page.contains("id=\"solid\""),
        "one that can be turned"
    );
    assert!(page.contains("Nothing was struck."), "and no strikes");
}

/// The rows of an accessor of a `.glb` file.
fn rows(tree: &serde_json::Value, binary: &[u8], accessor: &serde_json::Value) -> Vec<Vec<f32>> {
    let whole = |value: &serde_json::Value| value.as_u64().unwrap() as usize;
    let accessor = &tree["accessors"][whole(accessor)];
    let view = &tree["bufferViews"][whole(&accessor["bufferView"])];
    let (from, length) = (whole(&view["byteOffset"]), whole(&view["byteLength"]));
    let numbers =
        binary[from..from + length].chunks(4).map(|four| f32::from_le_bytes(four.try_into().unwrap()));
    let wide = length / 4 / whole(&accessor["count"]);
    numbers.collect::<Vec<_>>().chunks(wide).map(<[f32]>::to_vec).collect()
}

#[test]
fn a_model_moves_as_the_part_does() {
    let feeder = examples::two_plates();
    let run = feeder.run().unwrap();
    let file = carom_figure::space_glb(&feeder, &run);
    let length = u32::from_le_bytes(file[12..16].try_into().unwrap()) as usize;
    let tree: serde_json::Value = serde_json::from_slice(&file[20..20 + length]).unwrap();
    let binary = &file[28 + length..];
    let sampler = |k: usize| &tree["animations"][0]["samplers"][k];
    let times = rows(&tree, binary, &sampler(0)["input"]);
    assert!(times.windows(2).all(|pair| pair[0][0] < pair[1][0]), "times rise");
    assert!((f64::from(times[times.len() - 1][0]) - run.end_time).abs() < 1e-6);
    let [places, turns] = [0, 1].map(|k| rows(&tree, binary, &sampler(k)["output"]));
    // The last node has y upwards again: (x, y, z) of the animation is (x, −z, y) of the drawing.
    let place = &places[places.len() - 1];
    let centre = [place[0], place[2], -place[1]].map(f64::from);
    let off = centre.iter().zip(run.end.centre.to_array()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-6, "{off} m");
    assert!(turns.iter().all(|turn| (turn.iter().map(|x| x * x).sum::<f32>() - 1.0).abs() < 1e-5));
    // Every corner of the part is a vertex of its mesh.
    let meshes = tree["meshes"][0]["primitives"].as_array().unwrap();
    let vertices: Vec<Vec<f32>> =
        meshes.iter().flat_map(|piece| rows(&tree, binary, &piece["attributes"]["POSITION"])).collect();
    for corner in feeder.part.body.supports() {
        let at = corner.to_array();
        let near = |v: &Vec<f32>| v.iter().zip(at).all(|(a, b)| (f64::from(*a) - b).abs() < 1e-6);
        assert!(vertices.iter().any(near), "{corner:?}");
    }
}
