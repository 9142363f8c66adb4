//! Why a strike turned the part or did not: one sentence, from what the run did afterwards.

use crate::senses::forward_sense;
use crate::text::{fixed, signed, significant};
use crate::tolerance::{ROUNDING, UNSEEN};
use carom_feeder::{Feeder, Landing, Run, Verdict};
use carom_motion::planar::trace::Impact;
use carom_words::{Words, part, run};

/// What a strike did to the spin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Spin {
    Stays0,
    Stops,
    Starts,
    Keeps,
    Reverses,
}

/// A sentence or two on strike `index`: what it did to the spin and what came of it.
pub(crate) fn sentence(feeder: &Feeder, run: &Run, index: usize) -> String {
    let Some(impact) = run.trace.impacts.get(index) else { return String::new() };
    let (spin, words) = spin(feeder, impact);
    let mut out = match consequence(feeder, run, impact, spin) {
        Some(then) => format!("{words}: {then}."),
        None => format!("{words}."),
    };
    if let Some(force) = impact.holding_would_need.filter(|n| n.is_finite()) {
        out += &format!(
            " Holding the struck contact would need N = {} N, so the part lifts off at once{}.",
            significant(force, 3),
            following(feeder, run, impact)
        );
    }
    out
}

fn spin(feeder: &Feeder, impact: &Impact) -> (Spin, String) {
    let sense = forward_sense(feeder);
    let (before, after) = (sense * impact.before.spin, sense * impact.after.spin);
    // A spin that moves the part's rim slower than this share of its speed is none.
    let size = feeder.part.body.shape.size();
    let none = UNSEEN * (impact.before.velocity.norm() + size * before.abs()) / size;
    let per_second = |w: f64| signed(w, 3);
    match (before.abs() <= none, after.abs() <= none) {
        (true, true) => (Spin::Stays0, "The strike gives the part no spin".into()),
        (false, true) => (Spin::Stops, format!("The strike stops the spin of {} 1/s", per_second(before))),
        (true, false) => (Spin::Starts, format!("The strike starts a spin of {} 1/s", per_second(after))),
        (false, false) if before * after < 0.0 => (
            Spin::Reverses,
            format!("The strike reversed the spin from {} to {} 1/s", per_second(before), per_second(after)),
        ),
        (false, false) => {
            let verb = if after.abs() > before.abs() { "raised" } else { "slowed" };
            let change = format!("from {} to {} 1/s", per_second(before), per_second(after));
            (Spin::Keeps, format!("The strike {verb} the spin {change} and kept its sign"))
        }
    }
}

/// The landing that this strike leads to: on the struck plate, flat at or after the strike.
fn landing<'a>(run: &'a Run, impact: &Impact) -> Option<&'a Landing> {
    let plate = impact.contacts.first()?.obstacle;
    let near = ROUNDING * (1.0 + impact.time);
    run.landings.iter().find(|l| {
        l.plate == plate
            && l.first_touch <= impact.time + near
            && l.flat.is_some_and(|t| t >= impact.time - near)
    })
}

/// On which side a part comes to lie, against how it lay before: on the plate before, where there was one, or at the start.
fn side(feeder: &Feeder, run: &Run, landing: &Landing) -> Option<String> {
    let before = run.landings.iter().take_while(|l| l.plate != landing.plate).last();
    let plate = before.map(|l| part::obstacle(feeder, l.plate));
    // Only a rod or a box turns over: the faces of other parts have no opposite ones.
    let turns = !matches!(landing.verdict, Some(Verdict::Face(_)));
    match (landing.turned_here.filter(|turned| turns || !turned), landing.face, plate) {
        (Some(true), _, None) => Some("turned over".to_owned()),
        (Some(false), _, None) => Some("on the same side".to_owned()),
        (Some(true), _, Some(plate)) => Some(format!("turned over from how it lay on “{plate}”")),
        (Some(false), _, Some(plate)) => Some(format!("on the same side as on “{plate}”")),
        (None, Some(face), _) => Some(format!("on face {face}")),
        (None, None, _) => None,
    }
}

fn consequence(feeder: &Feeder, run: &Run, impact: &Impact, spin: Spin) -> Option<String> {
    let struck = impact.contacts.first()?.obstacle;
    let Some(landing) = landing(run, impact) else {
        let done = run.landings.iter().any(|l| l.plate == struck && l.flat.is_some_and(|t| t < impact.time));
        return (!done && struck < feeder.plates.len()).then(|| {
            format!(
                "the part does not lie flat on “{}” (the run: {})",
                part::obstacle(feeder, struck),
                run.outcome.word().replace('_', " ")
            )
        });
    };
    let flat = landing.flat?;
    let side = side(feeder, run, landing)?;
    if flat - impact.time <= ROUNDING * (1.0 + flat) {
        return Some(format!("the part lies flat, {side}"));
    }
    let first = impact.time <= landing.first_touch + ROUNDING * (1.0 + flat);
    let way = match (spin, landing.turned_here.filter(|_| first)) {
        (Spin::Keeps, None) => "the part turns on and lies down",
        (Spin::Reverses, None) => "the part swings back and lies down",
        (Spin::Keeps, Some(true)) => "the part turns on and lies down",
        (Spin::Keeps, _) => "the part turns on, but lies down",
        (Spin::Reverses, Some(false)) => "the part swings back and lies down",
        (Spin::Reverses, _) => "the part swings back, but lies down",
        _ => "the part lies down",
    };
    let between = run.trace.impacts.iter().filter(|i| i.time > impact.time && i.time < flat).count();
    let more = match between {
        0 => String::new(),
        1 => " and one more strike".to_owned(),
        n => format!(" and {n} more strikes"),
    };
    Some(format!("{way} {side}, {} ms{more} later", fixed(1e3 * (flat - impact.time), 1)))
}

/// The stage that begins with the strike, in words.
fn following(feeder: &Feeder, run: &Run, impact: &Impact) -> String {
    let near = ROUNDING * (1.0 + impact.time);
    let Some(stage) =
        run.stages.iter().find(|s| (s.start_time - impact.time).abs() <= near && s.end_time > s.start_time)
    else {
        return String::new();
    };
    let ended = run::stage_end(feeder, &stage.ended_by);
    format!(
        "; {} follows for {} ms ({ended})",
        stage.name.word(),
        fixed(1e3 * (stage.end_time - stage.start_time), 1)
    )
}
