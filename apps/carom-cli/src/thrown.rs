//! What many throws say, of a body in space and of a part in the plane alike.

use crate::table::fixed;
use carom_scene::ThrowRangeReport;
use carom_study::poses::Poses;
use carom_study::yields::REPETITIONS;
use carom_words::study;
use carom_words::study::percent;

/// The face that comes up most, in words; where most throws do not come to rest on one, how most of these end.
pub(crate) fn headline(found: &Poses) -> String {
    if 2 * found.resting.count < found.throws {
        let most =
            found.ends.iter().filter(|end| !end.pose.is_face()).max_by_key(|end| end.probability.count);
        let how =
            most.map_or(String::new(), |end| format!("; most others end with: {}", study::pose(end.pose)));
        return format!("{:.2} % of the throws come to rest on a face{how}", 100.0 * found.resting.share);
    }
    let faces = found.ends.iter().filter(|end| end.pose.is_face() && end.probability.count > 0);
    let most = faces.max_by_key(|end| end.probability.count);
    let Some((end, of)) = most.and_then(|end| Some((end, end.of_resting?))) else {
        return "no throw comes to rest on a face".to_owned();
    };
    let [share, interval] = percent(&of);
    format!("most often on {}: {share} % of those at rest ({interval})", study::pose(end.pose))
}

/// The first two lines of a text.
pub(crate) fn verdict(name: &str, found: &Poses) -> String {
    let [share, interval] = percent(&found.resting);
    let headline = headline(found);
    format!("{name}: {headline}\n{share} % of {} throws come to rest on a face ({interval})\n", found.throws)
}

/// What throws that come to no rest mean for the shares of the others.
pub(crate) fn without_way(found: &Poses) -> Option<String> {
    let lost: u64 =
        found.ends.iter().filter(|end| !end.pose.is_face()).map(|end| end.probability.count).sum();
    let share = 100.0 * lost as f64 / found.throws as f64;
    (lost > 0).then(|| {
        format!(
            "{lost} throws ({share:.2} %) do not come to rest on a face: shares of those at rest say how often a face comes up among the throws that the law can follow to rest, and these are no fair choice of all"
        )
    })
}

/// From where to where a quantity goes.
pub(crate) fn range(range: &ThrowRangeReport, unit: &str) -> String {
    match (range.low, range.high) {
        (Some(low), Some(high)) if low < high => {
            format!("{} to {} {unit} ({})", fixed(low, 5), fixed(high, 5), range.distribution)
        }
        _ => format!("{} {unit} ({})", fixed(range.middle, 5), range.distribution),
    }
}

/// How throws were drawn, and what their intervals are.
pub(crate) fn sampling(throws: u64, seed: u64) -> String {
    format!(
        "{throws} throws: Sobol’s points with Owen’s scrambling, in {REPETITIONS} scrambles of their own; seed {seed}. The 95 % interval of a share of all throws is Student’s, from the spread of the scrambles; where few throws end so, no narrower than Wilson’s. That of a share of those at rest is Wilson’s."
    )
}

/// How long it takes to rest, as a line after an empty one; nothing where nothing comes to rest.
pub(crate) fn until_rest(found: &Poses) -> String {
    let (Some(time), Some(strikes)) = (&found.time, &found.impacts) else { return String::new() };
    format!(
        "\nat rest after {} s (median; 95 % within {} s), {} strikes (95 % at most {})\n",
        fixed(time.median, 4),
        fixed(time.p95, 4),
        fixed(strikes.median, 0),
        fixed(strikes.p95, 0)
    )
}
