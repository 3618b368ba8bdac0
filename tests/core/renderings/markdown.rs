//! The report as Markdown: its tables, and that a text stays a text.

use super::lots::{bytes, corrected, hostile, lot, undecided};
use super::*;

fn page(report: &Report, language: Language) -> String {
    String::from_utf8(bytes("markdown", report, language)).unwrap()
}

/// The cells of every row of tables: a bar with a backslash before it is no end of a cell.
fn rows(page: &str) -> Vec<Vec<String>> {
    let cells = |line: &str| {
        let line = line.strip_prefix("| ")?.strip_suffix(" |")?.replace("\\|", "\u{1}");
        Some(line.split(" | ").map(|cell| cell.replace('\u{1}', "|")).collect())
    };
    page.lines().filter_map(cells).collect()
}

#[test]
fn a_check_is_a_row() {
    let page = page(&report(vec![good(), rework(), out_of_position()]), Language::En);
    let expected = "# Inspection report

**SIMULATED**: One value is simulated: nobody measured it, so it cannot make the part good.

- **Date**: 2026-11-21 11:00:00
- **Program**: Fitcheck 0.0.0

## Checks

- \u{2713} GOOD: 1
- \u{21bb} REWORK: 1
- \u{2013} SIMULATED: 1
- Total: 3

";
    assert!(page.starts_with(expected), "{page}");
    let rows = rows(&page);
    assert_eq!(rows.len(), 4);
    assert!(rows.iter().all(|row| row.len() == 15), "{rows:#?}");
    assert_eq!(
        rows[2][..9],
        ["2", "", "25 H7", "hole", "25.000 mm", "25.021 mm", "24.998 mm", "\u{2212}2 µm", "\u{21bb} REWORK"]
    );
    assert!(rows[2][14].starts_with("2 µm too small; To remove on diameter: 2 µm to the nearest limit"), "{rows:#?}");
    assert_eq!(rows[3][8], "\u{2013} SIMULATED SCRAP");
    assert!(rows[3][14].contains("Y \u{2212}0.012 mm, permitted ± 0.010 mm: OUT"), "{rows:#?}");
}

#[test]
fn a_part_begins_with_its_standing_and_what_it_lacks() {
    let page = page(&lot(), Language::En);
    for text in [
        "## Flange 4711, serial number 17\n\n**\u{2713} GOOD**: 3 measured, 0 missing, 0 skipped\n",
        "## Flange 4711, serial number 18\n\n**\u{2013} No verdict yet**: 1 measured, 1 missing, 1 skipped\n",
        "- Missing: SEAT\n",
        "- SLOT: skipped: no gauge\n",
        "**\u{2717} SCRAP**: 3 measured",
        "- **SIMULATED**\n",
        "| 3a | SLOT | 12 H9 |",
        "\u{2013} SIMULATED GOOD",
        "\u{2013} not measured",
    ] {
        assert!(page.contains(text), "{text:?} is missing in\n{page}");
    }
}

#[test]
fn a_guard_band_and_a_correction_are_said() {
    let page = page(&report(vec![undecided(), corrected()]), Language::En);
    for text in ["? RE-MEASURE", "guard band of the decision rule", "measured 25.012000 mm at 26 °C", "ILAC-G8"] {
        assert!(page.contains(text), "{text:?} is missing in\n{page}");
    }
    assert!(!page.contains("\u{2713} GOOD: 2"));
}

#[test]
fn no_name_becomes_anything_but_a_text() {
    let page = page(&hostile(), Language::En);
    let expected = super::lots::EVIL.len();
    assert_eq!(page.matches("\n# ").count(), 0, "{page}");
    assert_eq!(page.matches("\n## ").count(), expected + 2, "{page}");
    for begun in ["<", "![", "](", "://", "www.", "f@g"] {
        let ends = page.split(begun).collect::<Vec<_>>();
        let (_last, before) = ends.split_last().unwrap();
        assert!(before.iter().all(|text| text.ends_with('\\')), "{begun}: {page}");
    }
    assert!(!page.contains(['\0', '\u{1b}', '\u{202e}', '\r']));
    assert!(rows(&page).iter().all(|row| matches!(row.len(), 9 | 15)), "{page}");
}

#[test]
fn every_language_has_its_texts() {
    for language in Language::all() {
        let page = page(&lot(), language);
        assert!(!page.contains("report-") && !page.contains("page-") && !page.contains("{ $"), "{page}");
    }
    assert!(page(&lot(), Language::Nl).contains("GESIMULEERD"));
}
