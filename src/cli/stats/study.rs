//! `--study` and `--compare`: a gauge, or groups, instead of the process.

use std::path::PathBuf;

use crate::cli::args::one_of;
use crate::cli::io::{now, save};
use crate::cli::{CliError, ErrorSubject, IntoCliError as _, Io};
use crate::files;
use crate::length::Length;
use crate::series::{Answer, Factor, Reference, StudyKind, StudyWanted};

/// What is asked instead of the figures of the process.
#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Gauges and groups")]
pub(super) struct StudyArgs {
    /// Study of a gauge: readings of one master (type1), of parts by operators (crossed, nested), of several masters (linearity), of one master over time (stability)
    #[arg(long, value_name = "STUDY", value_parser = one_of(StudyKind::ALL, |kind| kind.word()), conflicts_with_all = ["compare", "all"])]
    pub(super) study: Option<StudyKind>,

    /// Calibrated size in mm of the master; of several masters one each, or a column of nominal sizes
    #[arg(long = "reference", value_name = "[PART=]MM", requires = "study")]
    references: Vec<String>,

    /// Step of the display in mm
    #[arg(long, value_name = "MM", requires = "study")]
    resolution: Option<String>,

    /// Evaluate a layout that looks wrong
    #[arg(long, requires = "study")]
    confirm_layout: bool,

    /// Also write what the study gives an uncertainty budget, as a file for fitcheck budget
    #[arg(long, value_name = "FILE", requires = "study")]
    budget_out: Option<PathBuf>,

    /// Compare groups of values: by who measured, by machine, gauge or part
    #[arg(long, value_name = "GROUPS", value_parser = one_of(Factor::ALL, |factor| factor.word()), conflicts_with = "all")]
    pub(super) compare: Option<Factor>,
}

fn mm(name: &str, text: &str) -> Result<f64, CliError> {
    text.parse::<Length>().about(&ErrorSubject::Option { name }).map(Length::to_mm_f64)
}

impl StudyArgs {
    /// Whether names that stand alone are those of parts.
    pub(super) fn has_parts(&self) -> bool {
        self.study.is_some() || self.compare == Some(Factor::Part)
    }

    pub(super) fn wanted(&self, kind: StudyKind) -> Result<StudyWanted, CliError> {
        let about = ErrorSubject::Option { name: "reference" };
        let reference = |given: &String| Reference::read(given).about(&about);
        Ok(StudyWanted {
            kind,
            references: self.references.iter().map(reference).collect::<Result<_, _>>()?,
            resolution: self.resolution.as_ref().map(|step| mm("resolution", step)).transpose()?,
            is_confirmed: self.confirm_layout,
        })
    }

    /// Writes the budget that is asked for.
    pub(super) fn save(&self, answer: &Answer, read: &[PathBuf], io: &mut Io<'_>) -> Result<(), CliError> {
        let Some(path) = &self.budget_out else { return Ok(()) };
        let names: Vec<String> = read.iter().map(|path| files::name_of(path).to_string_lossy().into_owned()).collect();
        let budget = answer.budget(&names.join(", "), now().date()).ok_or(CliError::StatsNoBudget)?;
        save(path, budget.as_bytes(), io)
    }
}
