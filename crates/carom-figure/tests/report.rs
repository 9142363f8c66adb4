//! The report says what happened, is whole in itself and never shows NaN.

use crate::fixture;

use carom_feeder::{Outcome, Part, PartKind, Plate, StageEnd, Verdict, Wall};
use carom_figure::{
    Draft, Extra, ImpulsePlane, ImpulsePoint, QuantityLimit, impulse_svg, impulse_text, layout_svg, report,
    senses, trace_csv,
};
use carom_impact::Phase;
use carom_motion::planar::{Body, Feature, Obstacle, Pose, Shape};
use carom_num::Vec2;
use carom_words::part;

/// Where the pictures of a test run go, to be looked at.
fn keep(name: &str, text: &str) {
    std::fs::write(std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name), text)
        .expect("the folder is there");
}

fn extra() -> Extra {
    let limit = |quantity: &str, unit: &str, low, value, high| QuantityLimit {
        quantity: quantity.into(),
        unit: unit.into(),
        value,
        low,
        high,
        ..QuantityLimit::default()
    };
    Extra {
        made_by: "carom 0.1.0".into(),
        scene: Some("[part]\nshape = \"rod\"\nlength = \"100 mm\"\n".into()),
        limits: vec![
            limit("contact.friction", "", Some(0.055), 0.15, Some(0.176)),
            limit("plate.lower.slope", "°", Some(21.3), 25.0, None),
        ],
        wanted: vec![],
        notes: vec![],
        draft: Draft::default(),
    }
}

/// Tags that must be closed, each as often as it is opened.
fn assert_balanced(html: &str) {
    for tag in [
        "svg", "section", "table", "tbody", "tr", "td", "th", "g", "text", "tspan", "figure", "div",
        "article", "dl",
    ] {
        let open = html.matches(&format!("<{tag} ")).count() + html.matches(&format!("<{tag}>")).count();
        let closed = html.matches(&format!("</{tag}>")).count();
        assert_eq!(open, closed, "<{tag}> opened {open} times, closed {closed} times");
    }
}

fn assert_clean(html: &str) {
    assert!(!html.contains("NaN"), "a NaN is shown");
    for part in html.split(['"', '>', '<', ' ', ',']) {
        assert!(!matches!(part, "inf" | "-inf" | "−inf"), "an infinity is shown");
    }
}

#[test]
fn a_turned_part_is_reported_whole() {
    let (feeder, run) = fixture::turned();
    let html = report(&feeder, &run, "Paper, case 2", &extra());
    keep("report.html", &html);
    assert_balanced(&html);
    assert_clean(&html);
    for network in ["http://", "https://", "src=", "@import", "url("] {
        let found = html.replace("http://www.w3.org/2000/svg", "");
        assert!(!found.contains(network), "{network} reaches outside");
    }
    for words in [
        "<strong>Turned</strong> on “lower”",
        "1.193 s",
        "Type 1, slides throughout",
        "The strike raised the spin from +7.62 to +31.9 1/s and kept its sign: the part turns on and lies down turned over, 48.4 ms and one more strike later.",
        "Holding the struck contact would need N = −6.27 N, so the part lifts off at once; flight follows for 35.9 ms",
        "−54 %",
        "10.0 → 35.1",
        "0.591 → 1.93",
        "the part lies flat, turned over",
        // After the last strike 14.58 mJ are left, not the 79 mJ before it.
        "sliding friction 72.6 mJ, and 14.6 mJ are left as motion",
    ] {
        assert!(html.contains(words), "missing: {words}");
    }
}

#[test]
fn a_reversed_spin_explains_the_same_side() {
    let (feeder, mut run) = fixture::turned();
    run.trace.impacts[0].after.spin = 10.786;
    run.trace.impacts[0].holding_would_need = None;
    run.landings[0].verdict = Some(Verdict::Same);
    run.landings[0].turned_here = Some(false);
    let html = report(&feeder, &run, "same", &Extra::default());
    let why = "The strike reversed the spin from +7.62 to −10.8 1/s: the part swings back and lies down on the same side";
    assert!(html.contains(why), "the reason");
    assert!(html.contains("<strong>Same side</strong> on “lower”"), "the headline");
}

#[test]
fn whole_turns_of_the_starting_angle_do_not_show() {
    let (feeder, mut run) = fixture::turned();
    for stage in &mut run.stages {
        stage.start.pose.angle += 4.0 * core::f64::consts::PI;
        stage.end.pose.angle += 4.0 * core::f64::consts::PI;
    }
    assert!(report(&feeder, &run, "turns", &Extra::default()).contains("10.0 → 35.1"), "the tilt of the tip");
}

#[test]
fn forward_is_the_way_the_part_tips_on_either_side() {
    let right = fixture::feeder();
    let mut left = right.clone();
    let mirrored = |p: Vec2| Vec2::new(-p.x, p.y);
    for plate in &mut left.plates {
        (plate.uphill, plate.edge) = (mirrored(plate.uphill), mirrored(plate.edge));
    }
    assert_eq!((senses::forward_sense(&right), senses::forward_sense(&left)), (-1.0, 1.0), "senses");
    for (feeder, sense) in [(&right, -1.0), (&left, 1.0)] {
        let start = feeder.start_state().pose;
        let tilt = senses::tilt(feeder, start).to_degrees();
        assert!((tilt - 10.0).abs() < 1e-12, "a part on a plate of 10° is tilted by 10°, not {tilt}");
        let tipped = Pose { angle: start.angle + sense * 0.1, ..start };
        let more = senses::tilt(feeder, tipped) - senses::tilt(feeder, start);
        assert!((more - 0.1).abs() < 1e-15, "tipping forward adds: {more}");
        // Vertex 1 is ahead where the plate descends to the right, vertex 0 where to the left.
        let ahead = if sense < 0.0 { 1 } else { 0 };
        let touches = Feature::VertexOnFace { vertex: ahead, face: Obstacle::LEFT };
        assert_eq!(part::feature(feeder, touches), "front", "the end ahead");
    }
}

#[test]
fn every_stage_has_the_plots_of_the_paper() {
    let (feeder, run) = fixture::turned();
    let html = report(&feeder, &run, "plots", &Extra::default());
    let titles = [
        ("Normal force in stage slide", 1),
        ("Speed along the plate in stage slide", 1),
        ("Normal force in stage tip", 1),
        ("Spin in stage tip", 1),
        ("Velocity of the mass centre about the contact point in stage tip", 1),
        ("Tilt in stage flight", 2),
        ("Velocity of the mass centre in stage flight", 2),
        ("Gap in stage flight", 2),
        ("Normal force in stage swing", 1),
        ("Spin in stage swing", 1),
        ("Mass centre from the struck point in stage swing", 1),
    ];
    for (title, count) in titles {
        assert_eq!(html.matches(&format!("aria-label=\"{title}\"")).count(), count, "{title}");
    }
}

#[test]
fn names_are_escaped_everywhere() {
    let (mut feeder, mut run) = fixture::turned();
    feeder.plates[1].name = "<script>alert('x')</script>&\"".into();
    run.stages[2].ended_by = StageEnd::Strikes { count: 2, obstacles: vec![1, 0], limit: false };
    let html =
        report(&feeder, &run, "</title><script>", &Extra { scene: Some("</pre><script>".into()), ..extra() });
    assert!(!html.contains("<script>alert"), "a plate's name became markup");
    assert!(html.contains("2 strikes on &lt;script&gt;"), "an ending is told");
    assert!(!html.contains("</title><script>"), "the title became markup");
    assert!(!html.contains("</pre><script>"), "the scene became markup");
    let svg = layout_svg(&feeder, Some(&run), &Draft::default());
    assert!(!svg.contains("<script"), "a plate's name became markup in the drawing");
}

#[test]
fn a_part_that_never_starts_still_gets_a_report() {
    let (feeder, run) = fixture::stuck();
    let html = report(&feeder, &run, "Held", &Extra::default());
    keep("stuck.html", &html);
    assert_balanced(&html);
    assert_clean(&html);
    assert!(html.contains("<strong>Stuck</strong> on “upper”"), "headline");
    assert!(html.contains("slopes by 10.0°, its angle of friction is 21.8°"), "the reason");
    assert!(html.contains("class=\"fig layout\""), "the layout");
    assert!(!html.contains("id=\"player\"") && !html.contains("<script"), "no player without motion");
}

#[test]
fn numbers_that_are_not_finite_are_left_out() {
    let (feeder, mut run) = fixture::turned();
    run.margin = f64::NAN;
    run.trace.pieces[2].samples[5].state.twist.spin = f64::NAN;
    run.trace.pieces[2].samples[6].contacts[0].normal_force = f64::INFINITY;
    run.trace.pieces[3].samples[2].state.pose.centre = Vec2::new(f64::NAN, f64::INFINITY);
    run.trace.impacts[0].energy_after = f64::NAN;
    run.trace.impacts[0].contacts[0].normal_impulse = f64::NAN;
    run.trace.impacts[1].stages[0].contacts[0].normal_impulse[1] = f64::NAN;
    run.stages[3].end.pose.angle = f64::NAN;
    let html = report(&feeder, &run, "holes", &Extra::default());
    assert_clean(&html);
    assert_balanced(&html);
    assert_clean(&layout_svg(&feeder, Some(&run), &Draft::default()));
    assert!(!trace_csv(&feeder, &run).contains("NaN"), "a NaN in the CSV");
}

#[test]
fn every_outcome_has_a_headline() {
    let (feeder, mut run) = fixture::turned();
    let all = [
        (Outcome::Landed, "Turned"),
        (Outcome::Delivered, "Delivered, turned"),
        (Outcome::Stuck, "Stuck"),
        (Outcome::OnEnd, "On end"),
        (Outcome::Jammed, "Jammed"),
        (Outcome::Missed, "Missed"),
        (Outcome::Escaped, "Escaped"),
        (Outcome::NeverFlat, "Never flat"),
    ];
    for (outcome, word) in all {
        run.outcome = outcome;
        let html = report(&feeder, &run, "outcomes", &Extra::default());
        assert!(html.contains(&format!("<strong>{word}</strong>")), "{outcome:?}");
    }
}

#[test]
fn the_layout_alone_shows_slopes_and_drops() {
    let (feeder, run) = fixture::turned();
    let plain = layout_svg(&feeder, None, &Draft::default());
    keep("layout.svg", &plain);
    keep("layout_run.svg", &layout_svg(&feeder, Some(&run), &Draft::default()));
    assert_balanced(&plain);
    assert!(plain.starts_with("<svg xmlns"), "stands alone");
    assert!(plain.contains("10.0°") && plain.contains("25.0°"), "slopes");
    // Straight down is (sin 10°, cos 10°) in the axes of x/0.428 + y/0.3 = 1: 1 / (0.17365/0.428 + 0.98481/0.3) = 0.27112.
    assert!(plain.contains("271.12 mm"), "plumb drop");
}

/// A box on four plates between two walls.
fn zigzag() -> carom_feeder::Feeder {
    let mut feeder = fixture::feeder();
    feeder.part = Part::rectangle(0.04, 0.01, 0.05, 7.1e-6).expect("a box");
    feeder.start.to_edge = 0.08;
    let plate = |k: u32| {
        let (wall, way) = if k.is_multiple_of(2) { (0.0, 1.0) } else { (0.18, -1.0) };
        let uphill = Vec2::new(wall, -0.11 * f64::from(k));
        let edge = uphill + Vec2::new(way * 0.13, -0.05);
        Plate { name: format!("plate {}", k + 1), uphill, edge, unbounded: false, ..feeder.plates[0].clone() }
    };
    let plates = (0..4).map(plate).collect();
    let wall = |name: &str, x: f64| Wall {
        name: name.into(),
        from: Vec2::new(x, -2.0),
        to: Vec2::new(x, 1.0),
        friction: 0.15,
        restitution: 0.0,
        form: Default::default(),
    };
    let walls = vec![wall("left wall", 0.0), wall("right wall", 0.18)];
    carom_feeder::Feeder { plates, walls, ..feeder }
}

#[test]
fn a_zigzag_between_walls_shows_its_gaps_and_cuts_its_walls() {
    let feeder = zigzag();
    let svg = layout_svg(&feeder, None, &Draft::default());
    keep("zigzag.svg", &svg);
    assert_balanced(&svg);
    assert_clean(&svg);
    assert_eq!(svg.matches(">50 mm</text>").count(), 4 + 1, "edge to wall of each plate, and the scale");
    assert_eq!(svg.matches(">21.0°</text>").count(), 4, "atan(0.05 / 0.13) of each plate");
    assert_eq!(svg.matches("class=\"break\"").count(), 4, "both ends of both walls");
}

#[test]
fn every_shape_can_be_drawn() {
    let mut feeder = zigzag();
    let corners = [(-0.01, -0.01), (0.02, -0.01), (-0.01, 0.02)].map(|(x, y)| Vec2::new(x, y));
    let shapes = [(corners.to_vec(), 0.0), (corners.to_vec(), 0.003), (vec![Vec2::ZERO], 0.02)];
    for (vertices, radius) in shapes {
        let kind = if vertices.len() == 1 { PartKind::Disc } else { PartKind::Polygon };
        let shape = Shape::new(vertices, radius).expect("a shape");
        feeder.part = Part { kind, body: Body { shape, mass: 0.1, inertia: 1e-5 } };
        let svg = layout_svg(&feeder, None, &Draft::default());
        keep(&format!("shape_{kind:?}_{radius}.svg"), &svg);
        assert_clean(&svg);
        assert!(svg.contains("class=\"body\""), "the part");
        let run = feeder.run().expect("it runs");
        assert_clean(&report(&feeder, &run, "shapes", &Extra::default()));
    }
}

#[test]
fn the_impulse_plane_names_its_lines_and_stages() {
    let (feeder, run) = fixture::turned();
    let plane = ImpulsePlane::of_contact(&run.trace.impacts[0], 0, &feeder.part.body).expect("one contact");
    let [tt, tn, nn] = plane.operator.expect("one contact acts");
    let p = &plane.points[0];
    let (u_t, u_n) =
        (plane.slip + tt * p.tangential + tn * p.normal, plane.approach + tn * p.tangential + nn * p.normal);
    // From the exact numbers: the slip after is 1.7592 down the plate, which is −t there.
    assert!((u_t + 1.759_206_766_880).abs() < 2e-6 && u_n.abs() < 1e-12, "u after: {u_t} {u_n}");
    let svg = impulse_svg(&plane);
    keep("impulse.svg", &svg);
    assert_balanced(&svg);
    assert!(svg.contains("max. compression"), "line of maximum compression");
    assert!(svg.contains("compression: slips along −t, until compression ends"), "the stage");
    let text = impulse_text(&plane, 60, 16);
    keep("impulse.txt", &text);
    assert!(text.contains("slips along −t") && text.contains('C'), "{text}");
    assert_eq!(
        ImpulsePlane::of_contact(&run.trace.impacts[0], 7, &feeder.part.body),
        None,
        "no such contact"
    );
}

#[test]
fn a_reversing_strike_walks_both_sides_of_the_line_of_sticking() {
    // The paper's first case: the striking end lies (−0.016271, −0.047279) m from the mass centre in the axes (t, n).
    let (r_t, r_n) = (-0.016_271, -0.047_279);
    let (mass, inertia) = (fixture::MASS, fixture::INERTIA);
    let [tt, tn, nn] =
        [1.0 / mass + r_n * r_n / inertia, -r_t * r_n / inertia, 1.0 / mass + r_t * r_t / inertia];
    let (slip, approach, mu) = (0.132_072_584, -1.587_161_331, 0.15);
    let stop = -slip / (tn - mu * tt);
    let normal = approach + stop * (nn - mu * tn);
    let end = stop - normal / (nn + mu * tn);
    let point = |normal, tangential, label: &str| ImpulsePoint {
        normal,
        tangential,
        phase: Phase::Compression,
        label: label.into(),
    };
    let points = vec![
        point(stop, -mu * stop, "compression: slips along +t, until its slip stops"),
        point(end, mu * (end - 2.0 * stop), "compression: slips along −t, until compression ends"),
    ];
    let plane = ImpulsePlane { operator: Some([tt, tn, nn]), slip, approach, friction: mu, points };
    let svg = impulse_svg(&plane);
    keep("reversing.svg", &svg);
    keep("reversing.txt", &impulse_text(&plane, 60, 16));
    assert_balanced(&svg);
    assert!(svg.contains("class=\"sticking\"") && !svg.contains("outside"), "the slip stops in the plane");
    assert_eq!(svg.matches("class=\"walk\" x1").count(), 2, "two stages");
}

#[test]
fn every_sample_is_a_line_of_the_csv() {
    let (feeder, run) = fixture::turned();
    let csv = trace_csv(&feeder, &run);
    keep("trace.csv", &csv);
    let samples: usize = run.trace.pieces.iter().map(|p| p.samples.len()).sum();
    assert_eq!(csv.lines().count(), samples + 1, "one line each, and the head");
    let columns = csv.lines().next().map(|l| l.split(',').count());
    assert_eq!(columns, Some(9 + 2 * 9), "two contacts at most");
    assert!(csv.lines().all(|l| Some(l.split(',').count()) == columns), "every line is whole");
    let last = csv.lines().last().and_then(|l| l.split(',').next()?.parse::<f64>().ok());
    assert_eq!(last, Some(run.end_time), "all digits of the time");
}

/// The rectangle that a text of a layout takes on paper, by what its letters take at most [px].
fn boxes(svg: &str) -> Vec<(String, [f64; 4])> {
    // The widest letters of common fonts are two thirds of their size of 11.5 px in the middle of a word of figures.
    const LETTER: f64 = 7.0;
    let number = |text: &str, key: &str| -> Option<f64> {
        let (_, rest) = text.split_once(key)?;
        rest.split([' ', '"', ')']).next()?.parse().ok()
    };
    let dims = svg.split("<text class=\"dim").skip(1);
    dims.filter_map(|text| {
        let (head, words) = text.split_once('>')?;
        let words = words.split('<').next()?;
        let half = 0.5 * LETTER * words.chars().count() as f64;
        let (x, y, upright) = match head.split_once("translate(") {
            Some((_, place)) => {
                let mut place = place.split([' ', ')']);
                let (x, y) = (place.next()?.parse().ok()?, place.next()?.parse().ok()?);
                (x, y, number(head, "rotate(")?.abs() > 45.0)
            }
            None => (number(head, " x=\"")?, number(head, " y=\"")?, false),
        };
        let (half_x, half_y) = if upright { (6.0, half) } else { (half, 6.0) };
        let middle = head.contains("middle");
        let left = if middle { x - half_x } else { x };
        Some((words.to_owned(), [left, y - half_y, left + 2.0 * half_x, y + half_y]))
    })
    .collect()
}

#[test]
fn no_measure_leaves_the_paper() {
    // A plate that ends 20 mm before the wall: the plumb line is as near to the border as it can be.
    let mut feeder = zigzag();
    for (k, plate) in feeder.plates.iter_mut().enumerate() {
        plate.edge.x = if k.is_multiple_of(2) { 0.17 } else { 0.01 };
    }
    let svg = layout_svg(&feeder, None, &Draft::default());
    keep("narrow.svg", &svg);
    let view = svg.split_once("viewBox=\"").expect("a view").1;
    let view: Vec<f64> =
        view.split('"').next().expect("its numbers").split(' ').filter_map(|x| x.parse().ok()).collect();
    let boxes = boxes(&svg);
    assert!(boxes.len() >= 3 + 4 + 4, "drops, gaps and slopes: {}", boxes.len());
    for (words, [left, top, right, bottom]) in boxes {
        assert!(
            left >= view[0] && top >= view[1] && right <= view[0] + view[2] && bottom <= view[1] + view[3],
            "“{words}” at {left} … {right}, {top} … {bottom} of {view:?}"
        );
    }
}

/// A square of 40 mm with a square hole, about its middle.
fn with_a_hole() -> (carom_feeder::Feeder, Draft) {
    let square = |a: f64| [(-a, -a), (a, -a), (a, a), (-a, a)].map(|(x, y)| Vec2::new(x, y)).to_vec();
    let mut feeder = zigzag();
    feeder.part = Part::rectangle(0.04, 0.04, 0.05, 1.3e-5).expect("a square");
    (feeder, Draft { outline: vec![square(0.02), square(0.005)], ..Draft::default() })
}

#[test]
fn a_report_draws_what_the_file_draws_and_numbers_its_faces() {
    let (feeder, draft) = with_a_hole();
    let run = feeder.run().expect("it runs");
    let html = report(&feeder, &run, "hole", &Extra { draft, ..Extra::default() });
    assert_balanced(&html);
    assert_clean(&html);
    let player = html.split_once("<g id=\"part\">").expect("the animation").1;
    let body = player.split_once("</g>").expect("its part").0;
    let body_path = body.split_once("class=\"body\" d=\"").expect("a path").1.split('"').next().unwrap_or("");
    assert_eq!(body_path.matches('Z').count(), 2, "outline and hole: {body_path}");
    assert!(body.contains("class=\"hull\""), "what touches, too");
    let faces = html.split_once("id=\"part-faces\"").expect("the part by itself").1;
    let faces = faces.split_once("</figure>").expect("a figure").0;
    for face in 0..4 {
        let label = format!("text-anchor=\"middle\">{face}</text>");
        assert_eq!(faces.matches(&label).count(), 2, "face {face}, at the start and at the end");
    }
}

/// A part's farthest points need not be as far from its mass centre as from each other: twice its farthest corner's distance from
/// that is more.
#[test]
fn a_part_is_as_far_across_as_its_farthest_points_are_apart() {
    let mut feeder = zigzag();
    // 30, 40 and 50 mm; its centroid is 10 and 40/3 mm from the legs, 32.0 mm from the farthest corner.
    let corners =
        [(-0.01, -0.04 / 3.0), (0.02, -0.04 / 3.0), (-0.01, 0.08 / 3.0)].map(|(x, y)| Vec2::new(x, y));
    let shape = Shape::new(corners.to_vec(), 0.0).expect("a triangle");
    feeder.part = Part { kind: PartKind::Polygon, body: Body { shape, mass: 0.1, inertia: 1e-5 } };
    let (_, run) = fixture::turned();
    assert!(report(&feeder, &run, "triangle", &Extra::default()).contains("polygon, 50 mm across"));
}

#[test]
fn a_fact_says_of_which_strike_it_is() {
    let (feeder, run) = fixture::turned();
    let html = report(&feeder, &run, "facts", &Extra::default());
    let facts =
        html.split_once("class=\"facts\"").expect("facts").1.split_once("</dl>").expect("their end").0;
    let first = run.trace.impacts[0].contacts[0].before;
    let speed = (first.slip * first.slip + first.normal * first.normal).sqrt();
    let square = format!("{:.2} m/s square to it", -first.normal);
    assert!(
        facts.contains(&format!("<dt>struck at</dt><dd>{speed:.2} m/s<small>strike 1, on “lower”; ")),
        "{facts}"
    );
    assert!(facts.contains(&square), "the same strike, square: {square} in {facts}");
    let hardest = run.trace.impacts.iter().map(|i| -i.contacts[0].before.normal).fold(0.0, f64::max);
    assert_eq!(facts.contains("hardest strike"), hardest > -first.normal, "only where it is another one");
}

#[test]
fn what_the_model_leaves_out_names_each_series_once() {
    let (feeder, mut run) = fixture::turned();
    run.trace.accumulations = vec![(0.2, 0.3), (0.2, 0.3), (0.4, 0.5)];
    let html = report(&feeder, &run, "two ends", &extra());
    assert_balanced(&html);
    let model = html.split_once("What the model leaves out").expect("the section").1;
    assert_eq!(model.matches("closed at their limit, 0.30000 s").count(), 1, "both ends of a face close it");
    assert_eq!(model.matches("closed at their limit, 0.50000 s").count(), 1, "the other series");
}

#[test]
fn a_strike_on_a_wall_is_told_in_words_that_go_together() {
    let mut feeder = zigzag();
    feeder.plates.iter_mut().for_each(|plate| plate.restitution = 0.6);
    let run = feeder.run().expect("it runs");
    let walls = feeder.plates.len()..feeder.plates.len() + feeder.walls.len();
    let struck = run.trace.impacts.iter().filter_map(|impact| impact.contacts.first());
    assert!(struck.into_iter().any(|contact| walls.contains(&contact.obstacle)), "it strikes a wall");
    let html = report(&feeder, &run, "walls", &extra());
    assert!(html.contains("° beside the normal at the struck point"), "beside it, not beside of it");
    assert!(!html.contains("beside of"), "beside of");
}

#[test]
fn parts_of_a_feed_that_do_not_meet_strike_equally_often() {
    let feeder = zigzag();
    let between = carom_motion::planar::Surface { friction: 0.2, restitution: 0.2 };
    let alone = feeder.run().expect("it runs");
    // Each part has its verdict before the next one starts, and goes on while that one falls.
    let feed = carom_feeder::Feed { parts: 3, interval: 1.5 * alone.end_time, between };
    let prepared = feeder.prepare(carom_motion::planar::Options::default()).expect("a feeder");
    let run = prepared.feed(&feed).expect("it runs");
    assert!(run.contacts.is_empty(), "no two meet");
    let page = carom_figure::feed_report(&feeder, &feed, &run, "three", &Extra::default());
    let strikes: Vec<&str> = page
        .split("<tr><th scope=\"row\">")
        .skip(1)
        .filter_map(|row| row.split("</td></tr>").next()?.rsplit("<td>").next())
        .collect();
    assert_eq!(strikes, [alone.trace.impacts.len().to_string().as_str(); 3], "as often as one alone");
}
