//! The grammar of a scene as types, for its JSON Schema. The reader is the judge: a test holds the two to the same keys.

#![allow(dead_code, reason = "only the schemas of these types are used")]

use schemars::JsonSchema;
use std::collections::BTreeMap;

/// A text with a unit ("100 mm", "15 ± 0.5 deg"), a plain SI number, or a distribution.
#[derive(JsonSchema)]
#[schemars(untagged, rename = "Quantity")]
enum Quantity {
    /// SI.
    Number(f64),
    /// A number and a unit, with or without a tolerance.
    Text(String),
    /// A normal distribution.
    Normal(Normal),
    /// Every value between two is equally likely.
    Uniform(Uniform),
}

/// A normal distribution.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Normal {
    value: Box<Quantity>,
    sigma: Box<Quantity>,
}

/// A uniform distribution.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Uniform {
    low: Box<Quantity>,
    high: Box<Quantity>,
}

/// A point [x, y], or { x, y } [m].
#[derive(JsonSchema)]
#[schemars(untagged)]
enum Point {
    /// [x, y]
    Pair([Quantity; 2]),
    /// { x, y }
    Named(NamedPoint),
}

#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct NamedPoint {
    x: Quantity,
    y: Quantity,
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
enum Side {
    Left,
    Right,
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
enum Stop {
    Landed,
    Delivered,
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
pub(crate) enum Law {
    Poisson,
    Stronge,
    Newton,
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
enum Shape {
    Rod,
    Box,
    Polygon,
    Disc,
    Outline,
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
enum LengthUnit {
    M,
    Mm,
    Cm,
    Um,
    In,
    Ft,
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
enum Aim {
    Yield,
    Height,
    Time,
}

#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
enum WantWord {
    Same,
    Turned,
    Any,
}

/// same | turned | any, or the number of a face.
#[derive(JsonSchema)]
#[schemars(untagged)]
enum Want {
    /// A word.
    Word(WantWord),
    /// A face.
    Face(u32),
}

/// What stands on a feeder's drawing.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields, title = "carom scene")]
pub(crate) struct SceneFile {
    /// Downwards; 9.81 m/s² where it is left out.
    gravity: Option<Quantity>,
    /// landed: flat on the last plate (default); delivered: until it has left it.
    stop: Option<Stop>,
    part: Part,
    contact: Option<Contact>,
    start: Start,
    channel: Option<Channel>,
    /// The plates, in the order the part meets them.
    plate: Option<Vec<Plate>>,
    zigzag: Option<Zigzag>,
    wall: Option<Vec<Wall>>,
    feed: Option<Feed>,
    design: Option<Design>,
}

/// The part.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Part {
    shape: Shape,
    /// Rod, box.
    length: Option<Quantity>,
    /// Box.
    height: Option<Quantity>,
    /// Disc.
    radius: Option<Quantity>,
    /// Polygon: its corners, counter-clockwise.
    vertices: Option<Vec<[Quantity; 2]>>,
    /// Outline: a DXF or SVG file, from the scene's folder.
    file: Option<String>,
    /// Outline: the unit of a file that does not give its own.
    unit: Option<LengthUnit>,
    /// Outline: the only layer of a DXF file that is read; every visible one where it is left out.
    layer: Option<String>,
    /// Outline: all lengths of the file are multiplied by it; 1 where it is left out.
    scale: Option<Quantity>,
    /// Outline: how far chords may be from curves, and ends to be joined from each other; a thousandth of the size where it is left out.
    chord: Option<Quantity>,
    /// Rounds the corners; the straight sides stay where they are drawn.
    corner_radius: Option<Quantity>,
    /// Or density with depth.
    mass: Option<Quantity>,
    density: Option<Quantity>,
    depth: Option<Quantity>,
    /// Of a part that is not uniform, with its inertia: in the coordinates of the vertices or of the outline's file; of a rod or box from
    /// its middle.
    mass_centre: Option<[Quantity; 2]>,
    /// About the mass centre; from the shape where it is left out.
    inertia: Option<Quantity>,
}

/// Contact of the part with every plate and wall.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Contact {
    /// Coulomb's coefficient.
    friction: Option<Quantity>,
    /// From 0 (default) to 1.
    restitution: Option<Quantity>,
    /// Poisson's where it is left out.
    law: Option<Law>,
}

/// How the part starts, lying flat on the first plate.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Start {
    /// Mass centre to the plate's free edge, along the plate.
    to_edge: Quantity,
    /// Down the plate; 0 where it is left out.
    speed: Option<Quantity>,
    /// The face that is down; 0 where it is left out.
    face: Option<u32>,
}

/// Two vertical walls, the left one at x = 0.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Channel {
    width: Quantity,
    friction: Option<Quantity>,
    restitution: Option<Quantity>,
}

/// A line x/along + y/normal = 1 in the axes of the plate before: x from its free edge downhill, y down through it.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Line {
    along: Quantity,
    normal: Quantity,
}

/// A plate: placed by its wall, by a line, by a point below, by its edge, or by its two ends.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Plate {
    name: Option<String>,
    /// The wall it is hinged at; with height or drop, slope, and gap or length.
    wall: Option<Side>,
    /// Of the hinge.
    height: Option<Quantity>,
    /// Of the hinge, below the previous plate's.
    drop: Option<Quantity>,
    /// Below the horizontal, away from its uphill end.
    slope: Option<Quantity>,
    /// From its free edge to the other wall.
    gap: Option<Quantity>,
    length: Option<Quantity>,
    downhill: Option<Side>,
    line: Option<Line>,
    /// A point its line passes through, from the previous plate's free edge.
    below: Option<Point>,
    /// Its free edge.
    edge: Option<Point>,
    /// Its uphill end.
    from: Option<Point>,
    /// Its free edge.
    to: Option<Point>,
    friction: Option<Quantity>,
    restitution: Option<Quantity>,
    want: Option<Want>,
}

/// Plates hinged by turns at the two walls of the channel, all alike.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Zigzag {
    plates: Quantity,
    drop: Quantity,
    slope: Quantity,
    gap: Quantity,
    /// Of the first hinge; 0 where it is left out.
    height: Option<Quantity>,
    /// Of the first hinge; left where it is left out.
    wall: Option<Side>,
    friction: Option<Quantity>,
    restitution: Option<Quantity>,
    /// On the last plate.
    want: Option<Want>,
}

/// Another straight obstacle.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Wall {
    name: Option<String>,
    from: Point,
    to: Point,
    friction: Option<Quantity>,
    restitution: Option<Quantity>,
}

/// Several parts, one after another.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Feed {
    /// How many, 1 to 100.
    parts: Quantity,
    /// Time from one part's start to the next.
    interval: Quantity,
    /// Friction coefficient between parts; else that of `[contact]`.
    friction: Option<Quantity>,
    /// Coefficient of restitution between parts; else that of `[contact]`.
    restitution: Option<Quantity>,
}

/// What a design may choose, must keep and aims at.
#[derive(JsonSchema)]
#[schemars(deny_unknown_fields)]
struct Design {
    /// Paths with their ranges: "plate.lower.slope" = "10..40 deg".
    free: Option<BTreeMap<String, String>>,
    max_impact_speed: Option<Quantity>,
    max_sliding_speed: Option<Quantity>,
    max_height: Option<Quantity>,
    max_width: Option<Quantity>,
    max_time: Option<Quantity>,
    /// True where the part may touch no wall on its way; false where it is left out.
    forbid_walls: Option<bool>,
    /// yield where it is left out.
    aim: Option<Aim>,
}
