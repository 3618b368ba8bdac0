//! `fitcheck pair`: which measured holes go with which measured shafts.
//!
//! | file | what |
//! |---|---|
//! | `parts` | the measured parts of a file |
//! | `text` | the answer for people; `report::pairing` has it in figures |

mod parts;
mod text;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::args::one_of;
use super::io::Tame;
use super::{CliError, CliWarning, IntoCliError as _, Io, Outcome, TableArgs, put};
use crate::pairing::{MOST_AMOUNTS, MOST_GROUPS, PairClearances};
use crate::report::pairing::{FORMATS, Note, PairingAnswer, PairingRequest, column_names};
use crate::tolerance::fit::Fit;
use crate::tolerance::{Callout, Feature};
pub(super) use parts::read_parts;

/// Pair measured holes with measured shafts for a wanted clearance: selective assembly
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    /// File of measured holes, in any format that import reads; - reads standard input
    #[arg(value_name = "HOLES")]
    holes: PathBuf,

    /// File of measured shafts
    #[arg(value_name = "SHAFTS")]
    shafts: PathBuf,

    /// Wanted clearances in mm, both ends included, such as 0.010..0.030; a negative value is an interference
    #[arg(
        long,
        value_name = "MM..MM",
        allow_hyphen_values = true,
        required_unless_present = "fit",
        conflicts_with = "fit"
    )]
    clearance: Option<String>,

    /// Fit whose clearances are wanted, such as "25 H7/g6"
    #[arg(long, value_name = "CALLOUT")]
    fit: Option<String>,

    /// Also sort into N groups of equal width: over the measured sizes or, with --fit, over its zones
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1_000))]
    classes: Option<u16>,

    /// Format of the answer
    #[arg(long, default_value = "text", value_parser = one_of(formats(), |format| format.0))]
    format: (&'static str, Option<Written>),

    /// The file to write; - or no file is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,

    #[command(flatten)]
    tables: TableArgs,
}

/// What writes the answer; `None` for people.
type Written = &'static crate::report::pairing::Format;

fn formats() -> impl Iterator<Item = (&'static str, Option<Written>)> {
    std::iter::once(("text", None)).chain(FORMATS.iter().map(|format| (format.name, Some(format))))
}

fn help() -> String {
    format!(
        "\
Examples:
  fitcheck pair holes.csv shafts.csv --clearance 0.010..0.030
  fitcheck pair holes.csv shafts.csv --fit \"25 H7/g6\" --classes 5
  fitcheck pair holes.csv shafts.csv --clearance -0.020..-0.005 --format csv -o pairs.csv

The columns are found as fitcheck import finds them; only names and measured sizes are needed. A
callout only says hole or shaft, if it can be read: a shaft among the holes is refused. In a file
without a header, names must not be numbers, or the rows are read as contacts.

Fitcheck makes as many pairs as possible. Of all ways to do so, it takes the one with the least sum
of squared distances from the middle of the wanted clearances. Parts of equal size are taken in the
order of their file.

--classes: a size at the end of a group belongs to the next group; the last group includes both ends.
Clearances of a group are those that its measured parts can have. At most {MOST_GROUPS} groups.

Grinding may save leftover parts: amounts from 1 µm in steps of 1 µm, at most {MOST_AMOUNTS} µm, off
all leftover shafts or out of all leftover holes, which is the same. The answer gives the smallest
amount that makes the most additional pairs, chosen in the same way; existing pairs are kept.

CSV has a row per result (pair, leftover, grinding, saved, group, refused) and these columns:
{}.
JSON has the same names within pairs, leftover_holes, leftover_shafts, grinding, saved, groups and
refused, and also fit, holes, shafts, minimum_clearance_um and maximum_clearance_um as wanted,
actual (of the pairs, with band_um), holes_outside_groups, shafts_outside_groups and warnings. saved
are the pairs after grinding, with their new clearances.

Exit codes: 0 done, 1 if any row or file could not be used, 2 wrong usage.",
        column_names().join(", "),
    )
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let fit = self.fit(io)?;
        let wanted = match (&self.clearance, &fit) {
            (Some(text), _) => text.parse::<PairClearances>(),
            (None, Some((_, fit))) => PairClearances::new(fit.minimum_clearance(), fit.maximum_clearance()),
            // clap has refused it.
            (None, None) => "".parse(),
        };
        let wanted = wanted.said()?;
        super::io::warn_of_repeats(&[self.holes.clone(), self.shafts.clone()], io);
        for input in [&self.holes, &self.shafts] {
            self.not_the_output(input)?;
        }
        let holes = Arc::new(read_parts(&self.holes, Feature::Hole, io)?);
        let shafts = Arc::new(read_parts(&self.shafts, Feature::Shaft, io)?);
        let asked = PairingRequest { holes, shafts, wanted, fit, group_count: self.classes.map(usize::from) };
        let answer = asked.answer();
        let PairingRequest { holes, shafts, .. } = &answer.asked;
        for (parts, outside) in [holes, shafts].into_iter().zip(&answer.outside) {
            if let Some(outside) = outside {
                parts::tell(parts, &Note::of(outside), io);
            }
        }
        if let Some(Err(error)) = &answer.sorted {
            return Err(error.clone()).said();
        }
        self.print(&answer, io)?;
        let is_whole = holes.errors.is_empty() && shafts.errors.is_empty();
        Ok(if is_whole { Outcome::Done } else { Outcome::BadData })
    }

    /// The callout of `--fit` and its limits.
    fn fit(&self, io: &mut Io<'_>) -> Result<Option<(Callout, Fit)>, CliError> {
        let Some(text) = &self.fit else {
            if self.tables.is_given() {
                io.warn(&CliWarning::TablesNotUsed);
            }
            return Ok(None);
        };
        let sources = self.tables.load(io)?;
        let callout: Callout = text.parse().said()?;
        let fit = Fit::of_callout(&callout, &sources).said()?;
        Ok(Some((callout, fit)))
    }

    /// An answer never replaces what it was made from.
    fn not_the_output(&self, input: &Path) -> Result<(), CliError> {
        let Some(output) = &self.output else { return Ok(()) };
        if same_file::is_same_file(input, output).unwrap_or(false) {
            return Err(CliError::BatchOntoItself { path: output.clone() });
        }
        Ok(())
    }

    fn print(&self, answer: &PairingAnswer, io: &mut Io<'_>) -> Result<(), CliError> {
        let format = self.format.1;
        put(
            self.output.as_deref(),
            &mut |out| match format {
                Some(format) => (format.write)(answer, &mut &mut *out),
                None => text::write(answer, &mut Tame(out)),
            },
            io,
        )
    }
}
