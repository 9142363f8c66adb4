//! Answers by the million: columns that NumPy and Arrow read.

use crate::failure::{of_fault, of_words};
use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::types::Int16Type;
use arrow_array::{
    ArrayRef, DictionaryArray, Float64Array, Int16Array, RecordBatch, RecordBatchIterator, StringArray,
};
use arrow_schema::{ArrowError, Field, Schema};
use carom_scene::columns::Column;
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::PyCapsule;
use std::collections::HashMap;
use std::sync::Arc;

/// One column.
#[derive(Clone)]
pub(crate) enum Data {
    /// Numbers; NaN where there is none.
    Number(Vec<f64>),
    /// Words, each by its number among the different ones; −1 where there is none.
    Word { numbers: Vec<i16>, words: Vec<String> },
}

impl Data {
    pub(crate) fn numbers() -> Self {
        Self::Number(vec![])
    }

    pub(crate) fn words() -> Self {
        Self::Word { numbers: vec![], words: vec![] }
    }

    /// Puts a word below the others.
    pub(crate) fn push_word(&mut self, word: Option<&str>) {
        let Self::Word { numbers, words } = self else { return };
        let Some(word) = word else { return numbers.push(-1) };
        let known = words.iter().position(|known| known == word).unwrap_or_else(|| {
            words.push(word.to_owned());
            words.len() - 1
        });
        numbers.push(i16::try_from(known).unwrap_or(-1));
    }

    pub(crate) fn push(&mut self, number: f64) {
        if let Self::Number(numbers) = self {
            numbers.push(number);
        }
    }

    /// Puts a column of the command's tables below.
    pub(crate) fn append(&mut self, below: &Column) {
        match below {
            Column::Number(list) => list.iter().for_each(|value| self.push(value.unwrap_or(f64::NAN))),
            Column::Word(list) => list.iter().for_each(|word| self.push_word(word.as_deref())),
            Column::Whole(_) => {}
        }
    }

    fn len(&self) -> usize {
        match self {
            Self::Number(values) => values.len(),
            Self::Word { numbers, .. } => numbers.len(),
        }
    }

    fn array(&self) -> Result<ArrayRef, ArrowError> {
        Ok(match self {
            Self::Number(values) => {
                let known = |value: &f64| Some(*value).filter(|value| !value.is_nan());
                Arc::new(values.iter().map(known).collect::<Float64Array>())
            }
            Self::Word { numbers, words } => {
                let keys: Int16Array = numbers.iter().map(|n| Some(*n).filter(|n| *n >= 0)).collect();
                Arc::new(DictionaryArray::<Int16Type>::try_new(
                    keys,
                    Arc::new(StringArray::from_iter_values(words)),
                )?)
            }
        })
    }
}

/// A column with its name and its unit.
#[derive(Clone)]
pub(crate) struct Named {
    pub(crate) name: String,
    pub(crate) unit: String,
    pub(crate) data: Data,
}

/// A table.
#[pyclass(frozen, module = "carom._carom")]
pub(crate) struct Table {
    rows: usize,
    columns: Vec<Named>,
}

/// A column for NumPy: its numbers, or the numbers of its words and the words.
#[derive(IntoPyObject)]
enum Read<'py> {
    Number(Bound<'py, PyArray1<f64>>),
    Word((Bound<'py, PyArray1<i16>>, Vec<String>)),
}

impl Table {
    pub(crate) fn new(rows: usize, columns: Vec<Named>) -> Self {
        Self { rows, columns }
    }

    fn batch(&self) -> Result<RecordBatch, ArrowError> {
        let mut fields = vec![];
        let mut arrays = vec![];
        for column in &self.columns {
            let array = column.data.array()?;
            let unit = HashMap::from([("unit".to_owned(), column.unit.clone())]);
            fields.push(Field::new(&column.name, array.data_type().clone(), true).with_metadata(unit));
            arrays.push(array);
        }
        RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays)
    }
}

/// A column as it was read.
#[derive(FromPyObject)]
enum Sent<'py> {
    Number(PyReadonlyArray1<'py, f64>),
    Word((PyReadonlyArray1<'py, i16>, Vec<String>)),
}

#[pymethods]
impl Table {
    /// The table that another process had.
    #[new]
    fn again(py: Python<'_>, columns: Vec<(String, String, Sent<'_>)>) -> PyResult<Self> {
        let columns: Vec<Named> = columns
            .into_iter()
            .map(|(name, unit, sent)| {
                let data = match sent {
                    Sent::Number(values) => Data::Number(values.as_array().to_vec()),
                    Sent::Word((numbers, words)) => {
                        let known = |n: &i16| usize::try_from(*n).is_ok_and(|n| n < words.len());
                        let own = numbers.as_array().mapv(|n| if known(&n) { n } else { -1 }).to_vec();
                        Data::Word { numbers: own, words }
                    }
                };
                Named { name, unit, data }
            })
            .collect();
        let rows = columns.first().map_or(0, |column| column.data.len());
        if columns.iter().any(|column| column.data.len() != rows) {
            return Err(of_words(py, "columns of different lengths are no table"));
        }
        Ok(Self { rows, columns })
    }

    fn __len__(&self) -> usize {
        self.rows
    }

    /// The names of the columns.
    #[getter]
    fn names(&self) -> Vec<&str> {
        self.columns.iter().map(|column| &*column.name).collect()
    }

    /// The units of the columns; empty of words and plain numbers.
    #[getter]
    fn units(&self) -> Vec<&str> {
        self.columns.iter().map(|column| &*column.unit).collect()
    }

    /// One column.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Read<'py>> {
        let found = self.columns.iter().find(|column| column.name == name);
        let Some(column) = found else {
            let message = format!("\"{name}\" is none of {}", self.names().join(", "));
            return Err(PyKeyError::new_err(message));
        };
        Ok(match &column.data {
            Data::Number(values) => Read::Number(PyArray1::from_slice(py, values)),
            Data::Word { numbers, words } => Read::Word((PyArray1::from_slice(py, numbers), words.clone())),
        })
    }

    /// The table as a stream of Arrow, by its PyCapsule interface.
    #[pyo3(signature = (requested_schema=None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // Who reads may ask for another schema; the interface allows to answer with one's own.
        let _ = requested_schema;
        let batch = self.batch().map_err(of_fault)?;
        let schema = batch.schema();
        let reader = RecordBatchIterator::new([Ok(batch)], schema);
        PyCapsule::new_with_value(py, FFI_ArrowArrayStream::new(Box::new(reader)), c"arrow_array_stream")
    }
}
