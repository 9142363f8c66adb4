//! The JSON of a run, made by hand.

use carom_feeder::{
    Decided, Effort, Landing, Outcome, PartKind, Run, Stage, StageEnd, StageName, Touch, Verdict,
};
use carom_impact::Law;
use carom_impact::planar::{ContactState, ImpactType};
use carom_motion::planar::trace::{ContactVelocity, Impact, ImpactContact, Trace};
use carom_motion::planar::{Feature, Obstacle, Pose, State, Twist};
use carom_num::{Vec2, elementary::sin_cos};
use carom_scene::{Limit, LimitEnd, RunReport, Scene};
use std::f64::consts::PI;
use std::path::Path;

fn example(name: &str) -> Scene {
    Scene::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name)).unwrap()
}

/// The front of case 1's rod strikes the lower plate when it has turned by 41° from the upper one.
fn strike(scene: &Scene) -> Impact {
    let angle = (-15.0 - 41.0) * PI / 180.0;
    let plate = &scene.feeder().plates[1];
    let normal = (plate.edge - plate.uphill).unit().unwrap().turned_right();
    let centre = Vec2::new(0.1, -0.1);
    Impact {
        time: 0.5929,
        pose: Pose { centre, angle },
        before: Twist { velocity: Vec2::new(0.5, -1.4), spin: -5.5 },
        after: Twist { velocity: Vec2::new(0.1, -0.2), spin: 10.8 },
        law: Law::Poisson,
        kind: Some(ImpactType::ReversesInCompression),
        without_approach: false,
        branches: 1,
        open_share: false,
        contacts: vec![ImpactContact {
            obstacle: 1,
            feature: Feature::VertexOnFace { vertex: 1, face: Obstacle::RIGHT },
            point: centre + Vec2::at_angle(angle) * 0.05,
            normal,
            friction: 0.15,
            restitution: 0.0,
            // Slip along the tangent, which points uphill here.
            before: ContactVelocity { slip: -0.133, normal: -1.593 },
            after: ContactVelocity { slip: 0.465, normal: 0.0 },
            state: ContactState::Slips,
            normal_impulse: 0.3965,
            tangential_impulse: 0.0512,
            normal_work: -0.3,
            tangential_work: -0.01,
        }],
        stages: vec![],
        energy_before: 0.34,
        energy_after: 0.02,
        gained_energy: false,
        restitution_scaled: 1.0,
        holding_would_need: Some(-6.27),
    }
}

fn run(scene: &Scene) -> Run {
    let state = State { pose: scene.feeder().start_state().pose, twist: Twist::default() };
    let feature = Feature::VertexOnFace { vertex: 0, face: Obstacle::LEFT };
    Run {
        outcome: Outcome::Landed,
        end_time: 0.6847,
        landings: vec![Landing {
            plate: 1,
            verdict: Some(Verdict::Same),
            turned_here: Some(false),
            face: Some(0),
            first_touch: 0.5929,
            flat: Some(0.6847),
            impact_speed: 1.593,
            max_impact_speed: 1.593,
            max_sliding_speed: 0.465,
        }],
        walls_touched: vec![],
        exit: None,
        margin: 0.05,
        margin_of: Decided::Impact { time: 0.5929 },
        jam: None,
        missed_by: None,
        effort: Effort { rhs_evaluations: 120, events: 6, impacts: 2, ..Effort::default() },
        stages: vec![Stage {
            name: StageName::Slide,
            obstacle: Some(0),
            start_time: 0.0,
            end_time: 0.423,
            start: state,
            end: state,
            ended_by: StageEnd::CentreAtEdge(Touch { obstacle: 0, feature }),
            pieces: 0..1,
        }],
        trace: Trace { pieces: vec![], impacts: vec![strike(scene)], accumulations: vec![(0.7, 0.71)] },
    }
}

#[test]
fn the_json_of_a_run_has_the_keys_that_are_promised() {
    let scene = example("case_1.toml");
    let ends = [(0.055, LimitEnd::Flips), (19.2, LimitEnd::EndOfSearch)];
    let limits = vec![Limit::new("contact.friction", ends)];
    let report = RunReport::new(&scene, &run(&scene), Some(limits));
    insta::assert_snapshot!(serde_json::to_string_pretty(&report).unwrap());
}

#[test]
fn the_angle_to_the_normal_is_the_papers() {
    let scene = example("case_1.toml");
    let impact = strike(&scene);
    let report = RunReport::new(&scene, &run(&scene), None);
    let found = report.impacts[0].angle_to_normal_rad.unwrap() * 180.0 / PI;
    // φ_K = φ + β − 90° with φ = 41° and β = atan(0.2/0.347).
    let beta = carom_num::elementary::atan2(0.2, 0.347) * 180.0 / PI;
    assert!((found - (41.0 + beta - 90.0)).abs() < 1e-10, "{found}");
    let incidence = report.impacts[0].incidence_rad.unwrap();
    let (sin, cos) = sin_cos(incidence);
    assert!(sin > 0.0 && cos > 0.0, "the corner moves downhill and in: {impact:?}");
}

#[test]
fn features_are_named_as_they_lay_at_the_start() {
    let touch = |vertex| Feature::VertexOnFace { vertex, face: Obstacle::LEFT };
    let names = |scene: &Scene| -> Vec<String> {
        let corners = scene.feeder().part.body.shape.vertices().len();
        (0..corners).map(|vertex| carom_words::part::feature(scene.feeder(), touch(vertex))).collect()
    };
    assert_eq!(names(&example("case_1.toml")), ["rear", "front"]);
    assert_eq!(names(&example("case_1_box.toml")), ["rear", "front", "front top", "rear top"]);
    assert_eq!(names(&example("disc.toml")), ["rim"]);
    assert_eq!(names(&example("hexagon.toml"))[2], "corner 2");
    let text = example("case_1.toml").source().replace("downhill = \"left\"\n", "");
    let left = text.replace("name  = \"upper\"", "name = \"upper\"\ndownhill = \"left\"");
    let left = Scene::parse("left.toml", &left).unwrap();
    assert_eq!(names(&left), ["front", "rear"]);
}

#[test]
fn a_polygon_is_judged_by_its_face() {
    let scene = example("hexagon.toml");
    assert_eq!(scene.feeder().part.kind, PartKind::Polygon);
    let mut run = run(&example("case_1.toml"));
    run.landings[0].face = Some(4);
    let report = RunReport::new(&scene, &run, None);
    let json = serde_json::to_value(&report).unwrap();
    assert_eq!(json["plates"][0]["verdict"], 4);
}

#[test]
fn what_is_wanted_is_held_against_the_run() {
    let scene = example("designer.toml");
    let mut run = run(&example("case_1.toml"));
    assert!(!scene.wanted(&run)[0].met, "the same side is not turned");
    run.landings[0].verdict = Some(Verdict::Turned);
    let wanted = scene.wanted(&run);
    assert_eq!((wanted.len(), wanted[0].plate.as_str(), wanted[0].met), (1, "lower", true));
    run.landings.clear();
    assert!(!scene.wanted(&run)[0].met, "it never lay flat there");
}
