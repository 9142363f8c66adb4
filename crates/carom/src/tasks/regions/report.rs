//! What a region diagram says in words and as JSON.

use super::study::{Comparison, EndsShares, Findings, Study};
use crate::tasks::axes::{Axis, Key, Plane};
use crate::tasks::tolerance::SHARE_SHOWN;
use carom_figure::RegionName;
use carom_scene::{
    RegionsAxisReport, RegionsBoundaryReport, RegionsClosedFormReport, RegionsEndsReport,
    RegionsJunctionReport, RegionsLabelReport, RegionsReport, RegionsSettingReport, RegionsThresholdReport,
    RegionsWorkReport,
};
use carom_study::regions::{Boundary, Junction, Regions, Share};
use carom_words::aligned;
use carom_words::number::ascii as fixed;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// For a person.
pub(super) fn text(study: &Study<'_>, findings: &Findings) -> String {
    let regions = &findings.regions;
    let mut text = format!("{}\n{}\n\n", study.title.to_uppercase(), study.subtitle);
    let mut rows = vec![["region", "", "area %", "grid nodes"].map(str::to_owned).to_vec()];
    rows.extend(regions.shares.iter().map(|share| {
        let name = (study.name)(share.label);
        vec![name.short, name.long, fixed(100.0 * share.area, 2), share.nodes.to_string()]
    }));
    text += &aligned(&rows);
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "\n{} boundaries, {} points where three or more regions meet",
        regions.boundaries.len(),
        regions.junctions.len()
    );
    let (sharp, coarse): (Vec<_>, Vec<_>) =
        regions.junctions.iter().partition(|junction| junction.accuracy <= study.accuracy);
    for junction in sharp {
        let names: Vec<String> = junction.labels.iter().map(|label| (study.name)(*label).short).collect();
        let [x, y] = junction.at;
        let _ = writeln!(text, "  {}  at {x:.9}, {y:.9}", names.join("|"));
    }
    if !coarse.is_empty() {
        let _ = writeln!(
            text,
            "  {} more, located to a cell or less: velocities vanish together there and the last of them is rounding, or outcomes change too often",
            coarse.len()
        );
    }
    if !findings.comparisons.is_empty() {
        text += "\nclosed forms: largest distance of the engine's boundary, as a share of the axes\n";
        for comparison in &findings.comparisons {
            let Comparison { name, points, largest, curve_points, confirmed, .. } = comparison;
            let _ = writeln!(
                text,
                "  {name:<40} {}   {confirmed} of {curve_points} points of the curve confirmed",
                if *points > 0 {
                    format!("{largest:.1e} at {points} points")
                } else {
                    "no boundary".to_owned()
                }
            );
        }
        if findings.unexplained > 0 {
            let _ = writeln!(text, "  {} points of boundaries have no closed form", findings.unexplained);
        }
    }
    if let Some(ends) = &findings.ends {
        text += &ends_text(ends);
    }
    text += &thresholds_text(study, &findings.thresholds);
    for remark in &findings.remarks {
        let _ = writeln!(text, "\n{remark}");
    }
    text.push('\n');
    text
}

/// Where the outcome changes on single lines of the plane.
fn thresholds_text(study: &Study<'_>, thresholds: &[RegionsThresholdReport]) -> String {
    if thresholds.is_empty() {
        return String::new();
    }
    let [x, y] = [0, 1].map(|k| study.plane.keys[study.plane.axes[k].key].name.clone());
    let mut rows = vec![vec![
        x,
        "below".to_owned(),
        "above".to_owned(),
        y,
        "closed form".to_owned(),
        "apart".to_owned(),
    ]];
    for RegionsThresholdReport { x, y, below, above, closed_form_y, .. } in thresholds {
        let form = closed_form_y.map_or_else(String::new, |form| fixed(form, 12));
        let apart = closed_form_y.map_or_else(String::new, |form| format!("{:.1e}", (y - form).abs()));
        rows.push(vec![x.to_string(), below.clone(), above.clone(), fixed(*y, 12), form, apart]);
    }
    format!("\nwhere the outcome changes, by bisection of the engine\n{}", aligned(&rows))
}

/// Where the laws leave a choice, if anywhere.
fn ends_text(ends: &EndsShares) -> String {
    let share = |share: f64| if share < SHARE_SHOWN { "<0.1".to_owned() } else { fixed(100.0 * share, 1) };
    let mut text = String::new();
    for (part, what) in [
        (ends.several, "several end states obey the laws, judged at the end alone"),
        (ends.not_reached, "the staged impact ends in none of them: the end depends on the way there"),
        (ends.branching, "the staged impact met several ways on, and one was chosen"),
    ] {
        if part > 0.0 {
            let head = if text.is_empty() { "\nlabels are what the staged impact does\n" } else { "" };
            let _ = writeln!(text, "{head}  on {} % of the grid {what}", share(part));
        }
    }
    text
}

/// For a program.
pub(super) fn summary(study: &Study<'_>, findings: &Findings) -> RegionsReport {
    let regions = &findings.regions;
    let name = |label| (study.name)(label).short;
    RegionsReport {
        diagram: study.slug.clone(),
        title: study.title.clone(),
        axes: [0, 1].map(|k| axis(&study.plane.axes[k], &study.plane.keys)),
        settings: settings(study.plane),
        labels: labels(regions, &*study.name),
        boundaries: boundaries(regions, &name),
        junctions: junctions(regions, &name),
        closed_forms: findings.comparisons.iter().map(closed_form).collect(),
        points_without_closed_form: findings.unexplained,
        ends: findings.ends.as_ref().map(|ends| RegionsEndsReport {
            several_share: ends.several,
            not_reached_share: ends.not_reached,
            branching_share: ends.branching,
        }),
        thresholds: findings.thresholds.clone(),
        remarks: findings.remarks.clone(),
        work: RegionsWorkReport { evaluations: regions.evaluations },
    }
}

/// The labels of a diagram with the room they take.
pub(in crate::tasks) fn labels<L: Copy>(
    regions: &Regions<L>,
    name: &dyn Fn(L) -> RegionName,
) -> Vec<RegionsLabelReport> {
    let label = |share: &Share<L>| {
        let RegionName { short, long } = name(share.label);
        RegionsLabelReport { label: short, words: long, area_share: share.area, grid_nodes: share.nodes }
    };
    regions.shares.iter().map(label).collect()
}

/// The boundaries of a diagram.
pub(in crate::tasks) fn boundaries<L: Copy>(
    regions: &Regions<L>,
    name: &dyn Fn(L) -> String,
) -> Vec<RegionsBoundaryReport> {
    let boundary = |line: &Boundary<L>| RegionsBoundaryReport {
        labels: line.pair.map(name),
        points: line.points.len(),
        closed: line.closed,
    };
    regions.boundaries.iter().map(boundary).collect()
}

/// Where three or more labels of a diagram meet.
pub(in crate::tasks) fn junctions<L: Copy>(
    regions: &Regions<L>,
    name: &dyn Fn(L) -> String,
) -> Vec<RegionsJunctionReport> {
    let junction = |point: &Junction<L>| RegionsJunctionReport {
        labels: point.labels.iter().copied().map(name).collect(),
        x: point.at[0],
        y: point.at[1],
        accuracy_share: point.accuracy,
    };
    regions.junctions.iter().map(junction).collect()
}

pub(in crate::tasks) fn axis(axis: &Axis, keys: &[Key]) -> RegionsAxisReport {
    RegionsAxisReport {
        key: keys[axis.key].name.clone(),
        unit: axis.unit().to_owned(),
        from: axis.range.from,
        to: axis.range.to,
        cells: axis.range.count,
    }
}

/// The quantities that are no axis.
fn settings(plane: &Plane) -> BTreeMap<String, RegionsSettingReport> {
    let fixed = plane.keys.iter().enumerate();
    let fixed = fixed.filter(|(k, _)| plane.axes.iter().all(|axis| axis.key != *k));
    let setting = |(_, key): (usize, &Key)| {
        let unit = key.dimension.si().to_owned();
        (key.name.clone(), RegionsSettingReport { value: key.value, unit })
    };
    fixed.map(setting).collect()
}

fn closed_form(comparison: &Comparison) -> RegionsClosedFormReport {
    let Comparison { name, states, points, largest, curve_points, confirmed } = comparison;
    RegionsClosedFormReport {
        curve: name.clone(),
        states: *states,
        boundary_points: *points,
        largest_distance_share: *largest,
        curve_points: *curve_points,
        curve_points_confirmed: *confirmed,
    }
}
