//! `[part]` and `[contact]`.

use crate::chain::read_chain;
use crate::contact_table::NamedContact;
use crate::drawing::{ContactDrawing, MassCentre, MassSpec, Outline, PartDrawing, ShapeWord, Surface};
use crate::grammar::Section;
use crate::grammar::kind::{MASS, RESTITUTION};
use crate::input::Beside;
use crate::quantity::Quantity;
use crate::read_library::read_library;
use crate::read_outline::read_outline_file;
use carom_impact::Law;

/// Reads `[part]`; the file of an outline is looked for beside the scene.
pub(crate) fn read_part(root: &Section<'_>, beside: Beside<'_>) -> Option<PartDrawing> {
    let section = root.section("part")?;
    let shape: ShapeWord = section.word("shape")?;
    let outline = read_outline(&section, shape, beside);
    let mass = read_mass(&section, shape);
    let inertia = section.quantity("inertia").filter(|_| mass.is_some());
    // A part without a good mass has its problem; its outline can still be judged, with any mass.
    let mass = mass.unwrap_or_else(|| MassSpec::Mass(Quantity::default_of(1.0, MASS)));
    let mass_centre =
        section.vector("mass_centre").map(|at| MassCentre { at, span: section.key_span("mass_centre") });
    let corner_radius = match shape {
        // Others draw their round corners themselves.
        ShapeWord::Rod | ShapeWord::Box | ShapeWord::Polygon => section.quantity("corner_radius"),
        _ => None,
    };
    let span = section.key_span("shape");
    Some(PartDrawing { outline: outline?, mass_centre, corner_radius, mass, inertia, span })
}

fn read_outline(section: &Section<'_>, shape: ShapeWord, beside: Beside<'_>) -> Option<Outline> {
    match shape {
        ShapeWord::Rod => Some(Outline::Rod { length: section.quantity("length")? }),
        ShapeWord::Box => {
            Some(Outline::Box { length: section.quantity("length")?, height: section.quantity("height")? })
        }
        ShapeWord::Disc => Some(Outline::Disc { radius: section.quantity("radius")? }),
        ShapeWord::Polygon => {
            let vertices = section.vectors("vertices")?;
            // Fewer are no polygon, which is told already.
            (vertices.len() >= 3).then_some(Outline::Polygon { vertices })
        }
        ShapeWord::Chain => Some(Outline::Chain { chain: read_chain(section, "points", true)? }),
        ShapeWord::Outline => read_outline_file(section, beside),
        ShapeWord::Bolt
        | ShapeWord::Washer
        | ShapeWord::Pin
        | ShapeWord::Cap
        | ShapeWord::Bracket
        | ShapeWord::Revolved => Some(Outline::Library(Box::new(read_library(section, shape)?))),
    }
}

fn read_mass(section: &Section<'_>, shape: ShapeWord) -> Option<MassSpec> {
    if section.has("mass") {
        return Some(MassSpec::Mass(section.quantity("mass")?));
    }
    let density = section.quantity("density")?;
    let depth = if shape.is_revolved() { None } else { Some(section.quantity("depth")?) };
    Some(MassSpec::Density { density, depth })
}

/// Reads `contact`, a name or a table. Its friction is needed only where a surface has none of its own.
pub(crate) fn read_contact(root: &Section<'_>) -> ContactDrawing {
    if let Some(named) = read_named(root) {
        return ContactDrawing {
            friction: Some(named.friction()),
            friction_written: true,
            restitution: named.restitution(),
            law: Law::default(),
            named: Some(named),
        };
    }
    let plastic = || Quantity::default_of(0.0, RESTITUTION);
    let Some(section) = root.section("contact") else {
        return ContactDrawing {
            friction: None,
            friction_written: false,
            restitution: plastic(),
            law: Law::default(),
            named: None,
        };
    };
    ContactDrawing {
        friction: section.quantity("friction"),
        friction_written: section.has("friction"),
        restitution: section.quantity_or_default("restitution").unwrap_or_else(plastic),
        law: section.word_or_default("law"),
        named: None,
    }
}

fn read_named(section: &Section<'_>) -> Option<&'static NamedContact> {
    section.text("contact").and_then(|(name, _)| NamedContact::of_name(name))
}

/// Reads a surface's own friction and restitution.
pub(crate) fn read_surface(section: &Section<'_>) -> Surface {
    if let Some(named) = read_named(section) {
        let (friction, restitution) = (Some(named.friction()), Some(named.restitution()));
        return Surface { friction, restitution, named: Some(named) };
    }
    Surface {
        friction: section.quantity("friction"),
        restitution: section.quantity("restitution"),
        named: None,
    }
}
