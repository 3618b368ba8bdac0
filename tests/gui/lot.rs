//! A lot of fifty flanges with twelve features: from the walk through each part to the statistics and a report to sign, without a command line.

use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::journal::ask::{AskedKinds, Question};
use fitcheck::length::Length;
use fitcheck::session::Page;
use fitcheck::store::local::Reader;

use crate::harness::{DESK, click, press, rows, scan, type_into};
use crate::walk_page::{Harnessed, until, window_of};

const PARTS: usize = 50;

/// A value near the middle of the limits that are asked for, another one for each part.
fn measured(page: &Harnessed, part: usize) -> Option<String> {
    let size = page.state().session().parts().walking.asked()?;
    let [lower, upper] = [size.limits.minimum(), size.limits.maximum()].map(Length::nanometres);
    let steps = i64::try_from(part * 7 % 11 + part * part % 5).unwrap();
    let nanometres = i64::midpoint(lower, upper) + (steps - 7) * (upper - lower) / 40;
    Some(Length::from_nanometres(nanometres / 100 * 100).unwrap().to_string())
}

/// What is heard of the page of the report that is in sight.
fn heard(page: &Harnessed) -> String {
    page.get_by_role(Role::Document).accesskit_node().label().unwrap_or_default()
}

#[test]
fn fifty_parts_of_twelve_features_end_in_a_report_to_sign() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = window_of(folder.path(), DESK).open();
    let mut sizes = 0;
    for part in 0..PARTS {
        type_into(&mut page, "Serial number", &format!("A-{:04}", part + 1));
        press(&mut page, Key::Enter);
        while let Some(value) = measured(&page, part) {
            // The focus stands in the field of the value, from the first feature to the last.
            scan(&mut page, &format!("{value}⏎"));
            sizes += 1;
        }
        press(&mut page, Key::F8);
    }
    assert_eq!(sizes, 13 * PARTS, "a boss has two sizes");
    click(&mut page, Role::Button, "Statistics");
    until(&mut page, |page| page.state().session().statistics().features().len() == 13);
    assert!(rows(&page).iter().all(|row| row.contains("50 values, Ppk ")), "{:?}", rows(&page));
    click(&mut page, Role::Button, "Report…");
    assert_eq!(page.state().session().page(), Page::Reports);
    until(&mut page, |page| page.query_by_role(Role::Document).is_some());
    for _ in 0..13 {
        press(&mut page, Key::PageDown);
    }
    let last = heard(&page);
    assert!(last.contains("Signature"), "{last}");
    let pdf = folder.path().join("lot.pdf");
    click(&mut page, Role::Button, "Save PDF…");
    type_into(&mut page, "File", &pdf.display().to_string());
    press(&mut page, Key::Enter);
    until(&mut page, |_| pdf.exists());
    assert!(std::fs::read(&pdf).unwrap().starts_with(b"%PDF-1.7"));
    // The journal knows which values the report has.
    let reader = Reader::open(&folder.path().join("journal.sqlite")).unwrap();
    let checks = reader.numbers(&Question { kinds: AskedKinds::Checks, ..Question::default() }, None, 1_000).unwrap();
    assert_eq!(checks.len(), sizes);
    let report = reader.head().unwrap().number;
    assert!(checks.iter().all(|number| reader.reports_of(*number).unwrap() == [report]));
}
