//! Which measured parts go together: what was asked, the answer, and its files.
//!
//! | file | what |
//! |---|---|
//! | here | what is asked, the answer, the list of formats |
//! | `parts` | holes or shafts with everything about them that has to be said |
//! | `figures` | CSV and JSON, the same in every language |
//!
//! To add a format of the answer:
//!
//! 1. Declare a [`Format`] here and add its line in [`FORMATS`].
//! 2. Add `pairing-page-save-NAME` to `pairing-page.ftl` in every folder of `assets/locales`.
//! 3. Add a call of `fitcheck pair --format NAME` to the corpus and record the answers (`tests/core/corpus.rs`).
//!
//! The button, the dialog and `fitcheck pair --format` follow.

mod figures;
mod parts;

use std::io::{self, Write};
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::pairing::{
    Grinding, Groups, PairClearances, Pairing, PairingError, Range, Ranges, grinding, groups, pair,
};
use fitcheck_core::tolerance::Callout;
use fitcheck_core::tolerance::fit::Fit;

pub use figures::column_names;
pub use parts::{Note, PairingParts, PartsFrom, PartsWarning};

#[derive(Debug, Clone, PartialEq)]
pub struct PairingRequest {
    /// The measured holes.
    pub holes: Arc<PairingParts>,
    /// The measured shafts.
    pub shafts: Arc<PairingParts>,
    /// The clearances that a pair may have.
    pub wanted: PairClearances,
    /// The fit whose clearances these are, where it is one.
    pub fit: Option<(Callout, Fit)>,
    /// Into how many groups the parts are sorted besides; `None` into none.
    pub group_count: Option<usize>,
}

/// What was asked, and what came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct PairingAnswer {
    pub asked: PairingRequest,
    /// Holes and shafts outside the limits of the fit: a pair of them may still have a wanted clearance.
    pub outside: [Option<PartsWarning>; 2],
    /// The pairs, and what is left over.
    pub pairing: Pairing,
    /// What grinding would save; `None` where holes or shafts are not left over.
    pub grinding: Option<Grinding>,
    /// The groups, where they were asked for, or why there are none.
    pub sorted: Option<Result<Groups, PairingError>>,
}

/// One way to write the answer.
#[derive(Debug, Clone, Copy)]
pub struct Format {
    /// Its name on the command line.
    pub name: &'static str,
    /// Endings of its files without the point.
    pub endings: &'static [&'static str],
    /// Writes the file.
    ///
    /// # Errors
    /// The stream's own.
    pub write: fn(&PairingAnswer, &mut dyn Write) -> io::Result<()>,
}

/// Every format: a new one is a line here.
pub const FORMATS: &[Format] = &[figures::CSV, figures::JSON];

impl PairingRequest {
    /// Pairs and sorts.
    pub fn answer(self) -> PairingAnswer {
        let holes = &self.holes.measured;
        let shafts = &self.shafts.measured;
        let pairing = pair(holes, shafts, self.wanted);
        let grinding = grinding(holes, shafts, &pairing, self.wanted);
        let sorted = self.group_count.map(|count| groups(holes, shafts, count, self.ranges()?));
        let limits = self.fit.as_ref().map(|(_, fit)| [fit.hole(), fit.shaft()]);
        let outside =
            limits.map_or([None, None], |[hole, shaft]| [self.holes.outside(hole), self.shafts.outside(shaft)]);
        PairingAnswer { outside, pairing, grinding, sorted, asked: self }
    }

    /// What is sorted: what was measured or, for a fit, its zones.
    fn ranges(&self) -> Result<Ranges, PairingError> {
        let Some((_, fit)) = &self.fit else { return Ranges::measured(&self.holes.measured, &self.shafts.measured) };
        Ok(Ranges {
            holes: Range { from: fit.hole().minimum(), to: fit.hole().maximum() },
            shafts: Range { from: fit.shaft().minimum(), to: fit.shaft().maximum() },
        })
    }
}

impl PairingAnswer {
    /// The groups, if there are any.
    pub fn groups(&self) -> Option<&Groups> {
        self.sorted.as_ref()?.as_ref().ok()
    }

    /// The smallest and the largest clearance of the pairs; `None` without pairs.
    pub fn clearances(&self) -> Option<(Length, Length)> {
        let clearances = || self.pairing.pairs.iter().map(|pair| pair.clearance);
        clearances().min().zip(clearances().max())
    }

    /// Everything that has to be said about the parts, with the file and the line: `holes.csv:4: …`.
    pub fn warnings(&self) -> Vec<String> {
        let [holes, shafts] = &self.outside;
        let both = [(&self.asked.holes, holes), (&self.asked.shafts, shafts)];
        let of = |(parts, outside): (&Arc<PairingParts>, &Option<PartsWarning>)| {
            let outside = outside.as_ref().map(|outside| parts.warning(&Note::of(outside)));
            parts.warnings().into_iter().chain(outside).collect::<Vec<_>>()
        };
        both.into_iter().flat_map(of).collect()
    }
}
