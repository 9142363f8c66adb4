//! The plates and walls of a feeder in space as they are drawn: cut to what is near the way of the part.

use crate::solid::SolidPlate;
use carom_feeder::spatial::{Feeder, Wall, WallForm};
use carom_num::{Vec2, Vec3};
use carom_words::part;

/// Reaches of the part, and shares of the way's length, that are shown beyond the way.
const BEYOND: (f64, f64) = (1.5, 0.12);
/// Lengths of the way from it at which a plate is still shown that the part does not come to.
const NEAR: f64 = 1.5;

/// A box along the axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Region {
    low: Vec3,
    high: Vec3,
}

impl Region {
    /// About places.
    fn of(places: impl Iterator<Item = Vec3>) -> Option<Self> {
        places.filter(|place| place.is_finite()).fold(None, |region: Option<Self>, place| {
            Some(region.map_or(Self { low: place, high: place }, |region| region.with(place)))
        })
    }

    fn with(self, place: Vec3) -> Self {
        let each =
            |of: fn(f64, f64) -> f64, a: Vec3, b: Vec3| Vec3::new(of(a.x, b.x), of(a.y, b.y), of(a.z, b.z));
        Self { low: each(f64::min, self.low, place), high: each(f64::max, self.high, place) }
    }

    fn widened(self, by: f64) -> Self {
        let by = Vec3::new(by, by, by);
        Self { low: self.low - by, high: self.high + by }
    }

    /// The place of it that is nearest.
    fn nearest(&self, to: Vec3) -> Vec3 {
        let within = |x: f64, low: f64, high: f64| x.max(low).min(high);
        let (low, high) = (self.low, self.high);
        Vec3::new(within(to.x, low.x, high.x), within(to.y, low.y, high.y), within(to.z, low.z, high.z))
    }

    /// Its sides as planes: a normal, inwards, and the offset from which on it is inside.
    fn sides(&self) -> [(Vec3, f64); 6] {
        let (low, high) = (self.low, self.high);
        [
            (Vec3::X, low.x),
            (-Vec3::X, -high.x),
            (Vec3::Y, low.y),
            (-Vec3::Y, -high.y),
            (Vec3::Z, low.z),
            (-Vec3::Z, -high.z),
        ]
    }
}

/// The plates and walls near a way, each side that is cut marked; and the names of those that are too far to be shown.
pub(crate) fn near(feeder: &Feeder, way: impl Iterator<Item = Vec3>) -> (Vec<SolidPlate>, Vec<String>) {
    let size = feeder.part.body.reach();
    let Some(own) = Region::of(way) else { return (vec![], vec![]) };
    let long = (own.high - own.low).norm();
    let beyond = BEYOND.0 * size + BEYOND.1 * long;
    let mut region = own.widened(beyond);
    // A plate that is missed is shown too: where it comes nearest.
    for plate in &feeder.plates {
        let ends = [plate.uphill, plate.edge].map(flat);
        let nearest = nearest_on(ends, |place| (region.nearest(place) - place).norm());
        if (own.nearest(nearest) - nearest).norm() <= NEAR * long.max(size) {
            region = region
                .with(nearest + (ends[0] - nearest).unit().unwrap_or(Vec3::ZERO) * beyond)
                .with(nearest);
        }
    }
    let (mut shown, mut far) = (vec![], vec![]);
    for (owner, polygons) in outlines(feeder, size, region).into_iter().enumerate() {
        let name = part::obstacle(feeder, owner);
        let before = shown.len();
        for corners in polygons {
            let Some((corners, cut)) = cut(&corners, &region) else { continue };
            let name = if shown.len() == before { name.clone() } else { String::new() };
            shown.push(SolidPlate { name, corners, cut });
        }
        if shown.len() == before {
            far.push(name);
        }
    }
    (shown, far)
}

fn flat(at: Vec2) -> Vec3 {
    Vec3::new(at.x, at.y, 0.0)
}

/// Of a few places along a line the one with the least distance.
fn nearest_on([from, to]: [Vec3; 2], distance: impl Fn(Vec3) -> f64) -> Vec3 {
    let places = (0..=16_u32).map(|i| from + (to - from) * (f64::from(i) / 16.0));
    places.min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or(from)
}

/// The polygons of every plate and wall: a sheet, then the walls along its sides.
fn outlines(feeder: &Feeder, size: f64, region: Region) -> Vec<Vec<Vec<Vec3>>> {
    let plates = feeder.plates.iter().map(|plate| plate.polygons(size));
    plates.chain(feeder.walls.iter().map(|wall| wall_outline(wall, region))).collect()
}

/// A wall, a little larger than what is shown where it has no end.
fn wall_outline(wall: &Wall, region: Region) -> Vec<Vec<Vec3>> {
    let Region { low, high } = region.widened((region.high - region.low).norm());
    match wall.form {
        WallForm::Across { .. } | WallForm::Pin { .. } => wall.polygons(low.z.abs().max(high.z.abs())),
        WallForm::Beside { z } => {
            let corners = [(low.x, low.y), (high.x, low.y), (high.x, high.y), (low.x, high.y)];
            vec![corners.map(|(x, y)| Vec3::new(x, y, z)).to_vec()]
        }
    }
}

/// A polygon within a region, with the sides that lie along the cut; `None` where nothing of it is inside.
fn cut(corners: &[Vec3], region: &Region) -> Option<(Vec<Vec3>, Vec<bool>)> {
    let mut outline: Vec<(Vec3, bool)> = corners.iter().map(|corner| (*corner, false)).collect();
    for (normal, offset) in region.sides() {
        let depth = |place: Vec3| normal.dot(place) - offset;
        let mut left = vec![];
        for (i, (from, open)) in outline.iter().enumerate() {
            let (to, _) = outline[(i + 1) % outline.len()];
            let [before, after] = [depth(*from), depth(to)];
            let crossing = *from + (to - *from) * (before / (before - after));
            if before >= 0.0 {
                left.push((*from, *open));
            }
            match (before >= 0.0, after >= 0.0) {
                (true, false) => left.push((crossing, true)),
                (false, true) => left.push((crossing, *open)),
                _ => {}
            }
        }
        outline = left;
    }
    (outline.len() > 2).then(|| outline.into_iter().unzip())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_that_reaches_out_of_the_region_on_one_side_is_cut_there_alone() {
        let region = Region { low: Vec3::new(-1.0, -1.0, -1.0), high: Vec3::new(1.0, 1.0, 1.0) };
        let at = |x: f64, z: f64| Vec3::new(x, 0.0, z);
        let (corners, sides) =
            cut(&[at(-0.5, -0.5), at(3.0, -0.5), at(3.0, 0.5), at(-0.5, 0.5)], &region).unwrap();
        assert_eq!(corners, [at(-0.5, -0.5), at(1.0, -0.5), at(1.0, 0.5), at(-0.5, 0.5)]);
        assert_eq!(sides, [false, true, false, false]);
        assert!(
            cut(&[at(2.0, 0.0), at(3.0, 0.0), at(3.0, 1.0)], &region).is_none(),
            "nothing of it is inside"
        );
    }

    #[test]
    fn plates_as_wide_as_needed_are_cut_to_the_way_and_what_has_ends_is_not() {
        let mut feeder = carom_feeder::spatial::examples::two_plates();
        feeder.plates[1].width = Some(0.04);
        let way = [Vec3::new(-0.1, 0.03, 0.0), Vec3::new(0.0, -0.1, 0.0)];
        let (shown, far) = near(&feeder, way.into_iter());
        assert!(far.is_empty() && shown.len() == 2, "{far:?}");
        assert!(shown[0].corners.iter().all(|corner| corner.z.abs() < 0.1), "{:?}", shown[0]);
        assert_eq!(
            shown[0].cut.iter().filter(|is| **is).count(),
            3,
            "uphill and to both sides: {:?}",
            shown[0]
        );
        assert!(
            shown[1].corners.iter().all(|corner| (corner.z.abs() - 0.02).abs() < 1e-12),
            "{:?}",
            shown[1]
        );
    }
}
