//! Dimensions of a DXF drawing: each an entity that names the points it measures, and a block that is its picture.

use crate::draft::{Axis, Draft};
use crate::dxf_file::{Group, mm, plain};
use crate::labels::Labels;
use crate::layout::{Paper, name_place, slope_place};
use crate::measures::{self, slope_text};
use crate::measures_svg::placed;
use crate::mechanism::Drawn;
use crate::senses::slope;
use crate::view::View;
use carom_feeder::Feeder;
use carom_num::Vec2;
use carom_num::elementary::atan2;

const LAYER: &str = "DIMENSIONS";
/// Height of a letter of the sheet [px].
const LETTERS: f64 = 9.0;
/// Length and half the width of a head [px].
const HEAD: (f64, f64) = (9.0, 1.8);
/// What a dimension measures, as its entity says it; its text stands where it is put.
const TURNED: u32 = 128;
const ALIGNED: u32 = 1 + 128;
const ANGULAR: u32 = 2 + 128;
const RADIAL: u32 = 4 + 128;

/// Dimensions as they come, with the places that their texts take on the sheet.
pub(crate) struct Dimensions<'v> {
    view: &'v View,
    labels: Labels,
    blocks: Group,
    entities: Group,
    count: usize,
}

impl<'v> Dimensions<'v> {
    pub(crate) fn of(view: &'v View) -> Self {
        let paper = Paper::around(view);
        let labels = Labels::within(paper.low, paper.high);
        Self { view, labels, blocks: Group::default(), entities: Group::default(), count: 0 }
    }

    /// Height of the letters [mm].
    pub(crate) fn letters(&self) -> f64 {
        1e3 * LETTERS / self.view.scale
    }

    /// Blocks and entities.
    pub(crate) fn done(self) -> (String, String) {
        (self.blocks.text, self.entities.text)
    }

    /// A place of the sheet in the world.
    fn world(&self, p: Vec2) -> Vec2 {
        Vec2::new(self.view.low.x + p.x / self.view.scale, self.view.high.y - p.y / self.view.scale)
    }

    /// A name along the back of a plate, clear of the dimensions.
    pub(crate) fn name(&mut self, out: &mut Group, d: &Drawn, name: &str) {
        let (at, right) = name_place(d, name, &mut self.labels);
        let angle = atan2(-right.y, right.x).to_degrees();
        out.centred(LAYER, self.world(at), self.letters(), angle, name);
    }

    /// Every length of the layout, and the radii of its arcs.
    pub(crate) fn lengths(&mut self, feeder: &Feeder, draft: &Draft) {
        for drawn in measures::lengths(feeder, draft, true) {
            let Some(place) = placed(&drawn, self.view, &mut self.labels) else { continue };
            let (a, b) = (self.world(place.line.0), self.world(place.line.1));
            let (at, angle) = (self.world(place.at), atan2(-place.along.y, place.along.x).to_degrees());
            let name = self.begin_block();
            if drawn.axis == Axis::Radius {
                self.radius(&name, &drawn, (a, at));
                continue;
            }
            self.blocks.line(LAYER, drawn.from, a);
            self.blocks.line(LAYER, drawn.to, b);
            self.blocks.line(LAYER, a, b);
            self.head(b, b - a);
            self.head(a, a - b);
            self.end_block(at, angle, &drawn.text, &[drawn.from, drawn.to, b]);
            let (kind, turned) = match drawn.axis {
                Axis::Level => (TURNED, 0.0),
                Axis::Plumb => (TURNED, 90.0),
                Axis::Along | Axis::Slope | Axis::Radius => (ALIGNED, 0.0),
            };
            self.entity(&name, kind, at, &drawn.text, b);
            self.entities.point(13, drawn.from);
            self.entities.point(14, drawn.to);
            if kind == TURNED {
                self.entities.group(50, plain(turned, 1));
            }
        }
    }

    /// The radius of an arc, by a line that comes from `end` to its middle.
    fn radius(&mut self, name: &str, drawn: &measures::Drawn, (end, at): (Vec2, Vec2)) {
        self.blocks.line(LAYER, end, drawn.to);
        self.head(drawn.to, drawn.to - end);
        self.end_block(at, 0.0, &drawn.text, &[drawn.from, drawn.to]);
        self.entity(name, RADIAL, at, &drawn.text, drawn.from);
        self.entities.point(15, drawn.to);
        self.entities.group(40, mm((drawn.to - end).norm()));
    }

    /// The slope of a plate, between it and the level line through its free edge.
    pub(crate) fn slope(&mut self, feeder: &Feeder, draft: &Draft, plate: usize, d: &Drawn) {
        let Some(drawn) = feeder.plates.get(plate) else { return };
        let text = slope_text(feeder, draft, plate);
        let falls = slope(drawn.uphill, drawn.edge);
        let Some(mark) = slope_place(d, falls, &text, &mut self.labels) else { return };
        let (tip, level, up) = (self.world(d.to), self.world(mark.ends.0), self.world(mark.ends.1));
        let at = self.world(mark.at);
        let radius = mark.radius / self.view.scale;
        let name = self.begin_block();
        self.blocks.line(LAYER, tip, level);
        let angle = |p: Vec2| atan2(p.y - tip.y, p.x - tip.x).to_degrees();
        // Counter-clockwise: from the level line where the plate rises to the right, to it where it rises to the left.
        let ends = if level.x > tip.x { [angle(level), angle(up)] } else { [angle(up), angle(level)] };
        self.blocks.arc(LAYER, tip, radius, ends);
        self.end_block(at, 0.0, &text, &[tip, level, up]);
        // Angles are measured counter-clockwise, from the first line to the second.
        let (first, second) = if level.x > tip.x { (level, up) } else { (up, level) };
        self.entity(&name, ANGULAR, at, &text, second);
        self.entities.point(13, tip);
        self.entities.point(14, first);
        self.entities.point(15, tip);
        // The arc passes through the middle of its angle.
        let middle = ((level - tip) + (up - tip)).unit().map_or(level, |half| tip + half * radius);
        self.entities.point(16, middle);
    }

    fn entity(&mut self, name: &str, kind: u32, at: Vec2, text: &str, point: Vec2) {
        self.entities.begin("DIMENSION", LAYER);
        self.entities.group(2, name);
        self.entities.point(10, point);
        self.entities.point(11, at);
        self.entities.group(70, kind);
        self.entities.group(1, crate::dxf_file::ascii(text));
        self.entities.group(3, "STANDARD");
    }

    fn begin_block(&mut self) -> String {
        let name = format!("*D{}", self.count);
        self.count += 1;
        self.blocks.begin("BLOCK", "0");
        self.blocks.group(2, &name);
        self.blocks.group(70, 1);
        self.blocks.point(10, Vec2::ZERO);
        self.blocks.group(3, &name);
        name
    }

    fn end_block(&mut self, at: Vec2, angle: f64, text: &str, measured: &[Vec2]) {
        let letters = self.letters();
        self.blocks.centred(LAYER, at, letters, angle, text);
        for point in measured {
            self.blocks.begin("POINT", "DEFPOINTS");
            self.blocks.point(10, *point);
        }
        self.blocks.begin("ENDBLK", "0");
    }

    /// The head of a dimension line at its end.
    fn head(&mut self, tip: Vec2, direction: Vec2) {
        let Some(along) = direction.unit() else { return };
        let (long, half) = (HEAD.0 / self.view.scale, HEAD.1 / self.view.scale);
        let (foot, side) = (tip - along * long, along.turned_left() * half);
        self.blocks.triangle(LAYER, [tip, foot + side, foot - side]);
    }
}
