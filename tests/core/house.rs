//! The house's own rules, checked against the source: which room may use which.

use std::path::{Path, PathBuf};

pub fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            found.push(path);
        }
    }
    found
}

/// The code of a file: without comments, and without its tests at the end.
pub fn code(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default().to_owned();
    text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// The folders with code of the program: `src` of the root and of every crate but the macro's.
pub fn source_folders() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let crates = std::fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path());
    let mut folders: Vec<_> =
        crates.filter(|path| !path.ends_with("derive")).chain([root.to_owned()]).map(|path| path.join("src")).collect();
    folders.sort();
    folders
}

/// Crates whose files are all of one room, but for rooms of their own in it.
const OF_ONE_ROOM: [(&str, &[&str]); 7] = [
    ("files", &[]),
    ("gauges", &[]),
    ("nc", &["control"]),
    ("session", &[]),
    ("shipped", &[]),
    ("statistics", &[]),
    ("store", &["watch"]),
];

/// The rooms in a crate of one room.
fn rooms_within(name: &str) -> Option<&'static [&'static str]> {
    OF_ONE_ROOM.iter().find(|(known, _)| *known == name).map(|(_, within)| *within)
}

/// A file's name from its room on: `nc/machine/store.rs`, `control/mask/mod.rs`, `tolerance/class.rs`, `cli/io.rs`.
fn name_of(path: &Path) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let name = path.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
    let Some((of, rest)) = name.strip_prefix("crates/").and_then(|name| name.split_once("/src/")) else {
        return name.strip_prefix("src/").unwrap().to_owned();
    };
    let room = rest.split('/').next().unwrap();
    match rooms_within(of) {
        Some(within) if !within.contains(&room) => format!("{of}/{rest}"),
        _ => rest.to_owned(),
    }
}

/// Whether a file has only tests.
fn is_of_tests(name: &str) -> bool {
    name.ends_with("tests.rs") || name.contains("/tests/")
}

/// Every file of the program, by its name from its room on.
fn all_files() -> Vec<(String, PathBuf)> {
    let all = source_folders().into_iter().flat_map(|folder| sources(&folder));
    all.map(|path| (name_of(&path), path)).collect()
}

/// The code of the files that are wanted.
fn files(wanted: impl Fn(&str) -> bool) -> Vec<(String, String)> {
    let named = all_files().into_iter().filter(|(name, _)| wanted(name));
    named.map(|(name, path)| (name, code(&path))).collect()
}

#[track_caller]
fn none_names(files: &[(String, String)], words: &[&str]) {
    assert!(!files.is_empty(), "no file looked at");
    for (name, code) in files {
        for word in words {
            assert!(!code.contains(word), "{name} names {word}");
        }
    }
}

/// The rooms from the ground up, each with its crate and the rooms of the same crate that it may name: an arrow only
/// points down. Which crate may name which is in their manifests, and the compiler holds it.
pub const ROOMS: [(&str, &str, &[&str]); 29] = [
    ("shipped", "shipped", &[]),
    ("core", "message", &[]),
    ("core", "length", &["message"]),
    ("core", "words", &["message", "length"]),
    ("core", "text", &[]),
    ("core", "law", &[]),
    ("core", "tolerance", &["message", "length", "words"]),
    ("core", "verdict", &["message", "length", "law", "tolerance"]),
    ("core", "pairing", &["message", "length", "tolerance"]),
    ("core", "probing", &["message", "length", "words", "tolerance", "verdict"]),
    ("core", "budget", &["message", "length", "law", "tolerance", "verdict", "probing"]),
    ("core", "part", &["message", "length", "text", "tolerance", "verdict", "probing"]),
    ("statistics", "statistics", &[]),
    ("nc", "control", &[]),
    ("nc", "nc", &["control"]),
    ("exchange", "journal", &[]),
    ("exchange", "exchange", &["journal"]),
    ("exchange", "series", &["journal", "exchange"]),
    ("exchange", "batch", &["exchange"]),
    ("exchange", "row", &["journal"]),
    ("exchange", "report", &["journal", "exchange", "series", "row"]),
    ("exchange", "proof", &["journal", "report"]),
    ("files", "files", &[]),
    ("store", "store", &[]),
    ("store", "watch", &[]),
    ("gauges", "gauges", &[]),
    ("session", "session", &[]),
    // Neither the command line nor the window names the other, and only the window names the session.
    ("fitcheck", "cli", &[]),
    ("fitcheck", "gui", &["session"]),
];

/// The rooms that a line of code of a room names: `crate::room` in a crate of several, `fitcheck_core::room` elsewhere.
fn named_rooms<'a>(line: &'a str, room: &'a str) -> impl Iterator<Item = &'a str> {
    let first = |rest: &'a str| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap();
    let own = line.split("crate::").skip(1).map(first);
    let house = OF_ONE_ROOM.iter().find(|(of, within)| *of == room || within.contains(&room));
    let own = own.map(move |named| match house {
        Some((of, within)) if !within.contains(&named) => of,
        _ => named,
    });
    let others = line.split("fitcheck_").skip(1).filter_map(move |rest| {
        let (of, rest) = rest.split_at(rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(rest.len()));
        let named = rest.strip_prefix("::").map(first);
        match rooms_within(of) {
            Some(within) => named.filter(|named| within.contains(named)).or(Some(of)),
            None => named.filter(|named| !named.is_empty()),
        }
    });
    own.chain(others)
}

/// The lines of a file that are a room's code, with their numbers: no comments, and no tests at the end.
fn numbered_code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    (1..).zip(code.lines()).filter(|(_, line)| !line.trim_start().starts_with("//"))
}

/// The crate of a room.
fn crate_of(room: &str) -> Option<&'static str> {
    ROOMS.iter().find(|(_, known, _)| *known == room).map(|(of, ..)| *of)
}

#[test]
fn arrows_point_down() {
    for (number, (_, room, may)) in ROOMS.iter().enumerate() {
        let below = |name: &&str| ROOMS[..number].iter().any(|(_, lower, _)| lower == name);
        assert!(may.iter().all(below), "{room} may name rooms above it");
    }
    let (mut wrong, mut arrows) = (Vec::new(), 0);
    for (name, path) in all_files() {
        let room = name.split('/').next().unwrap().trim_end_matches(".rs");
        if ["lib", "main", "window"].contains(&room) || is_of_tests(&name) {
            continue;
        }
        let Some((of, _, may)) = ROOMS.iter().find(|(_, known, _)| *known == room) else {
            wrong.push(format!("{name}: {room} is no known room"));
            continue;
        };
        let text = std::fs::read_to_string(&path).unwrap();
        for (line, code) in numbered_code(&text) {
            for other in named_rooms(code, room).filter(|other| *other != room) {
                arrows += 1;
                let is_within = crate_of(other) == Some(*of) || *of == "fitcheck" && other == "session";
                if is_within && !may.contains(&other) {
                    wrong.push(format!("{name}:{line}: {room} names {other}"));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(1_500 < arrows, "the search finds only {arrows}");
}

#[test]
fn a_wrong_arrow_is_found_in_code_only() {
    let text = "use crate::gui::theme;\n// crate::cli\n/// [`crate::cli`]\nlet a = crate::words::say(crate::cli::b);\n\
        use fitcheck_core::length::Length;\nfitcheck_nc::control::mask();\nuse fitcheck_nc::machine;\n\
        use fitcheck_files as files;\n#[cfg(test)]\nmod tests {\n    use crate::session;\n}\n";
    let named: Vec<_> =
        numbered_code(text).flat_map(|(line, code)| named_rooms(code, "cli").map(move |room| (line, room))).collect();
    let expected = [(1, "gui"), (4, "words"), (4, "cli"), (5, "length"), (6, "control"), (7, "nc"), (8, "files")];
    assert_eq!(named, expected);
    let of = |line, room| named_rooms(line, room).collect::<Vec<_>>();
    assert_eq!(of("use crate::machine::Store;", "control"), ["nc"]);
    assert_eq!(of("use crate::control::mask;", "nc"), ["control"]);
    assert_eq!(of("use crate::page::Page;", "session"), ["session"]);
}

#[test]
fn only_the_window_knows_egui() {
    none_names(&files(|name| !name.starts_with("gui/")), &["egui", "eframe", "rfd::"]);
}

#[test]
fn the_core_touches_no_file_thread_or_clock() {
    let core = |name: &str| {
        let rooms = [
            "length/",
            "tolerance/",
            "pairing/",
            "probing/",
            "budget/",
            "part/",
            "statistics/",
            "report/",
            "exchange/",
            "series/",
        ];
        rooms.iter().chain(&["session/"]).any(|room| name.starts_with(room))
            || name.starts_with("verdict/")
            || ["text.rs", "journal/mod.rs", "journal/window.rs"].contains(&name)
    };
    none_names(&files(core), &["std::fs", "std::thread", "Zoned::now", "Timestamp::now", "SystemTime", "Instant"]);
}

#[test]
fn a_cycle_gets_limits_and_never_a_tolerance_class() {
    none_names(&files(|name| name.starts_with("probing/")), &["ToleranceClass", "Callout", "Sources"]);
}

#[test]
fn colours_come_from_the_theme_file() {
    let window = files(|name| name.starts_with("gui/") && !name.starts_with("gui/theme/"));
    none_names(&window, &["from_rgb", "from_gray", "Color32::RED", "Color32::GREEN", "from_hex", "FontId::new"]);
}

#[test]
fn files_are_written_whole_in_one_place() {
    let others = files(|name| name != "files/lib.rs");
    none_names(&others, &["std::fs::write", "File::create"]);
}

/// A cycle is one file: nothing else in the source names its number. The page of points has a format's own marks.
#[test]
fn no_cycle_is_named_outside_its_own_file() {
    let others =
        |name: &str| !is_of_tests(name) && !name.starts_with("probing/cycles/") && !name.starts_with("tolerance/");
    let numbers = fitcheck::probing::cycles::CYCLES.iter().map(|cycle| cycle.number);
    // 400 is a round number, too.
    let cycles: Vec<String> = numbers.filter(|number| *number != 400).map(|number| number.to_string()).collect();
    let is_cycle = |word: &&str| {
        let word = word.trim_start_matches(['G', 'Q']).trim_end_matches("_u16");
        cycles.iter().any(|cycle| cycle == word)
    };
    let named = files(others).into_iter().flat_map(|(name, code)| {
        let is_between = |c: char| !c.is_ascii_alphanumeric() && !"._-#".contains(c);
        let found: Vec<_> =
            code.split(is_between).filter(is_cycle).map(|word| format!("{name} names {word}")).collect();
        found
    });
    let marks = ["control/point_log/stored.rs names 444"];
    let found: Vec<_> = named.filter(|found| !marks.contains(&found.as_str())).collect();
    assert_eq!(found, Vec::<String>::new());
}

/// Elsewhere a zone that nobody knows would be UTC in silence.
#[test]
fn the_time_zone_is_asked_for_in_one_place() {
    let others = files(|name| name != "files/zone.rs");
    none_names(&others, &["Zoned::now", "TimeZone::system", "TimeZone::try_system", "TimeZone::get", "in_tz("]);
}

/// What a person reads on a terminal goes through one writer, which tames it.
#[test]
fn nothing_is_written_around_the_writer_for_people() {
    let others = files(|name| name != "cli/io.rs");
    none_names(&others, &["io::stdout", "io::stderr", "println!", "eprint!", "print!("]);
}

/// Only the cycles declare the names of parameters.
#[test]
fn no_parameter_of_a_cycle_is_asked_for_by_its_number() {
    let others = files(|name| {
        let room = ["control/", "nc/machine/", "session/", "gui/", "cli/", "exchange/"];
        room.iter().any(|room| name.starts_with(room)) && !name.starts_with("control/variables")
    });
    for (name, code) in &others {
        for call in ["inputs.value(", "result.value(", ".parameter("] {
            for rest in code.split(call).skip(1) {
                assert!(!rest.starts_with(|c: char| c.is_ascii_digit()), "{name}: {call} with a number");
            }
        }
    }
}

/// Fitcheck asks nobody and tells nobody but the server of a shop. What the window needs of the desktop is in its crates.
#[test]
fn nothing_talks_to_another_machine() {
    none_names(
        &files(|name| !name.starts_with("store/shop")),
        &["std::net", "os::unix::net", "TcpStream", "UdpSocket", "UnixStream", "ToSocketAddrs", "tokio", "rustls"],
    );
}

/// Written files are given to the system's own program, sounds to a player of it, and nothing else is ever started.
#[test]
fn only_the_window_starts_programs() {
    // `window.rs` starts the program itself and nothing else.
    let others = files(|name| !["gui/effects.rs", "gui/printing.rs", "gui/sound.rs", "window.rs"].contains(&name));
    none_names(&others, &["process::Command", "process::{Command", "opener::", "CommandExt"]);
}
