//! Limit deviations looked up once for each tolerance class and size step.

use super::row::Part;
use crate::length::Length;
use crate::tolerance::{Callout, Deviations, Feature, Sources, ToleranceClass};

/// How many places the table of texts has: several times the classes of ISO 286.
const PLACES: usize = 1 << 12;

/// How many texts it takes at most, so that one is found after few tries; others are read each time.
const MOST: usize = PLACES / 2;

/// The size steps of some sources: within one of them no class has another answer.
#[derive(Debug)]
pub(super) struct Steps {
    /// Upper, inclusive ends, ascending.
    ends: Vec<i64>,
    /// The step of each whole millimetre, rounded up, where all ends are whole millimetres.
    by_millimetre: Vec<u16>,
}

const MM: i64 = 1_000_000;

/// The largest size that the table by millimetres has; beyond, the ends are searched.
const LARGEST_MM: i64 = 4_096;

impl Steps {
    pub(super) fn of(sources: &Sources) -> Self {
        let ends: Vec<i64> = sources.step_ends().iter().map(|end| end.nanometres()).collect();
        let is_whole = ends.iter().all(|end| end % MM == 0 && *end <= LARGEST_MM * MM);
        let last = ends.last().filter(|_| is_whole).map_or(-1, |last| last / MM);
        let step = |mm: i64| ends.partition_point(|end| *end < mm * MM);
        let by_millimetre = (0..=last).map(|mm| u16::try_from(step(mm)).unwrap_or(u16::MAX)).collect();
        Self { ends, by_millimetre }
    }

    /// The step of a size above zero; `None` beyond the last one.
    #[inline]
    fn of_size(&self, nominal: Length) -> Option<usize> {
        let nm = nominal.nanometres();
        let mm = usize::try_from((nm + MM - 1) / MM).ok()?;
        if let Some(step) = self.by_millimetre.get(mm) {
            return Some(usize::from(*step));
        }
        let step = self.ends.partition_point(|end| *end < nm);
        (step < self.ends.len()).then_some(step)
    }
}

/// What is known of a class in a step.
#[derive(Debug, Clone, Copy)]
enum Cell {
    NotAsked,
    /// It has no limits, or some that a callout has to be asked for.
    None,
    Deviations(Deviations),
}

/// A class that was met, and how many rows had it.
#[derive(Debug)]
pub(super) struct Known {
    class: ToleranceClass,
    feature: Feature,
    cells: Vec<Cell>,
}

/// The classes that one worker has met so far.
#[derive(Debug)]
pub(super) struct Classes<'a> {
    sources: &'a Sources,
    steps: &'a Steps,
    /// Texts of up to eight bytes, by their hash, and the class of each from 1; 0 where a place is free.
    places: Vec<(u64, u16)>,
    used: usize,
    known: Vec<Known>,
}

impl<'a> Classes<'a> {
    pub(super) fn new(sources: &'a Sources, steps: &'a Steps) -> Self {
        Self { sources, steps, places: vec![(0, 0); PLACES], used: 0, known: Vec::new() }
    }

    /// The number of the class that a text names.
    #[inline]
    pub(super) fn number(&mut self, text: Part<'_>) -> Option<usize> {
        let key = text.packed()?;
        let mut place = hash(key);
        loop {
            match self.places.get(place) {
                Some((found, number)) if *found == key && *number != 0 => return Some(usize::from(*number) - 1),
                Some((_, 0)) => return self.learn(text.bytes(), key, place),
                _ => place = (place + 1) % PLACES,
            }
        }
    }

    #[cold]
    fn learn(&mut self, text: &[u8], key: u64, place: usize) -> Option<usize> {
        if MOST <= self.used {
            return None;
        }
        let class: ToleranceClass = std::str::from_utf8(text).ok()?.parse().ok()?;
        // Written otherwise, it is read each time.
        if class.as_str().as_bytes() != text {
            return None;
        }
        let number = self.number_of(class);
        if let (Some(free), Ok(number)) = (self.places.get_mut(place), u16::try_from(number + 1)) {
            *free = (key, number);
            self.used += 1;
        }
        Some(number)
    }

    /// The number of a class, new if it was not met before.
    pub(super) fn number_of(&mut self, class: ToleranceClass) -> usize {
        if let Some(number) = self.known.iter().position(|known| known.class == class) {
            return number;
        }
        self.known.push(Known { class, feature: class.feature(), cells: vec![Cell::NotAsked; self.steps.ends.len()] });
        self.known.len() - 1
    }

    /// Whether the class with a number is one of holes, and its limit deviations at a size; `None` where the callout has to be asked for.
    #[inline]
    pub(super) fn deviations(&mut self, number: usize, nominal: Length) -> Option<(Feature, Deviations)> {
        let step = self.steps.of_size(nominal)?;
        let known = self.known.get_mut(number)?;
        let cell = known.cells.get_mut(step)?;
        if let Cell::NotAsked = cell {
            *cell = ask(self.sources, known.class, nominal);
        }
        match cell {
            Cell::Deviations(deviations) => Some((known.feature, *deviations)),
            Cell::NotAsked | Cell::None => None,
        }
    }

    /// The class with a number.
    pub(super) fn class(&self, number: usize) -> Option<ToleranceClass> {
        self.known.get(number).map(|known| known.class)
    }
}

#[cold]
fn ask(sources: &Sources, class: ToleranceClass, nominal: Length) -> Cell {
    let limits = Callout::new(nominal, class).ok().and_then(|callout| sources.limits(&callout, None).ok());
    limits.map_or(Cell::None, |limits| Cell::Deviations(limits.deviations))
}

/// A place for a number: the upper bits of a product spread over all places.
#[inline]
fn hash(key: u64) -> usize {
    let spread = key.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 52;
    usize::try_from(spread).unwrap_or_default()
}
