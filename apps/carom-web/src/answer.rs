//! The answer to a request.

use crate::bench::Bench;
use crate::reply::{Failure, Reply};
use crate::request::{Ask, Change, Frame, Request, Study};
use crate::watch::Watch;
use crate::{design, edit, lab, study};
use carom::study::regions::Options;
use carom::tasks;
use carom::tasks::design::DesignPlan;
use carom_scene::Scene;
use carom_scene::input::InMemory;
use std::collections::BTreeMap;

impl Request {
    pub(crate) fn answer(&self, watch: &dyn Watch) -> Result<Reply, Failure> {
        match &self.ask {
            Ask::Show { change, frame } => self.shown(change.as_ref(), *frame),
            Ask::Study(study) => self.studied(study, watch),
        }
    }

    /// Everything about a scene or an impact after a change.
    fn shown(&self, change: Option<&Change>, frame: Frame) -> Result<Reply, Failure> {
        if carom_scene::is_impact(&self.text) {
            return lab::shown(&self.name, &self.text, change, frame);
        }
        let mut scene = self.scene_of(&self.text)?;
        if let Some(change) = change {
            scene = self.scene_of(&edit::changed(&scene, change, &|text| self.scene_of(text))?)?;
        }
        Ok(Bench::of(&scene, frame)?.whole())
    }

    fn studied(&self, study: &Study, watch: &dyn Watch) -> Result<Reply, Failure> {
        if *study == Study::Files && carom_scene::is_impact(&self.text) {
            return lab::files(&self.name, &self.text);
        }
        let scene = self.scene_of(&self.text)?;
        match study {
            Study::Strike { number } => {
                let html = carom_figure::live_strike(scene.feeder(), &scene.feeder().run()?, *number);
                Ok(Reply { html: Some(html), ..Reply::default() })
            }
            Study::Limit { path } => {
                let limit = scene.limits_of(path).map(|(limit, _)| limit);
                Ok(Reply { limit: limit.map(Box::new), ..Reply::default() })
            }
            Study::Yield { samples, seed } => study::yielded(&scene, *samples, *seed, watch),
            Study::Map { axes, cells, depth, accuracy } => {
                let options = Options { accuracy: *accuracy, depth: *depth };
                let html = study::map(&scene, axes, *cells, options, watch)?;
                Ok(Reply { html: Some(html), ..Reply::default() })
            }
            Study::At { values } => {
                Ok(Reply { headline: Some(edit::ending_at(&scene, values)?), ..Reply::default() })
            }
            Study::Design { scan, samples, seed } => {
                design::found(&scene, DesignPlan { scan: *scan, samples: *samples, seed: *seed }, watch)
            }
            Study::Files => {
                let (run, fed) = (scene.feeder().run()?, tasks::feed(&scene)?);
                let files = tasks::run_files(&scene, &run, fed.as_ref(), None)?;
                Ok(Reply { files: Some(named(files)), ..Reply::default() })
            }
            Study::Drawings => Ok(Reply { files: Some(named(tasks::drawings(&scene))), ..Reply::default() }),
            Study::Race { runs } => {
                for _ in 0..*runs {
                    scene.feeder().run_untraced()?;
                }
                Ok(Reply::default())
            }
        }
    }

    fn scene_of(&self, text: &str) -> Result<Scene, Failure> {
        let files: InMemory =
            self.files.iter().map(|(name, text)| (name.into(), text.clone().into_bytes())).collect();
        Ok(Scene::parse_with(&self.name, text, &files)?)
    }
}

pub(crate) fn named<N: Into<String>>(
    files: impl IntoIterator<Item = (N, String)>,
) -> BTreeMap<String, String> {
    files.into_iter().map(|(name, text)| (name.into(), text)).collect()
}
