//! A drawing as PNG, for what shows no SVG.
//!
//! It stands here because it turns one of our drawings into another form of it, and behind a feature that is off by default because it brings a
//! renderer: some fifty crates and minutes of building, which whoever writes SVG and HTML alone does not need. The command has it on.
//!
//! Letters come from two faces that are part of the crate (`fonts/`), never from the machine: the same drawing gives the same bytes everywhere
//! the renderer's own arithmetic does. The renderer leaves out what its fonts lack without a word; so what they lack is replaced first.

use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb::Database};
use std::sync::Arc;
use thiserror::Error;

const REGULAR: &[u8] = include_bytes!("../fonts/DejaVuSans-subset.ttf");
const BOLD: &[u8] = include_bytes!("../fonts/DejaVuSans-Bold-subset.ttf");
const FAMILY: &str = "DejaVu Sans";
/// Largest side of a picture [px]: 1 GB of pixels.
const LARGEST: f64 = 16_384.0;
/// What stands for a character that the fonts lack.
const UNKNOWN: char = '\u{fffd}';

/// The characters that the fonts have, from the first to the last of each range.
const DRAWN: [[char; 2]; 37] = [
    [' ', '~'],
    ['\u{a0}', '\u{17f}'],
    ['\u{384}', '\u{38a}'],
    ['\u{38c}', '\u{38c}'],
    ['\u{38e}', '\u{3a1}'],
    ['\u{3a3}', '\u{3ce}'],
    ['ϑ', 'ϑ'],
    ['ϕ', 'ϕ'],
    ['\u{400}', '\u{45f}'],
    ['\u{200b}', '\u{200b}'],
    ['\u{2010}', '\u{2015}'],
    ['‘', '„'],
    ['†', '•'],
    ['…', '…'],
    ['‰', '‰'],
    ['′', '″'],
    ['⁰', '⁰'],
    ['⁴', '₎'],
    ['←', '↓'],
    ['∂', '∂'],
    ['∆', '∆'],
    ['∑', '∑'],
    ['−', '−'],
    ['∕', '∕'],
    ['∙', '∙'],
    ['√', '√'],
    ['∞', '∞'],
    ['∥', '∥'],
    ['≈', '≈'],
    ['≠', '≠'],
    ['≤', '≤'],
    ['≥', '≥'],
    ['⊥', '⊥'],
    ['⋅', '⋅'],
    ['\n', '\n'],
    ['\t', '\t'],
    [UNKNOWN, UNKNOWN],
];

/// Why there is no picture.
///
/// # Example
/// A thousand times as large as 30 by 20.
/// ```
/// use carom_figure::{PngError, png};
/// let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="30" height="20"/>"#;
/// assert_eq!(png(svg, 1e3), Err(PngError::Size { width: 30_000.0, height: 20_000.0 }));
/// ```
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum PngError {
    /// The text is no SVG that can be drawn.
    #[error("the drawing cannot be read: {0}")]
    Svg(String),
    /// It would have no pixels, or too many.
    #[error("{width} x {height} pixels: each side must be 1 to {LARGEST}")]
    Size {
        /// Pixels across.
        width: f64,
        /// Pixels up.
        height: f64,
    },
    /// The pixels could not be packed.
    #[error("the picture cannot be packed: {0}")]
    Packing(String),
}

/// A drawing of this crate as PNG, `scale` times as large as it says, on white and in the colours for paper.
///
/// # Limits
/// Letters are those of DejaVu Sans: Latin, Greek, Cyrillic and the signs that drawings use. Any other is drawn as �.
///
/// # Errors
/// [`PngError`].
///
/// # Example
/// ```
/// let svg = r#"<svg xmlns="http://www.w3.org/2000/svg" width="30" height="20"/>"#;
/// let picture = carom_figure::png(svg, 2.0).unwrap();
/// assert_eq!(&picture[1..4], b"PNG");
/// assert_eq!(picture[16..24], [0, 0, 0, 60, 0, 0, 0, 40], "60 by 40");
/// ```
pub fn png(svg: &str, scale: f64) -> Result<Vec<u8>, PngError> {
    let pixels = pixels(svg, scale)?;
    pixels.encode_png().map_err(|error| PngError::Packing(error.to_string()))
}

fn pixels(svg: &str, scale: f64) -> Result<Pixmap, PngError> {
    let mut fonts = Database::new();
    fonts.load_font_data(REGULAR.to_vec());
    fonts.load_font_data(BOLD.to_vec());
    let mut options =
        Options { font_family: FAMILY.to_owned(), fontdb: Arc::new(fonts), ..Options::default() };
    // Nothing is read: a drawing of ours names no other file.
    options.image_href_resolver.resolve_string = Box::new(|_, _| None);
    let tree = Tree::from_str(&drawable(svg), &options).map_err(|error| PngError::Svg(error.to_string()))?;
    let [width, height] =
        [tree.size().width(), tree.size().height()].map(|side| (f64::from(side) * scale).ceil());
    let fits = |side: f64| (1.0..=LARGEST).contains(&side);
    let sized = if fits(width) && fits(height) { Pixmap::new(width as u32, height as u32) } else { None };
    let Some(mut pixels) = sized else { return Err(PngError::Size { width, height }) };
    pixels.fill(Color::WHITE);
    resvg::render(&tree, Transform::from_scale(scale as f32, scale as f32), &mut pixels.as_mut());
    Ok(pixels)
}

/// The drawing with every character that the fonts lack replaced.
fn drawable(svg: &str) -> String {
    let has = |c: char| DRAWN.iter().any(|[first, last]| (*first..=*last).contains(&c));
    svg.chars().map(|c| if has(c) { c } else { UNKNOWN }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{RegionAxis, RegionDiagram, RegionName, regions_svg};
    use carom_study::regions::{Options as Finding, Range, find};

    fn dark(pixels: &Pixmap) -> usize {
        pixels.pixels().iter().filter(|pixel| u32::from(pixel.red()) + u32::from(pixel.green()) < 300).count()
    }

    fn written(text: &str) -> Pixmap {
        let svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"24\" height=\"28\"><text x=\"4\" y=\"20\" font-size=\"18\">{text}</text></svg>"
        );
        pixels(&svg, 1.0).unwrap()
    }

    #[test]
    fn every_character_that_is_promised_leaves_ink() {
        let invisible = |c: &char| c.is_whitespace() || ['\u{ad}', '\u{200b}'].contains(c);
        let all = DRAWN.iter().flat_map(|[first, last]| *first..=*last).filter(|c| !invisible(c));
        let mut count = 0;
        for c in all {
            let text = crate::markup::document(crate::markup::html! { (c.to_string()) });
            let ink = written(&text).pixels().iter().filter(|pixel| pixel.red() < 200).count();
            assert!(c.is_control() || ink > 0, "{c:?} ({:x}) leaves no ink", u32::from(c));
            count += 1;
        }
        assert!(count > 500, "{count}");
    }

    #[test]
    fn what_the_fonts_lack_is_not_left_out() {
        assert_eq!(drawable("<text>下µ−×</text>"), "<text>\u{fffd}µ−×</text>");
        assert!(dark(&written("下")) > 20, "something stands there");
        assert_eq!(written("下"), written("\u{fffd}"), "the sign for what is unknown");
    }

    fn diagram() -> String {
        let side = Range { from: -2.0, to: 2.0, count: 20 };
        let regions = find(side, side, &Finding::default(), |x, y| u8::from(x * x + y * y < 1.5)).unwrap();
        let axis = |name: &str, unit: &str| RegionAxis { name: name.to_owned(), unit: unit.to_owned() };
        regions_svg(&RegionDiagram {
            title: "Where α − β ≥ 2·10⁻³".to_owned(),
            subtitle: "friction 0.15".to_owned(),
            axes: [axis("angle γ", "°"), axis("inertia", "kg m^2")],
            regions: &regions,
            name: &|label| RegionName { short: label.to_string(), long: format!("outcome {label}") },
            curves_are: String::new(),
            curves: vec![],
            here: None,
        })
    }

    /// The drawing without its text elements, and where each of them begins, with its anchor.
    fn without_text(svg: &str) -> (String, Vec<([f64; 2], bool, String)>) {
        let (mut rest, mut left, mut places) = (svg, String::new(), vec![]);
        while let Some(at) = rest.find("<text") {
            let end = at + rest[at..].find("</text>").unwrap();
            let element = &rest[at..end];
            let number = |key: &str| {
                let value = element.split(&format!(" {key}=\"")).nth(1).unwrap().split('"').next().unwrap();
                value.parse::<f64>().unwrap()
            };
            let middle = element.contains("\"state") || element.contains("\"middle\"");
            let start = if element.contains("\"end\"") { number("x") - 4.0 } else { number("x") };
            places.push(([start, number("y")], middle, element.to_owned()));
            left += &rest[..at];
            rest = &rest[end + "</text>".len()..];
        }
        (left + rest, places)
    }

    #[test]
    fn a_diagram_has_its_colours_and_every_one_of_its_words() {
        let svg = diagram();
        let (bare, places) = without_text(&svg);
        let (drawn, bare) = (pixels(&svg, 2.0).unwrap(), pixels(&bare, 2.0).unwrap());
        assert_eq!((drawn.width(), drawn.height()), (1644, 1080), "822 by 540, twice");
        assert!(places.len() > 20, "{places:?}");
        for ([x, y], middle, element) in places {
            // A letter's room about where the text begins or has its middle.
            let from = if middle { x - 8.0 } else { x };
            let room = (0..22).flat_map(|j| {
                (0..28).map(move |i| (2.0 * from + f64::from(i), 2.0 * (y - 9.0) + f64::from(j)))
            });
            let at = |pixels: &Pixmap, (i, j): (f64, f64)| {
                pixels.pixel(i as u32, j as u32).map(|pixel| pixel.red())
            };
            let darker = room.filter(|place| at(&drawn, *place) < at(&bare, *place)).count();
            assert!(darker > 4, "{darker} pixels of {element}");
        }
        // The first region's fill, where nothing is written: the colours of paper, not those of the dark.
        let corner = drawn.pixel(2 * 70, 2 * 90).unwrap();
        assert_eq!([corner.red(), corner.green(), corner.blue()], [0xcf, 0xe0, 0xf3], "class r0");
        assert_eq!(Pixmap::decode_png(&png(&svg, 2.0).unwrap()).unwrap(), drawn, "packed and unpacked");
    }

    #[test]
    fn what_cannot_be_drawn_is_refused() {
        assert!(matches!(png("<svg", 1.0), Err(PngError::Svg(_))), "no SVG");
        let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"30\" height=\"20\"/>";
        for scale in [0.0, -1.0, f64::NAN, 1e6] {
            assert!(matches!(png(svg, scale), Err(PngError::Size { .. })), "{scale}");
        }
    }
}
