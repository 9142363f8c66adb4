//! The answer to a request: what the bench asks of a scene, here; all else by the whole engine.

use crate::bench::Bench;
use crate::edit;
use crate::reply::{Failure, Reply};
use crate::request::{Ask, Change, Frame, Request, Study};
use crate::watch::Watch;
use carom::tasks;
use carom_scene::input::InMemory;
use carom_scene::{Form, FoundLimits, Scene, SpaceScene};
use std::collections::BTreeMap;

impl Request {
    pub(crate) fn answer(&self, watch: &dyn Watch) -> Result<Reply, Failure> {
        if !self.is_in_the_plane() {
            return self.besides(watch);
        }
        match &self.ask {
            Ask::Show { change, frame } => self.shown(change.as_ref(), *frame),
            Ask::Study(study) => self.studied(study, watch),
            Ask::Portion { .. } | Ask::Joined { .. } => self.besides(watch),
        }
    }

    /// Everything about a scene after a change.
    fn shown(&self, change: Option<&Change>, frame: Frame) -> Result<Reply, Failure> {
        let mut scene = self.scene()?;
        if let Some(change) = change {
            scene = self.scene_of(&edit::changed(&scene, change, &|text| self.scene_of(text))?)?;
        }
        Ok(Bench::of(&scene, frame)?.whole())
    }

    fn studied(&self, study: &Study, watch: &dyn Watch) -> Result<Reply, Failure> {
        let scene = self.scene()?;
        match study {
            Study::Strike { number } => {
                let html = carom_figure::live_strike(scene.feeder(), &scene.feeder().run()?, *number);
                Ok(Reply { html: Some(html), ..Reply::default() })
            }
            Study::Limit { path } => {
                let limit = FoundLimits::one(&scene, path).map(|(limit, _)| limit);
                Ok(Reply { limit: limit.map(Box::new), ..Reply::default() })
            }
            Study::At { values } => {
                Ok(Reply { headline: Some(edit::ending_at(&scene, values)?), ..Reply::default() })
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
            Study::Design { .. } => self.besides(watch),
        }
    }

    /// What the bench alone does not know.
    #[cfg(not(feature = "whole"))]
    #[expect(clippy::unnecessary_wraps, reason = "the whole engine's answer may fail")]
    fn besides(&self, _: &dyn Watch) -> Result<Reply, Failure> {
        Ok(Reply { elsewhere: true, ..Reply::default() })
    }

    /// Whether the file is a scene whose part moves in the plane.
    pub(crate) fn is_in_the_plane(&self) -> bool {
        Form::of(&self.name, &self.text) == Form::Scene && !self.is_in_space()
    }

    /// Whether the file is a scene whose part is a solid.
    pub(crate) fn is_in_space(&self) -> bool {
        SpaceScene::is_one(&self.text)
    }

    pub(crate) fn scene(&self) -> Result<Scene, Failure> {
        self.scene_of(&self.text)
    }

    fn scene_of(&self, text: &str) -> Result<Scene, Failure> {
        Ok(Scene::parse_with(&self.name, text, &self.files())?)
    }

    #[cfg(feature = "whole")]
    pub(crate) fn space_scene(&self) -> Result<SpaceScene, Failure> {
        Ok(SpaceScene::parse_with(&self.name, &self.text, &self.files())?)
    }

    /// The files beside it. One that may be no text has a letter for each byte.
    pub(crate) fn files(&self) -> InMemory {
        let bytes = |name: &str, text: &str| match name.to_ascii_lowercase().ends_with(".stl") {
            true => text.chars().map(|letter| u8::try_from(u32::from(letter)).unwrap_or(b'?')).collect(),
            false => text.as_bytes().to_vec(),
        };
        self.files.iter().map(|(name, text)| (name.into(), bytes(name, text))).collect()
    }
}

pub(crate) fn named<N: Into<String>>(
    files: impl IntoIterator<Item = (N, String)>,
) -> BTreeMap<String, String> {
    files.into_iter().map(|(name, text)| (name.into(), text)).collect()
}
