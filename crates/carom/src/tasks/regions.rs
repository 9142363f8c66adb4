//! Region diagrams of what the engine says: the study of `carom regions`.

mod contact;
mod impact;
mod pyramid;
pub(super) mod report;
mod rocking;
mod stool;
mod stool_strike;
mod strike;
mod study;

use super::StudyError;
use super::axes::{Asker, Complaints, Key, Plane, read};
use carom_figure::{RegionAxis, RegionDiagram, RegionName, regions_csv, regions_svg};
use carom_scene::columns::{Column, ColumnsError, parquet};
use carom_scene::{ImpactTemplate, RegionsReport};
use carom_study::regions::Regions;
use std::path::Path;
use study::{Findings, Study};

/// What strikes, or slides, in a region diagram.
///
/// # Example
/// ```
/// use carom::tasks::regions::RegionsOf;
/// assert_eq!(RegionsOf::of_word("stool-strike"), Some(RegionsOf::StoolStrike));
/// assert_eq!(RegionsOf::Prism.word(), "prism");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RegionsOf {
    /// A cylinder that rolls against a step or a second plane.
    Cylinder,
    /// A prism that rolls on over its next edge.
    Prism,
    /// A rod that turns about one of two supports and falls on the other.
    Rod,
    /// A corner of a rod or box that strikes a plate.
    Strike,
    /// A pyramid that rolls over a lateral edge onto its next face.
    Pyramid,
    /// A rod that slides with one end on a plate, under gravity.
    Contact,
    /// A stool that is let go on one support.
    Stool,
    /// A stool that comes down from one support on the next.
    StoolStrike,
}

impl RegionsOf {
    /// All of them.
    pub const ALL: [Self; 8] = [
        Self::Cylinder,
        Self::Prism,
        Self::Rod,
        Self::Strike,
        Self::Pyramid,
        Self::Contact,
        Self::Stool,
        Self::StoolStrike,
    ];

    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Cylinder => "cylinder",
            Self::Prism => "prism",
            Self::Rod => "rod",
            Self::Strike => "strike",
            Self::Pyramid => "pyramid",
            Self::Contact => "contact",
            Self::Stool => "stool",
            Self::StoolStrike => "stool-strike",
        }
    }

    /// The one of this word.
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.word() == word)
    }

    /// The one of its kind that rocks in the plane, for which the end of compression can be told from the whole impact.
    fn rocking(self) -> Option<rocking::Kind> {
        match self {
            Self::Cylinder => Some(rocking::Kind::Cylinder),
            Self::Prism => Some(rocking::Kind::Prism),
            Self::Rod => Some(rocking::Kind::Rod),
            _ => None,
        }
    }

    fn keys(self) -> Vec<Key> {
        match self {
            Self::Strike => strike::keys(),
            Self::Contact => contact::keys(),
            Self::Pyramid => pyramid::keys(),
            Self::Stool => stool::keys(),
            Self::StoolStrike => stool_strike::keys(),
            Self::Cylinder | Self::Prism | Self::Rod => {
                self.rocking().map(rocking::Kind::keys).unwrap_or_default()
            }
        }
    }

    /// The axes of a diagram that names none.
    fn axes(self) -> [&'static str; 2] {
        match self {
            Self::Cylinder => rocking::Kind::Cylinder.axes(),
            Self::Prism => rocking::Kind::Prism.axes(),
            Self::Rod => rocking::Kind::Rod.axes(),
            Self::Strike => strike::AXES,
            Self::Contact => contact::AXES,
            Self::Pyramid => pyramid::AXES,
            Self::Stool => stool::AXES,
            Self::StoolStrike => stool_strike::AXES,
        }
    }

    fn study(self, plane: &Plane, elastic: Option<f64>) -> Study<'_> {
        match self {
            Self::Cylinder => rocking::Kind::Cylinder.study(plane, elastic),
            Self::Prism => rocking::Kind::Prism.study(plane, elastic),
            Self::Rod => rocking::Kind::Rod.study(plane, elastic),
            Self::Strike => strike::study(plane),
            Self::Contact => contact::study(plane),
            Self::Pyramid => pyramid::study(plane),
            Self::Stool => stool::study(plane),
            Self::StoolStrike => stool_strike::study(plane),
        }
    }
}

/// Of what a diagram is.
#[derive(Clone, Copy, Debug)]
pub enum RegionsSubject<'a> {
    /// Something that strikes or slides.
    Kind(RegionsOf),
    /// An impact file, any two numbers of which may be axes: its name and its text.
    File(&'a str, &'a str),
}

/// What is asked of a region diagram.
#[derive(Clone, Copy, Debug)]
pub struct RegionsAsked<'a> {
    /// Of what it is.
    pub of: RegionsSubject<'a>,
    /// Quantities that are not at their defaults: `inertia_ratio=0.5`.
    pub set: &'a [String],
    /// Abscissa and ordinate: `friction=0..1.5:75`; an impact file has no defaults.
    pub axes: [Option<&'a str>; 2],
    /// The restitution with which the whole impact is labelled, where it is not the end of compression (cylinder, prism, rod).
    pub elastic: Option<f64>,
    /// How often a cell is halved where something in it does not fit.
    pub depth: u32,
    /// Who asks.
    pub asker: Asker,
}

impl<'a> RegionsAsked<'a> {
    /// What is asked of a kind where nothing else is said.
    pub fn of(kind: RegionsOf) -> Self {
        let of = RegionsSubject::Kind(kind);
        Self { of, set: &[], axes: [None; 2], elastic: None, depth: 3, asker: Asker::Call }
    }
}

/// A region diagram.
///
/// # Example
/// ```
/// use carom::tasks::regions::{RegionsAsked, RegionsOf, RegionsStudy};
/// let axes = [Some("to_a=100..400 mm:6"), Some("to_b=100..400 mm:6")];
/// let asked = RegionsAsked { axes, ..RegionsAsked::of(RegionsOf::Rod) };
/// let found = RegionsStudy::drawn(&asked, || {})?;
/// assert_eq!(found.report.boundaries.len(), 1, "12ab = l² parts the rod's two outcomes");
/// # Ok::<(), carom::tasks::StudyError>(())
/// ```
pub struct RegionsStudy {
    /// What it says to a program.
    pub report: RegionsReport,
    /// The name of its folder.
    pub slug: String,
    /// The picture, by itself.
    pub svg: String,
    /// The points of the boundaries as CSV.
    pub csv: String,
    /// The same as Parquet.
    pub table: Result<Vec<u8>, ColumnsError>,
    /// What it says to a person.
    pub text: String,
}

impl RegionsStudy {
    /// Draws a diagram; `step` is called at each point that is asked.
    ///
    /// # Errors
    /// Everything that is wrong with what is asked.
    pub fn drawn(asked: &RegionsAsked<'_>, step: impl Fn() + Sync) -> Result<Self, StudyError> {
        match asked.of {
            RegionsSubject::Kind(kind) => {
                let plane = plane(asked, kind.keys(), Some(kind.axes()), kind.rocking().is_some())?;
                Self::of(kind.study(&plane, asked.elastic), asked.depth, step)
            }
            RegionsSubject::File(name, text) => of_file(asked, (name, text), step),
        }
    }

    fn of(study: Study<'_>, depth: u32, step: impl Fn() + Sync) -> Result<Self, StudyError> {
        let findings = study.compute(depth, &step).map_err(StudyError::Asked)?;
        Ok(Self {
            report: report::summary(&study, &findings),
            svg: drawing(&study, &findings),
            csv: regions_csv(&findings.regions, ["x", "y"], &*study.name),
            table: boundaries(&findings.regions, &*study.name),
            text: report::text(&study, &findings),
            slug: study.slug,
        })
    }
}

fn of_file(
    asked: &RegionsAsked<'_>,
    (file, source): (&str, &str),
    step: impl Fn() + Sync,
) -> Result<RegionsStudy, StudyError> {
    let template = ImpactTemplate::parse(file, source)?;
    let plane = plane(asked, impact::keys(&template), None, false)?;
    // What is set is set for good; the axes are moved on top of it.
    let set: Vec<(&str, f64)> = plane.keys.iter().map(|key| (key.name.as_str(), key.value)).collect();
    let mut complaints = Complaints::of(asked.asker);
    for (option, message) in impact::problems(&template, &plane) {
        complaints.push(option, message);
    }
    complaints.finish()?;
    let names = template.at(&set)?.names;
    let stem = Path::new(file).file_stem();
    let title = stem.map_or_else(|| "impact".into(), |stem| stem.to_string_lossy().into_owned());
    RegionsStudy::of(impact::study(&template, &names, &title, &plane), asked.depth, step)
}

/// The plane that is asked for; without defaults both axes must be named.
fn plane(
    asked: &RegionsAsked<'_>,
    keys: Vec<Key>,
    defaults: Option<[&str; 2]>,
    may_be_elastic: bool,
) -> Result<Plane, StudyError> {
    let mut complaints = Complaints::of(asked.asker);
    match asked.elastic {
        Some(_) if !may_be_elastic => {
            complaints.push("elastic", "is for cylinder, prism and rod: others have restitution".to_owned());
        }
        Some(restitution) if !(0.0..=1.0).contains(&restitution) => {
            complaints.push("elastic", format!("{restitution} is outside 0 to 1"));
        }
        _ => {}
    }
    for (given, option) in asked.axes.iter().zip(["x", "y"]) {
        if given.is_none() && defaults.is_none() {
            let names: Vec<&str> = keys.iter().map(|key| key.name.as_str()).collect();
            complaints.push(option, format!("missing: KEY=A..B with one of {}", names.join(", ")));
        }
    }
    let axes = match (asked.axes, defaults) {
        ([x, y], Some(defaults)) => [x.unwrap_or(defaults[0]), y.unwrap_or(defaults[1])],
        ([Some(x), Some(y)], None) => [x, y],
        _ => {
            complaints.finish()?;
            return Err(StudyError::Asked("both axes must be named".to_owned()));
        }
    };
    let plane = read(keys, asked.set, axes, &mut complaints);
    complaints.finish()?;
    plane.ok_or_else(|| StudyError::Asked("the axes could not be read".to_owned()))
}

/// The points of the boundaries as Parquet, as `regions.csv` has them.
fn boundaries<L: Copy>(
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
