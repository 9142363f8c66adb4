//! What a Parquet file holds, as columns again.

use super::{Column, ColumnsError};
use bytes::Bytes;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};

/// The columns of a file that [`super::parquet`] or [`super::Table`] wrote, by name, with the rows of all groups.
///
/// # Errors
/// [`ColumnsError`]: bytes that are no file of Parquet's, or one of other kinds of columns.
///
/// # Example
/// ```
/// use carom_scene::columns::{Column, parquet, read};
/// let speed = [("speed_m_s".to_owned(), Column::Number(vec![Some(1.5), None]))];
/// let bytes = parquet(&[("speed_m_s", speed[0].1.clone())], &[])?;
/// assert_eq!(read(bytes)?, speed);
/// # Ok::<(), carom_scene::columns::ColumnsError>(())
/// ```
pub fn read(file: Vec<u8>) -> Result<Vec<(String, Column)>, ColumnsError> {
    let reader = SerializedFileReader::new(Bytes::from(file))?;
    let described = reader.metadata().file_metadata().schema_descr();
    let mut found: Vec<(String, Column)> = vec![];
    for (i, column) in described.columns().iter().enumerate() {
        let mut whole: Option<Column> = None;
        for k in 0..reader.num_row_groups() {
            let group = reader.get_row_group(k)?;
            let rows = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
            let part = column_of(group.get_column_reader(i)?, rows)?;
            let fits = match &mut whole {
                None => {
                    whole = Some(part);
                    true
                }
                Some(whole) => whole.append(part),
            };
            if !fits {
                return Err(other_kind());
            }
        }
        found.extend(whole.map(|whole| (column.name().to_owned(), whole)));
    }
    Ok(found)
}

fn other_kind() -> ColumnsError {
    ParquetError::General("a column of a kind that tables of Carom have not".to_owned()).into()
}

fn column_of(reader: ColumnReader, rows: usize) -> Result<Column, ColumnsError> {
    match reader {
        ColumnReader::DoubleColumnReader(reader) => Ok(Column::Number(places(reader, rows, Ok)?)),
        ColumnReader::Int64ColumnReader(reader) => Ok(Column::Whole(places(reader, rows, Ok)?)),
        ColumnReader::ByteArrayColumnReader(reader) => {
            Ok(Column::Word(places(reader, rows, |word| Ok(word.as_utf8()?.to_owned()))?))
        }
        _ => Err(other_kind()),
    }
}

/// The rows of a column, each with its value or without.
fn places<D: DataType, P>(
    mut reader: ColumnReaderImpl<D>,
    rows: usize,
    plain: impl Fn(D::T) -> Result<P, ParquetError>,
) -> Result<Vec<Option<P>>, ColumnsError> {
    let (mut levels, mut values) = (vec![], vec![]);
    while levels.len() < rows {
        let (read, _, _) = reader.read_records(rows - levels.len(), Some(&mut levels), None, &mut values)?;
        if read == 0 {
            return Err(ParquetError::General("a column ends before its rows do".to_owned()).into());
        }
    }
    let mut values = values.into_iter();
    let place = |level: i16| if level > 0 { values.next().map(&plain).transpose() } else { Ok(None) };
    Ok(levels.into_iter().map(place).collect::<Result<_, _>>()?)
}
