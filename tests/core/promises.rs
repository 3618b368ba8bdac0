//! The documents keep their promises: what they name exists, and their lists of cycles are the program's.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use fitcheck::probing::cycle::{Control, Cycle};
use fitcheck::probing::cycles::{CYCLES, cycles_of};

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
    let names = last.flat_map(|(_, tests)| quoted(tests)).filter(|name| !name.contains(['/', '.', '*']));
    names.map(str::to_owned).collect()
}

#[test]
fn every_test_that_a_document_names_exists() {
    let mut files = Vec::new();
    sources(&root().join("tests"), &mut files);
    sources(&root().join("src"), &mut files);
    let functions: BTreeSet<&str> = files
        .iter()
        .flat_map(|(_, text)| text.split("fn ").skip(1))
        .filter_map(|rest| rest.split_once('(').map(|(name, _)| name))
        .collect();
    let is_test = |name: &str| functions.contains(name);
    let is_module = |name: &str| {
        let file = |path: &PathBuf| path.file_stem().is_some_and(|stem| stem == name);
        let folder = |path: &PathBuf| path.parent().is_some_and(|folder| folder.ends_with(name));
        files.iter().any(|(path, _)| file(path) || folder(path))
    };
    for (document, heading, at_least) in [
        ("ARCHITECTURE.md", "## Invariants", 60),
        ("SECURITY.md", "## What holds", 20),
        ("docs/REQUIREMENTS.md", "## Rows", 170),
    ] {
        let names = named_tests(document, heading);
        assert!(at_least < names.len(), "the search finds only {} in {document}", names.len());
        for name in names {
            let last = name.rsplit("::").next().unwrap();
            assert!(is_test(last) || is_module(last), "{document} names {name}, which does not exist");
        }
    }
}

#[test]
fn every_room_of_the_architecture_exists_and_every_room_is_in_it() {
    let text = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let (_, rooms) = text.split_once("## Room by room").unwrap();
    let (rooms, _) = rooms.split_once("## Things that are easy").unwrap();
    let rows = rooms.lines().filter(|line| line.starts_with("| `"));
    let mut named: Vec<String> =
        rows.filter_map(quoted_first).map(|room| room.trim_end_matches('/').to_owned()).collect();
    named.sort();
    let entries = std::fs::read_dir(root().join("src")).unwrap();
    let mut there: Vec<String> =
        entries.map(|entry| entry.unwrap().path().file_stem().unwrap().to_string_lossy().into_owned()).collect();
    there.retain(|name| name != "lib");
    there.sort();
    there.dedup();
    assert_eq!(named, there);
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
