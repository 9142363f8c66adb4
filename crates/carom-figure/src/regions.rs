//! A region diagram as SVG: regions in colours with their names inside, the boundaries that were found, closed-form curves over them.

use crate::FIGURE_CSS;
use crate::csv::csv_cell;
use crate::labels::Labels;
use crate::markup::{Markup, document, html, joined};
use crate::regions_legend::{Entry, cross, legend, wrapped};
use crate::svg::{self, line, text};
use crate::text::{fixed, px, significant};
use crate::ticks::ticks;
use crate::tolerance::NO_REGION;
use carom_num::Vec2;
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
/// Letters of a line under the title, and lines there.
const SUBTITLE: usize = 130;
const SUBTITLES: usize = 2;
/// Connected regions that get a name at most.
const MOST_NAMES: usize = 40;

/// An axis of a diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionAxis {
    /// What it measures, as it is written beside it: `friction f`.
    pub name: String,
    /// Its unit; empty for plain numbers.
    pub unit: String,
}

/// How a label is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RegionName {
    /// Inside its region: a number or a few letters.
    pub short: String,
    /// In the legend.
    pub long: String,
}

/// A curve that is drawn over the boundaries.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionCurve {
    /// What it is called.
    pub name: String,
    /// Its pieces, in units of the axes.
    pub pieces: Vec<Vec<[f64; 2]>>,
}

/// A diagram to draw.
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
    fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (u, v) = (self.regions.x.share(x), self.regions.y.share(y));
        [LEFT + u * WIDTH, TOP + (1.0 - v) * HEIGHT]
    }

    fn path(&self, points: &[[f64; 2]], closed: bool) -> String {
        let mut path = String::new();
        points.iter().for_each(|point| svg::to(&mut path, self.at(*point)));
        if closed { path + "Z" } else { path }
    }

    /// The class of a label's fill.
    fn fill(&self, label: L) -> usize {
        let seen = self.regions.shares.iter().filter(|share| share.area > NO_REGION);
        seen.take_while(|share| share.label != label).count() % FILLS
    }

    fn patches(&self) -> Markup {
        joined(self.regions.shares.iter().map(|share| {
            let patches = self.regions.patches.iter().filter(|patch| patch.label == share.label);
            let path: String = patches.map(|patch| self.path(&patch.outline, true)).collect();
            svg::path(&format!("region r{}", self.fill(share.label)), &path)
        }))
    }

    /// True where a label takes room that can be seen.
    fn is_seen(&self, label: L) -> bool {
        self.regions.shares.iter().any(|share| share.label == label && share.area > NO_REGION)
    }

    /// Junctions between regions that are seen.
    fn junctions(&self) -> impl Iterator<Item = &Junction<L>> {
        self.regions
            .junctions
            .iter()
            .filter(|junction| junction.labels.iter().all(|label| self.is_seen(*label)))
    }

    fn boundaries(&self) -> Markup {
        let lines = self.regions.boundaries.iter();
        let paths: String = lines.map(|line| self.path(&line.points, line.closed)).collect();
        let pieces = |curve: &RegionCurve| -> String {
            curve.pieces.iter().map(|piece| self.path(piece, false)).collect()
        };
        html! {
            (svg::path("boundary", &paths))
            @for curve in &self.curves { path.closed-form d=(pieces(curve)) { title { (curve.name) } } }
            @for junction in self.junctions() { (svg::circle("junction", self.at(junction.at), 3.6)) }
            @if let Some((at, _)) = self.here_within() { (cross(self.at(at))) }
        }
    }

    /// What is marked, where it lies in the plane.
    fn here_within(&self) -> Option<([f64; 2], &str)> {
        let (at, words) = self.here.as_ref()?;
        let shares = [self.regions.x.share(at[0]), self.regions.y.share(at[1])];
        shares.iter().all(|share| (0.0..=1.0).contains(share)).then_some((*at, words.as_str()))
    }

    /// At which resolution regions were looked for: the legend must not claim more.
    fn looked_for(&self) -> String {
        let [x, y] = [self.regions.x.count, self.regions.y.count];
        format!(
            "Looked for on {x} × {y} cells, finer where borders meet. A region narrower than a cell may be missed, here and where others meet."
        )
    }

    /// Half the room around a place [px], across and up.
    fn room(&self, place: &Place<L>) -> (f64, f64) {
        let cells = place.clearance as f64 + 0.5;
        let [columns, rows] = [self.regions.x.count, self.regions.y.count].map(|count| count as f64);
        (cells / columns * WIDTH, cells / rows * HEIGHT)
    }

    fn names(&self) -> Markup {
        let mut out: Vec<Markup> = vec![];
        // Slivers beside each other have places that touch, and one at the border has a name half outside.
        let mut free = Labels::within(Vec2::new(LEFT, TOP), Vec2::new(LEFT + WIDTH, TOP + HEIGHT));
        for place in self.regions.places.iter().take(MOST_NAMES) {
            let (room, up) = self.room(place);
            let RegionName { short, long } = (self.name)(place.label);
            let half = |text: &str, letter: f64| 0.5 * letter * text.chars().count() as f64;
            let [x, y] = self.at(place.at);
            let text = |class: &str, y: f64, text: &str| {
                html! { text class=(class) x=(px(x)) y=(px(y)) { (text) } }
            };
            let two_lines = long != short && half(&long, 6.2) < room && up > 18.0;
            // A name that hides its region's border says less than none: the legend has it.
            if half(&short, 7.5) > room + 5.0 || up < 5.0 {
                continue;
            }
            let taken = Vec2::new(2.0 * half(&short, 10.0), if two_lines { 34.0 } else { 16.0 });
            if !free.take(Vec2::new(x, y), taken) {
                continue;
            }
            let base = if two_lines { y - 1.0 } else { y + 5.0 };
            out.push(text("state", base, &short));
            if two_lines {
                out.push(text("state-words", base + 14.0, &long));
            }
        }
        joined(out)
    }

    fn axis_lines(&self) -> Markup {
        let (right, floor) = (LEFT + WIDTH, TOP + HEIGHT);
        let mut out: Vec<Markup> = vec![];
        let across = ticks(self.regions.x.from, self.regions.x.to, 7);
        for v in &across.at {
            let [x, _] = self.at([*v, self.regions.y.from]);
            out.push(line("axis", [x, floor], [x, floor + 4.0]));
            out.push(text("", [x, floor + 17.0], "middle", &tick(*v, across.decimals)));
        }
        let up = ticks(self.regions.y.from, self.regions.y.to, 7);
        for v in &up.at {
            let [_, y] = self.at([self.regions.x.from, *v]);
            out.push(line("axis", [LEFT - 4.0, y], [LEFT, y]));
            out.push(text("", [LEFT - 7.0, y + 3.8], "end", &tick(*v, up.decimals)));
        }
        out.push(svg::rect("axis", [LEFT, TOP], [WIDTH, HEIGHT]));
        let [x, y] = &self.axes;
        out.push(text("name", [right, floor + 36.0], "end", &with_unit(x)));
        out.push(text("name", [8.0, TOP - 10.0], "start", &with_unit(y)));
        joined(out)
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
    let (size, drawn) = region_drawing(diagram);
    document(svg::drawing(
        "fig",
        size,
        &diagram.title,
        html! { (svg::styled(size, &[FIGURE_CSS, REGIONS_CSS])) (drawn) },
    ))
}

/// The same for a page that has the style of figures already. The plane is the only `rect` of the class `axis`.
pub fn live_regions<L: Copy + Ord>(diagram: &RegionDiagram<'_, L>) -> String {
    let (size, drawn) = region_drawing(diagram);
    svg::drawing("fig regions", size, &diagram.title, drawn).into_string()
}

/// The size of the drawing, and what is in it.
fn region_drawing<L: Copy + Ord>(diagram: &RegionDiagram<'_, L>) -> ([f64; 2], Markup) {
    let entry = |share: &carom_study::regions::Share<L>| Entry {
        fill: diagram.fill(share.label),
        name: (diagram.name)(share.label),
        area: share.area,
    };
    let entries: Vec<Entry> =
        diagram.regions.shares.iter().filter(|share| share.area > NO_REGION).map(entry).collect();
    let drawn = diagram.curves.iter().filter(|curve| !curve.pieces.is_empty());
    let curves: Vec<&str> = drawn.map(|curve| curve.name.as_str()).collect();
    let marks = (diagram.junctions().next().is_some(), diagram.here_within().map(|(_, words)| words));
    let looked_for = diagram.looked_for();
    let (key, bottom) = legend(&entries, (&diagram.curves_are, &curves), marks, (&looked_for, TOP));
    let width = LEGEND + LEGEND_WIDTH;
    let height = (TOP + HEIGHT + BOTTOM).max(bottom + 12.0);
    let size = [width, height];
    let mut out = vec![text("title", [8.0, 20.0], "start", &diagram.title)];
    let lines = wrapped(&diagram.subtitle, SUBTITLE);
    for (k, part) in lines.iter().take(SUBTITLES).enumerate() {
        let more = if k + 1 == SUBTITLES && lines.len() > SUBTITLES { " …" } else { "" };
        out.push(text("small", [8.0, 36.0 + 14.0 * k as f64], "start", &format!("{part}{more}")));
    }
    out.extend([diagram.patches(), diagram.boundaries(), diagram.axis_lines(), diagram.names(), key]);
    (size, joined(out))
}

/// The boundaries as CSV: x and y under these names, the two labels, and the number of the polyline.
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
