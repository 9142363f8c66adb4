//! `carom regions`: region diagrams of what the engine says.

mod keys;
mod report;
mod rocking;
mod study;

use crate::args::{Format, Output, RegionsOf, RegionsOptions};
use crate::failure::Failure;
use crate::files;
use carom_figure::{RegionAxis, RegionDiagram, regions_csv, regions_svg};
use keys::{Complaints, Key, Plane};
use std::io::Write;
use study::{Findings, Study};

pub(crate) fn regions(
    options: &RegionsOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let kind = match options.of {
        Some(RegionsOf::Cylinder) | None => rocking::Kind::Cylinder,
        Some(RegionsOf::Prism) => rocking::Kind::Prism,
        Some(RegionsOf::Rod) => rocking::Kind::Rod,
        Some(RegionsOf::Strike) => rocking::Kind::Rod,
    };
    let plane = plane(options, kind.keys(), kind.axes())?;
    deliver(&kind.study(&plane, options.elastic), options, output, out)
}

/// The plane that the options ask for.
fn plane(options: &RegionsOptions, keys: Vec<Key>, defaults: [&str; 2]) -> Result<Plane, Failure> {
    let mut complaints = Complaints::default();
    if let Some(restitution) = options.elastic {
        if !(0.0..=1.0).contains(&restitution) {
            complaints.push("--elastic", format!("{restitution} is outside 0 to 1"));
        }
    }
    let axes = [options.x.as_deref().unwrap_or(defaults[0]), options.y.as_deref().unwrap_or(defaults[1])];
    let plane = keys::read(keys, &options.set, axes, &mut complaints);
    complaints.finish()?;
    plane.ok_or_else(|| Failure::Usage("the axes could not be read".to_owned()))
}

/// Computes a diagram, writes its files and says what came out.
fn deliver(
    study: &Study<'_>,
    options: &RegionsOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let findings = study.compute(options.depth).map_err(Failure::Usage)?;
    let summary = serde_json::to_string_pretty(&report::summary(study, &findings))?;
    let folder = output.folder(&study.slug);
    let written = [
        files::write(&folder, "regions.svg", &drawing(study, &findings))?,
        files::write(&folder, "regions.csv", &regions_csv(&findings.regions, &*study.name))?,
        files::write(&folder, "regions.json", &format!("{summary}\n"))?,
    ];
    match output.format {
        Format::Text => out.write_all(report::text(study, &findings, &written).as_bytes())?,
        Format::Json => writeln!(out, "{summary}")?,
    }
    Ok(())
}

fn drawing(study: &Study<'_>, findings: &Findings) -> String {
    let axis = |k: usize| {
        let axis = &study.plane.axes[k];
        RegionAxis { name: study.plane.keys[axis.key].words.clone(), unit: axis.unit().to_owned() }
    };
    regions_svg(&RegionDiagram {
        title: study.title.clone(),
        subtitle: study.subtitle.clone(),
        axes: [axis(0), axis(1)],
        regions: &findings.regions,
        name: &*study.name,
        curves_are: study.curves_are.clone(),
        curves: findings.curves.clone(),
    })
}
