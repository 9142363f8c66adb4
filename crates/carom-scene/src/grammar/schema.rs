//! The JSON Schema of a kind of file, from its grammar.

use super::value::{NORMAL, UNIFORM};
use super::{Fallback, File, Holds, Inherited, Key, Rule, Table, Tables, Variants, Way, When};
use crate::quantity::Kind;
use serde_json::{Map, Value, json};

/// The dialect of every schema.
pub(crate) const DIALECT: &str = "https://json-schema.org/draft/2020-12/schema";
const QUANTITY: &str = "Quantity";

/// The schema of one kind of file, or of several: then a file is one of them.
pub(crate) fn of_files(title: &str, files: &[&File]) -> Value {
    let mut defs = Defs::default();
    let mut schema = match files {
        [only] => file_body(only, &mut defs),
        several => {
            let variants = several.iter().map(|file| chain(file.variants, &mut defs));
            json!({ "type": "object", "anyOf": variants.collect::<Vec<_>>() })
        }
    };
    schema["$schema"] = DIALECT.into();
    schema["title"] = title.into();
    schema["$defs"] = Value::Object(defs.found);
    schema
}

/// A file with one table is described in place; of several each is named, and the first whose condition holds counts.
fn file_body(file: &File, defs: &mut Defs) -> Value {
    let [(_, only)] = file.variants else {
        let about = file.variants.iter().map(|(_, table)| table.about).collect::<Vec<_>>().join(" Or: ");
        let mut chain = chain(file.variants, defs);
        chain["type"] = "object".into();
        chain["description"] = about.into();
        return chain;
    };
    body(only, defs)
}

/// The first table whose condition holds; the last where none does.
fn chain(variants: Variants, defs: &mut Defs) -> Value {
    let mut chain = Value::Bool(true);
    for (i, (when, table)) in variants.iter().enumerate().rev() {
        let body = defs.table(table);
        chain = if i + 1 == variants.len() {
            body
        } else {
            json!({ "type": "object", "if": condition(*when), "then": body, "else": chain })
        };
    }
    chain
}

/// Tables that are named in a schema.
#[derive(Default)]
struct Defs {
    found: Map<String, Value>,
}

impl Defs {
    fn reference(name: &str) -> Value {
        json!({ "$ref": format!("#/$defs/{name}") })
    }

    /// A table by its name.
    fn table(&mut self, table: &Table) -> Value {
        if !self.found.contains_key(table.name) {
            self.found.insert(table.name.to_owned(), Value::Null);
            let body = body(table, self);
            self.found.insert(table.name.to_owned(), body);
        }
        Self::reference(table.name)
    }

    /// Names of a table.
    fn named(&mut self, names: &[&str], called: &str) -> Value {
        const NAME: &str = "Materials";
        let about = format!("{called}, by name.");
        let names = || json!({ "type": "string", "enum": names, "description": about });
        self.found.entry(NAME).or_insert_with(names);
        Self::reference(NAME)
    }

    fn quantity(&mut self) -> Value {
        self.found.entry(QUANTITY).or_insert_with(any_quantity);
        Self::reference(QUANTITY)
    }
}

/// A quantity of any kind: which units and sizes it may have is said where it stands.
fn any_quantity() -> Value {
    let plain = json!({ "type": ["number", "string"] });
    let pair = |keys: [&str; 2]| {
        json!({
            "type": "object", "additionalProperties": false, "required": keys,
            "properties": { (keys[0]): plain, (keys[1]): plain },
        })
    };
    let named = |mut schema: Value, about: &str| {
        schema["description"] = about.into();
        schema
    };
    json!({
        "description": "A text with a unit (\"100 mm\", \"15 ± 0.5 deg\"), a plain SI number, or a distribution.",
        "anyOf": [
            { "type": "number", "description": "SI." },
            { "type": "string", "description": "A number and a unit, with or without a tolerance." },
            named(pair(NORMAL), "A normal distribution."),
            named(pair(UNIFORM), "Every value between the two is equally likely."),
        ],
    })
}

fn body(table: &Table, defs: &mut Defs) -> Value {
    let mut properties = Map::new();
    for key in table.all_keys() {
        properties.insert(key.name.to_owned(), property(key, defs));
    }
    let required: Vec<&str> = table.all_keys().filter(|key| key.needed).map(|key| key.name).collect();
    let mut body = json!({
        "type": "object",
        "description": described(table),
        "properties": properties,
        "additionalProperties": false,
    });
    if !required.is_empty() {
        body["required"] = json!(required);
    }
    let mut rules: Vec<Value> = table.rules.iter().flat_map(rule).collect();
    rules.extend(table.inherited.iter().map(inherited));
    if !rules.is_empty() {
        body["allOf"] = json!(rules);
    }
    body
}

/// What a table is, and which of its keys go together.
fn described(table: &Table) -> String {
    let ways = table.rules.iter().map(rule_in_words).filter(|words| !words.is_empty());
    std::iter::once(table.about.to_owned()).chain(ways).collect::<Vec<_>>().join(" ")
}

fn rule_in_words(rule: &Rule) -> String {
    let ways: Vec<String> = rule.ways.iter().map(way_in_words).filter(|words| !words.is_empty()).collect();
    match rule.when {
        When::Always => format!("By {}.", ways.join("; or ")),
        when => format!("With {}: {}.", when.in_words(), ways.join("; or ")),
    }
}

fn way_in_words(way: &Way) -> String {
    let shown = match way.shown {
        When::NoOther if way.needs.is_empty() && way.takes.is_empty() => return "none of these".to_owned(),
        When::NoOther => "none of these".to_owned(),
        shown => shown.in_words(),
    };
    let needs = if way.needs.is_empty() { String::new() } else { format!(" with {}", way.needs.join(", ")) };
    let takes = if way.takes.is_empty() { String::new() } else { format!(" (and {})", way.takes.join(", ")) };
    format!("{shown}{needs}{takes}")
}

fn property(key: &Key, defs: &mut Defs) -> Value {
    let mut schema = held(&key.holds, defs);
    let kind = match &key.holds {
        Holds::Quantity(kind) | Holds::Number(kind) | Holds::Vector(kind, _) | Holds::Point(kind) => {
            format!(" {}.", kind_in_words(*kind))
        }
        _ => String::new(),
    };
    schema["description"] = format!("{}{kind}", key.about).into();
    match key.fallback {
        Some(Fallback::Number(number)) => schema["default"] = json!(number),
        Some(Fallback::Word(word)) => schema["default"] = json!(word),
        None => {}
    }
    schema
}

/// `Length [m, mm, ...], must be above 0`.
fn kind_in_words(kind: Kind) -> String {
    let units = kind.dimension.units_in_words();
    let units = if units.is_empty() { String::new() } else { format!(" in {units}") };
    let mut what = kind.dimension.to_string();
    if let Some(first) = what.get(..1).map(str::to_uppercase) {
        what.replace_range(..1, &first);
    }
    format!("{what}{units}; it {}", kind.allowed)
}

fn held(holds: &Holds, defs: &mut Defs) -> Value {
    match holds {
        Holds::Quantity(_) => defs.quantity(),
        Holds::Number(_) => json!({ "type": "number" }),
        Holds::Vector(_, count) => {
            json!({ "type": "array", "items": defs.quantity(), "minItems": count, "maxItems": count })
        }
        Holds::Point(kind) => {
            let named = json!({
                "type": "object", "additionalProperties": false, "required": ["x", "y"],
                // Both ways of writing a point are told apart by their type.
                "properties": { "x": defs.quantity(), "y": defs.quantity() },
            });
            json!({ "anyOf": [held(&Holds::Vector(*kind, 2), defs), named] })
        }
        Holds::List { of, least, most, .. } => {
            let mut list = json!({ "type": "array", "items": held(of, defs) });
            if *least > 0 {
                list["minItems"] = json!(least);
            }
            if *most < usize::MAX {
                list["maxItems"] = json!(most);
            }
            list
        }
        Holds::Text => json!({ "type": "string" }),
        Holds::Flag => json!({ "type": "boolean" }),
        Holds::Named(names, called) => defs.named(&names(), called),
        Holds::Words(words) => json!({ "type": "string", "enum": words() }),
        Holds::Either(choices) => {
            json!({ "anyOf": choices.iter().map(|choice| held(choice, defs)).collect::<Vec<_>>() })
        }
        Holds::Table(table) => defs.table(table),
        Holds::Variant(variants) => chain(variants, defs),
        Holds::Tables(tables) => list_of_tables(tables, defs),
        Holds::Ranges => ranges(defs),
    }
}

fn list_of_tables(tables: &Tables, defs: &mut Defs) -> Value {
    let with = |rules: &[Rule], table: Value| {
        let rules: Vec<Value> = rules.iter().flat_map(rule).collect();
        if rules.is_empty() {
            table
        } else {
            json!({ "allOf": std::iter::once(table).chain(rules).collect::<Vec<_>>() })
        }
    };
    let table = defs.table(tables.of);
    let mut list = json!({ "type": "array", "items": with(tables.later, table.clone()) });
    if !tables.first.is_empty() || !tables.later.is_empty() {
        list["prefixItems"] = json!([with(tables.first, table)]);
    }
    if tables.least > 0 {
        list["minItems"] = json!(tables.least);
    }
    if tables.most < usize::MAX {
        list["maxItems"] = json!(tables.most);
    }
    list
}

fn ranges(defs: &mut Defs) -> Value {
    const NAME: &str = "Ranges";
    let about = "Paths, each with its range: \"plate.lower.slope\" = \"10..40 deg\".";
    defs.found.entry(NAME).or_insert_with(|| {
        json!({
            "type": "object", "description": about,
            "additionalProperties": { "anyOf": [{ "type": "string" }, Defs::reference(NAME)] },
        })
    });
    Defs::reference(NAME)
}

/// What a rule says, as conditions that all hold.
fn rule(rule: &Rule) -> Vec<Value> {
    let shown = |when: When| all(&[condition(rule.when), condition(when)]);
    let shown_by_keys: Vec<Value> = rule
        .ways
        .iter()
        .filter(|way| !matches!(way.shown, When::NoOther))
        .map(|way| condition(way.shown))
        .collect();
    let mut found: Vec<Value> = rule
        .ways
        .iter()
        .filter_map(|way| {
            let then = consequence(rule, way)?;
            let shown = match way.shown {
                When::NoOther => all(&[condition(rule.when), json!({ "not": { "anyOf": shown_by_keys } })]),
                when => shown(when),
            };
            Some(json!({ "if": shown, "then": then }))
        })
        .collect();
    if rule.last_resort().is_none() && !rule.missing.is_empty() {
        let one = json!({ "anyOf": shown_by_keys });
        found.push(match rule.when {
            When::Always => one,
            when => json!({ "if": condition(when), "then": one }),
        });
    }
    found
}

/// That the giving table has the key, or every other its own.
fn inherited(inherited: &Inherited) -> Value {
    let Inherited { key, or, from, heirs, .. } = *inherited;
    let has =
        json!({ "anyOf": [{ "not": { "type": "object" } }, { "required": [key] }, { "required": [or] }] });
    let each = json!({ "items": has, "anyOf": [{ "type": "array" }, has] });
    let own: Map<String, Value> = heirs.iter().map(|table| ((*table).to_owned(), each.clone())).collect();
    let given = json!({ "required": [from], "properties": { (from): has } });
    json!({ "anyOf": [given, { "properties": own }] })
}

/// What a way needs, and what does not belong to it; `None` where that is nothing.
fn consequence(rule: &Rule, way: &Way) -> Option<Value> {
    let stray: Map<String, Value> = rule
        .keys()
        .into_iter()
        .filter(|key| !way.has(key))
        .map(|key| (key.to_owned(), Value::Bool(false)))
        .collect();
    let mut then = Map::new();
    if !way.needs.is_empty() {
        then.insert("required".to_owned(), json!(way.needs));
    }
    if !stray.is_empty() {
        then.insert("properties".to_owned(), Value::Object(stray));
    }
    (!then.is_empty()).then_some(Value::Object(then))
}

fn all(conditions: &[Value]) -> Value {
    let open = |condition: &&Value| **condition != Value::Bool(true);
    match conditions.iter().filter(open).collect::<Vec<_>>()[..] {
        [] => Value::Bool(true),
        [only] => only.clone(),
        ref several => json!({ "allOf": several }),
    }
}

/// A condition on the keys of a table.
fn condition(when: When) -> Value {
    let is = |key: &str, what: Value| json!({ "required": [key], "properties": { (key): what } });
    let vector = |count: usize| json!({ "type": "array", "minItems": count, "maxItems": count });
    match when {
        When::Always => Value::Bool(true),
        When::NoOther => Value::Bool(false),
        When::Has(key) => json!({ "required": [key] }),
        When::Any(keys) => {
            json!({ "anyOf": keys.iter().map(|key| json!({ "required": [key] })).collect::<Vec<_>>() })
        }
        When::Is(key, word) => is(key, json!({ "const": word })),
        When::IsOneOf(key, words) => is(key, json!({ "enum": words })),
        When::IsList(key) => is(key, json!({ "type": "array" })),
        When::InSpace(tables) => {
            let one = |(key, keys): &(&str, &[&str])| {
                let triple: Vec<Value> = keys.iter().map(|key| is(key, vector(3))).collect();
                let table = json!({ "type": "object", "anyOf": triple });
                is(key, json!({ "anyOf": [table, { "type": "array", "contains": table }] }))
            };
            json!({ "anyOf": tables.iter().map(one).collect::<Vec<_>>() })
        }
        When::ListsOfThree(table, key) => {
            let lists = json!({ "type": "array", "contains": vector(3) });
            let table_of = json!({ "type": "object", "required": [key], "properties": { (key): lists } });
            is(table, table_of)
        }
        When::Solid(table) => {
            let mesh = is("file", json!({ "pattern": "[.][sS][tT][lL]$" }));
            let corners = is("vertices", json!({ "type": "array", "contains": vector(3) }));
            let bare = json!({
                "not": { "required": ["shape"] },
                "anyOf": [{ "required": ["box"] }, mesh, corners],
            });
            is(table, json!({ "type": "object", "anyOf": [is("shape", json!({ "const": "solid" })), bare] }))
        }
        When::All(conditions) => all(&conditions.iter().map(|when| condition(*when)).collect::<Vec<_>>()),
    }
}
