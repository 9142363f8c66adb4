//! A polyhedron that is thrown on the plane.

use super::body_shape::{self, ThrownShape};
use super::setup::{MOST_POINTS, Setup, SpatialDrawing, triple};
use crate::grammar::Section;
use crate::grammar::kind::{LENGTH_OR_NONE, SPEED, SPIN_RATE};
use crate::input::Beside;
use crate::problem::{Problem, ProblemKind};
use crate::quantity::Quantity;
use crate::roll::bodies::unfit;
use crate::tolerance::FLAT_AS_WRITTEN;
use crate::unit::Dimension;
use carom_impact::spatial::RigidBody;
use carom_motion::spatial::{Body, BodyProblem, Feature, Polyhedron, Stance, State, Supports};
use carom_num::principal::principal;
use carom_num::{Mat3, Rotation, Vec3};

/// How it is turned where nothing is written: about this axis, by this angle \[rad\]; on no face, edge or vertex of a box.
const DEFAULT_AXIS: Vec3 = Vec3::new(2.0, 1.0, 0.5);

/// A polyhedron that is thrown.
///
/// # Example
/// A box is homogeneous; its mass centre is its middle, and it stands 10 mm, 20 mm or 30 mm above its faces.
/// ```
/// use carom_scene::*;
/// let text = "box = [0.06, 0.04, 0.02]\nmass = 1\nturn = 0\nheight = 0.2";
/// let brick = SpatialRollProblem::parse(SpatialRollKind::Body, "brick.toml", text, &[])?;
/// let thrown = brick.thrown.unwrap();
/// let mut heights: Vec<f64> = thrown.stances.iter().map(|stance| stance.height).collect();
/// heights.sort_by(f64::total_cmp);
/// assert!(thrown.homogeneous && heights.len() == 6);
/// assert!((heights[0] - 0.01).abs() < 1e-15 && (heights[5] - 0.03).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ThrownBody {
    /// Its shape, in the axes of the drawing.
    pub shape: ThrownShape,
    /// The mass centre in them \[m\].
    pub centre: Vec3,
    /// How it stands on each face.
    pub stances: Vec<Stance>,
    /// True where mass centre and inertia are those of the shape, filled evenly.
    pub homogeneous: bool,
    /// What varies from throw to throw.
    pub throw: Throw,
}

/// What varies from throw to throw, beside the attitude.
///
/// # Example
/// It is released 0.2 m above the plane, from rest.
/// ```
/// use carom_scene::*;
/// let text = "box = [0.06, 0.04, 0.02]\nmass = 1\nturn = 0\nheight = 0.2";
/// let brick = SpatialRollProblem::parse(SpatialRollKind::Body, "brick.toml", text, &[])?;
/// let Throw { height, speed, rise, .. } = brick.thrown.unwrap().throw;
/// assert_eq!((height.value, speed.value, rise), (0.2, 0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Throw {
    /// Of the lowest vertex above the plane \[m\].
    pub height: Quantity,
    /// Horizontal \[m/s\].
    pub speed: Quantity,
    /// Size of the spin \[rad/s\].
    pub spin_rate: Quantity,
    /// Upwards \[m/s\].
    pub rise: f64,
}

/// The longest body for its width that is followed, by radii of gyration. What happens at its thin end takes as many times less time than the fall
/// of the other, and each of those events is found: time grows with the ratio, about a second at this one.
const SLENDEREST: f64 = 1e3;

/// Mass, mass centre in the axes of the drawing, inertia about it.
pub(crate) struct MassSpec {
    pub(crate) mass: f64,
    pub(crate) centre: Vec3,
    pub(crate) inertia: Mat3,
    pub(crate) homogeneous: bool,
}

pub(super) fn read(root: &Section<'_>, beside: Beside<'_>) -> Option<Setup> {
    let shape = body_shape::read(root, beside);
    let heft = heft(root, shape.as_ref());
    let attitude = attitude(root);
    let velocity = triple(root, "velocity");
    let spin = triple(root, "spin");
    let height = root.quantity("height");
    let (speed, spin_rate) = (root.quantity("speed"), root.quantity("spin_rate"));
    let bad = |key: &str, read: bool| root.has(key) && !read;
    let unread = bad("velocity", velocity.is_some()) || bad("spin", spin.is_some());
    let (shape, heft) = (shape?, heft?);
    let body = body(root, &shape, &heft)?;
    if unread || bad("height", height.is_some()) {
        return None;
    }
    let (velocity, spin) = (velocity.unwrap_or(Vec3::ZERO), spin.unwrap_or(Vec3::ZERO));
    let height = height.unwrap_or_else(|| Quantity::default_of(body.reach(), LENGTH_OR_NONE));
    let flat = Vec3::new(velocity.x, velocity.y, 0.0).norm();
    let throw = Throw {
        height,
        speed: speed.unwrap_or_else(|| Quantity::default_of(flat, SPEED)),
        spin_rate: spin_rate.unwrap_or_else(|| Quantity::default_of(spin.norm(), SPIN_RATE)),
        rise: velocity.z,
    };
    let start = released(&body, attitude?, throw.height.value, velocity, spin);
    Some(setup(shape, &heft, body, start, throw))
}

fn setup(shape: ThrownShape, heft: &MassSpec, body: Body, start: State, throw: Throw) -> Setup {
    let faces = shape.hull.faces();
    let stances = stances(&shape, heft.centre);
    Setup {
        points: shape.hull.sources().iter().map(ToString::to_string).collect(),
        drawing: drawing(&shape, heft.centre),
        faces: faces.iter().map(|face| -face.normal).collect(),
        pyramid: None,
        thrown: Some(ThrownBody {
            shape,
            centre: heft.centre,
            stances,
            homogeneous: heft.homogeneous,
            throw,
        }),
        body,
        start,
    }
}

/// How it stands on each face, of which only the part between the round edges touches.
fn stances(shape: &ThrownShape, centre: Vec3) -> Vec<Stance> {
    let (touches, radius) = shape.touching();
    let raised = |stance: Stance| Stance { height: stance.height + radius, ..stance };
    (0..touches.faces().len()).filter_map(|face| touches.stance(face, centre)).map(raised).collect()
}

/// Its surface; a round edge is drawn with two facets.
fn drawing(shape: &ThrownShape, centre: Vec3) -> SpatialDrawing {
    let places = shape.rounding.as_ref().map(|(rounding, _)| &rounding.shown);
    let size = |places: &[Vec3]| places.iter().map(|r| r.norm()).fold(0.0, f64::max);
    let round = places.and_then(|places| Polyhedron::of_points(places, FLAT_AS_WRITTEN * size(places)).ok());
    let hull = round.as_ref().unwrap_or(&shape.hull);
    SpatialDrawing {
        corners: hull.vertices().iter().map(|r| *r - centre).collect(),
        faces: hull.faces().iter().map(|face| face.corners.clone()).collect(),
        lines: vec![],
    }
}

/// A body that is let go with its lowest place at a height \[m\].
pub(super) fn released(body: &Body, attitude: Rotation, height: f64, velocity: Vec3, spin: Vec3) -> State {
    State { centre: Vec3::Z * (height - body.lowest(attitude)), attitude, velocity, spin }
}

/// The rotation from the drawing's axes into the world's; `None`, and a problem, where there is none.
fn attitude(root: &Section<'_>) -> Option<Rotation> {
    if root.is_bad("axis") || root.is_bad("turn") {
        return None;
    }
    let Some(axis) = triple(root, "axis").unwrap_or(DEFAULT_AXIS).unit() else {
        unfit(root, "axis", "must have a direction: not all of its components can be 0");
        return None;
    };
    Some(Rotation::by(axis * root.number("turn")))
}

/// Mass, mass centre and inertia: as written, or those of the shape, filled evenly.
pub(crate) fn heft(root: &Section<'_>, shape: Option<&ThrownShape>) -> Option<MassSpec> {
    let (mass, density) = (root.value("mass"), root.value("density"));
    let centre = triple(root, "centre");
    let moments = triple(root, "inertia");
    let products = triple(root, "inertia_products");
    let unread = [
        ("mass", mass.is_some()),
        ("density", density.is_some()),
        ("centre", centre.is_some()),
        ("inertia", moments.is_some()),
        ("inertia_products", products.is_some()),
    ];
    let is_unread = |(key, read): &(&str, bool)| root.has(key) && !read;
    let own = moments.map(|m| {
        let [xy, xz, yz] = products.unwrap_or(Vec3::ZERO).to_array();
        Mat3 { rows: [Vec3::new(m.x, xy, xz), Vec3::new(xy, m.y, yz), Vec3::new(xz, yz, m.z)] }
    });
    // Told at once: whatever else is wrong with the file must not hide it.
    let possible = own.is_none_or(|own| unread[4..].iter().any(is_unread) || is_possible(root, own));
    if !possible || unread.iter().any(is_unread) {
        return None;
    }
    let solid = shape?.solid;
    let mass = mass.or(density.map(|d| d * solid.volume)).unwrap_or_else(|| root.number("mass"));
    Some(MassSpec {
        mass,
        centre: centre.unwrap_or(solid.centre),
        homogeneous: centre.is_none() && own.is_none(),
        inertia: own.unwrap_or(solid.inertia * (mass / solid.volume)),
    })
}

/// Whether a body can have this inertia; a problem where none has.
fn is_possible(root: &Section<'_>, inertia: Mat3) -> bool {
    let still = RigidBody { mass: 1.0, inertia, velocity: Vec3::ZERO, spin: Vec3::ZERO };
    let problem = still.check().err().map(|problem| problem.to_string());
    if let Some(message) = &problem {
        // The key is named already.
        unfit(root, "inertia", message.strip_prefix("inertia: ").unwrap_or(message));
    }
    problem.is_none()
}

/// The largest of the principal radii of gyration over the smallest; 1 where one of them is not above 0, which is said elsewhere.
fn slenderness(inertia: Mat3) -> f64 {
    let ([smallest, _, largest], _) = principal(inertia);
    if smallest > 0.0 { (largest / smallest).sqrt() } else { 1.0 }
}

/// Whether following the body would take too long; a problem where it would.
fn is_too_slender(root: &Section<'_>, shape: &ThrownShape, heft: &MassSpec) -> bool {
    let slender = slenderness(shape.solid.inertia).max(slenderness(heft.inertia));
    if slender > SLENDEREST {
        let message = format!(
            "its radii of gyration are as {} to 1: bodies are followed up to {} to 1",
            Dimension::Number.show_digits(slender, 3),
            Dimension::Number.show_digits(SLENDEREST, 3)
        );
        let span = Some(root.key_span(shape.word));
        let problem = Problem::new(ProblemKind::Unsupported, shape.word, message, span);
        root.push(problem.with_help("are all lengths in one unit?"));
    }
    slender > SLENDEREST
}

/// Says which limits a body exceeds, and what to do instead; true where a face has too many corners.
fn within_limits(root: &Section<'_>, shape: &ThrownShape) -> bool {
    let ThrownShape { hull, word, .. } = shape;
    let told = |message: String, help: String| {
        let problem = Problem::new(ProblemKind::Unsupported, *word, message, Some(root.key_span(word)));
        root.push(problem.with_help(help));
    };
    // Without friction every set of corners that keep is asked for, with friction few of a face that speak for all.
    let rough = root.has("friction");
    let most = if rough { Supports::TOGETHER } else { MOST_POINTS as usize };
    let wide = hull.faces().iter().filter(|face| face.corners.len() > most).count();
    if wide > 0 {
        let largest = hull.faces().iter().map(|face| face.corners.len()).max().unwrap_or_default();
        let have = if wide == 1 { "1 of its faces has" } else { &format!("{wide} of its faces have") };
        let (with, other) = if rough {
            ("with friction ", format!("without friction {MOST_POINTS}"))
        } else {
            ("without friction ", format!("with friction {}", Supports::TOGETHER))
        };
        let message = format!(
            "{have} more than {most} corners, up to {largest}: all corners of a face can touch at once, and {with}at most {most} contacts are followed"
        );
        told(message, format!("draw its circles with fewer sides, at most {most}; {other}"));
    }
    let count = hull.vertices().len();
    if count > Body::MOST {
        let message = format!("its hull has {count} vertices: at most {} are followed", Body::MOST);
        told(message, "draw it with fewer facets: what lies within the hull does not count".to_owned());
    }
    wide > 0
}

fn body(root: &Section<'_>, shape: &ThrownShape, heft: &MassSpec) -> Option<Body> {
    let word = &shape.word;
    let wide = within_limits(root, shape);
    let stances = stances(shape, heft.centre);
    if let Some(out) = stances.iter().map(|s| -s.height).filter(|out| *out >= 0.0).max_by(f64::total_cmp) {
        unfit(root, "centre", format!("is {out:.6} m outside the hull: no body has its mass centre there"));
        return None;
    }
    if is_too_slender(root, shape, heft) {
        return None;
    }
    let (touches, radius) = shape.touching();
    let feature = |r: &Vec3| Feature::point(*r - heft.centre).rounded(radius);
    match Body::of(heft.mass, heft.inertia, touches.vertices().iter().map(feature).collect()) {
        Ok(body) if !wide => Some(body),
        Ok(_) => None,
        Err(problems) => {
            let told = problems.iter().filter(|p| !matches!(p, BodyProblem::Count { .. }));
            for problem in told {
                let key = match problem {
                    BodyProblem::Mass(_) if root.has("inertia") => "inertia",
                    BodyProblem::Mass(_) => "mass",
                    _ => *word,
                };
                let message = problem.to_string();
                // The key is named already.
                unfit(root, key, message.strip_prefix("inertia: ").unwrap_or(&message));
            }
            if problems.is_empty() {
                unfit(root, "mass", "makes an inertia that is too large or too small to compute with");
            }
            None
        }
    }
}
