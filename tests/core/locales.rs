//! The texts: complete in every language of the window, with the same arguments, and all of them used.

#![cfg(test)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use fitcheck::report::pairing::FORMATS;
use fitcheck::shipped;
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::{Language, Words};
use fluent_bundle::FluentResource;

use crate::house::source_folders;

/// What comes before the name of a text in the source, `Message::new("file-missing")`: within these brackets every
/// literal that looks like a name is one, so that `Message::new(match self { … })` is also searched.
const CALLS: [&str; 10] = [
    "Message::new(",
    "message!(",
    "ResultName::new(",
    "Self::new(",
    "words.get(",
    "english.get(",
    "view.text(",
    ".t(",
    "said(",
    "entry(ui, ",
];

/// What ends the name's beginning when the rest is put in: `view.text(&format!("export-{}", …))`.
const PUT_IN: &str = "{}";

/// Arguments of each text by its name.
type Texts = BTreeMap<String, BTreeSet<String>>;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Every file below a folder with an ending, in order.
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

/// The texts of a file. A name begins its line; the other lines of its text are indented.
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

/// The source and the report's templates without tests, line breaks and indents, so that a call is found however it
/// is wrapped.
fn source() -> String {
    let assets = root().join("assets");
    let mut all: Vec<_> = source_folders().iter().flat_map(|folder| files(folder, "rs")).collect();
    all.extend([files(&assets, "html"), files(&assets, "svg")].concat());
    let texts = all.iter().filter(|path| !is_of_tests(path)).map(|path| std::fs::read_to_string(path).unwrap());
    let mut source = String::new();
    for text in texts {
        let lines = text.lines().take_while(|line| !line.ends_with("mod tests {"));
        source.extend(lines.map(str::trim).filter(|line| !line.starts_with("//")));
    }
    source
}

/// Whether a file has only tests.
fn is_of_tests(path: &Path) -> bool {
    path.ends_with("tests.rs") || path.strip_prefix(root()).unwrap().iter().any(|part| part == "tests")
}

/// The text within the bracket that was just opened.
fn within_bracket(rest: &str) -> &str {
    let mut depth = 1;
    let end = rest.find(|c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth == 0
    });
    rest.split_at(end.unwrap_or(rest.len())).0
}

/// The literals in a piece of source.
fn literals(source: &str) -> impl Iterator<Item = &str> {
    source.split('"').skip(1).step_by(2)
}

/// `LineTooLong` as `line-too-long`.
fn kebab(name: &str) -> String {
    let lower = |(at, c): (usize, char)| {
        let dash = if 0 < at && c.is_ascii_uppercase() { "-" } else { "" };
        format!("{dash}{}", c.to_ascii_lowercase())
    };
    name.char_indices().map(lower).collect()
}

/// The names of texts that `#[derive(Say)]` makes: the prefix of the enum and each variant.
fn derived() -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for path in source_folders().iter().flat_map(|folder| files(folder, "rs")) {
        let text = std::fs::read_to_string(path).unwrap();
        let pieces = text.split("#[say(prefix = \"");
        for (before, rest) in pieces.clone().zip(pieces.skip(1)) {
            // Within a macro the type is indented.
            let indent = before.rsplit('\n').next().unwrap();
            let (prefix, rest) = rest.split_once('"').unwrap();
            let body = rest.split(&format!("\n{indent}}}")).next().unwrap();
            let variants = body.lines().filter_map(|line| {
                let name = line.strip_prefix(indent)?.strip_prefix("    ")?;
                let name = Some(name).filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase()))?;
                name.split(|c: char| !c.is_alphanumeric()).next()
            });
            found.extend(variants.map(|variant| format!("{prefix}-{}", kebab(variant))));
        }
    }
    found
}

fn looks_like_a_name(literal: &str) -> bool {
    let rest = literal.strip_suffix(PUT_IN).unwrap_or(literal);
    1 < rest.len() && rest.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-')
}

/// Every name within one of [`CALLS`]; a name with [`PUT_IN`] keeps it.
fn named(source: &str) -> BTreeSet<String> {
    let calls = CALLS.iter().flat_map(|call| source.split(call).skip(1));
    let names = calls.flat_map(|rest| literals(within_bracket(rest))).filter(|literal| looks_like_a_name(literal));
    names.map(str::to_owned).collect()
}

#[test]
fn every_file_parses_whole() {
    for language in Language::all() {
        let files = locale(language);
        assert!(!files.is_empty());
        for (file, text) in files {
            if let Err((_, errors)) = FluentResource::try_new(text) {
                panic!("{language}/{file}: {errors:?}");
            }
        }
    }
}

/// The names of other texts in a text: `{ simulated }`.
fn references(text: &str) -> impl Iterator<Item = &str> {
    let placeables = text.split('{').skip(1).filter_map(|rest| rest.split('}').next()).map(str::trim);
    placeables.filter(|name| name.starts_with(|c: char| c.is_ascii_lowercase() || c == '-'))
}

#[test]
fn a_text_refers_to_texts_of_its_own_file_only() {
    let mut found = 0;
    for language in Language::all() {
        for (file, text) in locale(language) {
            let mut own = Texts::new();
            texts(&file, &text, &mut own);
            for name in references(&text) {
                found += 1;
                assert!(own.contains_key(name), "{language}/{file} refers to {name}");
            }
        }
    }
    assert!(0 < found, "the search finds nothing");
}

#[test]
fn every_file_is_embedded() {
    // A name that the program does not know is shown as it is.
    for language in Language::all() {
        let words = Words::new(language);
        let text: String = locale(language).into_iter().map(|(_, text)| text).collect();
        let lines: BTreeSet<&str> = text.lines().collect();
        for (id, arguments) in all(language) {
            let says_its_name = lines.contains(format!("{id} = {id}").as_str());
            assert!(!arguments.is_empty() || says_its_name || words.get(&id) != id, "{language}: {id}");
        }
    }
}

#[test]
fn every_language_has_the_same_texts_in_the_same_files() {
    let ids = |language| -> BTreeSet<String> {
        let in_file = |(file, text): (String, String)| {
            let mut found = Texts::new();
            texts(&file, &text, &mut found);
            found.into_keys().map(move |id| format!("{file} {id}"))
        };
        locale(language).into_iter().flat_map(in_file).collect()
    };
    let english = ids(Language::En);
    let mut wrong = Vec::new();
    for language in Language::all() {
        let own = ids(language);
        let line = |what: &str, entry: &String| {
            let (file, id) = entry.split_once(' ').unwrap();
            format!("assets/locales/{language}/{file} {what} {id}")
        };
        wrong.extend(english.difference(&own).map(|entry| line("lacks", entry)));
        wrong.extend(own.difference(&english).map(|entry| line("has and en lacks", entry)));
    }
    assert!(wrong.is_empty(), "{} texts:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn every_language_has_the_same_arguments() {
    let english = all(Language::En);
    assert!(100 < english.len());
    for language in Language::all() {
        for (id, arguments) in all(language) {
            assert_eq!(Some(&arguments), english.get(&id), "{language}: {id}");
        }
    }
}

/// Whether a text has the name, or begins with it where something is put in.
fn exists(texts: &Texts, name: &str) -> bool {
    match name.strip_suffix(PUT_IN) {
        Some(beginning) => texts.keys().any(|id| id.starts_with(beginning)),
        None => texts.contains_key(name),
    }
}

#[test]
fn every_text_that_the_source_names_exists() {
    let english = all(Language::En);
    let named = named(&source());
    assert!(150 < named.len(), "the search finds only {}", named.len());
    let missing: Vec<_> = named.iter().filter(|name| !exists(&english, name)).collect();
    assert!(missing.is_empty(), "assets/locales/en has no text {missing:#?}");
}

#[test]
fn every_text_is_used() {
    // Names are also chosen in a `match` far from the call: any literal counts as a use.
    let source = source();
    // What a language says of itself is read by the build.
    let of_build = ["language-name", "language-decimal-sign"];
    // A template of reports names its own.
    let templates: String =
        shipped::TEMPLATES.iter().map(|(_, bytes)| String::from_utf8_lossy(bytes).into_owned()).collect();
    let literals: BTreeSet<&str> = source.split('"').chain(templates.split('"')).chain(of_build).collect();
    let beginnings: Vec<&str> = literals.iter().filter_map(|literal| literal.strip_suffix(PUT_IN)).collect();
    let begins = |id: &str| beginnings.iter().any(|beginning| 1 < beginning.len() && id.starts_with(beginning));
    let english = all(Language::En);
    let derived = derived();
    let is_dead = |id: &&String| !literals.contains(id.as_str()) && !begins(id) && !derived.contains(*id);
    let dead: Vec<_> = english.keys().filter(is_dead).collect();
    assert!(dead.is_empty(), "{dead:#?}");
}

#[test]
fn the_search_finds_calls_and_arguments() {
    let set = |names: &[&str]| names.iter().map(ToString::to_string).collect::<BTreeSet<_>>();
    let source = "self.refuse(Message::new(\"one\").text(\"x\", 1));view.text(if a(1) { \"two\" } else { \"th-ree\" });\
                  Message::new(id).text(\"four\", 4);view.text(&format!(\"five-{}\", \"Six\"))";
    assert_eq!(named(source), set(&["one", "two", "th-ree", "five-{}"]));
    let mut found = Texts::new();
    let text = "# $no\na = { $x } of\n    { NUMBER($y-z) }\nb = { $n ->\n  [one] 1\n *[other] { $n }\n }\n";
    texts("x.ftl", text, &mut found);
    assert_eq!(found, Texts::from([("a".to_owned(), set(&["x", "y-z"])), ("b".to_owned(), set(&["n"]))]));
}

#[test]
fn every_folder_says_its_name_and_its_decimal_sign() {
    for folder in std::fs::read_dir(root().join("assets/locales")).unwrap() {
        let code = folder.unwrap().file_name().to_string_lossy().into_owned();
        let language = Language::from_code(&code).unwrap();
        let bundle = fitcheck::message::Bundle::of(language.code());
        for id in ["language-name", "language-decimal-sign"] {
            assert!(
                bundle.find(id).is_some_and(|text| !text.is_empty()),
                "assets/locales/{code}/language.ftl has no {id}"
            );
        }
    }
    let names: BTreeSet<&str> = Language::all().map(Language::name).collect();
    assert_eq!(names.len(), Language::all().len(), "two languages have one name: {names:?}");
    assert_eq!((Language::En.name(), Language::Nl.name()), ("English", "Nederlands"));
    assert_eq!((Language::En.decimal_sign(), Language::Nl.decimal_sign()), ('.', ','));
}

#[test]
fn a_code_is_kept_and_an_unknown_one_is_english() {
    let text = toml::Value::try_from(Language::Nl).unwrap();
    assert_eq!(text.as_str(), Some("nl"));
    assert_eq!(text.try_into::<Language>().unwrap(), Language::Nl);
    assert_eq!(toml::Value::from("tlh").try_into::<Language>().unwrap(), Language::En);
    assert_eq!(Language::from_code("nl_BE.UTF-8"), Some(Language::Nl));
    assert_eq!(Language::from_code("tlh"), None);
}

/// Names that are put together from a list of the program: each of its members has its text.
#[test]
fn every_rule_every_format_and_every_column_of_a_plan_has_its_texts() {
    let rules = RuleName::ALL.map(RuleName::word).into_iter();
    let rules = rules.flat_map(|word| [format!("rule-{word}"), format!("rule-name-{word}")]);
    let formats = FORMATS.iter().map(|format| format!("pairing-page-save-{}", format.name));
    let columns = fitcheck::part::Column::ALL;
    let columns = columns.map(|column| format!("parts-page-column-{}", column.key().replace('_', "-")));
    let names: Vec<String> = rules.chain(formats).chain(columns).collect();
    // Other languages have the texts of English, or another test fails.
    let english = all(Language::En);
    let missing: Vec<_> = names.iter().filter(|name| !english.contains_key(*name)).collect();
    assert!(missing.is_empty(), "assets/locales/en has no text {missing:?}");
    // A text that is missing shows its name.
    for format in fitcheck::exchange::FORMATS {
        assert!(!format.to_string().starts_with("exchange-format"), "assets/locales/en has no text {format}");
    }
}

#[test]
fn materials_and_the_entry_of_the_desktop_have_their_names_in_every_language() {
    let materials = std::fs::read_to_string(root().join("assets/materials.toml")).unwrap();
    let desktop = std::fs::read_to_string(root().join("packaging/linux/fitcheck.desktop")).unwrap();
    let count = materials.matches("[[material]]").count();
    for language in Language::all().filter(|language| *language != Language::En) {
        let code = language.code();
        let named =
            materials.lines().filter(|line| line.starts_with("names = ") && line.contains(&format!("{code} = ")));
        assert_eq!(named.count(), count, "{code} in assets/materials.toml");
        for key in ["GenericName", "Comment", "Keywords"] {
            assert!(
                desktop.contains(&format!("\n{key}[{code}]=")),
                "{key}[{code}] in packaging/linux/fitcheck.desktop"
            );
        }
    }
}

/// The English terms of the tables that say what a thing is and what it is not called.
fn terms() -> Vec<String> {
    let text = std::fs::read_to_string(root().join("docs/TERMS.md")).unwrap();
    let mut terms = Vec::new();
    let mut is_of_terms = false;
    for line in text.lines() {
        is_of_terms = (is_of_terms && line.starts_with('|')) || line == "| English | what it is | not |";
        let term =
            line.split('|').nth(1).map(str::trim).filter(|term| is_of_terms && *term != "English" && *term != "---");
        terms.extend(term.map(str::to_owned));
    }
    terms
}

#[test]
fn every_language_says_its_terms_and_where_they_come_from() {
    let terms = terms();
    assert!(40 < terms.len(), "{terms:?}");
    for language in Language::all().filter(|language| *language != Language::En) {
        let file = format!("docs/terms/{language}.tsv");
        let text = std::fs::read_to_string(root().join(&file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        let mut known = BTreeSet::new();
        for line in text.lines() {
            let cells: Vec<&str> = line.split('\t').collect();
            assert!(cells.len() == 3 && cells.iter().all(|cell| !cell.trim().is_empty()), "{file}: {line:?}");
            assert!(known.insert(cells[0].to_owned()), "{file} has {} twice", cells[0]);
        }
        let missing: Vec<_> = terms.iter().filter(|term| !known.contains(*term)).collect();
        assert!(missing.is_empty(), "{file} lacks {missing:?}");
    }
}
