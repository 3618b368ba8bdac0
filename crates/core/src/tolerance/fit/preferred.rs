//! The preferred fits of ISO 286-1 and the ten functions of ANSI B4.2.
//!
//! The letters and grades decide whether a pair is preferred; whether it is defined at a size, and what kind of fit it
//! is there, is decided elsewhere. `docs/SOURCES.md` says which figures are confirmed and by how many sources.

use crate::message::Say;
use crate::tolerance::class::{Feature, ToleranceClass};
use crate::tolerance::iso286::{self, Grade, Letter};

/// A letter and the number of a grade.
type Part = (Letter, u8);

/// The grade of H, and its shafts.
const HOLE_BASIS: [(u8, &[Part]); 6] = {
    use Letter::{B, C, D, E, F, G, H, Js, K, M, N, P, R, S, T, U, X};
    [
        (6, &[(G, 5), (H, 5), (Js, 5), (K, 5), (M, 5), (N, 5), (P, 5)]),
        (7, &[(F, 6), (G, 6), (H, 6), (Js, 6), (K, 6), (M, 6), (N, 6), (P, 6), (R, 6), (S, 6), (T, 6), (U, 6), (X, 6)]),
        (8, &[(E, 7), (F, 7), (H, 7), (Js, 7), (K, 7), (M, 7), (S, 7), (U, 7), (D, 8), (E, 8), (F, 8), (H, 8)]),
        (9, &[(D, 8), (E, 8), (F, 8), (H, 8)]),
        (10, &[(B, 9), (C, 9), (D, 9), (E, 9), (H, 9)]),
        (11, &[(B, 11), (C, 11), (D, 10), (H, 10)]),
    ]
};

/// The grade of h, and its holes.
const SHAFT_BASIS: [(u8, &[Part]); 5] = {
    use Letter::{B, C, D, E, F, G, H, Js, K, M, N, P, R, S, T, U, X};
    [
        (5, &[(G, 6), (H, 6), (Js, 6), (K, 6), (M, 6), (N, 6), (P, 6)]),
        (6, &[(F, 7), (G, 7), (H, 7), (Js, 7), (K, 7), (M, 7), (N, 7), (P, 7), (R, 7), (S, 7), (T, 7), (U, 7), (X, 7)]),
        (7, &[(E, 8), (F, 8), (H, 8)]),
        (8, &[(D, 9), (E, 9), (F, 9), (H, 9)]),
        (9, &[(E, 8), (F, 8), (H, 8), (D, 9), (E, 9), (F, 9), (H, 9), (B, 11), (C, 10), (D, 10), (H, 10)]),
    ]
};

/// Which list of ISO 286-1 has a preferred fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Say)]
#[say(prefix = "fit-preferred")]
pub enum Preference {
    /// The preferred fits of the hole basis.
    HoleBasis,
    /// The preferred fits of the shaft basis.
    ShaftBasis,
}

impl Preference {
    /// The word for machines, the same in every language.
    pub const fn word(self) -> &'static str {
        match self {
            Self::HoleBasis => "hole basis",
            Self::ShaftBasis => "shaft basis",
        }
    }

    /// The pairs of the list, hole first, in the standard's order.
    pub fn fits(self) -> impl Iterator<Item = (ToleranceClass, ToleranceClass)> {
        let lines: &[(u8, &[Part])] = match self {
            Self::HoleBasis => &HOLE_BASIS,
            Self::ShaftBasis => &SHAFT_BASIS,
        };
        let pairs = lines.iter().flat_map(|(grade, others)| others.iter().map(|other| ((Letter::H, *grade), *other)));
        pairs.filter_map(move |(base, other)| match self {
            Self::HoleBasis => pair(base, other),
            Self::ShaftBasis => pair(other, base),
        })
    }

    pub(super) fn of_parts(hole: (Letter, Grade), shaft: (Letter, Grade)) -> Option<Self> {
        if hole.0 == Letter::H && stands_in(&HOLE_BASIS, hole.1, shaft) {
            Some(Self::HoleBasis)
        } else if shaft.0 == Letter::H && stands_in(&SHAFT_BASIS, shaft.1, hole) {
            Some(Self::ShaftBasis)
        } else {
            None
        }
    }
}

/// The list of preferred fits that has a pair; the hole basis where both have it, as for `H7/h6`.
pub fn preference(hole: ToleranceClass, shaft: ToleranceClass) -> Option<Preference> {
    let (hole, shaft) = parts(hole, shaft)?;
    Preference::of_parts(hole, shaft)
}

crate::named! {
    /// What a fit is for: the names of ANSI B4.2 (metric), from loose to tight.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Say)]
    #[say(prefix = "fit-function")]
    pub enum Function {
        /// Every function, from loose to tight.
        ALL;
        /// The word for machines and the command line, the same in every language.
        fn word;
        /// `H11/c11`: wide tolerances, rough work.
        LooseRunning = "loose-running",
        /// `H9/d9`: high speed or large changes of temperature.
        FreeRunning = "free-running",
        /// `H8/f7`: accurate machines at moderate speed.
        CloseRunning = "close-running",
        /// `H7/g6`: moves and turns freely, and locates.
        Sliding = "sliding",
        /// `H7/h6`: snug, but freely assembled and taken apart.
        LocationalClearance = "locational-clearance",
        /// `H7/k6`: between clearance and interference.
        LocationalTransition = "locational-transition",
        /// `H7/n6`: the same where more interference is allowed.
        LocationalTransitionTighter = "locational-transition-tighter",
        /// `H7/p6`: rigid and aligned, without much pressure; a transition fit up to 3 mm.
        LocationalInterference = "locational-interference",
        /// `H7/s6`: shrink fits on light sections.
        MediumDrive = "medium-drive",
        /// `H7/u6`: parts that withstand high stress.
        Force = "force",
    }
}

/// A pair of classes with the name of its function.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct NamedFit {
    /// The hole's class.
    pub hole: ToleranceClass,
    /// The shaft's class.
    pub shaft: ToleranceClass,
    /// What the fit is for.
    pub name: Function,
}

impl Function {
    /// The letter that is not H, the hole's grade, the shaft's grade: the same in both bases.
    const fn parts(self) -> (Letter, u8, u8) {
        match self {
            Self::LooseRunning => (Letter::C, 11, 11),
            Self::FreeRunning => (Letter::D, 9, 9),
            Self::CloseRunning => (Letter::F, 8, 7),
            Self::Sliding => (Letter::G, 7, 6),
            Self::LocationalClearance => (Letter::H, 7, 6),
            Self::LocationalTransition => (Letter::K, 7, 6),
            Self::LocationalTransitionTighter => (Letter::N, 7, 6),
            Self::LocationalInterference => (Letter::P, 7, 6),
            Self::MediumDrive => (Letter::S, 7, 6),
            Self::Force => (Letter::U, 7, 6),
        }
    }

    /// The pairs of this function: hole basis, then shaft basis; `H7/h6` once.
    pub fn fits(self) -> impl Iterator<Item = NamedFit> {
        let (letter, hole, shaft) = self.parts();
        let hole_basis = pair((Letter::H, hole), (letter, shaft));
        let shaft_basis = pair((letter, hole), (Letter::H, shaft)).filter(|_| letter != Letter::H);
        hole_basis.into_iter().chain(shaft_basis).map(move |(hole, shaft)| NamedFit { hole, shaft, name: self })
    }

    pub(super) fn of_parts(hole: (Letter, Grade), shaft: (Letter, Grade)) -> Option<Self> {
        let ((Letter::H, letter) | (letter, Letter::H)) = (hole.0, shaft.0) else { return None };
        Self::ALL.into_iter().find(|function| {
            let (is, of_hole, of_shaft) = function.parts();
            is == letter && Grade::numbered(of_hole) == Some(hole.1) && Grade::numbered(of_shaft) == Some(shaft.1)
        })
    }
}

/// The function that ANSI B4.2 names for a pair of either basis.
pub fn function(hole: ToleranceClass, shaft: ToleranceClass) -> Option<Function> {
    let (hole, shaft) = parts(hole, shaft)?;
    Function::of_parts(hole, shaft)
}

fn stands_in(lines: &[(u8, &[Part])], base: Grade, other: (Letter, Grade)) -> bool {
    let is = |number: u8, grade: Grade| Grade::numbered(number) == Some(grade);
    let line = lines.iter().find(|(number, _)| is(*number, base));
    line.is_some_and(|(_, others)| others.iter().any(|(letter, number)| *letter == other.0 && is(*number, other.1)))
}

fn parts(hole: ToleranceClass, shaft: ToleranceClass) -> Option<((Letter, Grade), (Letter, Grade))> {
    let sides = (hole.feature(), shaft.feature());
    if sides != (Feature::Hole, Feature::Shaft) {
        return None;
    }
    Some((iso286::parts(hole)?, iso286::parts(shaft)?))
}

fn pair(hole: Part, shaft: Part) -> Option<(ToleranceClass, ToleranceClass)> {
    let class = |feature, (letter, number): Part| Some(iso286::class(feature, letter, Grade::numbered(number)?));
    Some((class(Feature::Hole, hole)?, class(Feature::Shaft, shaft)?))
}
