//! `fitcheck batch`: a verdict for every row of streams of any length.

mod judging;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(not(feature = "parquet"))]
#[path = "no_parquet.rs"]
#[expect(
    clippy::extra_unused_type_parameters,
    clippy::needless_pass_by_ref_mut,
    clippy::needless_pass_by_value,
    clippy::unused_self,
    reason = "the shape of the other, with nothing to do"
)]
mod parquet;
mod summary;

use std::borrow::Cow;
use std::ffi::OsStr;
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use super::args::one_of;
use super::import::columns;
use super::io::is_dash;
use super::progress::Work;
use super::{CliError, CliRemark, Io, Outcome, TableArgs};
use crate::batch::{self, Failed, Form, Input, Manner, Packing, Stream, Summary, Watch};
use crate::exchange::batch::{ADDED, BLOCK, Cutter, Layout, StreamJudging};
use crate::exchange::{ImportErrorKind, Mapping};
use crate::files;
use crate::message::Say as _;
use crate::tolerance::Sources;
use fitcheck_core::text::long;
use judging::{Rows, TextHeading, TextJudging};
use summary::BatchRemarks;

/// Judge every row of CSV or Parquet files of any length, in order
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    /// CSV or Parquet files with the same columns, one after the other; - is standard input
    #[arg(required = true, value_name = "FILE")]
    inputs: Vec<PathBuf>,

    /// File to write: .csv, .tsv, .jsonl or .parquet; .gz or .zst after it compresses text; - or no file is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    /// Format of the answers; default: by the ending of the output, or csv
    #[arg(long, value_parser = one_of(batch::FORMS.iter().map(|(form, ..)| *form), |form| form.name()))]
    format: Option<Form>,

    /// Word to put before the names of the added columns, if the input already has some of them
    #[arg(long, value_name = "WORD", default_value = "")]
    prefix: String,

    /// Number of processors to use; default: all, at most 8
    #[arg(short, long, value_name = "COUNT", value_parser = clap::value_parser!(u8).range(1..=64))]
    jobs: Option<u8>,

    /// What the columns hold, by number or name, such as measured=3,callout=Passung; or a .toml file with the same
    #[arg(long, value_name = "LIST|FILE")]
    columns: Option<String>,

    #[command(flatten)]
    tables: TableArgs,
}

fn help() -> String {
    format!(
        "\
Columns are found as by fitcheck import: by their names in English, Dutch, German, Italian, French or Spanish, by their content, or as --columns says. \
Every column is written unchanged, followed by these:

  {}

The limits alone decide, as on a control; for decision rules, use fitcheck import or report. \
A row without a verdict keeps its place, with the reason in the last column. Inputs compressed with gzip or \
Zstandard are decompressed. Programs built with the feature parquet read and write Parquet: its columns keep \
their types, and those of CSV become texts. The summary goes to standard error.

Examples:
  fitcheck batch bores.csv -o verdicts.csv
  fitcheck batch 2026-*.csv.gz -o 2026.csv.zst
  fitcheck batch bores.parquet -o verdicts.parquet
  zcat bores.csv.gz | fitcheck batch - --format jsonl | head

The exit code is that of the worst verdict; it is 1 if any row could not be judged, and 14 (judged, but look first: see \
fitcheck --help) instead of 0 or 10 if something contradicts a verdict.",
        ADDED.join(",")
    )
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let (form, packing) = self.form()?;
        super::io::warn_of_repeats(&self.inputs, io);
        for input in &self.inputs {
            self.not_the_output(input)?;
        }
        let mapping = self.columns.as_deref().map(columns::mapping).transpose()?;
        let job = Job { args: self, sources: &sources, form, packing, mapping };
        let mut result = Ok(Summary::default());
        if let Some(path) = self.file() {
            let (input, _, listener) = io.streams();
            let mut told = BatchRemarks::new(listener);
            let written = files::write_with(path, &mut |out| {
                result = job.all(input, out, &mut told);
                // What is not whole is not kept; the reason follows.
                if result.is_ok() { Ok(()) } else { Err(io::Error::other("not whole")) }
            });
            if result.is_ok() {
                written?;
                io.note(CliRemark::Wrote { path: path.display().to_string() });
            }
        } else {
            let (input, out, listener) = io.streams();
            result = job.all(input, out, &mut BatchRemarks::new(listener));
        }
        let summary = result?;
        summary::tell(&summary, io);
        Ok(summary::outcome(&summary))
    }

    /// The file to write; none for standard output.
    fn file(&self) -> Option<&PathBuf> {
        self.output.as_ref().filter(|path| !is_dash(path))
    }

    /// What is written, by `--format` and the output's ending.
    fn form(&self) -> Result<(Form, Packing), CliError> {
        let (form, packing) = self.named_form()?;
        match self.file() {
            Some(path) if form == Form::Parquet && packing != Packing::Plain => {
                Err(CliError::BatchPacked { path: path.clone() })
            }
            _ if form == Form::Parquet && !parquet::IS_KNOWN => {
                Err(CliError::Said(ImportErrorKind::ParquetUnknown.message()))
            }
            _ => Ok((form, packing)),
        }
    }

    fn named_form(&self) -> Result<(Form, Packing), CliError> {
        let Some(path) = self.file() else { return Ok((self.format.unwrap_or(Form::Csv), Packing::Plain)) };
        let (packing, name) = Packing::of_name(path);
        let ending = name.extension().map_or(Cow::Borrowed(""), OsStr::to_string_lossy);
        let known = Form::of_ending(&ending);
        match (self.format, known) {
            (Some(form), Some(other)) if form != other => {
                Err(CliError::ReportFormat { format: form.name(), file: path.clone() })
            }
            (Some(form), _) | (None, Some(form)) => Ok((form, packing)),
            // A device has no ending.
            (None, None) if path.extension().is_none() => Ok((Form::Csv, packing)),
            (None, None) => {
                let endings: Vec<&str> =
                    batch::FORMS.iter().flat_map(|(.., endings)| endings.iter().copied()).collect();
                Err(CliError::BatchEnding { path: path.clone(), endings: endings.join(", .") })
            }
        }
    }

    /// An output is never one of its own inputs: with a shell's `>` the input would be empty already.
    fn not_the_output(&self, input: &Path) -> Result<(), CliError> {
        let input =
            if input.as_os_str() == "-" { same_file::Handle::stdin() } else { same_file::Handle::from_path(input) };
        let output = match self.file() {
            Some(path) => same_file::Handle::from_path(path),
            None => same_file::Handle::stdout(),
        };
        match (input, output) {
            (Ok(input), Ok(output)) if input == output && is_file(&input) => {
                Err(CliError::BatchOntoItself { path: self.output.clone().unwrap_or_else(|| PathBuf::from("-")) })
            }
            _ => Ok(()),
        }
    }
}

/// Terminals and pipes can be read and written at the same time.
fn is_file(handle: &same_file::Handle) -> bool {
    handle.as_file().metadata().is_ok_and(|metadata| metadata.is_file())
}

/// What all inputs have in common.
struct Job<'a> {
    args: &'a Args,
    sources: &'a Sources,
    form: Form,
    packing: Packing,
    /// What is said of the columns.
    mapping: Option<Mapping>,
}

/// An input that can be read.
struct Opened<'a> {
    name: String,
    path: &'a Path,
    from: From<'a>,
    layout: Layout,
    /// The declarations of columns with types.
    types: Vec<String>,
    /// How many bytes the file has; `None` for pipes.
    size: Option<u64>,
}

/// Where rows come from.
enum From<'a> {
    Text(Stream<'a>),
    Parquet(parquet::File),
}

/// Where the answers go.
enum Answers<'o> {
    Text(&'o mut (dyn Write + Send)),
    Parquet(Box<parquet::Writer<'o>>),
}

/// How much CSV becomes a row group of Parquet, 4 MiB: about as many rows as engines make row groups of.
const GROUP: usize = 4 << 20;

impl Job<'_> {
    /// Judges all inputs, one after the other, into one output.
    fn all(
        &self,
        input: &mut (dyn Read + Send),
        out: &mut (dyn Write + Send),
        told: &mut BatchRemarks<'_>,
    ) -> Result<Summary, CliError> {
        let mut first = None;
        // Before anything is written; a pipe can be looked at only once.
        for path in self.args.inputs.iter().filter(|path| path.as_os_str() != "-" && path.is_file()) {
            self.same_columns(&self.open(path, &mut *input)?, &mut first)?;
        }
        let mut summary = Summary::default();
        let mut out = Some(out);
        let mut answers = None;
        for path in &self.args.inputs {
            let opened = self.open(path, &mut *input)?;
            self.same_columns(&opened, &mut first)?;
            if let From::Text(Stream { is_utf16: true, .. }) = &opened.from {
                told.remark(&CliRemark::BatchUtf16 { name: opened.name.clone() });
            }
            if let From::Parquet(file) = &opened.from {
                let floats = parquet::floats(file, &opened.layout);
                if !floats.is_empty() {
                    let columns = floats.join(", ");
                    told.remark(&CliRemark::BatchFloats { name: opened.name.clone(), columns });
                }
            }
            if let Some(out) = out.take() {
                answers = Some(self.begin(&opened, out)?);
            } else if let Some(Answers::Text(out)) = &mut answers {
                self.above(&opened.layout, false, &mut **out)?;
            }
            if let Some(answers) = &mut answers {
                summary.append(self.one(opened, answers, told)?);
            }
        }
        if let Some(Answers::Parquet(writer)) = answers {
            writer.finish().map_err(|error| self.not_written(error))?;
        }
        Ok(summary)
    }

    /// What stands before all answers: the first input says which columns there are.
    fn begin<'o>(&self, opened: &Opened<'_>, out: &'o mut (dyn Write + Send)) -> Result<Answers<'o>, CliError> {
        if self.above(&opened.layout, true, &mut *out)? {
            return Ok(Answers::Text(out));
        }
        let file = if let From::Parquet(file) = &opened.from { Some(file) } else { None };
        let writer = parquet::Writer::new(out, &opened.layout, file, &self.args.prefix);
        Ok(Answers::Parquet(Box::new(writer.map_err(|error| self.not_written(error))?)))
    }

    /// Writes what stands above the rows of an input; `false` where the form is not text.
    fn above(&self, layout: &Layout, is_first: bool, out: &mut (dyn Write + Send)) -> io::Result<bool> {
        let above = TextHeading { layout, manner: self.manner(), is_first, out };
        self.form.with_rendering(above).map_or(Ok(false), |written| written.map(|()| true))
    }

    fn manner(&self) -> Manner<'_> {
        let workers = self.args.jobs.map_or_else(batch::workers, usize::from);
        Manner { workers, packing: self.packing, prefix: &self.args.prefix }
    }

    /// Looks at the beginning of an input until its columns are known.
    fn open<'i>(&self, path: &'i Path, input: &'i mut (dyn Read + Send)) -> Result<Opened<'i>, CliError> {
        let is_standard = path.as_os_str() == "-";
        let name = if is_standard { "standard input".to_owned() } else { path.display().to_string() };
        let failed = |error: io::Error| CliError::from(files::system(path, &error));
        let (raw, size): (Box<dyn Read + Send + 'i>, _) = if is_standard {
            (Box::new(input), None)
        } else {
            let (file, size) = files::open(path)?;
            (Box::new(file), size)
        };
        let is_patient = size.is_some();
        let mut stream = Stream::of(raw).map_err(failed)?;
        if stream.is_parquet {
            drop(stream);
            let opened = match size {
                Some(_) => parquet::open(files::open(path)?.0),
                None => Err(ImportErrorKind::ParquetStream),
            };
            return match opened {
                Ok((file, layout)) => {
                    let types = parquet::types(&file);
                    Ok(Opened { name, path, from: From::Parquet(file), layout, types, size })
                }
                Err(error) => Err(CliError::BatchInput { name, error: error.to_string() }),
            };
        }
        match stream.mapped(is_patient, &name, self.mapping.as_ref()).map_err(failed)? {
            Ok(layout) => Ok(Opened { name, path, from: From::Text(stream), layout, types: Vec::new(), size }),
            Err(error) => Err(CliError::BatchInput { name, error: error.to_string() }),
        }
    }

    /// All inputs have the columns of the first one, and none under the name of an added one.
    fn same_columns(&self, opened: &Opened<'_>, first: &mut Option<First>) -> Result<(), CliError> {
        let name = &opened.name;
        let names = &opened.layout.names;
        // Only CSV has a place for the mark.
        if opened.layout.are_simulated() && self.form != Form::Csv {
            return Err(CliError::BatchSimulated { name: name.clone() });
        }
        let prefix = self.args.prefix.as_str();
        let is_added = |name: &&String| name.strip_prefix(prefix).is_some_and(|name| ADDED.contains(&name));
        if let Some(column) = names.iter().find(is_added) {
            return Err(CliError::BatchName { name: name.clone(), column: column.clone() });
        }
        let twice = (1..).zip(names).find(|(after, name)| names.iter().skip(*after).any(|other| other == *name));
        if let (true, Some((_, column))) = (self.form.finds_by_name(), twice) {
            return Err(CliError::BatchTwice { name: name.clone(), column: column.clone() });
        }
        let separator = opened.layout.separator();
        let new = || First { names: names.clone(), separator, types: opened.types.clone() };
        let first = first.get_or_insert_with(new);
        if first.names != *names {
            return Err(CliError::BatchColumns { name: name.clone(), columns: first.names.join(", ") });
        }
        if self.form.keeps_separators() && first.separator != separator {
            return Err(CliError::BatchSeparator { name: name.clone() });
        }
        let differs = (0..names.len()).find(|&at| first.types.get(at) != opened.types.get(at));
        if let (true, Some(column)) = (self.form.keeps_types(), differs.and_then(|at| names.get(at))) {
            return Err(CliError::BatchTypes { name: name.clone(), column: column.clone() });
        }
        Ok(())
    }

    /// Judges the rows of one input.
    fn one(
        &self,
        opened: Opened<'_>,
        answers: &mut Answers<'_>,
        told: &mut BatchRemarks<'_>,
    ) -> Result<Summary, CliError> {
        let Opened { name, path, from, layout, size, .. } = opened;
        for (line, warning) in &layout.warnings {
            told.warning(&name, *line, warning);
        }
        let court = StreamJudging::new(&layout, self.sources);
        let is_packed = matches!(&from, From::Text(stream) if stream.packing != Packing::Plain);
        let work = Work::on(&name, size.filter(|_| !is_packed));
        let manner = self.manner();
        let watch = Watch::default();
        let mut tick = |watch: &Watch| work.follow(watch);
        let mut input;
        let rows = match from {
            From::Text(stream) => {
                let mut head = io::Cursor::new(stream.head);
                head.set_position(long(layout.skip));
                input = head.chain(stream.input);
                let (step, is_patient) = match answers {
                    Answers::Text(_) => (BLOCK, size.is_some()),
                    Answers::Parquet(_) => (GROUP, true),
                };
                Rows::Text(Input { stream: &mut input, cutter: Cutter::new(layout.separator(), step, is_patient) })
            }
            From::Parquet(file) => Rows::Parquet(file),
        };
        let summary = match answers {
            Answers::Text(out) => {
                let judging =
                    TextJudging { rows, court: &court, manner, out: &mut **out, watch: &watch, tick: &mut tick };
                let no_text = || Err(Failed::Writing(io::ErrorKind::Unsupported.into()));
                self.form.with_rendering(judging).unwrap_or_else(no_text)
            }
            Answers::Parquet(writer) => match rows {
                Rows::Text(input) => writer.add_text(input, &court, manner.workers, &watch, &mut tick),
                Rows::Parquet(file) => writer.add(file, &court, manner.workers, &watch, &mut tick),
            },
        };
        if work.is_stopped() {
            work.follow(&watch);
            return Err(CliError::Stopped { rows: work.rows() });
        }
        drop(work);
        match summary {
            Ok(mut summary) => {
                summary.tally.not_utf8 += u64::from(!layout.is_utf8);
                told.notes(&name, layout.line, &summary.tally);
                Ok(summary)
            }
            Err(Failed::Reading(error)) => Err(files::system(path, &error).into()),
            Err(Failed::Writing(error)) => Err(self.not_written(error)),
        }
    }

    fn not_written(&self, error: io::Error) -> CliError {
        match &self.args.output {
            Some(path) => files::system(path, &error).into(),
            None => CliError::Stream(error),
        }
    }
}

/// The columns of the first input.
struct First {
    names: Vec<String>,
    separator: u8,
    types: Vec<String>,
}
