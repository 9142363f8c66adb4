//! What stands on a feeder's drawing, and how wide it is.

use crate::feeder::{Stop, crossing};
use crate::tolerance::DRAWN_FLAT;
use carom_impact::Law;
use carom_motion::spatial::{Body, BodyProblem, Feature, Polyhedron, Solid};
use carom_num::{Mat3, Vec2, Vec3};

/// A plane face of a part: on it the part may lie.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Unit normal, outwards, body axes.
    pub normal: Vec3,
    /// The points of the body at its corners, counter-clockwise as seen from outside; of a rounded part the middles of the balls there.
    pub corners: Vec<usize>,
    /// How far it is from the mass centre [m].
    pub depth: f64,
}

/// A solid part: a rigid body, and the faces of its convex hull.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// Mass, inertia, and the corners of its hull, sharp or with a ball of one radius about each.
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
        Self::about((hull, 0.0), solid.centre, (mass, inertia))
    }

    /// The same of a known mass [kg] and inertia about a known mass centre [kg m², m]. The hull is rounded by balls of a radius [m] about all of its places; 0 leaves it sharp.
    ///
    /// # Errors
    /// As [`Part::of`].
    ///
    /// # Example
    /// A cube of 1 m whose edges are rounded by 0.1 m: its faces stay where they are.
    /// ```
    /// use carom_feeder::spatial::Part;
    /// use carom_motion::spatial::{Polyhedron, examples::cube_corners};
    /// let rounding = Polyhedron::of_points(&cube_corners(), 1e-9).unwrap().rounded(0.1).unwrap();
    /// let solid = rounding.solid;
    /// let cube = Part::about((&rounding.inner, 0.1), solid.centre, (solid.volume, solid.inertia))?;
    /// assert_eq!(cube.body.rounding(), Some(0.1));
    /// assert!(cube.faces.iter().all(|face| (face.depth - 0.5).abs() < 1e-15));
    /// # Ok::<(), Vec<carom_motion::spatial::BodyProblem>>(())
    /// ```
    pub fn about(
        (hull, radius): (&Polyhedron, f64),
        centre: Vec3,
        (mass, inertia): (f64, Mat3),
    ) -> Result<Self, PartProblem> {
        let corners: Vec<Vec3> = hull.vertices().iter().map(|vertex| *vertex - centre).collect();
        let face = |face: &carom_motion::spatial::Face| Face {
            normal: face.normal,
            depth: face
                .corners
                .iter()
                .map(|i| face.normal.dot(corners[*i]))
                .fold(f64::NEG_INFINITY, f64::max)
                + radius,
            corners: face.corners.clone(),
        };
        let faces = hull.faces().iter().map(face).collect();
        let features = corners.iter().map(|r| Feature::point(*r).rounded(radius)).collect();
        Ok(Self { body: Body::of(mass, inertia, features)?, faces })
    }

    /// Its surface as a picture has it, body axes [m]: corners, and faces by their corners, counter-clockwise as seen from outside. Those of the part come first, by their
    /// numbers; of a rounded one facets between them follow, two along a round edge.
    ///
    /// # Example
    /// A rounded cube: its 6 faces come first.
    /// ```
    /// use carom_feeder::spatial::Part;
    /// use carom_motion::spatial::{Polyhedron, examples::cube_corners};
    /// let rounding = Polyhedron::of_points(&cube_corners(), 1e-9).unwrap().rounded(0.1).unwrap();
    /// let solid = rounding.solid;
    /// let cube = Part::about((&rounding.inner, 0.1), solid.centre, (solid.volume, solid.inertia))?;
    /// let (corners, faces) = cube.shown();
    /// assert!(faces.len() > 6 && faces[0].len() == 4);
    /// assert!(faces[2].iter().all(|corner| (cube.faces[2].normal.dot(corners[*corner]) - 0.5).abs() < 1e-12));
    /// # Ok::<(), Vec<carom_motion::spatial::BodyProblem>>(())
    /// ```
    pub fn shown(&self) -> (Vec<Vec3>, Vec<Vec<usize>>) {
        let corners = self.body.supports();
        let sharp = || (corners.to_vec(), self.faces.iter().map(|face| face.corners.clone()).collect());
        let Some(radius) = self.body.rounding().filter(|radius| *radius > 0.0) else { return sharp() };
        let around = |corner: usize| self.faces.iter().filter(move |face| face.corners.contains(&corner));
        let mut places = vec![];
        for (corner, at) in corners.iter().enumerate() {
            let normals: Vec<Vec3> = around(corner).map(|face| face.normal).collect();
            let pairs =
                normals.iter().enumerate().flat_map(|(k, a)| normals[k..].iter().map(move |b| *a + *b));
            let all = normals.iter().fold(Vec3::ZERO, |sum, normal| sum + *normal);
            places.extend(pairs.chain([all]).filter_map(Vec3::unit).map(|out| *at + out * radius));
        }
        let flatness = DRAWN_FLAT * self.body.reach();
        let Ok(hull) = Polyhedron::of_points(&places, flatness) else { return sharp() };
        let own = |face: &carom_motion::spatial::Face| self.facing(face.normal).unwrap_or(usize::MAX);
        let mut faces: Vec<&carom_motion::spatial::Face> = hull.faces().iter().collect();
        faces.sort_by_key(|face| own(face));
        (hull.vertices().to_vec(), faces.into_iter().map(|face| face.corners.clone()).collect())
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

/// What a plate is like across its line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum CrossSection {
    /// Flat, its sides open.
    #[default]
    Flat,
    /// Flat, with walls along both sides, square to it.
    Walled {
        /// How high they are [m].
        height: f64,
    },
    /// Two flanks of a V groove, whose bottom is the line.
    Groove {
        /// The angle between them [rad].
        angle: f64,
    },
}

impl CrossSection {
    /// True of a V groove.
    pub fn is_groove(self) -> bool {
        matches!(self, Self::Groove { .. })
    }
}

/// A plate, thin, with the same ends as in the drawing: flat, or two flanks of a V groove along the line between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Plate {
    /// Its name.
    pub name: String,
    /// Uphill end, in the drawing [m].
    pub uphill: Vec2,
    /// Free edge, the downhill end [m].
    pub edge: Vec2,
    /// Its width across the drawing, half of it to either side [m]; of a groove how wide it opens. `None` where it is as wide as needed.
    pub width: Option<f64>,
    /// How far it is turned about the line from its uphill end to its free edge, clockwise as seen down that line where it leads to the right [rad]: a positive one lowers the side
    /// that is towards whoever looks at the drawing.
    pub roll: f64,
    /// What it is like across.
    pub cross_section: CrossSection,
    /// Radius of its edges [m]: it is then a sheet twice as thick below its upper side, its ends half round, and its sides where no walls stand along them. Thin and sharp at 0.
    pub edge_radius: f64,
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
        /// Radius of its edges [m]: it is then a sheet twice as thick about that line, its ends half round. Thin and sharp at 0.
        edge_radius: f64,
    },
    /// A round bar: all places within a radius of the line between two ends [m].
    Pin {
        /// Its ends.
        ends: [Vec3; 2],
        /// Its radius [m].
        radius: f64,
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

/// How the part starts: lying flat on the first plate; in a groove on the flank behind, and against the other one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// From the mass centre to the first plate's free edge, along the plate [m].
    pub to_edge: f64,
    /// From the middle of the plate to the mass centre, across it: towards whoever looks at the drawing [m]. 0 in a groove, where both flanks say where it is.
    pub aside: f64,
    /// How far the part is turned on the plate, or on its flank, counter-clockwise as seen from above it [rad]. At 0 the body's axes are those of the drawing, but for the least turn that lays
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
