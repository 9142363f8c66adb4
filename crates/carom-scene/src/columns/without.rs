//! Tables of a build without Parquet: there is none.

use super::{Column, ColumnsError};

/// No table is written by this build.
///
/// # Errors
/// [`ColumnsError::NoParquet`], always.
///
/// # Example
/// ```
/// let error = carom_scene::columns::parquet(&[], &[]).unwrap_err();
/// assert!(error.to_string().contains("no Parquet"));
/// ```
pub fn parquet(_: &[(&str, Column)], _: &[(&str, &str)]) -> Result<Vec<u8>, ColumnsError> {
    Err(ColumnsError::NoParquet)
}

/// A table that no build without Parquet can have: there is no value of this type.
#[derive(Debug)]
pub enum Table {}

impl Table {
    /// No table is written by this build.
    ///
    /// # Errors
    /// [`ColumnsError::NoParquet`], always.
    pub fn new(_: &[(&str, Column)], _: &[&str], _: &[(&str, &str)]) -> Result<Self, ColumnsError> {
        Err(ColumnsError::NoParquet)
    }

    /// Never called: there is no such table.
    ///
    /// # Errors
    /// None, as it is never called.
    pub fn push(&mut self, _: &[(&str, Column)]) -> Result<(), ColumnsError> {
        match *self {}
    }

    /// Never called: there is no such table.
    ///
    /// # Errors
    /// None, as it is never called.
    pub fn finish(self) -> Result<Vec<u8>, ColumnsError> {
        match self {}
    }
}

/// No file is read by this build.
///
/// # Errors
/// [`ColumnsError::NoParquet`], always.
pub fn about(_: Vec<u8>) -> Result<Vec<(String, String)>, ColumnsError> {
    Err(ColumnsError::NoParquet)
}

/// No file is read by this build.
///
/// # Errors
/// [`ColumnsError::NoParquet`], always.
pub fn read(_: Vec<u8>) -> Result<Vec<(String, Column)>, ColumnsError> {
    Err(ColumnsError::NoParquet)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_says_that_there_is_no_parquet() {
        let said = [
            parquet(&[], &[]).map(drop),
            Table::new(&[], &[], &[]).map(drop),
            about(vec![]).map(drop),
            read(vec![]).map(drop),
        ];
        for result in said {
            assert!(matches!(result, Err(ColumnsError::NoParquet)), "{result:?}");
        }
    }
}
