//! From a wanted clearance to the pairs of classes that give it.
//!
//! Checks every pair of classes that the sources define at a size, exact to the nanometre. Two numbers decide a pair,
//! so all quarter of a million pairs are checked; only those that are shown get their details.

mod ranking;

use ranking::{Zone, fitting, nearest};

use super::FitKind;
use super::basis::{Basis, basis};
use super::preferred::{self, Function, Preference};
use crate::length::Length;
use crate::message::Say;
use crate::tolerance::class::{Feature, ToleranceClass};
use crate::tolerance::iso286::Options;
use crate::tolerance::sources::Sources;

/// A range of clearance; negative is an interference. Both ends belong to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ClearanceRange {
    /// No less than this.
    pub minimum: Length,
    /// No more than this.
    pub maximum: Length,
}

/// Which pairs are searched.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Scope {
    /// The preferred fits of ISO 286-1 and the pairs that ANSI B4.2 names.
    Preferred,
    /// Pairs with an H or an h.
    Basis,
    /// Every pair.
    #[default]
    All,
}

/// A pair of classes and what it gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Candidate {
    /// The hole's class.
    pub hole: ToleranceClass,
    /// The shaft's class.
    pub shaft: ToleranceClass,
    /// The smallest clearance.
    pub minimum: Length,
    /// The largest clearance.
    pub maximum: Length,
    /// The list of ISO 286-1 that has it.
    pub preference: Option<Preference>,
    /// Its name in ANSI B4.2.
    pub function: Option<Function>,
    /// Hole basis or shaft basis.
    pub basis: Option<Basis>,
}

impl Candidate {
    /// A pair of classes with the clearances that it gives, and what is known of the pair.
    pub fn new(hole: ToleranceClass, shaft: ToleranceClass, minimum: Length, maximum: Length) -> Self {
        let preference = preferred::preference(hole, shaft);
        let function = preferred::function(hole, shaft);
        Self { hole, shaft, minimum, maximum, preference, function, basis: basis(hole, shaft) }
    }

    /// Clearance, transition or interference.
    pub fn kind(&self) -> FitKind {
        FitKind::of(self.minimum, self.maximum)
    }
}

/// The nearest pair where none fits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NearestMiss {
    /// The pair.
    pub candidate: Candidate,
    /// How far its smallest clearance is below the wanted one, zero or more.
    pub below: Length,
    /// How far its largest clearance is above the wanted one, zero or more.
    pub above: Length,
}

/// What a search found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FitSearchResult {
    /// The best pairs, best first: preferred fits of the hole basis, of the shaft basis, pairs named in ANSI B4.2, then
    /// hole basis, shaft basis, and the rest. In each group the widest tolerances come first, because they are the
    /// cheapest to make: by both together, then by the narrower one, then by letters.
    pub candidates: Vec<Candidate>,
    /// How many pairs fit in total.
    pub total: usize,
    /// Where none fits, the pair that exceeds the wanted range the least, below and above together.
    pub nearest: Option<NearestMiss>,
}

/// Why there is nothing to search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "fit-search", error)]
pub enum SearchError {
    /// The wanted clearances are in the wrong order; they are not swapped.
    Order {
        /// The smallest that was given.
        minimum: Length,
        /// The largest that was given.
        maximum: Length,
    },
    /// A nominal size of 0 or less.
    #[say(id = "callout-not-positive")]
    NotPositive {
        /// What was given.
        nominal: Length,
    },
    /// A nominal size beyond the standard.
    #[say(id = "iso286-too-large")]
    TooLarge {
        /// What was given.
        nominal: Length,
    },
    /// The tables have no class for a hole or none for a shaft.
    NoClasses {
        /// What was given.
        nominal: Length,
    },
}

/// Finds the pairs of ISO 286 whose whole range of clearance is within the wanted one, and gives details of the best
/// `limit`.
///
/// # Errors
/// [`SearchError`] for a range in the wrong order and for a size that ISO 286 does not have.
pub fn search(
    nominal: Length,
    wanted: ClearanceRange,
    options: Options,
    scope: Scope,
    limit: usize,
) -> Result<FitSearchResult, SearchError> {
    search_in(nominal, wanted, &Sources::default().with_options(options), scope, limit)
}

/// Searches the classes of any sources: where a user's own table has a class, its deviations count.
///
/// # Errors
/// [`SearchError`], also where the sources have no class for a hole or none for a shaft.
pub fn search_in(
    nominal: Length,
    wanted: ClearanceRange,
    sources: &Sources,
    scope: Scope,
    limit: usize,
) -> Result<FitSearchResult, SearchError> {
    if wanted.maximum < wanted.minimum {
        return Err(SearchError::Order { minimum: wanted.minimum, maximum: wanted.maximum });
    }
    if nominal <= Length::ZERO {
        return Err(SearchError::NotPositive { nominal });
    }
    let holes = Zone::all(Feature::Hole, nominal, sources);
    let shafts = Zone::all(Feature::Shaft, nominal, sources);
    if holes.is_empty() || shafts.is_empty() {
        return Err(if sources.base().is_standard() {
            SearchError::TooLarge { nominal }
        } else {
            SearchError::NoClasses { nominal }
        });
    }
    let mut ranked = fitting(&holes, &shafts, wanted, scope);
    let total = ranked.len();
    let nearest = if total == 0 { nearest(&holes, &shafts, wanted, scope) } else { None };
    if limit < ranked.len() {
        ranked.select_nth_unstable(limit);
        ranked.truncate(limit);
    }
    ranked.sort_unstable();
    let candidates = ranked.iter().filter_map(|pair| pair.candidate(&holes, &shafts)).collect();
    Ok(FitSearchResult { candidates, total, nearest })
}
