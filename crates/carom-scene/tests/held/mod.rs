//! Holds what a reader says of a file's form to the JSON Schema of such files, by an independent validator.

use boon::{Compiler, SchemaIndex, Schemas};
use carom_scene::{Form, Problem, ProblemKind, schema};
use serde_json::Value;
use std::cell::RefCell;

/// A schema, ready to judge.
pub(crate) struct Judge {
    form: Form,
    schemas: Schemas,
    index: SchemaIndex,
}

impl Judge {
    pub(crate) fn of(form: Form) -> Self {
        let mut schemas = Schemas::new();
        let mut compiler = Compiler::new();
        compiler.add_resource("carom.json", schema::file(form).to_value()).expect("a resource");
        let index = compiler.compile("carom.json", &mut schemas).expect("a schema");
        Self { form, schemas, index }
    }

    /// Whether the schema takes a value.
    fn takes(&self, value: &Value) -> Result<(), String> {
        self.schemas.validate(value, self.index).map_err(|error| error.to_string())
    }

    /// Holds the reader's words on the form of a TOML text to the schema; true where the form is good.
    pub(crate) fn held(&self, source: &str) -> bool {
        let value: Value = toml::from_str(source).expect("TOML");
        let problems = self.form.problems(source);
        let wrong: Vec<&Problem> = problems.iter().filter(|problem| is_of_form(problem)).collect();
        match self.takes(&value) {
            Ok(()) => assert!(wrong.is_empty(), "{source}\nthe schema takes it, the reader says {wrong:?}"),
            Err(error) => {
                assert!(!wrong.is_empty(), "{source}\nthe reader takes it, the schema says {error}")
            }
        }
        wrong.is_empty()
    }
}

/// True for what a schema can know; not the size of a number, nor what is in a text.
fn is_of_form(problem: &Problem) -> bool {
    !matches!(problem.kind, ProblemKind::Quantity | ProblemKind::OutOfRange)
}

fn has_null(value: &Value) -> bool {
    match value {
        Value::Null => true,
        Value::Array(items) => items.iter().any(has_null),
        Value::Object(entries) => entries.values().any(has_null),
        _ => false,
    }
}

thread_local! {
    static JUDGES: RefCell<Vec<Judge>> = const { RefCell::new(vec![]) };
}

/// Holds a file of a test to its schema, where it is TOML that JSON can say.
pub(crate) fn file(form: Form, source: &str) {
    if toml::from_str::<Value>(source).is_ok_and(|value| !has_null(&value)) {
        JUDGES.with_borrow_mut(|judges| {
            if judges.iter().all(|judge| judge.form != form) {
                judges.push(Judge::of(form));
            }
            let judge = judges.iter().find(|judge| judge.form == form).expect("it is there");
            judge.held(source);
        });
    }
}
