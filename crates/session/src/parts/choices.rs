//! The words that a cell of a plan may have, where it may have only a few.

use fitcheck_core::part::{Column, FeatureKind};
use fitcheck_core::tolerance::Feature;
use fitcheck_core::verdict::rules::RuleName;

use super::PartsPage;

impl PartsPage {
    /// The words that the cell may have which is typed into, those that begin with what is typed; every word where it has one of them.
    /// None where anything may be typed.
    pub fn choices(&self) -> Vec<&'static str> {
        let (row, column) = self.sheet.at();
        let typed = self.document.draft().rows.get(row).map_or("", |row| row.cell(column).text.trim()).to_lowercase();
        let words = words(column);
        if words.contains(&typed.as_str()) {
            return words;
        }
        words.into_iter().filter(|word| word.starts_with(&typed)).collect()
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
