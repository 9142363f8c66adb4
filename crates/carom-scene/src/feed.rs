//! Several parts on one feeder.

use crate::drawing::Drawing;
use crate::problem::{Problem, ProblemKind, Problems};
use crate::scene::Scene;
use carom_feeder::{Feed, Stop};
use carom_motion::planar::Surface;

/// What `[feed]` says, with the friction and restitution between parts; every problem where it cannot be.
pub(crate) fn feed_of(drawing: &Drawing) -> Result<Option<Feed>, Vec<Problem>> {
    let Some(feed) = &drawing.feed else { return Ok(None) };
    let friction = feed.surface.friction.as_ref().or(drawing.contact.friction.as_ref());
    let restitution = feed.surface.restitution.as_ref().unwrap_or(&drawing.contact.restitution);
    if friction.is_none() && !drawing.contact.friction_written {
        return Err(vec![no_friction(Some(feed.span.clone()))]);
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a whole number from 1 to 100"
    )]
    let parts = feed.parts.value.round() as usize;
    let between = Surface { friction: friction.map_or(0.0, |f| f.value), restitution: restitution.value };
    Ok(Some(Feed { parts, interval: feed.interval.value, between }))
}

fn no_friction(span: Option<std::ops::Range<usize>>) -> Problem {
    let message = "missing: a plain number, the friction between parts, where [contact] has none";
    Problem::new(ProblemKind::MissingKey, "feed.friction", message, span)
}

impl Scene {
    /// So many parts, fed at an interval [s], that rub and rebound on each other as the scene says: in its `[feed]`, or else in `[contact]`.
    ///
    /// # Errors
    /// It says nowhere how parts rub on each other.
    pub fn fed(&self, parts: usize, interval: f64) -> Result<Feed, Problems> {
        if let Some(feed) = self.feed() {
            return Ok(Feed { parts, interval, between: feed.between });
        }
        let contact = &self.drawing().contact;
        let Some(friction) = &contact.friction else {
            let help = "write [feed] with parts, interval and friction";
            let problem = no_friction(None).with_help(help);
            return Err(Problems::new(self.file(), self.source(), vec![problem]));
        };
        let between = Surface { friction: friction.value, restitution: contact.restitution.value };
        Ok(Feed { parts, interval, between })
    }

    /// The text of this scene with so many parts fed at an interval [s], each followed until it has left the last plate or rests; all else stays.
    ///
    /// # Errors
    /// The result would not be such a scene.
    pub fn text_fed(&self, parts: usize, interval: f64) -> Result<String, Problems> {
        let (count, file) = (parts as f64, self.file());
        let mut text = match self.feed() {
            Some(_) => self.variants(&["feed.parts", "feed.interval"])?.text(&[count, interval])?,
            None => {
                let end = if self.source().ends_with('\n') { "" } else { "\n" };
                format!("{}{end}\n[feed]\nparts = {parts}\ninterval = {interval:?}\n", self.source())
            }
        };
        text = delivering(&text);
        let made = Self::parse(file, &text)?;
        let feed = made.feed().map(|feed| (feed.parts, feed.interval));
        if made.feeder().stop == Stop::Delivered && feed == Some((parts, interval)) {
            return Ok(text);
        }
        let message = "the scene cannot be written with another feed";
        let problem = Problem::new(ProblemKind::Conflict, "feed", message, None);
        Err(Problems::new(file, self.source(), vec![problem]))
    }
}

/// The same text with `stop = "delivered"` among the keys that stand above its tables.
fn delivering(text: &str) -> String {
    let new = "stop = \"delivered\"";
    let mut place = 0;
    for line in text.split_inclusive('\n') {
        let bare = line.trim_start();
        if bare.starts_with('[') {
            break;
        }
        let key = bare.split_once('=').map(|(key, _)| key.trim().trim_matches(['"', '\'']));
        if key == Some("stop") {
            let end = place + line.trim_end_matches(['\n', '\r']).len();
            return format!("{}{new}{}", &text[..place], &text[end..]);
        }
        place += line.len();
    }
    format!("{new}\n{text}")
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: &str = "[part]\nshape = \"rod\"\nlength = \"100 mm\"\nmass = \"0.3 kg\"\n[contact]\nfriction = 0.15\n[start]\nto_edge = \"100 mm\"\n[[plate]]\nslope = \"15 deg\"";

    #[test]
    fn a_scene_is_written_with_another_feed() {
        let feeds =
            [String::new(), "\n[feed]\nparts = 3 # many\ninterval = \"1.2 s\"\nfriction = 0.4\n".to_owned()];
        for (feed, friction) in feeds.iter().zip([0.15, 0.4]) {
            for stop in ["", "stop = \"landed\" # flat\n", "gravity = 9.8\n  \"stop\"=\"delivered\"\n"] {
                let scene = Scene::parse("plain.toml", &format!("# head\n{stop}{PLAIN}{feed}")).unwrap();
                let text = scene.text_fed(2, 0.123_456_789_012_345).unwrap();
                let made = Scene::parse("plain.toml", &text).unwrap();
                let fed = Feed {
                    parts: 2,
                    interval: 0.123_456_789_012_345,
                    between: Surface { friction, restitution: 0.0 },
                };
                assert_eq!((made.feed(), made.feeder().stop), (Some(&fed), Stop::Delivered), "{text}");
                assert_eq!(made.feeder().part, scene.feeder().part);
            }
        }
    }

    #[test]
    fn what_parts_do_to_each_other_must_be_known() {
        let own = PLAIN.replace("[contact]\nfriction = 0.15\n", "") + "\nfriction = 0.15\n";
        let scene = Scene::parse("plain.toml", &own).unwrap();
        let said = scene.fed(3, 1.0).unwrap_err().to_string();
        assert!(said.contains("feed.friction") && said.contains("[feed]"), "{said}");
    }
}
