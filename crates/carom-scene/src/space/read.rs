//! A solid part as a scene describes it, and which scenes have one.

use crate::drawing::{MassSpec, Outline, PartDrawing};
use crate::grammar::{Section, shows_a_solid as described};
use crate::input::Beside;
use crate::node::{Node, Value};
use crate::part_drawing::SolidDrawing;
use crate::problem::{Problem, ProblemKind};
use crate::roll::spatial::{read_mass, read_shape};

/// True of a scene whose part is a solid.
pub(crate) fn is_solid(tree: &Node) -> bool {
    matches!(&tree.value, Value::Table(entries) if described(entries))
}

/// The same of a scene that is being read.
pub(crate) fn is_in_space(root: &Section<'_>) -> bool {
    root.knows("groove")
}

/// What is said of a scene in space to whoever asks what is known of scenes in the plane alone.
pub(crate) fn refused_in_the_plane(tree: &Node) -> Option<Problem> {
    is_solid(tree).then(|| {
        let message = "is a solid: only `carom run`, `carom faces`, `carom draw`, `carom yield`, `carom map`, `carom sweep` and `carom design` follow parts in space so far";
        let span = match &tree.value {
            Value::Table(entries) => {
                entries.iter().find(|entry| entry.key == "part").map(|e| e.key_span.clone())
            }
            _ => None,
        };
        let problem = Problem::new(ProblemKind::Unsupported, "part", message, span);
        problem.with_help("a part that moves in the plane has an outline: shape = \"box\", \"polygon\" …")
    })
}

/// The shape of a solid and what fills it do not vary: a tolerance there would be written for nothing.
fn refuse_tolerances(section: &Section<'_>) {
    let vectors = ["box", "centre", "inertia", "inertia_products"].map(|key| (key, section.vector::<3>(key)));
    let vertices = section.vectors::<3>("vertices").map(|all| all.into_iter().flatten().collect::<Vec<_>>());
    let numbers = ["corner_radius", "flatness"].map(|key| (key, section.quantity_if_known(key)));
    let all = vectors.into_iter().map(|(key, of)| (key, of.map(Vec::from)));
    let all =
        all.chain([("vertices", vertices)]).chain(numbers.map(|(key, of)| (key, of.map(|of| vec![of]))));
    for (key, quantities) in all {
        if quantities.is_some_and(|all| all.iter().any(|quantity| quantity.tolerance.is_some())) {
            let message =
                "has a tolerance, and the shape of a solid part does not vary: write its middle alone";
            section.blame(ProblemKind::Unsupported, key, message);
        }
    }
}

/// Reads `[part]` of a scene in space; an STL file is looked for beside the scene.
pub(crate) fn read_solid(root: &Section<'_>, beside: Beside<'_>) -> Option<PartDrawing> {
    let section = root.section("part")?;
    refuse_tolerances(&section);
    let shape = read_shape(&section, beside);
    let written = section.has("mass") || section.has("density");
    let heft = if written { read_mass(&section, shape.as_ref()) } else { None };
    let mass = match section.quantity("mass") {
        Some(mass) => MassSpec::Mass(mass),
        None => MassSpec::Density { density: section.quantity("density")?, depth: None },
    };
    let (shape, heft) = (shape?, heft?);
    let own = !heft.homogeneous;
    let solid = SolidDrawing {
        shape,
        centre: own.then_some(heft.centre),
        inertia: section.has("inertia").then_some(heft.inertia),
    };
    Some(PartDrawing {
        outline: Outline::Solid(Box::new(solid)),
        mass_centre: None,
        corner_radius: None,
        mass,
        inertia: None,
        span: section.span(),
    })
}
