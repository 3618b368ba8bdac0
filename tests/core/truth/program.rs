//! The same tables through the program itself: `import`, `report`, `batch` and `watch`, and what it ends with.

use std::collections::BTreeMap;
use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::files;
use fitcheck::journal::body;
use fitcheck::journal::entry::Checked;
use fitcheck::verdict::Status;

use super::table::{Table, Trap, Truth};
use crate::fuzzing::{Random, variable};

/// Each table is a file and a call of its own.
const TABLES: usize = 8;
const ROWS_OF_A_TABLE: usize = 6;

fn say(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let mut command = cargo_bin_cmd!("fitcheck");
    command.env("HOME", folder).env("XDG_DATA_HOME", folder).env("XDG_CONFIG_HOME", folder);
    let output = command.env_remove("FITCHECK_JOURNAL").current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// The verdicts in a CSV, by the cell of the first of these columns that names a row.
fn verdicts(
    text: &str,
    separator: u8,
    name: &str,
    status: impl Fn(&csv::StringRecord) -> Option<String>,
) -> BTreeMap<String, Status> {
    let mut reader =
        csv::ReaderBuilder::new().delimiter(separator).flexible(true).has_headers(false).from_reader(text.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    let at = rows.first().and_then(|header| header.iter().position(|cell| cell == name)).unwrap_or_default();
    let said = rows.iter().filter_map(|row| {
        let word = status(row)?;
        let status = Status::ALL.into_iter().find(|status| status.word() == word)?;
        Some((row.get(at)?.to_owned(), status))
    });
    said.collect()
}

/// No verdict is another one than the truth.
#[track_caller]
fn hold(way: &str, said: &BTreeMap<String, Status>, truths: &BTreeMap<String, (Truth, String)>) {
    for (name, status) in said {
        let Some((truth, made)) = truths.get(name) else { panic!("{way}: {name} is no row") };
        assert_eq!(truth.status, Some(*status), "{way}: {truth:?}\n{made}");
    }
}

#[test]
fn the_program_says_the_truth_or_refuses_and_its_exit_code_is_never_0_beside_anything_else() {
    let mut random = Random::new(variable("TRUTH_SEED").unwrap_or(20_261_125) ^ 0x00ff_00ff);
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::create_dir(place.join("in")).unwrap();
    let (mut truths, mut plan) = (BTreeMap::new(), String::from("name;callout\n"));
    let mut names = Vec::new();
    for number in 0..TABLES {
        let table = Table::random(&mut random, &format!("T{number}"), ROWS_OF_A_TABLE);
        let name = format!("t{number}.csv");
        files::write(&place.join(&name), &table.bytes).unwrap();
        let described = || format!("{}\n{}", table.made, table.text);
        let (code, out, err) = say(place, &["import", "--format", "csv", &name]);
        let is_good =
            |truth: &Truth| truth.status == Some(Status::Good) && !truth.is_contradicted && !truth.is_simulated;
        assert!(code != 0 || table.rows.iter().all(is_good), "exit code 0: {out}{err}\n{}", described());
        truths.extend(table.rows.iter().map(|truth| (truth.name.clone(), (truth.clone(), described()))));
        hold("import", &verdicts(&out, b',', "id", |row| row.get(9).map(str::to_owned)), &truths);
        let (code, out, err) = say(place, &["batch", &name]);
        assert!(
            code != 0 || table.rows.iter().all(is_good) || out.contains("REWORK") || out.contains("SCRAP"),
            "exit code 0: {out}{err}\n{}",
            described()
        );
        let behind = |row: &csv::StringRecord| row.get(row.len().checked_sub(3)?).map(str::to_owned);
        hold("batch", &verdicts(&out, table.separator, "", behind), &truths);
        // What a plan knows better than the callouts of a table is no fault of the table.
        if !matches!(table.trap, Trap::Micrometres) {
            plan.extend(table.rows.iter().map(|truth| format!("{};{}\n", truth.name, truth.callout)));
            files::write(&place.join("in").join(&name), &table.bytes).unwrap();
        }
        names.push(name);
    }
    let arguments: Vec<&str> = ["report", "-o", "r.csv"].into_iter().chain(names.iter().map(String::as_str)).collect();
    say(place, &arguments);
    if let Ok(text) = std::fs::read_to_string(place.join("r.csv")) {
        let header = text.lines().next().unwrap_or_default().split(',').position(|name| name == "status");
        let status = |row: &csv::StringRecord| header.and_then(|at| row.get(at)).map(str::to_owned);
        hold("report", &verdicts(&text, b',', "id", status), &truths);
    }
    files::write(&place.join("plan.csv"), plan.as_bytes()).unwrap();
    let watch = ["watch", "in", "--plan", "plan.csv", "--journal", "j.sqlite", "--until-idle", "2"];
    let (code, out, err) = say(place, &watch);
    assert_ne!(code, 0, "some of it is not good\n{out}{err}");
    let reader = fitcheck::store::local::Reader::open(&place.join("j.sqlite")).unwrap();
    let mut said = BTreeMap::new();
    for kept in reader.entries(1, 10_000).unwrap() {
        let entry = body::read(&kept.body).unwrap();
        if let Some(Checked::Size(record)) = entry.check().map(|check| &check.what) {
            let is_simulated = record.measurement.origin.is_simulated();
            assert_eq!(is_simulated, truths[&record.id].0.is_simulated, "recorded: {}", record.id);
            said.insert(record.id.clone(), record.verdict.status());
        }
    }
    hold("watch", &said, &truths);
    assert!(!said.is_empty(), "{out}{err}");
}
