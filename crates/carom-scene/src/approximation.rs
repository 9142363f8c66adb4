//! Where the engine computes with another part than the one that is drawn.

use schemars::JsonSchema;
use serde::Serialize;

/// What stands in for a drawn outline.
///
/// # Example
/// ```
/// use carom_scene::ApproximationKind;
/// assert_eq!(serde_json::to_string(&ApproximationKind::Chords)?, r#""chords""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ApproximationKind {
    /// Straight chords in place of curves, or corners left out.
    Chords,
    /// The convex hull in place of a surface with hollows.
    ConvexHull,
}

/// One way in which the computed part differs from the drawn one.
///
/// # Example
/// A bracket of lines and arcs is computed as it is drawn, and so is a rod.
/// ```
/// use carom_scene::*;
/// assert!(Scene::read("../../examples/bracket.toml".as_ref())?.approximations().is_empty());
/// assert!(Scene::read("../../examples/case_2.toml".as_ref())?.approximations().is_empty());
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Approximation {
    /// What stands in for the outline.
    pub kind: ApproximationKind,
    /// What is approximated: `part`.
    #[schemars(extend("const" = "part"))]
    pub of: &'static str,
    /// How far it differs: of chords the greatest distance from the outline, of a hull the share of it that the part does not fill.
    pub amount: f64,
    /// Unit of the amount: `m` of chords, `1` of a hull.
    #[schemars(extend("enum" = ["m", "1"]))]
    pub unit: &'static str,
    /// The same in a sentence.
    pub text: String,
}

impl Approximation {
    /// Of a surface whose hull touches in its place; `empty` is the share of the hull that it does not fill.
    pub(crate) fn hull_of_surface(empty: f64) -> Self {
        let text = format!(
            "the part touches with its convex hull: {:.1} % of the hull is hollow, and hollows = true in [part] lets these touch too; mass and inertia are those of the part itself",
            100.0 * empty
        );
        Self { kind: ApproximationKind::ConvexHull, of: "part", amount: empty, unit: "1", text }
    }
}
