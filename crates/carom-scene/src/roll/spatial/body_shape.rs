//! The shape of a body that is thrown: a box, the hull of vertices, or a surface from a file.

use super::setup::triple;
use super::stl;
use crate::grammar::Section;
use crate::input::Beside;
use crate::problem::ProblemKind;
use crate::quantity::Quantity;
use crate::roll::bodies::unfit;
use crate::tolerance::{CONVEX, FLAT_AS_WRITTEN};
use crate::unit::Dimension;
use carom_motion::spatial::{HullProblem, Mesh, PiecesProblem, Polyhedron, Rounding, RoundingProblem, Solid};
use carom_num::Vec3;

/// Lengths of the box where no shape is written \[m\].
const DEFAULT_BOX: Vec3 = Vec3::new(0.06, 0.04, 0.025);
const FLAT_IN_A_FILE: f64 = 16.0 * f32::EPSILON as f64;
/// Convex pieces of one part. Contacts are looked for between each of them and each plate.
const MOST_PIECES: usize = 64;
const FEWER_FACETS: &str = "draw round hollows with fewer facets";
const LEAVE_HOLLOWS: &str = "leave hollows out: then the part touches with its hull";
/// The length of 1 in a file that says nothing else \[m\].
const MILLIMETRE: f64 = 1e-3;

/// The shape as it is drawn.
///
/// # Example
/// A box has eight points and a volume of 60 mm × 40 mm × 20 mm.
/// ```
/// use carom_scene::*;
/// let text = "box = [0.06, 0.04, 0.02]\nmass = 1\nturn = 0\nheight = 0.2";
/// let brick = SpatialRollProblem::parse(SpatialRollKind::Body, "brick.toml", text, &[])?;
/// let shape = brick.thrown.unwrap().shape;
/// assert_eq!((shape.word, shape.points, shape.convex), ("box", 8, true));
/// assert!((shape.solid.volume - 4.8e-5).abs() < 1e-18);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ThrownShape {
    /// box, vertices or file.
    pub word: &'static str,
    /// The file that it comes from.
    pub file: Option<String>,
    /// The convex hull, which touches the plane, in the axes of the drawing.
    pub hull: Polyhedron,
    /// What is filled: the hull, or the surface of a file that is not convex.
    pub solid: Solid,
    /// True where the hull is filled.
    pub convex: bool,
    /// The convex pieces with which it touches where its hollows count; none where its hull touches.
    pub pieces: Vec<Polyhedron>,
    /// Points that were given.
    pub points: usize,
    /// What rounds its edges and corners, and the radius \[m\]; `None` where they are sharp.
    pub rounding: Option<(Rounding, f64)>,
}

impl ThrownShape {
    /// The polyhedron at whose vertices it touches with balls, and their radius \[m\]: 0 of a sharp one.
    pub(crate) fn touching(&self) -> (&Polyhedron, f64) {
        self.rounding.as_ref().map_or((&self.hull, 0.0), |(rounding, radius)| (&rounding.inner, *radius))
    }
}

/// Points, the surface they are of, and the key they come from.
struct Drawn {
    word: &'static str,
    file: Option<String>,
    points: Vec<Vec3>,
    surface: Option<Mesh>,
    /// What counts as flat, in units of the largest coordinate.
    flat: f64,
}

/// The shape that a file describes; STL files are looked for beside it.
pub(crate) fn read(root: &Section<'_>, beside: Beside<'_>) -> Option<ThrownShape> {
    let unit = unit(root);
    let flatness = root.value("flatness");
    let sides = triple(root, "box");
    let drawn = match (root.has("vertices"), root.text("file")) {
        (true, _) => Drawn {
            word: "vertices",
            file: None,
            points: places(root)?,
            surface: None,
            flat: FLAT_AS_WRITTEN,
        },
        (false, Some((name, _))) => {
            let drawn = surface(root, beside, name, unit.unwrap_or(MILLIMETRE));
            unit.and(drawn)?
        }
        (false, None) if root.has("file") || root.has("box") && sides.is_none() => return None,
        (false, None) => Drawn {
            word: "box",
            file: None,
            points: cuboid(sides.unwrap_or(DEFAULT_BOX)),
            surface: None,
            flat: FLAT_AS_WRITTEN,
        },
    };
    let radius = root.quantity_if_known("corner_radius").map(|radius| radius.value);
    let shape = shaped(root, drawn, flatness)?;
    match radius {
        Some(radius) => rounded(root, shape, radius),
        None => (!root.has("corner_radius")).then_some(shape),
    }
}

/// The same shape with round edges.
fn rounded(root: &Section<'_>, shape: ThrownShape, radius: f64) -> Option<ThrownShape> {
    let unfit = |message: String| {
        root.blame(ProblemKind::Geometry, "corner_radius", message);
        None
    };
    if !shape.convex {
        return unfit("rounds a convex body, and the surface of the file is not convex".to_owned());
    }
    let corner = |vertex: usize| shape.hull.sources().get(vertex).copied().unwrap_or_default();
    match shape.hull.rounded(radius) {
        Ok(rounding) => {
            Some(ThrownShape { solid: rounding.solid, rounding: Some((rounding, radius)), ..shape })
        }
        Err(RoundingProblem::Vanishes { face }) => {
            let corners = shape.hull.faces().get(face).map_or(&[][..], |face| &face.corners);
            let names: Vec<String> = corners.iter().map(|vertex| corner(*vertex).to_string()).collect();
            unfit(format!("is too large: nothing of the face {} would stay plane", names.join(", ")))
        }
        Err(RoundingProblem::Faces { vertex, faces }) => {
            let found =
                format!("rounds corners of three faces, and at point {} there are {faces}", corner(vertex));
            unfit(format!(
                "{found}; a flatness joins faces that are one but for the digits that were written"
            ))
        }
        Err(problem) => unfit(problem.to_string()),
    }
}

/// How long 1 in a file is \[m\].
fn unit(root: &Section<'_>) -> Option<f64> {
    match root.text("unit") {
        Some((symbol, _)) => Dimension::Length.unit(symbol).map(|unit| unit.to_si(1.0)),
        None => (!root.has("unit")).then_some(MILLIMETRE),
    }
}

/// Corners of a box about the origin: the first at its lowest coordinates, then along x, y and z.
fn cuboid(sides: Vec3) -> Vec<Vec3> {
    let half = sides * 0.5;
    let sign = |i: usize, digit: usize| if i >> digit & 1 == 1 { 1.0 } else { -1.0 };
    (0..8).map(|i| Vec3::new(sign(i, 0) * half.x, sign(i, 1) * half.y, sign(i, 2) * half.z)).collect()
}

/// The places of a list, every one of which must be good.
fn places(root: &Section<'_>) -> Option<Vec<Vec3>> {
    let point = |[x, y, z]: [Quantity; 3]| Vec3::new(x.value, y.value, z.value);
    Some(root.vectors("vertices")?.into_iter().map(point).collect())
}

fn surface(root: &Section<'_>, beside: Beside<'_>, name: &str, unit: f64) -> Option<Drawn> {
    let mesh = match stl::read(beside, name, unit) {
        Ok(mesh) => mesh,
        Err(why) => {
            unfit_file(root, ProblemKind::File, format!("{name}: {why}"));
            return None;
        }
    };
    let points = mesh.vertices.clone();
    let file = Some(name.to_owned());
    Some(Drawn { word: "file", file, points, surface: Some(mesh), flat: FLAT_IN_A_FILE })
}

fn unfit_file(root: &Section<'_>, kind: ProblemKind, message: String) {
    root.blame(kind, "file", message);
}

/// The hull, and what is filled.
fn shaped(root: &Section<'_>, drawn: Drawn, flatness: Option<f64>) -> Option<ThrownShape> {
    let Drawn { word, file, points, surface, flat } = drawn;
    let largest = points.iter().flat_map(|r| r.to_array()).map(f64::abs).fold(0.0, f64::max);
    let flatness = flatness.unwrap_or(flat * largest);
    let hull = Polyhedron::of_points(&points, flatness);
    let own = surface.as_ref().map(Mesh::solid);
    // Of a surface without a volume the sides say nothing.
    let is_solid = |hull: &Result<Polyhedron, Vec<HullProblem>>| match hull {
        Ok(_) => true,
        Err(problems) => problems.iter().all(|p| matches!(p, HullProblem::Unclear { .. })),
    };
    if let Some(Err(problems)) = own.as_ref().filter(|_| is_solid(&hull)) {
        let name = file.as_deref().unwrap_or_default();
        for words in stl::in_words(problems) {
            unfit_file(root, ProblemKind::Geometry, format!("{name}: {words}"));
        }
    }
    let hull = hull.map_err(|problems| not_a_hull(root, word, file.as_deref(), &problems)).ok()?;
    let filled = match hull.solid() {
        Ok(filled) => filled,
        Err(problems) => {
            stl::in_words(&problems).into_iter().for_each(|words| unfit(root, word, words));
            return None;
        }
    };
    let own = match own {
        None => filled,
        Some(own) => own.ok()?,
    };
    if own.volume > filled.volume * (1.0 + CONVEX) {
        let (own, hull) = (own.volume, filled.volume);
        let message = format!(
            "the surface encloses {own:.6e} m³, and its hull {hull:.6e} m³: it cuts itself, or has a facet twice"
        );
        unfit_file(root, ProblemKind::Geometry, message);
        return None;
    }
    let convex = own.volume >= filled.volume * (1.0 - CONVEX);
    let pieces = match surface {
        Some(mesh) if !convex => in_pieces(root, &mesh, flatness)?,
        _ => vec![],
    };
    Some(ThrownShape {
        word,
        file,
        points: points.len(),
        solid: if convex { filled } else { own },
        hull,
        convex,
        pieces,
        rounding: None,
    })
}

/// The convex pieces of a surface, where its hollows count.
fn in_pieces(root: &Section<'_>, mesh: &Mesh, flatness: f64) -> Option<Vec<Polyhedron>> {
    if !(root.knows("hollows") && root.flag("hollows")) {
        return Some(vec![]);
    }
    let told = |problem: &PiecesProblem| {
        let too_many = matches!(problem, PiecesProblem::TooMany { .. });
        let message = if too_many {
            format!("{problem}: {FEWER_FACETS}, or {LEAVE_HOLLOWS}")
        } else {
            format!("{problem}; a larger flatness joins such faces, or {LEAVE_HOLLOWS}")
        };
        root.blame(ProblemKind::Geometry, "hollows", message);
    };
    mesh.pieces(flatness, MOST_PIECES).inspect_err(told).ok()
}

/// Says why points have no hull.
fn not_a_hull(root: &Section<'_>, word: &'static str, file: Option<&str>, problems: &[HullProblem]) {
    for problem in problems {
        let key = match problem {
            HullProblem::Unclear { .. } if root.has("flatness") => "flatness",
            _ => word,
        };
        let name = file.filter(|_| key == word).map_or(String::new(), |file| format!("{file}: "));
        unfit(root, key, format!("{name}{problem}"));
    }
}
