//! The ways of a file through the program.

use std::path::Path;
use std::process::Command as Process;

use assert_cmd::cargo::cargo_bin;
use fitcheck::exchange::{Imported, Item, import_from, import_given};
use fitcheck::part::{Column, Document, DraftFeature};
use fitcheck::session::{CheckCommand, Command, Effect, Session};
use fitcheck::tolerance::{Callout, Sources};
use fitcheck::words::Language;

use super::case::{Case, Row, Said, length};
use crate::session_walk::{imported, now, send, size, walking_by};

pub(crate) fn program(folder: &Path, args: &[&str]) -> (i32, String, String) {
    let home = folder.join("home");
    let mut command = Process::new(cargo_bin!("fitcheck"));
    command.current_dir(folder).args(args).env("FITCHECK_JOURNAL", folder.join("j.sqlite"));
    let output = command.env("HOME", &home).env("XDG_STATE_HOME", &home).env("XDG_DATA_HOME", &home).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// The rows of `--format csv`, with their files.
pub(crate) fn answers(out: &str) -> Vec<(String, Said)> {
    let mut reader = csv::Reader::from_reader(out.as_bytes());
    let names = reader.headers().unwrap().clone();
    let at = |name: &str| names.iter().position(|known| known == name).unwrap_or_else(|| panic!("{name}: {names:?}"));
    let [file, id, min, max] = ["file", "id", "min_mm", "max_mm"].map(at);
    let [measured, status, error] = ["measured_mm", "status", "error"].map(at);
    let said = |row: csv::StringRecord| {
        let verdict = if row[status].is_empty() { format!("!{}", &row[error]) } else { row[status].to_owned() };
        let name = row[id].trim_start_matches('\'').to_owned();
        let limits = length(&row[min]).zip(length(&row[max]));
        (row[file].to_owned(), Said { name, measured: length(&row[measured]), limits, verdict })
    };
    // A row without a verdict and without an error is what is said of the file as a whole.
    let is_value = |(_, said): &(String, Said)| said.verdict != "!";
    reader.records().map(|row| said(row.unwrap())).filter(is_value).collect()
}

/// Those of one file.
pub(crate) fn answers_of(file: &str, out: &str) -> Vec<Said> {
    answers(out).into_iter().filter(|(of, _)| of == file).map(|(_, said)| said).collect()
}

/// Names and callouts of a plan, each callout as the program writes it; what is no callout yet is a fault of the plan.
pub(crate) fn features_of(toml: &str) -> Vec<(String, String)> {
    let document = Document::read(toml.as_bytes()).unwrap();
    let text = |row: &DraftFeature, column| row.text(column).unwrap_or_default().to_owned();
    let is_form = |row: &DraftFeature| row.text(Column::Kind) == Some("form");
    let is_whole = |row: &&DraftFeature| is_form(row) || text(row, Column::Callout).parse::<Callout>().is_ok();
    let rows = document.draft.rows.iter().filter(is_whole);
    rows.map(|row| {
        let callout = text(row, Column::Callout);
        (text(row, Column::Name), whole(&callout))
    })
    .collect()
}

/// A callout as the program writes it.
pub(crate) fn whole(callout: &str) -> String {
    callout.parse::<Callout>().map_or_else(|_| callout.to_owned(), |callout| callout.to_string())
}

pub(crate) fn by_command_line(case: &Case, faults: &mut Vec<String>) {
    let place = tempfile::tempdir().unwrap();
    let put = |name: &str, bytes: &[u8]| fitcheck::files::write(&place.path().join(name), bytes).unwrap();
    put(&case.name, &case.bytes);
    let mut args = vec!["import", case.name.as_str(), "--format", "csv"];
    if let Some((name, text)) = &case.mask {
        put(name, text.as_bytes());
        args.extend(["--mask", name]);
    }
    let (code, out, err) = program(place.path(), &args);
    let rows: Vec<&Row> = case.rows.iter().collect();
    case.check("import", &rows, &answers_of(&case.name, &out), faults);
    if code != case.code {
        faults.push(format!("{} by import: exit code {code}, right: {}\n{err}", case.name, case.code));
    }
    if case.features().is_empty() {
        return;
    }
    put("plan.toml", case.plan().as_bytes());
    let (_, out, err) = program(place.path(), &[&args[..], &["--plan", "plan.toml"]].concat());
    let expected = case.rows_by_plan();
    let said = answers_of(&case.name, &out).into_iter().map(|said| Said { limits: None, ..said }).collect::<Vec<_>>();
    case.check(&format!("import --plan\n{err}"), &expected.iter().collect::<Vec<_>>(), &said, faults);
    let made: Vec<(String, String)> = case
        .features()
        .into_iter()
        .filter(|(.., is_made)| *is_made)
        .map(|(name, callout, ..)| (name, whole(&callout)))
        .collect();
    if made.is_empty() || case.mask.is_some() {
        return;
    }
    let (_, _, err) = program(place.path(), &["plan", "convert", &case.name, "-o", "made.toml"]);
    let toml = std::fs::read_to_string(place.path().join("made.toml")).unwrap_or_default();
    let found = if toml.is_empty() { Vec::new() } else { features_of(&toml) };
    if found != made {
        faults.push(format!("{} by plan convert:\n  right: {made:?}\n  said:  {found:?}\n{err}", case.name));
    }
}

pub(crate) fn by_window(case: &Case, faults: &mut Vec<String>) {
    let sources = Sources::default();
    let masks = case.masks();
    let read: Imported =
        import_given(&case.name, &mut std::io::Cursor::new(&case.bytes), Case::inputs(&masks, &sources, false));
    let set_aside = read.unjudged.len() + read.errors.len();
    let mut session = Session::new(Language::default());
    let result = Ok(Box::new(read));
    session.apply(Command::Check(CheckCommand::Imported { name: case.name.clone(), result }), now());
    let listed = session.history().listed();
    let mut said: Vec<Said> = listed
        .page(0..listed.count())
        .into_iter()
        .map(|(_, record)| Said {
            name: record.id.clone(),
            measured: Some(record.measurement.diameter),
            limits: Some((record.limits.minimum(), record.limits.maximum())),
            verdict: record.verdict.status().word().to_owned(),
        })
        .collect();
    // The newest one stands first.
    said.reverse();
    let judged: Vec<&Row> = case.rows.iter().filter(|row| row.is_judged()).collect();
    case.check("the check page", &judged, &said, faults);
    if set_aside != case.rows.len() - judged.len() {
        faults.push(format!("{} by the check page: {set_aside} set aside", case.name));
    }
    if case.features().is_empty() {
        return;
    }
    let mut session = walking_by(&case.plan());
    let mut items: Vec<Item> = Vec::new();
    let inputs = Case::inputs(&masks, &sources, true);
    import_from(&case.name, &mut std::io::Cursor::new(&case.bytes), inputs, &mut |item| items.push(item));
    let command = imported(&session, items);
    let effects = send(&mut session, command);
    let entries = effects.iter().find_map(|effect| match effect {
        Effect::Keep { entries, .. } => Some(entries.clone()),
        _ => None,
    });
    let said: Vec<Said> = entries
        .into_iter()
        .flatten()
        .map(|entry| Said {
            name: entry.about.feature.clone(),
            measured: Some(size(&entry).measurement.diameter),
            limits: None,
            verdict: size(&entry).verdict.status().word().to_owned(),
        })
        .collect();
    let by_plan = case.rows_by_plan();
    let judged: Vec<&Row> = by_plan.iter().filter(|row| row.is_judged()).collect();
    match case.walked {
        None => case.check("the walk", &judged, &said, faults),
        Some(count) if count == said.len() => {}
        Some(count) => {
            faults.push(format!("{} by the walk: {} values, right: {count}: {said:?}", case.name, said.len()));
        }
    }
}

/// All files of a format are dropped into one folder.
pub(crate) fn by_watch(cases: &[Case], faults: &mut Vec<String>) {
    let place = tempfile::tempdir().unwrap();
    let folder = place.path().join("in");
    std::fs::create_dir(&folder).unwrap();
    let mut args = vec!["watch", "in", "--until-idle", "2", "--format", "csv", "--journal", "w.sqlite"];
    for case in cases {
        fitcheck::files::write(&folder.join(&case.name), &case.bytes).unwrap();
        if let Some((name, text)) = &case.mask
            && !args.contains(&name.as_str())
        {
            fitcheck::files::write(&place.path().join(name), text.as_bytes()).unwrap();
            args.extend(["--mask", name]);
        }
    }
    let (_, out, _) = program(place.path(), &args);
    for case in cases {
        let rows: Vec<&Row> = case.rows.iter().take(case.watched.unwrap_or(usize::MAX)).collect();
        case.check("watch", &rows, &answers_of(&case.name, &out), faults);
    }
}

/// What `batch` says of the rows of a file in their order: the limits and the verdict, or `!` and why there is none.
pub(crate) fn by_batch(name: &str, bytes: &[u8]) -> Result<Vec<Said>, String> {
    let place = tempfile::tempdir().unwrap();
    fitcheck::files::write(&place.path().join(name), bytes).unwrap();
    let (_, _, err) = program(place.path(), &["batch", name, "-o", "out.jsonl", "--prefix", "fc_"]);
    let Ok(out) = std::fs::read_to_string(place.path().join("out.jsonl")) else { return Err(err) };
    let said = |line: &str| {
        let row: serde_json::Value = serde_json::from_str(line).unwrap();
        let figure = |key: &str| length(&row[key].to_string().replace("null", ""));
        let verdict = row["fc_status"]
            .as_str()
            .map_or_else(|| format!("!{}", row["fc_error"].as_str().unwrap_or_default()), str::to_owned);
        let limits = figure("fc_min_mm").zip(figure("fc_max_mm"));
        Said { name: String::new(), measured: None, limits, verdict }
    };
    // A line without an answer is none of a value.
    Ok(out.lines().map(said).filter(|said| said.verdict != "!").collect())
}
