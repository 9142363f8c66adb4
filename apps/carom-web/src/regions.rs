//! How an impact or a roll comes out over two values of its file.

use crate::fields::{dimensions, si};
use crate::reply::Failure;
use crate::request::{Request, Side};
use crate::solid;
use crate::watch::Watch;
use carom::study::Device;
use carom::study::regions::{Options, Range, RegionsError, explore, find};
use carom::tasks::impact::space::SpatialImpactStudy;
use carom::tasks::impact::{ImpactStudy, space, words};
use carom_figure::{RegionAxis, RegionDiagram, RegionName, live_regions};
use carom_scene::input::InMemory;
use carom_scene::unit::{Dimension, Unit};
use carom_scene::{
    AnyImpact, Form, RollProblem, RollReport, SpaceScene, SpatialRollProblem, SpatialRollReport, editing,
};
use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Mutex;

/// What happens at a point where the file is none.
const NONE: &str = "no such file";
/// Letters of a name within its region.
const SHORT: usize = 4;

/// A file with those beside it.
pub(crate) struct File<'a> {
    pub(crate) form: Form,
    pub(crate) name: &'a str,
    pub(crate) text: &'a str,
    pub(crate) beside: &'a InMemory,
}

impl<'a> File<'a> {
    pub(crate) fn of(request: &'a Request, beside: &'a InMemory) -> Self {
        let (name, text) = (request.name.as_str(), request.text.as_str());
        Self { form: Form::of(name, text), name, text, beside }
    }
}

/// A value that is given to a file: its path, the value in SI, and its dimension.
type Given<'a> = (&'a str, f64, Dimension);

/// How it comes out with these values, in a few words.
pub(crate) fn ending(file: &File<'_>, given: &[Given<'_>]) -> String {
    let File { form, name, text, beside } = file;
    let set = || -> Vec<String> {
        let set = given.iter().map(|(path, value, dimension)| format!("{path}={}", si(*value, *dimension)));
        // The first strike says it.
        set.chain(["strikes=1".to_owned()]).collect()
    };
    let strike = |first: Option<String>| first.unwrap_or_else(|| "no strike".to_owned());
    let found = match form {
        Form::Impact => impact(name, text, given),
        Form::Roll(kind) => RollProblem::parse(*kind, name, text, &set()).ok().and_then(|problem| {
            let run = problem.follow().ok()?;
            Some(strike(RollReport::new(&problem, &run).strikes.first().map(|one| one.state.clone())))
        }),
        Form::SpatialRoll(kind) => {
            SpatialRollProblem::parse_with(*kind, name, text, &set(), *beside).ok().and_then(|problem| {
                let run = problem.follow().ok()?;
                Some(strike(
                    SpatialRollReport::new(&problem, &run).strikes.first().map(|one| one.state.clone()),
                ))
            })
        }
        Form::Scene => drop_in_space(file, given),
    };
    found.unwrap_or_else(|| NONE.to_owned())
}

/// The text with these values written into it.
fn set(text: &str, given: &[Given<'_>]) -> Option<String> {
    given.iter().try_fold(text.to_owned(), |text, (path, value, dimension)| {
        let (table, key) = path.rsplit_once('.').unwrap_or(("", path));
        editing::setting(&text, table, key, &si(*value, *dimension))
    })
}

/// How a solid part comes out of its feeder.
fn drop_in_space(file: &File<'_>, given: &[Given<'_>]) -> Option<String> {
    let scene = SpaceScene::parse_with(file.name, &set(file.text, given)?, file.beside).ok()?;
    let run = scene.feeder().drop_part().ok()?;
    Some(solid::headline(&scene, &run, None).words())
}

fn impact(name: &str, text: &str, given: &[Given<'_>]) -> Option<String> {
    let text = set(text, given)?;
    let problem = match AnyImpact::parse(name, &text).ok()? {
        AnyImpact::Planar(problem) => *problem,
        AnyImpact::Spatial(problem) => return Some(space::verdict(&SpatialImpactStudy::of(*problem).report)),
    };
    let study = ImpactStudy::of(problem);
    let end = words::shown(&study.report);
    Some(end.map_or_else(|| "no answer".to_owned(), |end| words::states(end, study.report.staged.as_ref())))
}

/// A label of these words, whatever was asked before.
fn label(words: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    words.hash(&mut hasher);
    hasher.finish()
}

/// The words that were found at a point, in units of the axes and as whole numbers.
pub(crate) type Told = (u64, u64, String);

/// The plane of two values of a file.
pub(crate) struct Plane<'a> {
    file: &'a File<'a>,
    sides: &'a [Side; 2],
    dimensions: Vec<Dimension>,
    units: Vec<Option<Unit>>,
    cells: usize,
    options: Options,
}

impl<'a> Plane<'a> {
    pub(crate) fn of(
        file: &'a File<'a>,
        sides: &'a [Side; 2],
        (cells, options): (usize, Options),
    ) -> Result<Self, Failure> {
        let dimensions = dimensions(file.form, file.text, sides.each_ref().map(|side| side.path.as_str()))?;
        let units = dimensions.iter().map(|of| of.unit(of.usual())).collect();
        Ok(Self { file, sides, dimensions, units, cells, options })
    }

    fn shown(&self, k: usize, value: f64) -> f64 {
        self.units[k].map_or(value, |unit| unit.of_si(value))
    }

    fn ranges(&self) -> [Range; 2] {
        let range = |k: usize| Range {
            from: self.shown(k, self.sides[k].from),
            to: self.shown(k, self.sides[k].to),
            count: self.cells,
        };
        [range(0), range(1)]
    }

    /// How it comes out at a point.
    fn ending(&self, at: [f64; 2], watch: &dyn Watch) -> String {
        watch.step();
        let given = [0, 1].map(|k| {
            let value = self.units[k].map_or(at[k], |unit| unit.to_si(at[k]));
            (self.sides[k].path.as_str(), value, self.dimensions[k])
        });
        ending(self.file, &given)
    }

    /// What is found in one band of the plane, `number` of `of`.
    pub(crate) fn explored(&self, band: (u32, u32), watch: &dyn Watch) -> Result<Vec<Told>, Failure> {
        let told = Mutex::new(vec![]);
        let classify = |x: f64, y: f64| {
            let words = self.ending([x, y], watch);
            let label = label(&words);
            // A lock is poisoned by a panic alone, which ends the whole page's worker.
            if let Ok(mut told) = told.lock() {
                told.push((x.to_bits(), y.to_bits(), words));
            }
            label
        };
        explore(self.ranges(), &self.options, band, classify).map_err(of_regions)?;
        Ok(told.into_inner().unwrap_or_default())
    }

    /// The diagram, as SVG; what is known already is not asked again.
    pub(crate) fn drawn(&self, known: Vec<Told>, watch: &dyn Watch) -> Result<String, Failure> {
        let known: BTreeMap<(u64, u64), String> =
            known.into_iter().map(|(x, y, words)| ((x, y), words)).collect();
        let names: Mutex<BTreeMap<u64, String>> = Mutex::default();
        let classify = |x: f64, y: f64| {
            let words = known.get(&(x.to_bits(), y.to_bits())).cloned();
            let words = words.unwrap_or_else(|| self.ending([x, y], watch));
            let label = label(&words);
            if let Ok(mut names) = names.lock() {
                names.entry(label).or_insert(words);
            }
            label
        };
        let [x, y] = self.ranges();
        let regions = find(x, y, &self.options, classify).map_err(of_regions)?;
        let names = names.into_inner().unwrap_or_default();
        let title = match self.file.form {
            Form::Impact => "how the impact ends",
            Form::Scene => "how the drop ends",
            _ => "what the first strike does",
        };
        Ok(live_regions(&RegionDiagram {
            title: title.to_owned(),
            subtitle: String::new(),
            axes: [0, 1].map(|k| self.axis(k)),
            regions: &regions,
            name: &|label| named(names.get(&label).map_or("", String::as_str)),
            curves_are: String::new(),
            curves: vec![],
            here: Some(([0, 1].map(|k| self.own(k)), "the file".to_owned())),
        }))
    }

    /// Where the file is on an axis.
    fn own(&self, k: usize) -> f64 {
        let fields = self.file.form.fields(self.file.text);
        let field = fields.iter().find(|field| field.path() == self.sides[k].path);
        field.and_then(|field| field.value).map_or(f64::NAN, |value| self.shown(k, value))
    }

    fn axis(&self, k: usize) -> RegionAxis {
        let path = self.sides[k].path.as_str();
        let fields = self.file.form.fields(self.file.text);
        let field = fields.iter().find(|field| field.path() == path);
        let group = field.map_or("", |field| field.group.as_str());
        let key = path.rsplit('.').next().unwrap_or(path).replace('_', " ");
        let name = if group.is_empty() { key } else { format!("{group}: {key}") };
        RegionAxis { name, unit: self.units[k].map_or("", |unit| unit.symbol).to_owned() }
    }
}

fn of_regions(error: RegionsError) -> Failure {
    Failure::of_page(&error.to_string())
}

/// `1` of `1: separates at A, sticks at K`, `Ase Kst` of `A separates, K sticks`; else the first letters of its words.
fn named(words: &str) -> RegionName {
    if let Some((number, long)) = words.split_once(": ").filter(|(number, _)| number.len() <= 2) {
        return RegionName { short: number.to_owned(), long: long.to_owned() };
    }
    let contact = |part: &str| {
        let (name, state) = part.rsplit_once(' ')?;
        ["separates", "sticks", "slips"].contains(&state).then(|| format!("{name}{}", &state[..2]))
    };
    let contacts: Option<Vec<String>> = words.split(", ").map(contact).collect();
    let initials = || words.split(' ').filter_map(|word| word.chars().next()).take(SHORT).collect();
    RegionName { short: contacts.map_or_else(initials, |all| all.join(" ")), long: words.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::named;

    #[test]
    fn a_region_has_a_short_name_of_its_own() {
        let short = |words| named(words).short;
        assert_eq!(short("1: separates at A, sticks at K"), "1", "the number of a type");
        assert_eq!(short("A separates, K sticks"), "Ase Kst", "what each contact does");
        assert_eq!(short("C-sticking, type 7"), "Ct7", "initials");
    }
}
