//! The words that a cell of a plan may have, where it may have only a few.

use fitcheck_core::part::{Column, FeatureKind};
use fitcheck_core::tolerance::Feature;
use fitcheck_core::verdict::rules::RuleName;

use super::PartsPage;

impl PartsPage {
    /// The words that the cell may have which is typed into, those that begin with what is typed; every word where it has one of them, or
    /// where none begins so. None where anything may be typed.
    pub fn choices(&self) -> Vec<&'static str> {
        let (row, column) = self.sheet.at();
        let typed = self.document.draft().rows.get(row).map_or("", |row| row.cell(column).text.trim()).to_lowercase();
        let words = words(column);
        if words.contains(&typed.as_str()) {
            return words;
        }
        let begun: Vec<_> = words.iter().copied().filter(|word| word.starts_with(&typed)).collect();
        if begun.is_empty() { words } else { begun }
    }

    /// Every word that the cell may have at which the keys are; none where anything may be typed.
    pub fn words_here(&self) -> Vec<&'static str> {
        words(self.sheet.at().1)
    }
}

fn words(column: Column) -> Vec<&'static str> {
    match column {
        Column::Kind => FeatureKind::WORDS.to_vec(),
        Column::Feature => [Feature::Hole, Feature::Shaft].map(Feature::word).to_vec(),
        Column::Rule => RuleName::ALL.into_iter().map(RuleName::word).collect(),
        _ => Vec::new(),
    }
}
