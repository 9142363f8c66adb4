//! `[start]`: how the part starts, and on which of its faces.

use crate::drawing::{StartDrawing, StartFaces};
use crate::drawn::Drawn;
use crate::grammar::{Mixed, Section};
use crate::node::Value;
use crate::problem::{Problem, ProblemKind};
use crate::tolerance::EQUAL_SHARES;
use carom_motion::planar::Shape;

carom_words::words! {
    StartWord {
        Resting = "resting",
    }
}

/// A word for the faces on which a part may start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum StartWord {
    /// On any face, as a part that is turned over at random and let go without speed comes to rest.
    Resting,
}

/// Reads `[start]`.
pub(crate) fn read_start(root: &Section<'_>) -> Option<StartDrawing> {
    let section = root.section("start")?;
    Some(StartDrawing {
        to_edge: section.quantity("to_edge")?,
        speed: section.quantity_or_default("speed")?,
        faces: read_faces(&section)?,
        face_span: section.get("face").map(|node| node.span.clone()),
        turn: section.quantity_if_known("turn"),
        aside: section.quantity_if_known("aside"),
    })
}

fn read_faces(section: &Section<'_>) -> Option<StartFaces> {
    match section.get("face").map(|node| &node.value) {
        None => Some(StartFaces::One(0)),
        Some(Value::Text(_)) => section.word("face").map(|StartWord::Resting| StartFaces::Resting),
        Some(Value::List(_)) => {
            let shares = section.mixed::<2>("face")?.into_iter().map(|item| match item {
                Mixed::Table(of) => Some((whole(of.value("face")?), of.value("share")?)),
                Mixed::Vector(_) => None,
            });
            Some(StartFaces::Mixed(shares.collect::<Option<_>>()?))
        }
        Some(_) => section.value("face").map(|face| StartFaces::One(whole(face))),
    }
}

#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number from 0")]
fn whole(number: f64) -> usize {
    number as usize
}

/// The faces on which a part may start, and the share of each; the shares sum to 1.
#[derive(Clone, Debug)]
pub(crate) struct FaceMix(Vec<(usize, f64)>);

impl FaceMix {
    pub(crate) fn of(scene: &impl Drawn) -> Self {
        Self(scene.start_faces())
    }

    /// Each face and its share.
    pub(crate) fn shares(&self) -> &[(usize, f64)] {
        &self.0
    }

    /// True where it is a dimension of its own: there are several.
    pub(crate) fn varies(&self) -> bool {
        self.0.len() > 1
    }

    /// The face at a coordinate of the unit cube, which is cut into pieces as long as the shares.
    pub(crate) fn at(&self, coordinate: f64) -> usize {
        let mut left = coordinate;
        let holds = |(_, share): &&(usize, f64)| {
            left -= share;
            left < 0.0
        };
        let found = self.0.iter().find(holds).or(self.0.last());
        found.map_or(0, |(face, _)| *face)
    }
}

impl StartFaces {
    /// Each face on which a part may start, and its share of all; the shares sum to 1. `resting` tells, face by face, with what share a part comes to rest there that is let
    /// go gently; nothing of a part that lies alike on all its rim.
    pub(crate) fn shares(&self, resting: impl FnOnce() -> Vec<f64>) -> Vec<(usize, f64)> {
        let shares: Vec<(usize, f64)> = match self {
            Self::One(face) => vec![(*face, 1.0)],
            Self::Mixed(shares) => shares.clone(),
            Self::Resting => {
                let found: Vec<(usize, f64)> =
                    resting().into_iter().enumerate().filter(|(_, share)| *share > 0.0).collect();
                // A disc lies the same on all its rim.
                if found.is_empty() { vec![(0, 1.0)] } else { found }
            }
        };
        let all: f64 = shares.iter().map(|(_, share)| share).sum();
        shares.into_iter().map(|(face, share)| (face, share / all)).collect()
    }

    /// The face on which the part starts where it is dropped once: the most probable one.
    pub(crate) fn usual(&self, resting: impl FnOnce() -> Vec<f64>) -> usize {
        most_probable(&self.shares(resting))
    }

    /// What is wrong with them for a part that has so many faces.
    pub(crate) fn problems(&self, faces: usize, drawing: &StartDrawing) -> Vec<Problem> {
        let span = drawing.face_span.clone();
        let wrong = |path: String, message: String| {
            Problem::new(ProblemKind::OutOfRange, path, message, span.clone())
        };
        let named: Vec<(String, usize)> = match self {
            Self::One(face) => vec![("start.face".to_owned(), *face)],
            Self::Mixed(shares) => {
                let of = |(i, (face, _)): (usize, &(usize, f64))| (format!("start.face.{i}.face"), *face);
                shares.iter().enumerate().map(of).collect()
            }
            Self::Resting => vec![],
        };
        let mut found = vec![];
        for (i, (path, face)) in named.iter().enumerate() {
            if *face >= faces.max(1) {
                let message =
                    format!("{face} is no face of this part: its faces are 0 to {}", faces.max(1) - 1);
                found.push(wrong(path.clone(), message));
            } else if named[..i].iter().any(|(_, before)| before == face) {
                found.push(wrong(path.clone(), format!("face {face} is named twice: give it one share")));
            }
        }
        found
    }
}

/// The shares with which a shape comes to rest on what it can lie on, where it is let go gently.
pub(crate) fn resting(shape: &Shape) -> Vec<f64> {
    shape.rests().iter().map(carom_motion::planar::Rest::share).collect()
}

/// The face with the largest share; of equally probable ones the first.
fn most_probable(shares: &[(usize, f64)]) -> usize {
    let most = shares.iter().map(|(_, share)| *share).fold(0.0, f64::max);
    let first = shares.iter().find(|(_, share)| *share >= most * (1.0 - EQUAL_SHARES));
    first.map_or(0, |(face, _)| *face)
}
