//! Compares every pair of classes with the wanted clearance, in nanometres, and orders the answer.

use std::cmp::Reverse;

use super::{Candidate, ClearanceRange, NearestMiss, Scope};
use crate::length::Length;
use crate::tolerance::callout::Callout;
use crate::tolerance::class::{Feature, ToleranceClass};
use crate::tolerance::deviations::Deviations;
use crate::tolerance::fit::preferred::{Function, Preference};
use crate::tolerance::iso286::{self, Grade, Letter};
use crate::tolerance::sources::Sources;

/// A class at the size that is asked for, in nanometres.
pub(super) struct Zone {
    class: ToleranceClass,
    /// `None` for a class that ISO 286 does not know.
    parts: Option<(Letter, Grade)>,
    upper: i64,
    lower: i64,
}

impl Zone {
    /// Every class, by letter and then by grade; those that ISO 286 does not know follow by name.
    pub(super) fn all(feature: Feature, nominal: Length, sources: &Sources) -> Vec<Self> {
        let standard = sources.standard_classes_at(feature, nominal);
        if sources.tables().next().is_none() {
            return standard.map(|(class, deviations)| Self::new(class, deviations)).collect();
        }
        let mut classes: Vec<_> = standard.map(|(class, _)| class).chain(sources.table_classes(feature)).collect();
        classes.sort_unstable_by_key(|class| {
            let parts = iso286::parts(*class);
            (parts.is_none(), parts, *class)
        });
        classes.dedup();
        // A class that its table does not define at this size cannot be chosen.
        let zone = |class| {
            let callout = Callout::new(nominal, class).ok()?;
            Some(Self::new(class, sources.deviations(&callout, None).ok()?.0))
        };
        classes.into_iter().filter_map(zone).collect()
    }

    fn new(class: ToleranceClass, deviations: Deviations) -> Self {
        let upper = deviations.upper().nanometres();
        let lower = deviations.lower().nanometres();
        Self { class, parts: iso286::parts(class), upper, lower }
    }

    const fn width(&self) -> i64 {
        self.upper - self.lower
    }

    /// Whether its letter puts it on the zero line.
    fn is_h(&self) -> bool {
        self.parts.is_some_and(|(letter, _)| letter == Letter::H)
    }
}

/// A pair by its rank: the order of the fields is the order of the answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Ranked {
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
pub(super) enum Group {
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
        let one = hole_zone.width();
        let other = shaft_zone.width();
        let width = Reverse(one + other);
        let narrower = Reverse(one.min(other));
        Self { group: Group::of(hole_zone, shaft_zone), width, narrower, hole, shaft }
    }

    pub(super) fn candidate(self, holes: &[Zone], shafts: &[Zone]) -> Option<Candidate> {
        let hole = holes.get(self.hole)?;
        let shaft = shafts.get(self.shaft)?;
        let minimum = Length::from_nanometres(hole.lower - shaft.upper).ok()?;
        let maximum = Length::from_nanometres(hole.upper - shaft.lower).ok()?;
        Some(Candidate::new(hole.class, shaft.class, minimum, maximum))
    }
}

/// Every pair within the wanted range.
pub(super) fn fitting(holes: &[Zone], shafts: &[Zone], wanted: ClearanceRange, scope: Scope) -> Vec<Ranked> {
    let least = wanted.minimum.nanometres();
    let most = wanted.maximum.nanometres();
    let mut found = Vec::new();
    for hole in holes.iter().enumerate() {
        // The range that the shaft's deviations may have, so that the inner loop only compares.
        let highest = hole.1.lower - least;
        let lowest = hole.1.upper - most;
        let fits = |shaft: &(usize, &Zone)| shaft.1.upper <= highest && lowest <= shaft.1.lower;
        let ranked = shafts.iter().enumerate().filter(fits).map(|shaft| Ranked::of(hole, shaft));
        found.extend(ranked.filter(|pair| pair.group.is_in(scope)));
    }
    found
}

/// The pair that exceeds the wanted range the least; among equals the one of the best rank.
pub(super) fn nearest(holes: &[Zone], shafts: &[Zone], wanted: ClearanceRange, scope: Scope) -> Option<NearestMiss> {
    let least = wanted.minimum.nanometres();
    let most = wanted.maximum.nanometres();
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
    Some(NearestMiss { candidate: pair.candidate(holes, shafts)?, below: length(below)?, above: length(above)? })
}
