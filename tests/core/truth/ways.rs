//! The ways that a table takes to its verdicts, each as the program goes it.

use std::collections::BTreeMap;

use fitcheck::batch::{Input, Manner, Packing, Watch, run};
use fitcheck::exchange::batch::{Csv, Cutter, Layout, StreamJudging};
use fitcheck::exchange::{ByPlan, ImportWarningKind, Imported, Item, import, import_each};
use fitcheck::session::{CheckCommand, Command, Session};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use fitcheck::words::Language;
use jiff::civil::{DateTime, date};

use super::table::{Table, Trap};

/// What a way says of a row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Said {
    pub status: Status,
    pub is_simulated: bool,
    /// Whether it tells that the file's own status is another one.
    pub is_contradicted: bool,
}

/// What it says of the rows that it judges, by their names.
pub type Answers = BTreeMap<String, Said>;

pub struct Way {
    pub name: &'static str,
    pub say: fn(&Table) -> Answers,
    /// Whether each of its answers says that nobody measured, and that the file's own status is another one.
    pub tells: bool,
}

pub const WAYS: [Way; 5] = [
    Way { name: "import", say: |table| answers(&read("t.csv", &table.bytes)), tells: true },
    Way { name: "workbook", say: |table| answers(&read("t.xlsx", &workbook(table))), tells: true },
    Way { name: "batch", say: batch, tells: false },
    Way { name: "plan", say: by_plan, tells: true },
    Way { name: "window", say: window, tells: false },
];

const NOW: DateTime = date(2026, 11, 25).at(8, 0, 0, 0);

fn read(name: &str, bytes: &[u8]) -> Imported {
    import(name, bytes, &Sources::default(), NOW)
}

/// The lines of rows whose own status is told to be another one.
fn contradicted(imported: &Imported) -> Vec<usize> {
    let of_status = |kind: &ImportWarningKind| matches!(kind, ImportWarningKind::StatusDiffers { .. });
    imported.warnings.iter().filter(|warning| of_status(&warning.what.kind)).filter_map(|w| w.what.row).collect()
}

fn answers(imported: &Imported) -> Answers {
    let contradicted = contradicted(imported);
    let said = imported.records.iter().zip(&imported.lines).map(|(record, line)| {
        let said = Said {
            status: record.verdict.status(),
            is_simulated: record.measurement.origin.is_simulated(),
            is_contradicted: contradicted.contains(line),
        };
        (record.id.clone(), said)
    });
    said.collect()
}

/// The cells of the text as those of a sheet.
fn cells(table: &Table) -> Vec<Vec<String>> {
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(table.separator)
        .has_headers(false)
        .flexible(true)
        .from_reader(table.text.as_bytes());
    reader.records().map(|row| row.unwrap().iter().map(str::to_owned).collect()).collect()
}

fn workbook(table: &Table) -> Vec<u8> {
    let rows = cells(table);
    let rows: Vec<Vec<&str>> = rows.iter().map(|row| row.iter().map(String::as_str).collect()).collect();
    let rows: Vec<&[&str]> = rows.iter().map(Vec::as_slice).collect();
    crate::xlsx::workbook(&rows)
}

fn batch(table: &Table) -> Answers {
    let text = table.text.as_bytes();
    let Ok(layout) = Layout::of(text, true, "t.csv") else { return Answers::new() };
    let sources = Sources::default();
    let court = StreamJudging::new(&layout, &sources);
    let mut input = &text[layout.skip..];
    let cutter = Cutter::new(layout.separator(), 1 << 20, true);
    let mut out = Csv::header(&layout, "");
    let manner = Manner { workers: 1, packing: Packing::Plain, prefix: "" };
    let input = Input { stream: &mut input, cutter };
    run::<Csv>(input, &court, manner, &mut out, &Watch::default(), &mut |_| {}).unwrap();
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(layout.separator())
        .has_headers(false)
        .flexible(true)
        .from_reader(out.as_slice());
    let rows = reader.records().map(Result::unwrap).filter_map(|row| {
        // The last cells are the answer: min, max, deviation, status, what to remove, error.
        let word = row.get(row.len().checked_sub(3)?)?;
        let status = Status::ALL.into_iter().find(|status| status.word() == word)?;
        Some((row[0].to_owned(), Said { status, is_simulated: false, is_contradicted: false }))
    });
    rows.collect()
}

/// The same values judged by a plan with the limits that are true.
fn by_plan(table: &Table) -> Answers {
    if table.trap == Trap::Micrometres {
        // The plan says what the callouts do not.
        return Answers::new();
    }
    let features = table.rows.iter().map(|truth| format!("{};{}\n", truth.name, truth.callout));
    let plan = crate::plans::plan(&format!("name;callout\n{}", features.collect::<String>()));
    let by_plan = ByPlan::new(&plan);
    let mut judged = Imported::default();
    let mut take = |item: Item| match item {
        Item::Record { line, record, .. } => {
            judged.records.push(*record);
            judged.lines.push(line);
        }
        Item::Warning(warning) => judged.warnings.push(warning),
        _ => {}
    };
    import_each("t.csv", &table.bytes, &Sources::default(), NOW, &mut |item| by_plan.item(item, &mut take));
    answers(&judged)
}

/// What the window keeps of a file that was imported on its check page.
fn window(table: &Table) -> Answers {
    let mut session = Session::new(Language::default());
    let result = Ok(Box::new(read("t.csv", &table.bytes)));
    session.apply(Command::Check(CheckCommand::Imported { name: "t.csv".into(), result }), NOW);
    let listed = session.history().listed();
    let said = listed.page(0..listed.count()).into_iter().map(|(_, record)| {
        let said = Said {
            status: record.verdict.status(),
            is_simulated: record.measurement.origin.is_simulated(),
            is_contradicted: false,
        };
        (record.id.clone(), said)
    });
    said.collect()
}
