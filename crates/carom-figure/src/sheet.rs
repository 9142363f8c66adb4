//! The layout as a workshop's drawing: one to one, every measure, and where every plate begins and ends.

use crate::FIGURE_CSS;
use crate::draft::Draft;
use crate::labels::Labels;
use crate::layout::{Paper, ghost, millimetres, names_and_slopes};
use crate::markup::{Markup, PreEscaped, document, html, joined};
use crate::measures::{lengths, slope_text};
use crate::measures_svg::lengths_svg;
use crate::mechanism::{obstacles_svg, view_of};
use crate::text::{fixed, px};
use crate::view::View;
use carom_feeder::Feeder;
use carom_num::Vec2;
use carom_words::part;

/// The drawing without its frame is at most so large [px]; what a pixel is in millimetres follows from it.
const SHEET: (f64, f64) = (1500.0, 1200.0);
/// Lines of the table, and what a letter of it takes [px].
const LINE: f64 = 18.0;
const LETTER: f64 = 7.4;

/// The view of a workshop's drawing, as SVG and as DXF.
pub(crate) fn view_of_sheet(feeder: &Feeder) -> View {
    view_of(feeder, &[], SHEET.0, SHEET.1)
}

/// The layout one to one in millimetres, as SVG: printed without scaling it is as large as the feeder.
///
/// It has every measure that the draft writes as it is written; in parentheses what follows from them: lengths of plates, drops from hinge to
/// hinge, plumb drops, gaps to walls. A table below says where every plate begins and ends, in the scene's axes.
pub fn drawing_svg(feeder: &Feeder, draft: &Draft) -> String {
    let view = view_of_sheet(feeder);
    let paper = Paper::around(&view);
    let rows = table(feeder, draft);
    let widths = widths(&rows);
    let table_width = LETTER * widths.iter().map(|letters| letters + 3).sum::<usize>() as f64;
    let size = Vec2::new(
        paper.size().x.max(table_width + 2.0 * LINE),
        paper.size().y + LINE * (rows.len() + 4) as f64,
    );
    // Millimetres of a pixel.
    let unit = 1e3 / view.scale;
    let (width, height) = (px(size.x * unit), px(size.y * unit));
    let mut labels = Labels::within(paper.low, paper.high);
    // Lengths have their places before names, which have more to choose from.
    let inside = [
        obstacles_svg(feeder, &view),
        lengths_svg(&lengths(feeder, draft, true), &view, &mut labels),
        names_and_slopes(feeder, draft, &view, &mut labels),
        ghost(feeder, draft, feeder.start_state().pose, &view, "ghost stage"),
        table_svg(&rows, &widths, Vec2::new(0.0, paper.high.y + LINE)),
    ];
    let moved = format!("scale({unit}) translate({} {})", px(-paper.low.x), px(-paper.low.y));
    document(html! {
        svg xmlns="http://www.w3.org/2000/svg" class="fig drawing" width={ (width) "mm" } height={ (height) "mm" }
            viewBox=(format!("0 0 {width} {height}")) role="img" aria-label="The layout one to one" {
            style { (PreEscaped(FIGURE_CSS)) }
            rect.paper width=(width) height=(height) {}
            g transform=(moved) { (joined(inside)) }
        }
    })
}

fn place(p: Vec2) -> String {
    let coordinate = |x: f64| {
        let text = fixed(1e3 * x, 2);
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    };
    format!("({}, {})", coordinate(p.x), coordinate(p.y))
}

/// Where plates and walls begin and end.
fn table(feeder: &Feeder, draft: &Draft) -> Vec<[String; 5]> {
    let mut rows = vec![["", "slope", "length", "uphill end, mm", "free edge, mm"].map(str::to_owned)];
    for (i, plate) in feeder.plates.iter().enumerate() {
        let known = |text: String| if plate.unbounded { "as needed".to_owned() } else { text };
        rows.push([
            part::obstacle(feeder, i),
            slope_text(feeder, draft, i),
            known(millimetres(plate.length())),
            known(place(plate.uphill)),
            // Only the first plate's free edge is known where its length is not.
            if plate.unbounded && i > 0 { "as needed".to_owned() } else { place(plate.edge) },
        ]);
    }
    for (i, wall) in feeder.walls.iter().enumerate() {
        let ends = if wall.from.x == wall.to.x {
            // How far up and down a wall goes nobody has said where a channel has it.
            [format!("at x = {}", millimetres(wall.from.x)), String::new()]
        } else {
            [place(wall.from), place(wall.to)]
        };
        let [from, to] = ends;
        rows.push([part::obstacle(feeder, feeder.plates.len() + i), String::new(), String::new(), from, to]);
    }
    rows
}

fn widths(rows: &[[String; 5]]) -> [usize; 5] {
    let mut widths = [0; 5];
    for row in rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    widths
}

fn table_svg(rows: &[[String; 5]], widths: &[usize; 5], from: Vec2) -> Markup {
    let mut out: Vec<Markup> = vec![];
    for (line, row) in rows.iter().enumerate() {
        let mut x = from.x;
        for (cell, width) in row.iter().zip(widths) {
            let class = if line == 0 { "unit" } else { "name" };
            let y = from.y + LINE * line as f64;
            out.push(html! { text class=(class) x=(px(x)) y=(px(y)) { (cell) } });
            x += LETTER * (width + 3) as f64;
        }
    }
    out.push(html! {
        text.dim x=(px(from.x)) y=(px(from.y + LINE * rows.len() as f64)) {
            "One to one, in millimetres; the scene’s axes: x to the right, y up."
        }
        text.dim x=(px(from.x)) y=(px(from.y + LINE * (rows.len() + 1) as f64)) {
            "In parentheses: what follows from the rest."
        }
    });
    joined(out)
}
