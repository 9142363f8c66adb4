//! `carom regions`: region diagrams of what the engine says.

mod contact;
mod impact;
pub(crate) mod keys;
mod pyramid;
pub(crate) mod report;
mod rocking;
mod stool;
mod stool_strike;
mod strike;
mod study;

use crate::args::{Format, Output, RegionsOf, RegionsOptions};
use crate::failure::Failure;
use crate::files;
use carom_figure::{RegionAxis, RegionDiagram, RegionName, regions_csv, regions_svg};
use carom_scene::ImpactTemplate;
use carom_scene::columns::{Column, ColumnsError, parquet};
use carom_study::regions::Regions;
use keys::{Complaints, Key, Plane};
use std::io::Write;
use study::{Findings, Study};

pub(crate) fn regions(
    options: &RegionsOptions,
    output: &Output,
    out: &mut impl Write,
) -> Result<(), Failure> {
    let kind = match options.of {
        Some(RegionsOf::Cylinder) => rocking::Kind::Cylinder,
        Some(RegionsOf::Prism) => rocking::Kind::Prism,
        Some(RegionsOf::Rod) => rocking::Kind::Rod,
        Some(RegionsOf::Strike) => {
            let plane = plane(options, strike::keys(), Some(strike::AXES), false)?;
            return deliver(&strike::study(&plane), options, output, out);
        }
        Some(RegionsOf::Contact) => {
            let plane = plane(options, contact::keys(), Some(contact::AXES), false)?;
            return deliver(&contact::study(&plane), options, output, out);
        }
        Some(RegionsOf::Pyramid) => {
            let plane = plane(options, pyramid::keys(), Some(pyramid::AXES), false)?;
            return deliver(&pyramid::study(&plane), options, output, out);
        }
        Some(RegionsOf::Stool) => {
            let plane = plane(options, stool::keys(), Some(stool::AXES), false)?;
            return deliver(&stool::study(&plane), options, output, out);
        }
        Some(RegionsOf::StoolStrike) => {
            let plane = plane(options, stool_strike::keys(), Some(stool_strike::AXES), false)?;
            return deliver(&stool_strike::study(&plane), options, output, out);
        }
        None => return of_file(options, output, out),
    };
    let plane = plane(options, kind.keys(), Some(kind.axes()), true)?;
    deliver(&kind.study(&plane, options.elastic), options, output, out)
}

fn of_file(options: &RegionsOptions, output: &Output, out: &mut impl Write) -> Result<(), Failure> {
    let Some(path) = &options.file else {
        return Err(Failure::Usage("name a kind of strike, or an impact file with --file".to_owned()));
    };
    let file = path.display().to_string();
    let source = files::read_input(path)?;
    let template = ImpactTemplate::parse(&file, &source)?;
    let plane = plane(options, impact::keys(&template), None, false)?;
    // What is set is set for good; the axes are moved on top of it.
    let set: Vec<(&str, f64)> = plane.keys.iter().map(|key| (key.name.as_str(), key.value)).collect();
    let mut complaints = Complaints::default();
    for (option, message) in impact::problems(&template, &plane) {
        complaints.push(option, message);
    }
    complaints.finish()?;
    let names = template.at(&set)?.names;
    let title = path.file_stem().map_or_else(|| "impact".into(), |stem| stem.to_string_lossy().into_owned());
    deliver(&impact::study(&template, &names, &title, &plane), options, output, out)
}

/// The plane that the options ask for; without defaults both axes must be named.
fn plane(
    options: &RegionsOptions,
    keys: Vec<Key>,
    defaults: Option<[&str; 2]>,
    may_be_elastic: bool,
) -> Result<Plane, Failure> {
    let mut complaints = Complaints::default();
    match options.elastic {
        Some(_) if !may_be_elastic => {
            complaints
                .push("--elastic", "is for cylinder, prism and rod: others have restitution".to_owned());
        }
        Some(restitution) if !(0.0..=1.0).contains(&restitution) => {
            complaints.push("--elastic", format!("{restitution} is outside 0 to 1"));
        }
        _ => {}
    }
    let axes = [(&options.x, "--x"), (&options.y, "--y")].map(|(given, option)| {
        if given.is_none() && defaults.is_none() {
            let names: Vec<&str> = keys.iter().map(|key| key.name.as_str()).collect();
            complaints.push(option, format!("missing: KEY=A..B with one of {}", names.join(", ")));
        }
        given.as_deref()
    });
    let axes = match (axes, defaults) {
        ([x, y], Some(defaults)) => [x.unwrap_or(defaults[0]), y.unwrap_or(defaults[1])],
        ([Some(x), Some(y)], None) => [x, y],
        _ => {
            complaints.finish()?;
            return Err(Failure::Usage("both axes must be named".to_owned()));
        }
    };
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
    let mut written = files::write_drawing(&folder, "regions", &drawing(study, &findings))?;
    let csv = regions_csv(&findings.regions, ["x", "y"], &*study.name);
    written.push(files::write(&folder, "regions.csv", &csv)?);
    let table = boundaries(&findings.regions, &*study.name);
    written.extend(files::write_table(&folder, "regions.parquet", table)?);
    written.push(files::write(&folder, "regions.json", &format!("{summary}\n"))?);
    match output.format {
        Format::Text => out.write_all(report::text(study, &findings, &written).as_bytes())?,
        Format::Json => writeln!(out, "{summary}")?,
    }
    Ok(())
}

/// The points of the boundaries as Parquet, as `regions.csv` has them.
pub(crate) fn boundaries<L: Copy>(
    regions: &Regions<L>,
    name: &dyn Fn(L) -> RegionName,
) -> Result<Vec<u8>, ColumnsError> {
    let (mut x, mut y, mut polyline) = (vec![], vec![], vec![]);
    let mut labels = [vec![], vec![]];
    for (number, boundary) in (0..).zip(&regions.boundaries) {
        let first = boundary.points.first().filter(|_| boundary.closed);
        for point in boundary.points.iter().chain(first) {
            x.push(Some(point[0]));
            y.push(Some(point[1]));
            polyline.push(Some(number));
            for (column, label) in labels.iter_mut().zip(boundary.pair) {
                column.push(Some(name(label).short));
            }
        }
    }
    let [a, b] = labels;
    let columns = [
        ("x", Column::Number(x)),
        ("y", Column::Number(y)),
        ("label_a", Column::Word(a)),
        ("label_b", Column::Word(b)),
        ("polyline", Column::Whole(polyline)),
    ];
    parquet(&columns, &[("version", env!("CARGO_PKG_VERSION"))])
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
        here: None,
    })
}
