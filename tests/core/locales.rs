//! The texts: complete in every language that the window offers, with the same arguments, and all of them used.

#![cfg(test)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use fitcheck::words::{Language, Words};
use fluent_bundle::FluentResource;

/// What stands around the name of a text in the source: `Message::new("file-missing")`.
///
/// Names that are chosen in a `match` stand alone; the search for dead texts takes any literal for a use.
const CALLS: [&str; 7] = ["Message::new(", "words.get(", "english.get(", "view.text(", ".t(", "said(", "entry(ui, "];

/// Arguments of each text by its name.
type Texts = BTreeMap<String, BTreeSet<String>>;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Every file beneath a folder with an ending, in order.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|given| given == ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn locale(language: Language) -> Vec<(String, String)> {
    let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
    let folder = root().join("assets/locales").join(language.code());
    files(&folder, "ftl").iter().map(|path| (name(path), std::fs::read_to_string(path).unwrap())).collect()
}

/// The names of arguments in a text: `{ $name }`, `{ NUMBER($name) }`, `{ $name -> … }`.
fn arguments(text: &str) -> impl Iterator<Item = String> {
    text.split('$').skip(1).map(|rest| rest.chars().take_while(|c| c.is_alphanumeric() || "-_".contains(*c)).collect())
}

/// The texts of a file. A name begins its line; what belongs to it is indented.
fn texts(file: &str, text: &str, into: &mut Texts) {
    let mut name = None;
    for line in text.lines() {
        let begins = line.starts_with(|c: char| c.is_ascii_alphabetic());
        if let (true, Some((id, _))) = (begins, line.split_once('=')) {
            let id = id.trim().to_owned();
            assert!(into.insert(id.clone(), BTreeSet::new()).is_none(), "{file}: {id} stands there twice");
            name = Some(id);
        }
        if line.starts_with('#') {
            continue;
        }
        if let Some(arguments_of) = name.as_ref().and_then(|id| into.get_mut(id)) {
            arguments_of.extend(arguments(line));
        }
    }
}

fn all(language: Language) -> Texts {
    let mut found = Texts::new();
    for (file, text) in locale(language) {
        texts(&format!("{language}/{file}"), &text, &mut found);
    }
    found
}

/// The source with its line breaks and indents taken out, so that a call is found however it is wrapped.
fn source() -> String {
    let text: String = files(&root().join("src"), "rs")
        .iter()
        .chain(&files(&root().join("assets"), "html"))
        .chain(&files(&root().join("assets"), "svg"))
        .map(|path| std::fs::read_to_string(path).unwrap())
        .collect();
    text.lines().map(str::trim).collect()
}

/// Every literal that directly follows one of [`CALLS`].
fn named(source: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for call in CALLS {
        for rest in source.split(call).skip(1) {
            let literal = rest.strip_prefix('"').and_then(|rest| rest.split_once('"'));
            found.extend(literal.map(|(id, _)| id.to_owned()));
        }
    }
    found
}

#[test]
fn every_file_parses_whole() {
    for language in Language::COMPLETE {
        let files = locale(language);
        assert!(!files.is_empty());
        for (file, text) in files {
            if let Err((_, errors)) = FluentResource::try_new(text) {
                panic!("{language}/{file}: {errors:?}");
            }
        }
    }
}

#[test]
fn every_file_is_embedded() {
    // A name that the program does not know is said as itself.
    for language in Language::COMPLETE {
        let words = Words::new(language);
        for (id, arguments) in all(language) {
            if arguments.is_empty() {
                assert_ne!(words.get(&id), id, "{language}");
            }
        }
    }
}

#[test]
fn every_language_has_the_same_texts_in_the_same_files() {
    let by_file = |language| -> BTreeMap<String, BTreeSet<String>> {
        let names = |file: &str, text: &str| {
            let mut found = Texts::new();
            texts(file, text, &mut found);
            found.into_keys().collect()
        };
        locale(language).into_iter().map(|(file, text)| (file.clone(), names(&file, &text))).collect()
    };
    let english = by_file(Language::En);
    for language in Language::COMPLETE {
        assert_eq!(by_file(language), english, "{language}");
    }
}

#[test]
fn every_language_has_the_same_arguments() {
    let english = all(Language::En);
    assert!(100 < english.len());
    for language in Language::COMPLETE {
        for (id, arguments) in all(language) {
            assert_eq!(Some(&arguments), english.get(&id), "{language}: {id}");
        }
    }
}

#[test]
fn every_text_that_the_source_names_exists() {
    let english = all(Language::En);
    let named = named(&source());
    assert!(100 < named.len(), "the search finds only {}", named.len());
    let missing: Vec<_> = named.iter().filter(|id| !english.contains_key(*id)).collect();
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn every_text_is_used() {
    let source = source();
    let literals: BTreeSet<&str> = source.split('"').collect();
    let english = all(Language::En);
    let dead: Vec<_> = english.keys().filter(|id| !literals.contains(id.as_str())).collect();
    assert!(dead.is_empty(), "{dead:#?}");
}

#[test]
fn the_search_finds_calls_and_arguments() {
    let source = "self.refuse(Message::new(\"one\").text(\"x\", 1));view.text(\"two\");Message::new(id)";
    assert_eq!(named(source), BTreeSet::from(["one".to_owned(), "two".to_owned()]));
    let mut found = Texts::new();
    texts(
        "x.ftl",
        "# $no\na = { $x } of\n    { NUMBER($y-z) }\nb = { $n ->\n  [one] 1\n *[other] { $n }\n }\n",
        &mut found,
    );
    let set = |names: &[&str]| names.iter().map(ToString::to_string).collect::<BTreeSet<_>>();
    assert_eq!(found, Texts::from([("a".to_owned(), set(&["x", "y-z"])), ("b".to_owned(), set(&["n"]))]));
}
