//! Rows judged as they are asked for: some at a time by several threads, given out in their order.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use arrow_array::{RecordBatch, RecordBatchReader};
use arrow_schema::{ArrowError, Field, Schema, SchemaRef};
use fitcheck_exchange::exchange::batch::{Layout, StreamJudging, Tally, TypedBlock};
use pyo3::Python;

use super::answers::{Answers, fields};
use super::cells::{Cells, is_nested, is_text};
use crate::limits::SOURCES;

/// How many rows a thread judges at a time.
const PORTION: usize = 1 << 16;
/// How many rows decide what the columns are, as in files.
const SAMPLE: usize = 200;

/// What the rows so far had.
#[derive(Debug, Default)]
pub(super) struct Totals {
    pub(super) tally: Tally,
    /// In the order of `Status::ALL`.
    pub(super) counts: [u64; 5],
    /// Whether these are all rows.
    pub(super) are_all: bool,
}

/// The rows of a table with their answers.
pub(super) struct Judging {
    rows: Box<dyn RecordBatchReader + Send>,
    layout: Layout,
    /// Whether the judge reads a column.
    needed: Vec<bool>,
    schema: SchemaRef,
    /// What was read and is not judged yet.
    read: VecDeque<RecordBatch>,
    /// What was judged and is not given out yet.
    judged: VecDeque<RecordBatch>,
    threads: usize,
    /// After an error there are no more rows, and counts of all rows never.
    has_failed: bool,
    totals: Arc<Mutex<Totals>>,
}

/// Which columns hold what, where their names do not say it.
#[derive(Debug, Default, Clone, Copy)]
pub(super) struct Named<'a> {
    pub(super) callout: Option<&'a str>,
    pub(super) measured: Option<&'a str>,
}

impl Named<'_> {
    /// The names of the columns as they are looked for.
    fn names(&self, schema: &Schema) -> Result<Vec<String>, String> {
        let given: Vec<String> = schema.fields().iter().map(|field| field.name().clone()).collect();
        let mut names = given.clone();
        for (role, name) in [("callout", self.callout), ("measured", self.measured)] {
            let Some(name) = name else { continue };
            let mut places = (0..).zip(&given).filter(|(_, own)| *own == name).map(|(at, _): (usize, _)| at);
            match (places.next(), places.next()) {
                (Some(at), None) => names.splice(at..=at, [role.to_owned()]).for_each(drop),
                (None, _) => {
                    return Err(format!(
                        "{role}: the table has no column {name:?}; its columns are {}",
                        given.join(", ")
                    ));
                }
                (Some(_), Some(_)) => return Err(format!("{role}: the table has several columns {name:?}")),
            }
        }
        Ok(names)
    }
}

impl Judging {
    /// For the rows of a table.
    ///
    /// # Errors
    /// Why nothing in it can be judged.
    pub(super) fn new(
        mut rows: Box<dyn RecordBatchReader + Send>,
        columns: Named<'_>,
        prefix: &str,
        totals: Arc<Mutex<Totals>>,
    ) -> Result<Self, String> {
        let input = rows.schema();
        let names = columns.names(&input)?;
        let added = fields(prefix);
        if let Some(taken) = added.iter().find(|field| input.column_with_name(field.name()).is_some()) {
            return Err(format!(
                "the table has a column {} already; give prefix= for the names of the answers",
                taken.name()
            ));
        }
        let mut read = VecDeque::new();
        let mut block = TypedBlock::default();
        block.clear();
        let mut missing = SAMPLE;
        while 0 < missing {
            let Some(batch) = rows.next() else { break };
            let batch = batch.map_err(|error| error.to_string())?;
            let some = batch.slice(0, missing.min(batch.num_rows()));
            put(&some, &vec![true; some.num_columns()], &mut block, |_full| {});
            missing -= some.num_rows();
            read.push_back(batch);
        }
        let advice =
            || format!("the columns are {}: name those that count by callout= and measured=", names.join(", "));
        let layout = block.layout(names.clone()).map_err(|error| format!("{error}; {}", advice()))?;
        if !layout.has_limits() {
            let unnamed =
                layout.callouts_unnamed().map(|column| format!("; column {column} looks as if it had callouts"));
            let known = "no column is known to have callouts or limits".to_owned();
            return Err(known + unnamed.as_deref().unwrap_or("") + "; " + &advice());
        }
        let needed: Vec<bool> =
            (0..).zip(input.fields()).map(|(at, field)| layout.needs(at, is_text(field.data_type()))).collect();
        let nested =
            needed.iter().zip(input.fields()).find(|(is_needed, field)| **is_needed && is_nested(field.data_type()));
        if let Some((_, field)) = nested {
            return Err(format!(
                "column {}: {} is no type of a callout or a measured value",
                field.name(),
                field.data_type()
            ));
        }
        let all: Vec<Arc<Field>> = input.fields().iter().cloned().chain(added.into_iter().map(Arc::new)).collect();
        let schema = Arc::new(Schema::new_with_metadata(all, input.metadata().clone()));
        let threads = thread::available_parallelism().map_or(1, usize::from).min(8);
        Ok(Self { rows, layout, needed, schema, read, judged: VecDeque::new(), threads, has_failed: false, totals })
    }

    /// What is to be said of the columns.
    pub(super) fn warnings(&self) -> Vec<String> {
        self.layout.warnings.iter().map(|(_, warning)| warning.to_string()).collect()
    }

    /// The next rows for one thread; `None` at the end.
    fn portion(&mut self) -> Result<Option<RecordBatch>, ArrowError> {
        loop {
            let batch = match self.read.pop_front() {
                Some(batch) => batch,
                None => match self.rows.next() {
                    Some(batch) => batch?,
                    None => return Ok(None),
                },
            };
            let rows = batch.num_rows();
            if rows == 0 {
                continue;
            }
            if PORTION < rows {
                self.read.push_front(batch.slice(PORTION, rows - PORTION));
                return Ok(Some(batch.slice(0, PORTION)));
            }
            return Ok(Some(batch));
        }
    }

    /// Judges the next rows, as many as there are threads for.
    fn round(&mut self) -> Result<(), ArrowError> {
        let mut portions = Vec::new();
        while portions.len() < self.threads {
            match self.portion()? {
                Some(portion) => portions.push(portion),
                None => break,
            }
        }
        let court = StreamJudging::new(&self.layout, &SOURCES);
        let judge = |portion: &RecordBatch| judged(portion, &court, &self.needed, &self.schema);
        let all: Vec<_> = match portions.as_slice() {
            [] => return Ok(()),
            [one] => vec![judge(one)],
            several => thread::scope(|scope| {
                let judging: Vec<_> = several.iter().map(|portion| scope.spawn(|| judge(portion))).collect();
                judging
                    .into_iter()
                    .map(|one| one.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
                    .collect()
            }),
        };
        let mut totals = self.totals.lock().unwrap_or_else(PoisonError::into_inner);
        for one in all {
            let (batch, tally, counts) = one?;
            totals.tally.add(tally);
            for (total, count) in totals.counts.iter_mut().zip(counts) {
                *total += count;
            }
            self.judged.push_back(batch);
        }
        Ok(())
    }
}

impl Iterator for Judging {
    type Item = Result<RecordBatch, ArrowError>;

    fn next(&mut self) -> Option<Self::Item> {
        if self.has_failed {
            return None;
        }
        if self.judged.is_empty() {
            // Whoever asks may hold the interpreter: others go on with it meanwhile.
            let mut round = || self.round();
            let done = Python::try_attach(|py| py.detach(&mut round)).unwrap_or_else(round);
            if let Err(error) = done {
                self.has_failed = true;
                return Some(Err(error));
            }
        }
        let next = self.judged.pop_front();
        if next.is_none() {
            self.totals.lock().unwrap_or_else(PoisonError::into_inner).are_all = true;
        }
        next.map(Ok)
    }
}

impl RecordBatchReader for Judging {
    fn schema(&self) -> SchemaRef {
        Arc::clone(&self.schema)
    }
}

type Portion = (RecordBatch, Tally, [u64; 5]);

/// Some rows with their answers.
fn judged(
    rows: &RecordBatch,
    court: &StreamJudging<'_>,
    needed: &[bool],
    schema: &SchemaRef,
) -> Result<Portion, ArrowError> {
    let mut judge = court.judge();
    let mut answers = Answers::new(rows.num_rows());
    let mut tally = Tally::default();
    let mut block = TypedBlock::default();
    block.clear();
    put(rows, needed, &mut block, |full| {
        tally.add(full.judge(&mut judge, &mut answers));
        full.clear();
    });
    tally.add(block.judge(&mut judge, &mut answers));
    if answers.rows() != rows.num_rows() {
        return Err(ArrowError::ComputeError("a row without an answer".to_owned()));
    }
    let met = judge.met();
    let mut counts = met.others;
    for (_, of_class) in &met.by_class {
        for (total, count) in counts.iter_mut().zip(of_class) {
            *total += count;
        }
    }
    let columns = rows.columns().iter().cloned().chain(answers.columns()?).collect();
    Ok((RecordBatch::try_new(Arc::clone(schema), columns)?, tally, counts))
}

/// Adds rows to a block; whenever it is full, `full` judges and clears it.
fn put(rows: &RecordBatch, needed: &[bool], block: &mut TypedBlock, mut full: impl FnMut(&mut TypedBlock)) {
    let cells = |(column, is_needed): (&_, &bool)| (Cells::of(column, *is_needed), *is_needed);
    let columns: Vec<_> = rows.columns().iter().zip(needed).map(cells).collect();
    for row in 0..rows.num_rows() {
        for (cells, is_needed) in &columns {
            block.cell(cells.get(row), *is_needed);
        }
        block.end_row();
        if block.is_full() {
            full(block);
        }
    }
}
