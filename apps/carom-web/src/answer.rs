//! The answer to a request.

use crate::bench::Bench;
use crate::reply::{Failure, Reply};
use crate::request::{Ask, Request};
use crate::{edit, study};
use carom::study::regions::Options;
use carom::tasks;
use carom_scene::Scene;
use carom_scene::input::InMemory;
use std::collections::BTreeMap;

impl Request {
    pub(crate) fn answer(&self) -> Result<Reply, Failure> {
        if let Some(changed) = self.changed() {
            return changed;
        }
        let scene = self.scene()?;
        match &self.ask {
            Ask::Strike { number } => {
                let html = carom_figure::live_strike(scene.feeder(), &scene.feeder().run()?, *number);
                Ok(Reply { html: Some(html), ..Reply::default() })
            }
            Ask::Limit { path } => {
                let limit = scene.limits_of(path).map(|(limit, _)| limit);
                Ok(Reply { limit: limit.map(Box::new), ..Reply::default() })
            }
            Ask::Yield { samples, seed } => study::yielded(&scene, *samples, *seed),
            Ask::Map { axes, cells, depth, accuracy } => {
                let options = Options { accuracy: *accuracy, depth: *depth };
                Ok(Reply { html: Some(study::map(&scene, axes, *cells, options)?), ..Reply::default() })
            }
            Ask::At { values } => {
                Ok(Reply { headline: Some(edit::ending_at(&scene, values)?), ..Reply::default() })
            }
            Ask::Files => {
                let (run, fed) = (scene.feeder().run()?, tasks::feed(&scene)?);
                let files = tasks::run_files(&scene, &run, fed.as_ref(), None)?;
                Ok(Reply { files: Some(named(files)), ..Reply::default() })
            }
            Ask::Drawings => Ok(Reply { files: Some(named(tasks::drawings(&scene))), ..Reply::default() }),
            Ask::Race { runs } => {
                for _ in 0..*runs {
                    scene.feeder().run_untraced()?;
                }
                Ok(Reply::default())
            }
            // All that changes or shows the scene was answered above.
            _ => Ok(Reply::default()),
        }
    }

    /// The scene as it is shown or after it was changed; `None` where neither is asked.
    fn changed(&self) -> Option<Result<Reply, Failure>> {
        let (window, text) = match &self.ask {
            Ask::Open { size } => {
                return Some(self.scene().map(|scene| Bench::fitting(&scene, *size).whole()));
            }
            Ask::Part { lines, size } => {
                let other =
                    self.scene().and_then(|scene| self.scene_of(&scene.text_replacing("part", lines)));
                return Some(other.map(|scene| Bench::fitting(&scene, *size).whole()));
            }
            Ask::Show { window } => (window, Ok(self.text.clone())),
            Ask::Write { path, value, window } => {
                (window, self.scene().and_then(|scene| edit::written(&scene, path, value)))
            }
            Ask::Drag { grip, to, snap, window } => {
                (window, self.scene().and_then(|scene| edit::dragged(&scene, grip, *to, *snap)))
            }
            Ask::Add { table, from, to, snap, window } => {
                (window, self.scene().map(|scene| edit::added(&scene, *table, [*from, *to], *snap)))
            }
            Ask::Remove { obstacle, window } => {
                (window, self.scene().and_then(|scene| edit::removed(&scene, *obstacle)))
            }
            Ask::Move { values, window } => {
                let read = |text: &str| self.scene_of(text);
                (window, self.scene().and_then(|scene| edit::moved(&scene, values, &read)))
            }
            _ => return None,
        };
        Some(text.and_then(|text| Ok(Bench::of(&self.scene_of(&text)?, window.view()?).whole())))
    }

    fn scene(&self) -> Result<Scene, Failure> {
        self.scene_of(&self.text)
    }

    fn scene_of(&self, text: &str) -> Result<Scene, Failure> {
        let files: InMemory =
            self.files.iter().map(|(name, text)| (name.into(), text.clone().into_bytes())).collect();
        Ok(Scene::parse_with(&self.name, text, &files)?)
    }
}

fn named<'n>(files: impl IntoIterator<Item = (&'n str, String)>) -> BTreeMap<String, String> {
    files.into_iter().map(|(name, text)| (name.to_owned(), text)).collect()
}
