//! The English texts: which ones exist, and what is put into each.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::OnceLock;

/// The arguments of each text by its name, or why the texts cannot be read.
pub(crate) type Texts = Result<BTreeMap<String, BTreeSet<String>>, String>;

/// Reads them once for all derives of a crate.
pub(crate) fn english() -> &'static Texts {
    static TEXTS: OnceLock<Texts> = OnceLock::new();
    TEXTS.get_or_init(|| {
        let root = std::env::var("CARGO_MANIFEST_DIR").map_err(|error| error.to_string())?;
        let folder = Path::new(&root).ancestors().map(|at| at.join("assets/locales/en")).find(|folder| folder.is_dir());
        read(&folder.ok_or_else(|| format!("assets/locales/en is missing above {root}"))?)
    })
}

/// The arguments that a text asks for, or why there is no such text.
pub(crate) fn wanted<'a>(texts: &'a Texts, id: &str) -> Result<&'a BTreeSet<String>, String> {
    let texts = texts.as_ref().map_err(|error| format!("the English texts cannot be read: {error}"))?;
    texts.get(id).ok_or_else(|| format!("assets/locales/en has no text {id}"))
}

fn read(folder: &Path) -> Texts {
    let told = |error: std::io::Error| format!("{error}: {}", folder.display());
    let mut texts = BTreeMap::new();
    for entry in std::fs::read_dir(folder).map_err(told)? {
        let path = entry.map_err(told)?.path();
        if path.extension().is_some_and(|ending| ending == "ftl") {
            collect(&std::fs::read_to_string(&path).map_err(told)?, &mut texts);
        }
    }
    Ok(texts)
}

/// A text's name begins its line; its other lines are indented. A test of the crate checks that a file parses whole.
fn collect(file: &str, texts: &mut BTreeMap<String, BTreeSet<String>>) {
    let mut name = String::new();
    for line in file.lines().filter(|line| !line.starts_with('#')) {
        if let Some((id, _)) = line.split_once('=').filter(|_| line.starts_with(|c: char| c.is_ascii_alphabetic())) {
            id.trim().clone_into(&mut name);
            texts.insert(name.clone(), BTreeSet::new());
        }
        if let Some(arguments) = texts.get_mut(&name) {
            let named = |rest: &str| rest.chars().take_while(|c| c.is_alphanumeric() || "-_".contains(*c)).collect();
            arguments.extend(line.split('$').skip(1).map(named));
        }
    }
}

/// `LineTooLong` as `line-too-long`, `line_no` as `line-no`.
pub(crate) fn kebab(name: &str) -> String {
    let mut kebab = String::new();
    for c in name.trim_start_matches("r#").chars() {
        if c.is_ascii_uppercase() && !kebab.is_empty() {
            kebab.push('-');
        }
        kebab.push(if c == '_' { '-' } else { c.to_ascii_lowercase() });
    }
    kebab
}
