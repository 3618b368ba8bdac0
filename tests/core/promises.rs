//! The documents keep their promises: what they name exists, and their lists of cycles are the program's.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use fitcheck::probing::cycle::{Control, Cycle};
use fitcheck::probing::cycles::{CYCLES, cycles_of};

use crate::house::{ROOMS, source_folders};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The text of every source file below a folder.
fn sources(folder: &Path, into: &mut Vec<(PathBuf, String)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, into);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            let text = std::fs::read_to_string(&path).unwrap();
            into.push((path, text));
        }
    }
}

/// The words in backticks.
fn quoted(line: &str) -> impl Iterator<Item = &str> {
    line.split('`').skip(1).step_by(2)
}

/// The tests that a table of a document names in its last column.
fn named_tests(document: &str, heading: &str) -> Vec<String> {
    let text = std::fs::read_to_string(root().join(document)).unwrap();
    let (_, table) = text.split_once(heading).unwrap();
    let cells = table.lines().filter_map(|line| line.strip_prefix("| ")?.strip_suffix(" |"));
    let last = cells.filter_map(|cells| cells.rsplit_once(" | "));
    last.flat_map(|(_, tests)| names(tests)).map(str::to_owned).collect()
}

/// The words in backticks that can be names of tests: no files and no patterns.
fn names(text: &str) -> impl Iterator<Item = &str> {
    quoted(text).filter(|name| !name.contains(['/', '.', '*']))
}

/// What guards an invariant: a test, or every test of a module.
struct Guard {
    name: String,
    is_module: bool,
}

/// The invariants, each with what guards it: a list, and a list below each of its items.
fn invariants() -> Vec<(String, Vec<Guard>)> {
    let text = std::fs::read_to_string(root().join("docs/INVARIANTS.md")).unwrap();
    let mut all: Vec<(String, Vec<Guard>)> = Vec::new();
    for line in text.lines() {
        if let Some(invariant) = line.strip_prefix("- ") {
            all.push((invariant.to_owned(), Vec::new()));
        } else if let Some(tests) = line.strip_prefix("  - ") {
            let is_module = tests.starts_with("every test of ");
            let guards = names(tests).map(|name| Guard { name: name.to_owned(), is_module });
            all.last_mut().unwrap().1.extend(guards);
        }
    }
    all
}

/// Whether a file is that of a module, such as `programs::iso`; every file is one of the empty path.
fn is_of(file: &Path, module: &[&str]) -> bool {
    let file = file.with_extension("");
    let parts: Vec<&str> = file.iter().filter_map(|part| part.to_str()).filter(|part| *part != "mod").collect();
    parts.ends_with(module)
}

#[test]
fn every_test_that_a_document_names_exists() {
    let mut files = Vec::new();
    sources(&root().join("tests"), &mut files);
    sources(&root().join("crates/exchange/tests"), &mut files);
    sources(&root().join("crates/statistics/tests"), &mut files);
    for folder in source_folders() {
        sources(&folder, &mut files);
    }
    let mut functions: BTreeMap<&str, Vec<&Path>> = BTreeMap::new();
    for (path, text) in &files {
        for (name, _) in text.split("fn ").skip(1).filter_map(|rest| rest.split_once('(')) {
            functions.entry(name).or_default().push(path);
        }
    }
    let is_module = |name: &str| {
        let module: Vec<&str> = name.split("::").collect();
        files.iter().any(|(path, _)| is_of(path, &module))
    };
    let is_test = |name: &str| {
        let (module, test) = name.rsplit_once("::").unwrap_or(("", name));
        let module: Vec<&str> = module.split("::").filter(|part| !part.is_empty()).collect();
        functions.get(test).is_some_and(|paths| paths.iter().any(|path| is_of(path, &module)))
    };
    for (document, heading, at_least) in [
        ("ARCHITECTURE.md", "## Invariants", 15),
        ("SECURITY.md", "## Promises and their tests", 20),
        ("docs/REQUIREMENTS.md", "## Rows", 170),
    ] {
        let names = named_tests(document, heading);
        assert!(at_least < names.len(), "the search finds only {} in {document}", names.len());
        for name in names {
            assert!(is_test(&name) || is_module(&name), "{document} names {name}, which does not exist");
        }
    }
    let invariants = invariants();
    assert!(135 < invariants.len(), "the search finds only {}", invariants.len());
    for (invariant, guards) in invariants {
        assert!(!guards.is_empty(), "no test guards: {invariant}");
        for Guard { name, is_module: is_whole } in guards {
            let exists = if is_whole { is_module(&name) } else { name.contains("::") && is_test(&name) };
            assert!(exists, "docs/INVARIANTS.md names {name}, which does not exist");
        }
    }
}

/// A module that the architecture names for a change has the list of what to do.
#[test]
fn every_recipe_is_where_the_architecture_says() {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let (_, rows) = text.split_once("## To add something").unwrap();
    let (rows, _) = rows.split_once("\n## ").unwrap();
    let cells = rows.lines().filter_map(|line| line.strip_prefix("| ")?.split_once(" | "));
    let files: Vec<&str> = cells.flat_map(|(_, read)| quoted(read)).collect();
    assert!(20 < files.len(), "the search finds only {}", files.len());
    for file in files {
        let text = std::fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        if file.contains("src/") && !file.starts_with("fuzz/") {
            let docs: Vec<&str> = text.lines().take_while(|line| line.starts_with("//!")).collect();
            let says = |line: &&str| line.starts_with("//! To add ") || line.starts_with("//! To use ");
            assert!(docs.iter().any(says), "{file} does not say how to add something");
        }
    }
}

#[test]
fn every_room_of_the_architecture_exists_and_every_room_is_in_it() {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let (_, rooms) = text.split_once("## Code map").unwrap();
    let (rooms, _) = rooms.split_once("\n## ").unwrap();
    let rows = rooms.lines().filter(|line| line.starts_with("| `"));
    let mut named: Vec<&str> = rows.filter_map(quoted_first).collect();
    let place = |room: &str| named.iter().position(|named| *named == room);
    for (_, room, below) in ROOMS {
        for other in below {
            assert!(place(other) < place(room), "{room} may name {other}, which ARCHITECTURE.md lists below it");
        }
    }
    named.sort_unstable();
    let mut known: Vec<&str> = ROOMS.iter().map(|(_, room, _)| *room).chain(["main"]).collect();
    known.sort_unstable();
    assert_eq!(named, known);
}

fn quoted_first(line: &str) -> Option<&str> {
    quoted(line).next()
}

#[test]
fn every_requirement_says_where_it_works_and_names_a_test() {
    let text = std::fs::read_to_string(root().join("docs/REQUIREMENTS.md")).unwrap();
    let (_, rows) = text.split_once("## Rows").unwrap();
    let rows: Vec<&str> = rows.lines().filter(|line| line.starts_with("| ")).skip(1).collect();
    for (row, number) in rows.iter().zip(1..) {
        let cells: Vec<&str> = row.trim_matches('|').split(" | ").map(str::trim).collect();
        let [first, document, asked, works, test] = cells[..] else { panic!("{row}") };
        assert_eq!(first, number.to_string(), "{row}");
        assert!(![document, asked, works].contains(&""), "{row}");
        assert!(test.starts_with('`'), "{row}");
    }
    assert!(150 < rows.len(), "{}", rows.len());
}

#[test]
fn every_link_of_the_documents_leads_to_a_file() {
    let documents = ["", "docs", "docs/manual"].into_iter().flat_map(pages);
    let mut links = 0;
    for path in documents {
        let text = std::fs::read_to_string(&path).unwrap();
        for rest in text.split("](").skip(1) {
            let target = rest.split(')').next().unwrap();
            if target.contains("://") {
                continue;
            }
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let leads_to = if file.is_empty() { path.clone() } else { path.parent().unwrap().join(file) };
            assert!(leads_to.exists(), "{} links to {target}", path.display());
            if !heading.is_empty() {
                let there = headings(&std::fs::read_to_string(&leads_to).unwrap());
                assert!(there.contains(heading), "{} links to {target}", path.display());
            }
            links += 1;
        }
    }
    assert!(100 < links, "the search finds only {links}");
}

/// The documents of a folder.
fn pages(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    entries.filter(|path| path.extension().is_some_and(|ending| ending == "md")).collect()
}

/// The names by which links lead to the headings of a document.
fn headings(text: &str) -> BTreeSet<String> {
    let lines = text.lines().filter(|line| line.starts_with('#'));
    lines
        .map(|line| {
            let words = line.trim_start_matches('#').trim().to_lowercase();
            words.chars().filter(|&c| c.is_alphanumeric() || " -_".contains(c)).collect::<String>().replace(' ', "-")
        })
        .collect()
}

#[test]
fn the_contents_of_the_manual_name_every_page() {
    let contents = std::fs::read_to_string(root().join("docs/manual/README.md")).unwrap();
    for path in pages("docs/manual") {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        assert!(name == "README.md" || contents.contains(&format!("]({name})")), "{name} is not in the contents");
    }
}

/// Cycles as the documents list them: `421 to 427, 444 and G785`, with a word before the last.
fn cycles(all: impl IntoIterator<Item = &'static Cycle>, word: &str) -> String {
    let mut runs: Vec<(&str, &str, Option<u16>)> = Vec::new();
    for cycle in all {
        let number = cycle.code.parse::<u16>().ok();
        match runs.last_mut() {
            Some((_, last, next)) if next.is_some() && *next == number => {
                (*last, *next) = (cycle.code, number.map(|number| number + 1));
            }
            _ => runs.push((cycle.code, cycle.code, number.map(|number| number + 1))),
        }
    }
    let text = |&(first, last, _): &(&str, &str, _)| {
        if first == last { first.to_owned() } else { format!("{first} to {last}") }
    };
    let all: Vec<String> = runs.iter().map(text).collect();
    let (last, others) = all.split_last().unwrap();
    format!("{} {word} {last}", others.join(", "))
}

#[test]
fn the_lists_of_cycles_in_the_documents_are_the_program_s() {
    let all = || CYCLES.iter().copied();
    let (and, or) = (cycles(all(), "and"), cycles(all(), "or"));
    for (document, sentence) in [
        ("README.md", format!("measuring cycles {and} on")),
        ("docs/manual/README.md", format!("| {and}, one at a time")),
        ("docs/manual/cycles.md", format!("`fitcheck cycle` runs {and} on")),
        ("docs/manual/cycles.md", format!("Choose one of {or}:")),
        ("docs/manual/programs.md", format!("probing cycles {}, against", cycles(cycles_of(Control::Milling), "and"))),
    ] {
        let text = std::fs::read_to_string(root().join(document)).unwrap();
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(&sentence), "{document} does not say: {sentence}");
    }
}
