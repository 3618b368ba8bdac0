//! Which feature of a plan a value is of: by name, by number, or by where it lies.

use std::collections::BTreeMap;

use super::names::{key, number_key, of_side};
use super::plan::Plan;
use crate::length::Length;
use crate::message::Say;

/// How far a value may lie from where its feature should be, in every axis that is known: 0.5 mm.
const NEAR: Length = Length::from_micrometres(500);

/// What a value says of the feature that it is of. Texts are empty where it says nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Clues<'a> {
    /// The name of the feature, or of one of its sides: `K1 X`, `K1.X`.
    pub name: &'a str,
    /// The number of its balloon.
    pub number: &'a str,
    /// Where it lies in X, Y and Z, as far as that is known.
    pub place: [Option<Length>; 3],
    /// Which of the two sides of a pocket or boss it is, from 0.
    pub side: Option<usize>,
}

/// By what a value's feature was found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// Its name.
    Name,
    /// The number of its balloon.
    Number,
    /// Where it lies.
    Place,
}

/// Why no feature of a plan is found for a value.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "plan-not-found", error)]
pub enum NotFound {
    /// Nothing in the plan is called so or lies there.
    Unknown,
    /// It says nothing that could be looked for.
    NoClue,
    /// It has no name or number that is known, and of its place X or Y is missing.
    HalfPlace,
    /// Name and number are those of two features.
    Contradiction {
        /// The feature of that name.
        name: String,
        /// The feature of that number.
        number: String,
    },
    /// Only its number is that of a feature, and its name is of none: a number may be a running one.
    OtherName {
        /// What the file calls it.
        given: String,
        /// The name of the feature.
        name: String,
    },
    /// Only its number is that of a feature, and other sizes of its file are not of the plan: the number may be a running one.
    RunningNumber {
        /// The name of the feature.
        name: String,
    },
    /// The feature of that name, number or place has another nominal size.
    OtherNominal {
        /// Its name.
        name: String,
        /// What the file says.
        given: Length,
        /// What the plan says.
        planned: Length,
    },
    /// The limits of the file have nothing in common with those of the feature.
    OtherLimits {
        /// Its name.
        name: String,
        /// The file's limits.
        given: String,
        /// The plan's limits.
        planned: String,
    },
    /// The feature is of another kind than what was measured.
    OtherKind {
        /// Its name.
        name: String,
        /// Its kind.
        kind: &'static str,
    },
    /// Several features lie there.
    Several {
        /// Their names.
        names: String,
    },
    /// A feature with two sizes, and the value does not say which.
    WhichSide {
        /// The names of its sizes.
        names: String,
    },
}

/// Finds the sizes of a plan.
#[derive(Debug, Clone)]
pub struct Finder {
    /// The positions of sizes among [`Plan::sizes`], by the names that they may have, in upper case.
    names: BTreeMap<String, usize>,
    /// The sizes of features by number.
    numbers: BTreeMap<String, Vec<usize>>,
    /// Where features are, as far as the plan says so in X and Y: their sizes.
    places: Vec<(Vec<usize>, [Option<Length>; 3])>,
    /// The names of all sizes, and of the feature of each.
    sizes: Vec<(String, String)>,
}

impl Finder {
    /// For a plan.
    pub fn new(plan: &Plan) -> Self {
        let mut names = BTreeMap::new();
        let mut numbers = BTreeMap::<String, Vec<usize>>::new();
        let mut places = Vec::new();
        let mut sizes = Vec::new();
        for feature in plan.features() {
            let first = sizes.len();
            for size in feature.sizes() {
                let at = sizes.len();
                let side = feature.kind.sides().get(size.side).map_or("", |side| *side);
                names.extend(of_side(&feature.name, side).iter().map(|called| (key(called), at)));
                sizes.push((size.name(), feature.name.clone()));
            }
            let own: Vec<usize> = (first..sizes.len()).collect();
            if !feature.number.is_empty() {
                numbers.insert(number_key(&feature.number), own.clone());
            }
            if let [Some(_), Some(_), _] = feature.axes {
                places.push((own, feature.axes));
            }
        }
        Self { names, numbers, places, sizes }
    }

    /// How many sizes the plan has.
    pub fn len(&self) -> usize {
        self.sizes.len()
    }

    /// Whether the plan has none; no plan is so.
    pub fn is_empty(&self) -> bool {
        self.sizes.is_empty()
    }

    /// The position of a value's size among [`Plan::sizes`], and by what it was found.
    ///
    /// A name counts most, then a number, and where neither is known to the plan, the place: within 0.5 mm in X and Y, and in Z where both
    /// the plan and the value have it.
    ///
    /// # Errors
    /// [`NotFound`]; nothing is guessed.
    pub fn find(&self, clues: &Clues<'_>) -> Result<(usize, By), NotFound> {
        let by_name = self.by_name(clues);
        // A table with numbers alone calls a number what the plan calls a name.
        let is_name_a_number = by_name.is_none() && clues.number.trim().is_empty();
        let number = if is_name_a_number { clues.name } else { clues.number };
        let by_number = self.numbers.get(&number_key(number)).filter(|_| !number.trim().is_empty());
        // Some formats call a number what a plan calls a name.
        let named_so: Option<Vec<usize>> = self.names.get(&key(number)).map(|at| vec![*at]);
        let by_number = by_number.or(named_so.as_ref());
        match (by_name, by_number) {
            (Some(Err(which)), _) => Err(which),
            (Some(Ok(at)), Some(others)) if !others.contains(&at) => Err(NotFound::Contradiction {
                name: self.feature(at),
                number: others.first().map_or_else(String::new, |at| self.feature(*at)),
            }),
            (Some(Ok(at)), _) => Ok((at, By::Name)),
            (None, Some(own)) => Ok((self.one(own, clues)?, By::Number)),
            (None, None) => self.by_place(clues),
        }
    }

    /// The size of a name; the name of a feature with two sizes is not enough.
    fn by_name(&self, clues: &Clues<'_>) -> Option<Result<usize, NotFound>> {
        let wanted = key(clues.name);
        if wanted.is_empty() {
            return None;
        }
        if let Some(at) = self.names.get(&wanted) {
            return Some(Ok(*at));
        }
        let of_feature = (0..).zip(&self.sizes).filter(|(_, (_, feature))| key(feature) == wanted);
        let own: Vec<usize> = of_feature.map(|(at, _)| at).collect();
        (!own.is_empty()).then(|| self.one(&own, clues))
    }

    fn by_place(&self, clues: &Clues<'_>) -> Result<(usize, By), NotFound> {
        if let [None, _, _] | [_, None, _] = clues.place {
            let is_silent = clues.name.trim().is_empty() && clues.number.trim().is_empty();
            return Err(match clues.place {
                [None, None, None] if is_silent => NotFound::NoClue,
                [None, None, None] => NotFound::Unknown,
                _ => NotFound::HalfPlace,
            });
        }
        // An axis that one of them does not have does not count.
        let is_near = |(a, b): (&Option<Length>, &Option<Length>)| {
            a.zip(*b).is_none_or(|(a, b)| a.saturating_sub(b).abs() <= NEAR)
        };
        let near: Vec<&Vec<usize>> = self
            .places
            .iter()
            .filter(|(_, place)| place.iter().zip(&clues.place).all(is_near))
            .map(|(own, _)| own)
            .collect();
        match near.as_slice() {
            [] => Err(NotFound::Unknown),
            [own] => Ok((self.one(own, clues)?, By::Place)),
            several => {
                let names = several.iter().filter_map(|own| own.first()).map(|at| self.feature(*at));
                Err(NotFound::Several { names: names.collect::<Vec<_>>().join(", ") })
            }
        }
    }

    fn one(&self, own: &[usize], clues: &Clues<'_>) -> Result<usize, NotFound> {
        let of_side = clues.side.and_then(|side| own.get(side));
        match (own, of_side) {
            ([at], _) | (_, Some(at)) => Ok(*at),
            (several, None) => {
                let names = several.iter().filter_map(|at| Some(self.sizes.get(*at)?.0.as_str()));
                Err(NotFound::WhichSide { names: names.collect::<Vec<_>>().join(", ") })
            }
        }
    }

    fn feature(&self, at: usize) -> String {
        self.sizes.get(at).map_or_else(String::new, |(_, feature)| feature.clone())
    }
}
