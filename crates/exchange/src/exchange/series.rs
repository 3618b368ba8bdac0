//! A series of parts: what the words before a field or above a column say of a part and of its values.
//!
//! Words of a figure (`words::role`) end a label, and what stands before them is the name: `BORE 1 MIN`, `F1_MAX`. A name begins a group,
//! and so does a figure that the group has already. A group has one value: the measured one, or the only number without a word of a
//! limit. Means and ranges are of several parts, and a temperature or a deviation is no size: neither is a value.

use super::beside::is_deviation;
use super::imported::Labels;
use super::role::Role;
use super::vocabulary::{KNOWN, Names, Rank};
use super::words;

/// Names of a counter, besides those of a part and of a serial number.
static COUNTERS: Names = Names::of(
    "count|counter|part count|part counter|piece|piece no|sample|stück|stueck|stück nr|stueck nr|zähler|zaehler|\
    teilezähler|teilezaehler|stuk|stuk nr|teller|contatore|contapezzi|pezzo n|compteur|contador",
);

/// What a field says of the part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tells {
    Counter,
    Label(Role),
}

impl Tells {
    /// What a label says of a text or of a whole number: a whole number that stands behind the word of a part counts the parts.
    pub(super) fn of(label: &str, is_text: bool) -> Option<Self> {
        let label = label.trim_end_matches([':', '=']);
        let is_counter = COUNTERS.has(&words::bare(label));
        match words::label(label) {
            Some(Role::Part) if !is_text => Some(Self::Counter),
            Some(role @ (Role::Part | Role::Serial | Role::Who | Role::Machine | Role::Batch)) => {
                Some(Self::Label(role))
            }
            _ => is_counter.then_some(Self::Counter),
        }
    }

    /// Whether it says which part it is.
    pub(super) const fn is_of_part(self) -> bool {
        matches!(self, Self::Counter | Self::Label(Role::Part | Role::Serial))
    }
}

/// What is said of a part: a counter tells it where no serial number does.
pub(super) fn labels<'t>(said: impl Iterator<Item = (Tells, &'t str)>) -> Labels {
    let mut labels = Labels::default();
    for (tells, text) in said.filter(|(_, text)| !text.is_empty()) {
        let place = match tells {
            Tells::Counter => &mut labels.sample,
            Tells::Label(Role::Serial) => &mut labels.serial,
            Tells::Label(Role::Who) => &mut labels.who,
            Tells::Label(Role::Machine) => &mut labels.machine,
            Tells::Label(Role::Batch) => &mut labels.batch,
            Tells::Label(_) => &mut labels.part,
        };
        if place.is_empty() {
            text.clone_into(place);
        }
    }
    if labels.serial.is_empty() {
        labels.serial = std::mem::take(&mut labels.sample);
    }
    labels
}

/// What a number is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Figure {
    Nominal,
    Minimum,
    Maximum,
    Measured,
    /// Of several parts, or no size.
    Other,
}

/// The figure that a whole label or its end says.
fn figure(words: &str, is_whole: bool) -> Option<Figure> {
    let said = match words::role(words) {
        Some((Role::Nominal, Rank::Exact)) => Some(Figure::Nominal),
        Some((Role::Minimum, _)) => Some(Figure::Minimum),
        Some((Role::Maximum, _)) => Some(Figure::Maximum),
        Some((Role::Measured, Rank::Exact)) => Some(Figure::Measured),
        Some((Role::Measured, Rank::Weak)) if is_whole => Some(Figure::Measured),
        _ => None,
    };
    let is_other = |word: &str| {
        let word = word.to_lowercase();
        let is_axis = matches!(word.as_str(), "x" | "y" | "z");
        !is_axis && (KNOWN.other.contains(word.as_str()) || KNOWN.strange.contains(word.as_str()))
    };
    let is_other = || is_deviation(words) || words::is_of_several_parts(words) || is_other(words);
    said.or_else(|| is_other().then_some(Figure::Other))
}

/// A label as a name and the figure that it ends with.
pub(super) fn said(label: &str) -> (String, Option<Figure>) {
    let label = label.trim_matches([':', '=', ';', ',', '|', ' ', '\t', '/', '(', ')']);
    let words: Vec<&str> = label.split_whitespace().map(|word| word.trim_matches([':', '=', ';', ',', '|'])).collect();
    let end = |from: usize| words.get(from..).unwrap_or_default().join(" ");
    for from in 0..words.len() {
        if let Some(figure) = figure(&end(from), from == 0) {
            return (words.get(..from).unwrap_or_default().join(" "), Some(figure));
        }
    }
    // Names of columns have no blanks: `F1_MIN`.
    if let Some((name, figure)) = label.rsplit_once('_').and_then(|(name, end)| Some((name, figure(end, false)?))) {
        return (name.to_owned(), Some(figure));
    }
    // `GEMESSENER DURCHMESSER`: a word within says it, and no name stands before one.
    match words::role(&end(0)) {
        Some((Role::Measured, Rank::Contained)) => (String::new(), Some(Figure::Measured)),
        Some((Role::Nominal, Rank::Contained)) => (String::new(), Some(Figure::Nominal)),
        _ => (end(0), None),
    }
}

/// The figures of one name.
#[derive(Debug, Default)]
pub(super) struct Group {
    pub(super) name: String,
    figures: Vec<(Figure, usize)>,
    /// Numbers without a word of a figure.
    plain: Vec<usize>,
    /// The field that its name stands before.
    pub(super) from: usize,
    /// Its last number.
    pub(super) last: usize,
}

impl Group {
    fn has(&self, figure: Option<Figure>) -> bool {
        figure.map_or(!self.plain.is_empty(), |figure| self.at(figure).is_some())
    }

    /// The field of a figure.
    pub(super) fn at(&self, wanted: Figure) -> Option<usize> {
        self.figures.iter().find(|(figure, _)| *figure == wanted).map(|(_, at)| *at)
    }

    /// Its fields.
    pub(super) fn all(&self) -> impl Iterator<Item = usize> {
        self.figures.iter().map(|(_, at)| *at).chain(self.plain.iter().copied())
    }

    /// The field of its value; `None` where it has none, or several.
    pub(super) fn measured(&self) -> Option<usize> {
        match (self.at(Figure::Measured), self.plain.as_slice()) {
            (Some(measured), []) => Some(measured),
            (None, [only]) => Some(*only),
            _ => None,
        }
    }
}

/// Adds a number to the groups; `from` is the field that its name stands before.
pub(super) fn add(groups: &mut Vec<Group>, (from, at): (usize, usize), name: String, figure: Option<Figure>) {
    if figure == Some(Figure::Other) {
        return;
    }
    if groups.last().is_none_or(|last| !name.is_empty() && last.name != name || last.has(figure)) {
        groups.push(Group { name, from, ..Group::default() });
    }
    let Some(group) = groups.last_mut() else { return };
    match figure {
        Some(figure) => group.figures.push((figure, at)),
        None => group.plain.push(at),
    }
    group.last = at;
}
