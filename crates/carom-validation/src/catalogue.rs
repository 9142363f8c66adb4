//! Every published result: its table, and how the engine computes it.

use crate::failure::ValidationError;
use crate::report::{ResultReport, ValidationReport};
use crate::results;
use crate::table::Table;
use crate::value::Values;

/// A published result.
struct Published {
    name: &'static str,
    /// Its `result.toml`.
    text: &'static str,
    compute: fn() -> Result<Values, ValidationError>,
}

/// One of `validation/`, with the function that computes it.
macro_rules! published {
    ($name:literal, $compute:path) => {
        Published {
            name: $name,
            text: include_str!(concat!("../../../validation/", $name, "/result.toml")),
            compute: $compute,
        }
    };
}

const CATALOGUE: &[Published] = &[
    published!("feeder_table_1", results::feeder_paper::compute),
    published!("turning_rule", results::turning_rule::compute),
    published!("cylinder", results::rocking_paper::compute_cylinder),
    published!("prism", results::rocking_paper::compute_prism),
    published!("rod", results::rocking_paper::compute_rod),
    published!("pyramid", results::spatial_paper::compute_pyramid),
    published!("supports", results::spatial_paper::compute_supports),
    published!("housner_block", results::blocks::housner),
    published!("rimless_wheel", results::blocks::rimless_wheel),
    published!("energy_gain", results::one_contact::energy),
    published!("painleve_rod", results::one_contact::painleve),
    published!("falling_stick", results::falling::falling_stick),
    published!("newtons_cradle", results::chains::cradle),
    published!("stacked_balls", results::chains::stacked),
    published!("bouncing_ball", results::falling::bouncing_ball),
    published!("rolling_off_an_edge", results::falling::rolling_off),
    published!("incline", results::falling::incline),
    published!("hexagonal_prism", results::polygons::hexagonal_prism),
    published!("rocking_measured", results::polygons::rocking_measured),
    published!("cuboid_dice", results::dice::cuboids),
];

/// The names of all results, in the order in which they are validated.
pub fn names() -> impl Iterator<Item = &'static str> {
    CATALOGUE.iter().map(|published| published.name)
}

/// The table of a result, as it stands in its file.
///
/// # Errors
/// [`ValidationError::Unknown`], or a table that cannot be read.
///
/// # Example
/// ```
/// let housner = carom_validation::table("housner_block")?;
/// assert!(housner.citation.starts_with("Housner"));
/// # Ok::<(), carom_validation::ValidationError>(())
/// ```
pub fn table(name: &str) -> Result<Table, ValidationError> {
    read(find(name)?)
}

/// Computes results with the engine and judges every row; without names, all of them.
///
/// An engine that fails is no error here: the rows of that result *fail*, and the result says why.
///
/// # Errors
/// [`ValidationError::Unknown`], or a table that cannot be read.
///
/// # Example
/// ```
/// let report = carom_validation::validate(&["housner_block"])?;
/// assert!(report.is_as_declared());
/// # Ok::<(), carom_validation::ValidationError>(())
/// ```
pub fn validate(names: &[&str]) -> Result<ValidationReport, ValidationError> {
    let chosen: Vec<&Published> = match names {
        [] => CATALOGUE.iter().collect(),
        some => some.iter().map(|name| find(name)).collect::<Result<_, _>>()?,
    };
    let tables = chosen.iter().map(|published| read(published)).collect::<Result<Vec<_>, _>>()?;
    let results = chosen
        .iter()
        .zip(tables)
        .map(|(published, table)| ResultReport::new(published.name, table, (published.compute)()));
    Ok(ValidationReport::new(results.collect()))
}

fn find(name: &str) -> Result<&'static Published, ValidationError> {
    CATALOGUE.iter().find(|published| published.name == name).ok_or_else(|| ValidationError::Unknown {
        name: name.to_owned(),
        known: names().collect::<Vec<_>>().join(", "),
    })
}

fn read(published: &Published) -> Result<Table, ValidationError> {
    toml::from_str(published.text).map_err(|error| ValidationError::Table {
        name: published.name.to_owned(),
        why: error.to_string().trim_end().to_owned(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn no_key_stands_twice() {
        for published in CATALOGUE {
            let table = read(published).unwrap();
            let rows: BTreeSet<&str> = table.rows.iter().map(|row| row.key.as_str()).collect();
            assert_eq!(rows.len(), table.rows.len(), "{}", published.name);
        }
    }

    #[test]
    fn what_no_row_asks_for_is_told() {
        let published = find("incline").unwrap();
        let mut values = (published.compute)().unwrap();
        let report = |values| ResultReport::new(published.name, read(published).unwrap(), Ok(values));
        assert!(report(values.clone()).as_declared);
        values.put("odd", 1.0);
        let report = report(values);
        assert!(!report.as_declared, "{report:?}");
        assert!(report.failure.is_some_and(|why| why.ends_with("odd")));
    }

    #[test]
    fn what_is_declared_wrong_says_why() {
        for published in CATALOGUE {
            for row in read(published).unwrap().rows {
                let needed = row.expected.needs_evidence();
                assert_eq!(needed, !row.evidence.is_empty(), "{}: {}", published.name, row.key);
            }
        }
    }

    #[test]
    fn an_unknown_name_is_refused_with_those_that_there_are() {
        let error = validate(&["housner"]).unwrap_err().to_string();
        assert!(error.contains("\"housner\"") && error.contains("housner_block"), "{error}");
    }
}
