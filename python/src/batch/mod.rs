//! Verdicts for the rows of a table of any length, from whatever speaks the C stream of Arrow: Polars, pandas, `DuckDB`, pyarrow.
//!
//! | file | what |
//! |---|---|
//! | here | the function, and the rows as Python has them |
//! | `cells` | the cells of a column in memory, as values with types |
//! | `stream` | rows judged as they are asked for |
//! | `answers` | the answers as columns |
//!
//! What a row means is in `fitcheck_exchange::exchange::batch`, which judges the rows of `fitcheck batch`, too.

mod answers;
mod cells;
mod stream;

use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Arc, Mutex, PoisonError};

use fitcheck_core::verdict::Status;
use fitcheck_exchange::exchange::batch::RowNoteKind;
use pyo3::prelude::*;
use pyo3::types::{PyCapsule, PyDict};
use pyo3_arrow::PyRecordBatchReader;
use pyo3_arrow::input::AnyRecordBatch;

use crate::check::status_of;
use crate::error::with_code;
use stream::{Judging, Named, Totals};

/// The rows of a table with their answers: a stream of Arrow, which is read once.
#[pyclass(frozen, module = "fitcheck")]
pub(crate) struct Rows {
    reader: Py<PyRecordBatchReader>,
    is_taken: AtomicBool,
    totals: Arc<Mutex<Totals>>,
    warnings: Vec<String>,
}

impl Rows {
    /// What is counted of all rows: of some of them it would look better than it is.
    fn of_all<T>(&self, of: impl FnOnce(&Totals) -> T) -> PyResult<T> {
        let totals = self.totals.lock().unwrap_or_else(PoisonError::into_inner);
        if totals.are_all {
            return Ok(of(&totals));
        }
        let text = "the rows were not read to their end: make a frame of them first, such as polars.DataFrame(rows)";
        Err(with_code(text.to_owned(), "python-rows-not-read"))
    }
}

#[pymethods]
impl Rows {
    fn __arrow_c_schema__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.reader.bind(py).call_method0("__arrow_c_schema__")
    }

    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Bound<'py, PyCapsule>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        if self.is_taken.swap(true, Relaxed) {
            let text =
                "the rows were read already, and are read once: ask batch() again, or keep the frame made of them";
            return Err(with_code(text.to_owned(), "python-rows-read"));
        }
        self.reader.bind(py).call_method1("__arrow_c_stream__", (requested_schema,))
    }

    #[getter]
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let counts = self.of_all(|totals| totals.counts)?;
        let dict = PyDict::new(py);
        for (status, count) in Status::ALL.into_iter().zip(counts) {
            dict.set_item(status_of(py, status)?, count)?;
        }
        Ok(dict)
    }

    #[getter]
    fn refused(&self) -> PyResult<u64> {
        self.of_all(|totals| totals.tally.notes(RowNoteKind::Refused).count)
    }

    #[getter]
    fn doubtful(&self) -> PyResult<u64> {
        self.of_all(|totals| totals.tally.notes(RowNoteKind::Doubt).count)
    }

    #[getter]
    fn notes(&self) -> PyResult<Vec<(usize, String)>> {
        self.of_all(|totals| {
            let of = |kind| totals.tally.notes(kind).first.iter().map(|note| (note.line, note.what.to_string()));
            RowNoteKind::ALL.into_iter().flat_map(of).collect()
        })
    }

    #[getter]
    fn simulated(&self) -> PyResult<u64> {
        self.of_all(|totals| totals.tally.simulated)
    }

    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }
}

/// Judges every row of a table, in its order, by the limits alone, as `fitcheck batch` does.
///
/// table: whatever speaks the C stream of Arrow, such as a frame of Polars or pandas, a table of pyarrow, a relation of DuckDB. Its
/// columns are found by their names in English, Dutch, German, Italian, French or Spanish and by their contents, or named by callout and measured.
/// Texts may have a decimal comma. All columns are given on without copies,
/// followed by min_mm, max_mm, deviation_um, status, remove_um, error and doubt, each behind the prefix. A row without a verdict
/// has the reason in error. Raises FitcheckError where nothing in the table can be judged, as without a column of callouts or limits.
#[pyfunction]
#[pyo3(signature = (table, *, callout = None, measured = None, prefix = ""))]
pub(crate) fn batch(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    callout: Option<&str>,
    measured: Option<&str>,
    prefix: &str,
) -> PyResult<Rows> {
    let table: AnyRecordBatch = table.extract().map_err(|error| {
        let kind = table.get_type();
        let allowed = "give a frame of Polars or pandas, a table of pyarrow, a relation of DuckDB, or what else has __arrow_c_stream__";
        with_code(format!("table: {kind} cannot be read as Arrow; {allowed} ({error})"), "python-table")
    })?;
    let rows = table.into_reader()?;
    let totals = Arc::new(Mutex::new(Totals::default()));
    let named = Named { callout, measured };
    let judging = Judging::new(rows, named, prefix, Arc::clone(&totals));
    let judging = judging.map_err(|reason| with_code(reason, "python-table"))?;
    let warnings = judging.warnings();
    let reader = Py::new(py, PyRecordBatchReader::new(Box::new(judging)))?;
    Ok(Rows { reader, is_taken: AtomicBool::new(false), totals, warnings })
}
