//! The strikes: type, contacts before and after, impulse diagram, and what came of it.

use crate::after_strike;
use crate::impulse::ImpulsePlane;
use crate::impulse_drawing::drawing;
use crate::joint::JointWalk;
use crate::joint_drawing::joint_drawing;
use crate::markup::{Markup, html, joined, table};
use crate::senses::{forward_sense, obstacle_ends, upward};
use crate::stage_table::{Row, kind_of, rows};
use crate::text::{capitalised, fixed, html_symbol, significant};
use crate::tolerance::ROUNDING;
use crate::verdict::energy_lost;
use carom_feeder::{Feeder, Run};
use carom_motion::planar::trace::{Impact, ImpactContact};
use carom_num::elementary::atan2;
use carom_words::{Words, part};

/// Strikes described in full; those after them get a line each.
const MOST_IN_FULL: usize = 12;
/// Contacts with a plane of their own, where the stages of a strike were not kept.
const MOST_PLANES: usize = 3;
/// Lines for those after them.
const MOST_LINES: usize = 200;

/// The section with every strike: in full those that are rows of the stage table, in a line each those of a clatter.
pub(crate) fn section(feeder: &Feeder, run: &Run) -> Markup {
    let impacts = &run.trace.impacts;
    if impacts.is_empty() {
        return html! {};
    }
    let alone = |row: Row<'_>| if let Row::Strike(i, _) = row { Some(i) } else { None };
    let full: Vec<usize> = rows(run).into_iter().filter_map(alone).take(MOST_IN_FULL).collect();
    let others: Vec<usize> = (0..impacts.len()).filter(|i| !full.contains(i)).collect();
    html! {
        section id="strikes" {
            h2 { "Strikes" }
            @for i in full { (in_full(feeder, run, i, &impacts[i])) }
            @if !others.is_empty() { (in_lines(feeder, impacts, &others)) }
        }
    }
}

/// One strike with all that is known of it.
pub(crate) fn in_full(feeder: &Feeder, run: &Run, i: usize, impact: &Impact) -> Markup {
    let on = impact.contacts.first().map(|c| part::obstacle(feeder, c.obstacle)).unwrap_or_default();
    let class = impact.kind.map(|k| format!(" · {} (Wang and Mason)", k.class().word())).unwrap_or_default();
    html! {
        article.strike {
            h3 { i.key.strike {} "Strike " (i + 1) " on “" (on) "” " small { (fixed(impact.time, 4)) " s" } }
            p.kind { (capitalised(&kind_of(impact))) (class) }
            p.why { (after_strike::sentence(feeder, run, i)) }
            div class=(if impact.contacts.len() > 1 { "many" } else { "pair" }) {
                div { (body_table(feeder, impact)) (angles(feeder, impact)) (notes(feeder, impact)) }
                (walk(feeder, impact))
            }
            (contacts_table(feeder, impact))
        }
    }
}

/// The walk in impulse space: one picture of all contacts, or the plane of the one that acts.
fn walk(feeder: &Feeder, impact: &Impact) -> Markup {
    let names: Vec<String> = impact.contacts.iter().map(|c| part::feature(feeder, c.feature)).collect();
    if impact.contacts.len() > 1
        && let Some(picture) = joint_drawing(&JointWalk::of_impact(impact, &names), false)
    {
        let ways =
            names.iter().enumerate().map(|(k, name)| format!("{name}{}", direction(feeder, impact, k)));
        let ways = ways.collect::<Vec<_>>().join(" · ");
        return html! { figure.wide { (picture) figcaption { "The walk in impulse space of " (ways) } } };
    }
    let planes = names.iter().enumerate().take(MOST_PLANES).filter_map(|(k, name)| {
        let picture = drawing(&ImpulsePlane::of_contact(impact, k, &feeder.part.body)?, false)?;
        let way = direction(feeder, impact, k);
        Some(html! { figure { (picture) figcaption { "Impulse plane at the " (name) (way) } } })
    });
    html! { div.planes { (joined(planes)) } }
}

/// Which way +t points.
fn direction(feeder: &Feeder, impact: &Impact, contact: usize) -> String {
    let Some(c) = impact.contacts.get(contact) else { return String::new() };
    let t = c.normal.turned_right();
    let way = match feeder.plates.get(c.obstacle) {
        Some(plate) if t.dot(plate.edge - plate.uphill) > 0.0 => "down the plate",
        Some(_) => "up the plate",
        None if t.y > 0.0 => "up the wall",
        None => "down the wall",
    };
    format!("; +t points {way}")
}

fn row(label: &str, unit: &str, before: &str, after: &str) -> Markup {
    let label = if label.contains('_') {
        html_symbol(label)
    } else {
        html! { (label) }
    };
    html! { tr { th scope="row" { (label) " " span.u { (unit) } } td { (before) } td { (after) } } }
}

fn body_table(feeder: &Feeder, impact: &Impact) -> Markup {
    let sense = forward_sense(feeder);
    let n = |x: f64| significant(x, 4);
    let (b, a) = (impact.before, impact.after);
    let spin = |w: f64| n(if w == 0.0 { 0.0 } else { sense * w });
    let lost = energy_lost(impact).map(|p| format!(" ({} %)", fixed(-p, 1))).unwrap_or_default();
    let millijoule = |e: f64| significant(1e3 * e, 4);
    let left = millijoule(impact.energy_after) + &lost;
    html! {
        table.small {
            thead { tr { td {} th { "before" } th { "after" } } }
            tbody {
                (row("v_x", "m/s", &n(b.velocity.x), &n(a.velocity.x)))
                (row("v_y", "m/s", &n(b.velocity.y), &n(a.velocity.y)))
                (row("spin, forward", "1/s", &spin(b.spin), &spin(a.spin)))
                (row("energy", "mJ", &millijoule(impact.energy_before), &left))
            }
        }
    }
}

/// The two angles that decide most: where the mass centre stands over the struck point, and how the point comes in.
fn angles(feeder: &Feeder, impact: &Impact) -> Markup {
    let Some(c) = impact.contacts.first() else { return html! {} };
    let arm = impact.pose.centre - c.point;
    let along = obstacle_ends(feeder, c.obstacle).and_then(|(a, b)| (b - a).unit()).unwrap_or_default();
    let lean = atan2(-arm.dot(along), arm.dot(c.normal)).to_degrees();
    let incidence = atan2(c.before.slip.abs(), -c.before.normal).to_degrees();
    let side = match feeder.plates.get(c.obstacle) {
        Some(_) if lean > 0.0 => "uphill of",
        Some(_) => "downhill of",
        None => "beside",
    };
    let against = if c.normal.dot(upward(along)) < 0.0 { " (from below)" } else { "" };
    html! {
        p.note {
            "The mass centre stands " (fixed(lean.abs(), 1)) "° " (side) " the normal at the struck point" (against)
            " (" (html_symbol("φ_K")) " = " (fixed(lean, 1)) "°). The point comes in at " (fixed(incidence, 1))
            "° to the normal. Law: " (impact.law.word().to_owned()) "."
        }
    }
}

fn notes(feeder: &Feeder, impact: &Impact) -> Markup {
    let together = impact.contacts.len() > 1 && impact.kind.is_none();
    let names = || impact.contacts.iter().map(|c| part::feature(feeder, c.feature)).collect::<Vec<_>>();
    html! {
        @if impact.without_approach {
            p.note { "No contact approached: friction forces this impact (Painlevé’s paradox)." }
        }
        @if impact.branches > 1 {
            p.note.warn { "Up to " (impact.branches) " ways on were consistent, and one was chosen." }
        }
        @if impact.open_share {
            p.note.warn {
                "The share of compression among the contacts is open: restitution multiplies the share that is taken, and others leave other motions."
            }
        }
        @if impact.gained_energy {
            p.note.warn {
                "The law created kinetic energy here, as Newton’s can where the slip stops or reverses."
            }
        }
        @if impact.restitution_scaled < 1.0 {
            p.note {
                "The restitution coefficients were scaled by " (significant(impact.restitution_scaled, 3))
                " so that energy does not grow."
            }
        }
        @if together {
            p.note {
                "Acting together: " (names().join(", "))
                ". The lines of sticking and of compression move while others act and are left out."
            }
        }
    }
}

fn contacts_table(feeder: &Feeder, impact: &Impact) -> Markup {
    let heads = [
        "contact",
        "afterwards",
        "slip [m/s]",
        "normal velocity [m/s]",
        "impulse, normal [N s]",
        "tangential [N s]",
        "work, normal [mJ]",
        "tangential [mJ]",
    ];
    table("small", &heads, impact.contacts.iter().map(|c| contact_row(feeder, c)))
}

fn contact_row(feeder: &Feeder, c: &ImpactContact) -> Markup {
    // Rounding residue beside the velocities of this contact is shown as zero.
    let scale = c.before.slip.abs().max(c.before.normal.abs()).max(c.after.slip.abs());
    let velocity = |x: f64| if x.abs() < ROUNDING * scale { "0".to_owned() } else { significant(x, 4) };
    let n = |x: f64| significant(x, 4);
    let most = c.normal_work.abs().max(c.tangential_work.abs());
    let work = |w: f64| if w.abs() < ROUNDING * most { "0".to_owned() } else { significant(1e3 * w, 4) };
    html! {
        tr {
            th scope="row" { (part::feature(feeder, c.feature)) " on " (part::obstacle(feeder, c.obstacle)) }
            td { (c.state.word()) }
            td { (velocity(c.before.slip)) " → " (velocity(c.after.slip)) }
            td { (velocity(c.before.normal)) " → " (velocity(c.after.normal)) }
            td { (n(c.normal_impulse)) }
            td { (n(c.tangential_impulse)) }
            td { (work(c.normal_work)) }
            td { (work(c.tangential_work)) }
        }
    }
}

fn in_lines(feeder: &Feeder, impacts: &[Impact], which: &[usize]) -> Markup {
    let sense = forward_sense(feeder);
    let line = |(i, impact): (usize, &Impact)| {
        let on = impact.contacts.first().map(|c| part::obstacle(feeder, c.obstacle)).unwrap_or_default();
        let spin = [impact.before.spin, impact.after.spin].map(|spin| significant(sense * spin, 3));
        let energy = [impact.energy_before, impact.energy_after].map(|e| significant(1e3 * e, 3));
        html! {
            tr {
                td { (i + 1) }
                th scope="row" { (on) }
                td { (fixed(impact.time, 5)) }
                td { (spin[0]) " → " (spin[1]) }
                td { (energy[0]) " → " (energy[1]) }
                td.words { (kind_of(impact)) }
            }
        }
    };
    let shown = which.iter().take(MOST_LINES).filter_map(|i| Some((*i, impacts.get(*i)?)));
    let heads = ["#", "on", "at [s]", "spin [1/s]", "energy [mJ]", ""];
    html! {
        details {
            summary { (which.len()) " more strikes" }
            (table("small", &heads, shown.map(line)))
            @if which.len() > MOST_LINES { p.note { "and " (which.len() - MOST_LINES) " after them." } }
        }
    }
}
