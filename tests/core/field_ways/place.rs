//! A file in a folder of its own, and what the program says of it.

use std::path::{Path, PathBuf};

use fitcheck::exchange::{ImportInputs, Item, import, import_from};
use fitcheck::session::{CheckCommand, Command, Effect, Session};
use fitcheck::tolerance::Sources;
use fitcheck::words::Language;

use super::ways::program;
use crate::session_walk::{imported, now, send, size, walking_by};

pub(crate) fn data(name: &str) -> PathBuf {
    let folders = ["tables", "aqdef", "pcdmis", "probed"].map(|folder| Path::new("tests/data").join(folder).join(name));
    folders.into_iter().find(|path| path.exists()).unwrap_or_else(|| panic!("{name}"))
}

/// A folder with these files.
pub(crate) struct Place(pub(crate) tempfile::TempDir);

pub(crate) struct Said {
    pub(crate) code: i32,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Said {
    pub(crate) fn all(&self) -> String {
        format!("exit code {}\n{}{}", self.code, self.out, self.err)
    }
}

impl Place {
    pub(crate) fn of(files: &[&str]) -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        for name in files {
            std::fs::copy(data(name), place.0.path().join(name)).unwrap();
        }
        place
    }

    pub(crate) fn say(&self, args: &[&str]) -> Said {
        let (code, out, err) = program(self.0.path(), args);
        Said { code, out, err }
    }

    pub(crate) fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.path().join(name)).unwrap_or_default()
    }
}

/// Name, measured value and verdict of each row of `--format csv`; a row without a verdict has `-`.
pub(crate) fn rows(out: &str) -> Vec<String> {
    let mut reader = csv::Reader::from_reader(out.as_bytes());
    let names = reader.headers().unwrap().clone();
    let [id, measured, status] =
        ["id", "measured_mm", "status"].map(|name| names.iter().position(|known| known == name).unwrap());
    let row = |row: csv::StringRecord| {
        let or_none = |text: &str| if text.is_empty() { "-".to_owned() } else { text.to_owned() };
        [&row[id], &row[measured], &row[status]].map(or_none).join(" ")
    };
    reader.records().map(|read| row(read.unwrap())).collect()
}

/// `import`, `report` and the check page of the window have these rows and this exit code.
#[track_caller]
pub(crate) fn judged(file: &str, code: i32, expected: &[&str]) {
    let place = Place::of(&[file]);
    let said = place.say(&["import", file, "--format", "csv"]);
    assert_eq!(
        (rows(&said.out), said.code),
        (expected.iter().map(ToString::to_string).collect(), code),
        "{}",
        said.all()
    );
    let said = place.say(&["report", file, "-o", "r.csv"]);
    let report = place.read("r.csv");
    let words = |row: &&&str| row.split(' ').filter(|word| *word != "-").map(str::to_owned).collect::<Vec<_>>();
    for row in expected.iter().filter(|row| !row.ends_with(" -")) {
        let words = words(&row);
        let has = |line: &str| words.iter().all(|word| line.contains(word.as_str()));
        assert!(report.lines().any(has), "{row}\n{report}{}", said.all());
    }
    assert_eq!(said.code, code, "report: {}", said.all());
    let bytes = std::fs::read(data(file)).unwrap();
    let read = import(file, &bytes, &Sources::default(), now());
    let mut session = Session::new(Language::default());
    session.apply(Command::Check(CheckCommand::Imported { name: file.to_owned(), result: Ok(Box::new(read)) }), now());
    let listed = session.history().listed();
    let mut kept: Vec<String> = listed
        .page(0..listed.count())
        .into_iter()
        .map(|(_, record)| {
            let mm = record.measurement.diameter.exact(fitcheck::length::Unit::Millimetre, 3);
            format!("{} {mm} {}", record.id, record.verdict.status().word())
        })
        .collect();
    kept.reverse();
    let with_verdict: Vec<&str> = expected.iter().copied().filter(|row| !row.ends_with(" -")).collect();
    assert_eq!(kept, with_verdict, "{file} in the window");
}

/// `batch` gives the rows of a table these verdicts.
#[track_caller]
pub(crate) fn by_batch(file: &str, code: i32, expected: &[&str]) {
    let said = Place::of(&[file]).say(&["batch", file]);
    for row in expected {
        let words: Vec<&str> = row.split(' ').filter(|word| *word != "-").collect();
        let has = |line: &str| words.iter().all(|word| line.contains(word));
        assert!(said.out.lines().any(has), "{row}\n{}", said.all());
    }
    assert_eq!(said.code, code, "{}", said.all());
}

/// `plan convert` writes these features, and says each of these texts.
#[track_caller]
pub(crate) fn converted(file: &str, code: i32, features: &[&str], told: &[&str]) {
    let place = Place::of(&[file]);
    let said = place.say(&["plan", "convert", file, "-o", "p.toml"]);
    let plan = place.read("p.toml");
    let mut found = Vec::new();
    for feature in plan.split("[[feature]]").skip(1) {
        let text = |key: &str| {
            let line = feature.lines().find_map(|line| line.strip_prefix(&format!("{key} = ")));
            line.unwrap_or_default().trim_matches('"').to_owned()
        };
        found.push(format!("{} {}", text("name"), text("callout")));
    }
    assert_eq!((found, said.code), (features.iter().map(ToString::to_string).collect(), code), "{}", said.all());
    for words in told {
        assert!(said.err.contains(words), "{words}\n{}", said.all());
    }
}

/// Rows by a plan, and the exit code.
#[track_caller]
pub(crate) fn by_plan(file: &str, plan: &str, code: i32, expected: &[&str]) -> String {
    let said = Place::of(&[file, plan]).say(&["import", file, "--plan", plan, "--format", "csv"]);
    assert_eq!(
        (rows(&said.out), said.code),
        (expected.iter().map(ToString::to_string).collect(), code),
        "{}",
        said.all()
    );
    format!("{}{}", said.out, said.err)
}

/// What the walk through a part takes of a file: feature, value, verdict.
pub(crate) fn walked(file: &str, plan: &str) -> Vec<String> {
    let mut session = walking_by(&std::fs::read_to_string(data(plan)).unwrap());
    let sources = Sources::default();
    let mut items: Vec<Item> = Vec::new();
    let given = ImportInputs { has_plan: true, ..ImportInputs::new(&sources, now()) };
    let bytes = std::fs::read(data(file)).unwrap();
    import_from(file, &mut std::io::Cursor::new(bytes), given, &mut |item| items.push(item));
    let command = imported(&session, items);
    let effects = send(&mut session, command);
    let entries = effects.into_iter().find_map(|effect| match effect {
        Effect::Keep { entries, .. } => Some(entries),
        _ => None,
    });
    let said = |entry: &fitcheck::journal::entry::Entry| {
        let record = size(entry);
        format!("{} {} {}", entry.about.feature, record.measurement.diameter, record.verdict.status().word())
    };
    entries.iter().flatten().map(said).collect()
}
