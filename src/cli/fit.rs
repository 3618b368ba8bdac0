//! `fitcheck fit`: a hole against a shaft, and the way back from a clearance to classes.
//!
//! | file | what |
//! |---|---|
//! | `answer` | what there is to say about one fit |
//! | `figures`, `columns` | the same in figures: the names that CSV and JSON share |
//! | `text` | the same for people |
//! | `heat` | materials and temperatures |
//! | `reverse` | from a wanted clearance or a function to classes |
//!
//! Callouts are answered one by one, so that memory stays the same however many come.

mod answer;
mod columns;
mod figures;
mod heat;
mod reverse;
mod text;

use std::fmt::Display;
use std::io::{BufRead, ErrorKind};

use answer::{Answer, Measured};
use columns::COLUMNS;
use figures::Figures;

use super::limits::lines::{Found, Line};
use super::limits::printable;
use super::{CliError, Format, Io, Note, Outcome, Refused as _, TableArgs, What, diameter};
use crate::control::text::decode;
use crate::length::Length;
use crate::tolerance::{Feature, Sources};
use crate::verdict::{Status, doubt};

/// How much of a line that is too long is shown.
const SHOWN: usize = 40;

const HELP: &str = "\
Examples:
  fitcheck fit \"50 H7/p6\"                                 clearance, kind, basis, other basis
  fitcheck fit \"50 H7/p6\" --hole 50.010 --shaft 50.030    two measured parts, or one alone
  fitcheck fit \"50 H7/p6\" --hole-material brass --shaft-material steel --temperature 80
  fitcheck fit \"50 H7/p6\" --hole-material steel --shaft-material steel --hole-temperature 220
  fitcheck fit 25 --min-clearance 0.007 --max-clearance 0.041     classes for a clearance
  fitcheck fit 25 --function sliding --format json
  fitcheck fit - --format csv < fits.txt                  one fit a line

A clearance is hole minus shaft; a negative one is an interference. Measured diameters are those
at 20 °C.

JSON of one fit is an object, of several or of - an array:
  callout, nominal_mm, kind (clearance, transition, interference), minimum_clearance_um,
    maximum_clearance_um, mean_clearance_um, basis (hole, shaft, both),
    preferred (hole basis, shaft basis), function, error
  hole, shaft   class, min_mm, max_mm, lower_um, upper_um, source
  equivalent    the fit in the other basis: callout, exact, minimum_clearance_um,
                maximum_clearance_um, error
  actual        two measured parts: hole_mm, shaft_mm, clearance_um, conforms, hole_status,
                shaft_status, hole_remove_um, shaft_remove_um
  possible      one measured part: feature, measured_mm, status, remove_um,
                minimum_clearance_um, maximum_clearance_um
  temperature   hole_c, shaft_c, change_um, minimum_clearance_um, maximum_clearance_um, kind,
                actual_clearance_um, hole_material and shaft_material with name,
                expansion_um_per_m_k, certainty, source
JSON of a search:
  nominal_mm, minimum_clearance_um, maximum_clearance_um, scope, function, total
  candidates    callout, hole, shaft, kind, minimum_clearance_um, maximum_clearance_um, basis,
                preferred, function
  nearest       where nothing fits: candidate, below_um, above_um
What there is not is null. CSV has the same names, joined with _ where one lies within another.

Exit codes: the worse of the measured parts, 0 good, 10 rework, 11 scrap; 1 bad data, 2 wrong
usage. A search that finds nothing names the nearest miss and ends with 0.";

/// Show what a hole and a shaft such as "25 H7/g6" do to each other, or find classes for a clearance
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(super) struct Args {
    /// "25 H7/g6"; - reads one a line from standard input; for a search the nominal size alone, "25"
    #[arg(value_name = "CALLOUT|SIZE", required = true, allow_negative_numbers = true)]
    callouts: Vec<String>,

    /// The hole's measured diameter in mm
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    hole: Option<String>,

    /// The shaft's measured diameter in mm
    #[arg(long, value_name = "MM", allow_hyphen_values = true)]
    shaft: Option<String>,

    #[command(flatten)]
    heat: heat::HeatArgs,

    #[command(flatten)]
    reverse: reverse::ReverseArgs,

    /// How to print
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    #[command(flatten)]
    tables: TableArgs,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        if self.reverse.is_asked() {
            if self.hole.is_some() || self.shaft.is_some() || self.heat.is_asked() {
                return Err(CliError::SearchWithParts);
            }
            return self.reverse.run(&self.callouts, &sources, self.format, io);
        }
        let part = |text: &Option<String>, what| text.as_ref().map(|text| diameter(text, what)).transpose();
        let measured =
            Parts { hole: part(&self.hole, What::MeasuredHole)?, shaft: part(&self.shaft, What::MeasuredShaft)? };
        let is_one = matches!(self.callouts.as_slice(), [one] if one != "-");
        if !is_one && (measured.hole.is_some() || measured.shaft.is_some()) {
            return Err(CliError::PartsOfSeveral);
        }
        let asked = Asked { sources: &sources, heat: self.heat.load()?, measured };
        let mut printer = Printer::new(self.format, is_one);
        match (self.answer(&asked, &mut printer, io), printer.worst) {
            // Nobody listens, but the verdict stands.
            (Err(CliError::Stream(error)), Some(worst)) if error.kind() == ErrorKind::BrokenPipe => {
                Ok(Outcome::Judged(worst))
            }
            (outcome, _) => outcome,
        }
    }

    fn answer(&self, asked: &Asked<'_>, printer: &mut Printer, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        printer.begin(io)?;
        for callout in &self.callouts {
            if callout == "-" {
                answer_lines(asked, printer, io)?;
            } else {
                printer.answer(asked, &printable(callout), None, io)?;
            }
        }
        printer.finish(io)
    }
}

/// The measured diameters.
#[derive(Debug, Clone, Copy)]
struct Parts {
    hole: Option<Length>,
    shaft: Option<Length>,
}

/// What is asked about every callout.
struct Asked<'a> {
    sources: &'a Sources,
    heat: Option<heat::Heat>,
    measured: Parts,
}

impl Asked<'_> {
    fn answer(&self, callout: &str) -> Result<Answer<'_>, CliError> {
        Answer::of(callout.parse().said()?, self).said()
    }
}

/// Answers every line of the input; what is answered is out before the next wait for input.
fn answer_lines(asked: &Asked<'_>, printer: &mut Printer, io: &mut Io<'_>) -> Result<(), CliError> {
    let mut line = Line::default();
    for number in 1_usize.. {
        let (input, out): (&mut dyn BufRead, _) = (&mut *io.input, &mut *io.out);
        match line.read(input, || out.flush())? {
            Found::End => break,
            Found::Whole => printer.answer(asked, &printable(&decode(&line.bytes)), Some(number), io)?,
            Found::TooLong => {
                let beginning: String = printable(&decode(&line.bytes)).chars().take(SHOWN).collect();
                printer.refuse(&format!("{beginning}…"), &CliError::LineTooLong, Some(number), io)?;
            }
        }
    }
    Ok(())
}

/// Prints answers in one of the three formats and remembers how they ended.
struct Printer {
    format: Format,
    is_one: bool,
    answered: usize,
    refused: usize,
    /// The worst status of measured parts.
    worst: Option<Status>,
}

impl Printer {
    const fn new(format: Format, is_one: bool) -> Self {
        Self { format, is_one, answered: 0, refused: 0, worst: None }
    }

    fn begin(&self, io: &mut Io<'_>) -> Result<(), CliError> {
        match self.format {
            Format::Csv => csv_line(COLUMNS, io),
            Format::Json if !self.is_one => Ok(io.out.write_all(b"[")?),
            Format::Json | Format::Text => Ok(()),
        }
    }

    fn answer(
        &mut self,
        asked: &Asked<'_>,
        callout: &str,
        line: Option<usize>,
        io: &mut Io<'_>,
    ) -> Result<(), CliError> {
        let callout = callout.trim();
        let answer = match asked.answer(callout) {
            Ok(answer) => answer,
            Err(error) => return self.refuse(callout, &error, line, io),
        };
        self.worst = self.worst.max(answer.measured.status());
        warn(&answer, io)?;
        match self.format {
            Format::Text => {
                if 0 < self.answered {
                    writeln!(io.out)?;
                }
                text::write(io.out, &answer)?;
            }
            Format::Csv | Format::Json => self.row(&Figures::of(callout, &answer), io)?,
        }
        self.answered += 1;
        Ok(())
    }

    fn refuse(
        &mut self,
        callout: &str,
        error: &impl Display,
        line: Option<usize>,
        io: &mut Io<'_>,
    ) -> Result<(), CliError> {
        if self.format == Format::Text {
            // What was answered before stands before it on a screen, too.
            io.out.flush()?;
            match line {
                Some(line) if callout.is_empty() => io.tell(format_args!("line {line}: {error}"))?,
                _ if callout.is_empty() => io.tell(format_args!("\"\": {error}"))?,
                _ => io.tell(format_args!("{callout}: {error}"))?,
            }
        } else {
            self.row(&Figures::refused(callout, error.to_string()), io)?;
        }
        self.answered += 1;
        self.refused += 1;
        Ok(())
    }

    /// A line of CSV or an object of JSON.
    fn row(&self, figures: &Figures<'_>, io: &mut Io<'_>) -> Result<(), CliError> {
        if self.format == Format::Csv {
            return csv_line(figures.columns(), io);
        }
        if self.is_one {
            serde_json::to_writer_pretty(&mut *io.out, figures)?;
            return Ok(writeln!(io.out)?);
        }
        io.out.write_all(if self.answered == 0 { b"\n  " } else { b",\n  " })?;
        Ok(serde_json::to_writer(&mut *io.out, figures)?)
    }

    fn finish(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        if self.format == Format::Json && !self.is_one {
            io.out.write_all(if self.answered == 0 { b"]\n" } else { b"\n]\n" })?;
        }
        io.out.flush()?;
        if self.refused == 0 {
            return Ok(self.worst.map_or(Outcome::Done, Outcome::Judged));
        }
        if self.format != Format::Text {
            io.tell(Note::Refused { refused: self.refused, asked: self.answered })?;
        }
        Ok(Outcome::BadData)
    }
}

/// What is odd about a measured diameter.
fn warn(answer: &Answer<'_>, io: &mut Io<'_>) -> Result<(), CliError> {
    let (hole, shaft) = match answer.measured {
        Measured::None => (None, None),
        Measured::One(part) if part.feature == Feature::Hole => (Some(part.measured), None),
        Measured::One(part) => (None, Some(part.measured)),
        Measured::Both(actual) => (Some(actual.hole), Some(actual.shaft)),
    };
    for (name, measured) in [(What::Hole, hole), (What::Shaft, shaft)] {
        if let Some(doubt) = measured.and_then(|measured| doubt(answer.fit.nominal(), measured)) {
            io.warn_about(&name, &doubt)?;
        }
    }
    Ok(())
}

fn csv_line<T: AsRef<[u8]>>(cells: impl IntoIterator<Item = T>, io: &mut Io<'_>) -> Result<(), CliError> {
    // Into memory first: the writer's own flush would reach the stream line by line.
    let mut writer = csv::WriterBuilder::new().buffer_capacity(1 << 10).from_writer(Vec::new());
    writer.write_record(cells)?;
    let line = writer.into_inner().map_err(csv::IntoInnerError::into_error)?;
    Ok(io.out.write_all(&line)?)
}
