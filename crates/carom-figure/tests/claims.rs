//! What pages and drawings show, claim by claim, on the smallest input that shows it.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]
#![allow(unused_imports, reason = "what sets a claim up imports for all claims of its kind")]

/// Of numbers near one, of a sum of a few [1]: four units in the last place.
const ROUNDING: f64 = 1e-15;
/// When a stage ends, as events are located [s].
const TIME: f64 = 1e-9;
/// Of an operator of some 17 /kg from a part's mass and arm [1/kg].
const OPERATOR: f64 = 1e-10;
/// How near boundaries are located to where they are, as a share of the plane [1].
const LOCATED: f64 = 1e-8;

macro_rules! feeder {
    ($uphill:ident, $edge:ident, $feeder:ident) => {
        use {
            carom_feeder::{Feeder, Part, Plate, Start, Stop},
            carom_impact::planar::Law,
            carom_num::Vec2,
        };
        let (friction, restitution, unbounded) = (0.5, 0.0, false);
        let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
        let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
        let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
        let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
        let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
        let ($uphill, $edge, $feeder) = (uphill, edge, feeder);
        // Not every claim needs all of them.
        let _ = (&$uphill, &$edge, &$feeder);
    };
}

#[test]
fn the_first_line_of_a_trace_is_where_the_rod_starts() {
    feeder!(uphill, edge, feeder);
    let run = feeder.run().unwrap();
    let csv = carom_figure::trace_csv(&run);
    let first: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
    assert_eq!(
        (first[0], first[1]),
        ("0.0", "slide"),
        "A rod that starts 0.1 m before the edge of a plate that falls 3 in 4"
    );
    assert!(
        (first[2].parse::<f64>().unwrap() + 0.08).abs() < ROUNDING,
        "A rod that starts 0.1 m before the edge of a plate that falls 3 in 4"
    );
    assert!(
        (first[3].parse::<f64>().unwrap() - 0.06).abs() < ROUNDING,
        "A rod that starts 0.1 m before the edge of a plate that falls 3 in 4"
    );
    assert_eq!(
        csv.lines().count(),
        1 + run.trace.pieces.iter().map(|p| p.samples.len()).sum::<usize>(),
        "A rod that starts 0.1 m before the edge of a plate that falls 3 in 4"
    );
}

#[test]
fn it_stands_in_the_drawing_as_it_was_written() {
    feeder!(uphill, edge, feeder);
    use carom_figure::{Axis, Draft, Measure, layout_svg};
    let length = Measure {
        plate: Some(0),
        name: "length".to_owned(),
        text: "1000 ± 2 mm".to_owned(),
        axis: Axis::Along,
        from: uphill,
        to: edge,
    };
    let draft = Draft { measures: vec![length], ..Draft::default() };
    assert!(
        layout_svg(&feeder, None, &draft).contains("length 1000 ± 2 mm"),
        "It stands in the drawing as it was written"
    );
}

#[test]
fn lines_and_dimensions_of_a_plate_are_in_the_dxf() {
    feeder!(uphill, edge, feeder);
    let dxf = carom_figure::layout_dxf(&feeder, &carom_figure::Draft::default());
    assert!(
        dxf.contains("upper: 1000.00 mm, 36.870 deg") && dxf.contains("edge (0.00, 0.00)"),
        "A plate of 1 m that falls 3 in 4"
    );
    let lines = |layer: &str| dxf.matches(&format!("LINE\r\n8\r\n{layer}\r\n")).count();
    assert_eq!((lines("PLATES"), lines("PART")), (1, 2), "A plate of 1 m that falls 3 in 4");
    assert_eq!(
        (dxf.matches("0\r\nDIMENSION\r\n").count(), dxf.matches("0\r\nBLOCK\r\n").count()),
        (2, 2),
        "A plate of 1 m that falls 3 in 4"
    );
}

#[test]
fn two_parts_one_second_apart_on_a_plate_that_is_too_rough_for_them() {
    feeder!(uphill, edge, feeder);
    use {
        carom_feeder::Feed,
        carom_motion::planar::{Options, Surface},
    };
    let mut rough = feeder.clone();
    rough.plates[0].friction = 1.0;
    let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.2, restitution: 0.0 } };
    let run = rough.prepare(Options::default()).unwrap().feed(&feed).unwrap();
    let page = carom_figure::feed_report(&rough, &feed, &run, "rough", &carom_figure::Extra::default());
    assert!(
        page.contains("<h1>rough, 2 parts</h1>") && page.contains("1 stuck, 1 blocked"),
        "Two parts, one second apart, on a plate that is too rough for them"
    );
}

#[test]
fn where_a_verdict_flips_is_a_row_with_a_dash_where_it_does_not() {
    feeder!(uphill, edge, feeder);
    use carom_figure::{Extra, QuantityLimit, report};
    let limits = vec![QuantityLimit {
        quantity: "plate.upper.slope".to_owned(),
        unit: "°".to_owned(),
        value: 25.0,
        low: Some(21.3),
        high: None,
    }];
    let page = report(&feeder, &feeder.run().unwrap(), "", &Extra { limits, ..Extra::default() });
    assert!(
        page.contains("plate.upper.slope</th><td>21.3°</td><td>25°</td><td>–</td>"),
        "Where a verdict flips is a row, with a dash where it does not"
    );
}

#[test]
fn a_verdict_is_green_with_a_tick_where_it_is_as_wanted_red_with_a_cross_where_it_is_not() {
    feeder!(uphill, edge, feeder);
    use carom_figure::{Extra, Wish, report};
    let wanted = vec![Wish { plate: "lower".to_owned(), want: "turned".to_owned(), met: false }];
    let page = report(&feeder, &feeder.run().unwrap(), "", &Extra { wanted, ..Extra::default() });
    assert!(
        page.contains("Not as wanted: turned on “lower”"),
        "A verdict is green with a tick where it is as wanted, red with a cross where it is not"
    );
}

#[test]
fn the_scene_is_shown_as_it_was_written_but_for_the_characters_that_html_reserves() {
    feeder!(uphill, edge, feeder);
    use carom_figure::{Extra, report};
    let extra = Extra { scene: Some("friction = 0.5 # < 1".to_owned()), ..Extra::default() };
    let page = report(&feeder, &feeder.run().unwrap(), "", &extra);
    assert!(
        page.contains("<pre>friction = 0.5 # &lt; 1</pre>"),
        "The scene is shown as it was written, but for the characters that HTML reserves"
    );
}

#[test]
fn a_plate_of_1_m_is_1000_units_long_and_a_unit_is_a_millimetre() {
    feeder!(uphill, edge, feeder);
    let sheet = carom_figure::drawing_svg(&feeder, &carom_figure::Draft::default());
    assert!(
        sheet.contains("length 1000 mm") && sheet.contains("(−800, 600)"),
        "A plate of 1 m is 1000 units long, and a unit is a millimetre"
    );
    let (_, size) = sheet.split_once("viewBox=\"0 0 ").unwrap();
    let width = size.split(' ').next().unwrap();
    assert!(
        sheet.contains(&format!("width=\"{width}mm\"")),
        "A plate of 1 m is 1000 units long, and a unit is a millimetre"
    );
}

#[test]
fn a_rod_that_slides_0_1_m_with_2_m_s_takes_0_1_s_for_it() {
    feeder!(uphill, edge, feeder);
    use carom_figure::{Row, rows};
    let run = feeder.run().unwrap();
    let Row::Stage(0, slide) = rows(&run)[0] else { panic!("it begins with a stage") };
    assert!(
        (slide.end_time - slide.start_time - 0.1_f64.sqrt()).abs() < TIME,
        "A rod that slides 0.1 m with 2 m/s² takes √0.1 s for it"
    );
}

#[test]
fn a_rod_that_lies_on_a_plate_that_falls_3_in_4_is_tilted_by_atan_3_4() {
    feeder!(uphill, edge, feeder);
    use {carom_feeder::PartKind, carom_figure::shown_tilt};
    let run = feeder.run().unwrap();
    let pose = feeder.start_state().pose;
    assert!(
        (shown_tilt(&feeder, &run, pose).unwrap() - carom_num::elementary::atan(0.75)).abs() < ROUNDING,
        "A rod that lies on a plate that falls 3 in 4 is tilted by atan(3/4)"
    );
    let mut disc = feeder.clone();
    disc.part.kind = PartKind::Disc;
    assert_eq!(
        shown_tilt(&disc, &run, pose),
        None,
        "A rod that lies on a plate that falls 3 in 4 is tilted by atan(3/4)"
    );
}

#[test]
fn on_a_plate_that_falls_to_the_right_forward_is_clockwise() {
    feeder!(uphill, edge, feeder);
    use carom_figure::senses::forward_sense;
    assert_eq!(forward_sense(&feeder), -1.0, "On a plate that falls to the right, forward is clockwise");
    let mut left = feeder.clone();
    left.plates[0].uphill.x = 0.8;
    assert_eq!(forward_sense(&left), 1.0, "On a plate that falls to the right, forward is clockwise");
}

#[test]
fn tilt_is_counted_from_the_horizontal() {
    feeder!(uphill, edge, feeder);
    use carom_figure::senses::tilt;
    let flat = feeder.start_state().pose;
    let turned = carom_motion::planar::Pose { angle: flat.angle - 0.1, ..flat };
    assert!(
        (tilt(&feeder, flat) - carom_num::elementary::atan(0.75)).abs() < ROUNDING,
        "On a plate that falls 3 in 4 to the right"
    );
    assert!(
        (tilt(&feeder, turned) - (carom_num::elementary::atan(0.75) + 0.1)).abs() < ROUNDING,
        "On a plate that falls 3 in 4 to the right"
    );
}

macro_rules! washer {
    ($feeder:ident) => {
        use {
            carom_feeder::{Feeder, Part, Plate, Start, Stop},
            carom_impact::planar::Law,
            carom_num::Vec2,
        };
        let (friction, restitution, unbounded) = (0.5, 0.0, false);
        let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
        let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
        let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
        let (law, stop) = (Law::Poisson, Stop::Landed);
        let part = Part::rectangle(0.1, 0.1, 0.3, 2.5e-4).unwrap();
        let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
        let $feeder = feeder;
    };
}

#[test]
fn the_outline_of_a_washer_has_a_hole() {
    washer!(feeder);
    use carom_figure::{Draft, layout_svg};
    let square = |a: f64| [(a, a), (-a, a), (-a, -a), (a, -a)].map(|(x, y)| Vec2::new(x, y)).to_vec();
    let draft = Draft { outline: vec![square(0.05), square(0.02)], ..Draft::default() };
    let svg = layout_svg(&feeder, None, &draft);
    assert!(svg.contains("class=\"hull\""), "what touches, beside what is drawn");
}

macro_rules! plane {
    ($plane:ident) => {
        use {
            carom_figure::{ImpulsePlane, ImpulsePoint},
            carom_impact::planar::Phase,
        };
        let point = |normal, tangential, label: &str| ImpulsePoint {
            normal,
            tangential,
            phase: Phase::Compression,
            label: label.to_owned(),
        };
        let plane = ImpulsePlane {
            operator: Some([3.5, 0.0, 1.0]),
            slip: 1.05,
            approach: -2.0,
            friction: 0.3,
            points: vec![point(1.0, -0.3, "its slip stops"), point(2.0, -0.3, "compression ends")],
        };
        let $plane = plane;
    };
}

#[test]
fn a_walk_of_two_stages_has_three_corners_the_origin_one_of_them() {
    plane!(plane);
    use carom_figure::{ImpactFigure, ImpactPicture, impact_report};
    let picture = Some(ImpactPicture::Plane(plane));
    let page = impact_report(&ImpactFigure { picture, ..ImpactFigure::default() });
    assert_eq!(
        page.matches("<circle class=\"dot\"").count(),
        3,
        "A walk of two stages has three corners, the origin one of them"
    );
}

#[test]
fn corners_are_numbered_and_explained_with_their_labels() {
    plane!(plane);
    let text = carom_figure::impulse_text(&plane, 40, 8);
    assert!(
        text.ends_with("  1 its slip stops\n  2 compression ends\n"),
        "Corners are numbered, and explained with their labels"
    );
}

#[test]
fn a_head_12_rows_the_axis_its_numbers_what_the_lines_are_and_the_two_corners() {
    plane!(plane);
    let text = carom_figure::impulse_text(&plane, 48, 12);
    assert_eq!(
        text.lines().count(),
        1 + 12 + 2 + 1 + 2,
        "A head, 12 rows, the axis, its numbers, what the lines are, and the two corners"
    );
}

macro_rules! two_plates {
    ($feeder:ident) => {
        use {
            carom_feeder::{Feeder, Part, Plate, Start, Stop},
            carom_impact::planar::Law,
            carom_num::Vec2,
        };
        let plate = |name: &str, uphill, edge| Plate {
            name: name.to_owned(),
            uphill,
            edge,
            friction: 0.5,
            restitution: 0.0,
            unbounded: false,
        };
        let lower = plate("lower", Vec2::new(1.0, -0.2), Vec2::new(-1.0, -0.5));
        let plates = vec![plate("upper", Vec2::new(-0.8, 0.6), Vec2::ZERO), lower];
        let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
        let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
        let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
        let $feeder = feeder;
    };
}

#[test]
fn a_rod_of_0_3_kg_and_0_1_m_that_strikes_with_one_end_however_it_is_turned() {
    two_plates!(feeder);
    let run = feeder.run().unwrap();
    let (impact, body) = (&run.trace.impacts[0], &feeder.part.body);
    let plane = carom_figure::ImpulsePlane::of_contact(impact, 0, body).unwrap();
    let [tt, _, nn] = plane.operator.unwrap();
    assert!(
        (tt + nn - (2.0 / 0.3 + 0.05 * 0.05 / 2.5e-4)).abs() < OPERATOR,
        "A rod of 0.3 kg and 0.1 m that strikes with one end, however it is turned"
    );
    assert_eq!(
        plane.points.last().unwrap().normal,
        impact.contacts[0].normal_impulse,
        "A rod of 0.3 kg and 0.1 m that strikes with one end, however it is turned"
    );
    assert_eq!(carom_figure::ImpulsePlane::of_contact(impact, 1, body), None, "one end strikes");
}

#[test]
fn one_contact_takes_in_the_end_what_the_impact_says() {
    two_plates!(feeder);
    let run = feeder.run().unwrap();
    let impact = &run.trace.impacts[0];
    let walk = carom_figure::JointWalk::of_impact(impact, &["end".to_owned()]);
    let last = walk.stages.last().unwrap();
    assert_eq!(
        (walk.contacts.len(), walk.contacts[0].friction),
        (1, 0.5),
        "One end of a rod strikes a plate"
    );
    assert_eq!(
        last.pieces[0].impulse[1][1], impact.contacts[0].normal_impulse,
        "One end of a rod strikes a plate"
    );
}

#[test]
fn rows_are_in_order_of_time_strikes_among_the_stages() {
    two_plates!(feeder);
    use carom_figure::{Row, rows};
    let run = feeder.run().unwrap();
    let time = |row: &Row| match row {
        Row::Stage(_, stage) => stage.start_time,
        Row::Strike(_, impact) => impact.time,
    };
    let times: Vec<f64> = rows(&run).iter().map(time).collect();
    assert!(
        times.len() > run.stages.len() && times.is_sorted(),
        "Rows are in order of time, strikes among the stages"
    );
}

macro_rules! strips {
    ($piece:ident, $strips:ident) => {
        use carom_figure::{IntervalFill, IntervalPiece, IntervalStrips, intervals_svg};
        let piece = |from, to, fill| IntervalPiece { from, to, fill, parts: vec![] };
        let (bad, good) = (piece(0.1, 0.4, IntervalFill::Bad), piece(0.4, 1.0, IntervalFill::Good));
        let strips = IntervalStrips {
            title: "a feed".to_owned(),
            subtitle: String::new(),
            to: 1.0,
            pieces: vec![bad, good],
            marks: vec![],
            legend: vec![],
        };
        let ($piece, $strips) = (piece, strips);
        // Not every claim needs all of them.
        let _ = (&$piece, &$strips);
    };
}

#[test]
fn what_is_not_known_is_hatched() {
    strips!(piece, strips);
    assert!(!intervals_svg(&strips).contains("url(#hatch)"), "What is not known is hatched");
    let pieces = vec![piece(0.1, 1.0, IntervalFill::Unknown)];
    assert!(
        intervals_svg(&IntervalStrips { pieces, ..strips }).contains("url(#hatch)"),
        "What is not known is hatched"
    );
}

#[test]
fn each_part_has_a_strip_of_its_own() {
    strips!(piece, strips);
    let parts = vec![IntervalFill::Good, IntervalFill::Bad];
    let pieces = vec![IntervalPiece { from: 0.1, to: 1.0, fill: IntervalFill::Bad, parts }];
    let svg = intervals_svg(&IntervalStrips { pieces, ..strips });
    assert!(
        svg.contains("part 1") && svg.contains("part 2") && !svg.contains("part 3"),
        "Each part has a strip of its own"
    );
}

#[test]
fn the_axis_of_1_s_is_700_px_long_and_begins_at_96_px() {
    strips!(piece, strips);
    assert!(
        intervals_svg(&strips).contains("x=\"166\" y=\"92\" width=\"210\""),
        "The axis of 1 s is 700 px long and begins at 96 px"
    );
    let longer = intervals_svg(&IntervalStrips { to: 2.0, ..strips });
    assert!(
        longer.contains("x=\"131\" y=\"92\" width=\"105\""),
        "The axis of 1 s is 700 px long and begins at 96 px"
    );
}

#[test]
fn marks_beyond_the_axis_are_left_out() {
    strips!(piece, strips);
    let marks = vec![(0.4, "first".to_owned()), (2.0, "second".to_owned())];
    let svg = intervals_svg(&IntervalStrips { marks, ..strips });
    assert!(svg.contains("first") && !svg.contains("second"), "Marks beyond the axis are left out");
}

macro_rules! stages {
    ($contacts:ident, $stages:ident) => {
        use carom_figure::{JointContact, JointWalk};
        use {
            carom_impact::planar::{ContactSet2, Law, Touch, staged},
            carom_num::Vec2,
        };
        let normal = Vec2::new(0.0, 1.0);
        let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.2, restitution: 0.0 };
        let velocity = Vec2::new(0.0, -3.0);
        let rod = ContactSet2::of_free_body(1.0, 1.0 / 12.0, velocity, -6.0, &[end(-0.5), end(0.5)]).unwrap();
        let mut stages = vec![];
        staged::resolve_observed(&rod, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
        let contact = |name: &str| JointContact { name: name.to_owned(), friction: 0.2 };
        let contacts = vec![contact("A"), contact("B")];
        let ($contacts, $stages) = (contacts, stages);
        // Not every claim needs all of them.
        let _ = (&$contacts, &$stages);
    };
}

#[test]
fn a_name_is_written_as_it_is_whatever_its_letters() {
    stages!(contacts, stages);
    let odd = |c: JointContact| JointContact { name: format!("<{}>", c.name), ..c };
    let walk = JointWalk::of_stages(contacts.into_iter().map(odd).collect(), &stages);
    assert!(
        carom_figure::joint_svg(&walk).contains("&lt;A&gt;"),
        "A name is written as it is, whatever its letters"
    );
}

#[test]
fn a_rod_of_1_kg_and_1_m_turns_about_a_with_6_rad_s_and_falls_flat() {
    stages!(contacts, stages);
    let walk = JointWalk::of_stages(contacts, &stages);
    let taken = |contact: usize| walk.stages[0].pieces[contact].impulse[1][1];
    assert!(
        (taken(0) - 1.0).abs() < 10.0 * ROUNDING && (taken(1) - 2.0).abs() < 10.0 * ROUNDING,
        "A rod of 1 kg and 1 m turns about A with 6 rad/s and falls flat"
    );
}

#[test]
fn a_rod_that_falls_flat_on_two_supports_without_restitution() {
    stages!(contacts, stages);
    use carom_impact::planar::{Phase, StageEnd};
    let walk = JointWalk::of_stages(contacts, &stages);
    let last = walk.stages.last().unwrap();
    assert_eq!(
        (last.phase, last.ended_by),
        (Phase::Compression, StageEnd::CompressionEnds),
        "A rod that falls flat on two supports, without restitution"
    );
    assert_eq!(last.pieces.len(), 2, "A rod that falls flat on two supports, without restitution");
}

#[test]
fn in_every_stage_each_contact_goes_on_from_where_it_was() {
    stages!(contacts, stages);
    let walk = JointWalk::of_stages(contacts, &stages);
    assert!(
        walk.stages.windows(2).all(|pair| pair[0].pieces[1].impulse[1] == pair[1].pieces[1].impulse[0]),
        "In every stage each contact goes on from where it was"
    );
    assert_eq!(
        walk.stages[0].pieces[1].velocity[0],
        [0.0, -6.0],
        "In every stage each contact goes on from where it was"
    );
}

#[test]
fn a_walk_has_all_stages_and_all_contacts() {
    stages!(contacts, stages);
    let walk = JointWalk::of_stages(contacts, &stages);
    assert_eq!(
        (walk.stages.len(), walk.contacts[1].name.as_str()),
        (stages.len(), "B"),
        "A walk has all stages and all contacts"
    );
}

macro_rules! pose {
    ($end:ident, $probability:ident, $solid:ident) => {
        use carom_figure::{PoseEnd, PoseFigure, SolidDrawing, SolidFigure, pose_report};
        use carom_study::yields::Estimate;
        let drawing = SolidDrawing { corners: &[], faces: &[], lines: &[], points: &[], names: &[] };
        let solid = SolidFigure {
            title: "a die",
            verdict: "six faces",
            lead: "",
            notes: &[],
            drawing,
            instants: &[],
            stages: &[],
            strikes: &[],
            series: &[],
            source: "",
            made_by: "",
        };
        let probability = Estimate { share: 0.25, low: 0.2, high: 0.3, count: 25 };
        let end = PoseEnd {
            name: "face 2".to_owned(),
            vertices: "A B C".to_owned(),
            is_face: true,
            probability,
            of_resting: None,
            stance: Some([0.01, 0.005]),
            command: "carom roll body".to_owned(),
        };
        let ($end, $probability, $solid) = (end, probability, solid);
        // Not every claim needs all of them.
        let _ = (&$end, &$probability, &$solid);
    };
}

#[test]
fn of_25_of_100_throws_end_on_a_face_that_the_mass_centre_stands_10_mm_above_and_5_mm_inside() {
    pose!(end, probability, solid);
    let ends = [end];
    let (ends, resting) = (&ends[..], probability);
    let figure = PoseFigure { solid, ends, resting, time: None, strikes: None, throws: 100 };
    let row = "face 2</th><td>A B C</td><td>10.000</td><td>5.000</td><td>25.00 %</td>";
    assert!(
        pose_report(&figure).contains(row),
        "25 of 100 throws end on a face that the mass centre stands 10 mm above, and 5 mm inside"
    );
}

#[test]
fn the_share_of_throws_that_come_to_rest_is_told_with_its_interval() {
    pose!(end, probability, solid);
    let resting = probability;
    let figure = PoseFigure { solid, ends: &[], resting, time: None, strikes: None, throws: 100 };
    let sentence = "Of 100 throws 25.00 % come to rest on a face (20.00 to 30.00 %, with 95 % confidence).";
    assert!(
        pose_report(&figure).contains(sentence),
        "The share of throws that come to rest is told with its interval"
    );
}

#[test]
fn every_end_that_has_a_command_is_shown_with_it() {
    pose!(end, probability, solid);
    let ends = [end.clone(), PoseEnd { command: String::new(), ..end }];
    let (ends, resting) = (&ends[..], probability);
    let figure = PoseFigure { solid, ends, resting, time: None, strikes: None, throws: 100 };
    assert_eq!(
        pose_report(&figure).matches("<pre>carom roll body</pre>").count(),
        1,
        "Every end that has a command is shown with it"
    );
}

macro_rules! diagram {
    ($diagram:ident, $regions:ident, $name:ident) => {
        use carom_figure::{RegionAxis, RegionCurve, RegionDiagram, RegionName, regions_svg};
        use carom_study::regions::{Options, Range, find};
        let side = Range { from: 0.0, to: 1.0, count: 20 };
        let regions = find(side, side, &Options::default(), |x, _| u8::from(x > 0.25)).unwrap();
        let name = |label: u8| RegionName { short: label.to_string(), long: format!("state {label}") };
        let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
        let diagram = RegionDiagram {
            title: "half".to_owned(),
            subtitle: String::new(),
            axes: [axis("x", "m"), axis("y", "kg m^2")],
            regions: &regions,
            name: &name,
            curves_are: "closed forms".to_owned(),
            curves: vec![],
            here: None,
        };
        let ($diagram, $regions, $name) = (diagram, &regions, &name);
        // Not every claim needs all of them.
        let _ = (&$diagram, &$regions, &$name);
    };
}

#[test]
fn units_stand_in_brackets_with_their_powers_raised() {
    diagram!(diagram, regions, name);
    let svg = regions_svg(&diagram);
    assert!(
        svg.contains("x  [m]") && svg.contains("y  [kg m²]"),
        "Units stand in brackets, with their powers raised"
    );
}

#[test]
fn the_short_name_stands_in_the_region_both_stand_in_the_legend() {
    diagram!(diagram, regions, name);
    let svg = regions_svg(&diagram);
    let mut names = svg.split("<text class=\"state\"").skip(1).filter_map(|rest| rest.split('>').nth(1));
    assert!(
        names.any(|name| name == "1</text") && svg.contains(">1  state 1</text>"),
        "The short name stands in the region, both stand in the legend"
    );
}

#[test]
fn a_curve_at_half_of_an_axis_of_470_px_that_begins_at_62_px_is_drawn_at_297_px() {
    diagram!(diagram, regions, name);
    let middle = RegionCurve { name: "x = 1/2".to_owned(), pieces: vec![vec![[0.5, 0.0], [0.5, 1.0]]] };
    let svg = regions_svg(&RegionDiagram { curves: vec![middle], ..diagram });
    assert!(
        svg.contains("class=\"closed-form\" d=\"M297 ") && svg.contains(">x = 1/2</text>"),
        "A curve at half of an axis of 470 px that begins at 62 px is drawn at 297 px"
    );
}

#[test]
fn the_shares_of_two_states_are_told() {
    diagram!(diagram, regions, name);
    let svg = regions_svg(&diagram);
    assert!(svg.contains("75.0 %") && svg.contains("25.0 %"), "Where x > 1/4 it is state 1, else state 0");
}

#[test]
fn state_1_begins_at_x_1_4_whatever_y() {
    diagram!(diagram, regions, name);
    let csv = carom_figure::regions_csv(regions, ["x_m", "y"], &name);
    assert_eq!(
        csv.lines().next(),
        Some("x_m,y,label_a,label_b,polyline"),
        "State 1 begins at x = 1/4, whatever y"
    );
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert!(
        rows.len() > 1 && rows.iter().all(|row| row[2..] == ["0", "1", "0"]),
        "State 1 begins at x = 1/4, whatever y"
    );
    // Boundaries are located to about a billionth of the plane.
    assert!(
        rows.iter().all(|row| (row[0].parse::<f64>().unwrap() - 0.25).abs() < LOCATED),
        "State 1 begins at x = 1/4, whatever y"
    );
}

macro_rules! roll {
    ($figure:ident) => {
        use carom_motion::planar::{Body, Obstacle, Pose, Shape, State, Twist, World, trace::Trace};
        use {carom_figure::RollFigure, carom_impact::planar::Law, carom_num::Vec2};
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
        let body = Body { shape: Shape::new(corners.to_vec(), 0.0).unwrap(), mass: 1.0, inertia: 2.0 / 3.0 };
        let plane = Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), 0.9, 0.0);
        let world = World::of_one(Vec2::new(0.0, -10.0), body, vec![plane], Law::Poisson);
        let pose = Pose { centre: Vec2::new(0.0, 1.0), angle: 0.0 };
        let (start, trace) = (State { pose, twist: Twist::default() }, Trace::default());
        let figure = RollFigure {
            title: "a prism",
            verdict: "at rest",
            lead: "",
            notes: &[],
            world: &world,
            obstacles: &[],
            unreached: &[],
            start,
            trace: &trace,
            strikes: &[],
            source: "",
            made_by: "",
        };
        let $figure = figure;
    };
}

#[test]
fn a_contact_of_a_roll_is_a_row_with_its_impulses_and_velocities() {
    roll!(figure);
    use carom_figure::{RollContact, RollStrike, roll_report};
    let (name, state) = ("K".to_owned(), "sticks".to_owned());
    let contacts = vec![RollContact { name, state, impulse: [1.5, -0.5], velocity: [0.0, 0.0] }];
    let strikes = [RollStrike { contacts, ..RollStrike::default() }];
    let page = roll_report(&RollFigure { strikes: &strikes, ..figure });
    assert!(
        page.contains("K</th><td>sticks</td><td>1.50000</td><td>−0.500000</td><td>0</td><td>0</td>"),
        "A contact of a roll is a row with its impulses and velocities"
    );
}

#[test]
fn a_cube_that_rolls_on_keeps_a_quarter_of_its_roll_rate() {
    roll!(figure);
    use carom_figure::{RollStrike, roll_report};
    let tilt = std::f64::consts::FRAC_PI_2;
    let strikes = [RollStrike { time: 0.5, roll_rate: [2.0, 0.5], tilt, ..RollStrike::default() }];
    let page = roll_report(&RollFigure { strikes: &strikes, ..figure });
    assert!(
        page.contains("<td>0.5000</td><td>2.000 → 0.5000</td>") && page.contains("<td>90.00</td>"),
        "A cube that rolls on keeps a quarter of its roll rate"
    );
}

#[test]
fn a_body_that_rests_where_it_starts_has_nothing_to_play() {
    roll!(figure);
    let page = carom_figure::roll_report(&RollFigure { title: "1 < 2", ..figure });
    assert!(
        page.contains("<h1>1 &lt; 2</h1>") && !page.contains("id=\"player\""),
        "A body that rests where it starts has nothing to play"
    );
}

macro_rules! solid {
    ($drawing:ident, $figure:ident) => {
        use carom_figure::{SolidDrawing, SolidFigure};
        let drawing = SolidDrawing { corners: &[], faces: &[], lines: &[], points: &[], names: &[] };
        let figure = SolidFigure {
            title: "a stool",
            verdict: "at rest",
            lead: "",
            notes: &[],
            drawing,
            instants: &[],
            stages: &[],
            strikes: &[],
            series: &[],
            source: "",
            made_by: "",
        };
        let ($drawing, $figure) = (drawing, figure);
        // Not every claim needs all of them.
        let _ = (&$drawing, &$figure);
    };
}

#[test]
fn places_are_shown_in_units_of_the_size_of_the_body() {
    solid!(drawing, figure);
    use {
        carom_figure::{SolidInstant, solid_report},
        carom_num::{Rotation, Vec3},
    };
    let (centre, attitude) = (Vec3::Z, Rotation::NONE);
    let instants = [SolidInstant { time: 0.0, centre, attitude, tilt: 0.0, held: vec![] }];
    let (corners, lines) = ([Vec3::X * 2.0, Vec3::Y], [[0, 1]]);
    let drawing = SolidDrawing { corners: &corners, lines: &lines, ..drawing };
    let page = solid_report(&SolidFigure { drawing, instants: &instants, ..figure });
    assert!(
        page.contains("\"corners\":[[1.00000,0.00000,0.00000],[0.00000,0.50000,0.00000]]"),
        "Places are shown in units of the body's size"
    );
}

#[test]
fn half_a_turn_about_z_is_the_quaternion_0_0_0_1() {
    solid!(drawing, figure);
    use {
        carom_figure::{SolidInstant, solid_report},
        carom_num::{Rotation, Vec3},
    };
    let (centre, attitude) = (Vec3::ZERO, Rotation { w: 0.0, v: Vec3::Z });
    let instants = [SolidInstant { time: 0.5, centre, attitude, tilt: 0.0, held: vec![2] }];
    let page = solid_report(&SolidFigure { instants: &instants, ..figure });
    assert!(
        page.contains("0.00000,0.00000,0.00000,1.00000,[2]]"),
        "Half a turn about z is the quaternion (0, 0, 0, 1)"
    );
}

#[test]
fn the_stages_of_a_body_in_space_go_to_its_player() {
    solid!(drawing, figure);
    use {
        carom_figure::{SolidInstant, SolidStage, solid_report},
        carom_num::{Rotation, Vec3},
    };
    let (centre, attitude) = (Vec3::ZERO, Rotation::NONE);
    let instants = [SolidInstant { time: 0.0, centre, attitude, tilt: 0.0, held: vec![] }];
    let stages = [SolidStage { name: "edge", on: "A and B".to_owned(), start: 0.25, end: 0.75 }];
    let page = solid_report(&SolidFigure { instants: &instants, stages: &stages, ..figure });
    assert!(
        page.contains("\"stages\":[[\"edge\",\"A and B\",0.25,0.75]]"),
        "The stages of a body in space go to its player"
    );
}

#[test]
fn strikes_whose_periods_halve_from_0_5_s_on_end_after_another_0_5_s() {
    solid!(drawing, figure);
    use carom_figure::{SolidSeries, solid_report};
    let series = [SolidSeries { from: 0.5, to: 1.0, period: 2, ratio: 0.5, kept: "A and B".to_owned() }];
    let row = "A and B</th><td>0.50000000</td><td>1.00000000</td><td>2</td><td>0.500000</td>";
    assert!(
        solid_report(&SolidFigure { series: &series, ..figure }).contains(row),
        "Strikes whose periods halve from 0.5 s on end after another 0.5 s"
    );
}

#[test]
fn the_slip_of_3_4_m_s_is_shown_by_its_size_5_m_s() {
    solid!(drawing, figure);
    use carom_figure::{SolidContact, SolidStrike, solid_report};
    let (name, state) = ("A".to_owned(), "slides".to_owned());
    let contact = SolidContact { name, strikes: true, state, impulse: [2.0, 0.5], velocity: [3.0, 4.0, 0.0] };
    let strikes = [SolidStrike { contacts: vec![contact], ..SolidStrike::default() }];
    let page = solid_report(&SolidFigure { strikes: &strikes, ..figure });
    assert!(
        page.contains("A</th><td>strikes</td><td>slides</td><td>2.00000</td><td>0.500000</td>"),
        "The slip of (3, 4) m/s is shown by its size, 5 m/s"
    );
    assert!(
        page.contains("<td>0</td><td>5.00000</td></tr>"),
        "The slip of (3, 4) m/s is shown by its size, 5 m/s"
    );
}

#[test]
fn less_friction_may_do_where_the_impulses_are_open() {
    solid!(drawing, figure);
    use carom_figure::{SolidState, SolidStrike, solid_report};
    let (hypothesis, friction) = ("O and K keep".to_owned(), Some(0.25));
    let state = SolidState { hypothesis, friction, friction_is_bound: true, followed: true };
    let strikes = [SolidStrike { found: vec![state], ..SolidStrike::default() }];
    let page = solid_report(&SolidFigure { strikes: &strikes, ..figure });
    assert!(
        page.contains("consistent; not to slide takes friction ≤ 0.2500"),
        "Less friction may do where the impulses are open"
    );
}

#[test]
fn the_way_that_is_followed_stands_before_the_others() {
    solid!(drawing, figure);
    use carom_figure::{SolidFork, SolidStrike, solid_report};
    let (when, others) = ("stage 2".to_owned(), vec!["A sticks".to_owned(), "A slips".to_owned()]);
    let forks = vec![SolidFork { when, followed: Some("A opens".to_owned()), others }];
    let strikes = [SolidStrike { forks, ..SolidStrike::default() }];
    let page = solid_report(&SolidFigure { strikes: &strikes, ..figure });
    assert_eq!(
        (page.matches("as consistent").count(), page.matches("<td>followed</td>").count()),
        (2, 1),
        "The way that is followed stands before the others"
    );
}

#[test]
fn spins_are_shown_by_their_size() {
    solid!(drawing, figure);
    use carom_figure::{SolidStrike, solid_report};
    let spin = [[2.0, 3.0, 6.0], [0.0, 0.0, 0.0]];
    let strikes = [SolidStrike { time: 0.5, spin, energy: [4.0, 1.0], ..SolidStrike::default() }];
    let page = solid_report(&SolidFigure { strikes: &strikes, ..figure });
    assert!(page.contains("<td>7.000 → 0</td><td>4.000 → 1.000</td>"), "Spins are shown by their size");
}

#[test]
fn a_title_is_escaped_a_verdict_begins_with_a_capital() {
    solid!(drawing, figure);
    let page = carom_figure::solid_report(&SolidFigure { title: "a <stool>", ..figure });
    assert!(
        page.contains("<h1>a &lt;stool&gt;</h1>") && page.contains("<strong>At rest</strong>"),
        "A title is escaped, a verdict begins with a capital"
    );
}

#[test]
fn states_that_are_refused_are_counted_with_those_left_out() {
    solid!(drawing, figure);
    use carom_figure::{SolidStrike, solid_report};
    assert!(
        solid_report(&figure).contains("Nothing was struck."),
        "States that are refused are counted with those left out"
    );
    let strikes = [SolidStrike { left_out: 3, ..SolidStrike::default() }, SolidStrike::default()];
    let strikes = strikes.map(|s| SolidStrike { rejected: vec![["A".into(), "pulls".into()]], ..s });
    let page = solid_report(&SolidFigure { strikes: &strikes, ..figure });
    assert!(
        page.contains("No state is consistent, 4 are refused"),
        "States that are refused are counted with those left out"
    );
    assert!(
        page.contains("No state is consistent, 1 is refused"),
        "States that are refused are counted with those left out"
    );
}

macro_rules! rough {
    ($feeder:ident) => {
        use {
            carom_feeder::{Feeder, Part, Plate, Start, Stop},
            carom_impact::planar::Law,
            carom_num::Vec2,
        };
        let (friction, restitution, unbounded) = (0.9, 0.0, false);
        let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
        let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
        let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
        let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
        let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
        let $feeder = feeder;
    };
}

#[test]
fn a_part_that_friction_holds_where_it_starts() {
    rough!(feeder);
    use carom_words::run::headline;
    assert_eq!(
        headline(&feeder, &feeder.run().unwrap()).because,
        "friction holds it",
        "A part that friction holds where it starts"
    );
}

macro_rules! study {
    ($figure:ident) => {
        use carom_figure::{YieldFigure, YieldQuantity, YieldWorst, yield_report};
        use {
            carom_impact::planar::Law,
            carom_study::{
                Ending,
                yields::{Estimate, Yield},
            },
        };
        let share = Estimate { share: 0.75, low: 0.65, high: 0.83, count: 75 };
        let found = Yield {
            wanted: share,
            kept: share,
            endings: vec![],
            passages: vec![],
            plates: vec![],
            time: None,
            worst: vec![],
            drops: 100,
        };
        let figure = YieldFigure {
            title: "a feeder",
            warnings: &[],
            wanted: "turned",
            limited: false,
            plate: "lower",
            plates: &[],
            found: &found,
            deciders: Err("not asked"),
            laws: &[],
            drawn: Ending::Stays,
            law: Law::Poisson,
            quantities: &[],
            worst: &[],
            notes: &[],
            source: "",
            made_by: "",
        };
        let $figure = figure;
    };
}

#[test]
fn what_varies_is_a_row_with_its_tolerance() {
    study!(figure);
    let (path, middle) = ("plate.slope".to_owned(), "10 deg".to_owned());
    let quantities = [YieldQuantity { path, middle, tolerance: "± 0.5 deg".to_owned() }];
    let page = yield_report(&YieldFigure { quantities: &quantities, ..figure });
    assert!(
        page.contains("plate.slope</th><td>10 deg</td><td>± 0.5 deg</td>"),
        "What varies is a row with its tolerance"
    );
}

#[test]
fn a_drop_to_look_at_is_told_with_its_strike() {
    study!(figure);
    let impact_speed = Some(1.25);
    let worst = [YieldWorst { ending: "same".to_owned(), impact_speed, ..YieldWorst::default() }];
    let page = yield_report(&YieldFigure { worst: &worst, ..figure });
    assert!(
        page.contains("<h3>Same <small>strikes at 1.250 m/s</small></h3>"),
        "A drop to look at is told with its strike"
    );
}

#[test]
fn of_100_drops_75_end_as_wanted() {
    study!(figure);
    let page = yield_report(&figure);
    assert!(
        page.contains("<strong>75.00 %</strong> end as wanted") && page.contains("<dd>25.00 %"),
        "Of 100 drops 75 end as wanted"
    );
}
