//! An impact file with some of its numbers moved: what a diagram over two of them reads again and again.

use crate::impact_file::{self, ImpactProblem};
use crate::node::{Entry, Node, Value, from_toml};
use crate::problem::Problems;
use crate::quantity::parse;
use crate::unit::Dimension;

/// A number of an impact file that may be moved.
///
/// # Example
/// A spin that is not written is zero.
/// ```
/// use carom_scene::*;
/// let template = ImpactTemplate::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// let spin = template.numbers().iter().find(|number| number.path == "body.spin").unwrap();
/// assert_eq!((spin.value, spin.dimension), (0.0, unit::Dimension::Spin));
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactNumber {
    /// Its path: `body.spin`, `contact.0.point.x`.
    pub path: String,
    /// What it measures.
    pub dimension: Dimension,
    /// Its value in the file, SI; the default where the file does not say it.
    pub value: f64,
}

/// An impact file that is free of problems, kept to be read with other numbers.
///
/// # Example
/// With half the mass the same strike takes half the impulse.
/// ```
/// use carom_scene::*;
/// let template = ImpactTemplate::parse("ball.toml", r#"
///     body = { mass = 2, inertia = 0.4, velocity = [0, -3] }
///     contact = [{ point = [0, -1], normal = [0, 1], friction = 0.3, restitution = 0.5 }]
/// "#)?;
/// let normal = |ball: ImpactProblem| ball.solve().walk().unwrap().outcome.impulse[0][1];
/// let impulse = |mass| template.at(&[("body.mass", mass)]).map(normal);
/// assert!((impulse(2.0)? - 9.0).abs() < 1e-14 && (impulse(1.0)? - 4.5).abs() < 1e-14);
/// # Ok::<(), carom_scene::Problems>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct ImpactTemplate {
    file: String,
    tree: Node,
    numbers: Vec<ImpactNumber>,
}

impl ImpactTemplate {
    /// Reads the TOML text of an impact; `file` is the name its problems are reported under.
    ///
    /// # Errors
    /// Every problem found.
    ///
    /// # Example
    /// ```
    /// use carom_scene::ImpactTemplate;
    /// let template = ImpactTemplate::parse("ball.toml", r#"
    ///     [body]
    ///     mass = 1
    ///     inertia = 0.4
    ///     velocity = [0, -2]
    ///     [[contact]]
    ///     point = [0, -1]
    ///     normal = [0, 1]
    ///     friction = 0.3
    /// "#)?;
    /// let paths: Vec<&str> = template.numbers().iter().map(|number| number.path.as_str()).collect();
    /// assert!(paths.contains(&"body.spin") && paths.contains(&"contact.0.friction"));
    /// let moved = template.at(&[("body.velocity.x", 3.0)])?;
    /// assert_eq!(moved.contacts.before(), [[3.0, -2.0]]);
    /// # Ok::<(), carom_scene::Problems>(())
    /// ```
    pub fn parse(file: &str, source: &str) -> Result<Self, Problems> {
        ImpactProblem::parse(file, source)?;
        let (mut tree, _) = from_toml(source);
        complete(&mut tree);
        let mut numbers = vec![];
        collect("", None, &tree, &mut numbers);
        Ok(Self { file: file.to_owned(), tree, numbers })
    }

    /// Every number that may be moved, in the order of the file.
    pub fn numbers(&self) -> &[ImpactNumber] {
        &self.numbers
    }

    /// The impact with these numbers (path and SI value) in place of the file's. A path that is none of [`ImpactTemplate::numbers`] is
    /// passed over.
    ///
    /// # Errors
    /// Every problem that the numbers bring.
    pub fn at(&self, moved: &[(&str, f64)]) -> Result<ImpactProblem, Problems> {
        let mut tree = self.tree.clone();
        for (path, value) in moved {
            if let Some(node) = path.split('.').try_fold(&mut tree, step) {
                node.value = Value::Number(*value);
            }
        }
        impact_file::read(&tree, "").map_err(|list| {
            let list = list.into_iter().map(|problem| crate::Problem { span: None, ..problem });
            Problems::new(&self.file, "", list.collect())
        })
    }
}

/// What a key of an impact file measures.
fn dimension(key: &str) -> Option<Dimension> {
    match key {
        "mass" => Some(Dimension::Mass),
        "inertia" => Some(Dimension::Inertia),
        "velocity" | "slip" | "approach" => Some(Dimension::Speed),
        "spin" => Some(Dimension::Spin),
        "point" => Some(Dimension::Length),
        "force" => Some(Dimension::Force),
        "torque" => Some(Dimension::Torque),
        "gravity" => Some(Dimension::Acceleration),
        "friction" | "restitution" | "normal" | "w_tt" | "w_tn" | "w_nn" => Some(Dimension::Number),
        _ => None,
    }
}

/// Writes out the numbers that a file may leave to their defaults.
fn complete(tree: &mut Node) {
    let span = tree.span.clone();
    let zero = |key: &str| Entry {
        key: key.to_owned(),
        key_span: span.clone(),
        node: Node { value: Value::Number(0.0), span: span.clone() },
    };
    let fill = |node: &mut Node, key: &str| {
        if let Value::Table(entries) = &mut node.value
            && !entries.iter().any(|entry| entry.key == key)
        {
            entries.push(zero(key));
        }
    };
    let Value::Table(entries) = &mut tree.value else { return };
    for Entry { key, node, .. } in entries {
        match (key.as_str(), &mut node.value) {
            ("body", _) => fill(node, "spin"),
            ("contact", Value::List(contacts)) => contacts.iter_mut().for_each(|c| fill(c, "restitution")),
            ("operator", Value::Table(inner)) if !inner.iter().any(|entry| entry.key == "matrix") => {
                fill(node, "restitution");
            }
            _ => {}
        }
    }
}

fn collect(path: &str, measured: Option<Dimension>, node: &Node, numbers: &mut Vec<ImpactNumber>) {
    let join = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
    let value = match &node.value {
        Value::Number(number) => Some(*number),
        Value::Text(text) => measured.and_then(|dimension| parse(text, dimension).ok()).map(|w| w.value),
        _ => None,
    };
    if let (Some(dimension), Some(value)) = (measured, value) {
        numbers.push(ImpactNumber { path: path.to_owned(), dimension, value });
    }
    match &node.value {
        Value::Table(entries) => {
            for Entry { key, node, .. } in entries {
                collect(&join(key), dimension(key), node, numbers);
            }
        }
        Value::List(items) => {
            // A list of two quantities is a vector, of tables a list of contacts; a matrix must stay symmetric and is left alone.
            let vector = measured.is_some() && items.len() == 2 && !path.starts_with("operator");
            for (i, item) in items.iter().enumerate() {
                let name = if vector { ["x", "y"][i].to_owned() } else { i.to_string() };
                collect(&join(&name), measured, item, numbers);
            }
        }
        _ => {}
    }
}

/// One step down the tree.
fn step<'n>(node: &'n mut Node, key: &str) -> Option<&'n mut Node> {
    match &mut node.value {
        Value::Table(entries) => {
            entries.iter_mut().find(|entry| entry.key == key).map(|entry| &mut entry.node)
        }
        Value::List(items) => {
            let number = match key {
                "x" => 0,
                "y" => 1,
                key => key.parse().ok()?,
            };
            items.get_mut(number)
        }
        _ => None,
    }
}
