//! The tables of a run in space: stages and strikes, each strike with its contacts, the faces of the part.

use crate::markup::{Markup, html, table};
use crate::space_rows::{SpaceRow, space_contacts, space_energy_change, space_rows, space_tilt};
use crate::stage_table::milliseconds;
use crate::text::{capitalised, fixed, significant};
use crate::tolerance::{NO_SPIN, SOLVED};
use carom_feeder::Stage;
use carom_feeder::spatial::{Face, Feeder, Prepared, Run};
use carom_impact::spatial::{Conclusion, Freedom};
use carom_motion::spatial::{Impact, Options, State, Touch};
use carom_num::Vec3;
use carom_words::part::Names;
use carom_words::{Words, part, roll_space, run as run_words};

/// Rows of stages and strikes.
const MOST_ROWS: usize = 400;
/// Strikes shown with their contacts.
const MOST_IN_FULL: usize = 12;
/// Contacts of one strike.
const MOST_CONTACTS: usize = 60;

/// Stages and strikes, in the columns of the terminal; a row moves the animation.
pub(crate) fn stages(feeder: &Feeder, run: &Run) -> Markup {
    let rows = space_rows(run);
    // A part that friction holds from the start has no stage.
    if rows.is_empty() {
        return html! { p.note { "Nothing moved: there are no stages and no strikes to show." } };
    }
    let row = |row: &SpaceRow<'_>| match *row {
        SpaceRow::Stage(i, stage) => stage_row(feeder, i, stage),
        SpaceRow::Strike(k, impact) => strike_row(feeder, run, k, impact),
    };
    let heads = [
        "#",
        "stage",
        "plate",
        "from [s]",
        "lasts [ms]",
        "speed [m/s]",
        "tilt [°]",
        "spin [1/s]",
        "ended by",
    ];
    html! {
        section id="stages" {
            h2 { "Stages" }
            (table("stages", &heads, rows.iter().take(MOST_ROWS).map(row)))
            @if rows.len() > MOST_ROWS { p.note { "and " (rows.len() - MOST_ROWS) " after them." } }
            p.note {
                "A row moves the animation to its start. Speed is that of the mass centre, at a strike that of the striking point just before. Tilt is the angle from level of the face that was down at the start. Spin is its size."
            }
        }
    }
}

fn change(a: f64, b: f64, of: impl Fn(f64) -> String) -> String {
    let (a, b) = (of(a), of(b));
    if a == b { a } else { format!("{a} → {b}") }
}

fn spin(spin: Vec3) -> f64 {
    let size = spin.norm();
    if size < NO_SPIN { 0.0 } else { size }
}

fn finite(time: f64) -> f64 {
    if time.is_finite() { time } else { 0.0 }
}

fn stage_row(feeder: &Feeder, i: usize, stage: &Stage<State, Touch>) -> Markup {
    let (start, end) = (&stage.start, &stage.end);
    let name = stage.name.word();
    let tilt = |state: &State| space_tilt(feeder, state).to_degrees();
    html! {
        tr.stage data-t=(finite(stage.start_time)) {
            td { (i + 1) }
            th scope="row" { i class={ "key " (name) } {} (name) }
            td { (stage.obstacle.map_or("–".to_owned(), |on| part::obstacle(feeder, on))) }
            td { (fixed(stage.start_time, 4)) }
            td { (milliseconds(stage.end_time - stage.start_time)) }
            td { (change(start.velocity.norm(), end.velocity.norm(), |speed| fixed(speed, 3))) }
            td { (change(tilt(start), tilt(end), |degrees| fixed(degrees, 1))) }
            td { (change(spin(start.spin), spin(end.spin), |size| fixed(size, 2))) }
            td.words { (run_words::stage_end(feeder, &stage.ended_by)) }
        }
    }
}

fn strike_row(feeder: &Feeder, run: &Run, k: usize, impact: &Impact) -> Markup {
    let on = run.struck.get(k).map_or("–".to_owned(), |on| part::obstacle(feeder, *on));
    html! {
        tr.stage.strike data-t=(finite(impact.time)) {
            td {}
            th scope="row" { i.key.strike {} a href=(anchor(k)) { "strike " (k + 1) } }
            td { (on) }
            td { (fixed(impact.time, 4)) }
            td {}
            td { (fixed(run.struck_at.get(k).map_or(f64::NAN, |speed| *speed), 3)) }
            td {}
            td { (change(spin(impact.spin_before), spin(impact.spin_after), |size| fixed(size, 2))) }
            td.words { (space_contacts(impact)) (energy(impact)) }
        }
    }
}

/// Where a strike is told: the section where it is not among the first.
fn anchor(k: usize) -> String {
    if k < MOST_IN_FULL { format!("#strike-{}", k + 1) } else { "#strikes".to_owned() }
}

fn energy(impact: &Impact) -> String {
    space_energy_change(impact).map_or(String::new(), |change| {
        let sign = if change > 0.0 { "+" } else { "" };
        format!(", {sign}{} % energy", fixed(change, 0))
    })
}

/// Every strike with its contacts and their impulses.
pub(crate) fn strikes(feeder: &Feeder, run: &Run) -> Markup {
    if run.impacts.is_empty() {
        return html! { section id="strikes" { h2 { "Strikes" } p.note { "Nothing was struck." } } };
    }
    let prepared = feeder.prepare(Options::default()).ok();
    let more = run.impacts.len().saturating_sub(MOST_IN_FULL);
    html! {
        section id="strikes" {
            h2 { "Strikes" }
            p.note {
                "Impulses on the part, in the axes of the world: x to the right, y up, z towards the viewer. A contact that strikes comes down in this strike; one that stands was held before it."
            }
            @for k in 0..run.impacts.len().min(MOST_IN_FULL) {
                (one(feeder, run, prepared.as_ref(), k))
            }
            @if more > 0 { p.note { "and " (more) " after them." } }
        }
    }
}

fn one(feeder: &Feeder, run: &Run, prepared: Option<&Prepared<'_>>, k: usize) -> Markup {
    let Some(impact) = run.impacts.get(k) else { return html! {} };
    let on = run.struck.get(k).map(|on| part::obstacle(feeder, *on)).unwrap_or_default();
    let three = |spin: Vec3| {
        let largest = spin.norm();
        let clear = |x: f64| if x.abs() <= SOLVED * largest { 0.0 } else { x };
        spin.to_array().map(|x| significant(clear(x), 4)).join(", ")
    };
    let millijoule = |energy: f64| significant(1e3 * energy, 4);
    html! {
        article.strike id={ "strike-" (k + 1) } {
            h3 { i.key.strike {} "Strike " (k + 1) " on “" (on) "” " small { (fixed(impact.time, 6)) " s" } }
            p.kind { (capitalised(&space_contacts(impact))) (energy(impact)) }
            p.note {
                "Spin (" (three(impact.spin_before)) ") → (" (three(impact.spin_after))
                ") 1/s; kinetic energy " (millijoule(impact.kinetic_before)) " → "
                (millijoule(impact.kinetic_after)) " mJ"
            }
            @if impact.conclusion == Conclusion::Several {
                p.note.warn { "Several outcomes are consistent: the one that keeps the most contacts is followed." }
            }
            @if impact.open == Freedom::Motion { p.note { (capitalised(roll_space::SHARED)) "." } }
            @if let Some(prepared) = prepared { (contacts(feeder, prepared, impact)) }
        }
    }
}

fn contacts(feeder: &Feeder, prepared: &Prepared<'_>, impact: &Impact) -> Markup {
    let world = prepared.world();
    let largest = impact.impulses.iter().map(|(_, impulse)| impulse.norm()).fold(0.0, f64::max);
    let number = |x: f64| {
        let x = if x.abs() <= SOLVED * largest { 0.0 } else { x };
        html! { td { (significant(1e3 * x, 4)) } }
    };
    // What comes down first is what the strike is about.
    let mut all: Vec<&(usize, Vec3)> = impact.impulses.iter().collect();
    all.sort_by_key(|(support, _)| !impact.striking.contains(*support));
    let row = |(support, impulse): &(usize, Vec3)| {
        let feature = world.touch(*support).unwrap_or(Touch::Point { point: 0, face: 0 });
        let state = match () {
            () if !impact.kept.contains(*support) => "separates",
            () if impact.sliding.contains(*support) => "slips",
            () => "sticks",
        };
        html! {
            tr {
                th scope="row" { (feeder.part_of(&feature)) }
                td { (part::obstacle(feeder, prepared.owner(*support))) }
                td { @if impact.striking.contains(*support) { "strikes" } @else { "stands" } }
                td { (state) }
                (number(impulse.x))
                (number(impulse.y))
                (number(impulse.z))
                (number(impulse.norm()))
            }
        }
    };
    let heads = [
        "of the part",
        "plate",
        "before",
        "afterwards",
        "impulse x [mN s]",
        "y [mN s]",
        "z [mN s]",
        "size [mN s]",
    ];
    html! {
        (table("small contacts", &heads, all.iter().take(MOST_CONTACTS).map(|contact| row(contact))))
        @if all.len() > MOST_CONTACTS { p.note { "and " (all.len() - MOST_CONTACTS) " more contacts." } }
    }
}

/// The faces by their numbers, and how the part stands on each.
pub(crate) fn faces(feeder: &Feeder, run: &Run, margins: &[f64]) -> Markup {
    let part = &feeder.part;
    // The verdict names a face by its number: which one that is must be found at a glance.
    let lay = |face: usize| {
        let started = (feeder.start.face == face).then(|| "at the start".to_owned());
        let landed = run.landings.iter().filter(|landing| landing.face == Some(face));
        let landed = landed.map(|landing| format!("on “{}”", part::obstacle(feeder, landing.plate)));
        started.into_iter().chain(landed).collect::<Vec<_>>().join(", ")
    };
    let length = |metres: f64| fixed(1e3 * metres, 3);
    let row = |(i, face): (usize, &Face)| {
        let margin = margins.get(i);
        let corners: Vec<String> = face.corners.iter().map(usize::to_string).collect();
        let rests = margin.map_or("–", |margin| if *margin > 0.0 { "yes" } else { "no" });
        html! {
            tr {
                th scope="row" { "face " (i) }
                td.words { (corners.join(" ")) }
                td { (length(face.depth)) }
                td { (margin.map_or("–".to_owned(), |margin| length(*margin))) }
                td { (rests) }
                td.words { (lay(i)) }
            }
        }
    };
    let heads =
        ["face", "corners", "mass centre over it [mm]", "inside it by [mm]", "can rest on it", "was down"];
    html! {
        section id="faces" {
            h2 { "Faces of the part" }
            (table("small faces", &heads, part.faces.iter().enumerate().map(row)))
            p.note {
                "The part can rest on a face, on level ground, where its mass centre is above the inside of the face. With “names” the animation shows the numbers; a face that is down is seen from below, with the view turned."
            }
        }
    }
}
