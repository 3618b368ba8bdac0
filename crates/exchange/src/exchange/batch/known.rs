//! Limit deviations looked up once for each tolerance class and size step.

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::{Callout, Deviations, Feature, FigureWarning, Limits, Sources, ToleranceClass};

use crate::exchange::row::Part;

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

/// What is known of a class in a step, in eight bytes, so that the steps of many classes stay near the processor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Cell {
    upper: i32,
    lower: i32,
}

impl Cell {
    /// The upper deviation is never below the lower one, so these three are none.
    const NOT_ASKED: Self = Self { upper: 0, lower: 1 };
    /// There are no limits, or some that a callout has to be asked for.
    const NONE: Self = Self { upper: 0, lower: 2 };
    /// A deviation of two millimetres or more.
    const WIDE: Self = Self { upper: 0, lower: 3 };
}

/// A class that was met.
#[derive(Debug, Clone, Copy)]
struct Known {
    class: ToleranceClass,
    feature: Feature,
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
    /// The steps of each class, one class behind the other.
    cells: Vec<Cell>,
    /// The deviations that no cell has room for, by class and step.
    wide: BTreeMap<(usize, usize), Deviations>,
    /// What to check about the figures that were looked up, by class and step.
    figures: Figures,
}

/// What to check about figures, by class and the end of the size step.
pub type Figures = BTreeMap<(ToleranceClass, Length), FigureWarning>;

impl<'a> Classes<'a> {
    pub(super) fn new(sources: &'a Sources, steps: &'a Steps) -> Self {
        let places = vec![(0, 0); PLACES];
        let wide = BTreeMap::new();
        Self { sources, steps, places, used: 0, known: Vec::new(), cells: Vec::new(), wide, figures: Figures::new() }
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
        self.known.push(Known { class, feature: class.feature() });
        self.cells.resize(self.known.len() * self.steps.ends.len(), Cell::NOT_ASKED);
        self.known.len() - 1
    }

    /// The class with a number and its limit deviations at a size; `None` where the callout has to be asked for.
    #[inline]
    pub(super) fn deviations(
        &mut self,
        number: usize,
        nominal: Length,
    ) -> Option<(ToleranceClass, Feature, Deviations)> {
        let step = self.steps.of_size(nominal)?;
        let Known { class, feature } = *self.known.get(number)?;
        let cell = *self.cells.get(number * self.steps.ends.len() + step)?;
        let of = |nm| Length::constant(i64::from(nm));
        let deviations = match Deviations::new(of(cell.upper), of(cell.lower)) {
            Ok(deviations) => deviations,
            Err(_) => self.rarely(number, step, nominal)?,
        };
        Some((class, feature, deviations))
    }

    /// What is not known yet, or is in no cell.
    #[cold]
    fn rarely(&mut self, number: usize, step: usize, nominal: Length) -> Option<Deviations> {
        let class = self.known.get(number)?.class;
        let cell = self.cells.get_mut(number * self.steps.ends.len() + step)?;
        if *cell == Cell::NOT_ASKED {
            let callout = Callout::new(nominal, class).ok();
            let limits = callout.as_ref().and_then(|callout| self.sources.limits(callout, None).ok());
            let Some(limits) = limits else {
                *cell = Cell::NONE;
                return None;
            };
            note(&mut self.figures, callout.as_ref(), &limits, self.sources);
            let [upper, lower] = [limits.deviations.upper(), limits.deviations.lower()];
            let narrow = |deviation: Length| i32::try_from(deviation.nanometres()).ok();
            let known = narrow(upper).zip(narrow(lower)).map(|(upper, lower)| Cell { upper, lower });
            *cell = known.unwrap_or(Cell::WIDE);
            if known.is_none() {
                self.wide.insert((number, step), limits.deviations);
            }
            return Some(limits.deviations);
        }
        self.wide.get(&(number, step)).copied()
    }

    /// Notes what to check about limits that were looked up elsewhere.
    pub(super) fn note(&mut self, callout: &Callout, limits: &Limits) {
        note(&mut self.figures, Some(callout), limits, self.sources);
    }

    /// What to check about the figures that were looked up.
    pub(super) fn into_figures(self) -> Figures {
        self.figures
    }

    pub(super) fn class(&self, number: usize) -> Option<ToleranceClass> {
        self.known.get(number).map(|known| known.class)
    }
}

fn note(figures: &mut Figures, callout: Option<&Callout>, limits: &Limits, sources: &Sources) {
    let warning = callout.and_then(|callout| FigureWarning::of_limits(callout, limits, sources));
    figures.extend(warning.map(|warning| (warning.cell(), warning)));
}

/// A place for a number: the upper bits of a product spread over all places.
#[inline]
fn hash(key: u64) -> usize {
    let spread = key.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 52;
    let [low, high, ..] = spread.to_le_bytes();
    usize::from(u16::from_le_bytes([low, high]))
}
