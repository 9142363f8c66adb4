//! Names of plates and walls, and of the features of a part.

use carom_feeder::spatial::{self, CrossSection};
use carom_feeder::{Feeder, PartKind};
use carom_motion::planar::Feature;
use carom_motion::spatial::Touch;
use carom_num::Vec2;

/// A feeder, in the plane or in space, as far as words name what stands in it.
pub trait Names {
    /// What of the part touches what of a plate or wall.
    type Feature;
    /// The name that a plate or wall was given: plates first, then walls.
    fn given(&self, obstacle: usize) -> &str;
    /// How many plates there are.
    fn plate_count(&self) -> usize;
    /// The name of the part's share of a feature, as the part lay at the start.
    fn part_of(&self, feature: &Self::Feature) -> String;
    /// True where a face of the part lies over the end of a plate.
    fn is_over_end(&self, feature: &Self::Feature) -> bool;
}

impl Names for Feeder {
    type Feature = Feature;

    fn given(&self, obstacle: usize) -> &str {
        self.obstacle_name(obstacle)
    }

    fn plate_count(&self) -> usize {
        self.plates.len()
    }

    /// A rod has a front, its downhill end, and a rear; a box has two corners at each, those of the face that was down and `top` ones. A
    /// polygon's corners and every part's faces go by number.
    fn part_of(&self, feature: &Feature) -> String {
        match (self.part.kind, *feature) {
            (PartKind::Disc, _) => "rim".to_owned(),
            (_, Feature::FaceOnEnd { face, .. }) => format!("face {face}"),
            (_, Feature::VertexOnFace { vertex, .. } | Feature::VertexOnEnd { vertex, .. }) => {
                corner(self, vertex)
            }
        }
    }

    fn is_over_end(&self, feature: &Feature) -> bool {
        matches!(feature, Feature::FaceOnEnd { .. })
    }
}

impl Names for spatial::Feeder {
    type Feature = Touch;

    fn given(&self, obstacle: usize) -> &str {
        self.obstacle_name(obstacle)
    }

    fn plate_count(&self) -> usize {
        self.plates.len()
    }

    /// Corners and faces go by their numbers, edges by those of the corners at their ends.
    fn part_of(&self, feature: &Touch) -> String {
        match *feature {
            Touch::Point { point, .. }
            | Touch::PointOnEdge { point, .. }
            | Touch::PointOnCorner { point, .. } => format!("corner {point}"),
            Touch::Face { face, .. } => match face.checked_sub(self.part.faces.len()) {
                None => format!("face {face}"),
                Some(inner) => format!("face {inner} in a hollow"),
            },
            Touch::Edge { ends: [a, b], .. } | Touch::EdgeOnCorner { ends: [a, b], .. } => {
                format!("edge {a}–{b}")
            }
        }
    }

    fn is_over_end(&self, feature: &Touch) -> bool {
        matches!(feature, Touch::Face { .. })
    }
}

/// The name of an obstacle for a person: `plate 1`, `wall 2`, counted from 1, where it has no name of its own but its number.
pub fn obstacle(feeder: &impl Names, obstacle: usize) -> String {
    let name = feeder.given(obstacle);
    let (kind, number) = match obstacle.checked_sub(feeder.plate_count()) {
        None => ("plate", obstacle),
        Some(wall) => ("wall", wall),
    };
    if name == number.to_string() { format!("{kind} {}", number + 1) } else { name.to_owned() }
}

/// The name of the part's share of a pair of features, as it lay at the start: `front`, `rear`, `front top`, `corner 2`, `face 0`, `rim`, `edge 2–5`.
pub fn feature<N: Names>(feeder: &N, feature: N::Feature) -> String {
    feeder.part_of(&feature)
}

fn corner(feeder: &Feeder, vertex: usize) -> String {
    let shape = &feeder.part.body.shape;
    let number = || format!("corner {vertex}");
    let named = matches!(feeder.part.kind, PartKind::Rod | PartKind::Box);
    let (Some((_, downhill)), Some(corner)) = (feeder.start_place(), shape.vertices().get(vertex)) else {
        return number();
    };
    if !named || feeder.start.face >= shape.faces() {
        return number();
    }
    let turn = Vec2::at_angle(feeder.start_state().pose.angle);
    let ahead = corner.rotated(turn.x, turn.y).dot(downhill) > 0.0;
    let end = if ahead { "front" } else { "rear" };
    let down = shape.face_normal(feeder.start.face);
    let top = feeder.part.kind == PartKind::Box && corner.dot(down) < 0.0;
    if top { format!("{end} top") } else { end.to_owned() }
}

/// What stands along the sides of a plate in space, or how its groove opens, for a table; `length` and `angle` write values \[m, rad\].
pub fn sides(
    plate: &spatial::Plate,
    length: impl Fn(f64) -> String,
    angle: impl Fn(f64) -> String,
) -> String {
    match plate.cross_section {
        CrossSection::Groove { angle: open } => format!("V {}", angle(open)),
        CrossSection::Walled { height } => format!("walls {}", length(height)),
        CrossSection::Flat => "–".to_owned(),
    }
}
