//! Tables as Parquet: written, sealed, read again.
//!
//! Parquet brings some twenty crates, so it stands behind the cargo feature `parquet`. Without the feature everything here is there
//! all the same, and says that it cannot: whoever writes tables needs no `cfg` of their own.
//! The examples that write a table end before it in a build that has no Parquet.

#[cfg(feature = "parquet")]
mod arrow;
#[cfg(feature = "parquet")]
mod read;
mod seal;
#[cfg(feature = "parquet")]
mod table;
#[cfg(not(feature = "parquet"))]
mod without;

#[cfg(feature = "parquet")]
pub use read::read;
pub use seal::{SEAL, is_sealed, sealed};
#[cfg(feature = "parquet")]
pub use table::{Table, about, parquet};
#[cfg(not(feature = "parquet"))]
pub use without::{Table, about, parquet, read};

use thiserror::Error;

/// One column of a table; a place without a value is null.
///
/// # Example
/// A place without a value is empty.
/// ```
/// # if !carom_scene::columns::HAS_PARQUET { return Ok(()); }
/// use carom_scene::columns::{Column, parquet};
/// let speeds = |list: Vec<Option<f64>>| parquet(&[("speed_m_s", Column::Number(list))], &[]);
/// assert_ne!(speeds(vec![Some(1.5), None])?, speeds(vec![Some(1.5), Some(0.0)])?);
/// # Ok::<(), carom_scene::columns::ColumnsError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub enum Column {
    /// Numbers.
    Number(Vec<Option<f64>>),
    /// Words.
    Word(Vec<Option<String>>),
    /// Whole numbers.
    Whole(Vec<Option<i64>>),
}

/// Whether this build has Parquet, by the cargo feature `parquet`. Without it every table answers [`ColumnsError::NoParquet`].
///
/// # Example
/// ```
/// use carom_scene::columns::{HAS_PARQUET, parquet};
/// assert_eq!(parquet(&[], &[]).is_ok(), HAS_PARQUET);
/// ```
pub const HAS_PARQUET: bool = cfg!(feature = "parquet");

/// Why a table could not be written or read.
///
/// # Example
/// Columns of different lengths are no table.
/// ```
/// # if !carom_scene::columns::HAS_PARQUET { return; }
/// use carom_scene::columns::{Column, parquet};
/// let (one, two) = (Column::Whole(vec![Some(1)]), Column::Whole(vec![Some(1), Some(2)]));
/// let error = parquet(&[("one", one), ("two", two)], &[]).unwrap_err();
/// assert!(error.to_string().starts_with("the Parquet table cannot be written or read"));
/// ```
#[derive(Debug, Error)]
pub enum ColumnsError {
    /// The build has no Parquet.
    #[error("this build of Carom has no Parquet: build it with the cargo feature `parquet`")]
    NoParquet,
    /// Columns that are no table, or bytes that are no Parquet file.
    #[cfg(feature = "parquet")]
    #[error("the Parquet table cannot be written or read: {0}")]
    Parquet(#[from] parquet::errors::ParquetError),
}

impl Column {
    /// Puts the places of another column below these; false, and nothing is put, where it is of another kind.
    ///
    /// # Example
    /// ```
    /// use carom_scene::columns::Column;
    /// let mut counts = Column::Whole(vec![Some(1)]);
    /// assert!(counts.append(Column::Whole(vec![None])) && !counts.append(Column::Word(vec![])));
    /// assert_eq!(counts, Column::Whole(vec![Some(1), None]));
    /// ```
    pub fn append(&mut self, below: Self) -> bool {
        match (self, below) {
            (Self::Number(places), Self::Number(more)) => places.extend(more),
            (Self::Word(places), Self::Word(more)) => places.extend(more),
            (Self::Whole(places), Self::Whole(more)) => places.extend(more),
            _ => return false,
        }
        true
    }
}
