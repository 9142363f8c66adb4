//! A region diagram as SVG: regions in colours with their names inside, the boundaries that were found, closed-form curves over them.

use crate::FIGURE_CSS;
use crate::csv::csv_cell;
use crate::regions_legend::{Entry, cross, legend, wrapped};
use crate::text::{escape, fixed, px, significant};
use crate::ticks::ticks;
use carom_study::regions::{Junction, Place, Regions};

/// Size of the plane [px], and where it lies.
const WIDTH: f64 = 470.0;
const HEIGHT: f64 = 410.0;
const LEFT: f64 = 62.0;
const TOP: f64 = 82.0;
const BOTTOM: f64 = 48.0;
/// Where the legend begins, and how wide it is.
pub(crate) const LEGEND: f64 = LEFT + WIDTH + 22.0;
pub(crate) const LEGEND_WIDTH: f64 = 268.0;
/// Fills there are; more labels use them again.
pub(crate) const FILLS: usize = 16;
/// Share of the plane below which a region is no region: an outcome at equality, or rounding.
const SEEN: f64 = 1e-7;
/// Letters of a line under the title, and lines there.
const SUBTITLE: usize = 130;
const SUBTITLES: usize = 2;
/// Connected regions that get a name at most.
const MOST_NAMES: usize = 40;

/// An axis of a diagram.
///
/// # Example
/// Units stand in brackets, with their powers raised.
/// ```
/// # use carom_figure::{RegionAxis, RegionCurve, RegionDiagram, RegionName, regions_svg};
/// # use carom_study::regions::{Options, Range, find};
/// # let side = Range { from: 0.0, to: 1.0, count: 20 };
/// # let regions = find(side, side, &Options::default(), |x, _| u8::from(x > 0.25)).unwrap();
/// # let name = |label: u8| RegionName { short: label.to_string(), long: format!("state {label}") };
/// # let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
/// # let diagram = RegionDiagram {
/// #     title: "half".to_owned(), subtitle: String::new(), axes: [axis("x", "m"), axis("y", "kg m^2")],
/// #     regions: &regions, name: &name, curves_are: "closed forms".to_owned(), curves: vec![], here: None,
/// # };
/// let svg = regions_svg(&diagram);
/// assert!(svg.contains("x  [m]") && svg.contains("y  [kg m²]"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RegionAxis {
    /// What it measures, as it is written beside it: `friction f`.
    pub name: String,
    /// Its unit; empty for plain numbers.
    pub unit: String,
}

/// How a label is written.
///
/// # Example
/// The short name stands in the region, both stand in the legend.
/// ```
/// # use carom_figure::{RegionAxis, RegionCurve, RegionDiagram, RegionName, regions_svg};
/// # use carom_study::regions::{Options, Range, find};
/// # let side = Range { from: 0.0, to: 1.0, count: 20 };
/// # let regions = find(side, side, &Options::default(), |x, _| u8::from(x > 0.25)).unwrap();
/// # let name = |label: u8| RegionName { short: label.to_string(), long: format!("state {label}") };
/// # let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
/// # let diagram = RegionDiagram {
/// #     title: "half".to_owned(), subtitle: String::new(), axes: [axis("x", "m"), axis("y", "kg m^2")],
/// #     regions: &regions, name: &name, curves_are: "closed forms".to_owned(), curves: vec![], here: None,
/// # };
/// let svg = regions_svg(&diagram);
/// let inside = |line: &str| line.starts_with("<text class=\"state\"") && line.ends_with(">1</text>");
/// assert!(svg.lines().any(inside) && svg.contains(">1  state 1</text>"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RegionName {
    /// Inside its region: a number or a few letters.
    pub short: String,
    /// In the legend.
    pub long: String,
}

/// A curve that is drawn over the boundaries.
///
/// # Example
/// A curve at half of an axis of 470 px that begins at 62 px is drawn at 297 px.
/// ```
/// # use carom_figure::{RegionAxis, RegionCurve, RegionDiagram, RegionName, regions_svg};
/// # use carom_study::regions::{Options, Range, find};
/// # let side = Range { from: 0.0, to: 1.0, count: 20 };
/// # let regions = find(side, side, &Options::default(), |x, _| u8::from(x > 0.25)).unwrap();
/// # let name = |label: u8| RegionName { short: label.to_string(), long: format!("state {label}") };
/// # let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
/// # let diagram = RegionDiagram {
/// #     title: "half".to_owned(), subtitle: String::new(), axes: [axis("x", "m"), axis("y", "kg m^2")],
/// #     regions: &regions, name: &name, curves_are: "closed forms".to_owned(), curves: vec![], here: None,
/// # };
/// let middle = RegionCurve { name: "x = 1/2".to_owned(), pieces: vec![vec![[0.5, 0.0], [0.5, 1.0]]] };
/// let svg = regions_svg(&RegionDiagram { curves: vec![middle], ..diagram });
/// assert!(svg.contains("class=\"closed-form\" d=\"M297 ") && svg.contains(">x = 1/2</text>"));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct RegionCurve {
    /// What it is called.
    pub name: String,
    /// Its pieces, in units of the axes.
    pub pieces: Vec<Vec<[f64; 2]>>,
}

/// A diagram to draw.
///
/// # Example
/// Where x > 1/4 it is state 1, else state 0: three quarters of the plane, and one.
/// ```
/// # use carom_figure::{RegionAxis, RegionCurve, RegionDiagram, RegionName, regions_svg};
/// # use carom_study::regions::{Options, Range, find};
/// # let side = Range { from: 0.0, to: 1.0, count: 20 };
/// # let regions = find(side, side, &Options::default(), |x, _| u8::from(x > 0.25)).unwrap();
/// # let name = |label: u8| RegionName { short: label.to_string(), long: format!("state {label}") };
/// # let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
/// # let diagram = RegionDiagram {
/// #     title: "half".to_owned(), subtitle: String::new(), axes: [axis("x", "m"), axis("y", "kg m^2")],
/// #     regions: &regions, name: &name, curves_are: "closed forms".to_owned(), curves: vec![], here: None,
/// # };
/// let svg = regions_svg(&diagram);
/// assert!(svg.contains("75.0 %") && svg.contains("25.0 %"));
/// ```
pub struct RegionDiagram<'a, L> {
    /// What it shows.
    pub title: String,
    /// What is fixed.
    pub subtitle: String,
    /// Abscissa and ordinate.
    pub axes: [RegionAxis; 2],
    /// The regions.
    pub regions: &'a Regions<L>,
    /// How a label is written.
    pub name: &'a dyn Fn(L) -> RegionName,
    /// What the curves are, for the legend: `closed forms`.
    pub curves_are: String,
    /// Curves drawn over the boundaries.
    pub curves: Vec<RegionCurve>,
    /// A point that is marked, with what it is: the scene as it is written.
    pub here: Option<([f64; 2], String)>,
}

impl<L: Copy + Ord> RegionDiagram<'_, L> {
    /// Pixels of a point of the plane.
    fn at(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        let (u, v) = (self.regions.x.share(x), self.regions.y.share(y));
        (LEFT + u * WIDTH, TOP + (1.0 - v) * HEIGHT)
    }

    fn path(&self, points: &[[f64; 2]], closed: bool) -> String {
        let mut path = String::new();
        for (k, point) in points.iter().enumerate() {
            let (x, y) = self.at(*point);
            path += &format!("{}{} {}", if k == 0 { "M" } else { "L" }, px(x), px(y));
        }
        if closed { path + "Z" } else { path }
    }

    /// The class of a label's fill.
    fn fill(&self, label: L) -> usize {
        let seen = self.regions.shares.iter().filter(|share| share.area > SEEN);
        seen.take_while(|share| share.label != label).count() % FILLS
    }

    fn patches(&self) -> String {
        let mut out = String::new();
        for share in &self.regions.shares {
            let patches = self.regions.patches.iter().filter(|patch| patch.label == share.label);
            let path: String = patches.map(|patch| self.path(&patch.outline, true)).collect();
            out += &format!("<path class=\"region r{}\" d=\"{path}\"/>\n", self.fill(share.label));
        }
        out
    }

    /// True where a label takes room that can be seen.
    fn is_seen(&self, label: L) -> bool {
        self.regions.shares.iter().any(|share| share.label == label && share.area > SEEN)
    }

    /// Junctions between regions that are seen.
    fn junctions(&self) -> impl Iterator<Item = &Junction<L>> {
        self.regions
            .junctions
            .iter()
            .filter(|junction| junction.labels.iter().all(|label| self.is_seen(*label)))
    }

    fn boundaries(&self) -> String {
        let lines = self.regions.boundaries.iter();
        let paths: String = lines.map(|line| self.path(&line.points, line.closed)).collect();
        let mut out = format!("<path class=\"boundary\" d=\"{paths}\"/>\n");
        for curve in &self.curves {
            let path: String = curve.pieces.iter().map(|piece| self.path(piece, false)).collect();
            out += &format!(
                "<path class=\"closed-form\" d=\"{path}\"><title>{}</title></path>\n",
                escape(&curve.name)
            );
        }
        for junction in self.junctions() {
            let (x, y) = self.at(junction.at);
            out += &format!("<circle class=\"junction\" cx=\"{}\" cy=\"{}\" r=\"3.6\"/>\n", px(x), px(y));
        }
        out + &self.here_within().map_or(String::new(), |(at, _)| cross(self.at(at)))
    }

    /// What is marked, where it lies in the plane.
    fn here_within(&self) -> Option<([f64; 2], &str)> {
        let (at, words) = self.here.as_ref()?;
        let shares = [self.regions.x.share(at[0]), self.regions.y.share(at[1])];
        shares.iter().all(|share| (0.0..=1.0).contains(share)).then_some((*at, words.as_str()))
    }

    /// Half the room around a place [px], across and up.
    fn room(&self, place: &Place<L>) -> (f64, f64) {
        let cells = place.clearance as f64 + 0.5;
        let [columns, rows] = [self.regions.x.count, self.regions.y.count].map(|count| count as f64);
        (cells / columns * WIDTH, cells / rows * HEIGHT)
    }

    fn names(&self) -> String {
        let mut out = String::new();
        for place in self.regions.places.iter().take(MOST_NAMES) {
            let (room, up) = self.room(place);
            let RegionName { short, long } = (self.name)(place.label);
            let half = |text: &str, letter: f64| 0.5 * letter * text.chars().count() as f64;
            let (x, y) = self.at(place.at);
            let text = |class: &str, y: f64, text: &str| {
                format!("<text class=\"{class}\" x=\"{}\" y=\"{}\">{}</text>\n", px(x), px(y), escape(text))
            };
            let two_lines = long != short && half(&long, 6.2) < room && up > 18.0;
            if half(&short, 7.5) > room + 5.0 || up < 5.0 {
                continue;
            }
            let base = if two_lines { y - 1.0 } else { y + 5.0 };
            out += &text("state", base, &short);
            if two_lines {
                out += &text("state-words", base + 14.0, &long);
            }
        }
        out
    }

    fn axis_lines(&self) -> String {
        let (right, floor) = (LEFT + WIDTH, TOP + HEIGHT);
        let mut out = String::new();
        let across = ticks(self.regions.x.from, self.regions.x.to, 7);
        for v in &across.at {
            let (x, _) = self.at([*v, self.regions.y.from]);
            out += &line("axis", [x, floor], [x, floor + 4.0]);
            out += &label("", "middle", [x, floor + 17.0], &tick(*v, across.decimals));
        }
        let up = ticks(self.regions.y.from, self.regions.y.to, 7);
        for v in &up.at {
            let (_, y) = self.at([self.regions.x.from, *v]);
            out += &line("axis", [LEFT - 4.0, y], [LEFT, y]);
            out += &label("", "end", [LEFT - 7.0, y + 3.8], &tick(*v, up.decimals));
        }
        out += &format!(
            "<rect class=\"axis\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
            px(LEFT),
            px(TOP),
            px(WIDTH),
            px(HEIGHT)
        );
        let [x, y] = &self.axes;
        out += &label("name", "end", [right, floor + 36.0], &with_unit(x));
        out + &label("name", "start", [8.0, TOP - 10.0], &with_unit(y))
    }
}

pub(crate) fn tick(v: f64, decimals: usize) -> String {
    if v != 0.0 && (v.abs() >= 1e6 || decimals > 5) { significant(v, 3) } else { fixed(v, decimals) }
}

fn with_unit(axis: &RegionAxis) -> String {
    if axis.unit.is_empty() {
        axis.name.clone()
    } else {
        format!("{}  [{}]", axis.name, axis.unit.replace("^2", "²").replace("^3", "³"))
    }
}

pub(crate) fn line(class: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) -> String {
    format!(
        "<line class=\"{class}\" x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n",
        px(x1),
        px(y1),
        px(x2),
        px(y2)
    )
}

pub(crate) fn label(class: &str, anchor: &str, [x, y]: [f64; 2], text: &str) -> String {
    format!(
        "<text class=\"{class}\" text-anchor=\"{anchor}\" x=\"{}\" y=\"{}\">{}</text>\n",
        px(x),
        px(y),
        escape(text)
    )
}

/// A region diagram as a stand-alone SVG: regions with their names, boundaries (solid), curves (dashed), junctions (rings), axes with
/// units, and a legend with the share of the plane that each label takes.
///
/// # Example
/// Titles are escaped.
/// ```
/// # use carom_figure::{RegionAxis, RegionCurve, RegionDiagram, RegionName, regions_svg};
/// # use carom_study::regions::{Options, Range, find};
/// # let side = Range { from: 0.0, to: 1.0, count: 20 };
/// # let regions = find(side, side, &Options::default(), |x, _| u8::from(x > 0.25)).unwrap();
/// # let name = |label: u8| RegionName { short: label.to_string(), long: format!("state {label}") };
/// # let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
/// # let diagram = RegionDiagram {
/// #     title: "half".to_owned(), subtitle: String::new(), axes: [axis("x", "m"), axis("y", "kg m^2")],
/// #     regions: &regions, name: &name, curves_are: "closed forms".to_owned(), curves: vec![], here: None,
/// # };
/// let svg = regions_svg(&RegionDiagram { title: "x & y".to_owned(), ..diagram });
/// assert!(svg.contains("x &amp; y") && !svg.contains("x & y"));
/// ```
pub fn regions_svg<L: Copy + Ord>(diagram: &RegionDiagram<'_, L>) -> String {
    let entry = |share: &carom_study::regions::Share<L>| Entry {
        fill: diagram.fill(share.label),
        name: (diagram.name)(share.label),
        area: share.area,
    };
    let entries: Vec<Entry> =
        diagram.regions.shares.iter().filter(|share| share.area > SEEN).map(entry).collect();
    let drawn = diagram.curves.iter().filter(|curve| !curve.pieces.is_empty());
    let curves: Vec<&str> = drawn.map(|curve| curve.name.as_str()).collect();
    let marks = (diagram.junctions().next().is_some(), diagram.here_within().map(|(_, words)| words));
    let (key, bottom) = legend(&entries, (&diagram.curves_are, &curves), marks, TOP);
    let width = LEGEND + LEGEND_WIDTH;
    let height = (TOP + HEIGHT + BOTTOM).max(bottom + 12.0);
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"fig\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"{2}\">\n<style>{FIGURE_CSS}{REGIONS_CSS}</style>\n",
        px(width),
        px(height),
        escape(&diagram.title)
    );
    out += &format!("<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n", px(width), px(height));
    out += &label("title", "start", [8.0, 20.0], &diagram.title);
    let lines = wrapped(&diagram.subtitle, SUBTITLE);
    for (k, part) in lines.iter().take(SUBTITLES).enumerate() {
        let more = if k + 1 == SUBTITLES && lines.len() > SUBTITLES { " …" } else { "" };
        out += &label("small", "start", [8.0, 36.0 + 14.0 * k as f64], &format!("{part}{more}"));
    }
    out += &diagram.patches();
    out += &diagram.boundaries();
    out += &diagram.axis_lines();
    out += &diagram.names();
    out + &key + "</svg>\n"
}

/// The boundaries as CSV: x and y under these names, the two labels, and the number of the polyline.
///
/// # Example
/// State 1 begins at x = 1/4, whatever y.
/// ```
/// # use carom_figure::{RegionAxis, RegionCurve, RegionDiagram, RegionName, regions_svg};
/// # use carom_study::regions::{Options, Range, find};
/// # let side = Range { from: 0.0, to: 1.0, count: 20 };
/// # let regions = find(side, side, &Options::default(), |x, _| u8::from(x > 0.25)).unwrap();
/// # let name = |label: u8| RegionName { short: label.to_string(), long: format!("state {label}") };
/// # let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
/// # let diagram = RegionDiagram {
/// #     title: "half".to_owned(), subtitle: String::new(), axes: [axis("x", "m"), axis("y", "kg m^2")],
/// #     regions: &regions, name: &name, curves_are: "closed forms".to_owned(), curves: vec![], here: None,
/// # };
/// let csv = carom_figure::regions_csv(&regions, ["x_m", "y"], &name);
/// assert_eq!(csv.lines().next(), Some("x_m,y,label_a,label_b,polyline"));
/// let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
/// assert!(rows.len() > 1 && rows.iter().all(|row| row[2..] == ["0", "1", "0"]));
/// // Boundaries are located to about a billionth of the plane.
/// assert!(rows.iter().all(|row| (row[0].parse::<f64>().unwrap() - 0.25).abs() < 1e-8));
/// ```
pub fn regions_csv<L: Copy + Ord>(
    regions: &Regions<L>,
    columns: [&str; 2],
    name: &dyn Fn(L) -> RegionName,
) -> String {
    let [x, y] = columns.map(csv_cell);
    let mut out = format!("{x},{y},label_a,label_b,polyline\n");
    for (number, boundary) in regions.boundaries.iter().enumerate() {
        let [a, b] = boundary.pair.map(|label| csv_cell(&name(label).short));
        let first = boundary.points.first().filter(|_| boundary.closed);
        for [x, y] in boundary.points.iter().chain(first) {
            out += &format!("{x},{y},{a},{b},{number}\n");
        }
    }
    out
}

pub(crate) const REGIONS_CSS: &str = include_str!("regions.css");
