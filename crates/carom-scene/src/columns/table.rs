//! A table on its way into a Parquet file.

use super::{Column, ColumnsError, arrow};
use bytes::Bytes;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A table as the bytes of a Parquet file, compressed by Snappy; `about` goes into its metadata. The same table gives the same bytes.
///
/// # Errors
/// [`ColumnsError`]: columns of different lengths, a name that occurs twice.
///
/// # Example
/// ```
/// use carom_scene::columns::{Column, parquet};
/// let speed = Column::Number(vec![Some(1.5), None]);
/// let bytes = parquet(&[("speed_m_s", speed)], &[("scene", "stop = \"landed\"")])?;
/// assert_eq!(&bytes[..4], b"PAR1");
/// # Ok::<(), carom_scene::columns::ColumnsError>(())
/// ```
pub fn parquet(columns: &[(&str, Column)], about: &[(&str, &str)]) -> Result<Vec<u8>, ColumnsError> {
    let mut table = Table::new(columns, &[], about)?;
    table.push(columns)?;
    table.finish()
}

/// A Parquet file that is written group by group of rows, none of which is kept as columns.
///
/// # Example
/// Two groups of one row each.
/// ```
/// use carom_scene::columns::{Column, Table, read};
/// let count = |n| [("count", Column::Whole(vec![Some(n)]))];
/// let mut table = Table::new(&count(0), &["kg"], &[])?;
/// table.push(&count(1))?;
/// table.push(&count(2))?;
/// let rows = Column::Whole(vec![Some(1), Some(2)]);
/// assert_eq!(read(table.finish()?)?, [("count".to_owned(), rows)]);
/// # Ok::<(), carom_scene::columns::ColumnsError>(())
/// ```
pub struct Table {
    writer: SerializedFileWriter<Vec<u8>>,
}

impl Table {
    /// A table without rows, whose columns have the names and the kinds of these, and these units where any are given; an empty one says none.
    ///
    /// A unit stands in the metadata of the column's field as Arrow has them, under `unit`: pyarrow, Polars and others show it. For others the file's
    /// metadata have all of them under `units`, a JSON object.
    ///
    /// # Errors
    /// [`ColumnsError`]: a name that occurs twice.
    ///
    /// # Example
    /// A table may have no group at all.
    /// ```
    /// use carom_scene::columns::{Column, Table};
    /// assert!(Table::new(&[("count", Column::Whole(vec![]))], &[], &[])?.finish().is_ok());
    /// # Ok::<(), carom_scene::columns::ColumnsError>(())
    /// ```
    pub fn new(
        columns: &[(&str, Column)],
        units: &[&str],
        about: &[(&str, &str)],
    ) -> Result<Self, ColumnsError> {
        let fields: Vec<Arc<Type>> =
            columns.iter().map(|(name, column)| field(name, column)).collect::<Result<_, _>>()?;
        let schema = Type::group_type_builder("carom").with_fields(fields).build()?;
        let mut said: Vec<(String, String)> = vec![];
        if !units.is_empty() {
            let by_name: BTreeMap<&str, &str> =
                columns.iter().zip(units).map(|((name, _), unit)| (*name, *unit)).collect();
            said.push((arrow::KEY.to_owned(), arrow::schema(columns, units)));
            said.push(("units".to_owned(), serde_json::json!(by_name).to_string()));
        }
        // What the caller says comes last: a seal is the last entry.
        said.extend(about.iter().map(|(key, value)| ((*key).to_owned(), (*value).to_owned())));
        let about = said.into_iter().map(|(key, value)| KeyValue::new(key, value));
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_created_by(concat!("carom ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(about.collect()))
            .build();
        Ok(Self { writer: SerializedFileWriter::new(vec![], Arc::new(schema), Arc::new(properties))? })
    }

    /// Adds a group of rows, with all the columns in their order.
    ///
    /// # Errors
    /// [`ColumnsError`]: columns of different lengths, or of other kinds than the table's.
    ///
    /// # Example
    /// ```
    /// use carom_scene::columns::{Column, Table};
    /// let mut table = Table::new(&[("count", Column::Whole(vec![]))], &[], &[])?;
    /// assert!(table.push(&[("count", Column::Word(vec![None]))]).is_err());
    /// # Ok::<(), carom_scene::columns::ColumnsError>(())
    /// ```
    pub fn push(&mut self, columns: &[(&str, Column)]) -> Result<(), ColumnsError> {
        let mut group = self.writer.next_row_group()?;
        for (_, column) in columns {
            let Some(mut place) = group.next_column()? else { break };
            write(place.untyped(), column)?;
            place.close()?;
        }
        group.close()?;
        Ok(())
    }

    /// The file's bytes.
    ///
    /// # Errors
    /// [`ColumnsError`], where the end cannot be written.
    ///
    /// # Example
    /// ```
    /// use carom_scene::columns::{Column, Table};
    /// let bytes = Table::new(&[("count", Column::Whole(vec![]))], &[], &[])?.finish()?;
    /// assert!(bytes.ends_with(b"PAR1"));
    /// # Ok::<(), carom_scene::columns::ColumnsError>(())
    /// ```
    pub fn finish(self) -> Result<Vec<u8>, ColumnsError> {
        Ok(self.writer.into_inner()?)
    }
}

/// What the metadata of a Parquet file says, key by key.
///
/// # Errors
/// [`ColumnsError`]: bytes that are no file of Parquet's.
///
/// # Example
/// What was said of a table stands in its file.
/// ```
/// use carom_scene::columns::{Column, about, parquet};
/// let bytes = parquet(&[("count", Column::Whole(vec![Some(1)]))], &[("scene", "case_2")])?;
/// assert!(about(bytes)?.contains(&("scene".to_owned(), "case_2".to_owned())));
/// # Ok::<(), carom_scene::columns::ColumnsError>(())
/// ```
pub fn about(file: Vec<u8>) -> Result<Vec<(String, String)>, ColumnsError> {
    let reader = SerializedFileReader::new(Bytes::from(file))?;
    let told = reader.metadata().file_metadata().key_value_metadata().cloned().unwrap_or_default();
    Ok(told.into_iter().map(|entry| (entry.key, entry.value.unwrap_or_default())).collect())
}

fn field(name: &str, column: &Column) -> Result<Arc<Type>, ParquetError> {
    let (physical, logical) = match column {
        Column::Number(_) => (Physical::DOUBLE, None),
        Column::Whole(_) => (Physical::INT64, None),
        Column::Word(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
    };
    let builder = Type::primitive_type_builder(name, physical);
    Ok(Arc::new(builder.with_repetition(Repetition::OPTIONAL).with_logical_type(logical).build()?))
}

/// Values, and for each place whether it has one.
fn split<T: Clone, P>(values: &[Option<T>], plain: impl Fn(T) -> P) -> (Vec<P>, Vec<i16>) {
    let levels = values.iter().map(|value| i16::from(value.is_some())).collect();
    (values.iter().flatten().cloned().map(plain).collect(), levels)
}

fn write(writer: &mut ColumnWriter<'_>, column: &Column) -> Result<(), ParquetError> {
    let written = match (writer, column) {
        (ColumnWriter::DoubleColumnWriter(writer), Column::Number(values)) => {
            let (values, levels) = split(values, |value| value);
            writer.write_batch(&values, Some(&levels), None)
        }
        (ColumnWriter::Int64ColumnWriter(writer), Column::Whole(values)) => {
            let (values, levels) = split(values, |value| value);
            writer.write_batch(&values, Some(&levels), None)
        }
        (ColumnWriter::ByteArrayColumnWriter(writer), Column::Word(values)) => {
            let (values, levels) = split(values, |value| ByteArray::from(value.into_bytes()));
            writer.write_batch(&values, Some(&levels), None)
        }
        _ => Err(ParquetError::General("a column of another type than its field".to_owned())),
    };
    written.map(|_| ())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_can_be_read() {
        let columns = [
            ("x", Column::Number(vec![Some(1.0), None, Some(-0.0)])),
            ("word", Column::Word(vec![None, Some("same side".to_owned()), Some(String::new())])),
            ("n", Column::Whole(vec![Some(1), Some(-2), None])),
        ];
        let bytes = parquet(&columns, &[("version", "1")]).unwrap();
        assert_eq!(bytes, parquet(&columns, &[("version", "1")]).unwrap(), "the same bytes");
        let reader = SerializedFileReader::new(Bytes::from(bytes)).unwrap();
        let about = reader.metadata().file_metadata().key_value_metadata().unwrap();
        assert_eq!((about[0].key.as_str(), about[0].value.as_deref()), ("version", Some("1")));
        let rows: Vec<String> =
            reader.get_row_iter(None).unwrap().map(|row| row.unwrap().to_string()).collect();
        assert_eq!(rows[1], "{x: null, word: \"same side\", n: -2}");
        assert_eq!(rows.len(), 3);
    }

    #[test]
    fn columns_of_different_lengths_are_refused() {
        let columns = [("x", Column::Number(vec![Some(1.0)])), ("y", Column::Number(vec![]))];
        assert!(parquet(&columns, &[]).unwrap_err().to_string().contains("Parquet"));
    }

    #[test]
    fn groups_are_groups_of_rows() {
        let rows = |from: i64| [("n", Column::Whole((from..from + 3).map(Some).collect()))];
        let mut table = Table::new(&rows(0), &[], &[]).unwrap();
        table.push(&rows(0)).unwrap();
        table.push(&rows(3)).unwrap();
        let reader = SerializedFileReader::new(Bytes::from(table.finish().unwrap())).unwrap();
        let sizes: Vec<i64> = reader.metadata().row_groups().iter().map(|group| group.num_rows()).collect();
        assert_eq!(sizes, [3, 3]);
    }
}
