//! From a wanted clearance to the pairs of classes that give it.
//!
//! Looks at every pair of classes that the sources define at a size, exactly, to the nanometre. Two numbers decide a
//! pair, so all quarter of a million pairs are looked at; only those that are shown are spelled out.

use std::cmp::Reverse;

use super::basis::{self, Basis};
use super::preferred::{Function, Preference};
use super::{Kind, preferred};
use crate::length::{Length, signed_mm};
use crate::tolerance::callout::Callout;
use crate::tolerance::class::{Feature, ToleranceClass};
use crate::tolerance::iso286::{self, Grade, Letter, Options};
use crate::tolerance::limits::Deviations;
use crate::tolerance::sources::{Base, Sources};
use crate::words::{Message, Say};

/// A range of clearance; negative is an interference. The borders belong to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Wanted {
    /// No less than this.
    pub minimum: Length,
    /// No more than this.
    pub maximum: Length,
}

/// Which pairs are looked at.
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
    /// The list of ISO 286-1 that it stands in.
    pub preference: Option<Preference>,
    /// Its name in ANSI B4.2.
    pub function: Option<Function>,
    /// Hole basis or shaft basis.
    pub basis: Option<Basis>,
}

impl Candidate {
    /// Clearance, transition or interference.
    pub fn kind(&self) -> Kind {
        Kind::of(self.minimum, self.maximum)
    }
}

/// The pair that comes nearest where none fits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Miss {
    /// The pair.
    pub candidate: Candidate,
    /// How far its smallest clearance is below the wanted one, zero or more.
    pub below: Length,
    /// How far its largest clearance is above the wanted one, zero or more.
    pub above: Length,
}

/// What a search found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Found {
    /// The best pairs, best first: preferred fits of the hole basis, of the shaft basis, pairs named in ANSI B4.2, then
    /// hole basis, shaft basis, and the rest. Within each the widest tolerances first, which are the cheapest to make:
    /// both together, then the narrower one; and then by letters.
    pub candidates: Vec<Candidate>,
    /// How many pairs fit altogether.
    pub total: usize,
    /// Where none fits, the pair that reaches least beyond what is wanted, below and above together.
    pub nearest: Option<Miss>,
}

/// Why there is nothing to search.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SearchError {
    /// The wanted clearances are in the wrong order; they are not swapped.
    #[error("smallest clearance {minimum} mm is above largest clearance {maximum} mm")]
    Order {
        /// The smallest that was given.
        minimum: Length,
        /// The largest that was given.
        maximum: Length,
    },
    /// A nominal size of 0 or less.
    #[error("nominal size {nominal} mm is not above 0")]
    NotPositive {
        /// What was given.
        nominal: Length,
    },
    /// A nominal size beyond the standard.
    #[error("nominal size {nominal} mm is beyond ISO 286, which ends at 3150 mm")]
    TooLarge {
        /// What was given.
        nominal: Length,
    },
    /// The tables have no class for a hole or none for a shaft.
    #[error("the tables have no classes for both hole and shaft at {nominal} mm")]
    NoClasses {
        /// What was given.
        nominal: Length,
    },
}

impl Say for SearchError {
    fn message(&self) -> Message {
        match *self {
            Self::Order { minimum, maximum } => {
                let message = signed_mm(Message::new("fit-search-order"), "minimum-sign", "minimum", minimum);
                signed_mm(message, "maximum-sign", "maximum", maximum)
            }
            Self::NotPositive { nominal } => {
                signed_mm(Message::new("callout-not-positive"), "nominal-sign", "nominal", nominal)
            }
            Self::TooLarge { nominal } => Message::new("iso286-too-large").mm("nominal", nominal),
            Self::NoClasses { nominal } => Message::new("fit-search-no-classes").mm("nominal", nominal),
        }
    }
}

/// Finds the pairs of ISO 286 whose whole range of clearance lies within the wanted one, and spells out the best
/// `limit`.
///
/// # Errors
/// [`SearchError`] for a range in the wrong order and for a size that ISO 286 does not have.
pub fn search(
    nominal: Length,
    wanted: Wanted,
    options: Options,
    scope: Scope,
    limit: usize,
) -> Result<Found, SearchError> {
    search_in(nominal, wanted, &Sources::default().with_options(options), scope, limit)
}

/// The same among the classes of any sources: where a user's own table has a class, its deviations count.
///
/// # Errors
/// [`SearchError`], also where the sources have no class for a hole or none for a shaft.
pub fn search_in(
    nominal: Length,
    wanted: Wanted,
    sources: &Sources,
    scope: Scope,
    limit: usize,
) -> Result<Found, SearchError> {
    if wanted.maximum < wanted.minimum {
        return Err(SearchError::Order { minimum: wanted.minimum, maximum: wanted.maximum });
    }
    if nominal <= Length::ZERO {
        return Err(SearchError::NotPositive { nominal });
    }
    let holes = Zone::all(Feature::Hole, nominal, sources);
    let shafts = Zone::all(Feature::Shaft, nominal, sources);
    if holes.is_empty() || shafts.is_empty() {
        let is_standard = matches!(sources.base(), Base::Iso286);
        return Err(if is_standard { SearchError::TooLarge { nominal } } else { SearchError::NoClasses { nominal } });
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
    Ok(Found { candidates, total, nearest })
}

/// A class at the size that is asked for, in nanometres.
struct Zone {
    class: ToleranceClass,
    /// `None` for a class that ISO 286 does not know.
    parts: Option<(Letter, Grade)>,
    upper: i64,
    lower: i64,
}

impl Zone {
    /// Every class, by letter and then by grade; those that ISO 286 does not know follow by name.
    fn all(feature: Feature, nominal: Length, sources: &Sources) -> Vec<Self> {
        let is_standard = matches!(sources.base(), Base::Iso286);
        let standard = is_standard.then(|| iso286::classes_at(feature, nominal, sources.options()));
        let standard = standard.into_iter().flatten();
        if sources.tables().next().is_none() {
            return standard.map(|(class, deviations)| Self::new(class, deviations)).collect();
        }
        let columns = sources.tables().flat_map(|table| table.columns().iter().map(|column| column.class));
        let mut classes: Vec<_> =
            standard.map(|(class, _)| class).chain(columns.filter(|class| class.feature() == feature)).collect();
        classes.sort_unstable_by_key(|class| {
            let parts = iso286::parts(*class);
            (parts.is_none(), parts, *class)
        });
        classes.dedup();
        // A class that its table does not define at this size is none to choose.
        let zone = |class| {
            let callout = Callout::new(nominal, class).ok()?;
            Some(Self::new(class, sources.deviations(&callout, None).ok()?.0))
        };
        classes.into_iter().filter_map(zone).collect()
    }

    fn new(class: ToleranceClass, deviations: Deviations) -> Self {
        let (upper, lower) = (deviations.upper().nanometres(), deviations.lower().nanometres());
        Self { class, parts: iso286::parts(class), upper, lower }
    }

    const fn width(&self) -> i64 {
        self.upper - self.lower
    }

    /// Whether it lies on the zero line by its letter.
    fn is_h(&self) -> bool {
        self.parts.is_some_and(|(letter, _)| letter == Letter::H)
    }
}

/// A pair by its rank: the order of the fields is the order of the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Ranked {
    group: Group,
    /// The width of the range of clearance in nanometres: both tolerances together.
    width: Reverse<i64>,
    /// The narrower of the two tolerances: among equals `H6/g7` before `H0/g8`.
    narrower: Reverse<i64>,
    /// Places in the lists of zones, which are in the order of letters.
    hole: usize,
    shaft: usize,
}

/// The groups of candidates, best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Group {
    PreferredHole,
    PreferredShaft,
    Named,
    HoleBasis,
    ShaftBasis,
    Rest,
}

impl Group {
    fn of(hole: &Zone, shaft: &Zone) -> Self {
        if !hole.is_h() && !shaft.is_h() {
            return Self::Rest;
        }
        let parts = hole.parts.zip(shaft.parts);
        match parts.and_then(|(hole, shaft)| Preference::of_parts(hole, shaft)) {
            Some(Preference::HoleBasis) => Self::PreferredHole,
            Some(Preference::ShaftBasis) => Self::PreferredShaft,
            None if parts.is_some_and(|(hole, shaft)| Function::of_parts(hole, shaft).is_some()) => Self::Named,
            None if hole.is_h() => Self::HoleBasis,
            None => Self::ShaftBasis,
        }
    }

    fn is_in(self, scope: Scope) -> bool {
        match scope {
            Scope::All => true,
            Scope::Basis => self < Self::Rest,
            Scope::Preferred => self < Self::HoleBasis,
        }
    }
}

impl Ranked {
    fn of((hole, hole_zone): (usize, &Zone), (shaft, shaft_zone): (usize, &Zone)) -> Self {
        let (one, other) = (hole_zone.width(), shaft_zone.width());
        let (width, narrower) = (Reverse(one + other), Reverse(one.min(other)));
        Self { group: Group::of(hole_zone, shaft_zone), width, narrower, hole, shaft }
    }

    fn candidate(self, holes: &[Zone], shafts: &[Zone]) -> Option<Candidate> {
        let (hole, shaft) = (holes.get(self.hole)?, shafts.get(self.shaft)?);
        Some(Candidate {
            hole: hole.class,
            shaft: shaft.class,
            minimum: Length::from_nanometres(hole.lower - shaft.upper).ok()?,
            maximum: Length::from_nanometres(hole.upper - shaft.lower).ok()?,
            preference: preferred::preference(hole.class, shaft.class),
            function: preferred::function(hole.class, shaft.class),
            basis: basis::basis(hole.class, shaft.class),
        })
    }
}

/// Every pair within the wanted range.
fn fitting(holes: &[Zone], shafts: &[Zone], wanted: Wanted, scope: Scope) -> Vec<Ranked> {
    let (least, most) = (wanted.minimum.nanometres(), wanted.maximum.nanometres());
    let mut found = Vec::new();
    for hole in holes.iter().enumerate() {
        // What the shaft's deviations may be, so that the inner loop compares and does nothing else.
        let (highest, lowest) = (hole.1.lower - least, hole.1.upper - most);
        let fits = |shaft: &(usize, &Zone)| shaft.1.upper <= highest && lowest <= shaft.1.lower;
        let ranked = shafts.iter().enumerate().filter(fits).map(|shaft| Ranked::of(hole, shaft));
        found.extend(ranked.filter(|pair| pair.group.is_in(scope)));
    }
    found
}

/// The pair with the smallest reach beyond the wanted range; among equals the one of the best rank.
fn nearest(holes: &[Zone], shafts: &[Zone], wanted: Wanted, scope: Scope) -> Option<Miss> {
    let (least, most) = (wanted.minimum.nanometres(), wanted.maximum.nanometres());
    let mut best: Option<((i64, Ranked), (i64, i64))> = None;
    for hole in holes.iter().enumerate() {
        for shaft in shafts.iter().enumerate() {
            let below = (least - (hole.1.lower - shaft.1.upper)).max(0);
            let above = ((hole.1.upper - shaft.1.lower) - most).max(0);
            if best.is_some_and(|((reach, _), _)| reach < below + above) {
                continue;
            }
            let rank = (below + above, Ranked::of(hole, shaft));
            if rank.1.group.is_in(scope) && best.is_none_or(|(before, _)| rank < before) {
                best = Some((rank, (below, above)));
            }
        }
    }
    let ((_, pair), (below, above)) = best?;
    let length = |nm| Length::from_nanometres(nm).ok();
    Some(Miss { candidate: pair.candidate(holes, shafts)?, below: length(below)?, above: length(above)? })
}
