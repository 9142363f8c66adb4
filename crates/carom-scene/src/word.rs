//! Words of results: a value is written as its word, and the schema lists all words that there are.

use carom_study::Ending;
use carom_study::poses::Pose;
use carom_words::{Words, study};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// A value of an enum, written as its word.
///
/// # Example
/// ```
/// use carom_impact::Phase;
/// use carom_scene::Word;
/// assert_eq!(serde_json::to_string(&Word(Phase::Compression))?, r#""compression""#);
/// let schema = schemars::schema_for!(Word<Phase>);
/// assert_eq!(schema.as_value()["enum"], serde_json::json!(["compression", "restitution"]));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word<T>(pub T);

impl<T: Words> Word<T> {
    /// The word.
    pub fn as_str(self) -> &'static str {
        self.0.word()
    }
}

impl<T: Words> std::fmt::Display for Word<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.pad(self.0.word())
    }
}

impl<T: Words> PartialEq<&str> for Word<T> {
    fn eq(&self, word: &&str) -> bool {
        self.0.word() == *word
    }
}

impl<T: Words> Serialize for Word<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0.word())
    }
}

impl<T: Words> JsonSchema for Word<T> {
    fn schema_name() -> Cow<'static, str> {
        let path = std::any::type_name::<T>();
        path.rsplit("::").next().unwrap_or(path).into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": "string", "enum": T::words() })
    }
}

/// How a drop ends on a plate, written in words: `turned`, `face 2`, `stuck`.
///
/// # Example
/// ```
/// use carom_scene::EndingWord;
/// use carom_study::Ending;
/// assert_eq!(serde_json::to_string(&EndingWord(Ending::Stays))?, r#""stays on it""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EndingWord(pub Ending);

/// How a thrown body ended, written in words: `face 2`, `balanced`.
///
/// # Example
/// ```
/// use carom_scene::PoseWord;
/// use carom_study::poses::Pose;
/// assert_eq!(serde_json::to_string(&PoseWord(Pose::Face(2)))?, r#""face 2""#);
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PoseWord(pub Pose);

/// Serialises, shows and describes a type whose values are words, or a face and its number.
macro_rules! words_or_face {
    ($type:ty, $words:path, $all:path) => {
        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(&$words(self.0))
            }
        }

        impl Serialize for $type {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str(&$words(self.0))
            }
        }

        impl JsonSchema for $type {
            fn schema_name() -> Cow<'static, str> {
                stringify!($type).into()
            }

            fn inline_schema() -> bool {
                true
            }

            fn json_schema(_: &mut SchemaGenerator) -> Schema {
                let words: Vec<String> = $all().map($words).collect();
                json_schema!({ "type": "string", "pattern": format!("^({}|face [0-9]+)$", words.join("|")) })
            }
        }
    };
}

words_or_face!(EndingWord, study::ending, study::endings);
words_or_face!(PoseWord, study::pose, study::poses);
