//! The page of a feed: which parts came out how, which touched, and all of them in motion.

use crate::draft::Draft;
use crate::mechanism::{obstacles_svg, path_svg, view_of};
use crate::outline::outline_at_rest;
use crate::page::Page;
use crate::player::{CONTROLS, MOST_SAMPLES, all_samples};
use crate::report::{Extra, REPORT_CSS};
use crate::text::{escape, fixed, px, significant, trimmed};
use crate::view::View;
use crate::{FIGURE_CSS, player};
use carom_feeder::{Feed, FeedRun, Feeder, Outcome, Run};

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 620.0;
/// Paper around the scene, for the marks at its border.
const FRAME: f64 = 14.0;

/// One self-contained HTML page on a feed; as the report of a run, it needs no network.
///
/// # Example
/// Two parts, one second apart, on a plate that is too rough for them: the second finds its place taken.
/// ```
/// # use {carom_feeder::{Feeder, Part, Plate, Start, Stop}, carom_impact::planar::Law, carom_num::Vec2};
/// # let (friction, restitution, unbounded) = (0.5, 0.0, false);
/// # let (uphill, edge) = (Vec2::new(-0.8, 0.6), Vec2::ZERO);
/// # let plates = vec![Plate { name: "upper".to_owned(), uphill, edge, friction, restitution, unbounded }];
/// # let start = Start { to_edge: 0.1, speed: 0.0, face: 0 };
/// # let (part, law, stop) = (Part::rod(0.1, 0.3, 2.5e-4).unwrap(), Law::Poisson, Stop::Landed);
/// # let feeder = Feeder { gravity: 10.0, stop, law, part, start, plates, walls: vec![] };
/// use {carom_feeder::Feed, carom_motion::planar::{Options, Surface}};
/// let mut rough = feeder.clone();
/// rough.plates[0].friction = 1.0;
/// let feed = Feed { parts: 2, interval: 1.0, between: Surface { friction: 0.2, restitution: 0.0 } };
/// let run = rough.prepare(Options::default()).unwrap().feed(&feed).unwrap();
/// let page = carom_figure::feed_report(&rough, &feed, &run, "rough", &carom_figure::Extra::default());
/// assert!(page.contains("<h1>rough, 2 parts</h1>") && page.contains("1 stuck, 1 blocked"));
/// ```
pub fn feed_report(feeder: &Feeder, feed: &Feed, run: &FeedRun, title: &str, extra: &Extra) -> String {
    let (table, motion) = (parts(feeder, run), motion(feeder, run, &extra.draft));
    let script = if motion.is_empty() { String::new() } else { player::script() };
    let heading = format!("{title}, {} parts", feed.parts);
    Page {
        title: &heading,
        heading: &heading,
        warnings: &extra.warnings,
        styles: &[FIGURE_CSS, REPORT_CSS],
        body: &[lead(feeder, feed, run), table, motion].concat(),
        script: &script,
        made_by: &extra.made_by,
    }
    .html()
}

/// What came of it, in two sentences.
fn lead(feeder: &Feeder, feed: &Feed, run: &FeedRun) -> String {
    let mut words: Vec<(String, usize)> = vec![];
    for part in &run.parts {
        let word = feeder.headline(&part.run).word;
        match words.iter_mut().find(|(known, _)| *known == word) {
            Some((_, count)) => *count += 1,
            None => words.push((word, 1)),
        }
    }
    let counted: Vec<String> = words.iter().map(|(word, count)| format!("{count} {word}")).collect();
    let broken = run.broken_off.as_ref().map(|why| format!(" Broken off: {why}.")).unwrap_or_default();
    let touch = match run.contacts.first() {
        None => "No two parts touch.".to_owned(),
        Some(c) => format!(
            "Parts {} and {} are the first to touch, at {} s.",
            c.parts[0] + 1,
            c.parts[1] + 1,
            fixed(c.time, 4)
        ),
    };
    format!(
        "<section id=\"verdict\"><p class=\"lead\">One part every {} s: {}. {touch}{}</p></section>",
        trimmed(feed.interval, 6),
        escape(&counted.join(", ")),
        escape(&broken)
    )
}

/// The table of the parts, and that of their contacts.
fn parts(feeder: &Feeder, run: &FeedRun) -> String {
    let mut out = String::from(
        "<section id=\"parts\"><h2>Parts</h2><div class=\"wide\"><table><thead><tr><th>part</th><th>starts s</th><th>verdict</th><th>plate</th><th>decided s</th><th>after its start s</th><th>strikes</th></tr></thead><tbody>",
    );
    for (i, part) in run.parts.iter().enumerate() {
        let headline = feeder.headline(&part.run);
        out += &format!(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            i + 1,
            fixed(part.entered, 4),
            escape(&headline.word),
            escape(headline.plate.as_deref().unwrap_or("–")),
            decided(&part.run, 0.0),
            decided(&part.run, part.entered),
            strikes_until_decided(&part.run)
        );
    }
    out += "</tbody></table></div>";
    if !run.contacts.is_empty() {
        out += "<h2>Parts that touch</h2><div class=\"wide\"><table><thead><tr><th>parts</th><th>first at s</th><th>speed m/s</th></tr></thead><tbody>";
        for c in &run.contacts {
            out += &format!(
                "<tr><th scope=\"row\">{} and {}</th><td>{}</td><td>{}</td></tr>",
                c.parts[0] + 1,
                c.parts[1] + 1,
                fixed(c.time, 4),
                c.speed.map_or("no strike".to_owned(), |v| significant(v, 3))
            );
        }
        out += "</tbody></table></div>";
    }
    out + "</section>"
}

/// What a part strikes after its verdict, while others are still on their way, is no part of what it is told of.
fn strikes_until_decided(run: &Run) -> usize {
    run.trace.impacts.iter().filter(|impact| impact.time <= run.end_time).count()
}

fn decided(run: &Run, since: f64) -> String {
    let never = matches!(run.outcome, Outcome::Blocked | Outcome::NeverFlat);
    if never { "–".to_owned() } else { fixed(run.end_time - since, 4) }
}

/// The animation of all parts; empty where none moved.
fn motion(feeder: &Feeder, run: &FeedRun, draft: &Draft) -> String {
    let moving: Vec<&Run> = run
        .parts
        .iter()
        .map(|p| &p.run)
        .filter(|r| r.trace.pieces.iter().any(|p| p.end_time > p.start_time))
        .collect();
    let Some((&first, others)) = moving.split_first() else { return String::new() };
    let view = view_of(feeder, &moving, WIDTH, HEIGHT);
    let part = outline_at_rest(feeder, draft, &view);
    let body = |number: usize| {
        format!("{}<text class=\"name\" text-anchor=\"middle\" dy=\"0.35em\">{number}</text>", part.svg())
    };
    let paths: String = moving.iter().map(|r| path_svg(r, &view)).collect();
    let groups: String = (0..others.len())
        .map(|i| {
            format!("<g class=\"other\" id=\"part-{}\" visibility=\"hidden\">{}</g>", i + 2, body(i + 2))
        })
        .collect();
    let mut out = String::from(
        "<section id=\"motion\"><h2>Motion</h2><div id=\"player\" class=\"player\" tabindex=\"0\" role=\"group\" aria-label=\"Animation of the parts\">",
    );
    out += &format!(
        "<svg class=\"fig scene\" viewBox=\"{} {0} {} {}\" role=\"img\" aria-label=\"The parts on their way\">{}{paths}<g id=\"forces\"></g><g id=\"part\">{}</g>{groups}</svg>{CONTROLS}</div>",
        px(-FRAME),
        px(view.width() + 2.0 * FRAME),
        px(view.height() + 2.0 * FRAME),
        obstacles_svg(feeder, &view),
        body(1),
    );
    out += &format!(
        "<script type=\"application/json\" id=\"motion-numbers\">{}</script>",
        numbers(feeder, first, others, &view)
    );
    out + "</section>"
}

fn numbers(feeder: &Feeder, first: &Run, others: &[&Run], view: &View) -> String {
    let weight = feeder.part.body.mass * feeder.gravity;
    let most = MOST_SAMPLES / (others.len() + 1);
    let samples = |run: &Run| format!("[{}]", all_samples(&run.trace.pieces, most, view, weight));
    let mut times: Vec<f64> = std::iter::once(first)
        .chain(others.iter().copied())
        .flat_map(|run| run.trace.impacts.iter().map(|i| i.time))
        .filter(|t| t.is_finite())
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times.truncate(1000);
    let others: Vec<String> = others.iter().map(|run| samples(run)).collect();
    let times: Vec<String> = times.iter().map(|t| format!("{t}")).collect();
    format!(
        "{{\"samples\":{},\"others\":[{}],\"stages\":[],\"strikes\":[{}]}}",
        samples(first),
        others.join(","),
        times.join(",")
    )
}
