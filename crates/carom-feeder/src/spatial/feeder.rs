//! What stands on a feeder's drawing, and how wide it is.

use crate::feeder::{Stop, crossing};
use carom_impact::Law;
use carom_motion::spatial::{Body, BodyProblem, Polyhedron, Solid};
use carom_num::{Mat3, Vec2, Vec3};

/// A plane face of a part: on it the part may lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Unit normal, outwards, body axes.
    pub normal: Vec3,
    /// The points of the body at its corners, counter-clockwise as seen from outside.
    pub corners: Vec<usize>,
    /// How far it is from the mass centre [m].
    pub depth: f64,
}

/// A solid part: a rigid body, and the faces of its convex hull.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Mass, inertia, and the corners of its hull.
    pub body: Body,
    /// The faces of the hull.
    pub faces: Vec<Face>,
}

/// Why a hull and a mass make no part.
pub type PartProblem = Vec<BodyProblem>;

impl Part {
    /// A part whose surface is touched as its convex hull is, filled as `solid` says, of a density [kg/m³].
    ///
    /// # Errors
    /// All that is wrong with the body.
    ///
    /// # Example
    /// A cube of 1 m that is filled with 1000 kg/m³.
    /// ```
    /// use carom_feeder::spatial::Part;
    /// use carom_motion::spatial::{Polyhedron, examples::cube_corners};
    /// let hull = Polyhedron::of_points(&cube_corners(), 1e-9).unwrap();
    /// let cube = Part::of(&hull, &hull.solid().unwrap(), 1000.0)?;
    /// assert!((cube.body.mass() - 1000.0).abs() < 1e-9 && cube.faces.len() == 6);
    /// assert!(cube.faces.iter().all(|face| (face.depth - 0.5).abs() < 1e-15));
    /// # Ok::<(), Vec<carom_motion::spatial::BodyProblem>>(())
    /// ```
    pub fn of(hull: &Polyhedron, solid: &Solid, density: f64) -> Result<Self, PartProblem> {
        let (mass, inertia) = (density * solid.volume, solid.inertia * density);
        Self::about(hull, solid.centre, (mass, inertia))
    }

    /// The same of a known mass [kg] and inertia about a known mass centre [kg m², m].
    ///
    /// # Errors
    /// As [`Part::of`].
    pub fn about(hull: &Polyhedron, centre: Vec3, (mass, inertia): (f64, Mat3)) -> Result<Self, PartProblem> {
        let corners: Vec<Vec3> = hull.vertices().iter().map(|vertex| *vertex - centre).collect();
        let face = |face: &carom_motion::spatial::Face| Face {
            normal: face.normal,
            depth: face
                .corners
                .iter()
                .map(|i| face.normal.dot(corners[*i]))
                .fold(f64::NEG_INFINITY, f64::max),
            corners: face.corners.clone(),
        };
        let faces = hull.faces().iter().map(face).collect();
        Ok(Self { body: Body::new(mass, inertia, corners)?, faces })
    }

    /// The face with this unit normal, body axes; `None` where there is none.
    pub fn facing(&self, normal: Vec3) -> Option<usize> {
        self.faces.iter().position(|face| (face.normal - normal).norm() <= crate::tolerance::OPPOSITE)
    }

    /// The face that looks the other way, by its number; `None` where there is none.
    pub fn opposite(&self, face: usize) -> Option<usize> {
        self.facing(-self.faces.get(face)?.normal)
    }
}

/// A plate: flat, thin, with the same ends as in the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Plate {
    /// Its name.
    pub name: String,
    /// Uphill end, in the drawing [m].
    pub uphill: Vec2,
    /// Free edge, the downhill end [m].
    pub edge: Vec2,
    /// Its width across the drawing, half of it to either side [m]; `None` where it is as wide as needed.
    pub width: Option<f64>,
    /// How far it is turned about the line from its uphill end to its free edge, clockwise as seen down that line where it leads to the right [rad]: a positive one lowers the side
    /// that is towards whoever looks at the drawing.
    pub roll: f64,
    /// Height of the walls along its two sides, square to it [m]; 0 where there are none.
    pub side_walls: f64,
    /// Friction against the part.
    pub friction: f64,
    /// Restitution against the part.
    pub restitution: f64,
    /// True where the drawing gives the plate no length and it is as long as needed: pictures may cut it.
    pub unbounded: bool,
}

/// What a wall is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WallForm {
    /// A line of the drawing from one end to the other [m], as wide as needed.
    Across {
        /// One end.
        from: Vec2,
        /// The other end.
        to: Vec2,
    },
    /// A plane without ends beside the drawing, parallel to it: at this z [m], touched from the side of the drawing. Two of them make a groove.
    Beside {
        /// Where it is.
        z: f64,
    },
}

/// Another obstacle.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// Its name.
    pub name: String,
    /// Where it is.
    pub form: WallForm,
    /// Friction against the part.
    pub friction: f64,
    /// Restitution against the part.
    pub restitution: f64,
}

/// How the part starts: lying flat on the first plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// From the mass centre to the first plate's free edge, along the plate [m].
    pub to_edge: f64,
    /// From the middle of the plate to the mass centre, across it: towards whoever looks at the drawing [m].
    pub aside: f64,
    /// How far the part is turned on the plate, counter-clockwise as seen from above it [rad]. At 0 the body's axes are those of the drawing, but for the least turn that lays
    /// the face down (about z where it is half a turn), and the slope of the plate.
    pub turn: f64,
    /// Speed down the plate [m/s].
    pub speed: f64,
    /// The face that is down.
    pub face: usize,
}

/// A feeder in space.
#[derive(Clone, Debug, PartialEq)]
pub struct Feeder {
    /// Gravity, downwards [m/s²].
    pub gravity: f64,
    /// When a run stops.
    pub stop: Stop,
    /// Restitution law.
    pub law: Law,
    /// The part.
    pub part: Part,
    /// How it starts.
    pub start: Start,
    /// The plates, in the order the part meets them.
    pub plates: Vec<Plate>,
    /// Other obstacles.
    pub walls: Vec<Wall>,
}

impl Feeder {
    /// Pairs of plates whose middle lines cross in the drawing, by their numbers: such a feeder can be run, but not built. Plates that only touch do not cross, and plates as
    /// long as needed do not count. Side walls are not looked at.
    pub fn crossing_plates(&self) -> Vec<(usize, usize)> {
        let drawn = |plate: &Plate| if plate.unbounded { vec![] } else { vec![(plate.uphill, plate.edge)] };
        crossing(&self.plates.iter().map(drawn).collect::<Vec<_>>())
    }
}
