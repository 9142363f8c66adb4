//! The page of many throws of a body: on which faces it comes to rest, how surely, and how else throws end.

use crate::bars::{Bar, bars, enlarged};
use crate::markup::{Markup, html, table};
use crate::page::{Page, law_and_input};
use crate::report::REPORT_CSS;
use crate::solid::SOLID_CSS;
use crate::text::{capitalised, fixed, percent, significant};
use crate::yield_page::YIELD_CSS;
use crate::{
    Draft, FIGURE_CSS, SolidDrawing, SolidFigure, SolidInstant, part_faces, part_picture, solid_scene,
};
use carom_feeder::Feeder;
use carom_study::yields::{Estimate, Spread};

/// A way in which throws end.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseEnd {
    /// face 2; or in words.
    pub name: String,
    /// The vertices of a face; empty of other ends.
    pub vertices: String,
    /// True of a face.
    pub is_face: bool,
    /// With what probability throws end so.
    pub probability: Estimate,
    /// Of the throws that come to rest on a face.
    pub of_resting: Option<Estimate>,
    /// How high the mass centre is over the face, and how far inside it \[m\].
    pub stance: Option<[f64; 2]>,
    /// The command that makes the first throw again that ends so; empty where none does.
    pub command: String,
}

/// What is thrown.
#[derive(Clone, Copy, Debug)]
pub enum PoseBody<'a> {
    /// A body in space, and where it comes to rest: a picture that can be turned.
    Solid(SolidDrawing<'a>, &'a [SolidInstant]),
    /// The part of a feeder, in the plane.
    Part(&'a Feeder, &'a Draft),
}

/// What the page of many throws shows.
#[derive(Clone, Copy, Debug)]
pub struct PoseFigure<'a> {
    /// Heading of the page.
    pub title: &'a str,
    /// What comes up most, in a few words.
    pub verdict: &'a str,
    /// The sentence below it.
    pub lead: &'a str,
    /// Sentences on the law and the model.
    pub notes: &'a [String],
    /// The file as written; empty where there is none.
    pub source: &'a str,
    /// What made the page, with its version.
    pub made_by: &'a str,
    /// What is thrown.
    pub body: PoseBody<'a>,
    /// Every way in which throws end.
    pub ends: &'a [PoseEnd],
    /// With what probability a throw comes to rest on a face.
    pub resting: Estimate,
    /// When \[s\].
    pub time: Option<&'a Spread>,
    /// After how many strikes.
    pub strikes: Option<&'a Spread>,
    /// Throws.
    pub throws: u64,
}

/// One self-contained HTML page on many throws of a body; it needs no network.
pub fn pose_report(figure: &PoseFigure<'_>) -> String {
    let (body, script) = match &figure.body {
        PoseBody::Solid(drawing, instants) => {
            (html! { (faces(figure)) (picture(figure, *drawing, instants)) }, Some(solid_scene::SCRIPT))
        }
        PoseBody::Part(feeder, draft) => (
            html! { (part_picture::figure(feeder, None, draft)) (part_faces::section(&feeder.part.body.shape)) },
            None,
        ),
    };
    let body = html! {
        (verdict(figure))
        (shares(figure))
        (body)
        (replays(figure))
        (law_and_input(figure.notes, figure.source))
    };
    Page {
        title: &format!("{}: poses", figure.title),
        heading: &format!("{}: how it comes to rest", figure.title),
        styles: &[FIGURE_CSS, REPORT_CSS, YIELD_CSS, SOLID_CSS],
        body,
        script,
        made_by: figure.made_by,
    }
    .html()
}

/// The body at rest, to be turned.
fn picture(figure: &PoseFigure<'_>, drawing: SolidDrawing<'_>, instants: &[SolidInstant]) -> Markup {
    let PoseFigure { title, verdict, lead, notes, source, made_by, .. } = *figure;
    let (around, stages, strikes, series) = (&[], &[], &[], &[]);
    solid_scene::section(&SolidFigure {
        title,
        verdict,
        lead,
        notes,
        drawing,
        around,
        instants,
        stages,
        strikes,
        series,
        source,
        made_by,
    })
}

fn verdict(figure: &PoseFigure<'_>) -> Markup {
    let Estimate { share, low, high, .. } = figure.resting;
    html! {
        section id="verdict" class="verdict" {
            p.headline { strong { (capitalised(figure.verdict)) } }
            p.lead { (capitalised(figure.lead)) }
            p.lead {
                "Of " (figure.throws) " throws " (percent(share)) " % come to rest on a face ("
                (percent(low)) " to " (percent(high)) " %, with 95 % confidence)."
                @if let Some(time) = figure.time {
                    " Half of those rest within " (significant(time.median, 3)) " s, 95 % within "
                    (significant(time.p95, 3)) " s."
                }
                @if let Some(strikes) = figure.strikes {
                    " They take " (fixed(strikes.median, 0)) " strikes in the median, 95 % at most "
                    (fixed(strikes.p95, 0)) "."
                }
            }
        }
    }
}

/// All ends as bars; faces once more, of the throws that come to rest.
fn shares(figure: &PoseFigure<'_>) -> Markup {
    let bar = |end: &PoseEnd, estimate: &Estimate| Bar {
        name: if end.vertices.is_empty() {
            end.name.clone()
        } else {
            format!("{}  ({})", end.name, end.vertices)
        },
        class: if end.is_face { "wanted" } else { "unwanted" },
        ..Bar::of(estimate, "throws")
    };
    let all: Vec<Bar> = figure.ends.iter().map(|end| bar(end, &end.probability)).collect();
    let widest = |of: &dyn Fn(&PoseEnd) -> Option<Estimate>| {
        figure.ends.iter().filter_map(of).map(|e| e.high).fold(f64::MIN_POSITIVE, f64::max)
    };
    let whole = widest(&|end| Some(end.probability));
    let resting: Vec<Bar> =
        figure.ends.iter().filter_map(|end| Some(bar(end, end.of_resting.as_ref()?))).collect();
    // Where all throws come to rest the second picture would be the first.
    let differs = !resting.is_empty() && figure.resting.count < figure.throws;
    html! {
        section id="ends" {
            h2 { "How throws end" }
            (bars(&all, whole))
            p.note {
                "Bars: the share of the throws, of " (significant(100.0 * whole, 3))
                " % for the whole width. Brackets: the 95 % interval. Every throw is counted once."
            }
            @if differs {
                (enlarged("Of those that come to rest on a face", &resting, widest(&|end| end.of_resting), 3))
            }
        }
    }
}

/// Faces with how the body stands on them.
fn faces(figure: &PoseFigure<'_>) -> Markup {
    let row = |end: &PoseEnd| {
        let [height, margin] = end.stance?.map(|length| fixed(1e3 * length, 3));
        Some(html! {
            tr {
                th scope="row" { (end.name) }
                td { (end.vertices) }
                td { (height) }
                td { (margin) }
                td { (percent(end.probability.share)) " %" }
            }
        })
    };
    let rows: Vec<Markup> = figure.ends.iter().filter_map(row).collect();
    let heads = ["face", "vertices", "mass centre over it, mm", "inside it by, mm", "of all throws"];
    html! {
        @if !rows.is_empty() { section id="faces" { h2 { "Faces to rest on" } (table("", &heads, rows)) } }
    }
}

/// How the first throw of each end is made again.
fn replays(figure: &PoseFigure<'_>) -> Markup {
    if figure.ends.iter().all(|end| end.command.is_empty()) {
        return html! {};
    }
    html! {
        section id="replays" {
            h2 { "Throws to look at" }
            p.note { "The first throw of each end, to be made again." }
            div.cases {
                @for end in figure.ends.iter().filter(|end| !end.command.is_empty()) {
                    article { h3 { (capitalised(&end.name)) } pre { (end.command) } }
                }
            }
        }
    }
}
