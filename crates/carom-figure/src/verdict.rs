//! The verdict, in a feeder designer's words.

use crate::after_strike;
use crate::markup::{Markup, fact, html, joined, table};
use crate::report::Wish;
use crate::stage_table::{Row, rows};
use crate::text::{capitalised, fixed, significant};
use crate::tolerance::{ROUNDING, SERIES_LEAVES_OUT};

use carom_feeder::{Feeder, Landing, Outcome, Run, Verdict};
use carom_motion::planar::trace::{Impact, Trace};
use carom_words::{part, run};

/// Share of the kinetic energy that an impact takes, in percent.
pub(crate) fn energy_lost(impact: &Impact) -> Option<f64> {
    let share = 100.0 * (impact.energy_before - impact.energy_after) / impact.energy_before;
    share.is_finite().then_some(share)
}

/// The impacts between a landing's first touch and its lying flat.
fn impacts_of<'a>(trace: &'a Trace, landing: &Landing, until: f64) -> impl Iterator<Item = &'a Impact> {
    let (from, until, plate) = (landing.first_touch, landing.flat.unwrap_or(until), landing.plate);
    trace.impacts.iter().filter(move |i| {
        i.time >= from && i.time <= until && i.contacts.first().is_some_and(|c| c.obstacle == plate)
    })
}

/// Why it came out so: what the first strike on the last plate did; else what the outcome means.
fn lead(feeder: &Feeder, run: &Run) -> String {
    let decided = matches!(run.outcome, Outcome::Landed | Outcome::Delivered);
    let landing = run.landings.last().filter(|l| decided && l.turned_here.is_some());
    let first = landing.and_then(|l| run.trace.impacts.iter().position(|i| i.time >= l.first_touch));
    match first {
        Some(index) => after_strike::sentence(feeder, run, index),
        None => sentence(feeder, run),
    }
}

/// What the outcome means, in one sentence.
pub(crate) fn sentence(feeder: &Feeder, run: &Run) -> String {
    let name = |i: usize| part::obstacle(feeder, i);
    match run.outcome {
        Outcome::Landed => match run.landings.last() {
            Some(l) => format!("The part {} “{}”.", lies(l.verdict), name(l.plate)),
            None => "The part lies flat on the last plate.".into(),
        },
        Outcome::Delivered => match run.landings.last() {
            Some(l) => format!(
                "The part {} “{}” and left over its edge{}.",
                lies(l.verdict).replace("lies", "lay"),
                name(l.plate),
                run.exit
                    .map(|x| format!(" at {} m/s", significant(x.state.twist.velocity.norm(), 3)))
                    .unwrap_or_default()
            ),
            None => "The part left over the last plate’s edge.".into(),
        },
        Outcome::Stuck => stuck_sentence(feeder, run),
        Outcome::OnEnd => "The part came to rest standing on an end; it lies on no face.".into(),
        Outcome::Jammed => format!("The part jammed: {}.", run::headline(feeder, run).because),
        Outcome::Missed => match run.missed_by {
            Some(by) => format!(
                "The part fell past the last plate without touching it, {} mm from it at the nearest.",
                significant(1e3 * by, 3)
            ),
            None => "The part fell past the last plate without touching it.".into(),
        },
        Outcome::Escaped => "The part touched the last plate and left it before lying flat.".into(),
        Outcome::Unresolved => "More contacts met at once than could be resolved.".into(),
        Outcome::Blocked => "The part did not start: another part stood in its place.".into(),
        Outcome::NeverFlat if run::swings(run) => {
            let on = run.swings_on(feeder).map_or(String::new(), |face| format!(" on face {face}"));
            format!(
                "The part swings to and fro for ever{on}: it loses no energy on the way. Rolling resistance, which would stop it, is not in the model."
            )
        }
        Outcome::NeverFlat => {
            "The part was still moving and not yet flat when the budget of events or time ran out.".into()
        }
    }
}

fn lies(verdict: Option<Verdict>) -> String {
    match verdict {
        Some(Verdict::Same) => "lies on the same side as at the start on".into(),
        Some(Verdict::Turned) => "lies turned over on".into(),
        Some(Verdict::Face(face)) => format!("lies on its face {face} on"),
        None => "came down on".into(),
    }
}

/// Why a part at rest stays: the slope against the angle of friction.
fn stuck_sentence(feeder: &Feeder, run: &Run) -> String {
    let index = run.stages.last().and_then(|s| s.obstacle).unwrap_or(0);
    let Some(plate) = feeder.plates.get(index) else { return "Friction holds the part.".into() };
    if !plate.form.course.is_empty() {
        return format!("Friction and the bends hold the part on “{}”.", part::obstacle(feeder, index));
    }
    let slope = crate::senses::slope(plate.uphill, plate.edge).to_degrees();
    let friction = carom_num::elementary::atan(plate.friction).to_degrees();
    let start = (run.stages.len() <= 1).then(|| (feeder.start_state().pose.centre - plate.edge).norm());
    let place = start.map(|d| format!(" {} mm before the edge", fixed(1e3 * d, 0))).unwrap_or_default();
    if slope <= friction {
        format!(
            "Friction holds the part{place}: “{}” slopes by {}°, its angle of friction is {}°. A part starts only on a steeper plate.",
            part::obstacle(feeder, index),
            fixed(slope, 1),
            fixed(friction, 1)
        )
    } else {
        format!("Friction stopped the part{place} on “{}”.", part::obstacle(feeder, index))
    }
}

/// Whether it came out as wanted: a class for the colour, a sign and a sentence; red and a cross, green and a tick, none of them where nothing is wanted.
pub(crate) fn standing(wanted: &[Wish]) -> (&'static str, &'static str, Option<String>) {
    let missed: Vec<String> = wanted
        .iter()
        .filter(|wish| !wish.met)
        .map(|wish| format!("{} on “{}”", wish.want, wish.plate))
        .collect();
    match (wanted, missed.as_slice()) {
        ([], _) => ("open", "", None),
        (_, []) => ("wanted", "✓ ", Some("As wanted.".to_owned())),
        (_, missed) => ("unwanted", "✗ ", Some(format!("Not as wanted: {}.", missed.join(", ")))),
    }
}

/// The section that opens the report.
pub(crate) fn section(feeder: &Feeder, run: &Run, wanted: &[Wish]) -> Markup {
    let headline = run::headline(feeder, run);
    let (class, sign, says) = standing(wanted);
    html! {
        section class={ "verdict " (class) } {
            p.headline {
                strong { (sign) (capitalised(&headline.word)) } " "
                @if let Some(plate) = &headline.plate { "on “" (plate) "”" }
            }
            @if let Some(says) = says { p.as-wanted { (says) } }
            p.lead { (lead(feeder, run)) }
            p.note {
                "Computed for a rigid part in plane motion, as the groove guides it, with Coulomb friction: "
                a href="#model" { "what the model leaves out" } "."
            }
            dl.facts { (facts(feeder, run)) }
            @if !run.landings.is_empty() { (plates_table(feeder, run)) (energy_line(feeder, run)) }
        }
    }
}

/// The numbers that matter.
fn facts(feeder: &Feeder, run: &Run) -> Markup {
    let mut out = vec![];
    match run.final_landing().and_then(|l| l.flat) {
        Some(flat) => out.push(fact("flat after", &format!("{} s", fixed(flat, 3)), "from the start")),
        None => out.push(fact("ended after", &format!("{} s", fixed(run.end_time, 3)), "from the start")),
    }
    let first = run.deciding_strike();
    if let Some((impact, speed)) = first.and_then(|i| Some((i, speeds(i)?.0))) {
        out.push(fact("struck at", &format!("{} m/s", fixed(speed, 2)), &strike_words(feeder, run, impact)));
    }
    let hardest = run.trace.impacts.iter().filter(|i| speeds(i).is_some());
    // Of strikes that are equally hard the first is told: a reader looks for it from the start.
    let harder = |a: &&Impact, b: &&Impact| square(a).total_cmp(&square(b)).then(b.time.total_cmp(&a.time));
    if let Some(impact) =
        hardest.max_by(harder).filter(|i| first.is_none_or(|first| square(i) > square(first)))
    {
        let words = strike_words(feeder, run, impact);
        let speed = speeds(impact).map_or(0.0, |(speed, _)| speed);
        out.push(fact("hardest strike", &format!("{} m/s", fixed(speed, 2)), &words));
    }
    if let Some((impact, lost)) = first.and_then(|i| Some((i, energy_lost(i)?))) {
        let more = format!(
            "{} → {} mJ in strike {}",
            millijoule(impact.energy_before),
            millijoule(impact.energy_after),
            number_of(run, impact)
        );
        out.push(fact("kinetic energy", &format!("{} %", fixed(-lost, 0)), &more));
    }
    out.push(fact("margin", &significant(run.margin, 2), &run::decided(run.margin_of)));
    joined(out)
}

/// Speed of the struck point, and its share square to what it strikes [m/s].
fn speeds(impact: &Impact) -> Option<(f64, f64)> {
    let before = impact.contacts.first()?.before;
    let speed = (before.slip * before.slip + before.normal * before.normal).sqrt();
    speed.is_finite().then_some((speed, -before.normal))
}

fn square(impact: &Impact) -> f64 {
    speeds(impact).map_or(f64::NEG_INFINITY, |(_, square)| square)
}

/// The number of a strike, from 1.
fn number_of(run: &Run, impact: &Impact) -> usize {
    run.trace.impacts.iter().position(|other| core::ptr::eq(other, impact)).map_or(1, |i| i + 1)
}

/// Which strike it is, on what, and how fast it comes square to that.
fn strike_words(feeder: &Feeder, run: &Run, impact: &Impact) -> String {
    let on = impact.contacts.first().map(|c| part::obstacle(feeder, c.obstacle)).unwrap_or_default();
    format!(
        "strike {}, on “{on}”; {} m/s square to it",
        number_of(run, impact),
        significant(square(impact).max(0.0), 3)
    )
}

fn millijoule(energy: f64) -> String {
    significant(1e3 * energy, 3)
}

fn plates_table(feeder: &Feeder, run: &Run) -> Markup {
    let row = |l: &Landing| {
        let by_number = matches!(l.verdict, Some(Verdict::Face(_)));
        let here = match (l.turned_here, by_number) {
            (Some(true), false) => "turned over",
            (Some(false), false) => "not turned",
            (Some(true), true) => "another face",
            (Some(false), true) => "the same face",
            (None, _) => "–",
        };
        html! {
            tr {
                th scope="row" { (part::obstacle(feeder, l.plate)) }
                td { (l.verdict.map_or("–".into(), run::side)) }
                td { (here) }
                td { (fixed(l.first_touch, 4)) " s" }
                td { (l.flat.map_or("–".into(), |t| format!("{} s", fixed(t, 4)))) }
                td { (significant(l.impact_speed, 3)) " m/s" }
                td { (significant(l.max_sliding_speed, 3)) " m/s" }
                td { (impacts_of(&run.trace, l, run.end_time).count()) }
            }
        }
    };
    let heads =
        ["plate", "against the start", "here", "first touch", "flat", "struck at", "fastest slip", "strikes"];
    table("", &heads, run.landings.iter().map(row))
}

/// Where the energy of height went: impacts, friction, what is left.
fn energy_line(feeder: &Feeder, run: &Run) -> Markup {
    let (Some(first), Some(last)) = (run.stages.first(), run.stages.last()) else { return html! {} };
    let body = &feeder.part.body;
    let kinetic = |s: &carom_motion::planar::State| {
        0.5 * body.mass * s.twist.velocity.dot(s.twist.velocity)
            + 0.5 * body.inertia * s.twist.spin * s.twist.spin
    };
    let height = body.mass * feeder.gravity * (first.start.pose.centre.y - last.end.pose.centre.y);
    let impacts: f64 = run.trace.impacts.iter().map(|i| i.energy_before - i.energy_after).sum();
    let before = kinetic(&first.start);
    // The run may end with a strike or after it.
    let left = match rows(run).last() {
        Some(Row::Strike(_, impact)) => impact.energy_after,
        _ => kinetic(&last.end),
    };
    let friction = height + before - impacts - left;
    if ![height, impacts, left, friction].iter().all(|x| x.is_finite()) {
        return html! {};
    }
    // A difference of four energies: what is no more than their rounding is none, nor what the strikes took that a closed series leaves out.
    let unknown = if run.trace.accumulations.is_empty() { ROUNDING } else { SERIES_LEAVES_OUT };
    let slid = if friction.abs() < unknown * height.abs() { 0.0 } else { friction };
    html! {
        p.note {
            "Energy: the height gave " (millijoule(height)) " mJ"
            @if before > 0.0 { " on top of " (millijoule(before)) " mJ at the start" }
            "; strikes took " (millijoule(impacts)) " mJ, sliding friction " (millijoule(slid)) " mJ, and "
            (millijoule(left)) " mJ are left as motion."
        }
    }
}
