//! How the values of a study go together: parts, operators and readings, and what looks wrong with it.

use std::collections::BTreeMap;

use fitcheck_core::message::Say;
use fitcheck_statistics::gauge::Finding;

use super::value::Value;

fitcheck_core::named! {
    /// A kind of study.
    #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
    pub enum StudyKind {
        ALL;
        /// Its name in files.
        fn word;
        /// Many readings of one master.
        Type1 = "type1",
        /// Every operator reads every part.
        #[default]
        Crossed = "crossed",
        /// Every operator has parts of its own.
        Nested = "nested",
        /// Several masters.
        Linearity = "linearity",
        /// One master over time.
        Stability = "stability",
    }
}

/// How a study was understood.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    pub kind: StudyKind,
    /// Parts, masters, or points of a stability study; in a nested study those of each operator.
    pub parts: usize,
    pub operators: usize,
    /// The readings of a part, by one operator: least and most.
    pub readings: [usize; 2],
}

/// How the values of a study were understood, before anything is computed of them.
#[derive(Debug, Clone, PartialEq)]
pub struct Understood {
    pub layout: Layout,
    /// What looks wrong with it.
    pub doubts: Vec<Finding>,
    /// What is missing, or is there too often.
    pub faults: Vec<StudyError>,
}

/// Why values make no study.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "series-study", error)]
pub enum StudyError {
    /// Values that name no part.
    NoParts { count: usize },
    /// Values that name no operator, beside others that do.
    NoOperators { count: usize },
    /// A cell with another number of readings than the others.
    UnevenCell { part: String, operator: String, found: usize, needed: usize },
    /// An operator with another number of parts than the others.
    UnevenOperator { operator: String, found: usize, needed: usize },
    /// A crossed study in which each part was read by one operator.
    Nested,
    /// Values without a calibrated size.
    NoReference { count: usize },
    /// A master with several sizes.
    References,
}

/// Readings by part and operator.
#[derive(Debug)]
pub(super) struct Cells {
    pub(super) readings: Vec<Vec<Vec<f64>>>,
    pub(super) understood: Understood,
}

/// Names in the order in which they come.
#[derive(Debug, Default)]
struct Names<'a> {
    known: BTreeMap<&'a str, usize>,
    names: Vec<&'a str>,
}

impl<'a> Names<'a> {
    fn index(&mut self, name: &'a str) -> usize {
        let next = self.names.len();
        let index = *self.known.entry(name).or_insert(next);
        if index == next {
            self.names.push(name);
        }
        index
    }

    fn name(&self, index: usize) -> String {
        self.names.get(index).map_or_else(String::new, |name| (*name).to_owned())
    }
}

/// Puts a value into its cell.
fn put(cells: &mut Vec<Vec<Vec<f64>>>, [outer, inner]: [usize; 2], value: f64) {
    cells.resize_with(cells.len().max(outer + 1), Vec::new);
    let Some(row) = cells.get_mut(outer) else { return };
    row.resize_with(row.len().max(inner + 1), Vec::new);
    if let Some(cell) = row.get_mut(inner) {
        cell.push(value);
    }
}

/// The count that most of them have; of several such counts the largest. What differs from it is what is wrong.
fn usual(counts: impl Iterator<Item = usize>) -> usize {
    let mut often: BTreeMap<usize, usize> = BTreeMap::new();
    for count in counts {
        *often.entry(count).or_default() += 1;
    }
    often.into_iter().max_by_key(|(count, times)| (*times, *count)).map_or(0, |(count, _)| count)
}

/// The parts of values, each of which names one.
fn parts_of(values: &[&Value]) -> Result<Vec<String>, StudyError> {
    match values.iter().filter(|value| value.origin.is_of_no_part()).count() {
        0 => Ok(values.iter().map(|value| value.origin.whole_part()).collect()),
        count => Err(StudyError::NoParts { count }),
    }
}

impl Cells {
    /// The cells of a crossed or a nested study.
    pub(super) fn of(values: &[&Value], is_nested: bool) -> Result<Self, StudyError> {
        let parts = parts_of(values)?;
        let nobody = values.iter().filter(|value| value.origin.who.is_empty()).count();
        if 0 < nobody && nobody < values.len() {
            return Err(StudyError::NoOperators { count: nobody });
        }
        let pairs: Vec<[&str; 2]> =
            parts.iter().zip(values).map(|(part, value)| [part.as_str(), value.origin.who.as_str()]).collect();
        let mut cells = if is_nested { nested(values, &pairs) } else { crossed(values, &pairs)? };
        let Layout { parts, operators, .. } = cells.understood.layout;
        let doubts = &mut cells.understood.doubts;
        if 1 < operators && operators == values.len() {
            doubts.push(Finding::OperatorPerValue);
        } else if parts < operators && !is_nested {
            doubts.push(Finding::MoreOperators { parts, operators });
        }
        Ok(cells)
    }
}

fn crossed(values: &[&Value], pairs: &[[&str; 2]]) -> Result<Cells, StudyError> {
    let (mut parts, mut operators) = (Names::default(), Names::default());
    let mut readings = Vec::new();
    for ([part, operator], value) in pairs.iter().zip(values) {
        put(&mut readings, [parts.index(part), operators.index(operator)], value.measured.to_mm_f64());
    }
    let count = operators.names.len();
    for row in &mut readings {
        row.resize_with(count, Vec::new);
    }
    let has_one = |row: &Vec<Vec<f64>>| row.iter().filter(|cell| !cell.is_empty()).count() == 1;
    if 1 < count && count < values.len() && readings.iter().all(has_one) {
        return Err(StudyError::Nested);
    }
    let needed = usual(readings.iter().flatten().map(Vec::len));
    let cells = readings.iter().enumerate().flat_map(|(part, row)| row.iter().enumerate().map(move |it| (part, it)));
    let uneven = cells.filter(|(_, (_, cell))| cell.len() != needed).map(|(part, (operator, cell))| {
        let (part, operator) = (parts.name(part), operators.name(operator));
        StudyError::UnevenCell { part, operator, found: cell.len(), needed }
    });
    let faults = uneven.collect();
    let layout = Layout { kind: StudyKind::Crossed, parts: parts.names.len(), operators: count, readings: [needed; 2] };
    Ok(Cells { readings, understood: Understood { layout, doubts: Vec::new(), faults } })
}

fn nested(values: &[&Value], pairs: &[[&str; 2]]) -> Cells {
    let mut operators = Names::default();
    let mut parts: Vec<Names<'_>> = Vec::new();
    let mut readings = Vec::new();
    for ([part, operator], value) in pairs.iter().zip(values) {
        let outer = operators.index(operator);
        parts.resize_with(operators.names.len(), Names::default);
        let inner = parts.get_mut(outer).map_or(0, |parts| parts.index(part));
        put(&mut readings, [outer, inner], value.measured.to_mm_f64());
    }
    let most = usual(readings.iter().map(Vec::len));
    let needed = usual(readings.iter().flatten().map(Vec::len));
    let mut faults = Vec::new();
    for (at, row) in readings.iter().enumerate() {
        let operator = operators.name(at);
        if row.len() != most {
            faults.push(StudyError::UnevenOperator { operator: operator.clone(), found: row.len(), needed: most });
        }
        for (inner, cell) in row.iter().enumerate().filter(|(_, cell)| cell.len() != needed) {
            let part = parts.get(at).map_or_else(String::new, |parts| parts.name(inner));
            faults.push(StudyError::UnevenCell { part, operator: operator.clone(), found: cell.len(), needed });
        }
    }
    let is_same = |pair: &[Names<'_>]| matches!(pair, [one, other] if one.known.keys().eq(other.known.keys()));
    let is_crossed = 1 < parts.len() && parts.windows(2).all(is_same);
    let layout =
        Layout { kind: StudyKind::Nested, parts: most, operators: operators.names.len(), readings: [needed; 2] };
    let doubts = is_crossed.then_some(Finding::SameParts).into_iter().collect();
    Cells { readings, understood: Understood { layout, doubts, faults } }
}
