#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use super::*;
use carom_feeder::Plate;

const FINE: Snap = Snap { length: 1e-7, angle: 1e-7 };

fn example(name: &str) -> Scene {
    Scene::read(format!("../../examples/{name}.toml").as_ref()).unwrap()
}

/// A plate with both of its ends, held at one of them or in the middle.
fn held(plate: &Plate, index: usize, hold: Hold) -> Grip {
    let ends = [plate.uphill, plate.edge];
    let at = match hold {
        Hold::First => ends[0],
        Hold::Middle => (ends[0] + ends[1]) * 0.5,
        Hold::Last => ends[1],
    };
    Grip::Obstacle { index, ends, cut: [false; 2], hold, at }
}

fn redrawn(scene: &Scene, grip: &Grip, to: Vec2, snap: Snap) -> Scene {
    Scene::parse("dragged.toml", &scene.dragged(grip, to, snap).unwrap()).unwrap()
}

#[test]
fn a_line_goes_through_the_pointer_and_keeps_its_slope() {
    let scene = example("case_2");
    let plate = &scene.feeder().plates[1];
    let along = (plate.edge - plate.uphill).unit().unwrap();
    let foot = plate.uphill + along * (-plate.uphill).dot(along);
    let ends = [foot - along * 0.2, foot + along * 0.2];
    let grip = Grip::Obstacle { index: 1, ends, cut: [true; 2], hold: Hold::Middle, at: foot };
    let to = foot + Vec2::new(0.01, 0.03);
    let now = redrawn(&scene, &grip, to, FINE).feeder().plates[1].clone();
    let turned = (now.edge - now.uphill).unit().unwrap().cross(along);
    let off = (to - now.uphill).cross((now.edge - now.uphill).unit().unwrap());
    assert!(turned.abs() < 1e-5 && off.abs() < 1e-6, "turned by {turned}, off by {off} m");
}

#[test]
fn a_plate_that_is_hinged_at_a_wall_keeps_its_length_and_slope_when_it_is_moved_down() {
    let scene = example("designer");
    let plate = scene.feeder().plates[1].clone();
    let grip = held(&plate, 1, Hold::Middle);
    let down = Vec2::new(0.0, -0.02);
    let now =
        redrawn(&scene, &grip, (plate.uphill + plate.edge) * 0.5 + down, FINE).feeder().plates[1].clone();
    let moved = [now.uphill - plate.uphill, now.edge - plate.edge];
    assert!(moved.iter().all(|moved| (*moved - down).norm() < 1e-5), "{moved:?}");
}

#[test]
fn a_free_edge_that_is_dragged_leaves_the_other_end_where_it_is() {
    let scene = example("designer");
    let plate = scene.feeder().plates[1].clone();
    let grip = held(&plate, 1, Hold::Last);
    let to = plate.edge + Vec2::new(0.0, -0.01);
    let now = redrawn(&scene, &grip, to, FINE).feeder().plates[1].clone();
    let off = [(now.uphill - plate.uphill).norm(), (now.edge - to).norm()];
    assert!(off[0] < 1e-4 && off[1] < 2e-3, "{off:?}");
}

#[test]
fn values_snap_to_round_numbers_and_tolerances_stay() {
    let scene = example("designer");
    let plate = scene.feeder().plates[0].clone();
    let snap = Snap { length: 1e-3, angle: 0.5_f64.to_radians() };
    let grip = held(&plate, 0, Hold::Last);
    let text = scene.dragged(&grip, plate.edge + Vec2::new(0.003, -0.02), snap).unwrap();
    let now = Scene::parse("dragged.toml", &text).unwrap();
    for (old, new) in scene.quantities().into_iter().zip(now.quantities()) {
        assert_eq!(old.tolerance.is_some(), new.tolerance.is_some(), "{}", old.path);
        let shown = if new.kind.dimension == Dimension::Angle {
            2.0 * new.value.to_degrees()
        } else {
            1e3 * new.value
        };
        let moved = (old.value - new.value).abs() > 1e-12;
        assert!(!moved || (shown - shown.round()).abs() < 1e-9, "{}: {shown}", new.path);
    }
}
