//! What a file may say, as data. Its reader, its JSON Schema, the reference page and `carom new` follow from it.
//!
//! A [`Table`] has keys, what each holds, and rules for keys that go together. [`check()`] holds a file to it, with every problem
//! of form and of single values; [`Section`] then reads values without a word; what is left to a reader are the things that no
//! grammar knows: names that must differ, places, crossings.

mod check;
mod draft;
pub(crate) mod impact;
mod impact_space;
pub(crate) mod kind;
mod library;
pub(crate) mod part;
mod recognise;
pub(crate) mod roll;
pub(crate) mod roll_space;
mod rule_check;
pub(crate) mod scene;
mod scene_space;
mod scene_studies;
pub(crate) mod schema;
mod section;
mod value;

pub(crate) use check::{can_stand_in_paths, check, is_of_type, name_of, variant};
pub(crate) use draft::comment_of;
pub(crate) use recognise::{kinds_of_roll, shows_an_impact};
pub(crate) use rule_check::shows_a_solid;
pub(crate) use section::{Mixed, Section, Sink, read_checked};
pub(crate) use value::{out_of_range, quantity as read_quantity};

use crate::problem::ProblemKind;
use crate::quantity::Kind;

/// A table of a file: `[part]`, one `[[plate]]`, or the file itself.
#[derive(Debug)]
pub(crate) struct Table {
    /// Its name in a schema.
    pub(crate) name: &'static str,
    /// What it describes: one sentence.
    pub(crate) about: &'static str,
    /// Its keys, in groups that several tables may share.
    pub(crate) keys: &'static [&'static [Key]],
    pub(crate) rules: &'static [Rule],
    /// Keys of another kind of file, or of another table, and what is said to whoever writes them.
    pub(crate) foreign: &'static [Foreign],
    /// Keys that one table gives to others that do not have their own.
    pub(crate) inherited: &'static [Inherited],
}

/// A key of one table that counts for others which do not have it: it may be left out where all of them have it.
#[derive(Debug)]
pub(crate) struct Inherited {
    pub(crate) key: &'static str,
    /// A key that says it as well.
    pub(crate) or: &'static str,
    /// The table that gives it, or a text that does.
    pub(crate) from: &'static str,
    /// The tables, or lists of tables, that take it.
    pub(crate) heirs: &'static [&'static str],
    /// What is missing where neither has it.
    pub(crate) missing: &'static str,
}

impl Table {
    /// One without rules: what most tables are.
    pub(crate) const fn plain(
        name: &'static str,
        about: &'static str,
        keys: &'static [&'static [Key]],
    ) -> Self {
        Self { name, about, keys, rules: &[], foreign: &[], inherited: &[] }
    }

    pub(crate) fn all_keys(&self) -> impl Iterator<Item = &'static Key> + use<> {
        self.keys.iter().flat_map(|group| group.iter())
    }

    pub(crate) fn key(&self, name: &str) -> Option<&'static Key> {
        self.all_keys().find(|key| key.name == name)
    }
}

/// A key of a table.
#[derive(Debug)]
pub(crate) struct Key {
    pub(crate) name: &'static str,
    pub(crate) holds: Holds,
    /// What it means: shown in schemas, on the reference page, and where it is missing.
    pub(crate) about: &'static str,
    /// True where no file may leave it out.
    pub(crate) needed: bool,
    /// What is said where it is missing; empty where what it holds says enough.
    pub(crate) missing: &'static str,
    /// What counts where it is left out.
    pub(crate) fallback: Option<Fallback>,
}

/// What counts where a key is left out.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Fallback {
    /// SI.
    Number(f64),
    Word(&'static str),
}

pub(crate) const fn key(name: &'static str, holds: Holds, about: &'static str) -> Key {
    Key { name, holds, about, needed: false, missing: "", fallback: None }
}

impl Key {
    /// One that no file may leave out.
    pub(crate) const fn needed(self) -> Self {
        Self { needed: true, ..self }
    }

    /// One that no file may leave out, and what is said to whoever does.
    pub(crate) const fn needed_as(self, missing: &'static str) -> Self {
        self.needed().if_missing(missing)
    }

    /// What is said where it is needed and missing.
    pub(crate) const fn if_missing(self, missing: &'static str) -> Self {
        Self { missing, ..self }
    }

    /// One whose value is `number` [SI] where it is left out.
    pub(crate) const fn or(self, number: f64) -> Self {
        Self { fallback: Some(Fallback::Number(number)), ..self }
    }

    /// One whose value is `word` where it is left out.
    pub(crate) const fn or_word(self, word: &'static str) -> Self {
        Self { fallback: Some(Fallback::Word(word)), ..self }
    }
}

/// What a key may hold.
#[derive(Debug)]
pub(crate) enum Holds {
    /// A number, a text with a unit, or a distribution.
    Quantity(Kind),
    /// A plain number and nothing else.
    Number(Kind),
    /// So many quantities, two or three: a vector.
    Vector(Kind, usize),
    /// Two lengths, `[x, y]` or `{ x, y }`.
    Point(Kind),
    /// At least and at most so many of the same, and what the list is called.
    List {
        of: &'static Holds,
        least: usize,
        most: usize,
        called: &'static str,
    },
    Text,
    Flag,
    /// A name of a table that has many of them, and what such a name is called.
    Named(fn() -> Vec<&'static str>, &'static str),
    /// One of a few words.
    Words(fn() -> Vec<&'static str>),
    /// The first of these whose type the value has.
    Either(&'static [Holds]),
    Table(&'static Table),
    /// The first of these tables whose condition holds.
    Variant(Variants),
    Tables(&'static Tables),
    /// Paths with a range each: `"plate.lower.slope" = "10..40 deg"`.
    Ranges,
}

/// Tables, each with the condition under which it is the one.
pub(crate) type Variants = &'static [(When, &'static Table)];

/// The tables of `[[key]]`.
#[derive(Debug)]
pub(crate) struct Tables {
    pub(crate) of: &'static Table,
    pub(crate) least: usize,
    pub(crate) most: usize,
    /// True where each goes by its name in paths: `plate.lower.slope`.
    pub(crate) named: bool,
    /// What holds for the first of them besides.
    pub(crate) first: &'static [Rule],
    /// What holds for every other besides.
    pub(crate) later: &'static [Rule],
}

impl Tables {
    /// At least one table and at most so many, without names in paths and without rules of their own.
    pub(crate) const fn of(table: &'static Table, most: usize) -> Self {
        Self { of: table, least: 1, most, named: false, first: &[], later: &[] }
    }
}

/// Keys that go together: one of several ways to say something.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rule {
    /// Where it holds.
    pub(crate) when: When,
    pub(crate) ways: &'static [Way],
    /// What is missing where no way is taken; empty where that is told elsewhere.
    pub(crate) missing: &'static str,
    /// What is said to whoever mixes ways or takes none, besides.
    pub(crate) help: &'static str,
}

/// One way to say something.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Way {
    /// What shows that it is taken.
    pub(crate) shown: When,
    /// What it cannot do without.
    pub(crate) needs: &'static [&'static str],
    /// What it may have besides.
    pub(crate) takes: &'static [&'static str],
}

/// A condition on the keys of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) enum When {
    Always,
    Has(&'static str),
    /// Any of these keys.
    Any(&'static [&'static str]),
    /// The key holds this word.
    Is(&'static str, &'static str),
    /// The key holds any of these words.
    IsOneOf(&'static str, &'static [&'static str]),
    /// The key holds a list.
    IsList(&'static str),
    /// In these tables, or in those of a list of such tables, these keys hold lists of three values more often than of two.
    InSpace(&'static [(&'static str, &'static [&'static str])]),
    /// In this table this key holds a list, and in it a list of three values.
    ListsOfThree(&'static str, &'static str),
    /// In this table a solid part is described: its shape is "solid", or it has none and a box or an STL file.
    Solid(&'static str),
    All(&'static [When]),
    /// No other way is taken.
    NoOther,
}

/// Keys that are none of this table's, and why.
#[derive(Debug)]
pub(crate) struct Foreign {
    pub(crate) keys: &'static [&'static str],
    pub(crate) kind: ProblemKind,
    pub(crate) message: &'static str,
    pub(crate) help: &'static str,
}

/// What a file is about, and so which commands take it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileKind {
    Scene,
    Impact,
    Roll,
}

/// A kind of file: the first of its tables whose condition holds describes it.
#[derive(Debug)]
pub(crate) struct File {
    pub(crate) kind: FileKind,
    pub(crate) title: &'static str,
    pub(crate) variants: Variants,
}
