//! What a body does between events: it flies, turns about a support or an edge, or rests; its equations and the forces on it.

use crate::spatial::geometry::plane::Plane;
use crate::spatial::geometry::posture::Posture;
use crate::spatial::geometry::state::Pose;
use crate::spatial::geometry::supports::Supports;
use crate::spatial::geometry::world::World;
use crate::tolerance::ON_EDGE;
use carom_num::{Mat3, Rotation, Vec3};
use std::ops::Range;

/// What a body does.
///
/// # Example
/// A cube that falls flies until it lies on all its corners.
/// ```
/// use carom_motion::spatial::{Mode, Options, Samples, examples, run};
/// let (world, start) = examples::falling_cube();
/// let mut samples = Samples::default();
/// run(&world, &start, &Options::default(), &mut samples)?;
/// assert_eq!(samples.pieces[0].mode, Mode::Flight);
/// # Ok::<(), carom_motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// No support is held.
    Flight,
    /// It turns about one support, which is held.
    Pivot {
        /// Which one.
        support: usize,
        /// It, and the same point's supports of other planes.
        held: Supports,
    },
    /// It turns about an edge.
    Edge {
        /// The supports at its ends.
        ends: [usize; 2],
        /// The unit vector from the first to the second, body axes.
        along: Vec3,
        /// All that are held.
        held: Supports,
    },
    /// Three or more supports that are not on one line are held.
    Rest {
        /// Which ones.
        held: Supports,
    },
    /// Supports slide along their planes. A body with balls or circles that rolls on one or two of them does so too, with none that slips: their places move along it, so that
    /// nothing of it is a pivot or an edge.
    Slides {
        /// Those whose places on the planes do not slip, which the body turns about, or none.
        sticking: Supports,
        /// Those that slide and carry the body.
        slipping: Supports,
    },
}

/// The distance of a point from the line through another, along a unit vector.
fn off_line(point: Vec3, on: Vec3, along: Vec3) -> f64 {
    (point - on).cross(along).norm()
}

impl Mode {
    /// What a body does while the places at which these supports touch, and no others, stay where they are.
    pub(in crate::spatial) fn holding(world: &World, held: Supports, pose: Pose) -> Self {
        let place = |i: usize| world.arm(i, pose);
        let Some(first) = held.iter().next() else { return Self::Flight };
        let distance = |i: usize, j: usize| (place(i) - place(j)).norm();
        // The ends of a line are a support farthest from any, and the one farthest from that.
        let farthest = |from: usize| {
            held.iter().max_by(|a, b| distance(from, *a).total_cmp(&distance(from, *b))).unwrap_or(from)
        };
        let one = farthest(first);
        let other = farthest(one);
        let ends = [one.min(other), one.max(other)];
        let Some(along) = (place(ends[1]) - place(ends[0])).unit() else {
            return Self::Pivot { support: first, held };
        };
        let collinear =
            |i: usize| off_line(place(i), place(ends[0]), along) <= ON_EDGE * world.body().reach();
        if !held.iter().all(collinear) {
            return Self::Rest { held };
        }
        // Others between the ends touch their plane too, where it holds two of these.
        let beside = |i: &usize| {
            let own = world.of_plane(world.plane_of(*i));
            let of_its_plane = held.those(|i| own.contains(&i));
            of_its_plane.len() >= 2 && collinear(*i) && world.is_between(ends, *i)
        };
        let between: Supports = (0..world.of_faces()).filter(beside).collect();
        Self::Edge { ends, along, held: held.union(between) }
    }

    /// What a body does of which these supports stick where they touch: one with balls or circles rolls on them, and edges turn about each other as they may.
    pub(in crate::spatial) fn sticking(world: &World, held: Supports, pose: Pose) -> Self {
        match Self::holding(world, held, pose) {
            Self::Pivot { .. } | Self::Edge { .. } if world.body().is_round() || world.has_pairs(held) => {
                Self::Slides { sticking: held, slipping: Supports::NONE }
            }
            mode => mode,
        }
    }

    /// The supports that stay on their planes as long as this goes on.
    pub fn held(&self, world: &World) -> Supports {
        match *self {
            Self::Flight => Supports::NONE,
            Self::Pivot { held, .. } | Self::Edge { held, .. } | Self::Rest { held } => held,
            Self::Slides { sticking, slipping } => spanned(world, sticking.union(slipping)),
        }
    }

    /// What of the body stays where it is.
    pub(in crate::spatial) fn fixed(&self, world: &World) -> Fixed {
        match *self {
            Self::Flight => Fixed::Nothing,
            Self::Slides { sticking, .. } if world.body().is_round() || world.has_pairs(sticking) => {
                Fixed::Nothing
            }
            Self::Slides { sticking, .. } => Self::holding(world, sticking, Pose::NONE).fixed(world),
            Self::Pivot { support, .. } => Fixed::Point(world.point(support)),
            Self::Edge { ends: [a, _], along, .. } => Fixed::Line(world.point(a), along),
            Self::Rest { .. } => Fixed::All,
        }
    }

    /// The support whose place the motion is reckoned from.
    pub(in crate::spatial) fn foot(&self) -> Option<usize> {
        match *self {
            Self::Flight => None,
            Self::Pivot { support, .. } => Some(support),
            Self::Edge { ends, .. } => Some(ends[0]),
            Self::Rest { held } => held.iter().next(),
            Self::Slides { sticking, slipping } => sticking.iter().next().or(slipping.iter().next()),
        }
    }
}

/// What of a body stays where it is in a mode.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) enum Fixed {
    Nothing,
    /// A point of it, body axes.
    Point(Vec3),
    /// The points of a line: one of them, and its direction.
    Line(Vec3, Vec3),
    All,
}

impl Fixed {
    /// A support whose point stays where it is: that of another plane, too, which it may not touch.
    pub(in crate::spatial) fn holds(&self, world: &World, support: usize) -> bool {
        let near = ON_EDGE * world.body().reach();
        let of_face = support < world.of_faces();
        match *self {
            Self::Nothing => false,
            Self::Point(point) => of_face && (world.point(support) - point).norm() <= near,
            Self::Line(point, along) => of_face && off_line(world.point(support), point, along) <= near,
            Self::All => true,
        }
    }
}

/// The supports of each plane on the point, line or plane that these span of it: they stay on the plane with them.
pub(in crate::spatial) fn spanned(world: &World, bearing: Supports) -> Supports {
    // Of a face that has ends others may be on its plane, and beyond them.
    let endless = |plane: &usize| world.of_plane(*plane).next().is_none_or(|i| world.limits(i) == 0);
    let planes = (0..world.planes().len()).filter(endless);
    planes.map(|plane| spanned_of(world, bearing, world.of_plane(plane))).fold(bearing, Supports::union)
}

/// Those of one plane.
fn spanned_of(world: &World, bearing: Supports, own: Range<usize>) -> Supports {
    let bearing = bearing.those(|i| own.contains(&i));
    // Places of features that are not alike move against each other: only those between two of them stay on the plane with them.
    if !world.are_alike(bearing) {
        let between = |i: &usize| {
            let ends = |a: usize| bearing.iter().filter(move |b| a < *b).map(move |b| [a, b]);
            bearing.iter().flat_map(ends).any(|ends| world.is_between(ends, *i))
        };
        return bearing.union(own.filter(between).collect());
    }
    let mode = Mode::holding(world, bearing, Pose::NONE);
    let Mode::Rest { held } = mode else { return mode.held(world) };
    let normal = normal_of(world, held, Pose::NONE);
    let (Some(first), Some(normal)) = (held.iter().next(), normal) else { return held };
    let on = |i: &usize| {
        (world.point(*i) - world.point(first)).dot(normal).abs() <= ON_EDGE * world.body().reach()
    };
    let like = |i: &usize| world.are_alike([first, *i].into_iter().collect());
    held.union(own.filter(on).filter(like).collect())
}

/// The unit normal of the plane through three or more supports.
pub(in crate::spatial) fn normal_of(world: &World, held: Supports, pose: Pose) -> Option<Vec3> {
    let place = |i: usize| world.arm(i, pose);
    let first = held.iter().next()?;
    let others: Vec<Vec3> = held.iter().skip(1).map(|i| place(i) - place(first)).collect();
    let crossed = |a: &Vec3| others.iter().map(|b| a.cross(*b)).collect::<Vec<_>>();
    let normals = others.iter().flat_map(crossed);
    normals.max_by(|a, b| a.norm().total_cmp(&b.norm()))?.unit()
}

/// The turn since the start of a stretch (w, x, y, z) and the spin in body axes, as the integration takes them.
pub(in crate::spatial) type Vector = [f64; 7];

pub(super) fn pack(turned: Rotation, spin: Vec3) -> Vector {
    let [w, x, y, z] = turned.to_array();
    [w, x, y, z, spin.x, spin.y, spin.z]
}

/// Turn as it stands and spin. Only a unit quaternion is a rotation.
pub(super) fn unpack(y: &Vector) -> (Rotation, Vec3) {
    (Rotation { w: y[0], v: Vec3::new(y[1], y[2], y[3]) }, Vec3::new(y[4], y[5], y[6]))
}

/// The same motion with a unit quaternion.
pub(in crate::spatial) fn normalised(y: &Vector) -> Vector {
    let (turned, spin) = unpack(y);
    pack(Rotation::of(turned.to_array()).unwrap_or(turned), spin)
}

/// The equations of a mode.
///
/// ```text
/// pivot about s:  J_s ω̇ = −m s × g − ω × J_s ω        J_s = J + m (s² 1 − s sᵀ), g in body axes
/// edge along u:   u·J_s u ω̇ = −m u·(s × g) u
/// flight:         J ω̇ = −ω × J ω
/// ```
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct Equations {
    mode: Mode,
    mass: f64,
    /// Gravity and the normal of the foot's plane, or of the first one, in body axes as they are at the start.
    gravity: Vec3,
    up: Vec3,
    /// The foot from the mass centre, body axes; zero in flight.
    arm: Vec3,
    /// About the mass centre, and about the foot.
    inertia: Mat3,
    about: Mat3,
    inverse: Mat3,
    /// Length of the edge.
    length: f64,
}

impl Equations {
    /// `None` where the inertia about the foot has no inverse, by overflow.
    pub(in crate::spatial) fn of(world: &World, mode: Mode, start: Rotation) -> Option<Self> {
        let body = world.body();
        let arm = mode.foot().map_or(Vec3::ZERO, |s| world.point(s));
        let about = body.inertia_about(arm);
        let plane = world.planes().get(mode.foot().map_or(0, |foot| world.plane_of(foot)));
        let length = match mode {
            Mode::Edge { ends: [a, b], .. } => (world.point(b) - world.point(a)).norm(),
            _ => 0.0,
        };
        Some(Self {
            mode,
            mass: body.mass(),
            gravity: start.undo(world.gravity()),
            up: start.undo(plane.map_or(Vec3::Z, Plane::normal)),
            arm,
            inertia: body.inertia(),
            about,
            inverse: about.inverse()?,
            length,
        })
    }

    pub(in crate::spatial) fn mode(&self) -> Mode {
        self.mode
    }

    pub(in crate::spatial) fn arm(&self) -> Vec3 {
        self.arm
    }

    pub(in crate::spatial) fn about(&self) -> Mat3 {
        self.about
    }

    pub(in crate::spatial) fn weight(&self) -> f64 {
        self.mass * self.gravity.norm()
    }

    /// Gravity, body axes.
    pub(in crate::spatial) fn gravity(&self, turned: Rotation) -> Vec3 {
        turned.undo(self.gravity)
    }

    /// Angular acceleration, body axes [rad/s²].
    fn turning(&self, turned: Rotation, spin: Vec3) -> Vec3 {
        let pull = || self.arm.cross(self.gravity(turned)) * -self.mass;
        match self.mode {
            // Sliding bodies have equations of their own.
            Mode::Rest { .. } | Mode::Slides { .. } => Vec3::ZERO,
            Mode::Edge { along, .. } => along * (along.dot(pull()) / along.dot(self.about * along)),
            Mode::Pivot { .. } => self.inverse * (pull() - spin.cross(self.about * spin)),
            Mode::Flight => self.inverse * -spin.cross(self.about * spin),
        }
    }

    /// The derivative of turn and spin.
    pub(in crate::spatial) fn rate(&self, y: &Vector) -> Vector {
        let (turned, spin) = unpack(y);
        let turning = self.turning(turned, spin);
        let [w, x, y, z] = turned.rate(spin);
        [w, x, y, z, turning.x, turning.y, turning.z]
    }

    /// The instant with this turn and spin; `base` is how the foot, or the mass centre, has gone.
    pub(in crate::spatial) fn posture(&self, y: &Vector, base: [Vec3; 3]) -> Posture {
        let (turned, spin) = unpack(&normalised(y));
        let turning = self.turning(turned, spin);
        Posture { turned, up: turned.undo(self.up), spin, turning, from: self.arm, base }
    }

    /// The whole force on the body from what it touches, body axes \[N\]: `m (a − g)`.
    pub(in crate::spatial) fn force(&self, at: &Posture) -> Vec3 {
        let foot = -self.arm;
        let acceleration = at.turning.cross(foot) + at.spin.cross(at.spin.cross(foot));
        (acceleration - self.gravity(at.turned)) * self.mass
    }

    /// Normal forces at the foot and, on an edge, at its other end \[N\].
    ///
    /// On an edge the moment about the horizontal e ⊥ u shares them: `N₂ = (e·(s × P) − e·L̇)/length`, with the whole force P and the angular
    /// momentum L about the mass centre.
    pub(in crate::spatial) fn normal_forces(&self, at: &Posture) -> [f64; 2] {
        let force = self.force(at);
        let whole = at.up.dot(force);
        let Mode::Edge { along, .. } = self.mode else { return [whole, 0.0] };
        let across = at.up.cross(along);
        let moment = self.inertia * at.turning + at.spin.cross(self.inertia * at.spin);
        let other = (across.dot(self.arm.cross(force)) - across.dot(moment)) / self.length;
        [whole - other, other]
    }

    /// The forces on the foot and, on an edge, on its other end \[N\].
    ///
    /// On an edge the moment about the normal e shares what acts across it: `e·(L̇ − s × P)/length` is the other end's.
    pub(in crate::spatial) fn end_forces(&self, at: &Posture) -> EndForces {
        let force = self.force(at);
        let normal = self.normal_forces(at);
        let Mode::Edge { along, .. } = self.mode else {
            let flat = force - at.up * at.up.dot(force);
            return EndForces { normal, across: [0.0; 2], along: flat.norm(), axes: [flat, Vec3::ZERO] };
        };
        let across = at.up.cross(along);
        let moment = self.inertia * at.turning + at.spin.cross(self.inertia * at.spin);
        let other = at.up.dot(moment - self.arm.cross(force)) / self.length;
        EndForces {
            normal,
            across: [across.dot(force) - other, other],
            along: along.dot(force),
            axes: [along, across],
        }
    }
}

/// Forces at the ends of an edge, or on a single foot.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct EndForces {
    /// Along the plane's normal.
    pub(in crate::spatial) normal: [f64; 2],
    /// Horizontally across the edge.
    pub(in crate::spatial) across: [f64; 2],
    /// Along the edge, of both ends together; on a single foot, the size of the horizontal force.
    pub(in crate::spatial) along: f64,
    /// The edge and the horizontal direction across it, body axes; of a single foot, its horizontal force first.
    pub(in crate::spatial) axes: [Vec3; 2],
}
