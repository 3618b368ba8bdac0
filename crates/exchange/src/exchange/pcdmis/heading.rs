//! The heading of a dimension: what it is of, in which unit, and which column is which.

use super::super::units;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use fitcheck_core::length::Unit;

/// A dimension, by the lines above its columns.
#[derive(Debug, Clone, Default)]
pub(super) struct Title {
    /// What the report calls the dimension, such as `LOC1`.
    pub(super) label: String,
    /// What is measured, such as `LOCATION`.
    pub(super) kind: String,
    /// The feature, where the dimension is of one alone.
    pub(super) feature: Option<String>,
    unit: Option<String>,
}

impl Title {
    /// Reads `DIM #1 LOC1= LOCATION OF CIRCLE CIR5 UNITS=MM`, of which the options may stand in further lines.
    pub(super) fn of(text: &str) -> Self {
        let text = text.trim();
        let rest = text.strip_prefix("DIM").unwrap_or(text).trim_start();
        let (label, rest) = rest.split_once('=').unwrap_or(("", rest));
        // Before the label may stand a running number.
        let label = label.split_whitespace().last().unwrap_or_default().to_owned();
        let words: Vec<&str> = rest.split([' ', '\t', ',', '$']).filter(|word| !word.is_empty()).collect();
        let unit = words.iter().find_map(|word| word.strip_prefix("UNITS=")).map(str::to_owned);
        let said: Vec<&str> = words.into_iter().take_while(|word| !word.contains('=')).collect();
        let is_link = |word: &&&str| matches!(**word, "OF" | "FROM" | "BETWEEN");
        let kind: Vec<&str> = said.iter().take_while(|word| !is_link(word)).copied().collect();
        let is_of_one = said.contains(&"OF") && !said.iter().any(|word| matches!(*word, "TO" | "FROM" | "BETWEEN"));
        let feature = said.last().filter(|_| is_of_one).map(|name| (*name).to_owned());
        Self { label, kind: kind.join(" "), feature, unit }
    }

    /// The unit of its lengths; `None` where the report says none.
    ///
    /// # Errors
    /// A unit that is not known.
    pub(super) fn unit(&self) -> Result<Option<Unit>, ImportErrorKind> {
        let Some(unit) = &self.unit else { return Ok(None) };
        units::known(unit).map(Some).ok_or_else(|| ImportErrorKind::Unit { unit: shorten(unit) })
    }

    /// Whether its values are angles.
    pub(super) fn is_of_angle(&self) -> bool {
        let is_angle = |word: &str| matches!(word, "ANGLE" | "ANGLES");
        let is_degree = |unit: &str| matches!(unit.to_ascii_uppercase().as_str(), "DEG" | "DEGREE" | "DEGREES" | "RAD");
        self.kind.split(' ').any(is_angle) || self.unit.as_deref().is_some_and(is_degree)
    }

    /// Whether its values are distances or sizes, which have a nominal value; those of form and place have 0.
    pub(super) fn has_nominal(&self) -> bool {
        let words = ["DISTANCE", "LOCATION", "LENGTH", "KEYIN", "WIDTH", "SIZE"];
        self.kind.split(' ').any(|word| words.contains(&word))
    }
}

/// What stands in a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Column {
    Nominal,
    Plus,
    Minus,
    Bonus,
    Measured,
    Deviation,
    Beyond,
    /// Nothing that is used.
    Other,
}

/// The columns of a dimension, in their order.
#[derive(Debug, Clone)]
pub(super) struct Columns(pub(super) Vec<Heading>);

/// The name of a column, and where it ends, in characters.
#[derive(Debug, Clone)]
pub(super) struct Heading {
    pub(super) column: Column,
    pub(super) name: String,
    pub(super) end: usize,
}

/// How measured values are called.
pub(super) const MEASURED: &str = "MEAS";

impl Columns {
    /// The columns of a line that names them: `AX NOMINAL +TOL -TOL MEAS DEV OUTTOL`, in any order.
    pub(super) fn of(text: &str) -> Option<Self> {
        let mut words = words(text).into_iter();
        let (first, _) = words.next()?;
        if !matches!(first.as_str(), "AX" | "AXIS") {
            return None;
        }
        let headings: Vec<Heading> =
            words.map(|(name, end)| Heading { column: column(&name.to_uppercase()), name, end }).collect();
        let known = headings.iter().filter(|heading| heading.column != Column::Other).count();
        (2 <= known).then_some(Self(headings))
    }

    pub(super) fn has(&self, column: Column) -> bool {
        self.0.iter().any(|heading| heading.column == column)
    }

    /// The names of the columns that are not used.
    pub(super) fn skipped(&self) -> impl Iterator<Item = &str> {
        self.0.iter().filter(|heading| heading.column == Column::Other).map(|heading| heading.name.as_str())
    }
}

fn column(name: &str) -> Column {
    match name {
        "NOMINAL" | "NOM" => Column::Nominal,
        "+TOL" => Column::Plus,
        "-TOL" | "\u{2212}TOL" => Column::Minus,
        "BONUS" => Column::Bonus,
        MEASURED | "MEASURED" | "ACTUAL" => Column::Measured,
        "DEV" => Column::Deviation,
        "OUTTOL" | "OUT-TOL" => Column::Beyond,
        _ => Column::Other,
    }
}

/// The words of a line, each with where it ends, in characters.
pub(super) fn words(text: &str) -> Vec<(String, usize)> {
    let mut words: Vec<(String, usize)> = Vec::new();
    let mut is_within = false;
    for (at, sign) in text.chars().enumerate() {
        if sign.is_whitespace() {
            is_within = false;
            continue;
        }
        match words.last_mut().filter(|_| is_within) {
            Some((word, end)) => {
                word.push(sign);
                *end = at + 1;
            }
            None => words.push((sign.to_string(), at + 1)),
        }
        is_within = true;
    }
    words
}
