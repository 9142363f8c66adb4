//! What is said of a polyhedron that is thrown: its mass, its faces, and on which it rests.

use super::throws::face_of;
use super::{SpatialRollProblem, SpatialRollRun, ThrownBody};
use crate::tolerance::BALANCED;
use carom_motion::spatial::{End, Face, Stance, State, Supports};
use carom_num::principal::principal;
use carom_num::{Mat3, Vec3};
use schemars::JsonSchema;
use serde::Serialize;

/// A polyhedron. Axes are those of its drawing.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ThrownBodyReport {
    /// box, vertices or file.
    #[schemars(extend("enum" = ["box", "vertices", "file"]))]
    pub shape: &'static str,
    /// The file that it comes from; null where there is none.
    pub file: Option<String>,
    /// False where the file's surface is not convex: then mass centre and inertia are those of the surface, and the plane is touched by its hull.
    pub convex: bool,
    /// Points that were given.
    pub points: usize,
    /// Radius of its edges and corners [m]; null where they are sharp.
    pub corner_radius_m: Option<f64>,
    /// Vertices of the hull, as drawn and not rounded: their names, which are the numbers of the points, and their places [m].
    pub vertices: Vec<ThrownVertexReport>,
    /// How far a vertex was moved at most to bring it onto its faces [m].
    pub moved_m: f64,
    /// Volume [m³].
    pub volume_m3: f64,
    /// Mass over volume [kg/m³].
    pub density_kg_m3: f64,
    /// The mass centre [m].
    pub centre_m: [f64; 3],
    /// Inertia about the mass centre, by rows [kg m²].
    pub inertia_kg_m2: [[f64; 3]; 3],
    /// Principal moments, ascending [kg m²].
    pub principal_moments_kg_m2: [f64; 3],
    /// The unit axis of each, right-handed.
    pub principal_axes: [[f64; 3]; 3],
    /// True where mass centre and inertia follow from the shape.
    pub homogeneous: bool,
    /// Its faces: the number of a face is its place here.
    pub faces: Vec<ThrownFaceReport>,
}

/// A vertex of the hull.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ThrownVertexReport {
    /// The number of the point.
    pub name: String,
    /// Its place [m].
    pub place_m: [f64; 3],
}

/// A face of the hull.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ThrownFaceReport {
    /// Its number.
    pub face: usize,
    /// Its corners, counter-clockwise as seen from outside.
    pub vertices: Vec<String>,
    /// Unit normal, outwards.
    pub normal: [f64; 3],
    /// Height of the mass centre over it [m].
    pub centre_height_m: f64,
    /// How far inside the face the mass centre's projection is; negative where it is outside [m].
    pub margin_m: f64,
    /// True where the body can rest on it: the projection is inside.
    pub stable: bool,
}

/// On what it rests, and what became of its energy.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RestingReport {
    /// The face that is down; null where it does not rest on one.
    pub face: Option<usize>,
    /// Its unit normal, outwards, in the drawing's axes; at rest it points down.
    pub normal: Option<[f64; 3]>,
    /// Its vertices.
    pub vertices: Vec<String>,
    /// Those of them that are held.
    pub held: Vec<String>,
    /// How far inside the face the mass centre's projection is [m].
    pub margin_m: Option<f64>,
    /// Kinetic energy at the release, and potential energy above the plane [J].
    #[serde(rename = "energy_start_J")]
    pub energy_start: f64,
    /// The same at the end [J].
    #[serde(rename = "energy_end_J")]
    pub energy_end: f64,
}

impl ThrownBody {
    /// Which face a body rests on that holds these supports; `None` where they belong to no face together.
    pub fn face_of(&self, held: Supports) -> Option<usize> {
        face_of(self.shape.hull.faces().iter().map(|face| &face.corners[..]), held)
    }
}

impl ThrownBodyReport {
    /// Of the body of a problem; `None` where it is none that is thrown.
    pub fn new(problem: &SpatialRollProblem) -> Option<Self> {
        let thrown = problem.thrown.as_ref()?;
        let (body, hull) = (problem.world.body(), &thrown.shape.hull);
        let (moments, axes) = principal(body.inertia());
        let vertices = problem.points.iter().zip(hull.vertices());
        let vertices =
            vertices.map(|(name, r)| ThrownVertexReport { name: name.clone(), place_m: r.to_array() });
        Some(Self {
            shape: thrown.shape.word,
            file: thrown.shape.file.clone(),
            convex: thrown.shape.convex,
            points: thrown.shape.points,
            corner_radius_m: thrown.shape.rounding.as_ref().map(|(_, radius)| *radius),
            vertices: vertices.collect(),
            moved_m: hull.moved(),
            volume_m3: thrown.shape.solid.volume,
            density_kg_m3: body.mass() / thrown.shape.solid.volume,
            centre_m: thrown.centre.to_array(),
            inertia_kg_m2: rows(body.inertia()),
            principal_moments_kg_m2: moments,
            principal_axes: axes.map(Vec3::to_array),
            homogeneous: thrown.homogeneous,
            faces: faces(problem, thrown),
        })
    }
}

fn rows(m: Mat3) -> [[f64; 3]; 3] {
    m.rows.map(Vec3::to_array)
}

fn faces(problem: &SpatialRollProblem, thrown: &ThrownBody) -> Vec<ThrownFaceReport> {
    let of = |(face, (shape, stance)): (usize, (&Face, &Stance))| ThrownFaceReport {
        face,
        vertices: shape.corners.iter().filter_map(|i| problem.points.get(*i).cloned()).collect(),
        normal: shape.normal.to_array(),
        centre_height_m: stance.height,
        margin_m: stance.margin,
        stable: stance.margin > BALANCED * problem.world.body().reach(),
    };
    thrown.shape.hull.faces().iter().zip(&thrown.stances).enumerate().map(of).collect()
}

impl RestingReport {
    /// Of a run of a body that is thrown.
    pub fn new(problem: &SpatialRollProblem, run: &SpatialRollRun) -> Option<Self> {
        let thrown = problem.thrown.as_ref()?;
        let held = match run.end {
            Some(End::AtRest { held }) => held,
            _ => Supports::NONE,
        };
        let face = thrown.face_of(held).filter(|_| !held.is_empty());
        let shape = face.and_then(|face| thrown.shape.hull.faces().get(face));
        let energy = |state: &State| {
            let body = problem.world.body();
            state.kinetic(body) + state.potential(&problem.world)
        };
        Some(Self {
            face,
            normal: shape.map(|shape| shape.normal.to_array()),
            vertices: shape.map_or(vec![], |shape| {
                shape.corners.iter().filter_map(|i| problem.points.get(*i).cloned()).collect()
            }),
            held: problem.names_of(held),
            margin_m: face.and_then(|face| thrown.stances.get(face)).map(|stance| stance.margin),
            energy_start: energy(&problem.start),
            energy_end: energy(&run.last),
        })
    }
}
