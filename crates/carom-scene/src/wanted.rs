//! Does a run end as its designer wants?

use crate::drawing::Want;
use crate::scene::Scene;
use crate::space::SpaceScene;
use carom_feeder::{Landing, Verdict};
use carom_study::Landed;
use schemars::JsonSchema;
use serde::Serialize;

/// What is wanted on a plate, and whether a run has it.
///
/// # Example
/// What lands nowhere has not landed as wanted.
/// ```
/// use carom_scene::*;
/// let scene = Scene::read("../../examples/designer.toml".as_ref())?;
/// let run = scene.feeder().run_untraced().unwrap();
/// let nowhere = carom_feeder::Run { landings: vec![], ..run };
/// let Wanted { plate, want, met } = &scene.wanted(&nowhere)[0];
/// assert_eq!((plate.as_str(), want.as_str(), *met), ("lower", "turned", false));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Wanted {
    /// Name of the plate.
    pub plate: String,
    /// same, turned or face and its number.
    #[schemars(extend("pattern" = "^(same|turned|face [0-9]+)$"))]
    pub want: String,
    /// True where the part's first lying flat on the plate is as wanted; false too where it never lay flat on it.
    pub met: bool,
}

impl Scene {
    /// Each plate on which something is wanted, by a run.
    pub fn wanted(&self, run: &impl Landed) -> Vec<Wanted> {
        let names = self.feeder().plates.iter().map(|plate| plate.name.as_str());
        wanted(names, self.wants(), run.landings())
    }
}

impl SpaceScene {
    /// Each plate on which something is wanted, by a run.
    pub fn wanted(&self, run: &impl Landed) -> Vec<Wanted> {
        let names = self.feeder().plates.iter().map(|plate| plate.name.as_str());
        wanted(names, self.wants(), run.landings())
    }
}

fn wanted<'n>(
    names: impl Iterator<Item = &'n str>,
    wants: &[Option<Want>],
    landings: &[Landing],
) -> Vec<Wanted> {
    let of = |(i, (name, want)): (usize, (&str, &Option<Want>))| {
        let landing = landings.iter().find(|landing| landing.plate == i);
        let verdict = landing.and_then(|landing| landing.verdict);
        let (want, met) = match want.as_ref()? {
            Want::Any => return None,
            Want::Same => ("same".to_owned(), verdict == Some(Verdict::Same)),
            Want::Turned => ("turned".to_owned(), verdict == Some(Verdict::Turned)),
            Want::Face(face) => {
                let down = landing.and_then(|landing| landing.face);
                (format!("face {face}"), down == Some(*face))
            }
        };
        Some(Wanted { plate: name.to_owned(), want, met })
    };
    names.zip(wants).enumerate().filter_map(of).collect()
}
