//! What a plate or wall looks like beside a thin straight segment: its course, and the radius of its edges.

use crate::feeder::{Plate, Wall};
use carom_motion::planar::{ChainPoint, Shape};
use carom_num::Vec2;
use carom_num::elementary::{atan2, sin, sin_cos};
use std::f64::consts::PI;

use crate::tolerance::SMOOTH_BEND;

/// What a plate or wall looks like: straight, thin and sharp unless it says otherwise.
///
/// # Example
/// A plate that is straight and thin needs no more than its two ends.
/// ```
/// assert!(carom_feeder::Form::default().is_plain());
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Form {
    /// Its course from one end to the other [m, world frame], the ends included: segments and arcs. Empty where it is straight.
    pub course: Vec<ChainPoint>,
    /// Radius of its edges [m]; 0 where it is thin and its edges are sharp. A plate with a radius is a sheet twice as thick below its drawn upper
    /// side, and each of its ends is half a circle that reaches as far as drawn. Of a wall the drawn line is the middle of the sheet. A rod without thickness
    /// meets a bent plate or wall without one as if this were a millionth of the rod's size.
    pub edge_radius: f64,
}

/// An arc of a plate or wall, as a drawing measures it.
///
/// # Example
/// The free edge of a level plate of 1 m, 20 mm thick: half a circle that ends where the plate is drawn to end, below its upper side.
/// ```
/// use {carom_feeder::{Form, Plate}, carom_num::Vec2};
/// let (uphill, edge, form) = (Vec2::ZERO, Vec2::new(1.0, 0.0), Form { edge_radius: 0.01, ..Form::default() });
/// let (friction, restitution, unbounded) = (0.2, 0.5, false);
/// let plate = Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded, form };
/// let free = plate.arcs()[0];
/// assert_eq!((free.centre, free.middle, free.uphill), (Vec2::new(0.99, -0.01), Vec2::new(1.0, -0.01), false));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FormArc {
    /// Its centre [m].
    pub centre: Vec2,
    /// The point in its middle [m].
    pub middle: Vec2,
    /// True for a bend of the course, false for an edge.
    pub bend: bool,
    /// True for the edge at the uphill end of a plate, or at the first end of a wall.
    pub uphill: bool,
}

/// On which side of the drawn line a sheet has its thickness, seen along the line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Thick {
    Left,
    Right,
    Both,
}

/// Why a form makes no shape.
pub(crate) type FormProblem = &'static str;

const TOO_ROUND: FormProblem =
    "its edge radius must be less than half of its first and last stretch, and of the radius of each bend";
const KINKED: FormProblem = "a sheet with an edge radius needs smooth joints between its arcs and segments, to 0.00001 rad: bend_radius makes such joints";
const NO_CHAIN: FormProblem = "its course must not cross itself, and its points must be different";

impl Form {
    /// True where it is straight, thin and sharp.
    pub fn is_plain(&self) -> bool {
        self.course.is_empty() && self.edge_radius == 0.0
    }

    /// The course between two ends.
    fn between(&self, from: Vec2, to: Vec2) -> Vec<ChainPoint> {
        if self.course.is_empty() {
            vec![ChainPoint::straight(from), ChainPoint::straight(to)]
        } else {
            self.course.clone()
        }
    }

    /// The shape of what runs between two ends, as a part with this skin [m] meets it. Of two that have no thickness at all nothing would tell on which side
    /// of the other each is, but where both are straight: what is thin then has twice this thickness below what is drawn, and sharp ends.
    pub(crate) fn shape(&self, from: Vec2, to: Vec2, thick: Thick, skin: f64) -> Result<Shape, FormProblem> {
        let (course, thin) = (self.between(from, to), self.edge_radius == 0.0);
        if thin && skin == 0.0 {
            return Shape::of_open_chain(&course).map_err(|_| NO_CHAIN);
        }
        let (radius, end) = if thin { (skin, 0.0) } else { (self.edge_radius, PI) };
        let course = if thin { course } else { shortened(&course, radius).ok_or(TOO_ROUND)? };
        // Of a skin one side is what is drawn, that of a wall too; where an arc meets it at an angle the other lies a hair beside where it would be.
        let middle = if thin && thick == Thick::Both { Thick::Right } else { thick }.middle(radius);
        let side = |distance: f64| beside(&course, distance, thin);
        let (right, left) = (side(middle + radius)?, side(middle - radius)?);
        // Round the first end, along the right side, round the other end, and back along the left side.
        let Some((last, before)) = right.split_last() else { return Err(NO_CHAIN) };
        let mut chain = vec![ChainPoint { at: left[0].at, sweep: end }];
        chain.extend(before);
        chain.push(ChainPoint { at: last.at, sweep: end });
        chain.extend((1..left.len()).rev().map(|i| ChainPoint { at: left[i].at, sweep: -left[i - 1].sweep }));
        Shape::of_chain(&chain).map_err(|_| NO_CHAIN)
    }

    /// The arcs of what runs between two ends: its bends, then its edges where they are round, the last one first.
    pub(crate) fn arcs(&self, from: Vec2, to: Vec2, thick: Thick) -> Vec<FormArc> {
        let course = self.between(from, to);
        let bend = |pair: &[ChainPoint]| {
            let (centre, _) = pair[0].arc_to(pair[1].at)?;
            Some(FormArc { centre, middle: pair[0].along(pair[1].at, 0.5), bend: true, uphill: false })
        };
        let bends = course.windows(2).filter_map(bend);
        let radius = self.edge_radius;
        let middle = shortened(&course, radius).and_then(|c| beside(&c, thick.middle(radius), false).ok());
        let edges = middle.filter(|_| radius > 0.0).map(|middle| {
            let last = middle.len() - 1;
            let [begins, _] = directions(&middle[0], middle[1].at);
            let [_, ends] = directions(&middle[last - 1], middle[last].at);
            [(middle[last].at, ends, false), (middle[0].at, -begins, true)].map(|(centre, out, uphill)| {
                FormArc { centre, middle: centre + out * radius, bend: false, uphill }
            })
        });
        bends.chain(edges.into_iter().flatten()).collect()
    }
}

impl Thick {
    /// How far the middle of a sheet with edges of this radius lies to the right of its drawn line [m].
    fn middle(self, radius: f64) -> f64 {
        match self {
            Self::Left => -radius,
            Self::Right => radius,
            Self::Both => 0.0,
        }
    }
}

/// Unit directions in which a stretch leaves its first point and arrives at its last.
fn directions(from: &ChainPoint, to: Vec2) -> [Vec2; 2] {
    let chord = (to - from.at).unit().unwrap_or_default();
    let (sin, cos) = sin_cos(0.5 * from.sweep);
    [chord.rotated(cos, -sin), chord.rotated(cos, sin)]
}

/// Length of a stretch [m].
fn length(from: &ChainPoint, to: Vec2) -> f64 {
    let (chord, half) = ((to - from.at).norm(), 0.5 * from.sweep.abs());
    if half == 0.0 { chord } else { chord * half / sin(half) }
}

/// A course without so much of each end; `None` where a stretch is too short for that.
fn shortened(course: &[ChainPoint], by: f64) -> Option<Vec<ChainPoint>> {
    let mut out = course.to_vec();
    let last = course.len().checked_sub(2)?;
    let share = |i: usize| by / length(&course[i], course[i + 1].at);
    let (first_cut, last_cut) = (share(0), share(last));
    let left = if last == 0 { first_cut + last_cut } else { first_cut.max(last_cut) };
    // A course of broken numbers has no length either.
    if left.is_nan() || left >= 1.0 {
        return None;
    }
    out[0].at = course[0].along(course[1].at, first_cut);
    out[last + 1].at = course[last].along(course[last + 1].at, 1.0 - last_cut);
    out[0].sweep *= 1.0 - first_cut;
    out[last].sweep = course[last].sweep * (1.0 - if last == 0 { left } else { last_cut });
    Some(out)
}

/// The line at this distance to the right of a course. Arcs meet other stretches smoothly, unless they may meet them in `kinks`.
fn beside(course: &[ChainPoint], distance: f64, kinks: bool) -> Result<Vec<ChainPoint>, FormProblem> {
    let ends = |i: usize| directions(&course[i], course[i + 1].at);
    let stretches = course.len() - 1;
    let mut out = course.to_vec();
    for (i, point) in out.iter_mut().enumerate() {
        let arrives = if i == 0 { ends(0)[0] } else { ends(i - 1)[1] };
        let leaves = if i == stretches { ends(i - 1)[1] } else { ends(i)[0] };
        let is_bent = |i: usize| course.get(i).is_some_and(|p| p.sweep != 0.0);
        let kink = arrives.cross(leaves).abs() > SMOOTH_BEND || arrives.dot(leaves) < 0.0;
        if !kinks && kink && (is_bent(i) || i > 0 && is_bent(i - 1)) {
            return Err(KINKED);
        }
        let (a, b) = (arrives.turned_right(), leaves.turned_right());
        point.at += (a + b) * (distance / (1.0 + a.dot(b)));
    }
    // Where a side has lost its direction the sheet is thicker than its bend, or than its stretch is long.
    let turned = |i: usize| (out[i + 1].at - out[i].at).dot(course[i + 1].at - course[i].at) <= 0.0;
    if (0..stretches).any(turned) { Err(TOO_ROUND) } else { Ok(out) }
}

/// A place on a course: the point, the unit direction there, and whether the stretch is straight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct OnCourse {
    pub(crate) at: Vec2,
    pub(crate) direction: Vec2,
    pub(crate) straight: bool,
}

impl Plate {
    /// Its course, from the uphill end to the free edge.
    pub fn course(&self) -> Vec<ChainPoint> {
        self.form.between(self.uphill, self.edge)
    }

    /// Its arcs: the bends of its course from the uphill end on, then its edges where they have a radius, the free one first.
    pub fn arcs(&self) -> Vec<FormArc> {
        self.form.arcs(self.uphill, self.edge, self.below())
    }

    /// Length along it [m].
    pub fn length(&self) -> f64 {
        self.form.length(self.uphill, self.edge)
    }

    /// How steep it is below the horizontal at its uphill end and at its free edge [rad]: one angle where it is straight.
    pub fn slopes(&self) -> [f64; 2] {
        let falls = |along: Vec2| atan2(-along.y, along.x.abs());
        let begins = match self.form.course.as_slice() {
            [first, second, ..] => directions(first, second.at)[0],
            _ => self.arrives(),
        };
        [falls(begins), falls(self.arrives())]
    }

    /// The direction in which it arrives at its free edge, of any length.
    pub(crate) fn arrives(&self) -> Vec2 {
        if self.form.course.is_empty() {
            return self.edge - self.uphill;
        }
        before_end(&self.form.course, 0.0).map_or(Vec2::ZERO, |end| end.direction)
    }

    /// The side of it that is below, seen towards the free edge. Of what is thin it is the one below that edge: the part leaves the other, which is exact.
    pub(crate) fn below(&self) -> Thick {
        let across = self.edge.x - self.uphill.x;
        let across = if across == 0.0 || self.form.edge_radius == 0.0 { self.arrives().x } else { across };
        if across < 0.0 { Thick::Left } else { Thick::Right }
    }

    /// Straight pieces along it, as of [`Form::pieces`].
    pub fn pieces(&self) -> Vec<(Vec2, Vec2)> {
        self.form.pieces(self.uphill, self.edge)
    }

    /// True where an arc lies at this distance before its free edge, along it [m].
    pub fn is_bent_at(&self, to_edge: f64) -> bool {
        before_end(&self.form.course, to_edge).is_some_and(|place| !place.straight)
    }
}

impl Wall {
    /// Its arcs, as [`Plate::arcs`].
    pub fn arcs(&self) -> Vec<FormArc> {
        self.form.arcs(self.from, self.to, Thick::Both)
    }
}

impl Form {
    /// Length of what runs between two ends, along its course [m].
    pub fn length(&self, from: Vec2, to: Vec2) -> f64 {
        course_length(&self.between(from, to))
    }

    /// Straight pieces between two ends [m]: one of a straight form; chords of arcs, no farther from them than 1e-4 of their radius.
    pub fn pieces(&self, from: Vec2, to: Vec2) -> Vec<(Vec2, Vec2)> {
        let course = self.between(from, to);
        let piece = |pair: &[ChainPoint]| {
            let (from, to) = (pair[0], pair[1].at);
            let count = if from.sweep == 0.0 { 1 } else { CHORDS };
            let point = move |i: u32| from.along(to, f64::from(i) / f64::from(count));
            (0..count)
                .map(move |i| (point(i), if i + 1 == count { to } else { point(i + 1) }))
                .collect::<Vec<_>>()
        };
        course.windows(2).flat_map(piece).collect()
    }
}

/// Chords of an arc: enough for what is said of distances and crossings.
const CHORDS: u32 = 128;

/// Length of a course [m].
pub(crate) fn course_length(course: &[ChainPoint]) -> f64 {
    course.windows(2).map(|pair| length(&pair[0], pair[1].at)).sum()
}

/// The place on a course at this distance before its end [m]; its beginning where it is shorter.
pub(crate) fn before_end(course: &[ChainPoint], mut distance: f64) -> Option<OnCourse> {
    for pair in course.windows(2).rev() {
        let (from, to) = (&pair[0], pair[1].at);
        let long = length(from, to);
        if distance <= long || from == &course[0] {
            let share = (1.0 - distance / long).max(0.0);
            let (sin, cos) = sin_cos(from.sweep * share);
            let direction = directions(from, to)[0].rotated(cos, sin);
            return Some(OnCourse { at: from.along(to, share), direction, straight: from.sweep == 0.0 });
        }
        distance -= long;
    }
    None
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use super::*;
    use crate::tolerance::SAME_LENGTH;
    use std::f64::consts::FRAC_PI_2;

    fn at(x: f64, y: f64) -> ChainPoint {
        ChainPoint::straight(Vec2::new(x, y))
    }

    #[test]
    fn a_straight_sheet_is_a_capsule_that_ends_where_it_is_drawn() {
        let form = Form { edge_radius: 0.01, ..Form::default() };
        let shape = form.shape(Vec2::ZERO, Vec2::new(1.0, 0.0), Thick::Right, 0.0).unwrap();
        assert!(shape.is_hull(), "numbered as a segment is: from, to");
        let expected = [Vec2::new(0.01, -0.01), Vec2::new(0.99, -0.01)];
        for (vertex, expected) in shape.vertices().iter().zip(expected) {
            assert!((*vertex - expected).norm() < SAME_LENGTH, "{vertex:?}");
        }
        assert!((shape.radius() - 0.01).abs() < SAME_LENGTH && shape.face_normal(1).y > 0.0);
        assert!(
            form.shape(Vec2::ZERO, Vec2::new(0.015, 0.0), Thick::Right, 0.0).is_err(),
            "shorter than thick"
        );
    }

    #[test]
    fn a_bent_sheet_is_as_thick_everywhere() {
        // Down, a quarter circle of 0.5 m, and on: the upper side is the inner one.
        let course =
            vec![at(0.0, 1.0), ChainPoint { sweep: FRAC_PI_2, ..at(0.0, 0.5) }, at(0.5, 0.0), at(1.0, 0.0)];
        let form = Form { course, edge_radius: 0.01 };
        let shape = form.shape(Vec2::ZERO, Vec2::ZERO, Thick::Right, 0.0).unwrap();
        let mut radii: Vec<f64> = (0..shape.vertices().len()).map(|v| shape.radius_of(v)).collect();
        radii.sort_by(f64::total_cmp);
        for (radius, expected) in radii.iter().zip([-0.5, 0.01, 0.01, 0.52]) {
            assert!((radius - expected).abs() < SAME_LENGTH, "{radii:?}");
        }
        assert_eq!(form.shape(Vec2::ZERO, Vec2::ZERO, Thick::Both, 0.0).map(|s| s.vertices().len()), Ok(4));
        assert!(Form { edge_radius: 0.3, ..form }.shape(Vec2::ZERO, Vec2::ZERO, Thick::Left, 0.0).is_err());
    }

    #[test]
    fn places_on_a_course_are_measured_along_it() {
        let course =
            [at(0.0, 1.0), ChainPoint { sweep: FRAC_PI_2, ..at(0.0, 0.5) }, at(0.5, 0.0), at(1.0, 0.0)];
        let quarter = 0.5 * FRAC_PI_2;
        assert!((course_length(&course) - 1.0 - quarter).abs() < SAME_LENGTH);
        let middle = before_end(&course, 0.5 + 0.5 * quarter).unwrap();
        let expected = Vec2::new(0.5, 0.5) - Vec2::new(0.5f64.sqrt(), 0.5f64.sqrt()) * 0.5;
        assert!((middle.at - expected).norm() < SAME_LENGTH && !middle.straight, "{middle:?}");
        assert!((middle.direction - Vec2::new(0.5f64.sqrt(), -0.5f64.sqrt())).norm() < SAME_LENGTH);
        let first = before_end(&course, 0.5 + quarter + 0.1).unwrap();
        assert!((first.at - Vec2::new(0.0, 0.6)).norm() < SAME_LENGTH && first.straight, "{first:?}");
    }
}
