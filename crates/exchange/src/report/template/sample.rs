//! A template to begin with: every key and every word that a template may have, each with what it means in a language of the window.

use std::fmt::Write as _;

use fitcheck_core::words::Words;

use super::{Column, HeadField, Section, Template, VERSION};
use crate::report::paper::Paper;

/// Where what a word means begins.
const MEANING: usize = 20;

impl Template {
    /// The text of a template with the usual sections, head and columns; what is not usual is there as a comment.
    pub fn sample(words: &Words) -> String {
        let papers: Vec<&str> = Paper::ALL.iter().map(|paper| paper.name()).collect();
        let mut text = format!(
            "# {}\nversion = {VERSION}\nname = \"{}\"\n# purpose = \"\"\n# title = \"\"\npaper = \"a4\"  # {}\n# language = \"{}\"  # {}\n",
            words.get("report-template-new-about"),
            words.get("report-template-new-name"),
            papers.join(", "),
            words.language().code(),
            super::languages(),
        );
        let list = |text: &mut String, key: &str, all: &[(&'static str, &'static str, bool)]| {
            // A text in memory takes whatever is written into it.
            let _always = writeln!(text, "{key} = [");
            for (word, meaning, is_usual) in all {
                let word = format!("\"{word}\",");
                let mark = if *is_usual { "" } else { "# " };
                let _always = writeln!(text, "    {mark}{word:MEANING$} # {}", words.get(meaning));
            }
            text.push_str("]\n");
        };
        let sections = |section: &Section| (section.word(), section.text(), Section::usual().contains(section));
        let fields = |field: &HeadField| (field.word(), field.text(), HeadField::usual().contains(field));
        let columns = |column: &Column| (column.word(), column.text(), Column::usual().contains(column));
        list(&mut text, "sections", &Section::ALL.iter().map(sections).collect::<Vec<_>>());
        list(&mut text, "head", &HeadField::ALL.iter().map(fields).collect::<Vec<_>>());
        list(&mut text, "columns", &Column::ALL.iter().map(columns).collect::<Vec<_>>());
        text.push_str(
            "# rule-text = \"\"\n\n[company]\n# name = \"\"\n# address = [\"\", \"\"]\n# logo = \"logo.svg\"\n",
        );
        text
    }
}
