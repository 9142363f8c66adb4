//! What a shape can lie on: its faces, lines across its hollows, and the lowest points of its arcs.

use super::Shape;
use super::wrap::{Support, turn};
use crate::tolerance::{COINCIDENT_VERTICES, SAME_SIDE_SINE, SHORTEST_SIDE, THINNEST};
use carom_num::Vec2;
use std::f64::consts::TAU;
use std::sync::OnceLock;

/// What of a shape lies below where it rests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RestKind {
    /// One of its faces.
    Face,
    /// Two points with a hollow between them.
    Across,
    /// The lowest point of an arc.
    Arc,
}

/// A side on which a shape can lie, in its own frame.
///
/// # Example
/// See [`Shape::rests`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Unit normal out of the shape.
    pub normal: Vec2,
    /// Distance of the line from the mass centre [m].
    pub depth: f64,
    /// The two outermost points that touch the line, counter-clockwise [m]; of an arc both are its lowest point.
    pub from: Vec2,
    /// The other one.
    pub to: Vec2,
    /// The first point belongs to this vertex.
    pub vertex: usize,
    /// What lies below.
    pub kind: RestKind,
    /// By how much the shape can be tilted clockwise and counter-clockwise before it tips over [rad]: up to where the mass centre is highest. Zeros
    /// where it does not stay.
    pub basin: [f64; 2],
}

/// What a shape can lie on, once somebody has asked: it takes the square of its corners to find, and a part that rolls is asked at each strike.
#[derive(Clone, Debug, Default)]
pub(super) struct FoundRests(OnceLock<Vec<Rest>>);

/// Two shapes are one, whoever has been asked.
impl PartialEq for FoundRests {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Rest {
    /// True of a face, along which the line runs all the way.
    pub fn is_face(&self) -> bool {
        self.kind == RestKind::Face
    }

    /// By how much the mass centre lies inside the two points, along the line [m]: negative on either side where the shape tips over at once.
    ///
    /// # Example
    /// A square of 2 m tips over after 1 m either way.
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
    /// let square = Shape::new(corners.to_vec(), 0.0).unwrap();
    /// assert_eq!(square.rests()[0].inside(), [1.0, 1.0]);
    /// ```
    pub fn inside(&self) -> [f64; 2] {
        let along = self.normal.turned_left();
        [-along.dot(self.from), along.dot(self.to)]
    }

    /// The share of all orientations from which the shape comes to lie so on level ground when it is let go gently: it tips towards where its mass
    /// centre is lowest, without a swing. The shares of all rests add up to 1.
    ///
    /// # Example
    /// A square lies on each of its sides as often; a bar of 4 to 1 on a long side with 2 atan(4)/π of the time, over both of them.
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let corners = [(-4.0, -1.0), (4.0, -1.0), (4.0, 1.0), (-4.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
    /// let shares = Shape::new(corners.to_vec(), 0.0).unwrap().rests().iter().map(|r| r.share()).collect::<Vec<_>>();
    /// assert!((shares[0] - 4f64.atan() / std::f64::consts::PI).abs() < 1e-15);
    /// assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-15);
    /// ```
    ///
    /// # Source
    /// Boothroyd & Ho (1977), "Natural resting aspects of parts for automatic handling", the energy barriers of which this is the plane's form.
    pub fn share(&self) -> f64 {
        (self.basin[0] + self.basin[1]) / TAU
    }
}

impl Shape {
    /// The sides on which it can lie, counter-clockwise: of an evenly rounded hull its faces, by their numbers. Of any other shape they are
    /// numbered from that which starts at the lowest vertex; a line across a hollow is one of them, a face in a hollow is none. The lowest points of
    /// arcs on which it stays come after all of these.
    ///
    /// # Example
    /// An L lies on its two long sides, its two short ones, and across its hollow.
    /// ```
    /// use carom_motion::planar::{ChainPoint, Shape};
    /// use carom_num::Vec2;
    /// let corners = [(-1.0, -1.0), (2.0, -1.0), (2.0, 0.0), (0.0, 0.0), (0.0, 1.0), (-1.0, 1.0)];
    /// let l = Shape::of_chain(&corners.map(|(x, y)| ChainPoint::straight(Vec2::new(x, y)))).unwrap();
    /// let rests = l.rests();
    /// assert_eq!(rests.iter().map(|rest| rest.is_face()).collect::<Vec<_>>(), [true, true, false, true, true]);
    /// assert_eq!((rests[2].from, rests[2].to), (Vec2::new(2.0, 0.0), Vec2::new(0.0, 1.0)));
    /// ```
    pub fn rests(&self) -> &[Rest] {
        self.rests.0.get_or_init(|| self.find_rests())
    }

    fn find_rests(&self) -> Vec<Rest> {
        let supports = self.supports();
        let mut found = if self.is_hull() {
            (0..self.faces()).map(|face| self.rest_on(face)).collect()
        } else {
            let mut found = self.lines(&supports);
            let first = (0..found.len()).min_by_key(|i| found[*i].vertex).unwrap_or(0);
            found.rotate_left(first);
            found
        };
        found.extend(supports.iter().filter_map(|support| self.rest_on_arc(support)));
        let highest: Vec<Vec2> = supports.iter().filter_map(Support::highest).collect();
        for rest in &mut found {
            rest.basin = basin(rest, &highest);
        }
        found
    }

    /// How high the mass centre is above level ground on which the shape stands, where a unit vector of its own frame points down \[m\].
    ///
    /// # Example
    /// A square of 2 m on a side and on a corner.
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
    /// let square = Shape::new(corners.to_vec(), 0.0).unwrap();
    /// let corner = Vec2::new(1.0, 1.0) / 2f64.sqrt();
    /// assert_eq!(square.centre_height(Vec2::new(0.0, -1.0)), 1.0);
    /// assert!((square.centre_height(corner) - 2f64.sqrt()).abs() < 1e-15);
    /// ```
    pub fn centre_height(&self, down: Vec2) -> f64 {
        let outside = (0..self.vertices().len()).filter(|vertex| !self.is_hollow(*vertex));
        let reach = outside.flat_map(|vertex| {
            let (centre, radius) = (self.vertices()[vertex], self.radius_of(vertex));
            let in_front = radius == 0.0 || self.normals_hold(vertex, down);
            // Of an arc that does not face down an end is lowest.
            let ends =
                (!in_front).then(|| [self.face_before(vertex), vertex].map(|face| self.face_normal(face)));
            let ends = ends.into_iter().flatten().map(move |normal| down.dot(centre + normal * radius));
            ends.chain(in_front.then_some(down.dot(centre) + radius))
        });
        reach.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The rest to which the shape tips without a swing from where a unit vector of its own frame points down, by its number among [`Self::rests`]; `None`
    /// where it is balanced, or where it lies alike on all its rim.
    ///
    /// # Example
    /// A square that is tilted by 44° goes back, by 46° over its corner.
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
    /// let square = Shape::new(corners.to_vec(), 0.0).unwrap();
    /// let tilted = |degrees: f64| square.rest_below(Vec2::at_angle((degrees - 90.0).to_radians()));
    /// assert_eq!((tilted(44.0), tilted(46.0), tilted(-46.0)), (Some(0), Some(1), Some(3)));
    /// ```
    pub fn rest_below(&self, down: Vec2) -> Option<usize> {
        let holds =
            |rest: &Rest| turn(rest.normal, down) < rest.basin[0] || turn(down, rest.normal) < rest.basin[1];
        self.rests().iter().position(holds)
    }

    /// How deep a point lies within the shape, in its own frame [m]: the distance from the outline, negative outside. A shape without thickness has
    /// no inside.
    ///
    /// # Example
    /// In the hollow of an L, and in its leg.
    /// ```
    /// use carom_motion::planar::{ChainPoint, Shape};
    /// use carom_num::Vec2;
    /// let corners = [(-1.0, -1.0), (2.0, -1.0), (2.0, 0.0), (0.0, 0.0), (0.0, 1.0), (-1.0, 1.0)];
    /// let l = Shape::of_chain(&corners.map(|(x, y)| ChainPoint::straight(Vec2::new(x, y)))).unwrap();
    /// assert_eq!(l.depth_of(Vec2::new(0.75, 0.25)), -0.25);
    /// assert_eq!(l.depth_of(Vec2::new(1.25, -0.25)), 0.25);
    /// ```
    pub fn depth_of(&self, point: Vec2) -> f64 {
        self.depth_by(point, |_, _| true)
    }

    /// How deep a point lies within the shape [m], by those sides and arcs behind which it lies so deep and to which the way from it is so that they are
    /// `wanted`; −∞ where none is.
    pub(in crate::planar) fn depth_by(&self, point: Vec2, wanted: impl Fn(f64, Vec2) -> bool) -> f64 {
        let mut nearest = f64::NEG_INFINITY;
        // Where both sides of a sheet are equally near it has no thickness, and the point is in front of one of them.
        let thin = THINNEST * self.size();
        let take = |depth: f64, way: Vec2| {
            let farther = depth.abs() - nearest.abs();
            let nearer = farther < -thin || farther <= thin && depth < nearest;
            if nearer && wanted(depth, way) {
                nearest = depth;
            }
        };
        self.each_depth(point, take);
        nearest
    }

    /// How deep a point lies behind every side and arc that it is square to, and behind every corner, with the way to it [m].
    fn each_depth(&self, point: Vec2, mut take: impl FnMut(f64, Vec2)) {
        // Rounding leaves no seam between a side and an arc: what is square to neither would be told of by something far away.
        let seam = THINNEST * self.size();
        for face in (0..self.faces()).filter(|face| self.face_length(*face) > 0.0) {
            let (normal, from) = (self.face_normal(face), point - self.vertices()[face]);
            let along = normal.turned_left().dot(from);
            if along >= -seam && along <= self.face_length(face) + seam {
                let depth = self.radius_of(face) - normal.dot(from);
                take(depth, normal * depth);
            }
        }
        for vertex in 0..self.vertices().len() {
            let (from, radius) = (point - self.vertices()[vertex], self.radius_of(vertex));
            let distance = from.norm();
            if radius == 0.0 {
                // What is nearest to a corner lies outside it, but in a hollow.
                let depth = if self.is_hollow(vertex) { distance } else { -distance };
                take(depth, -from);
            } else if self.normals_hold(vertex, from * radius.signum()) {
                let out = from.unit().unwrap_or_default();
                let depth = radius - radius.signum() * distance;
                take(depth, out * (radius.abs() - distance));
            }
        }
    }

    /// The straight side that runs by a point and looks in the direction `out`: how far the point lies behind it [m], and its outward normal. Sides
    /// count that look so to 1e-4 rad; `None` where there is none. Beyond its ends a side goes on.
    ///
    /// # Example
    /// A point above a square, and the side that looks up; no side looks up askew.
    /// ```
    /// use carom_motion::planar::Shape;
    /// use carom_num::Vec2;
    /// let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y));
    /// let square = Shape::new(square.to_vec(), 0.0).unwrap();
    /// let up = Vec2::new(0.0, 1.0);
    /// assert_eq!(square.side_by(Vec2::new(0.5, 1.25), up), Some((-0.25, up)));
    /// assert_eq!(square.side_by(Vec2::new(0.5, 1.25), Vec2::new(0.6, 0.8)), None);
    /// ```
    pub fn side_by(&self, point: Vec2, out: Vec2) -> Option<(f64, Vec2)> {
        let looks_out = |face: &usize| {
            let normal = self.face_normal(*face);
            self.face_length(*face) > 0.0
                && normal.dot(out) > 0.0
                && normal.cross(out).abs() <= SAME_SIDE_SINE
        };
        let by = |face: usize| {
            let (normal, from) = (self.face_normal(face), point - self.vertices()[face]);
            let (along, depth) = (normal.turned_left().dot(from), self.radius_of(face) - normal.dot(from));
            let beyond = (-along).max(along - self.face_length(face)).max(0.0);
            (depth.abs() + beyond, depth, normal)
        };
        let nearest = (0..self.faces()).filter(looks_out).map(by).min_by(|a, b| a.0.total_cmp(&b.0));
        nearest.map(|(_, depth, normal)| (depth, normal))
    }

    /// Where the segment between two points meets the outline's lines and circles, as shares of it; arcs count all round.
    pub fn cuts(&self, from: Vec2, to: Vec2) -> Vec<f64> {
        let run = to - from;
        let mut out = vec![];
        for face in 0..self.faces() {
            let (normal, start) = (self.face_normal(face), from - self.vertices()[face]);
            out.push((self.radius_of(face) - normal.dot(start)) / normal.dot(run));
        }
        for vertex in 0..self.vertices().len() {
            let (start, radius) = (from - self.vertices()[vertex], self.radius_of(vertex));
            // |start + s run| = r.
            let (a, b) = (run.dot(run), run.dot(start));
            let inside = b * b - a * (start.dot(start) - radius * radius);
            if inside >= 0.0 {
                out.extend([(-b - inside.sqrt()) / a, (-b + inside.sqrt()) / a]);
            }
        }
        out.retain(|share| *share > 0.0 && *share < 1.0);
        out.sort_by(f64::total_cmp);
        out
    }

    fn rest_on(&self, face: usize) -> Rest {
        let (normal, k) = (self.face_normal(face), self.vertices().len());
        let end = |v: usize| self.vertices()[v] + normal * self.radius_of(v);
        let (from, to) = (end(face), end((face + 1) % k));
        Rest {
            normal,
            depth: normal.dot(from),
            from,
            to,
            vertex: face,
            kind: RestKind::Face,
            basin: [0.0; 2],
        }
    }

    /// The lines from one support to the next.
    fn lines(&self, supports: &[Support]) -> Vec<Rest> {
        let mut found = vec![];
        for (i, a) in supports.iter().enumerate() {
            let (normal, b) = (a.to, &supports[(i + 1) % supports.len()]);
            let (from, to) = (a.touch(normal), b.touch(normal));
            // One arc goes on in another, or ends at a corner.
            if (to - from).norm() <= SHORTEST_SIDE * self.size() {
                continue;
            }
            let kind = if self.runs_along(from, to, normal) { RestKind::Face } else { RestKind::Across };
            found.push(Rest {
                normal,
                depth: normal.dot(from),
                from,
                to,
                vertex: a.vertex,
                kind,
                basin: [0.0; 2],
            });
        }
        found
    }

    /// True where one of its faces runs from one point to another.
    fn runs_along(&self, from: Vec2, to: Vec2, normal: Vec2) -> bool {
        let within = SHORTEST_SIDE * self.size();
        let k = self.vertices().len();
        (0..self.faces()).filter(|face| self.face_normal(*face).dot(normal) > 0.0).any(|face| {
            let end = |v: usize| self.vertices()[v] + self.face_normal(face) * self.radius_of(v);
            (end(face) - from).norm() <= within && (end((face + 1) % k) - to).norm() <= within
        })
    }

    /// The lowest point of an arc about which the shape swings, where it is one.
    fn rest_on_arc(&self, support: &Support) -> Option<Rest> {
        let normal =
            -support.centre.unit().filter(|_| support.centre.norm() > COINCIDENT_VERTICES * self.size())?;
        if support.radius == 0.0 || !support.has_within(normal) {
            return None;
        }
        let touch = support.touch(normal);
        let depth = normal.dot(touch);
        let (vertex, kind) = (support.vertex, RestKind::Arc);
        Some(Rest { normal, depth, from: touch, to: touch, vertex, kind, basin: [0.0; 2] })
    }
}

/// The angles to the nearest directions on both sides in which the mass centre is highest; zeros where the shape does not stay.
fn basin(rest: &Rest, highest: &[Vec2]) -> [f64; 2] {
    let stays = rest.kind == RestKind::Arc || rest.inside().iter().all(|inside| *inside > 0.0);
    if !stays {
        return [0.0; 2];
    }
    let nearest = |angles: &dyn Fn(Vec2) -> f64| highest.iter().map(|n| angles(*n)).fold(TAU, f64::min);
    // A shape that is tilted clockwise touches with a normal that lies counter-clockwise on it.
    [nearest(&|n| turn(rest.normal, n)), nearest(&|n| turn(n, rest.normal))]
}
