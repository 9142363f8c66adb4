//! Where the engine computes with another part than the one that is drawn.

use schemars::JsonSchema;
use serde::Serialize;

/// What a hull is said to weigh like: the uniform outline, or what the scene says.
pub(crate) const AS_DRAWN: &str = "mass, mass centre and inertia are the outline's own, its holes left out";
const AS_GIVEN: &str = "mass centre and inertia are as the scene gives them";

/// What stands in for a drawn outline.
///
/// # Example
/// ```
/// use carom_scene::ApproximationKind;
/// assert_eq!(serde_json::to_string(&ApproximationKind::ConvexHull)?, r#""convex_hull""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ApproximationKind {
    /// The convex hull: hollows of the outline are filled. The part is another one, and may end otherwise.
    ConvexHull,
    /// Straight chords in place of curves, or corners left out.
    Chords,
}

/// One way in which the computed part differs from the drawn one.
///
/// # Example
/// A bracket is drawn with hollows, and touches with its convex hull; a rod is what it is drawn as.
/// ```
/// use carom_scene::*;
/// let bracket = Scene::read("../../examples/bracket.toml".as_ref())?;
/// let hull = &bracket.approximations()[0];
/// assert_eq!((hull.kind, hull.of, hull.unit), (ApproximationKind::ConvexHull, "part", "1"));
/// assert!(hull.amount > 0.0 && hull.warning().is_some());
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
    /// How far it differs: of a hull the area that it adds, as a share of the area within the outline; of chords the greatest distance from
    /// the outline.
    pub amount: f64,
    /// Unit of the amount: `1` or `m`.
    #[schemars(extend("enum" = ["1", "m"]))]
    pub unit: &'static str,
    /// The faces that are no sides of the outline: lines of the hull across hollows, or chords.
    pub faces: Vec<usize>,
    /// The same in a sentence.
    pub text: String,
}

impl Approximation {
    /// Of a part whose mass centre is given: says that how it weighs is as given, not the outline's.
    pub(crate) fn weighs_otherwise(&mut self) {
        self.text = self.text.replace(AS_DRAWN, AS_GIVEN);
    }

    /// What a verdict says beside itself, in capitals; `None` for chords, which are as near as the scene asks.
    pub fn warning(&self) -> Option<String> {
        let more = 100.0 * self.amount;
        let digits = usize::from(more < 10.0);
        (self.kind == ApproximationKind::ConvexHull)
            .then(|| format!("OF THE CONVEX HULL, NOT OF THE PART AS DRAWN (+{more:.digits$} % AREA)"))
    }
}
