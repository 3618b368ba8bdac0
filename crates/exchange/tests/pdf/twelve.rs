//! A part with twelve features, one of them missing and one to rework: every rendering and kind of report, in four languages.

use std::io::Cursor;
use std::path::Path;
use std::sync::Arc;

use fitcheck_core::message::message;
use fitcheck_core::part::Document;
use fitcheck_core::tolerance::Sources;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::{Language, Words};
use fitcheck_exchange::exchange::{ByPlan, ImportInputs, Item, import_from};
use fitcheck_exchange::report::image::Image;
use fitcheck_exchange::report::paper::Paper;
use fitcheck_exchange::report::part::PartSheet;
use fitcheck_exchange::report::template::{Column, Section, Template};
use fitcheck_exchange::report::{RENDERINGS, Report};

use super::made::{rendered, report as report_of, time};
use super::reader::Pdf;

const LANGUAGES: [&str; 4] = ["en", "de", "nl", "it"];

fn example(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/examples/reports");
    std::fs::read(folder.join(name)).unwrap()
}

/// The part as `fitcheck report --plan housing.toml housing.csv` makes it.
fn housing() -> Report {
    let sources = Sources::default();
    let plan = Arc::new(Document::read(&example("housing.toml")).unwrap().plan(&sources).unwrap());
    let mut sheet = PartSheet::new(&plan, "A-031");
    sheet.picture = Some(Image::read("housing.svg", &example("housing.svg")));
    let names: Vec<String> = plan.sizes().map(|size| size.name()).collect();
    let by_plan = ByPlan::new(&plan);
    let mut checks = Vec::new();
    let given = ImportInputs { has_plan: true, ..ImportInputs::new(&sources, time()) };
    import_from("housing.csv", &mut Cursor::new(example("housing.csv")), given, &mut |item| {
        by_plan.item(item, &mut |item| {
            let Item::Record { record, .. } = item else { panic!("{item:?}") };
            let at = names.iter().position(|name| *name == record.id).unwrap();
            sheet.take(at, Arc::new((*record).clone()), None);
            checks.push(*record);
        });
    });
    assert_eq!((names.len(), checks.len()), (12, 11));
    Report { parts: vec![sheet], part: Some(plan.head.part.clone()), ..report_of(checks) }
}

fn words(language: &str) -> Words {
    Words::new(Language::all().find(|known| known.code() == language).unwrap())
}

/// Name, value and verdict of every check of a file that is read again.
fn read_back(name: &str, bytes: &[u8]) -> Vec<(String, String, Status)> {
    let sources = Sources::default();
    let mut values = Vec::new();
    import_from(name, &mut Cursor::new(bytes), ImportInputs::new(&sources, time()), &mut |item| match item {
        Item::Record { record, .. } => {
            values.push((record.id.clone(), record.measurement.diameter.to_string(), record.verdict.status()));
        }
        // A place without a value, which some formats have for what is missing.
        Item::Unjudged(row) => assert_eq!(row.id, "OIL", "{name}: {}", row.why),
        // QIF has a status for it, and our reader says which.
        Item::Error(error) if error.to_string().ends_with("no measured value here; status NOT_ANALYZED") => {}
        Item::Error(error) => panic!("{name}: {error}"),
        Item::Warning(_) | Item::Contacts(_) => {}
    });
    values
}

fn wanted(report: &Report) -> Vec<(String, String, Status)> {
    let mut all = Vec::new();
    let mut see = |record: &fitcheck_exchange::journal::Record| {
        all.push((record.id.clone(), record.measurement.diameter.to_string(), record.verdict.status()));
        Ok(())
    };
    report.checks.each(&mut see).unwrap();
    all
}

#[test]
fn every_rendering_has_every_feature_in_four_languages() {
    let report = housing();
    let values = wanted(&report);
    assert_eq!(values.iter().filter(|(.., status)| *status == Status::Rework).count(), 1);
    for language in LANGUAGES {
        let words = words(language);
        for rendering in RENDERINGS.iter().filter(|rendering| rendering.refusal(report.paper).is_none()) {
            let bytes = rendered(&report, language, rendering.name);
            let name = format!("housing.{}", rendering.endings[0]);
            match rendering.name {
                "html" | "markdown" => {
                    let page = String::from_utf8_lossy(&bytes).replace('\\', "");
                    for (id, ..) in &values {
                        assert!(page.contains(id.as_str()), "{name} in {language}: {id}");
                    }
                    for said in [words.told(&Status::Rework), "OIL".to_owned(), "A-031".to_owned()] {
                        assert!(page.contains(&said), "{name} in {language}: {said}");
                    }
                }
                "csv" => {
                    let page = String::from_utf8_lossy(&bytes);
                    for (id, measured, status) in &values {
                        let line = page.lines().find(|line| line.contains(&format!(",{id},"))).unwrap();
                        assert!(
                            line.contains(&format!(",{measured},")) && line.contains(&format!(",{},", status.word()))
                        );
                    }
                }
                "dfq" | "qif" => assert_eq!(read_back(&name, &bytes), values, "{name} in {language}"),
                "xlsx" => assert!(bytes.starts_with(b"PK")),
                "json" => {
                    let json: serde_json::Value = serde_json::from_slice(&bytes).unwrap();
                    let of = |check: &serde_json::Value, key: &str| check[key].as_str().unwrap().to_owned();
                    let found: Vec<_> =
                        json["checks"].as_array().unwrap().iter().map(|check| of(check, "id")).collect();
                    assert_eq!(found, values.iter().map(|(id, ..)| id.clone()).collect::<Vec<_>>());
                    assert!(json["parts"].to_string().contains("OIL"), "{}", json["parts"]);
                }
                "pdf" => assert!(bytes.starts_with(b"%PDF")),
                other => panic!("{other} is not looked at: say here what it has to have"),
            }
        }
    }
}

#[test]
fn every_kind_says_what_is_missing_and_has_its_data_attached_in_four_languages() {
    let report = housing();
    let values = wanted(&report);
    for language in LANGUAGES {
        let words = words(language);
        let data = ["csv", "json"].map(|name| rendered(&report, language, name));
        for template in Template::shipped().iter().filter(|template| !template.is_blank()) {
            let report = report.clone().by(template);
            let pdf = Pdf::read(&rendered(&report, language, "pdf"));
            let said = pdf.pages().iter().map(|page| pdf.text(*page)).collect::<Vec<_>>().join(" ");
            let place = format!("{} in {language}", template.word());
            assert!(!said.contains('□') && !said.contains("report-"), "{place}: {said}");
            let missing = words.say(&message!("walk-page-missing").text("names", "OIL"));
            for text in [words.told(&Status::Rework), missing, "A-031".to_owned()] {
                assert!(said.contains(&text), "{place}: {text}: {said}");
            }
            let has = |column| template.has(Section::Features) && template.columns.contains(&column);
            for (id, measured, _) in &values {
                assert!(!has(Column::Feature) || said.contains(id.as_str()), "{place}: {id}: {said}");
                let measured = words.number(measured);
                assert!(!has(Column::Measured) || said.contains(&measured), "{place}: {measured}: {said}");
            }
            if template.has(Section::Statement) {
                let not = message!("report-statement-not").count("bad", 1).count("count", 11);
                assert!(said.contains(&words.say(&not)), "{place}: {said}");
            }
            let attached: Vec<Vec<u8>> = pdf.attachments().into_iter().map(|(.., bytes)| bytes).collect();
            assert_eq!(attached, data, "{place}");
        }
    }
}

#[test]
fn a_label_of_the_part_fits_on_one_small_page_in_four_languages() {
    let label = Template::shipped().iter().find(|template| template.paper.is_label()).unwrap();
    for paper in [Paper::SmallLabel, Paper::LargeLabel] {
        for language in LANGUAGES {
            let report = Report { paper, ..housing().by(label) };
            let pdf = Pdf::read(&rendered(&report, language, "pdf"));
            assert_eq!(pdf.pages().len(), 1, "{language}");
            assert!(rendered(&report, language, "png").starts_with(b"\x89PNG"));
        }
    }
}
