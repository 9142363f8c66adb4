//! The words for what happens: features, stages, outcomes, verdicts. Every table, file and picture takes them from here.

use crate::feeder::{Feeder, PartKind};
use crate::run::{Outcome, Run, StageName, Verdict};
use carom_motion::planar::Feature;
use carom_motion::planar::trace::Impact;
use carom_num::Vec2;

impl StageName {
    /// Its word, as tables and files have it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Slide => "slide",
            Self::Tip => "tip",
            Self::Flight => "flight",
            Self::Swing => "swing",
            Self::Stick => "stick",
            Self::Roll => "roll",
            Self::Wedge => "wedge",
            Self::Push => "push",
            Self::Rest => "rest",
            Self::Clatter => "clatter",
        }
    }
}

impl Outcome {
    /// All there are, in their order.
    pub const ALL: [Self; 10] = [
        Self::Landed,
        Self::Delivered,
        Self::Stuck,
        Self::OnEnd,
        Self::Jammed,
        Self::Missed,
        Self::Escaped,
        Self::NeverFlat,
        Self::Unresolved,
        Self::Blocked,
    ];

    /// Its word, as files have it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Landed => "landed",
            Self::Delivered => "delivered",
            Self::Stuck => "stuck",
            Self::OnEnd => "on_end",
            Self::Jammed => "jammed",
            Self::Missed => "missed",
            Self::Escaped => "escaped",
            Self::NeverFlat => "never_flat",
            Self::Unresolved => "unresolved",
            Self::Blocked => "blocked",
        }
    }
}

impl Verdict {
    /// In words: `same side`, `turned`, `face 2`.
    pub fn words(self) -> String {
        match self {
            Self::Same => "same side".to_owned(),
            Self::Turned => "turned".to_owned(),
            Self::Face(face) => format!("face {face}"),
        }
    }
}

/// The verdict in a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Headline {
    /// How it came out: `turned`, `same side`, `face 2`, `delivered, turned`, `stuck`, ...
    pub word: String,
    /// Name of the plate it came to, where it came to one.
    pub plate: Option<String>,
    /// What a word for a failure means; empty for the others.
    pub because: &'static str,
}

impl Run {
    /// The first strike on the plate of the last landing: the one that decides. `None` without a trace.
    pub fn deciding_strike(&self) -> Option<&Impact> {
        let landing = self.landings.last()?;
        let on_plate =
            |impact: &&Impact| impact.contacts.first().is_some_and(|c| c.obstacle == landing.plate);
        self.trace.impacts.iter().find(on_plate)
    }

    /// Speed of the striking point just before the deciding strike [m/s].
    pub fn struck_at(&self) -> Option<f64> {
        let before = self.deciding_strike()?.contacts.first()?.before;
        Some((before.slip * before.slip + before.normal * before.normal).sqrt())
    }
}

impl Feeder {
    /// The verdict of a run in a line.
    pub fn headline(&self, run: &Run) -> Headline {
        let last = run.landings.last();
        let verdict = last.and_then(|landing| landing.verdict).map(Verdict::words);
        let (word, because) = match (run.outcome, verdict) {
            (Outcome::Landed, verdict) => (verdict.unwrap_or("landed".to_owned()), ""),
            (Outcome::Delivered, Some(verdict)) => (format!("delivered, {verdict}"), ""),
            (Outcome::Delivered, None) => ("delivered".to_owned(), ""),
            (Outcome::Stuck, _) => ("stuck".to_owned(), "friction holds it"),
            (Outcome::OnEnd, _) => ("on end".to_owned(), "it rests on an end"),
            (Outcome::Jammed, _) => ("jammed".to_owned(), "it rests wedged"),
            (Outcome::Missed, _) => ("missed".to_owned(), "it fell past the last plate"),
            (Outcome::Escaped, _) => ("escaped".to_owned(), "it left the last plate before it lay flat"),
            (Outcome::NeverFlat, _) => ("never flat".to_owned(), "the budget of events or time ran out"),
            (Outcome::Unresolved, _) => {
                ("unresolved".to_owned(), "more contacts met at once than could be resolved")
            }
            (Outcome::Blocked, _) => ("blocked".to_owned(), "another part stood where it starts"),
        };
        let plate = match run.outcome {
            Outcome::Landed | Outcome::Delivered => last.map(|landing| landing.plate),
            // Where it lies now, not where it landed last.
            Outcome::Stuck | Outcome::OnEnd => match run.stages.last() {
                Some(stage) => stage.obstacle,
                None => last.map(|landing| landing.plate).or((!self.plates.is_empty()).then_some(0)),
            },
            Outcome::Jammed
            | Outcome::Missed
            | Outcome::Escaped
            | Outcome::NeverFlat
            | Outcome::Unresolved
            | Outcome::Blocked => None,
        };
        let plate = plate.map(|obstacle| self.obstacle_label(obstacle));
        Headline { word, plate, because }
    }

    /// The name of an obstacle for a person: `plate 1`, `wall 2`, counted from 1, where it has no name of its own but its number.
    pub fn obstacle_label(&self, obstacle: usize) -> String {
        let name = self.obstacle_name(obstacle);
        let (kind, number) = match obstacle.checked_sub(self.plates.len()) {
            None => ("plate", obstacle),
            Some(wall) => ("wall", wall),
        };
        if name == number.to_string() { format!("{kind} {}", number + 1) } else { name.to_owned() }
    }

    /// The name of the body's part of a pair of features, as it lay at the start: `front`, `rear`, `front top`, `corner 2`, `face 0`, `rim`.
    ///
    /// A rod has a front, its downhill end, and a rear; a box has two corners at each, those of the face that was down and `top` ones. A
    /// polygon's corners and every part's faces go by number.
    pub fn feature_name(&self, feature: Feature) -> String {
        match (self.part.kind, feature) {
            (PartKind::Disc, _) => "rim".to_owned(),
            (_, Feature::FaceOnEnd { face, .. }) => format!("face {face}"),
            (_, Feature::VertexOnFace { vertex, .. } | Feature::VertexOnEnd { vertex, .. }) => {
                self.vertex_name(vertex)
            }
        }
    }

    fn vertex_name(&self, vertex: usize) -> String {
        let shape = &self.part.body.shape;
        let number = || format!("corner {vertex}");
        let named = matches!(self.part.kind, PartKind::Rod | PartKind::Box);
        let (Some(plate), Some(corner)) = (self.plates.first(), shape.vertices().get(vertex)) else {
            return number();
        };
        if !named || self.start.face >= shape.faces() {
            return number();
        }
        let turn = Vec2::at_angle(self.start_state().pose.angle);
        let end = if corner.rotated(turn.x, turn.y).dot(plate.edge - plate.uphill) > 0.0 {
            "front"
        } else {
            "rear"
        };
        let down = shape.face_normal(self.start.face);
        let top = self.part.kind == PartKind::Box && corner.dot(down) < 0.0;
        if top { format!("{end} top") } else { end.to_owned() }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

    use crate::feeder::{Feeder, Part, Plate, Start, Stop, Wall};
    use carom_num::Vec2;

    #[test]
    fn what_has_no_name_is_counted_from_one() {
        let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
        let plate = |name: &str| Plate {
            name: name.to_owned(),
            uphill,
            edge,
            friction: 0.2,
            restitution: 0.0,
            unbounded: false,
        };
        let wall = |name: &str| Wall {
            name: name.to_owned(),
            from: uphill,
            to: edge,
            friction: 0.2,
            restitution: 0.0,
        };
        let feeder = Feeder {
            gravity: 9.81,
            stop: Stop::Landed,
            law: Default::default(),
            part: Part::rod(0.1, 0.3, 2.5e-4).unwrap(),
            start: Start { to_edge: 0.1, speed: 0.0, face: 0 },
            plates: vec![plate("0"), plate("lower"), plate("2")],
            walls: vec![wall("left"), wall("1")],
        };
        let labels: Vec<String> = (0..6).map(|o| feeder.obstacle_label(o)).collect();
        assert_eq!(labels, ["plate 1", "lower", "plate 3", "left", "wall 2", "another part"]);
        assert_eq!(feeder.obstacle_name(2), "2", "in paths and files the number is the index");
    }
}
