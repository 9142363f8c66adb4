//! Whole drops: a thin box slides down a plate, tips, falls on another one and comes to lie on one of its sides.

use super::named;
use crate::case::{Case, Expected, Known, PartOfDrop, Place, PlateOfDrop, World};
use crate::tolerance::AGREES;
use carom_feeder::{Feeder, Verdict};
use carom_scene::{Scene, toml_of_json};
use serde_json::{Value, json};

/// The paper's rod [kg m²].
const INERTIA: f64 = 0.000_25;
/// Slopes of the lower plate [deg], and how far it lies below the upper one's edge [m].
const SLOPES: [f64; 7] = [2.0, 8.0, 14.0, 20.0, 26.0, 32.0, 38.0];
const DEPTHS: [f64; 9] = [0.12, 0.16, 0.2, 0.24, 0.28, 0.32, 0.36, 0.4, 0.44];

pub(super) fn cases() -> Vec<Case> {
    let all = SLOPES.iter().flat_map(|slope| DEPTHS.iter().map(move |depth| scene(*slope, *depth)));
    all.enumerate().filter_map(|(i, scene)| case(named("drop", i), scene)).collect()
}

/// The paper's feeder with another lower plate.
fn scene(slope_deg: f64, depth: f64) -> Value {
    let lower = json!({ "name": "lower", "downhill": "left", "slope": format!("{slope_deg} deg"),
        "below": { "x": 0.0, "y": -depth } });
    json!({
        "part": { "shape": "box", "length": 0.1, "height": 0.001, "mass": 0.3, "inertia": INERTIA },
        "contact": { "friction": 0.15, "restitution": 0.0 },
        "start": { "to_edge": 0.1 },
        "plate": [{ "name": "upper", "slope": "10 deg" }, lower],
    })
}

fn case(name: String, scene: Value) -> Option<Case> {
    let text = toml_of_json(&name, &scene.to_string()).ok()?;
    let read = Scene::parse(&name, &text).ok()?;
    let run = read.feeder().run_untraced().ok()?;
    let verdict = run.final_landing()?.verdict?;
    let known =
        Known { by: "Carom's run".to_owned(), bodies: vec![], verdict: Some(said(verdict)?.to_owned()) };
    Some(Case {
        case: name,
        group: "drop".to_owned(),
        impact: None,
        scene: Some(scene),
        world: Some(world(read.feeder())),
        expected: Expected { answers: vec![known], others: vec![] },
        tolerance: AGREES,
        source: "Carom's run of the scene; 98 such drops are judged alike by an independent event-driven solution (bench/peers)"
            .to_owned(),
    })
}

/// The verdict as `carom run` says it; `None` for a part that is told by its face.
fn said(verdict: Verdict) -> Option<&'static str> {
    match verdict {
        Verdict::Same => Some("same"),
        Verdict::Turned => Some("turned"),
        Verdict::Face(_) => None,
    }
}

/// A feeder laid out.
fn world(feeder: &Feeder) -> World {
    let (body, start) = (&feeder.part.body, feeder.start_state());
    let plates = feeder.plates.iter().map(|plate| PlateOfDrop {
        name: plate.name.clone(),
        uphill_m: [plate.uphill.x, plate.uphill.y],
        edge_m: [plate.edge.x, plate.edge.y],
        friction: plate.friction,
        restitution: plate.restitution,
    });
    World {
        gravity_m_s2: feeder.gravity,
        part: PartOfDrop {
            corners_m: body.shape.vertices().iter().map(|corner| [corner.x, corner.y]).collect(),
            mass_kg: body.mass,
            inertia_kg_m2: body.inertia,
            start: Place {
                position_m: [start.pose.centre.x, start.pose.centre.y],
                angle_rad: start.pose.angle,
            },
        },
        plates: plates.collect(),
    }
}
