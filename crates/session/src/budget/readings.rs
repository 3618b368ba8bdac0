//! Readings of a calibrated piece: from a file, or from the checks of the history.

use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::Feature;
use fitcheck_exchange::exchange::{Sizes, sizes};
use fitcheck_exchange::journal::Record;

/// The sizes of a file, read as holes and as shafts: the budget says which of them it means.
#[derive(Debug, Clone, PartialEq)]
pub struct BothSizes {
    hole: Sizes,
    shaft: Sizes,
}

impl BothSizes {
    /// Reads a file of any known format.
    pub fn read(file_name: &str, bytes: &[u8]) -> Self {
        Self { hole: sizes(file_name, bytes, Feature::Hole), shaft: sizes(file_name, bytes, Feature::Shaft) }
    }
}

/// Where readings come from.
#[derive(Debug, Clone)]
pub(super) enum Source {
    File { name: String, sizes: Box<BothSizes> },
    Records { records: Vec<Arc<Record>>, is_choice: bool },
}

/// Readings in place of those of the budget, and what has to be said of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Readings {
    /// How many, and where they come from.
    pub from: Message,
    pub measured: Vec<Length>,
    /// What was not used, and what to check.
    pub notes: Vec<Message>,
}

impl Readings {
    /// The readings of a hole or a shaft.
    pub(super) fn of(source: &Source, feature: Feature) -> Self {
        match source {
            Source::File { name, sizes } => Self::of_file(name, sizes, feature),
            Source::Records { records, is_choice } => Self::of_records(records, *is_choice, feature),
        }
    }

    fn of_file(name: &str, sizes: &BothSizes, feature: Feature) -> Self {
        let read = match feature {
            Feature::Hole => &sizes.hole,
            Feature::Shaft => &sizes.shaft,
        };
        let from = message!("budget-page-readings-of-file").count("count", read.measured.len()).text("name", name);
        let refused = read.errors.iter().map(fitcheck_core::message::Say::message);
        let warnings = read.warnings.iter().map(fitcheck_core::message::Say::message);
        let doubts = read.doubts();
        let notes = refused.chain(warnings).chain(doubts.iter().map(fitcheck_core::message::Say::message)).collect();
        Self { from, measured: read.measured.iter().map(|size| size.measured).collect(), notes }
    }

    fn of_records(records: &[Arc<Record>], is_choice: bool, feature: Feature) -> Self {
        let (used, others): (Vec<_>, Vec<_>) =
            records.iter().partition(|record| record.limits.feature == Some(feature));
        let id = if is_choice { "budget-page-readings-of-chosen" } else { "budget-page-readings-of-history" };
        let from = Message::new(id).count("count", used.len());
        let simulated = used.iter().filter(|record| record.measurement.origin.is_simulated()).count();
        let doubted = used.iter().filter_map(|record| record.doubt);
        let count = |id: &'static str, count: usize| (0 < count).then(|| Message::new(id).count("count", count));
        let other = match feature {
            Feature::Hole => "budget-page-readings-are-shafts",
            Feature::Shaft => "budget-page-readings-are-holes",
        };
        let counted = [count(other, others.len()), count("budget-page-readings-simulated", simulated)];
        let notes = counted.into_iter().flatten().chain(doubted.map(|doubt| doubt.message())).collect();
        Self { from, measured: used.iter().map(|record| record.measurement.diameter).collect(), notes }
    }
}
