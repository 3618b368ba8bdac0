//! Lists the built-in files: every file of the folders below, so that a new language, mask or program is only a file.

use std::collections::HashMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

use flate2::Compression;
use flate2::write::ZlibEncoder;

/// Constant, folder, what it holds.
const SHIPPED: [(&str, &str, &str); 9] = [
    ("DIALOGUES", "assets/dialogues", "Words of the control's dialogue languages, as `nl.toml`."),
    ("LOGS", "assets/logs", "Words and templates of measuring logs, as `nl.toml`."),
    ("MANUAL", "docs/manual", "Pages of the manual, as `check.md`."),
    ("MASKS", "assets/masks", "FN 16 masks, as `82552_nl.a`."),
    ("NC", "assets/nc", "NC programs and pages of text for a control, as `8255_nl.h`."),
    ("SAMPLES", "assets/samples", "Files to try the program with, as `sample_plate.toml`."),
    ("TRANSLATED", "docs/translated", "Pages of the manual in other languages, as `nl/operator.md`."),
    ("TEMPLATES", "assets/report/templates", "Templates of reports, as `inspection.toml`."),
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
    languages(&Path::new(&root).join("../../assets/locales"), Path::new(&out), &mut code)?;
    fs::write(Path::new(&out).join("shipped.rs"), code)
}

/// The texts of a Fluent file by their names, in its order. A name begins its line; the rest of its text is indented.
fn read(file: &Path) -> io::Result<Vec<(String, String)>> {
    let mut texts: Vec<(String, String)> = Vec::new();
    for line in fs::read_to_string(file)?.lines() {
        match line.split_once('=') {
            Some((name, text)) if line.starts_with(|c: char| c.is_ascii_alphabetic()) => {
                texts.push((name.trim_end().to_owned(), text.trim().to_owned()));
            }
            _ if line.starts_with('#') || line.trim().is_empty() => {}
            _ => {
                if let Some((_, text)) = texts.last_mut() {
                    text.push_str("\n ");
                    text.push_str(line.trim());
                }
            }
        }
    }
    Ok(texts)
}

/// Lists the languages. All have the texts of English in the order of English, so that their names stand there once; the texts of the others
/// are packed. A test finds what a language lacks.
#[expect(clippy::disallowed_methods, reason = "they are made anew whenever they are needed")]
fn languages(locales: &Path, out: &Path, code: &mut String) -> io::Result<()> {
    println!("cargo::rerun-if-changed={}", locales.display());
    let mut files = Vec::new();
    collect(&locales.join("en"), &mut files)?;
    files.sort();
    let mut names = Vec::new();
    for file in &files {
        names.push(read(file)?.into_iter().map(|(name, _)| name).collect::<Vec<_>>());
    }
    let all: Vec<String> = names.iter().map(|names| names.join("\n")).collect();
    let mut add = |line: std::fmt::Arguments<'_>| code.write_fmt(line).map_err(io::Error::other);
    add(format_args!("/// The names of the texts, line by line; an empty line stands between two files.\n"))?;
    add(format_args!("pub static NAMES: &str = {:?};\n", all.join("\n\n")))?;
    add(format_args!("static LANGUAGES: &[Packed] = &[\n"))?;
    let mut folders: Vec<PathBuf> = fs::read_dir(locales)?.map(|entry| Ok(entry?.path())).collect::<io::Result<_>>()?;
    folders.sort();
    for folder in folders.iter().filter(|path| path.is_dir()) {
        let language = folder.file_name().unwrap_or_default().to_string_lossy();
        let mut known = HashMap::new();
        let mut files = Vec::new();
        collect(folder, &mut files)?;
        for file in files {
            known.extend(read(&file)?);
        }
        let text = |name: &str| known.get(name).map_or("", String::as_str);
        let texts: Vec<&str> = names.iter().flatten().map(|name| text(name)).collect();
        let texts = texts.join("\0");
        let is_plain = language == "en";
        let mut bytes = texts.clone().into_bytes();
        if !is_plain {
            let mut packing = ZlibEncoder::new(Vec::new(), Compression::best());
            packing.write_all(texts.as_bytes())?;
            bytes = packing.finish()?;
        }
        let file = out.join(format!("{language}.texts"));
        fs::write(&file, bytes)?;
        add(format_args!(
            "    Packed {{ code: {language:?}, name: {:?}, decimal_sign: {:?}, is_plain: {is_plain}, texts: include_bytes!({:?}) }},\n",
            text("language-name"),
            text("language-decimal-sign").chars().next().unwrap_or('.'),
            file.display().to_string(),
        ))?;
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
