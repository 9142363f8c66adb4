//! The page of a feed: which parts came out how, which touched, and all of them in motion.

use crate::draft::Draft;
use crate::markup::{Markup, html, table};
use crate::mechanism::{obstacles_svg, path_svg, view_of};
use crate::outline::outline_at_rest;
use crate::page::Page;
use crate::player::{MOST_SAMPLES, all_samples};
use crate::report::{Extra, REPORT_CSS};
use crate::text::{fixed, significant, trimmed};
use crate::view::View;
use crate::{FIGURE_CSS, player};
use carom_feeder::{Contact, FedPart, Feed, FeedRun, Feeder, Outcome, Run};
use carom_words::run;

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 620.0;
/// Paper around the scene, for the marks at its border.
const FRAME: f64 = 14.0;

/// One self-contained HTML page on a feed; as the report of a run, it needs no network.
pub fn feed_report(feeder: &Feeder, feed: &Feed, run: &FeedRun, title: &str, extra: &Extra) -> String {
    let motion = motion(feeder, run, &extra.draft);
    let script = motion.is_some().then_some(player::SCRIPT);
    let heading = format!("{title}, {} parts", feed.parts);
    let body = html! {
        (lead(feeder, feed, run))
        (parts(feeder, run))
        @if let Some(motion) = motion { (motion) }
    };
    Page {
        title: &heading,
        heading: &heading,
        styles: &[FIGURE_CSS, REPORT_CSS],
        body,
        script,
        made_by: &extra.made_by,
    }
    .html()
}

/// What came of it, in two sentences.
fn lead(feeder: &Feeder, feed: &Feed, run: &FeedRun) -> Markup {
    let mut words: Vec<(String, usize)> = vec![];
    for part in &run.parts {
        let word = run::headline(feeder, &part.run).word;
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
    html! {
        section id="verdict" {
            p.lead {
                "One part every " (trimmed(feed.interval, 6)) " s: " (counted.join(", ")) ". " (touch) (broken)
            }
        }
    }
}

/// The table of the parts, and that of their contacts.
fn parts(feeder: &Feeder, run: &FeedRun) -> Markup {
    let row = |(i, part): (usize, &FedPart)| {
        let headline = run::headline(feeder, &part.run);
        html! {
            tr {
                th scope="row" { (i + 1) }
                td { (fixed(part.entered, 4)) }
                td { (headline.word) }
                td { (headline.plate.as_deref().unwrap_or("–")) }
                td { (decided(&part.run, 0.0)) }
                td { (decided(&part.run, part.entered)) }
                td { (strikes_until_decided(&part.run)) }
            }
        }
    };
    let touch = |c: &Contact| {
        html! {
            tr {
                th scope="row" { (c.parts[0] + 1) " and " (c.parts[1] + 1) }
                td { (fixed(c.time, 4)) }
                td { (c.speed.map_or("no strike".to_owned(), |v| significant(v, 3))) }
            }
        }
    };
    let heads = ["part", "starts s", "verdict", "plate", "decided s", "after its start s", "strikes"];
    html! {
        section id="parts" {
            h2 { "Parts" }
            (table("", &heads, run.parts.iter().enumerate().map(row)))
            @if !run.contacts.is_empty() {
                h2 { "Parts that touch" }
                (table("", &["parts", "first at s", "speed m/s"], run.contacts.iter().map(touch)))
            }
        }
    }
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
fn motion(feeder: &Feeder, run: &FeedRun, draft: &Draft) -> Option<Markup> {
    let moving: Vec<&Run> = run
        .parts
        .iter()
        .map(|p| &p.run)
        .filter(|r| r.trace.pieces.iter().any(|p| p.end_time > p.start_time))
        .collect();
    // The player moves one part in full, with forces and stages; the others only show where they are.
    let (&first, others) = moving.split_first()?;
    let view = view_of(feeder, &moving, WIDTH, HEIGHT);
    let part = outline_at_rest(feeder, draft, &view);
    let body = |number: usize| {
        html! { (part.svg()) text.name text-anchor="middle" dy="0.35em" { (number) } }
    };
    let scene = html! {
        svg.fig.scene viewBox=(view.framed(FRAME)) role="img" aria-label="The parts on their way" {
            (obstacles_svg(feeder, &view))
            @for run in &moving { (path_svg(run, &view)) }
            g id="forces" {}
            g id="part" { (body(1)) }
            @for number in 2..others.len() + 2 {
                g.other id={ "part-" (number) } visibility="hidden" { (body(number)) }
            }
        }
    };
    Some(html! {
        section id="motion" {
            h2 { "Motion" }
            div id="player" class="player" tabindex="0" role="group" aria-label="Animation of the parts" {
                (scene)
                (player::controls(player::SPEED))
            }
            (player::numbers_element("motion-numbers", numbers(feeder, first, others, &view)))
        }
    })
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
