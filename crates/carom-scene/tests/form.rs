//! Readers and schemas say the same of the form of files: of the examples, and of thousands that are spoiled at random.

#![allow(clippy::print_stdout, reason = "how many files were of which form is shown with --nocapture")]

use crate::held;

use carom_scene::{
    AnyImpact, AnyScene, Form, Problem, ProblemKind, RollKind, RollProblem, SpatialRollKind,
    SpatialRollProblem, toml_of_json,
};
use carom_words::Words;
use held::Judge;
use rand::{RngExt, SeedableRng, seq::IndexedRandom};
use rand_pcg::Pcg64;
use serde_json::{Map, Value, json};
use std::path::{Path, PathBuf};

/// Spoiled files of each kind.
const SPOILED: usize = 1500;
const SEED: u64 = 0x0f04;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples")
}

/// The examples of a kind of file: their paths and texts.
fn of_form(form: Form) -> Vec<(String, String)> {
    let prefix = match form {
        Form::Scene => String::new(),
        Form::Impact => "impact_".to_owned(),
        Form::Roll(kind) => format!("roll_{}", kind.word()),
        Form::SpatialRoll(kind) => format!("roll_{}", kind.word()),
    };
    let entries = std::fs::read_dir(examples()).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<(String, String)> = entries
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .filter(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            let other = ["impact_", "contact_", "roll_"].iter().any(|kind| name.starts_with(kind));
            match form {
                Form::Scene => !other,
                Form::Impact => name.starts_with("impact_") || name.starts_with("contact_"),
                Form::Roll(_) | Form::SpatialRoll(_) => name.starts_with(&prefix),
            }
        })
        .map(|path| (path.display().to_string(), std::fs::read_to_string(&path).unwrap()))
        .collect();
    found.sort();
    found
}

/// What the whole reader says.
fn read(form: Form, file: &str, source: &str) -> Vec<Problem> {
    match form {
        Form::Scene => AnyScene::parse(file, source).err().map_or(vec![], |found| found.list),
        Form::Impact => AnyImpact::parse(file, source).err().map_or(vec![], |found| found.list),
        Form::Roll(kind) => {
            let found = RollProblem::parse(kind, file, source, &[]).err();
            found.into_iter().flat_map(|found| found.0).flat_map(|found| found.list).collect()
        }
        Form::SpatialRoll(kind) => {
            let found = SpatialRollProblem::parse(kind, file, source, &[]).err();
            found.into_iter().flat_map(|found| found.0).flat_map(|found| found.list).collect()
        }
    }
}

#[test]
fn every_example_is_as_its_schema_says() {
    for form in Form::ALL {
        let judge = Judge::of(form);
        let files = of_form(form);
        assert!(!files.is_empty(), "{form:?} has an example");
        for (file, text) in files {
            assert!(judge.held(&text), "{file} is refused");
            assert_eq!(read(form, &file, &text), [], "{file}");
        }
    }
}

/// Every key that a schema knows, wherever it stands.
fn keys(schema: &Value, found: &mut Vec<String>) {
    match schema {
        Value::Object(entries) => {
            if let Some(properties) = schema["properties"].as_object() {
                found.extend(properties.keys().cloned());
            }
            entries.values().for_each(|value| keys(value, found));
        }
        Value::Array(items) => items.iter().for_each(|item| keys(item, found)),
        _ => {}
    }
}

/// Spoils files: every draw comes from one generator.
struct Spoiler {
    random: Pcg64,
    keys: Vec<String>,
}

impl Spoiler {
    fn number(&mut self, below: usize) -> usize {
        self.random.random_range(0..below)
    }

    /// A value that some key might hold.
    fn value(&mut self) -> Value {
        let words = [
            "rod",
            "box",
            "disc",
            "polygon",
            "outline",
            "bolt",
            "cap",
            "M8 x 30",
            "steel on steel, dry",
            "left",
            "right",
            "poisson",
            "newton",
            "fixed",
            "turned",
            "keep most",
            "in sequence",
            "mm",
            "100 mm",
            "15 deg",
            "0.3 kg",
            "12 furlong",
            "",
        ];
        match self.number(12) {
            0 => json!(true),
            1 => json!(-3),
            2 => json!(0.25),
            3 => json!([0.1, 0.2]),
            4 => json!([0.1, 0.2, "3 mm"]),
            5 => json!([[0, 0], [1, 0], [0, 1]]),
            6 => json!({ "value": 0.1, "sigma": 0.01 }),
            7 => json!({ "low": 0.1, "high": "0.2", "middle": 3 }),
            8 => json!({ "x": 0.1, "y": "2 mm" }),
            9 => json!([{ "name": "odd" }, 4]),
            10 => json!({}),
            _ => json!(words.choose(&mut self.random).unwrap()),
        }
    }

    /// Spoils one table: a key less, a key more, a key of another name, another value, a list of another length.
    fn spoil(&mut self, table: &mut Map<String, Value>) {
        let names: Vec<String> = table.keys().cloned().collect();
        let Some(name) = names.choose(&mut self.random).cloned() else { return };
        match self.number(9) {
            0 => drop(table.remove(&name)),
            1 => {
                let key = self.keys.choose(&mut self.random).unwrap().clone();
                let value = self.value();
                table.insert(key, value);
            }
            2 => {
                let value = table.remove(&name).unwrap();
                let key = self.keys.choose(&mut self.random).unwrap().clone();
                table.insert(key, value);
            }
            3 => {
                let value = self.value();
                table.insert(name, value);
            }
            4 => {
                let value = table.remove(&name).unwrap();
                table.insert(format!("{name}x"), value);
            }
            _ => self.deeper(table.get_mut(&name).unwrap()),
        }
    }

    fn deeper(&mut self, value: &mut Value) {
        match value {
            Value::Object(table) => self.spoil(table),
            Value::Array(items) if !items.is_empty() => {
                let i = self.number(items.len());
                match self.number(4) {
                    0 => drop(items.remove(i)),
                    1 => items.push(items[i].clone()),
                    2 => items[i] = self.value(),
                    _ => self.deeper(&mut items[i]),
                }
            }
            // Half of the values stay of their type, so that some files stay of good form.
            Value::Number(number) if self.random.random_bool(0.5) => *number = 1.into(),
            Value::String(text) if self.random.random_bool(0.5) => *text = "12 mm".to_owned(),
            other => *other = self.value(),
        }
    }
}

/// Reasons that no schema can know.
fn is_beyond_form(problem: &Problem) -> bool {
    !matches!(problem.kind, ProblemKind::UnknownKey | ProblemKind::MissingKey | ProblemKind::WrongValue)
}

fn hold_spoiled(form: Form) {
    let judge = Judge::of(form);
    let mut known = vec![];
    keys(&carom_scene::schema::file(form).to_value(), &mut known);
    let mut spoiler = Spoiler { random: Pcg64::seed_from_u64(SEED), keys: known };
    let files: Vec<(String, Value)> =
        of_form(form).into_iter().map(|(file, text)| (file, toml::from_str(&text).unwrap())).collect();
    let (mut good, mut bad) = (0, 0);
    for round in 0..SPOILED {
        let (file, value) = &files[round % files.len()];
        let Value::Object(mut table) = value.clone() else { panic!("a table") };
        for _ in 0..=spoiler.number(2) {
            spoiler.spoil(&mut table);
        }
        let source = toml_of_json("spoiled", &Value::Object(table).to_string()).unwrap();
        let form_is_good = judge.held(&source);
        let told = read(form, file, &source);
        if form_is_good {
            good += 1;
            let odd = told.iter().find(|problem| !is_beyond_form(problem));
            assert!(odd.is_none(), "seed {SEED}, round {round}: {source}\n{odd:?}");
        } else {
            bad += 1;
            assert!(
                !told.is_empty(),
                "seed {SEED}, round {round}: {source}\nits form is bad, and it is read"
            );
        }
    }
    assert!(good > SPOILED / 20 && bad > SPOILED / 4, "{good} good, {bad} bad");
    println!("{form:?}: {good} of good form, {bad} of bad");
}

macro_rules! spoiled {
    ($($name:ident: $form:expr;)*) => { $(
        #[test]
        fn $name() {
            hold_spoiled($form);
        }
    )* };
}

spoiled! {
    spoiled_scenes_are_refused_as_the_schema_says: Form::Scene;
    spoiled_impacts_are_refused_as_the_schema_says: Form::Impact;
    spoiled_cylinders_are_refused_as_the_schema_says: Form::Roll(RollKind::Cylinder);
    spoiled_prisms_are_refused_as_the_schema_says: Form::Roll(RollKind::Prism);
    spoiled_rods_are_refused_as_the_schema_says: Form::Roll(RollKind::Rod);
    spoiled_pyramids_are_refused_as_the_schema_says: Form::SpatialRoll(SpatialRollKind::Pyramid);
    spoiled_stools_are_refused_as_the_schema_says: Form::SpatialRoll(SpatialRollKind::Stool);
    spoiled_bodies_are_refused_as_the_schema_says: Form::SpatialRoll(SpatialRollKind::Body);
}

/// What a newcomer wrote, and how often each is told.
#[test]
fn empty_lists_misspelt_kinds_and_three_ways_are_told_once_each() {
    let told = |form: Form, text: &str| {
        assert!(!Judge::of(form).held(text), "{text}");
        let problems = read(form, "odd.toml", text);
        problems.iter().map(|problem| problem.path.clone()).collect::<Vec<_>>()
    };
    let body = "body = { mass = 1, inertia = 1, velocity = [0, -1] }\n";
    assert_eq!(told(Form::Impact, &format!("contact = []\n{body}")), ["contact"], "no contact");
    assert_eq!(told(Form::Impact, "contact = []\nbody = []"), ["contact", "body"], "nobody");
    let kind = "[[body]]\nkind = 'fixd'\n[[body]]\nmass = 1\ninertia = 1\ncentre = [0, 1]\n[[contact]]\npoint = [0, 0]\nnormal = [0, 1]\nfriction = 0\nbetween = ['body 2', 'body 1']\n";
    assert_eq!(told(Form::Impact, kind), ["body.0.kind"], "a word that means neither");
    let three =
        "box = [1, 1, 1]\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\nfile = 'bolt.stl'\n";
    let found = told(Form::SpatialRoll(SpatialRollKind::Body), three);
    assert_eq!(found, ["vertices", "file"], "three shapes");
    let part =
        "[part]\nshape = 'rod'\nlength = 0.1\nmass = 1\n[contact]\nfriction = 0.2\n[start]\nto_edge = 0.1\n";
    assert_eq!(told(Form::Scene, &format!("{part}[channel]\nwidth = 0.3\n")), ["plate"], "no plate");
}
