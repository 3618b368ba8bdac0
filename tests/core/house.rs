//! The house's own rules, checked against the source: which room may use which.

use std::path::{Path, PathBuf};

fn sources(folder: &Path) -> Vec<PathBuf> {
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
fn code(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let text = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default().to_owned();
    text.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// Files below `src`, as relative paths.
fn files(wanted: impl Fn(&str) -> bool) -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let name = |path: &Path| path.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/");
    let named = sources(&root).into_iter().map(|path| (name(&path), path));
    named.filter(|(name, _)| wanted(name)).map(|(name, path)| (name, code(&path))).collect()
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

/// The rooms from the ground up, each with the rooms that it may name: an arrow only points down.
pub const ROOMS: [(&str, &[&str]); 22] = [
    ("shipped", &[]),
    ("message", &["shipped"]),
    ("length", &["message"]),
    ("words", &["shipped", "message", "length"]),
    ("tolerance", &["message", "length", "words"]),
    ("verdict", &["message", "length", "tolerance"]),
    ("pairing", &["message", "length", "tolerance"]),
    ("probing", &["message", "length", "words", "tolerance", "verdict"]),
    ("budget", &["message", "length", "tolerance", "verdict", "probing"]),
    ("control", &["shipped", "message", "length", "words", "tolerance", "verdict", "probing"]),
    ("part", &["message", "length", "tolerance", "verdict", "probing", "control"]),
    ("nc", &["shipped", "message", "length", "words", "tolerance", "verdict", "probing", "control", "part"]),
    ("journal", &["message", "length", "words", "tolerance", "verdict", "probing", "budget", "control", "part"]),
    ("exchange", &["message", "length", "tolerance", "verdict", "probing", "control", "part", "journal"]),
    (
        "report",
        &[
            "shipped",
            "message",
            "length",
            "words",
            "tolerance",
            "verdict",
            "pairing",
            "probing",
            "budget",
            "part",
            "journal",
            "exchange",
        ],
    ),
    ("files", &["message", "tolerance", "control", "nc"]),
    ("store", &["message", "length", "verdict", "journal", "files"]),
    (
        "session",
        &[
            "shipped",
            "message",
            "length",
            "words",
            "tolerance",
            "verdict",
            "pairing",
            "probing",
            "budget",
            "control",
            "part",
            "nc",
            "journal",
            "exchange",
            "report",
            "files",
        ],
    ),
    ("batch", &["length", "tolerance", "exchange"]),
    ("watch", &["message", "tolerance", "control", "part", "journal", "exchange", "files"]),
    (
        "cli",
        &[
            "shipped",
            "message",
            "length",
            "words",
            "tolerance",
            "verdict",
            "pairing",
            "probing",
            "budget",
            "control",
            "part",
            "nc",
            "journal",
            "exchange",
            "report",
            "files",
            "store",
            "batch",
            "watch",
        ],
    ),
    (
        "gui",
        &[
            "shipped",
            "message",
            "length",
            "words",
            "tolerance",
            "verdict",
            "pairing",
            "probing",
            "budget",
            "control",
            "part",
            "nc",
            "journal",
            "exchange",
            "report",
            "files",
            "store",
            "batch",
            "watch",
            "session",
        ],
    ),
];

/// The rooms that a line of code names, `crate::room`.
fn named_rooms(line: &str) -> impl Iterator<Item = &str> {
    line.split("crate::").skip(1).map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next().unwrap())
}

/// The lines of a file that are a room's code, with their numbers: no comments, and no tests at the end.
fn numbered_code(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let code = text.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    (1..).zip(code.lines()).filter(|(_, line)| !line.trim_start().starts_with("//"))
}

#[test]
fn arrows_point_down() {
    for (number, (room, may)) in ROOMS.iter().enumerate() {
        let below = |name: &&str| ROOMS[..number].iter().any(|(lower, _)| lower == name);
        assert!(may.iter().all(below), "{room} may name rooms above it");
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut wrong, mut arrows) = (Vec::new(), 0);
    for path in sources(&root) {
        let name = path.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/");
        let room = name.split('/').next().unwrap().trim_end_matches(".rs");
        if ["lib", "main"].contains(&room) || name.ends_with("tests.rs") {
            continue;
        }
        let text = std::fs::read_to_string(&path).unwrap();
        for (line, code) in numbered_code(&text) {
            for other in named_rooms(code).filter(|other| *other != room) {
                arrows += 1;
                let may = ROOMS.iter().find(|(known, _)| *known == room).map(|(_, may)| *may);
                let arrow = format!("src/{name}:{line}: {room} names {other}");
                match may {
                    None => wrong.push(format!("{arrow}, and {room} is no known room")),
                    Some(may) if may.contains(&other) => {}
                    Some(_) => wrong.push(arrow),
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(300 < arrows, "the search finds only {arrows}");
}

#[test]
fn a_wrong_arrow_is_found_in_code_only() {
    let text = "use crate::gui::theme;\n// crate::cli\n/// [`crate::cli`]\nlet a = crate::words::say(crate::cli::b);\n\
        #[cfg(test)]\nmod tests {\n    use crate::session;\n}\n";
    let named: Vec<_> =
        numbered_code(text).flat_map(|(line, code)| named_rooms(code).map(move |room| (line, room))).collect();
    assert_eq!(named, [(1, "gui"), (4, "words"), (4, "cli")]);
}

#[test]
fn only_the_window_knows_egui() {
    none_names(&files(|name| !name.starts_with("gui/")), &["egui", "eframe", "rfd::"]);
}

#[test]
fn the_core_touches_no_file_thread_or_clock() {
    let core = |name: &str| {
        ["length/", "tolerance/", "pairing/", "probing/", "budget/", "part/", "report/", "exchange/", "session/"]
            .iter()
            .any(|room| name.starts_with(room))
            || name.starts_with("verdict/")
            || ["length.rs", "journal.rs", "journal/window.rs"].contains(&name)
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
    let others = files(|name| name != "files.rs");
    none_names(&others, &["std::fs::write", "File::create"]);
}

/// A cycle is one file: nothing else in the source names its number. The page of points has a format's own marks.
#[test]
fn no_cycle_is_named_outside_its_own_file() {
    let others = |name: &str| {
        !name.ends_with("tests.rs") && !name.starts_with("probing/cycles/") && !name.starts_with("tolerance/")
    };
    let cycles: Vec<String> = fitcheck::probing::cycles::CYCLES.iter().map(|cycle| cycle.number.to_string()).collect();
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

/// Written files are given to the system's own program, and nothing else is ever started.
#[test]
fn only_the_window_starts_programs() {
    let others = files(|name| name != "gui/effects.rs");
    none_names(&others, &["process::Command", "process::{Command", "opener::", "CommandExt"]);
}
