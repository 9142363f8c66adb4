//! What pages and drawings show, claim by claim, on the smallest input that shows it.
use carom_feeder::{Feed, Feeder, Form, Part, PartKind, Plate, Start, Stop};
use carom_figure::senses::{forward_sense, tilt};
use carom_figure::*;
use carom_impact::planar::{ContactSet2, StageEnd, Touch, staged};
use carom_impact::{Law, Phase};
use carom_motion::planar::trace::Trace;
use carom_motion::planar::{
    Body, ChainPoint, MassProperties, Obstacle, Options, Pose, Shape, State, Surface, Twist, World,
};
use carom_num::elementary::atan;
use carom_num::{Rotation, Vec2, Vec3};
use carom_study::Ending;
use carom_study::regions::{self, Range, Regions};
use carom_study::yields::{Estimate, Yield};
use std::f64::consts::{FRAC_PI_2, PI};

/// Of numbers near one, of a sum of a few [1]: four units in the last place.
const ROUNDING: f64 = 1e-15;
/// When a stage ends, as events are located [s].
const TIME: f64 = 1e-9;
/// Of a length of a drawing, to a nanometre in each coordinate [mm].
const DRAWN: f64 = 1e-5;
/// Of an operator of some 17 /kg from a part's mass and arm [1/kg].
const OPERATOR: f64 = 1e-10;
/// How near boundaries are located to where they are, as a share of the plane [1].
const LOCATED: f64 = 1e-8;

fn shows(page: &str, what: &[&str]) {
    for words in what {
        assert!(page.contains(words), "it does not show {words:?}:\n{page}");
    }
}

fn hides(page: &str, words: &str) {
    assert!(!page.contains(words), "it shows {words:?}:\n{page}");
}

fn near(found: f64, expected: f64, within: f64) {
    assert!((found - expected).abs() < within, "{found} is not {expected}");
}

fn plate(name: &str, [uphill, edge]: [Vec2; 2], friction: f64) -> Plate {
    Plate {
        name: name.to_owned(),
        uphill,
        edge,
        friction,
        restitution: 0.0,
        unbounded: false,
        form: Default::default(),
    }
}

/// A plate of 1 m that falls 3 in 4 to the right, down to the origin.
fn upper(friction: f64) -> Plate {
    plate("upper", [Vec2::new(-0.8, 0.6), Vec2::ZERO], friction)
}

/// A rod of 0.1 m and 0.3 kg on the first of these plates, 0.1 m before its edge, at g = 10 m/s².
fn feeder(plates: Vec<Plate>) -> Feeder {
    let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
    let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
    Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] }
}

fn one_plate() -> Feeder {
    feeder(vec![upper(0.5)])
}

fn two_plates() -> Feeder {
    feeder(vec![upper(0.5), plate("lower", [Vec2::new(1.0, -0.2), Vec2::new(-1.0, -0.5)], 0.5)])
}

/// The report of the run on one plate.
fn report_with(extra: &Extra) -> String {
    let feeder = one_plate();
    report(&feeder, &feeder.run().unwrap(), "", extra)
}

#[test]
fn the_first_line_of_a_trace_is_where_the_rod_starts() {
    let run = one_plate().run().unwrap();
    let csv = trace_csv(&one_plate(), &run);
    let first: Vec<&str> = csv.lines().nth(1).unwrap().split(',').collect();
    assert_eq!((first[0], first[1]), ("0.0", "slide"), "it slides from the start");
    near(first[2].parse().unwrap(), -0.08, ROUNDING);
    near(first[3].parse().unwrap(), 0.06, ROUNDING);
    let samples = run.trace.pieces.iter().map(|p| p.samples.len()).sum::<usize>();
    assert_eq!(csv.lines().count(), 1 + samples, "a head, and a line for each sample");
}

#[test]
fn a_measure_stands_in_the_drawing_as_it_was_written() {
    let (name, text) = ("length".to_owned(), "1000 ± 2 mm".to_owned());
    let [from, to] = [Vec2::new(-0.8, 0.6), Vec2::ZERO];
    let measures = vec![Measure { plate: Some(0), name, text, axis: Axis::Along, from, to }];
    let draft = Draft { measures, ..Draft::default() };
    shows(&layout_svg(&one_plate(), None, &draft), &["length 1000 ± 2 mm"]);
}

#[test]
fn lines_and_dimensions_of_a_plate_are_in_the_dxf() {
    let dxf = layout_dxf(&one_plate(), &Draft::default());
    shows(&dxf, &["upper: 1000.00 mm, 36.870 deg", "edge (0.00, 0.00)"]);
    let count = |what: &str| dxf.matches(what).count();
    let lines = |layer: &str| count(&format!("LINE\r\n8\r\n{layer}\r\n"));
    assert_eq!((lines("PLATES"), lines("PART")), (1, 2), "a line a plate, two a rod");
    assert_eq!((count("0\r\nDIMENSION\r\n"), count("0\r\nBLOCK\r\n")), (2, 2), "its length and its slope");
}

#[test]
fn the_radii_of_bends_and_edges_are_dimensions_of_the_dxf_about_their_centres() {
    // Level after a quarter turn of 200 mm, a sheet of 20 mm.
    let quarter = ChainPoint { at: Vec2::new(-0.2, 0.2), sweep: FRAC_PI_2 };
    let course =
        [Vec2::new(-0.2, 0.4), quarter.at, Vec2::ZERO, Vec2::new(0.3, 0.0)].map(ChainPoint::straight);
    let course = course.map(|point| if point.at == quarter.at { quarter } else { point }).to_vec();
    let form = Form { course, edge_radius: 0.01 };
    let chute = Plate { form, ..plate("chute", [Vec2::new(-0.2, 0.4), Vec2::new(0.3, 0.0)], 0.2) };
    let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
    let dxf = layout_dxf(&Feeder { start, ..feeder(vec![chute]) }, &Draft::default());
    let radial = |text: &str| {
        let entities = dxf.split("0\r\nDIMENSION\r\n").skip(1);
        let own: Vec<_> = entities.filter(|e| e.contains(&format!("\r\n1\r\n{text}\r\n"))).collect();
        assert!(own.iter().all(|e| e.contains("\r\n70\r\n132\r\n")), "{text} is a radius: {own:?}");
        let value = |e: &str, code: &str| -> f64 {
            e.split_once(&format!("\r\n{code}\r\n")).unwrap().1.lines().next().unwrap().parse().unwrap()
        };
        own.iter().map(|e| ["10", "20", "15", "25"].map(|code| value(e, code))).collect::<Vec<_>>()
    };
    assert_eq!(radial("edge R 10 mm"), [[290.0, -10.0, 300.0, -10.0], [-210.0, 390.0, -210.0, 400.0]]);
    let [[x, y, on_x, on_y]] = radial("bend R 200 mm")[..] else { panic!("one bend") };
    assert_eq!([x, y], [0.0, 200.0], "its centre");
    near((Vec2::new(on_x, on_y) - Vec2::new(x, y)).norm(), 200.0, DRAWN);
}

#[test]
fn a_half_disc_has_a_side_and_an_arc_in_the_table_of_its_faces_and_two_numbers_in_its_picture() {
    let half =
        [ChainPoint { at: Vec2::new(-0.05, 0.0), sweep: PI }, ChainPoint::straight(Vec2::new(0.05, 0.0))];
    let drawn = MassProperties::of(&Shape::of_chain(&half).unwrap());
    let about_centre = half.map(|point| ChainPoint { at: point.at - drawn.centroid, ..point });
    let shape = Shape::of_chain(&about_centre).unwrap();
    let body = Body { shape, mass: 0.1, inertia: 0.1 * drawn.gyration_squared };
    let half = Feeder { part: Part { body, kind: PartKind::Polygon }, ..one_plate() };
    let page = report(&half, &half.run().unwrap(), "", &Extra::default());
    shows(&page, &["<th scope=\"row\">0</th><td>side</td><td>100.00</td>"]);
    shows(&page, &["<th scope=\"row\">1</th><td>arc</td><td>–</td>"]);
    let numbers = |face: &str| {
        let mut texts = page.split("class=\"face\"").skip(1).filter_map(|text| text.split_once('>'));
        texts.any(|(_, text)| text.starts_with(&format!("{face}<")))
    };
    assert!(numbers("0") && numbers("1"), "both faces have their numbers");
}

#[test]
fn of_two_parts_one_second_apart_on_a_plate_too_rough_for_them_one_is_stuck_and_one_blocked() {
    let rough = feeder(vec![upper(1.0)]);
    let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.2, restitution: 0.0 } };
    let run = rough.prepare(Options::default()).unwrap().feed(&feed).unwrap();
    let page = feed_report(&rough, &feed, &run, "rough", &Extra::default());
    shows(&page, &["<h1>rough, 2 parts</h1>", "1 stuck, 1 blocked"]);
}

#[test]
fn where_a_verdict_flips_is_a_row_and_where_nothing_more_can_be_drawn_stands_in_parentheses() {
    let (quantity, unit) = ("plate.upper.slope".to_owned(), "°".to_owned());
    let limits = vec![QuantityLimit {
        quantity,
        unit,
        value: 25.0,
        low: Some(21.3),
        possible: [None, Some(40.0)],
        ..QuantityLimit::default()
    }];
    let page = report_with(&Extra { limits, ..Extra::default() });
    shows(&page, &["plate.upper.slope</th><td>21.3°</td><td>25°</td><td>(40°)</td>"]);
}

#[test]
fn a_verdict_that_is_not_as_wanted_says_so() {
    let wanted = vec![Wish { plate: "lower".to_owned(), want: "turned".to_owned(), met: false }];
    shows(&report_with(&Extra { wanted, ..Extra::default() }), &["Not as wanted: turned on “lower”"]);
}

#[test]
fn the_scene_is_shown_as_it_was_written_but_for_the_characters_that_html_reserves() {
    let scene = Some("friction = 0.5 # < 1".to_owned());
    shows(&report_with(&Extra { scene, ..Extra::default() }), &["<pre>friction = 0.5 # &lt; 1</pre>"]);
}

#[test]
fn a_plate_of_1_m_is_1000_units_long_and_a_unit_is_a_millimetre() {
    let sheet = drawing_svg(&one_plate(), &Draft::default());
    shows(&sheet, &["length 1000 mm", "(−800, 600)"]);
    let (_, size) = sheet.split_once("viewBox=\"0 0 ").unwrap();
    let width = size.split(' ').next().unwrap();
    shows(&sheet, &[&format!("width=\"{width}mm\"")]);
}

#[test]
fn a_rod_that_slides_0_1_m_with_2_m_s2_takes_the_root_of_0_1_s_for_it() {
    let run = one_plate().run().unwrap();
    let Row::Stage(0, slide) = rows(&run)[0] else { panic!("it begins with a stage") };
    near(slide.end_time - slide.start_time, 0.1_f64.sqrt(), TIME);
}

#[test]
fn a_rod_that_lies_on_a_plate_that_falls_3_in_4_is_tilted_by_atan_3_4_and_a_disc_by_nothing() {
    let mut feeder = one_plate();
    let (run, pose) = (feeder.run().unwrap(), feeder.start_state().pose);
    near(shown_tilt(&feeder, &run, pose).unwrap(), atan(0.75), ROUNDING);
    feeder.part.kind = PartKind::Disc;
    assert_eq!(shown_tilt(&feeder, &run, pose), None, "a disc");
}

#[test]
fn on_a_plate_that_falls_to_the_right_forward_is_clockwise() {
    let mut feeder = one_plate();
    assert_eq!(forward_sense(&feeder), -1.0, "to the right");
    feeder.plates[0].uphill.x = 0.8;
    assert_eq!(forward_sense(&feeder), 1.0, "to the left");
}

#[test]
fn tilt_is_counted_from_the_horizontal() {
    let feeder = one_plate();
    let flat = feeder.start_state().pose;
    let turned = Pose { angle: flat.angle - 0.1, ..flat };
    near(tilt(&feeder, flat), atan(0.75), ROUNDING);
    near(tilt(&feeder, turned), atan(0.75) + 0.1, ROUNDING);
}

#[test]
fn a_part_that_friction_holds_where_it_starts_is_said_to_be_held() {
    let rough = feeder(vec![upper(0.9)]);
    assert_eq!(
        carom_words::run::headline(&rough, &rough.run().unwrap()).because,
        "friction holds it",
        "0.9 is more than 3/4"
    );
}

#[test]
fn what_touches_of_a_washer_stands_beside_what_is_drawn() {
    let washer = Feeder { part: Part::rectangle(0.1, 0.1, 0.3, 2.5e-4).unwrap(), ..one_plate() };
    let square = |a: f64| [(a, a), (-a, a), (-a, -a), (a, -a)].map(|(x, y)| Vec2::new(x, y)).to_vec();
    let draft = Draft { outline: vec![square(0.05), square(0.02)], ..Draft::default() };
    shows(&layout_svg(&washer, None, &draft), &["class=\"hull\""]);
}

/// A walk of two stages.
fn plane() -> ImpulsePlane {
    let point = |normal, label: &str| ImpulsePoint {
        normal,
        tangential: -0.3,
        phase: Phase::Compression,
        label: label.to_owned(),
    };
    let points = vec![point(1.0, "its slip stops"), point(2.0, "compression ends")];
    ImpulsePlane { operator: Some([3.5, 0.0, 1.0]), slip: 1.05, approach: -2.0, friction: 0.3, points }
}

#[test]
fn a_walk_of_two_stages_has_three_corners_the_origin_one_of_them() {
    let picture = Some(ImpactPicture::Plane(plane()));
    let page = impact_report(&ImpactFigure { picture, ..ImpactFigure::default() });
    assert_eq!(page.matches("<circle class=\"dot\"").count(), 3, "{page}");
}

#[test]
fn corners_are_numbered_and_explained_with_their_labels() {
    let text = impulse_text(&plane(), 40, 8);
    assert!(text.ends_with("  1 its slip stops\n  2 compression ends\n"), "{text}");
}

#[test]
fn an_impulse_plane_in_text_is_a_head_12_rows_the_axis_its_numbers_what_the_lines_are_and_the_two_corners() {
    let text = impulse_text(&plane(), 48, 12);
    assert_eq!(text.lines().count(), 1 + 12 + 2 + 1 + 2, "{text}");
}

/// One end strikes, however the rod is turned: the operator's trace is 2/m + r²/J.
#[test]
fn the_operator_of_a_rods_end_has_the_trace_of_its_mass_and_arm() {
    let feeder = two_plates();
    let run = feeder.run().unwrap();
    let (impact, body) = (&run.trace.impacts[0], &feeder.part.body);
    let plane = ImpulsePlane::of_contact(impact, 0, body).unwrap();
    let [tt, _, nn] = plane.operator.unwrap();
    near(tt + nn, 2.0 / 0.3 + 0.05 * 0.05 / 2.5e-4, OPERATOR);
    let last = plane.points.last().unwrap().normal;
    assert_eq!(last, impact.contacts[0].normal_impulse, "the walk ends where the impact does");
    assert_eq!(ImpulsePlane::of_contact(impact, 1, body), None, "one end strikes");
}

#[test]
fn one_contact_takes_in_the_end_what_the_impact_says() {
    let run = two_plates().run().unwrap();
    let impact = &run.trace.impacts[0];
    let walk = JointWalk::of_impact(impact, &["end".to_owned()]);
    assert_eq!((walk.contacts.len(), walk.contacts[0].friction), (1, 0.5), "one end of the rod");
    let taken = walk.stages.last().unwrap().pieces[0].impulse[1][1];
    assert_eq!(taken, impact.contacts[0].normal_impulse, "in the end");
}

#[test]
fn rows_are_in_order_of_time_strikes_among_the_stages() {
    let run = two_plates().run().unwrap();
    let time = |row: &Row| match row {
        Row::Stage(_, stage) => stage.start_time,
        Row::Strike(_, impact) => impact.time,
    };
    let times: Vec<f64> = rows(&run).iter().map(time).collect();
    assert!(times.len() > run.stages.len() && times.is_sorted(), "{times:?}");
}

fn interval(from: f64, to: f64, fill: IntervalFill) -> IntervalPiece {
    IntervalPiece { from, to, fill, parts: vec![] }
}

fn strips() -> IntervalStrips {
    let pieces = vec![interval(0.1, 0.4, IntervalFill::Bad), interval(0.4, 1.0, IntervalFill::Good)];
    let (title, subtitle) = ("a feed".to_owned(), String::new());
    IntervalStrips { title, subtitle, to: 1.0, pieces, marks: vec![], legend: vec![] }
}

#[test]
fn what_is_not_known_is_hatched() {
    hides(&intervals_svg(&strips()), "url(#hatch)");
    let pieces = vec![interval(0.1, 1.0, IntervalFill::Unknown)];
    shows(&intervals_svg(&IntervalStrips { pieces, ..strips() }), &["url(#hatch)"]);
}

#[test]
fn each_part_has_a_strip_of_its_own() {
    let parts = vec![IntervalFill::Good, IntervalFill::Bad];
    let pieces = vec![IntervalPiece { parts, ..interval(0.1, 1.0, IntervalFill::Bad) }];
    let svg = intervals_svg(&IntervalStrips { pieces, ..strips() });
    shows(&svg, &["part 1", "part 2"]);
    hides(&svg, "part 3");
}

#[test]
fn the_axis_of_1_s_is_700_px_long_and_begins_at_96_px() {
    shows(&intervals_svg(&strips()), &["x=\"166\" y=\"92\" width=\"210\""]);
    let longer = intervals_svg(&IntervalStrips { to: 2.0, ..strips() });
    shows(&longer, &["x=\"131\" y=\"92\" width=\"105\""]);
}

#[test]
fn marks_beyond_the_axis_are_left_out() {
    let marks = vec![(0.4, "first".to_owned()), (2.0, "second".to_owned())];
    let svg = intervals_svg(&IntervalStrips { marks, ..strips() });
    shows(&svg, &["first"]);
    hides(&svg, "second");
}

/// A rod of 1 kg and 1 m that falls flat on two supports, its end B faster, with these names; and how many stages that has.
fn walk(names: [&str; 2]) -> (JointWalk, usize) {
    let normal = Vec2::new(0.0, 1.0);
    let end = |x| Touch { arm: Vec2::new(x, 0.0), normal, friction: 0.2, restitution: 0.0 };
    let (velocity, inertia) = (Vec2::new(0.0, -3.0), 1.0 / 12.0);
    let rod = ContactSet2::of_free_body(1.0, inertia, velocity, -6.0, &[end(-0.5), end(0.5)]).unwrap();
    let mut stages = vec![];
    staged::resolve_observed(&rod, Law::Poisson, &mut |stage| stages.push(*stage)).unwrap();
    let contacts = names.map(|name| JointContact { name: name.to_owned(), friction: 0.2 });
    (JointWalk::of_stages(contacts.to_vec(), &stages), stages.len())
}

#[test]
fn a_name_is_written_as_it_is_whatever_its_letters() {
    shows(&joint_svg(&walk(["<A>", "<B>"]).0), &["&lt;A&gt;"]);
}

#[test]
fn a_rod_of_1_kg_and_1_m_turns_about_a_with_6_rad_s_and_falls_flat() {
    let (walk, _) = walk(["A", "B"]);
    for (contact, expected) in [1.0, 2.0].into_iter().enumerate() {
        near(walk.stages[0].pieces[contact].impulse[1][1], expected, 10.0 * ROUNDING);
    }
}

#[test]
fn a_rod_that_falls_flat_on_two_supports_without_restitution_ends_with_compression() {
    let (walk, _) = walk(["A", "B"]);
    let last = walk.stages.last().unwrap();
    assert_eq!(
        (last.phase, last.ended_by),
        (Phase::Compression, StageEnd::CompressionEnds),
        "its last stage"
    );
    assert_eq!(last.pieces.len(), 2, "a piece a contact");
}

#[test]
fn in_every_stage_each_contact_goes_on_from_where_it_was() {
    let (walk, _) = walk(["A", "B"]);
    let goes_on = |pair: &[JointStage]| pair[0].pieces[1].impulse[1] == pair[1].pieces[1].impulse[0];
    assert!(walk.stages.windows(2).all(goes_on), "{:?}", walk.stages);
    assert_eq!(walk.stages[0].pieces[1].velocity[0], [0.0, -6.0], "from how it comes");
}

#[test]
fn a_walk_has_all_stages_and_all_contacts() {
    let (walk, stages) = walk(["A", "B"]);
    assert_eq!((walk.stages.len(), walk.contacts[1].name.as_str()), (stages, "B"), "as they were seen");
}

/// A body in space with nothing to show.
fn solid() -> SolidFigure<'static> {
    let drawing = SolidDrawing {
        corners: &[],
        faces: &[],
        numbers: None,
        seams: &[],
        lines: &[],
        points: &[],
        names: &[],
    };
    let (title, verdict, lead, source, made_by) = ("a <stool>", "at rest", "", "", "");
    let (notes, around, instants, stages, strikes, series) = (&[], &[], &[], &[], &[], &[]);
    SolidFigure {
        title,
        verdict,
        lead,
        notes,
        drawing,
        around,
        instants,
        stages,
        strikes,
        series,
        source,
        made_by,
    }
}

fn page_of_strikes(strikes: &[SolidStrike]) -> String {
    solid_report(&SolidFigure { strikes, ..solid() })
}

/// Where a body is, with its supports of these numbers held.
fn instant(time: f64, centre: Vec3, attitude: Rotation, held: Vec<usize>) -> [SolidInstant; 1] {
    [SolidInstant { time, centre, attitude, tilt: 0.0, held, places: vec![] }]
}

/// A quarter of 100 throws, on a face that the mass centre stands 10 mm above and 5 mm inside.
fn pose() -> PoseEnd {
    PoseEnd {
        name: "face 2".to_owned(),
        vertices: "A B C".to_owned(),
        is_face: true,
        probability: QUARTER,
        of_resting: None,
        stance: Some([0.01, 0.005]),
        command: "carom roll body".to_owned(),
    }
}

const QUARTER: Estimate = Estimate { share: 0.25, low: 0.2, high: 0.3, count: 25 };

fn page_of_poses(ends: &[PoseEnd]) -> String {
    let SolidFigure { title, verdict, lead, notes, source, made_by, drawing, .. } = solid();
    let (body, resting, time, strikes, throws) = (PoseBody::Solid(drawing, &[]), QUARTER, None, None, 100);
    pose_report(&PoseFigure {
        title,
        verdict,
        lead,
        notes,
        source,
        made_by,
        body,
        ends,
        resting,
        time,
        strikes,
        throws,
    })
}

#[test]
fn a_face_is_a_row_with_how_the_mass_centre_stands_on_it_and_its_share() {
    let row = "face 2</th><td>A B C</td><td>10.000</td><td>5.000</td><td>25.00 %</td>";
    shows(&page_of_poses(&[pose()]), &[row]);
}

#[test]
fn the_share_of_throws_that_come_to_rest_is_told_with_its_interval() {
    let sentence = "Of 100 throws 25.00 % come to rest on a face (20.00 to 30.00 %, with 95 % confidence).";
    shows(&page_of_poses(&[]), &[sentence]);
}

#[test]
fn every_end_that_has_a_command_is_shown_with_it() {
    let page = page_of_poses(&[pose(), PoseEnd { command: String::new(), ..pose() }]);
    assert_eq!(page.matches("<pre>carom roll body</pre>").count(), 1, "{page}");
}

#[test]
fn places_are_shown_in_units_of_the_size_of_the_body() {
    let (corners, lines) = ([Vec3::X * 2.0, Vec3::Y], [[0, 1]]);
    let drawing = SolidDrawing { corners: &corners, lines: &lines, ..solid().drawing };
    let instants = &instant(0.0, Vec3::Z, Rotation::NONE, vec![]);
    let page = solid_report(&SolidFigure { drawing, instants, ..solid() });
    shows(&page, &["\"corners\":[[1.00000,0.00000,0.00000],[0.00000,0.50000,0.00000]]"]);
}

#[test]
fn half_a_turn_about_z_is_the_quaternion_0_0_0_1() {
    let instants = &instant(0.5, Vec3::ZERO, Rotation { w: 0.0, v: Vec3::Z }, vec![2]);
    let page = solid_report(&SolidFigure { instants, ..solid() });
    shows(&page, &["0.00000,0.00000,0.00000,1.00000,[2]]"]);
}

#[test]
fn the_stages_of_a_body_in_space_go_to_its_player() {
    let instants = &instant(0.0, Vec3::ZERO, Rotation::NONE, vec![]);
    let stages = &[SolidStage { name: "edge", on: "A and B".to_owned(), start: 0.25, end: 0.75 }];
    let page = solid_report(&SolidFigure { instants, stages, ..solid() });
    shows(&page, &["\"stages\":[[\"edge\",\"A and B\",0.25,0.75]]"]);
}

#[test]
fn strikes_whose_periods_halve_from_0_5_s_on_end_after_another_0_5_s() {
    let series = &[SolidSeries { from: 0.5, to: 1.0, period: 2, ratio: 0.5, kept: "A and B".to_owned() }];
    let row = "A and B</th><td>0.50000000</td><td>1.00000000</td><td>2</td><td>0.500000</td>";
    shows(&solid_report(&SolidFigure { series, ..solid() }), &[row]);
}

#[test]
fn the_slip_of_3_4_m_s_is_shown_by_its_size_5_m_s() {
    let (name, state) = ("A".to_owned(), "slides".to_owned());
    let contact = SolidContact { name, strikes: true, state, impulse: [2.0, 0.5], velocity: [3.0, 4.0, 0.0] };
    let page = page_of_strikes(&[SolidStrike { contacts: vec![contact], ..SolidStrike::default() }]);
    let row = "A</th><td>strikes</td><td>slides</td><td>2.00000</td><td>0.500000</td>";
    shows(&page, &[row, "<td>0</td><td>5.00000</td></tr>"]);
}

#[test]
fn less_friction_may_do_where_the_impulses_are_open() {
    let (hypothesis, friction) = ("O and K keep".to_owned(), Some(0.25));
    let state = SolidState { hypothesis, friction, friction_is_bound: true, followed: true };
    let page = page_of_strikes(&[SolidStrike { found: vec![state], ..SolidStrike::default() }]);
    shows(&page, &["consistent; not to slide takes friction ≤ 0.2500"]);
}

#[test]
fn the_way_that_is_followed_stands_before_the_others() {
    let (when, others) = ("stage 2".to_owned(), vec!["A sticks".to_owned(), "A slips".to_owned()]);
    let forks = vec![SolidFork { when, followed: Some("A opens".to_owned()), others }];
    let page = page_of_strikes(&[SolidStrike { forks, ..SolidStrike::default() }]);
    let count = |what: &str| page.matches(what).count();
    assert_eq!((count("as consistent"), count("<td>followed</td>")), (2, 1), "{page}");
}

#[test]
fn spins_are_shown_by_their_size() {
    let spin = [[2.0, 3.0, 6.0], [0.0, 0.0, 0.0]];
    let page =
        page_of_strikes(&[SolidStrike { time: 0.5, spin, energy: [4.0, 1.0], ..SolidStrike::default() }]);
    shows(&page, &["<td>7.000 → 0</td><td>4.000 → 1.000</td>"]);
}

#[test]
fn a_title_is_escaped_a_verdict_begins_with_a_capital() {
    shows(&solid_report(&solid()), &["<h1>a &lt;stool&gt;</h1>", "<strong>At rest</strong>"]);
}

#[test]
fn states_that_are_refused_are_counted_with_those_left_out() {
    shows(&page_of_strikes(&[]), &["Nothing was struck."]);
    let strikes = [SolidStrike { left_out: 3, ..SolidStrike::default() }, SolidStrike::default()];
    let page =
        page_of_strikes(&strikes.map(|s| SolidStrike { rejected: vec![["A".into(), "pulls".into()]], ..s }));
    shows(&page, &["No state is consistent, 4 are refused", "No state is consistent, 1 is refused"]);
}

/// The page of a cube of 2 m that rests on a plane.
fn page_of_a_roll(title: &str, strikes: &[RollStrike]) -> String {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
    let body = Body { shape: Shape::new(corners.to_vec(), 0.0).unwrap(), mass: 1.0, inertia: 2.0 / 3.0 };
    let plane = Obstacle::new(Vec2::new(-9.0, 0.0), Vec2::new(9.0, 0.0), 0.9, 0.0);
    let world = &World::of_one(Vec2::new(0.0, -10.0), body, vec![plane], Law::Poisson);
    let pose = Pose { centre: Vec2::new(0.0, 1.0), angle: 0.0 };
    let (start, trace) = (State { pose, twist: Twist::default() }, &Trace::default());
    let (verdict, lead, source, made_by) = ("at rest", "", "", "");
    let (notes, obstacles, unreached) = (&[], &[], &[]);
    roll_report(&RollFigure {
        title,
        verdict,
        lead,
        notes,
        world,
        obstacles,
        unreached,
        start,
        trace,
        strikes,
        source,
        made_by,
    })
}

#[test]
fn a_contact_of_a_roll_is_a_row_with_its_impulses_and_velocities() {
    let (name, state) = ("K".to_owned(), "sticks".to_owned());
    let contacts = vec![RollContact { name, state, impulse: [1.5, -0.5], velocity: [0.0, 0.0] }];
    let page = page_of_a_roll("a prism", &[RollStrike { contacts, ..RollStrike::default() }]);
    shows(&page, &["K</th><td>sticks</td><td>1.50000</td><td>−0.500000</td><td>0</td><td>0</td>"]);
}

#[test]
fn a_cube_that_rolls_on_keeps_a_quarter_of_its_roll_rate() {
    let tilt = std::f64::consts::FRAC_PI_2;
    let strike = RollStrike { time: 0.5, roll_rate: [2.0, 0.5], tilt, ..RollStrike::default() };
    let page = page_of_a_roll("a prism", &[strike]);
    shows(&page, &["<td>0.5000</td><td>2.000 → 0.5000</td>", "<td>90.00</td>"]);
}

#[test]
fn a_body_that_rests_where_it_starts_has_nothing_to_play() {
    let page = page_of_a_roll("1 < 2", &[]);
    shows(&page, &["<h1>1 &lt; 2</h1>"]);
    hides(&page, "id=\"player\"");
}

/// State 1 where x > 1/4, else state 0.
fn regions() -> Regions<u8> {
    let side = Range { from: 0.0, to: 1.0, count: 20 };
    regions::find(side, side, &regions::Options::default(), |x, _| u8::from(x > 0.25)).unwrap()
}

fn state_name(label: u8) -> RegionName {
    RegionName { short: label.to_string(), long: format!("state {label}") }
}

fn diagram_with(curves: Vec<RegionCurve>) -> String {
    let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
    regions_svg(&RegionDiagram {
        title: "half".to_owned(),
        subtitle: String::new(),
        axes: [axis("x", "m"), axis("y", "kg m^2")],
        regions: &regions(),
        name: &state_name,
        curves_are: "closed forms".to_owned(),
        curves,
        here: None,
    })
}

#[test]
fn units_stand_in_brackets_with_their_powers_raised() {
    shows(&diagram_with(vec![]), &["x  [m]", "y  [kg m²]"]);
}

#[test]
fn the_short_name_stands_in_the_region_both_stand_in_the_legend() {
    let svg = diagram_with(vec![]);
    let mut names = svg.split("<text class=\"state\"").skip(1).filter_map(|rest| rest.split('>').nth(1));
    assert!(names.any(|name| name == "1</text"), "{svg}");
    shows(&svg, &[">1  state 1</text>"]);
}

#[test]
fn a_curve_at_half_of_an_axis_of_470_px_that_begins_at_62_px_is_drawn_at_297_px() {
    let middle = RegionCurve { name: "x = 1/2".to_owned(), pieces: vec![vec![[0.5, 0.0], [0.5, 1.0]]] };
    shows(&diagram_with(vec![middle]), &["class=\"closed-form\" d=\"M297 ", ">x = 1/2</text>"]);
}

#[test]
fn the_shares_of_two_states_are_told() {
    shows(&diagram_with(vec![]), &["75.0 %", "25.0 %"]);
}

#[test]
fn state_1_begins_at_x_1_4_whatever_y() {
    let csv = regions_csv(&regions(), ["x_m", "y"], &state_name);
    assert_eq!(csv.lines().next(), Some("x_m,y,label_a,label_b,polyline"), "the head");
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    assert!(rows.len() > 1, "a boundary has two ends: {csv}");
    for row in rows {
        assert_eq!(row[2..], ["0", "1", "0"], "one boundary, between the two");
        near(row[0].parse().unwrap(), 0.25, LOCATED);
    }
}

/// The page of a study of 100 drops, of which 75 end as wanted.
fn page_of_a_yield(quantities: &[YieldQuantity], worst: &[YieldWorst]) -> String {
    let share = Estimate { share: 0.75, low: 0.65, high: 0.83, count: 75 };
    let found = &Yield {
        wanted: share,
        kept: share,
        endings: vec![],
        transitions: vec![],
        recirculation: None,
        plates: vec![],
        time: None,
        worst: vec![],
        drops: 100,
    };
    yield_report(&YieldFigure {
        motion: "plane motion",
        title: "a feeder",
        wanted: "turned",
        limited: false,
        plate: "lower",
        plates: &[],
        found,
        deciders: Err("not asked"),
        laws: &[],
        drawn: Ending::Stays,
        law: Law::Poisson,
        quantities,
        worst,
        notes: &[],
        live: false,
        source: "",
        made_by: "",
    })
}

#[test]
fn what_varies_is_a_row_with_its_tolerance() {
    let (path, middle) = ("plate.slope".to_owned(), "10 deg".to_owned());
    let quantity = YieldQuantity { path, middle, tolerance: "± 0.5 deg".to_owned() };
    shows(&page_of_a_yield(&[quantity], &[]), &["plate.slope</th><td>10 deg</td><td>± 0.5 deg</td>"]);
}

#[test]
fn a_drop_to_look_at_is_told_with_its_strike() {
    let (ending, impact_speed) = ("same".to_owned(), Some(1.25));
    let worst = YieldWorst { ending, impact_speed, ..YieldWorst::default() };
    shows(&page_of_a_yield(&[], &[worst]), &["<h3>Same <small>strikes at 1.250 m/s</small></h3>"]);
}

#[test]
fn of_100_drops_75_end_as_wanted() {
    shows(&page_of_a_yield(&[], &[]), &["<strong>75.00 %</strong> end as wanted", "<dd>25.00 %"]);
}
