//! No two files of a crate need each other, but for a module and what is in it.
//!
//! What a file names by `crate::`, `super::` and `self::` is followed through re-exports to the file where it is
//! declared. Files that can all be reached from each other are a circle: none of them can be read first.

#![cfg(test)]

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::house::{code, source_folders, sources};

/// A module as the names on its way from the crate's root; the root is empty.
type Module = Vec<String>;

/// A path as it is written, name by name.
type Names = Vec<String>;

/// The files of a crate by their modules, and what each has from elsewhere by `use`.
struct Crate {
    code: BTreeMap<Module, String>,
    used: BTreeMap<Module, BTreeMap<String, Names>>,
}

impl Crate {
    fn read(folder: &Path) -> Self {
        let mut read = BTreeMap::new();
        for path in sources(folder) {
            let mut module: Module = path
                .with_extension("")
                .strip_prefix(folder)
                .unwrap()
                .iter()
                .map(|part| part.to_str().unwrap().to_owned())
                .collect();
            if module.last().is_some_and(|last| ["mod", "lib"].contains(&last.as_str())) {
                module.pop();
            }
            if !module.last().is_some_and(|last| ["main", "tests"].contains(&last.as_str())) {
                read.insert(module, code(&path));
            }
        }
        Self::of(read)
    }

    fn of(code: BTreeMap<Module, String>) -> Self {
        let named = |text: &String| used(text).into_iter().filter_map(|path| Some((path.last()?.clone(), path)));
        let used = code.iter().map(|(module, text)| (module.clone(), named(text).collect())).collect();
        Self { code, used }
    }

    /// The module in which what a path names is declared; `None` for a path into another crate.
    fn declared(&self, from: &[String], path: &[String], steps: u8) -> Option<Module> {
        let mut at = from.to_vec();
        let mut rest = path;
        match path.first()?.as_str() {
            "crate" => {
                at = Module::new();
                rest = &path[1..];
            }
            "self" => rest = &path[1..],
            "super" => {
                while let Some(above) = rest.strip_prefix(&["super".to_owned()]) {
                    at.pop();
                    rest = above;
                }
            }
            child if !self.code.contains_key(&[from, &[child.to_owned()]].concat()) => return None,
            _ => {}
        }
        while let Some((name, after)) = rest.split_first() {
            let child = [at.as_slice(), std::slice::from_ref(name)].concat();
            if !self.code.contains_key(&child) {
                break;
            }
            at = child;
            rest = after;
        }
        let again = rest.split_first().and_then(|(name, after)| {
            let path = self.used.get(&at)?.get(name)?;
            let next = steps.checked_sub(1)?;
            self.declared(&at, &[path.as_slice(), after].concat(), next)
        });
        Some(again.unwrap_or(at))
    }

    /// Which files each file names: neither those it is in nor those in it.
    fn arrows(&self) -> BTreeMap<&Module, BTreeSet<Module>> {
        let arrows = self.code.iter().map(|(module, text)| {
            let paths = used(text).into_iter().chain(named(text));
            let others = paths.filter_map(|path| self.declared(module, &path, 6));
            let others = others.filter(|other| !module.starts_with(other) && !other.starts_with(module));
            (module, others.filter(|other| self.code.contains_key(other)).collect())
        });
        arrows.collect()
    }

    /// The files that lead back to themselves, each with where it leads to on the way.
    fn circles(&self) -> Vec<String> {
        let arrows = self.arrows();
        let reached: BTreeMap<&Module, BTreeSet<&Module>> =
            arrows.keys().map(|module| (*module, reached(&arrows, module))).collect();
        let leads_back = |from: &Module, to: &Module| reached.get(to).is_some_and(|there| there.contains(from));
        let circles = arrows.iter().filter(|(module, _)| leads_back(module, module)).map(|(module, others)| {
            let back = others.iter().filter(|other| leads_back(module, other)).map(|other| other.join("/"));
            format!("{} names {}", module.join("/"), back.collect::<Vec<_>>().join(", "))
        });
        circles.collect()
    }
}

/// The files that arrows lead to from a file.
fn reached<'a>(arrows: &'a BTreeMap<&Module, BTreeSet<Module>>, from: &Module) -> BTreeSet<&'a Module> {
    let mut reached = BTreeSet::new();
    let mut open: Vec<&'a Module> = arrows.get(from).into_iter().flatten().collect();
    while let Some(at) = open.pop() {
        if reached.insert(at) {
            open.extend(arrows.get(at).into_iter().flatten());
        }
    }
    reached
}

/// The paths of every `use` of a text, written out one by one.
fn used(text: &str) -> Vec<Names> {
    let pieces = text.split("use ").zip(text.split("use ").skip(1));
    let begun = pieces.filter(|(before, _)| !before.ends_with(|c: char| c.is_alphanumeric()));
    let trees = begun.filter_map(|(_, rest)| rest.split_once(';')).map(|(tree, _)| tree);
    trees.filter(|tree| tree.contains("::")).flat_map(|tree| written_out(tree.trim())).collect()
}

/// `a::{b, c::{self, d}}` as `a::b`, `a::c` and `a::c::d`.
fn written_out(tree: &str) -> Vec<Names> {
    let names = |path: &str| -> Names {
        path.split("::").map(|name| name.trim().to_owned()).filter(|name| !name.is_empty()).collect()
    };
    let Some((front, inner)) = tree.split_once('{') else {
        return vec![names(tree.split(" as ").next().unwrap())];
    };
    let inner = inner.rsplit_once('}').map_or(inner, |(inner, _)| inner);
    let mut depth = 0;
    let parts = inner.split(|c: char| {
        depth += i32::from(c == '{') - i32::from(c == '}');
        c == ',' && depth == 0
    });
    let parts = parts.map(str::trim).filter(|part| !part.is_empty());
    let all = parts.flat_map(written_out).map(|mut rest| {
        rest.retain(|name| name != "self");
        [names(front), rest].concat()
    });
    all.collect()
}

/// A text without its `use`.
fn without_use(text: &str) -> String {
    let mut pieces = text.split("use ");
    let mut outside = pieces.next().unwrap().to_owned();
    for piece in pieces {
        let is_use = !outside.ends_with(|c: char| c.is_alphanumeric());
        outside += if is_use { piece.split_once(';').map_or("", |(_tree, behind)| behind) } else { piece };
    }
    outside
}

/// The paths that a text names outside of `use`.
fn named(text: &str) -> Vec<Names> {
    let is_of_name = |c: char| c.is_alphanumeric() || c == '_';
    let text = without_use(text);
    let words = text.split(|c: char| !is_of_name(c) && c != ':').filter(|word| word.contains("::"));
    let paths = words.filter(|word| ["crate::", "super::", "self::"].iter().any(|front| word.starts_with(front)));
    paths.map(|path| path.split("::").filter(|name| !name.is_empty()).map(str::to_owned).collect()).collect()
}

#[test]
fn no_files_of_a_crate_need_each_other() {
    for folder in source_folders() {
        let circles = Crate::read(&folder).circles();
        assert!(circles.is_empty(), "{}:\n{}", folder.display(), circles.join("\n"));
    }
}

#[test]
fn a_circle_is_found_through_what_a_parent_passes_on() {
    let file = |module: &str, text: &str| {
        (module.split('/').filter(|name| !name.is_empty()).map(str::to_owned).collect(), text.to_owned())
    };
    let circles =
        |files: &[(&str, &str)]| Crate::of(files.iter().map(|(name, text)| file(name, text)).collect()).circles();
    let parent = ("", "mod a;\nmod b;\npub use a::A;\npub use b::{self, B};");
    assert_eq!(
        circles(&[parent, ("a", "use super::B;"), ("b", "fn b() { crate::a::A::new(); }")]),
        ["a names b", "b names a"]
    );
    assert!(circles(&[parent, ("a", "use super::B;"), ("b", "use std::fmt::{self, Debug};")]).is_empty());
    assert!(
        circles(&[("", "mod a;\nuse a::A;"), ("a", "mod b;\nuse self::b::B;"), ("a/b", "use super::A;")]).is_empty()
    );
}
