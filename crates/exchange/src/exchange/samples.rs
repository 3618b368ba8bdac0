//! Measured values side by side: each row of a table is a characteristic, and each of some columns is a part or a repeat.

use csv::StringRecord;

use super::cell::single_blanks;
use super::claim::letters;
use super::column::name_of;
use super::given::shorten;
use super::vocabulary::Names;
use crate::exchange::cell::Cells as _;

/// Words before the numbers of such columns: `Sample 1`, `Teil 2`. A measured value with a number is asked about.
static BEFORE: Names = Names::of(
    "|sample|samples|s|part|pc|pcs|piece|specimen|unit|teil|stück|stueck|muster|stichprobe|probe|monster|stuk|campione|pezzo|\
    échantillon|pièce|muestra|pieza|x|n|no|nr",
);

/// The columns whose names are counted from 1, one beside the other, where two or more are.
pub(super) fn counted(names: &StringRecord) -> Vec<usize> {
    let mut best: Vec<usize> = Vec::new();
    let mut run: Vec<usize> = Vec::new();
    let mut word = String::new();
    for (at, name) in names.iter().enumerate() {
        let Some((before, number)) = split(name) else {
            run.clear();
            continue;
        };
        if number != run.len() + 1 || !run.is_empty() && before != word {
            run.clear();
        }
        if number == run.len() + 1 {
            run.push(at);
            word = before;
        }
        if best.len() < run.len() {
            best.clone_from(&run);
        }
    }
    if best.len() < 2 { Vec::new() } else { best }
}

/// The word and the number of a name.
fn split(name: &str) -> Option<(String, usize)> {
    let name = name.trim();
    let word = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = name.strip_prefix(word)?.parse().ok()?;
    let word = letters(word);
    BEFORE.has(&word).then_some((word, number))
}

/// Whether a column has a name of this kind, whatever stands beside it.
pub(super) fn is_one(name: &str) -> bool {
    split(name).is_some()
}

/// What one of them is called.
pub(super) fn name(header: &str) -> String {
    shorten(&single_blanks(header))
}

/// The first and the last of such columns, as messages name them.
pub(super) fn range(names: &StringRecord, samples: &[usize]) -> String {
    let name = |at: Option<&usize>| at.map_or_else(String::new, |at| name_of(*at, names.cell(*at)));
    format!("{} … {}", name(samples.first()), name(samples.last()))
}
