//! The way back: from a wanted clearance, or a function such as sliding, to classes.

mod figures;

use clap::ValueEnum;
use figures::{CandidateFigures, Figures};

use super::text;
use crate::cli::answers::printable;
use crate::cli::args::one_of;
use crate::cli::people::{negative, range};
use crate::cli::rows::csv;
use crate::cli::said::about;
use crate::cli::{CliError, CliRemark, ErrorSubject, Figure, Format, IntoCliError as _, Io, Outcome};
use crate::length::Length;
use crate::tolerance::fit::Fit;
use crate::tolerance::fit::preferred::Function;
use crate::tolerance::fit::search::{self, Candidate, ClearanceRange, FitSearchResult, NearestMiss, Scope};
use crate::tolerance::{Callout, Sources};

/// A wanted clearance or a function.
#[derive(Debug, clap::Args)]
pub(super) struct ReverseArgs {
    /// Search: smallest clearance in mm; a negative value is an interference
    #[arg(long, value_name = "MM", requires = "max_clearance", allow_hyphen_values = true)]
    min_clearance: Option<String>,

    /// Search: largest clearance in mm
    #[arg(long, value_name = "MM", requires = "min_clearance", allow_hyphen_values = true)]
    max_clearance: Option<String>,

    /// Show the pairs that ANSI B4.2 names for a function
    #[arg(
        long,
        value_parser = one_of(Function::ALL, |function| function.word()),
        conflicts_with_all = ["min_clearance", "max_clearance", "scope", "limit"]
    )]
    function: Option<Function>,

    /// Search: pairs to consider; default: all
    #[arg(long, value_enum, requires = "min_clearance")]
    scope: Option<ScopeChoice>,

    /// Search: largest number of pairs to show; default: 20
    #[arg(long, value_name = "N", requires = "min_clearance")]
    limit: Option<usize>,
}

/// Which pairs are looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ScopeChoice {
    /// The preferred fits of ISO 286-1 and the pairs that ANSI B4.2 names.
    Preferred,
    /// Pairs with an H or an h.
    Basis,
    /// Every pair.
    All,
}

impl ScopeChoice {
    const fn word(self) -> &'static str {
        match self {
            Self::Preferred => "preferred",
            Self::Basis => "basis",
            Self::All => "all",
        }
    }

    const fn scope(self) -> Scope {
        match self {
            Self::Preferred => Scope::Preferred,
            Self::Basis => Scope::Basis,
            Self::All => Scope::All,
        }
    }
}

/// How many pairs are shown by default.
const SHOWN: usize = 20;

impl ReverseArgs {
    pub(super) const fn is_asked(&self) -> bool {
        self.min_clearance.is_some() || self.max_clearance.is_some() || self.function.is_some()
    }

    pub(super) fn run(
        &self,
        callouts: &[String],
        sources: &Sources,
        format: Format,
        io: &mut Io<'_>,
    ) -> Result<Outcome, CliError> {
        let [size] = callouts else {
            return Err(CliError::SearchWithoutSize);
        };
        let size = nominal_size(size)?;
        if let Some(function) = self.function {
            return of_function(size, function, sources, format, io);
        }
        let (Some(minimum), Some(maximum)) = (&self.min_clearance, &self.max_clearance) else {
            return Err(CliError::SearchWithoutClearance);
        };
        let wanted = ClearanceRange {
            minimum: minimum.parse().about(&ErrorSubject::SmallestClearance)?,
            maximum: maximum.parse().about(&ErrorSubject::LargestClearance)?,
        };
        let scope = self.scope.unwrap_or(ScopeChoice::All);
        let found = search::search_in(size, wanted, sources, scope.scope(), self.limit.unwrap_or(SHOWN));
        print(format, &Searched { size, wanted: Some((wanted, scope)), function: None, found: &found.said()? }, io);
        Ok(Outcome::Done)
    }
}

/// `25`, `Ø25`, `25 mm`.
fn nominal_size(text: &str) -> Result<Length, CliError> {
    let shown = printable(text.trim());
    let bare = text.trim().trim_start_matches(['Ø', 'ø', '⌀']);
    bare.parse().about(&ErrorSubject::NominalSize { text: &shown })
}

/// The pairs of a function, hole basis first; one that is not defined at this size is refused by name.
fn of_function(
    size: Length,
    function: Function,
    sources: &Sources,
    format: Format,
    io: &mut Io<'_>,
) -> Result<Outcome, CliError> {
    let mut candidates = Vec::new();
    let mut refused = Vec::new();
    for named in function.fits() {
        let callout = Callout::fit(size, named.hole, named.shaft).said()?;
        match Fit::of_callout(&callout, sources) {
            Ok(fit) => {
                let minimum = fit.minimum_clearance();
                let maximum = fit.maximum_clearance();
                candidates.push(Candidate::new(named.hole, named.shaft, minimum, maximum));
            }
            Err(error) => refused.push(about(&callout.to_string(), &error)),
        }
    }
    let found = FitSearchResult { total: candidates.len(), candidates, nearest: None };
    print(format, &Searched { size, wanted: None, function: Some(function), found: &found }, io);
    io.data().flush();
    for refusal in &refused {
        io.tell(refusal);
    }
    Ok(if refused.is_empty() { Outcome::Done } else { Outcome::BadData })
}

/// What was asked and what was found.
struct Searched<'a> {
    size: Length,
    wanted: Option<(ClearanceRange, ScopeChoice)>,
    function: Option<Function>,
    found: &'a FitSearchResult,
}

fn print(format: Format, searched: &Searched<'_>, io: &mut Io<'_>) {
    match format {
        Format::Text => print_text(searched, io),
        Format::Csv => {
            csv(searched.found.candidates.iter().map(|one| CandidateFigures::of(searched.size, one)), io);
            if let Some(miss) = &searched.found.nearest {
                io.tell(CliRemark::NoPair { nearest: nearest(miss) });
            }
        }
        Format::Json => io.json(&Figures::of(searched)),
    }
}

fn print_text(searched: &Searched<'_>, io: &mut Io<'_>) {
    let FitSearchResult { candidates, total, nearest: miss } = searched.found;
    let size = searched.size;
    match (&searched.wanted, searched.function) {
        (Some((wanted, _)), _) => {
            let range = range(wanted.minimum, wanted.maximum);
            let negative = negative(wanted.minimum);
            let shown =
                if candidates.len() < *total { format!(", the best {}", candidates.len()) } else { String::new() };
            let pairs = if *total == 1 { "pair" } else { "pairs" };
            writeln!(io.people(), "{size} mm, clearance {range}{negative}: {total} {pairs}{shown}");
        }
        (None, Some(function)) => writeln!(io.people(), "{size} mm, {function}"),
        (None, None) => {}
    }
    for candidate in candidates {
        let pair = format!("{}/{}", candidate.hole, candidate.shaft);
        let range = range(candidate.minimum, candidate.maximum);
        let remarks = text::with_remarks(&candidate.kind(), Some((candidate.hole, candidate.shaft)));
        writeln!(io.people(), "  {pair:<10} {range:<20}  {remarks}");
    }
    if let Some(miss) = miss {
        writeln!(io.people(), "  nearest is {}", nearest(miss));
    }
}

/// `H7/g6 with +7 … +41 µm, 1 µm below`
fn nearest(miss: &NearestMiss) -> String {
    let Candidate { hole, shaft, minimum, maximum, .. } = miss.candidate;
    let beyond = [(miss.below, "below"), (miss.above, "above")];
    let beyond: Vec<String> = beyond
        .iter()
        .filter(|(length, _)| Length::ZERO < *length)
        .map(|(length, side)| format!("{} {side}", Figure::um(*length).0 + " µm"))
        .collect();
    format!("{hole}/{shaft} with {}, {}", range(minimum, maximum), beyond.join(" and "))
}
