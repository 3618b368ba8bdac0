//! Lists the built-in files: every file of the folders below, so that a new language, mask or program is only a file.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// Constant, folder, what it holds.
const SHIPPED: [(&str, &str, &str); 8] = [
    ("LOCALES", "assets/locales", "Fluent files of the window's languages, as `en/tolerance.ftl`."),
    ("DIALOGUES", "assets/dialogues", "Words of the control's dialogue languages, as `nl.toml`."),
    ("LOGS", "assets/logs", "Words and templates of measuring logs, as `nl.toml`."),
    ("MANUAL", "docs/manual", "Pages of the manual, as `check.md`."),
    ("MASKS", "assets/masks", "FN 16 masks, as `82552_nl.a`."),
    ("NC", "assets/nc", "NC programs and pages of text for a control, as `8255_nl.h`."),
    ("SAMPLES", "assets/samples", "Files to try the program with, as `sample_plate.toml`."),
    ("TABLES", "tables", "Control tables, as `82553_hole.tab`."),
];

#[expect(clippy::disallowed_methods, reason = "the list is made anew whenever it is needed")]
fn main() -> io::Result<()> {
    let root = env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?;
    let out = env::var("OUT_DIR").map_err(io::Error::other)?;
    let mut code = String::new();
    println!("cargo::rerun-if-changed=build.rs");
    for (name, folder, what) in SHIPPED {
        println!("cargo::rerun-if-changed=../../{folder}");
        let base = Path::new(&root).join("../..").join(folder);
        let mut files = Vec::new();
        collect(&base, &mut files)?;
        files.sort();
        let mut add = |line: std::fmt::Arguments<'_>| code.write_fmt(line).map_err(io::Error::other);
        add(format_args!("/// {what}\npub static {name}: &[(&str, &[u8])] = &[\n"))?;
        for file in &files {
            let short = file.strip_prefix(&base).map_err(io::Error::other)?.to_string_lossy().replace('\\', "/");
            add(format_args!(
                "    ({short:?}, include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), {:?}))),\n",
                format!("/../../{folder}/{short}")
            ))?;
        }
        add(format_args!("];\n"))?;
    }
    texts(&Path::new(&root).join("../../assets/locales"), &mut code)?;
    fs::write(Path::new(&out).join("shipped.rs"), code)
}

/// Lists the names of the texts of each language with their files, so that a start of the program parses only the
/// files that it needs. A name begins its line; the rest of its text is indented.
fn texts(locales: &Path, code: &mut String) -> io::Result<()> {
    let mut add = |line: std::fmt::Arguments<'_>| code.write_fmt(line).map_err(io::Error::other);
    let mut languages: Vec<PathBuf> =
        fs::read_dir(locales)?.map(|entry| Ok(entry?.path())).collect::<io::Result<_>>()?;
    languages.sort();
    add(format_args!(
        "/// The names of each language's texts in their order, each with the number of its file among the language's.\n\
         pub static TEXTS: &[(&str, &[(&str, usize)])] = &[\n"
    ))?;
    for language in languages.iter().filter(|path| path.is_dir()) {
        let mut files = Vec::new();
        collect(language, &mut files)?;
        files.sort();
        let mut names = Vec::new();
        for (number, file) in files.iter().enumerate() {
            let text = fs::read_to_string(file)?;
            let lines = text.lines().filter(|line| line.starts_with(|c: char| c.is_ascii_alphabetic()));
            let found = lines.filter_map(|line| line.split_once('=')).map(|(name, _)| name.trim_end());
            names.extend(found.map(|name| (name.to_owned(), number)));
        }
        names.sort();
        let name = language.file_name().unwrap_or_default().to_string_lossy();
        add(format_args!("    ({name:?}, &{names:?}),\n"))?;
    }
    add(format_args!("];\n"))
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() { collect(&path, files)? } else { files.push(path) }
    }
    Ok(())
}
