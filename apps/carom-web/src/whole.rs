//! What is asked beside the bench: many drops of a scene, impacts, and what rolls.

use crate::regions::File;
use crate::reply::{Failure, Headline, Reply};
use crate::request::{Ask, Request, Study};
use crate::watch::Watch;
use crate::{design, fields, lab, portions, regions, rolling, solid};
use carom::tasks::design::DesignPlan;
use carom_scene::Form;

impl Request {
    pub(crate) fn besides(&self, watch: &dyn Watch) -> Result<Reply, Failure> {
        let (name, text) = (self.name.as_str(), self.text.as_str());
        let form = Form::of(name, text);
        match &self.ask {
            Ask::Show { change, frame } => {
                let change = change.as_ref();
                match form {
                    Form::Impact => lab::shown(name, text, change, *frame),
                    Form::Roll(kind) => rolling::shown(kind, name, text, change, *frame),
                    Form::SpatialRoll(kind) => {
                        solid::shown(kind, (name, text), change, *frame, &self.files())
                    }
                    // One in the plane is shown by the bench.
                    Form::Scene => solid::through_feeder(self, change, *frame),
                }
            }
            Ask::Study(study) if self.is_in_the_plane() => self.of_scene(study, watch),
            Ask::Study(study) => self.of_another(form, study),
            Ask::Portion { study, round, number, of } => {
                let portion = portions::of(self, study, (*round, (*number, *of)), watch)?;
                Ok(Reply { portion: Some(portion), ..Reply::default() })
            }
            Ask::Joined { study, known } => portions::joined(self, study, known, watch),
        }
    }

    fn of_scene(&self, study: &Study, watch: &dyn Watch) -> Result<Reply, Failure> {
        let scene = self.scene()?;
        match study {
            Study::Design { scan, samples, seed } => {
                design::found(&scene, DesignPlan { scan: *scan, samples: *samples, seed: *seed }, watch)
            }
            _ => Err(Failure::of_page("the bench answers this")),
        }
    }

    /// What may be asked of an impact, of what rolls, or of a scene in space.
    fn of_another(&self, form: Form, study: &Study) -> Result<Reply, Failure> {
        let (name, text) = (self.name.as_str(), self.text.as_str());
        let files = self.files();
        match (study, form) {
            (Study::Files, Form::Impact) => lab::files(name, text),
            (Study::Files, Form::Roll(kind)) => rolling::files(kind, name, text),
            (Study::Files, Form::SpatialRoll(kind)) => solid::files(kind, (name, text), &files),
            (Study::Files, Form::Scene) => solid::files_of_run(&self.space_scene()?),
            (Study::At { values }, _) => {
                let dimensions = fields::dimensions(form, text, values.keys())?;
                let given =
                    values.iter().zip(&dimensions).map(|((path, value), of)| (path.as_str(), *value, *of));
                let file = File::of(self, &files);
                let word = regions::ending(&file, &given.collect::<Vec<_>>());
                Ok(Reply { headline: Some(Headline { word, plate: None, wanted: None }), ..Reply::default() })
            }
            _ => Err(Failure::of_page("this is asked of scenes in the plane alone")),
        }
    }
}
