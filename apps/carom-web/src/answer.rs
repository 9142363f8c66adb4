//! The answer to a request.

use crate::bench::Bench;
use crate::reply::{Failure, Headline, Reply};
use crate::request::{Ask, Change, Frame, Request, Study};
use crate::watch::Watch;
use crate::{design, edit, fields, lab, regions, rolling, study};
use carom::study::regions::Options;
use carom::tasks;
use carom::tasks::design::DesignPlan;
use carom_scene::input::InMemory;
use carom_scene::{Form, Scene};
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
        match Form::of(&self.name, &self.text) {
            Form::Scene => {}
            Form::Impact => return lab::shown(&self.name, &self.text, change, frame),
            Form::Roll(kind) => return rolling::shown(kind, &self.name, &self.text, change, frame),
            Form::SpatialRoll(_) => return Err(in_space()),
        }
        let mut scene = self.scene_of(&self.text)?;
        if let Some(change) = change {
            scene = self.scene_of(&edit::changed(&scene, change, &|text| self.scene_of(text))?)?;
        }
        Ok(Bench::of(&scene, frame)?.whole())
    }

    fn studied(&self, study: &Study, watch: &dyn Watch) -> Result<Reply, Failure> {
        match Form::of(&self.name, &self.text) {
            Form::Scene => {}
            Form::SpatialRoll(_) => return Err(in_space()),
            form => return self.studied_besides(form, study, watch),
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

    /// What may be asked of an impact or a roll.
    fn studied_besides(&self, form: Form, study: &Study, watch: &dyn Watch) -> Result<Reply, Failure> {
        let (name, text) = (self.name.as_str(), self.text.as_str());
        match (study, form) {
            (Study::Files, Form::Impact) => lab::files(name, text),
            (Study::Files, Form::Roll(kind)) => rolling::files(kind, name, text),
            (Study::Map { axes, cells, depth, accuracy }, _) => {
                let options = Options { accuracy: *accuracy, depth: *depth };
                let html = regions::drawn(form, (name, text), axes, (*cells, options), watch)?;
                Ok(Reply { html: Some(html), ..Reply::default() })
            }
            (Study::At { values }, _) => {
                let dimensions = fields::dimensions(form, text, values.keys())?;
                let given =
                    values.iter().zip(&dimensions).map(|((path, value), of)| (path.as_str(), *value, *of));
                let word = regions::ending(form, name, text, &given.collect::<Vec<_>>());
                Ok(Reply { headline: Some(Headline { word, plate: None, wanted: None }), ..Reply::default() })
            }
            _ => Err(Failure::of_page("this is asked of scenes alone")),
        }
    }

    fn scene_of(&self, text: &str) -> Result<Scene, Failure> {
        let files: InMemory =
            self.files.iter().map(|(name, text)| (name.into(), text.clone().into_bytes())).collect();
        Ok(Scene::parse_with(&self.name, text, &files)?)
    }
}

fn in_space() -> Failure {
    Failure::of_page("a body in space is not shown here yet: `carom roll` follows it")
}

pub(crate) fn named<N: Into<String>>(
    files: impl IntoIterator<Item = (N, String)>,
) -> BTreeMap<String, String> {
    files.into_iter().map(|(name, text)| (name.into(), text)).collect()
}
