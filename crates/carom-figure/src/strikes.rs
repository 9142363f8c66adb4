//! The strikes: type, contacts before and after, impulse diagram, and what came of it.

use crate::after_strike;
use crate::impulse::ImpulsePlane;
use crate::impulse_drawing::drawing;
use crate::joint::JointWalk;
use crate::joint_drawing::joint_drawing;
use crate::stage_table::{Row, kind_of, rows};
use crate::text::{capitalised, escape, fixed, html_symbol, significant};
use crate::verdict::energy_lost;
use crate::words::{forward_sense, obstacle_ends, upward};
use carom_feeder::{Feeder, Run};
use carom_motion::planar::trace::{Impact, ImpactContact};
use carom_num::elementary::atan2;

/// Strikes described in full; those after them get a line each.
const MOST_IN_FULL: usize = 12;
/// Contacts with a plane of their own, where the stages of a strike were not kept.
const MOST_PLANES: usize = 3;
/// Lines for those after them.
const MOST_LINES: usize = 200;

/// The section with every strike: in full those that are rows of the stage table, in a line each those of a clatter.
pub(crate) fn section(feeder: &Feeder, run: &Run) -> String {
    let impacts = &run.trace.impacts;
    if impacts.is_empty() {
        return String::new();
    }
    let alone = |row: Row<'_>| if let Row::Strike(i, _) = row { Some(i) } else { None };
    let full: Vec<usize> = rows(run).into_iter().filter_map(alone).take(MOST_IN_FULL).collect();
    let mut out = String::from("<section id=\"strikes\"><h2>Strikes</h2>");
    for i in &full {
        out += &in_full(feeder, run, *i, &impacts[*i]);
    }
    let others: Vec<usize> = (0..impacts.len()).filter(|i| !full.contains(i)).collect();
    if !others.is_empty() {
        out += &in_lines(feeder, impacts, &others);
    }
    out + "</section>"
}

fn in_full(feeder: &Feeder, run: &Run, i: usize, impact: &Impact) -> String {
    let on = impact.contacts.first().map(|c| feeder.obstacle_label(c.obstacle)).unwrap_or_default();
    let class = impact.kind.map(|k| format!(" · {} (Wang and Mason)", k.class())).unwrap_or_default();
    let mut out = format!(
        "<article class=\"strike\"><h3><i class=\"key strike\"></i>Strike {} on “{}” <small>{} s</small></h3><p class=\"kind\">{}{}</p><p class=\"why\">{}</p><div class=\"{}\"><div>",
        i + 1,
        escape(&on),
        fixed(impact.time, 4),
        escape(&capitalised(&kind_of(impact))),
        escape(&class),
        escape(&after_strike::sentence(feeder, run, i)),
        if impact.contacts.len() > 1 { "many" } else { "pair" }
    );
    out += &body_table(feeder, impact);
    out += &notes(feeder, impact);
    out += "</div>";
    out += &walk(feeder, impact);
    out += "</div>";
    out += &contacts_table(feeder, impact);
    out + "</article>"
}

/// The walk in impulse space: one picture of all contacts, or the plane of the one that acts.
fn walk(feeder: &Feeder, impact: &Impact) -> String {
    let names: Vec<String> = impact.contacts.iter().map(|c| feeder.feature_name(c.feature)).collect();
    if impact.contacts.len() > 1 {
        let svg = joint_drawing(&JointWalk::of_impact(impact, &names), false);
        let ways =
            names.iter().enumerate().map(|(k, name)| format!("{name}{}", direction(feeder, impact, k)));
        let ways = escape(&ways.collect::<Vec<_>>().join(" · "));
        if !svg.is_empty() {
            return format!(
                "<figure class=\"wide\">{svg}<figcaption>The walk in impulse space of {ways}</figcaption></figure>"
            );
        }
    }
    let mut out = String::from("<div class=\"planes\">");
    for (k, name) in names.iter().enumerate().take(MOST_PLANES) {
        let Some(plane) = ImpulsePlane::of_contact(impact, k, &feeder.part.body) else { continue };
        let svg = drawing(&plane, false);
        if !svg.is_empty() {
            out += &format!(
                "<figure>{svg}<figcaption>Impulse plane at the {}{}</figcaption></figure>",
                escape(name),
                direction(feeder, impact, k)
            );
        }
    }
    out + "</div>"
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

fn row(label: &str, before: &str, after: &str) -> String {
    format!("<tr><th scope=\"row\">{label}</th><td>{before}</td><td>{after}</td></tr>")
}

fn body_table(feeder: &Feeder, impact: &Impact) -> String {
    let sense = forward_sense(feeder);
    let n = |x: f64| significant(x, 4);
    let (b, a) = (impact.before, impact.after);
    let mut out = String::from(
        "<table class=\"small\"><thead><tr><th></th><th>before</th><th>after</th></tr></thead><tbody>",
    );
    out += &row(
        &format!("{} <span class=\"u\">m/s</span>", html_symbol("v_x")),
        &n(b.velocity.x),
        &n(a.velocity.x),
    );
    out += &row(
        &format!("{} <span class=\"u\">m/s</span>", html_symbol("v_y")),
        &n(b.velocity.y),
        &n(a.velocity.y),
    );
    let spin = |w: f64| n(if w == 0.0 { 0.0 } else { sense * w });
    out += &row("spin, forward <span class=\"u\">1/s</span>", &spin(b.spin), &spin(a.spin));
    let lost = energy_lost(impact).map(|p| format!(" ({} %)", fixed(-p, 1))).unwrap_or_default();
    let millijoule = |e: f64| significant(1e3 * e, 4);
    out += &row(
        "energy <span class=\"u\">mJ</span>",
        &millijoule(impact.energy_before),
        &(millijoule(impact.energy_after) + &lost),
    );
    out += "</tbody></table>";
    out + &angles(feeder, impact)
}

/// The two angles that decide most: where the mass centre stands over the struck point, and how the point comes in.
fn angles(feeder: &Feeder, impact: &Impact) -> String {
    let Some(c) = impact.contacts.first() else { return String::new() };
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
    format!(
        "<p class=\"note\">The mass centre stands {}° {side} the normal at the struck point{against} ({} = {}°). The point comes in at {}° to the normal. Law: {}.</p>",
        fixed(lean.abs(), 1),
        html_symbol("φ_K"),
        fixed(lean, 1),
        fixed(incidence, 1),
        escape(&impact.law.to_string())
    )
}

fn notes(feeder: &Feeder, impact: &Impact) -> String {
    let mut out = String::new();
    if impact.without_approach {
        out +=
            "<p class=\"note\">No contact approached: friction forces this impact (Painlevé’s paradox).</p>";
    }
    if impact.branches > 1 {
        out += &format!(
            "<p class=\"note warn\">Up to {} ways on were consistent, and one was chosen.</p>",
            impact.branches
        );
    }
    if impact.open_share {
        out += "<p class=\"note warn\">The share of compression among the contacts is open: restitution multiplies the share that is taken, and others leave other motions.</p>";
    }
    if impact.gained_energy {
        out += "<p class=\"note warn\">The law created kinetic energy here, as Newton’s can where the slip stops or reverses.</p>";
    }
    if impact.restitution_scaled < 1.0 {
        out += &format!(
            "<p class=\"note\">The restitution coefficients were scaled by {} so that energy does not grow.</p>",
            significant(impact.restitution_scaled, 3)
        );
    }
    if impact.contacts.len() > 1 && impact.kind.is_none() {
        let names: Vec<String> = impact.contacts.iter().map(|c| feeder.feature_name(c.feature)).collect();
        out += &format!(
            "<p class=\"note\">Acting together: {}. The lines of sticking and of compression move while others act and are left out.</p>",
            escape(&names.join(", "))
        );
    }
    out
}

fn contacts_table(feeder: &Feeder, impact: &Impact) -> String {
    let mut out = String::from(
        "<div class=\"wide\"><table class=\"small\"><thead><tr><th>contact</th><th>afterwards</th><th>slip <span class=\"u\">m/s</span></th><th>normal velocity <span class=\"u\">m/s</span></th><th>impulse, normal <span class=\"u\">N s</span></th><th>tangential <span class=\"u\">N s</span></th><th>work, normal <span class=\"u\">mJ</span></th><th>tangential <span class=\"u\">mJ</span></th></tr></thead><tbody>",
    );
    for c in &impact.contacts {
        out += &contact_row(feeder, c);
    }
    out + "</tbody></table></div>"
}

fn contact_row(feeder: &Feeder, c: &ImpactContact) -> String {
    // Rounding residue beside the velocities of this contact is shown as zero.
    let scale = c.before.slip.abs().max(c.before.normal.abs()).max(c.after.slip.abs());
    let velocity = |x: f64| if x.abs() < 1e-9 * scale { "0".to_owned() } else { significant(x, 4) };
    let n = |x: f64| significant(x, 4);
    let most = c.normal_work.abs().max(c.tangential_work.abs());
    let work = |w: f64| if w.abs() < 1e-9 * most { "0".to_owned() } else { significant(1e3 * w, 4) };
    format!(
        "<tr><th scope=\"row\">{} on {}</th><td>{}</td><td>{} → {}</td><td>{} → {}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
        escape(&feeder.feature_name(c.feature)),
        escape(&feeder.obstacle_label(c.obstacle)),
        c.state,
        velocity(c.before.slip),
        velocity(c.after.slip),
        velocity(c.before.normal),
        velocity(c.after.normal),
        n(c.normal_impulse),
        n(c.tangential_impulse),
        work(c.normal_work),
        work(c.tangential_work)
    )
}

fn in_lines(feeder: &Feeder, impacts: &[Impact], which: &[usize]) -> String {
    let sense = forward_sense(feeder);
    let mut out = format!(
        "<details><summary>{} more strikes</summary><div class=\"wide\"><table class=\"small\"><thead><tr><th>#</th><th>on</th><th>at <span class=\"u\">s</span></th><th>spin <span class=\"u\">1/s</span></th><th>energy <span class=\"u\">mJ</span></th><th></th></tr></thead><tbody>",
        which.len()
    );
    for (i, impact) in which.iter().take(MOST_LINES).filter_map(|i| Some((i, impacts.get(*i)?))) {
        let on = impact.contacts.first().map(|c| feeder.obstacle_label(c.obstacle)).unwrap_or_default();
        out += &format!(
            "<tr><td>{}</td><th scope=\"row\">{}</th><td>{}</td><td>{} → {}</td><td>{} → {}</td><td class=\"words\">{}</td></tr>",
            i + 1,
            escape(&on),
            fixed(impact.time, 5),
            significant(sense * impact.before.spin, 3),
            significant(sense * impact.after.spin, 3),
            significant(1e3 * impact.energy_before, 3),
            significant(1e3 * impact.energy_after, 3),
            escape(&kind_of(impact))
        );
    }
    out += "</tbody></table></div>";
    if which.len() > MOST_LINES {
        out += &format!("<p class=\"note\">and {} after them.</p>", which.len() - MOST_LINES);
    }
    out + "</details>"
}
