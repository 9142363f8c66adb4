//! What an inverse design says, and the files of its winner.

mod said;

use super::{Designed, Winner};
use crate::args::Output;
use crate::failure::Failure;
use crate::files;
use crate::pipeline;
use crate::progress::spent;
use crate::side_by_side::aligned;
use crate::table::fixed;
use crate::yields;
use carom_scene::{
    DeliveredReport, DesignLayoutReport, DesignReport, EndingWord, ForbiddenReport, Word, labelled,
};
use carom_study::Ending;
use carom_study::design::{Demand, Forbidden, Judged};
use carom_study::yields::Estimate;
use carom_words::{Words, part, study};
use std::fmt::Write as _;
use std::io::Write;
use std::path::PathBuf;

pub(super) fn deliver(
    designed: &Designed<'_>,
    output: &Output,
    json: bool,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let folder = output.folder(designed.scene.name()).join("design");
    let summary = format!("{}\n", serde_json::to_string_pretty(&summary(designed))?);
    let mut written = vec![];
    if let Some(winner) = &designed.winner {
        files::bring_outline(designed.scene, &folder)?;
        written.push(files::write(&folder, "design.toml", &winner.text)?);
        for (name, drawing) in pipeline::drawings(&winner.scene) {
            written.push(files::write(&folder, name, &drawing)?);
        }
        written.push(files::write(
            &folder,
            "report.html",
            &pipeline::design_page(&winner.scene, &winner.run, said::sentences(designed, winner)),
        )?);
    }
    written.push(files::write(&folder, "design.json", &summary)?);
    if designed.winner.is_none() {
        files::remove(&folder, &["design.toml", "drawing.dxf", "drawing.svg", "report.html"])?;
    }
    if json {
        out.write_all(summary.as_bytes())?;
    } else {
        out.write_all(text(designed, &written).as_bytes())?;
    }
    Ok(())
}

fn unit(demand: Demand) -> &'static str {
    match demand {
        Demand::Drawable | Demand::Clear | Demand::Wanted | Demand::Walls | Demand::ComesOut => "",
        Demand::ImpactSpeed | Demand::SlidingSpeed => "m/s",
        Demand::Height | Demand::Width => "m",
        Demand::Time => "s",
    }
}

/// `98.53 % (98.31 to 98.75)`
fn percent(estimate: &Estimate) -> String {
    let [share, interval] = yields::percent(estimate);
    format!("{share} % ({interval})")
}

/// How the part comes to lie on every plate but the one it starts on.
fn endings(winner: &Winner) -> Vec<DeliveredReport> {
    let plates = winner.scene.feeder().plates.iter().enumerate().skip(1);
    let ending = |i| EndingWord(Ending::of(&winner.run, i));
    plates.map(|(i, plate)| DeliveredReport { plate: plate.name.clone(), ending: ending(i) }).collect()
}

/// The same in words.
fn delivered(winner: &Winner) -> Vec<String> {
    let feeder = winner.scene.feeder();
    let end =
        |i| format!("{} on \"{}\"", study::ending(Ending::of(&winner.run, i)), part::obstacle(feeder, i));
    (1..feeder.plates.len()).map(end).collect()
}

/// Pose and speed in which the part leaves the last plate.
fn afterwards(winner: &Winner) -> String {
    let feeder = winner.scene.feeder();
    let last = part::obstacle(feeder, feeder.plates.len() - 1);
    let Some(exit) = &winner.to_the_end.exit else {
        let word = winner.to_the_end.outcome.word().replace('_', " ");
        return format!("it does not leave \"{last}\": {word} after {:.3} s", winner.to_the_end.end_time);
    };
    let (velocity, state) = (exit.state.twist.velocity, &exit.state);
    let below = carom_num::elementary::atan2(-velocity.y, velocity.x.abs()).to_degrees();
    format!(
        "leaves \"{last}\" after {:.3} s at {:.3} m/s, {below:.1}° below the horizontal, its drawing turned by {:.1}°, turning at {:.3} 1/s",
        exit.time,
        velocity.norm(),
        state.pose.angle.to_degrees(),
        state.twist.spin
    )
}

/// For a person.
fn text(designed: &Designed<'_>, files: &[PathBuf]) -> String {
    let mut text = match &designed.winner {
        Some(winner) => found(designed, winner),
        None => not_possible(designed),
    };
    // Writing to a String cannot fail.
    let found = &designed.found;
    let _ = writeln!(
        text,
        "\n{} of {} layouts of the first look meet every demand where nothing varies",
        found.met, found.scanned
    );
    text += &forbidden(designed);
    text += &front(designed);
    let _ = writeln!(text, "\n{} drops, seed {}, {:.2} s\n", designed.drops, designed.seed, designed.seconds);
    for file in files {
        let _ = writeln!(text, "{}", file.display());
    }
    text
}

fn found(designed: &Designed<'_>, winner: &Winner) -> String {
    let judged = &winner.judged;
    let mut text = format!(
        "{}: {} end as wanted, within the limits; {} with every tolerance doubled\n",
        designed.scene.name(),
        percent(&winner.yields),
        percent(&winner.doubled)
    );
    let _ = writeln!(text, "{}", delivered(winner).join(", "));
    let _ = writeln!(text, "{}\n", afterwards(winner));
    let mut rows = vec![];
    for (quantity, value) in designed.space.quantities().zip(&winner.values) {
        rows.push(vec![
            labelled(&quantity.path).into_owned(),
            quantity.kind.dimension.show_digits(*value, 6),
        ]);
    }
    text += &aligned(&rows);
    let within = |limit: Option<f64>| limit.map_or(String::new(), |limit| format!(" (at most {limit})"));
    let limits = &designed.limits;
    let _ = writeln!(
        text,
        "\nwhere nothing varies its striking point is {:.3} m/s fast at most, it slides at {:.3} m/s at most, and it lies flat on the last plate after {:.3} s; {:.4} m high{}, {:.4} m wide{}",
        judged.impact_speed,
        judged.sliding_speed,
        judged.time,
        judged.height,
        within(limits.height),
        judged.width,
        within(limits.width),
    );
    for sentence in said::sentences(designed, winner) {
        let _ = writeln!(text, "{sentence}");
    }
    text
}

fn not_possible(designed: &Designed<'_>) -> String {
    let mut text = format!("{}: NOT POSSIBLE", designed.scene.name());
    let failed = |demand: Demand| {
        designed.found.forbidden.iter().filter(|f| f.demand == demand).map(|f| f.failed).sum::<u64>()
    };
    let (undrawable, unwanted) = (failed(Demand::Drawable), failed(Demand::Wanted));
    // What cannot be drawn says nothing about what can, unless nothing can; nor what ends otherwise, where some end as wanted.
    let decides = |f: &&Forbidden| match f.demand {
        Demand::Drawable => undrawable == designed.found.scanned,
        Demand::Wanted => undrawable + unwanted == designed.found.scanned,
        _ => true,
    };
    let alone = designed.found.forbidden.iter().filter(|f| f.alone > 0).filter(decides);
    let decisive = alone.max_by_key(|f| f.alone);
    // Where some meet every demand it is their yield that does not suffice.
    let decisive = decisive.filter(|_| designed.found.met == 0);
    text += &match decisive {
        Some(f) => match (f.nearest, designed.limits.of(f.demand)) {
            (Some(nearest), Some(limit)) => format!(
                ": {} forbids it. Of the layouts looked at that meet all else the best has {nearest:.4} {u}; at most {limit} {u} is allowed\n",
                f.demand.word(),
                u = unit(f.demand)
            ),
            _ => format!(": no layout meets the demand that {}\n", f.demand.word()),
        },
        None if designed.found.met > 0 => {
            format!(": no layout has a yield of {} %\n", fixed(100.0 * carom_study::design::ENOUGH, 0))
        }
        None => ": every layout fails several demands at once\n".to_owned(),
    };
    text
}

/// What stands in the way.
fn forbidden(designed: &Designed<'_>) -> String {
    let mut rows =
        vec![["demand", "limit", "fail it", "fail it alone", "nearest of these"].map(str::to_owned).to_vec()];
    for f in designed.found.forbidden.iter().filter(|f| f.failed > 0) {
        let show =
            |value: Option<f64>| value.map_or("-".to_owned(), |v| format!("{v:.4} {}", unit(f.demand)));
        rows.push(vec![
            f.demand.word().to_owned(),
            show(designed.limits.of(f.demand)),
            f.failed.to_string(),
            f.alone.to_string(),
            show(f.nearest),
        ]);
    }
    if rows.len() > 1 { aligned(&rows) } else { String::new() }
}

/// Rows of the table of what else there is.
const MOST_ROWS: usize = 12;

/// Yield against height and impact speed.
fn front(designed: &Designed<'_>) -> String {
    if designed.found.front.is_empty() {
        return String::new();
    }
    let mut rows = vec![vec![
        "yield %".to_owned(),
        "doubled %".to_owned(),
        "height m".to_owned(),
        "strikes m/s".to_owned(),
    ]];
    let head = designed.space.quantities().map(|quantity| labelled(&quantity.path).into_owned());
    rows[0].extend(head);
    for design in designed.found.front.iter().take(MOST_ROWS) {
        let mut row = vec![
            fixed(100.0 * design.yields.share, 2),
            fixed(100.0 * design.doubled.share, 2),
            fixed(design.judged.height, 4),
            fixed(design.judged.impact_speed, 3),
        ];
        let values = designed.space.values(&design.point);
        let quantities = designed.space.quantities().zip(values);
        row.extend(quantities.map(|(quantity, value)| quantity.kind.dimension.show_digits(value, 4)));
        rows.push(row);
    }
    let more = designed.found.front.len().saturating_sub(MOST_ROWS);
    let more = if more > 0 { format!("and {more} more in design.json\n") } else { String::new() };
    format!(
        "\nno layout is better than these in yield, height and impact speed at once\n{}{more}",
        aligned(&rows)
    )
}

fn layout(
    designed: &Designed<'_>,
    values: &[f64],
    judged: &Judged,
    [yields, doubled]: [Estimate; 2],
) -> DesignLayoutReport {
    let paths = designed.space.quantities().map(|quantity| quantity.path.clone());
    DesignLayoutReport {
        chosen: paths.zip(values.iter().copied()).collect(),
        probability: yields.into(),
        yield_doubled: doubled.into(),
        impact_speed_m_s: judged.impact_speed,
        sliding_speed_m_s: judged.sliding_speed,
        height_m: judged.height,
        width_m: judged.width,
        time_s: judged.time,
    }
}

/// For a program.
fn summary(designed: &Designed<'_>) -> DesignReport {
    let found = &designed.found;
    let winner = designed.winner.as_ref();
    DesignReport {
        scene: designed.scene.name().to_owned(),
        approximations: designed.scene.approximations().to_vec(),
        outcome: if winner.is_some() { "found" } else { "not possible" },
        aim: Word(designed.aim),
        winner: winner.map(|w| layout(designed, &w.values, &w.judged, [w.yields, w.doubled])),
        worst: winner.map(|winner| said::worst(designed, winner)),
        at_range_ends: winner.map(|winner| said::at_range_ends(designed, winner)).unwrap_or_default(),
        wall_strikes: winner.map(said::wall_strikes_by_name).unwrap_or_default(),
        delivered: winner.map(delivered).unwrap_or_default(),
        endings: winner.map(endings).unwrap_or_default(),
        exit: winner.and_then(|winner| winner.to_the_end.exit.as_ref()).map(carom_scene::exit_report),
        ends: winner.map(|winner| Word(winner.to_the_end.outcome)),
        front: found
            .front
            .iter()
            .map(|d| layout(designed, &designed.space.values(&d.point), &d.judged, [d.yields, d.doubled]))
            .collect(),
        forbidden: found
            .forbidden
            .iter()
            .map(|f| ForbiddenReport {
                demand: Word(f.demand),
                failed: f.failed,
                alone: f.alone,
                nearest: f.nearest,
                limit: designed.limits.of(f.demand),
            })
            .collect(),
        scanned: found.scanned,
        met: found.met,
        seed: designed.seed,
        run: spent(designed.drops, designed.seconds),
    }
}
