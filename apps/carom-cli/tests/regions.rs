//! Region diagrams as a user meets them: what is printed, what is written, and what is refused.

use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a boundary is located to, as a share of the axes.
const ACCURACY: f64 = 1e-9;

/// A diagram that is computed: its JSON, its SVG and its CSV.
struct Diagram {
    summary: Value,
    svg: String,
    csv: String,
}

fn example(name: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name).display().to_string()
}

fn carom(words: &[&str], out: &Path) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_carom"));
    let output = command.arg("regions").args(words).arg("--out").arg(out).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

fn diagram(test: &str, slug: &str, words: &[&str]) -> Diagram {
    let out: PathBuf = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    let (code, said, errors) = carom(&[words, &["--format", "json"]].concat(), &out);
    assert_eq!((code, errors.as_str()), (0, ""), "{words:?}");
    let read = |name: &str| fs::read_to_string(out.join(slug).join(name)).unwrap();
    assert_eq!(said.trim(), read("regions.json").trim(), "the same on stdout and in the file");
    let png = fs::read(out.join(slug).join("regions.png")).unwrap();
    assert_eq!(&png[1..4], b"PNG", "the drawing in pixels, beside the SVG");
    Diagram {
        summary: serde_json::from_str(&said).unwrap(),
        svg: read("regions.svg"),
        csv: read("regions.csv"),
    }
}

/// Every closed form that has a boundary is met, from both sides; returns the states of those that do.
fn assert_closed_forms(summary: &Value) -> Vec<[u64; 2]> {
    let mut met = vec![];
    assert_eq!(summary["points_without_closed_form"], 0, "{summary:#}");
    for curve in summary["closed_forms"].as_array().unwrap() {
        assert_eq!(curve["curve_points"], curve["curve_points_confirmed"], "{curve}");
        if curve["boundary_points"].as_u64().unwrap() > 0 {
            let largest = curve["largest_distance_share"].as_f64().unwrap();
            assert!(largest <= ACCURACY, "{curve}");
            met.push([0, 1].map(|k| curve["states"][k].as_u64().unwrap()));
        }
    }
    met
}

#[test]
fn the_cylinders_figure_is_met_by_its_closed_forms() {
    let ring = diagram("regions_ring", "regions-cylinder", &["cylinder"]);
    assert_eq!(assert_closed_forms(&ring.summary), [[1, 2], [2, 3], [3, 4]], "a ring");
    assert_eq!(ring.summary["junctions"], serde_json::json!([]), "three curves that never meet");
    for (b, friction, gamma) in [(0.5, 3f64.sqrt().recip(), 60.0), (0.4, 0.4 / 0.84f64.sqrt(), 56.789_089_2)]
    {
        let words = ["cylinder", "--set", &format!("inertia_ratio={b}")];
        let disc = diagram(&format!("regions_disc_{b}"), "regions-cylinder", &words);
        assert_eq!(assert_closed_forms(&disc.summary), [[1, 2], [2, 3], [3, 4], [1, 4]], "b = {b}");
        let point = &disc.summary["junctions"][0];
        let off = (point["x"].as_f64().unwrap() - friction).abs() / 1.5;
        // The angle is given to 7 decimals of a degree.
        let turned = (point["y"].as_f64().unwrap() - gamma).abs() / 88.0;
        assert!(off <= ACCURACY && turned <= 2.0 * ACCURACY, "b = {b}: {point}");
        // Beyond f* nothing but 1|4 is left.
        for line in disc.csv.lines().skip(1) {
            let cells: Vec<&str> = line.split(',').collect();
            let beyond = cells[0].parse::<f64>().unwrap() > friction + 1e-6;
            assert!(!beyond || cells[2..4] == ["1", "4"], "b = {b}: {line}");
        }
        assert!(disc.svg.contains("class=\"junction\"") && disc.svg.contains("[deg]"), "drawn, in degrees");
    }
}

#[test]
fn prism_and_rod_are_met_by_their_closed_forms() {
    let prism = diagram("regions_prism", "regions-prism", &["prism"]);
    assert_eq!(assert_closed_forms(&prism.summary).len(), 4, "four borders");
    let shape = ["prism", "--x", "height=100..600 mm:40", "--y", "friction=0..2:40"];
    let shape = diagram("regions_shape", "regions-prism", &shape);
    assert!(assert_closed_forms(&shape.summary).len() >= 3, "friction against shape");
    let rod = diagram("regions_rod", "regions-rod", &["rod"]);
    assert_eq!(assert_closed_forms(&rod.summary), [[1, 2]], "12ab = l²");
}

#[test]
fn a_whole_impact_keeps_the_borders_of_its_compression() {
    let prism = diagram("regions_elastic", "regions-prism", &["prism", "--elastic", "0.5"]);
    assert_eq!(assert_closed_forms(&prism.summary).len(), 4, "every phase-1 impulse is scaled");
    let words: Vec<&Value> =
        prism.summary["labels"].as_array().unwrap().iter().map(|label| &label["words"]).collect();
    let says = |part: &str| words.iter().all(|words| words.as_str().unwrap().contains(part));
    assert!(says("turns back"), "{words:?}");
    assert!(says("K rebounds"), "what returned half of its impulse has left the plane: {words:?}");
}

#[test]
fn without_restitution_a_whole_impact_has_the_plastic_borders_and_no_more() {
    for words in [&["prism"][..], &["rod"], &["cylinder", "--set", "inertia_ratio=0.5"]] {
        let slug = format!("regions-{}", words[0]);
        let plastic = diagram(&format!("plain_{}", words[0]), &slug, words);
        let whole = diagram(&format!("zero_{}", words[0]), &slug, &[words, &["--elastic", "0"]].concat());
        let count = |diagram: &Diagram, key: &str| diagram.summary[key].as_array().unwrap().len();
        for key in ["labels", "boundaries", "junctions"] {
            assert_eq!(count(&whole, key), count(&plastic, key), "{words:?}: {key}");
        }
    }
}

/// A cylinder may roll over K or wedge, as far as the end alone says; the walk has one way on all the same, so that labels do not flip.
#[test]
fn several_end_states_are_counted_and_labels_stay_single() {
    let words = ["cylinder", "--set", "inertia_ratio=0.5", "--x", "friction=0.5..0.7:50", "--y"];
    let axes = ["gamma=55..65 deg:41"];
    let plastic = diagram("ends_plastic", "regions-cylinder", &[&words[..], &axes].concat());
    let elastic = ["--elastic", "0.5"];
    let whole = diagram("ends_whole", "regions-cylinder", &[&words[..], &axes, &elastic].concat());
    let shares = |diagram: &Diagram| {
        let ends = &diagram.summary["ends"];
        ["several_share", "not_reached_share", "branching_share"].map(|key| ends[key].as_f64().unwrap())
    };
    let ([several, missed, branching], [also, depends, chose]) = (shares(&plastic), shares(&whole));
    assert!(several > 0.1 && (several, missed, branching) == (several, 0.0, 0.0), "{several} {missed}");
    assert!(also > 0.1 && depends > 0.01 && chose == 0.0, "{also} {depends} {chose}");
    for label in whole.summary["labels"].as_array().unwrap() {
        assert!(label["area_share"].as_f64().unwrap() > 0.0, "an outcome at equality: {label}");
    }
    let file = example("impact_row.toml");
    let row = ["--file", &file, "--x", "body.0.velocity.x=0.1..1:4", "--y", "contact.0.friction=0..1:4"];
    let row = diagram("ends_row", "regions-impact_row", &row);
    assert_eq!(row.summary["ends"], Value::Null, "seven contacts are not examined");
    assert_eq!(row.summary["labels"][0]["label"], "ossssss", "the first ball flies back");
}

#[test]
fn painleves_curve_is_where_the_motions_of_a_sliding_rod_change() {
    let falls = diagram("regions_contact", "regions-contact", &["contact", "--depth", "1"]);
    assert_eq!(assert_closed_forms(&falls.summary), [[1, 0]], "one motion outside the curve, none inside");
    // With ω² = 1.5 g/ℓ the spin throws the end off where sin θ > 2/3: all four borders.
    let turns =
        ["contact", "--depth", "1", "--set", "spin_ratio=1.224744871391589", "--y", "friction=0..4:75"];
    let turns = diagram("regions_contact_turning", "regions-contact", &turns);
    assert_eq!(assert_closed_forms(&turns.summary), [[1, 0], [2, 3], [1, 2], [0, 3]], "each is met");
}

#[test]
fn a_diagram_of_a_file_obeys_its_convention_on_sharing() {
    // A row of three balls whose contacts return .9 and .3: as springs both separate, together they do not.
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("regions_sharing");
    fs::create_dir_all(&out).unwrap();
    let cradle = fs::read_to_string(example("impact_cradle.toml")).unwrap();
    let cradle = cradle.replacen("restitution = 1", "restitution = 0.9", 1);
    let cradle = cradle.replacen("restitution = 1", "restitution = 0.3", 1);
    for (sharing, label) in [("by stiffness", "oo"), ("in sequence", "oo"), ("together", "os")] {
        let file = out.join("cradle.toml");
        let asked = format!("sharing = \"{sharing}\"");
        fs::write(&file, cradle.replacen("sharing = \"by stiffness\"", &asked, 1)).unwrap();
        let axes = ["--x", "contact.0.restitution=0.88..0.92:3", "--y", "contact.1.restitution=0.28..0.32:3"];
        let file = file.display().to_string();
        let around = diagram("regions_sharing", "regions-cradle", &[&["--file", &file][..], &axes].concat());
        let impact = Command::new(env!("CARGO_BIN_EXE_carom"))
            .args(["impact", &file, "--format", "json"])
            .output()
            .unwrap();
        let impact: Value = serde_json::from_slice(&impact.stdout).unwrap();
        let states = impact["staged"]["contacts"].as_array().unwrap().iter();
        let states: String = states.map(|c| if c["state"] == "separates" { 'o' } else { 's' }).collect();
        let labels = around.summary["labels"].as_array().unwrap();
        assert_eq!((labels.len(), &labels[0]["label"]), (1, &states.as_str().into()), "{sharing}");
        assert_eq!(states, label, "{sharing}");
    }
}

#[test]
fn any_two_numbers_of_an_impact_file_are_axes() {
    let file = example("impact_bar.toml");
    let axes = ["--x", "body.spin=-10..10:40", "--y", "contact.0.friction=0..1:30"];
    let bar = diagram("regions_file", "regions-impact_bar", &[&["--file", &file][..], &axes].concat());
    let labels: Vec<&str> = bar.summary["labels"]
        .as_array()
        .unwrap()
        .iter()
        .map(|label| label["label"].as_str().unwrap())
        .collect();
    assert_eq!(labels, ["7s", "1+"], "with enough friction it sticks");
    // It sticks where P_d = P_q: μ (W_tt |u_n| + W_tn u_t) = W_nn u_t − W_tn |u_n|, by the operator of one contact.
    let (m, j, x, y) = (0.3, 2.5e-4, 0.0266, -0.0423);
    let (tt, nn, tn) = (1.0 / m + y * y / j, 1.0 / m + x * x / j, -x * y / j);
    for line in bar.csv.lines().skip(1) {
        let cells: Vec<f64> = line.split(',').take(2).map(|cell| cell.parse().unwrap()).collect();
        let (spin, friction) = (cells[0], cells[1]);
        let (slip, approach) = (0.558 - y * spin, 1.852 - x * spin);
        let exact = (nn * slip + tn * approach) / (tt * approach + tn * slip);
        assert!((friction - exact).abs() <= 2.0 * ACCURACY, "spin {spin}: {friction}, exactly {exact}");
    }
}

#[test]
fn the_strike_map_says_how_often_the_printed_rule_is_right() {
    let strike = diagram("regions_strike", "regions-strike", &["strike"]);
    let remark = strike.summary["remarks"][0].as_str().unwrap();
    assert!(remark.contains("names the type on"), "{remark}");
    // Without restitution and with slip there are the types 1, 5 and 7 only.
    for label in strike.summary["labels"].as_array().unwrap() {
        let label = label["label"].as_str().unwrap();
        assert!(["1−", "1+", "5−", "5+", "7−", "7+"].contains(&label), "{label}");
    }
}

#[test]
fn every_bad_option_is_named_at_once() {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("regions_bad");
    let words =
        ["cylinder", "--set", "foo=1", "--set", "friction=-3", "--x", "gamma=2..1 deg:5", "--elastic", "2"];
    let (code, said, errors) = carom(&words, &out);
    assert_eq!((code, said.as_str()), (2, ""), "{errors}");
    for what in
        ["4 problems", "friction, gamma, inertia_ratio", "-3 is below 0", "--x gamma=2..1 deg:5", "--elastic"]
    {
        assert!(errors.contains(what), "{what}: {errors}");
    }
    let file = example("impact_bar.toml");
    let (code, _, errors) = carom(&["--file", &file, "--x", "body.mass=-1..2:9"], &out);
    assert!(code == 2 && errors.contains("--y: missing") && errors.contains("body.velocity.x"), "{errors}");
    let axes = ["--x", "body.mass=-1..2:9", "--y", "contact.0.friction=0..1:9"];
    let (code, _, errors) = carom(&[&["--file", &file][..], &axes].concat(), &out);
    assert!(code == 2 && errors.contains("body.mass: -1 kg must be above 0"), "{errors}");
    let (code, _, errors) = carom(&["--file", "nowhere.toml"], &out);
    assert!(code == 2 && errors.contains("there is no such file"), "{errors}");
}
