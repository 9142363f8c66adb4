//! A scene on the bench: its run, its picture and its words.

use crate::asked;
use crate::reply::{Failure, Grip, Headline, QuantityShown, Reply, Seen};
use crate::request::{Frame, Held, Window};
use carom::tasks;
use carom_feeder::Run;
use carom_figure::{View, live_controls, live_ends, live_scene, live_sections, live_view};
use carom_num::Vec2;
use carom_scene::{Hold, NamedQuantity, Scene, labelled};
use carom_words::{part, run as run_words};
use serde_json::value::RawValue;

/// Pixels between the grips of the part and of its plate.
const CLEAR: f64 = 30.0;
/// Pixels from the border to a grip.
const INSET: f64 = 14.0;

pub(crate) struct Bench<'s> {
    scene: &'s Scene,
    /// Its run, or why there is none.
    run: Result<Run, Failure>,
    view: View,
}

impl<'s> Bench<'s> {
    pub(crate) fn of(scene: &'s Scene, frame: Frame) -> Result<Self, Failure> {
        let run = scene.feeder().run().map_err(Failure::from);
        let view = match frame {
            Frame::Window(window) => window.view()?,
            Frame::Size(size) => live_view(scene.feeder(), run.as_ref().ok(), size.map(|side| side.max(1.0))),
        };
        Ok(Self { scene, run, view })
    }

    /// Everything that the page shows of a scene.
    pub(crate) fn whole(&self) -> Reply {
        let (feeder, run) = (self.scene.feeder(), self.run.as_ref().ok());
        let extra = tasks::extra(self.scene, run, None);
        let wanted = &extra.wanted;
        let picture = live_scene(feeder, run, &extra.draft, wanted, &self.view);
        let headline = run.map(|run| {
            let headline = run_words::headline(feeder, run);
            let met = wanted.iter().all(|wish| wish.met);
            Headline {
                word: headline.word,
                plate: headline.plate,
                wanted: (!wanted.is_empty()).then_some(met),
            }
        });
        let seen = RawValue::from_string(picture.motion).ok().map(|motion| Seen {
            scene: picture.scene,
            motion,
            grips: self.grips(),
            words: headline.as_ref().map_or_else(String::new, |headline| {
                format!("A part goes through the feeder: {}.", headline.words())
            }),
        });
        Reply {
            kind: Some("scene"),
            text: Some(self.scene.source().to_owned()),
            window: Some(Window::of(&self.view)),
            seen,
            headline,
            sections: run.map(|run| live_sections(feeder, run, &extra).into()),
            quantities: Some(self.scene.quantities().iter().map(|own| shown(self.scene, own)).collect()),
            design: Some(asked::design(self.scene)),
            controls: Some(live_controls()),
            failure: self.run.as_ref().err().cloned(),
            ..Reply::default()
        }
    }

    fn grips(&self) -> Vec<Grip> {
        let feeder = self.scene.feeder();
        let mut all = vec![];
        let moves = |obstacle| {
            self.scene.moved_by(obstacle).into_iter().map(|quantity| quantity.path).collect::<Vec<_>>()
        };
        let mut add = |obstacle, hold, at: Vec2, ends: [Vec2; 2], cut, label: String, moves: &[String]| {
            let seen = self.view.at(at);
            let held = Held { obstacle, hold, at: [at.x, at.y], ends: ends.map(|end| [end.x, end.y]), cut };
            all.push(Grip { label, at: [seen.x, seen.y], held, moves: moves.to_vec() });
        };
        let part = feeder.start_state().pose.centre;
        for obstacle in 0..feeder.plates.len() + feeder.walls.len() {
            let bent = feeder.plates.get(obstacle).is_some_and(|plate| !plate.form.course.is_empty());
            let moves = moves(Some(obstacle));
            let Some((ends, cut)) =
                live_ends(feeder, obstacle, &self.view).filter(|_| !bent && !moves.is_empty())
            else {
                continue;
            };
            let name = part::obstacle(feeder, obstacle);
            // The part has a grip of its own: the plate's keeps clear of it.
            let near = |share: &f64| (ends[0] + (ends[1] - ends[0]) * *share - part).norm() * self.view.scale;
            let share = [0.5, 0.3, 0.7].into_iter().find(|share| near(share) > CLEAR).unwrap_or(0.5);
            let middle = ends[0] + (ends[1] - ends[0]) * share;
            // Where the border cuts a plate the grip keeps within the picture.
            let inwards = (ends[1] - ends[0]).unit().unwrap_or_default() * (INSET / self.view.scale);
            let [first, last] =
                [ends[0] + inwards * f64::from(cut[0]), ends[1] - inwards * f64::from(cut[1])];
            let places = [
                (Hold::First, first, ", one end"),
                (Hold::Middle, middle, ""),
                (Hold::Last, last, ", other end"),
            ];
            let holds = self.scene.holds(obstacle, cut);
            for ((hold, at, which), _) in places.into_iter().zip(holds).filter(|(_, holds)| *holds) {
                add(Some(obstacle), hold, at, ends, cut, format!("{name}{which}"), &moves);
            }
        }
        let moves = moves(None);
        if !moves.is_empty() {
            let label = "the part at its start".to_owned();
            add(None, Hold::Middle, part, [part; 2], [false; 2], label, &moves);
        }
        all
    }
}

fn shown(scene: &Scene, quantity: &NamedQuantity) -> QuantityShown {
    let dimension = quantity.kind.dimension;
    let unit = dimension.unit(dimension.usual());
    let si = unit.map_or(1.0, |unit| unit.to_si(1.0));
    let written = quantity.span.clone().and_then(|span| scene.source().get(span));
    let text = match written {
        Some(text) => text.trim_matches('"').to_owned(),
        None => dimension.show(quantity.value),
    };
    QuantityShown {
        path: quantity.path.clone(),
        label: labelled(&quantity.path).into_owned(),
        text,
        written: quantity.written && quantity.span.is_some(),
        value: quantity.value,
        allowed: quantity.kind.interval().map(|end| end.is_finite().then_some(end)),
        unit: dimension.usual().to_owned(),
        si,
        about: "",
        choices: vec![],
        number: true,
    }
}
