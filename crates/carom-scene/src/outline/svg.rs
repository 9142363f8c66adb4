//! SVG files: shapes and paths in millimetres, y turned up.

use super::drawn::{self, Drawn, Fault, Origin};
use super::edge::{Edge, Placement};
use super::svg_shape::shape_of;
use super::xml_entities::expanded_length;
use crate::input::LONGEST;
use crate::lines::Lines;
use crate::unit::{Dimension, Unit};
use carom_num::Vec2;
use carom_num::elementary::{sin_cos, tan};
use roxmltree::{Document, Node, ParsingOptions};
use std::f64::consts::PI;
use std::str::FromStr;
use svgtypes::{Align, AspectRatio, Length, LengthUnit, TransformListParser, TransformListToken, ViewBox};

/// Elements whose children are drawn.
const GROUPS: [&str; 4] = ["svg", "g", "a", "switch"];
/// Elements that hold what is drawn elsewhere, or nothing to draw.
const SILENT: [&str; 14] = [
    "defs",
    "symbol",
    "clipPath",
    "mask",
    "pattern",
    "marker",
    "linearGradient",
    "radialGradient",
    "filter",
    "style",
    "script",
    "title",
    "desc",
    "metadata",
];
/// Most elements and texts of a file.
const MOST_NODES: u32 = 1_000_000;
/// Deepest nesting of groups.
const DEEPEST: usize = 100;

/// Reads what an SVG text draws; `unit` is that of a user unit, where the file has no physical size.
///
/// # Errors
/// Everything that could not be read, with its line.
///
/// # Source
/// W3C, *Scalable Vector Graphics (SVG) 1.1*: 7.8 preserveAspectRatio, 8 paths, 9 shapes; *CSS Values*: 96 px to the inch.
pub(crate) fn read_svg(text: &str, unit: Option<Unit>) -> Result<Drawn, Vec<Fault>> {
    if expanded_length(text) > LONGEST {
        let why = format!("its entities, written out, are longer than {} MiB", LONGEST >> 20);
        return Err(vec![Fault::file(None, why).with_help("save it as plain SVG, without entities")]);
    }
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options)
        .map_err(|error| vec![Fault::file(error.pos().row as usize, format!("is not XML: {error}"))])?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let name = root.tag_name().name();
        return Err(vec![Fault::file(None, format!("is not SVG: its first element is <{name}>"))]);
    }
    let lines = Lines::of(text);
    let (page, said) = page(&lines, root, unit).map_err(|fault| vec![fault])?;
    let mut reader =
        Reader { lines: &lines, drawn: Drawn { unit: said, ..Drawn::default() }, faults: vec![] };
    reader.children(root, page, 0);
    if reader.faults.is_empty() { Ok(reader.drawn) } else { Err(reader.faults) }
}

struct Reader<'l> {
    lines: &'l Lines<'l>,
    drawn: Drawn,
    faults: Vec<Fault>,
}

impl Reader<'_> {
    fn children(&mut self, parent: Node<'_, '_>, outer: Placement, depth: usize) {
        for node in parent.children().filter(Node::is_element) {
            self.element(node, outer, depth + 1);
        }
    }

    fn element(&mut self, node: Node<'_, '_>, outer: Placement, depth: usize) {
        let name = node.tag_name().name();
        // Editors keep their own settings beside the drawing, in namespaces of their own.
        let foreign = node.tag_name().namespace().is_some_and(|space| !space.ends_with("/svg"));
        if foreign || SILENT.contains(&name) || is_hidden(node) {
            return;
        }
        let line = line_of(self.lines, node);
        let placement = match node.attribute("transform").map(transform) {
            None => outer,
            Some(Ok(own)) => outer.after(own),
            Some(Err(why)) => {
                self.faults
                    .push(Fault::new(line, format!("<{name}> has a transform that cannot be read: {why}")));
                return;
            }
        };
        if name == "use" || (name == "svg" && depth > 0) || depth > DEEPEST {
            let fault = Fault::unsupported(line, format!("<{name}> is not read"));
            self.faults.push(fault.with_help("unlink clones and take nested drawings apart before saving"));
        } else if GROUPS.contains(&name) {
            self.children(node, placement, depth);
        } else {
            match shape_of(node) {
                Ok(Some(chains)) => {
                    for (edges, closed) in chains {
                        let edges: Vec<Edge> = edges.iter().map(|edge| edge.placed(placement)).collect();
                        let origin = Origin { name: format!("<{name}>"), line };
                        self.faults.extend(self.drawn.push(edges, closed, origin).err());
                    }
                }
                Ok(None) => self.drawn.pass_over(&format!("<{name}>")),
                Err(why) => self.faults.push(Fault::new(line, format!("<{name}> {why}"))),
            }
        }
    }
}

fn line_of(lines: &Lines<'_>, node: Node<'_, '_>) -> usize {
    lines.line_of(node.range().start)
}

fn is_hidden(node: Node<'_, '_>) -> bool {
    let style = node.attribute("style").unwrap_or_default().replace(' ', "");
    node.attribute("display") == Some("none") || style.split(';').any(|rule| rule == "display:none")
}

/// From user units of the file to metres, y up; and how the unit is known.
fn page(lines: &Lines<'_>, root: Node<'_, '_>, wanted: Option<Unit>) -> Result<(Placement, String), Fault> {
    let line = line_of(lines, root);
    let length = |key| {
        let text: Option<&str> = root.attribute(key);
        let bad = || {
            Fault::new(line, format!("<svg> has a {key} that is no length: \"{}\"", text.unwrap_or_default()))
        };
        let length = text.map(|text| Length::from_str(text).map_err(|_| bad())).transpose();
        length.map(|length| length.filter(|length| length.unit != LengthUnit::Percent))
    };
    let (width, height) = (length("width")?, length("height")?);
    let view = root.attribute("viewBox").map(ViewBox::from_str).transpose();
    let view =
        view.map_err(|error| Fault::new(line, format!("<svg> has a viewBox that cannot be read: {error}")))?;
    // A file that gives its own size and a scene that gives a unit say two things: which is right cannot be guessed.
    let physical = [width, height].into_iter().flatten().find(|length| length.unit != LengthUnit::None);
    if let (Some(unit), Some(length)) = (wanted, physical) {
        let text = format!(
            "<svg> gives its own size, {}, but the scene gives a unit, {}",
            words(length),
            unit.symbol
        );
        return Err(Fault::new(line, text)
            .with_help("leave `unit` out; if the file is wrong about itself, `scale` puts it right"));
    }
    if let Some(unit) = wanted {
        let one = unit.to_si(1.0);
        let said = format!("user unit {}, from the scene", unit.symbol);
        return Ok((Placement::scaled(one, -one), said));
    }
    let Some(given) = width.or(height) else {
        let fault = Fault::new(line, "does not say its size: <svg> has no width and no height");
        return Err(fault.with_help("write the length of a user unit beside the file: unit = \"mm\""));
    };
    let metres = |length: Length| {
        let unknown =
            || Fault::new(line, format!("<svg> has a size of {}, which is no physical size", words(length)));
        metres(length).ok_or_else(unknown)
    };
    let Some(view) = view else {
        let px = metres(Length::new(1.0, LengthUnit::Px))?;
        return Ok((Placement::scaled(px, -px), "user unit px, 96 to the inch".to_owned()));
    };
    let across = width.map(metres).transpose()?.map(|width| width / view.w);
    let down = height.map(metres).transpose()?.map(|height| height / view.h);
    let (x, y) = match (across, down) {
        (Some(x), Some(y)) => fit(root, x, y),
        (Some(one), None) | (None, Some(one)) => (one, one),
        (None, None) => (1.0, 1.0),
    };
    let said = format!("user unit {}, from its size of {}", drawn::length(x), words(given));
    Ok((Placement::scaled(x, -y), said))
}

/// What `preserveAspectRatio` makes of two scales.
fn fit(root: Node<'_, '_>, x: f64, y: f64) -> (f64, f64) {
    let ratio = root.attribute("preserveAspectRatio").and_then(|text| AspectRatio::from_str(text).ok());
    match ratio {
        Some(ratio) if ratio.align == Align::None => (x, y),
        Some(ratio) if ratio.slice => (x.max(y), x.max(y)),
        _ => (x.min(y), x.min(y)),
    }
}

fn words(length: Length) -> String {
    let unit = match length.unit {
        LengthUnit::None => "",
        LengthUnit::Em => " em",
        LengthUnit::Ex => " ex",
        LengthUnit::Px => " px",
        LengthUnit::In => " in",
        LengthUnit::Cm => " cm",
        LengthUnit::Mm => " mm",
        LengthUnit::Pt => " pt",
        LengthUnit::Pc => " pc",
        LengthUnit::Percent => " %",
    };
    format!("{}{unit}", length.number)
}

/// A physical length [m]; plain numbers are pixels.
fn metres(length: Length) -> Option<f64> {
    let unit = |symbol| Dimension::Length.unit(symbol).map(|unit: Unit| unit.to_si(1.0));
    let number = length.number;
    match length.unit {
        LengthUnit::Mm => Some(number * unit("mm")?),
        LengthUnit::Cm => Some(number * unit("cm")?),
        LengthUnit::In => Some(number * unit("in")?),
        LengthUnit::Px | LengthUnit::None => Some(number / 96.0 * unit("in")?),
        LengthUnit::Pt => Some(number / 72.0 * unit("in")?),
        LengthUnit::Pc => Some(number / 6.0 * unit("in")?),
        LengthUnit::Em | LengthUnit::Ex | LengthUnit::Percent => None,
    }
}

/// A list of transforms as one, the last applied first.
fn transform(text: &str) -> Result<Placement, svgtypes::Error> {
    let mut all = Placement::scaled(1.0, 1.0);
    for token in TransformListParser::from(text) {
        let upright = Placement::scaled(1.0, 1.0);
        let own = match token? {
            TransformListToken::Matrix { a, b, c, d, e, f } => {
                Placement { x: Vec2::new(a, b), y: Vec2::new(c, d), origin: Vec2::new(e, f) }
            }
            TransformListToken::Translate { tx, ty } => Placement::shifted(Vec2::new(tx, ty)),
            TransformListToken::Scale { sx, sy } => Placement::scaled(sx, sy),
            TransformListToken::Rotate { angle } => {
                let (sin, cos) = sin_cos(angle * PI / 180.0);
                Placement { x: Vec2::new(cos, sin), y: Vec2::new(-sin, cos), ..upright }
            }
            TransformListToken::SkewX { angle } => {
                Placement { y: Vec2::new(tan(angle * PI / 180.0), 1.0), ..upright }
            }
            TransformListToken::SkewY { angle } => {
                Placement { x: Vec2::new(1.0, tan(angle * PI / 180.0)), ..upright }
            }
        };
        all = all.after(own);
    }
    Ok(all)
}
