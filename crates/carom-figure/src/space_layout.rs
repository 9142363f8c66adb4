//! The layout of a feeder in space, seen from the side: its drawing, with the solid part as it lies at the start.

use crate::draft::Draft;
use crate::layout::laid_out;
use crate::markup::{Markup, document, html, joined};
use crate::svg;
use crate::tolerance::{EDGE_ON, LEAST_SHEET};
use crate::view::View;
use carom_feeder::spatial::{Feeder, Shown, WallForm};
use carom_feeder::{Form, Part, PartKind, Plate, Start, Wall};
use carom_motion::planar::{Body, Shape};
use carom_num::{Vec2, Vec3};

/// The layout as a stand-alone SVG drawing to scale, as [`layout_svg`](crate::layout_svg) draws one in the plane: plates and walls across the drawing by their lines, with slopes and measures,
/// round pins as they are seen,
/// and the part at the start with those of its faces that look towards the viewer. The face that is down is marked. Walls beside the drawing are not to be seen from there; a plate that is rolled is
/// drawn by its middle line.
///
/// # Example
/// Of a bar that lies along the drawing one face is to be seen, and the mark on the face below it.
/// ```
/// let feeder = carom_feeder::spatial::examples::two_plates();
/// let layout = carom_figure::space_layout_svg(&feeder, &carom_figure::Draft::default());
/// assert!(layout.starts_with("<svg") && layout.matches("class=\"mark\"").count() == 1);
/// ```
pub fn space_layout_svg(feeder: &Feeder, draft: &Draft) -> String {
    let Some(drawing) = drawing(feeder) else { return String::new() };
    document(laid_out(&drawing, None, draft, true, |view, _| part(feeder, view)))
}

/// A round bar as it is seen from the side: as long as it looks, its ends half round; a bar across the drawing as a circle.
fn seen_pin(wall: &carom_feeder::spatial::Wall, ends: [Vec3; 2], radius: f64) -> Option<Wall> {
    let [from, to] = ends.map(|end| Vec2::new(end.x, end.y));
    // What has no length on the drawing has the least that a sheet has.
    let along = (to - from).unit().unwrap_or(Vec2::new(1.0, 0.0)) * (radius * LEAST_SHEET);
    Some(Wall {
        name: wall.name.clone(),
        from: from - along,
        to: to + along,
        friction: wall.friction,
        restitution: wall.restitution,
        form: Form { edge_radius: radius, ..Form::default() },
    })
}

/// What the drawing shows of the feeder but for its part, in whose place there is a disc as large; `None` of a part without a size.
fn drawing(feeder: &Feeder) -> Option<carom_feeder::Feeder> {
    let plates = feeder.plates.iter().map(|plate| Plate {
        name: plate.name.clone(),
        uphill: plate.uphill,
        edge: plate.edge,
        friction: plate.friction,
        restitution: plate.restitution,
        unbounded: plate.unbounded,
        form: Form { edge_radius: plate.edge_radius, ..Form::default() },
    });
    let walls = feeder.walls.iter().filter_map(|wall| match wall.form {
        WallForm::Beside { .. } => None,
        WallForm::Pin { ends, radius } => seen_pin(wall, ends, radius),
        WallForm::Across { from, to, edge_radius } => Some(Wall {
            name: wall.name.clone(),
            from,
            to,
            friction: wall.friction,
            restitution: wall.restitution,
            form: Form { edge_radius, ..Form::default() },
        }),
    });
    // The disc only makes room for the part in the view: it is not drawn.
    let (mass, reach) = (feeder.part.body.mass(), feeder.part.body.reach());
    let shape = Shape::new(vec![Vec2::ZERO], reach).ok()?;
    let part = Part { kind: PartKind::Disc, body: Body { shape, mass, inertia: mass * reach * reach } };
    let start = Start { to_edge: feeder.start.to_edge, speed: feeder.start.speed, face: 0 };
    Some(carom_feeder::Feeder {
        gravity: feeder.gravity,
        stop: feeder.stop,
        law: feeder.law,
        part,
        start,
        plates: plates.collect(),
        walls: walls.collect(),
    })
}

/// The faces of the part that look towards the viewer, where it lies at the start, the face that is down, and the mass centre.
fn part(feeder: &Feeder, view: &View) -> Markup {
    let state = feeder.start_state();
    let Shown { corners, faces, numbers, seams } = feeder.part.shown();
    let middle = Vec2::new(state.centre.x, state.centre.y);
    let seen: Vec<Vec2> =
        corners.iter().map(|corner| state.place(*corner)).map(|r| Vec2::new(r.x, r.y)).collect();
    let outline = |face: &Vec<usize>| {
        let mut data = String::new();
        face.iter().for_each(|corner| svg::to(&mut data, svg::xy(view.at(seen[*corner]))));
        data + "Z"
    };
    let least = EDGE_ON * feeder.part.body.reach() * feeder.part.body.reach();
    // Corners run counter-clockwise as seen from outside.
    let is_towards = |face: &&Vec<usize>| {
        let next = face.iter().cycle().skip(1);
        face.iter().zip(next).map(|(a, b)| (seen[*a] - middle).cross(seen[*b] - middle)).sum::<f64>() > least
    };
    let drawn = |face: &Vec<usize>| {
        let sides = face.iter().zip(face.iter().cycle().skip(1)).map(|(a, b)| [*a, *b]);
        let edges: Vec<[usize; 2]> = sides.filter(|side| !seams.contains(side)).collect();
        if edges.len() == face.len() {
            return svg::path("body", &outline(face));
        }
        let lines = edges
            .iter()
            .map(|[a, b]| svg::line("body", svg::xy(view.at(seen[*a])), svg::xy(view.at(seen[*b]))));
        html! { (svg::path("body filled", &outline(face))) (joined(lines)) }
    };
    let shown = faces.iter().filter(is_towards).map(drawn);
    let down = faces.iter().zip(&numbers).filter(|(_, number)| **number == feeder.start.face);
    let down = down.map(|(face, _)| svg::path("mark", &outline(face)));
    let centre = view.at(middle);
    html! {
        g class="ghost stage" { (joined(shown)) (joined(down)) }
        (svg::circle("centre", svg::xy(centre), 2.6))
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use carom_feeder::spatial::examples::two_plates;

    #[test]
    fn a_bar_that_is_turned_shows_two_sides() {
        let mut feeder = two_plates();
        let faces =
            |feeder: &Feeder| space_layout_svg(feeder, &Draft::default()).matches("class=\"body\"").count();
        feeder.start.turn = 0.0;
        assert_eq!(faces(&feeder), 1, "the front: all others are edge on or behind it");
        feeder.start.turn = 0.4;
        assert_eq!(faces(&feeder), 2, "the front and an end: the upper side is edge on");
    }

    #[test]
    fn walls_beside_the_drawing_are_left_out_and_plates_stay_where_they_are() {
        let mut feeder = two_plates();
        let wall = |name: &str, form| carom_feeder::spatial::Wall {
            name: name.to_owned(),
            form,
            friction: 0.0,
            restitution: 0.0,
        };
        feeder.walls = vec![
            wall(
                "stop",
                WallForm::Across { from: Vec2::new(0.1, 0.0), to: Vec2::new(0.1, -0.3), edge_radius: 0.0 },
            ),
            wall("front wall", WallForm::Beside { z: 0.1 }),
        ];
        let flat = drawing(&feeder).unwrap();
        assert_eq!((flat.walls.len(), flat.walls[0].name.as_str()), (1, "stop"));
        for (own, plate) in flat.plates.iter().zip(&feeder.plates) {
            assert_eq!((own.uphill, own.edge), (plate.uphill, plate.edge), "{}", plate.name);
        }
    }
}
