//! One impact to resolve: a free body and its contacts, or the operator alone. TOML, or JSON with the same keys.

use crate::drawing::{FRICTION, INERTIA, MASS, RESTITUTION};
use crate::node::{Node, Value, from_json, from_toml};
use crate::problem::{Problem, ProblemKind, Problems};
use crate::quantity::{Allowed, Kind};
use crate::read_part::read_law;
use crate::section::{Section, Sink, expected, read_pair, read_quantity};
use crate::unit::Dimension;
use carom_impact::planar::{Block, Law, MOST_CONTACTS, Several, Touch};
use carom_num::Vec2;

const ANY_SPEED: Kind = Kind::new(Dimension::Speed, Allowed::Any);
const ANY_SPIN: Kind = Kind::new(Dimension::Spin, Allowed::Any);
const ANY_LENGTH: Kind = Kind::new(Dimension::Length, Allowed::Any);
const ANY_NUMBER: Kind = Kind::new(Dimension::Number, Allowed::Any);
const POSITIVE: Kind = Kind::new(Dimension::Number, Allowed::Positive);
const APPROACH: Kind = Kind::new(Dimension::Speed, Allowed::Negative);

/// Entries of a matrix that should be equal may differ by this share of the largest entry, and pivots that should not be negative may be.
const ROUNDING: f64 = 1e-9;

/// A free planar body that is touched.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactBody {
    /// Mass [kg].
    pub mass: f64,
    /// Moment of inertia about the mass centre [kg m²].
    pub inertia: f64,
    /// Velocity of the mass centre before [m/s].
    pub velocity: Vec2,
    /// Spin before [rad/s].
    pub spin: f64,
    /// Where it is touched; normals are unit vectors.
    pub touches: Vec<Touch>,
}

/// An impact to resolve.
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactProblem {
    /// Restitution law.
    pub law: Law,
    /// Names of the contacts: A, B, … unless they are given.
    pub names: Vec<String>,
    /// The contacts with their operator.
    pub contacts: Several,
    /// The body, where one is described.
    pub body: Option<ImpactBody>,
}

impl ImpactProblem {
    /// Reads the TOML text of an impact; `file` is the name its problems are reported under.
    ///
    /// # Errors
    /// Every problem found.
    pub fn parse(file: &str, source: &str) -> Result<Self, Problems> {
        let fail = |list| Problems::new(file, source, list);
        let (tree, syntax) = from_toml(source);
        if syntax.is_empty() { read(&tree).map_err(fail) } else { Err(fail(syntax)) }
    }

    /// Reads one JSON text with the same keys.
    ///
    /// # Errors
    /// Every problem found.
    pub fn parse_json(file: &str, source: &str) -> Result<Self, Problems> {
        let fail = |mut list: Vec<Problem>| {
            // One line of numbers is no picture: the path says where.
            list.iter_mut().for_each(|problem| problem.span = None);
            Problems::new(file, source, list)
        };
        let tree = from_json(source).map_err(|problem| fail(vec![problem]))?;
        read(&tree).map_err(fail)
    }
}

pub(crate) fn read(tree: &Node) -> Result<ImpactProblem, Vec<Problem>> {
    let sink = Sink::default();
    let Some(root) = Section::new("", tree, &sink) else { return Err(sink.into_list()) };
    if let Some(key) = ["part", "plate", "zigzag"].into_iter().find(|key| root.has(key)) {
        let message = "this is a scene, not an impact";
        let problem = Problem::new(ProblemKind::File, key, message, Some(root.key_span(key)));
        return Err(vec![problem.with_help("`carom run` runs it")]);
    }
    let law = read_law(&root);
    let found = if root.has("operator") {
        for key in ["body", "contact"] {
            if root.has(key) {
                root.get(key);
                let message = "does not go together with [operator], which says it all";
                let span = Some(root.key_span(key));
                sink.push(Problem::new(ProblemKind::Conflict, key, message, span));
            }
        }
        read_operator(&root).map(|(names, contacts)| ImpactProblem { law, names, contacts, body: None })
    } else {
        read_body(&root).and_then(|(names, body)| {
            let ImpactBody { mass, inertia, velocity, spin, ref touches } = body;
            let contacts = Several::of_free_body(mass, inertia, velocity, spin, touches).ok()?;
            Some(ImpactProblem { law, names, contacts, body: Some(body) })
        })
    };
    root.get("operator");
    root.finish();
    let problems = sink.into_list();
    match found {
        Some(found) if problems.is_empty() => Ok(found),
        _ => Err(problems),
    }
}

fn read_body(root: &Section<'_>) -> Option<(Vec<String>, ImpactBody)> {
    if !root.has("body") {
        root.missing("body", "a table [body] with mass, inertia, velocity and spin; or [operator]");
    }
    if !root.has("contact") {
        root.missing("contact", "[[contact]] with point, normal and friction, one for each contact");
    }
    let contacts = root.sections("contact");
    if contacts.len() > MOST_CONTACTS {
        let message =
            format!("at most {MOST_CONTACTS} contacts are resolved at once, found {}", contacts.len());
        let span = Some(root.key_span("contact"));
        root.sink().push(Problem::new(ProblemKind::OutOfRange, "contact", message, span));
    }
    let touches: Vec<Option<(String, Touch)>> = contacts.into_iter().enumerate().map(read_touch).collect();
    let section = root.section("body")?;
    let (mass, inertia) = (section.required("mass", MASS), section.required("inertia", INERTIA));
    if !section.has("velocity") {
        section.missing("velocity", "a list [vx, vy]");
    }
    let velocity = section.pair("velocity", ANY_SPEED);
    let spin = section.quantity("spin", ANY_SPIN);
    section.finish();
    let touches: Vec<(String, Touch)> = touches.into_iter().collect::<Option<_>>()?;
    let (names, touches): (Vec<_>, Vec<_>) = touches.into_iter().unzip();
    let [vx, vy] = velocity?;
    let body = ImpactBody {
        mass: mass?.value,
        inertia: inertia?.value,
        velocity: Vec2::new(vx.value, vy.value),
        spin: spin.map_or(0.0, |spin| spin.value),
        touches,
    };
    (!names.is_empty()).then_some((names, body))
}

fn read_touch((number, section): (usize, Section<'_>)) -> Option<(String, Touch)> {
    let name = section.text("name").map_or_else(|| letter(number), |(name, _)| name.to_owned());
    for key in ["point", "normal"] {
        if !section.has(key) {
            section.missing(key, "a list [x, y]");
        }
    }
    let point = section.pair("point", ANY_LENGTH);
    let normal = section.get("normal").and_then(|node| {
        let path = section.path_of("normal");
        let [x, y] = read_pair(&path, node, ANY_NUMBER, section.sink())?;
        let unit = Vec2::new(x.value, y.value).unit();
        if unit.is_none() {
            let message = "has no direction: it must not be zero";
            let span = Some(node.span.clone());
            section.sink().push(Problem::new(ProblemKind::Geometry, path, message, span));
        }
        unit
    });
    let friction = section.required("friction", FRICTION);
    let restitution = section.quantity("restitution", RESTITUTION);
    section.finish();
    let [x, y] = point?;
    let touch = Touch {
        arm: Vec2::new(x.value, y.value),
        normal: normal?,
        friction: friction?.value,
        restitution: restitution.map_or(0.0, |restitution| restitution.value),
    };
    Some((name, touch))
}

/// A, B, C …
fn letter(number: usize) -> String {
    char::from(b'A' + (number % 26) as u8).to_string()
}

fn read_operator(root: &Section<'_>) -> Option<(Vec<String>, Several)> {
    let section = root.section("operator")?;
    let found = if section.has("matrix") { read_many(&section) } else { read_one(&section) };
    section.finish();
    let contacts = found?;
    Some(((0..contacts.count).map(letter).collect(), contacts))
}

fn none() -> Several {
    Several {
        count: 0,
        operator: [[Block::default(); MOST_CONTACTS]; MOST_CONTACTS],
        slip: [0.0; MOST_CONTACTS],
        normal: [0.0; MOST_CONTACTS],
        friction: [0.0; MOST_CONTACTS],
        restitution: [0.0; MOST_CONTACTS],
    }
}

fn read_one(section: &Section<'_>) -> Option<Several> {
    let (tt, nn) = (section.required("w_tt", POSITIVE), section.required("w_nn", POSITIVE));
    let tn = section.required("w_tn", ANY_NUMBER);
    let (slip, approach) = (section.required("slip", ANY_SPEED), section.required("approach", APPROACH));
    let friction = section.required("friction", FRICTION);
    let restitution = section.quantity("restitution", RESTITUTION).map_or(0.0, |e| e.value);
    let (tt, tn, nn) = (tt?.value, tn?.value, nn?.value);
    if tn * tn >= tt * nn {
        let message = "is impossible for any bodies: w_tn² must be less than w_tt w_nn";
        let span = Some(section.key_span("w_tn"));
        section.sink().push(Problem::new(ProblemKind::OutOfRange, section.path_of("w_tn"), message, span));
        return None;
    }
    let mut set = none();
    set.count = 1;
    set.operator[0][0] = Block { tt, tn, nt: tn, nn };
    (set.slip[0], set.normal[0]) = (slip?.value, approach?.value);
    (set.friction[0], set.restitution[0]) = (friction?.value, restitution);
    Some(set)
}

/// `matrix` (2n × 2n), `velocity` (2n), `friction` and `restitution` (n, or one for all); tangential and normal by turns.
fn read_many(section: &Section<'_>) -> Option<Several> {
    let Some(matrix) = read_matrix(section) else {
        // How long the lists should be is not known: only their names are judged.
        for key in ["velocity", "friction", "restitution"] {
            section.get(key);
        }
        return None;
    };
    let count = matrix.len() / 2;
    let velocity = read_list(section, "velocity", 2 * count, ANY_SPEED);
    let friction = read_list(section, "friction", count, FRICTION);
    let restitution = if section.has("restitution") {
        read_list(section, "restitution", count, RESTITUTION)
    } else {
        Some(vec![0.0; count])
    };
    let (velocity, friction, restitution) = (velocity?, friction?, restitution?);
    let mut set = none();
    set.count = count;
    for i in 0..count {
        for j in 0..count {
            let at = |a: usize, b: usize| matrix[2 * i + a][2 * j + b];
            set.operator[i][j] = Block { tt: at(0, 0), tn: at(0, 1), nt: at(1, 0), nn: at(1, 1) };
        }
        (set.slip[i], set.normal[i]) = (velocity[2 * i], velocity[2 * i + 1]);
        (set.friction[i], set.restitution[i]) = (friction[i], restitution[i]);
    }
    Some(set)
}

fn read_matrix(section: &Section<'_>) -> Option<Vec<Vec<f64>>> {
    let node = section.get("matrix")?;
    let path = section.path_of("matrix");
    let problem = |kind, message: String| {
        section.sink().push(Problem::new(kind, path.clone(), message, Some(node.span.clone())));
        None
    };
    let Value::List(rows) = &node.value else {
        section.sink().push(expected("a list of rows [[..], ..]", &path, node));
        return None;
    };
    let size = rows.len();
    if size == 0 || size % 2 == 1 || size > 2 * MOST_CONTACTS {
        let most = 2 * MOST_CONTACTS;
        let message =
            format!("needs two rows for each contact, tangential and normal, up to {most}; found {size}");
        return problem(ProblemKind::WrongValue, message);
    }
    let numbers = |(i, row): (usize, &Node)| {
        let path = format!("{path}.{i}");
        numbers(&path, row, size, ANY_NUMBER, section.sink())
    };
    let matrix: Vec<Option<Vec<f64>>> = rows.iter().enumerate().map(numbers).collect();
    let matrix: Vec<Vec<f64>> = matrix.into_iter().collect::<Option<_>>()?;
    let largest = matrix.iter().flatten().fold(0.0f64, |largest, entry| largest.max(entry.abs()));
    let pairs = (0..size).flat_map(|i| (0..i).map(move |j| (i, j)));
    let mut skew = pairs.filter(|(i, j)| (matrix[*i][*j] - matrix[*j][*i]).abs() > ROUNDING * largest);
    if let Some((i, j)) = skew.next() {
        let message =
            format!("must be symmetric: [{i}][{j}] is {}, [{j}][{i}] is {}", matrix[i][j], matrix[j][i]);
        return problem(ProblemKind::OutOfRange, message);
    }
    if !is_semidefinite(&matrix, ROUNDING * largest) {
        let message =
            "must have no negative eigenvalue: an impulse cannot take a velocity against itself".into();
        return problem(ProblemKind::OutOfRange, message);
    }
    Some(matrix)
}

/// Cholesky's decomposition, a vanishing pivot having a vanishing row.
fn is_semidefinite(matrix: &[Vec<f64>], rounding: f64) -> bool {
    let mut left = matrix.to_vec();
    for k in 0..left.len() {
        let pivot = left[k][k];
        if pivot < -rounding
            || (pivot <= rounding && (k..left.len()).any(|i| left[i][k].abs() > 1e3 * rounding))
        {
            return false;
        }
        if pivot <= rounding {
            continue;
        }
        for i in k + 1..left.len() {
            for j in k + 1..left.len() {
                let taken = left[i][k] * left[k][j] / pivot;
                left[i][j] -= taken;
            }
        }
    }
    true
}

/// A list of `count` quantities, or one quantity for all.
fn read_list(section: &Section<'_>, key: &'static str, count: usize, kind: Kind) -> Option<Vec<f64>> {
    if !section.has(key) {
        section.missing(key, format!("a list of {count}"));
    }
    let node = section.get(key)?;
    let path = section.path_of(key);
    match &node.value {
        Value::List(_) => numbers(&path, node, count, kind, section.sink()),
        _ => Some(vec![read_quantity(&path, node, kind, section.sink())?.value; count]),
    }
}

fn numbers(path: &str, node: &Node, count: usize, kind: Kind, sink: &Sink) -> Option<Vec<f64>> {
    let Value::List(items) = &node.value else {
        sink.push(expected("a list", path, node));
        return None;
    };
    if items.len() != count {
        let message = format!("expected {count} numbers, found {}", items.len());
        sink.push(Problem::new(ProblemKind::WrongValue, path, message, Some(node.span.clone())));
        return None;
    }
    let values = items.iter().enumerate();
    let values: Vec<Option<f64>> = values
        .map(|(i, item)| Some(read_quantity(&format!("{path}.{i}"), item, kind, sink)?.value))
        .collect();
    values.into_iter().collect()
}
