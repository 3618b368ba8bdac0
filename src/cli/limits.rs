//! `fitcheck limits`: limits of size of one callout or of a stream of them.
//!
//! Answers one by one, so that memory stays the same however many callouts come.

pub(super) mod lines;

use std::fmt::Display;
use std::io::{BufRead, Write};

use lines::{Found, Line};

use super::{CliError, Figure, Format, Io, Note, Outcome, TableArgs, heard_or_not};
use crate::control::text::decode;
use crate::length::{Length, Unit};
use crate::tolerance::{Callout, Deviations, Feature, Limits, Source, Sources, Tolerance};

/// How much of a line that is too long is shown.
const SHOWN: usize = 40;

const EXAMPLES: &str = "\
Examples:
  fitcheck limits \"25 H7\"                        one callout, for people
  fitcheck limits \"25 H7\" \"25 g6\" --format csv   several, for a spreadsheet
  fitcheck limits - --format csv < callouts.txt  one callout a line, one answer a line
  fitcheck limits \"25 U1\" --tables my_tables     with your own control tables
  fitcheck limits \"25 H7/g6\" 10m \"12 ±0.02\"     a fit (hole, then shaft), ISO 2768-1, deviations

Columns of CSV and names in JSON: callout, nominal_mm, lower_um, upper_um, min_mm, max_mm, source, error.
A refused callout has no figures but a reason in error, and the exit code is 1.";

/// Show the limits of size of callouts such as "25 H7"
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// "25 H7", "25 H7/g6", "10m", "12 +0.01 -0.015", "12.01/11.985"; - reads one a line from standard input
    #[arg(value_name = "CALLOUT", required = true)]
    callouts: Vec<String>,

    /// How to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    #[command(flatten)]
    tables: TableArgs,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let Io { input, out, err } = io;
        let mut answers = Answers::new(&sources, self.format, &mut **out, &mut **err)?;
        for callout in &self.callouts {
            if callout == "-" {
                answers.answer_lines(&mut **input)?;
            } else {
                answers.answer(&printable(callout), None)?;
            }
        }
        answers.finish()
    }
}

/// Everything that is printed, in one of the three formats.
struct Answers<'a> {
    sources: &'a Sources,
    printer: Printer<'a>,
    err: &'a mut dyn Write,
    answered: usize,
    refused: usize,
}

enum Printer<'a> {
    Text(&'a mut dyn Write),
    // Boxed for its buffer.
    Csv(Box<csv::Writer<&'a mut dyn Write>>),
    Json(&'a mut dyn Write),
}

/// A line of CSV or an object of JSON.
#[derive(Debug, Default, serde::Serialize)]
struct Row<'a> {
    callout: &'a str,
    nominal_mm: Option<Figure>,
    lower_um: Option<Figure>,
    upper_um: Option<Figure>,
    min_mm: Option<Figure>,
    max_mm: Option<Figure>,
    source: Option<String>,
    error: Option<String>,
}

impl<'a> Row<'a> {
    fn of(callout: &'a str, limits: &Limits) -> Self {
        let mm = |length: Length, decimals| Some(Figure(length.exact(Unit::Millimetre, decimals)));
        let um = |length: Length| Some(Figure(length.exact(Unit::Micrometre, 0)));
        Self {
            callout,
            nominal_mm: mm(limits.nominal, 0),
            lower_um: um(limits.deviations.lower()),
            upper_um: um(limits.deviations.upper()),
            min_mm: mm(limits.minimum(), 3),
            max_mm: mm(limits.maximum(), 3),
            source: Some(source(&limits.source)),
            error: None,
        }
    }

    fn write_csv(&self, writer: &mut csv::Writer<&mut dyn Write>) -> Result<(), csv::Error> {
        let figure = |figure: &'_ Option<Figure>| figure.as_ref().map(|figure| figure.0.clone()).unwrap_or_default();
        writer.write_record([
            self.callout,
            &figure(&self.nominal_mm),
            &figure(&self.lower_um),
            &figure(&self.upper_um),
            &figure(&self.min_mm),
            &figure(&self.max_mm),
            self.source.as_deref().unwrap_or_default(),
            self.error.as_deref().unwrap_or_default(),
        ])
    }
}

/// Where the limits come from, and what the shipped table says where the user's says something else.
pub(super) fn source(source: &Source) -> String {
    match source {
        Source::Table { instead_of: Some(shipped), .. } => {
            format!("{source}, instead of {} µm in ISO 286", lower_and_upper(shipped))
        }
        _ => source.to_string(),
    }
}

/// `0 / +21`
pub(super) fn lower_and_upper(deviations: &Deviations) -> String {
    let signed = |length: Length| {
        let plus = if Length::ZERO < length { "+" } else { "" };
        format!("{plus}{}", length.exact(Unit::Micrometre, 0))
    };
    format!("{} / {}", signed(deviations.lower()), signed(deviations.upper()))
}

impl<'a> Answers<'a> {
    fn new(
        sources: &'a Sources,
        format: Format,
        out: &'a mut dyn Write,
        err: &'a mut dyn Write,
    ) -> Result<Self, CliError> {
        let printer = match format {
            Format::Text => Printer::Text(out),
            Format::Csv => {
                let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(out);
                let names = ["callout", "nominal_mm", "lower_um", "upper_um", "min_mm", "max_mm", "source", "error"];
                writer.write_record(names)?;
                Printer::Csv(Box::new(writer))
            }
            Format::Json => {
                out.write_all(b"[")?;
                Printer::Json(out)
            }
        };
        Ok(Self { sources, printer, err, answered: 0, refused: 0 })
    }

    /// Answers every line of the input. What is answered is out before the next wait for input, so that another
    /// program can ask line by line.
    fn answer_lines(&mut self, input: &mut dyn BufRead) -> Result<(), CliError> {
        let mut line = Line::default();
        for number in 1_usize.. {
            match line.read(input, || self.printer.flush())? {
                Found::End => break,
                Found::Whole => self.answer(&printable(&decode(&line.bytes)), Some(number))?,
                Found::TooLong => {
                    let beginning: String = printable(&decode(&line.bytes)).chars().take(SHOWN).collect();
                    self.refuse(&format!("{beginning}…"), &CliError::LineTooLong, Some(number))?;
                }
            }
        }
        Ok(())
    }

    fn answer(&mut self, callout: &str, line: Option<usize>) -> Result<(), CliError> {
        let callout = callout.trim();
        let parsed: Callout = match callout.parse() {
            Ok(parsed) => parsed,
            Err(error) => return self.refuse(callout, &error, line),
        };
        if !matches!(parsed.tolerance(), Tolerance::Fit { .. }) {
            return self.answer_part(callout, parsed, line);
        }
        // A fit is two sizes: the hole's answer, then the shaft's.
        for feature in [Feature::Hole, Feature::Shaft] {
            let part = parsed.of_part(feature);
            self.answer_part(&part.to_string(), part, line)?;
        }
        Ok(())
    }

    fn answer_part(&mut self, asked: &str, callout: Callout, line: Option<usize>) -> Result<(), CliError> {
        let limits = match self.sources.size_limits(&callout) {
            Ok(limits) => limits,
            Err(error) => return self.refuse(asked, &error, line),
        };
        match &mut self.printer {
            Printer::Text(out) => write_text(*out, &callout, &limits)?,
            printer => printer.row(self.answered, &Row::of(asked, &limits))?,
        }
        self.answered += 1;
        Ok(())
    }

    fn refuse(&mut self, callout: &str, error: &impl Display, line: Option<usize>) -> Result<(), CliError> {
        match &mut self.printer {
            Printer::Text(out) => {
                // What was answered before stands before it on a screen, too.
                out.flush()?;
                heard_or_not(match line {
                    Some(line) if callout.is_empty() => writeln!(self.err, "line {line}: {error}"),
                    _ if callout.is_empty() => writeln!(self.err, "\"\": {error}"),
                    _ => writeln!(self.err, "{callout}: {error}"),
                })?;
            }
            printer => {
                let row = Row { callout, error: Some(error.to_string()), ..Row::default() };
                printer.row(self.answered, &row)?;
            }
        }
        self.answered += 1;
        self.refused += 1;
        Ok(())
    }

    fn finish(self) -> Result<Outcome, CliError> {
        let is_text = matches!(self.printer, Printer::Text(_));
        self.printer.finish(self.answered)?;
        if self.refused == 0 {
            return Ok(Outcome::Done);
        }
        if !is_text {
            let note = Note::Refused { refused: self.refused, asked: self.answered };
            heard_or_not(writeln!(self.err, "{note}"))?;
        }
        Ok(Outcome::BadData)
    }
}

impl Printer<'_> {
    /// A line of CSV or an object of JSON; `before` counts those before it.
    fn row(&mut self, before: usize, row: &Row<'_>) -> Result<(), CliError> {
        match self {
            Self::Text(_) => {}
            Self::Csv(writer) => row.write_csv(writer)?,
            Self::Json(out) => {
                out.write_all(if before == 0 { b"\n  " } else { b",\n  " })?;
                serde_json::to_writer(&mut **out, row)?;
            }
        }
        Ok(())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        match self {
            Self::Text(out) | Self::Json(out) => out.flush(),
            Self::Csv(writer) => writer.flush(),
        }
    }

    fn finish(mut self, answered: usize) -> Result<(), CliError> {
        if let Self::Json(out) = &mut self {
            out.write_all(if answered == 0 { b"]\n" } else { b"\n]\n" })?;
        }
        Ok(self.flush()?)
    }
}

/// `25 H7   hole   25.000 … 25.021   mm   (0 / +21 µm)   from …`: the callout as it was understood.
fn write_text(out: &mut dyn Write, callout: &Callout, limits: &Limits) -> std::io::Result<()> {
    let mm = |length: Length| length.exact(Unit::Millimetre, 3);
    let (minimum, maximum) = (mm(limits.minimum()), mm(limits.maximum()));
    let range = format!("{minimum:>8} … {maximum} mm");
    let deviations = format!("({} µm)", lower_and_upper(&limits.deviations));
    let feature = callout.feature().map_or("–", Feature::word);
    let source = source(&limits.source);
    writeln!(out, "{callout:<10}  {feature:<5}  {range:<22}  {deviations:<18}  from {source}")
}

/// A text without control characters: it goes to a terminal, and one line of input stays one line of output.
pub(super) fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && c != '\t' { char::REPLACEMENT_CHARACTER } else { c }).collect()
}
