//! The command line, byte for byte: compares every call of `tests/data/corpus/*.txt` with its recorded output.
//!
//! `CORPUS=write cargo test --no-default-features --test core corpus` records the output again; the difference is then
//! read in the files: review it like code. Help and errors list cycles, formats and subcommands, so that a new one of these
//! changes answers of other calls, too.
//!
//! Calls are written by hand. Every subcommand, option and value of an option needs one, and a test names every missing call.
//! Options of a struct that subcommands share, such as `TableArgs`, need one call in all; each of these subcommands needs a
//! call with one of them. A file is a list of calls:
//!
//! ```text
//! # A comment; it belongs to the call below it.
//! $ fitcheck import own.csv --time 2026-01-02T03:04     the call: words apart by blanks, "…" and '…' hold blanks
//! < 25 H7                                               a line of standard input
//! @ own.csv                                             a file that the call finds …
//! < callout;measured                                    … and a line of it
//! <*3 25 H7;25.01                                       a line three times
//! @ fit.tab = samples/tables/generation1_plain.tab      a file that the call finds, from tests/data
//! @ empty/                                              a folder that the call finds
//! | GOOD                                                a line of standard output
//! ! warning: …                                          a line of standard error
//! = 10                                                  the exit code where it is not 0
//! > out/report.csv                                      a file that the call has written or changed …
//! | 25 H7                                               … and a line of it
//! ```
//!
//! Every call runs in a fresh folder with a copy of the files that it names from `tests/data/corpus/inputs`. Control
//! characters are written as their pictures, such as `␍`; `◁` at the end of a line means that no line end follows. A
//! text that is not UTF-8 is shown as Windows-1252 and marked so; bytes that are not text, or long, become a length and
//! a hash. The current time becomes `«now»`, the call's folder `«here»`.

#![cfg(test)]

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};

use clap::CommandFactory as _;

/// Longer streams become a length and a hash.
const LONGEST_STREAM: usize = 16_000;

/// Longer files that a call has written become a length and a hash.
const LONGEST_FILE: usize = 4_000;

/// One call as its file has it.
struct Call {
    file: PathBuf,
    line: usize,
    words: Vec<String>,
    /// What the writer of the corpus wrote: comments, the call, its input.
    given: Vec<String>,
    /// The output of the program.
    said: Vec<String>,
    input: Vec<u8>,
    /// Files and folders that the call finds.
    files: Vec<(String, Vec<u8>)>,
}

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data")
}

fn words(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quote = None;
    for c in text.chars() {
        match quote {
            Some(open) if c == open => quote = None,
            None if c == '"' || c == '\'' => {
                quote = Some(c);
                word.get_or_insert_default();
            }
            None if c == ' ' => words.extend(word.take()),
            _ => word.get_or_insert_default().push(c),
        }
    }
    assert!(quote.is_none(), "a quotation mark is not closed: {text}");
    words.extend(word);
    words
}

/// A line of a file from its form in the corpus.
fn unshown(line: &str) -> Vec<u8> {
    let mut text: String = line
        .chars()
        .map(|c| match u32::from(c) {
            picture @ 0x2400..=0x241F => char::from_u32(picture - 0x2400).unwrap(),
            _ => c,
        })
        .collect();
    if text.ends_with('◁') {
        text.pop();
    } else {
        text.push('\n');
    }
    text.into_bytes()
}

/// A text in the form of the corpus, each line after its mark.
fn shown(mark: char, text: &str) -> Vec<String> {
    let has_end = text.ends_with('\n');
    let mut lines: Vec<String> = text
        .strip_suffix('\n')
        .unwrap_or(text)
        .split('\n')
        .map(|line| {
            let line: String = line
                .chars()
                .map(|c| match u32::from(c) {
                    code @ 0..=0x1F if c != '\t' => char::from_u32(0x2400 + code).unwrap(),
                    _ => c,
                })
                .collect();
            if line.is_empty() { mark.to_string() } else { format!("{mark} {line}") }
        })
        .collect();
    if !has_end {
        lines.last_mut().unwrap().push('◁');
    }
    lines
}

fn calls_of(file: &Path) -> (Vec<Call>, Vec<String>) {
    let text = std::fs::read_to_string(file).unwrap();
    let mut calls: Vec<Call> = Vec::new();
    let mut between: Vec<String> = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let place = format!("{}:{}", file.display(), number + 1);
        let rest = line.get(1..).unwrap_or_default();
        let rest = rest.strip_prefix(' ').unwrap_or(rest);
        match line.chars().next() {
            None | Some('#') => between.push(line.to_owned()),
            Some('$') => {
                let words = words(rest.strip_prefix("fitcheck").unwrap_or_else(|| panic!("{place}: no fitcheck")));
                let mut given = std::mem::take(&mut between);
                given.push(line.to_owned());
                let (file, line) = (file.to_owned(), number + 1);
                let (said, input, files) = Default::default();
                calls.push(Call { file, line, words, given, said, input, files });
            }
            Some(mark) => {
                let call = calls.last_mut().unwrap_or_else(|| panic!("{place}: no call before"));
                assert!(between.is_empty(), "{place}: a comment or an empty line within a call");
                if !matches!(mark, '<' | '@') {
                    assert!("|!=>~".contains(mark), "{place}: no mark");
                    call.said.push(line.to_owned());
                    continue;
                }
                assert!(call.said.is_empty(), "{place}: input behind output");
                call.given.push(line.to_owned());
                if mark == '@' {
                    let (name, source) = rest.split_once(" = ").unwrap_or((rest, ""));
                    let bytes =
                        if source.is_empty() { Vec::new() } else { std::fs::read(data().join(source)).unwrap() };
                    call.files.push((name.to_owned(), bytes));
                } else {
                    let (times, text) = line.strip_prefix("<*").map_or((1, rest), |rest| {
                        let (times, text) = rest.split_once(' ').unwrap();
                        (times.parse().unwrap(), text)
                    });
                    let into = call.files.last_mut().map_or(&mut call.input, |(_, bytes)| bytes);
                    into.extend(unshown(text).repeat(times));
                }
            }
        }
    }
    (calls, between)
}

fn corpus() -> Vec<(PathBuf, Vec<Call>, Vec<String>)> {
    let folder = data().join("corpus");
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "txt"));
    files.sort();
    files
        .into_iter()
        .map(|file| {
            let (calls, rest) = calls_of(&file);
            (file, calls, rest)
        })
        .collect()
}

/// Every file below a folder with its bytes, every folder with a `/` after its name.
fn tree(root: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut found = BTreeMap::new();
    let mut open = vec![root.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(root).unwrap().to_string_lossy().replace('\\', "/");
            if path.is_dir() {
                found.insert(name + "/", Vec::new());
                open.push(path);
            } else {
                found.insert(name, std::fs::read(path).unwrap());
            }
        }
    }
    found
}

fn put(folder: &Path, name: &str, bytes: &[u8]) {
    let path = folder.join(name);
    if name.ends_with('/') {
        std::fs::create_dir_all(path).unwrap();
    } else {
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::File::create(path).unwrap().write_all(bytes).unwrap();
    }
}

fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

/// What varies from run to run.
struct Varying {
    folder: String,
    times: Vec<String>,
}

impl Varying {
    fn new(folder: &Path, begin: &jiff::Zoned, end: &jiff::Zoned) -> Self {
        let mut times = Vec::new();
        let mut time = begin.clone();
        while time.timestamp().as_second() <= end.timestamp().as_second() {
            for form in
                ["%Y-%m-%dT%H:%M:%S", "%Y-%m-%d %H:%M:%S", "%d-%m-%Y %H:%M:%S", "%Y-%m-%d %H:%M", "%Y-%m-%dT%H:%M"]
            {
                times.push(time.strftime(form).to_string());
            }
            time = time.saturating_add(jiff::Span::new().seconds(1));
        }
        // The longer form first: the shorter one begins the same.
        times.sort_by_key(|text| std::cmp::Reverse(text.len()));
        Self { folder: folder.to_str().unwrap().to_owned(), times }
    }

    /// Bytes as lines of the corpus, and a word about them.
    fn lines(&self, mark: char, longest: usize, bytes: &[u8]) -> (&'static str, Vec<String>) {
        let (note, text) = match std::str::from_utf8(bytes) {
            _ if bytes.is_empty() => return (" (empty)", Vec::new()),
            Ok(text) => ("", text.to_owned()),
            Err(_) => (" (Windows-1252)", encoding_rs::WINDOWS_1252.decode_without_bom_handling(bytes).0.into_owned()),
        };
        let text = text.replace(&self.folder, "«here»");
        let text = self.times.iter().fold(text, |text, time| text.replace(time, "«now»"));
        if longest < text.len() || text.contains('\0') {
            return ("", vec![format!("~ {} bytes, FNV-1a {:016x}", text.len(), fnv(text.as_bytes()))]);
        }
        (note, shown(mark, &text))
    }
}

/// The program's output for a call, as lines of the corpus; `inputs` are the files of `corpus/inputs`.
fn answer(call: &Call, inputs: &BTreeMap<String, Vec<u8>>) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in inputs {
        let first = name.split('/').next().unwrap();
        if call.given.iter().any(|line| line.contains(first)) {
            put(folder.path(), name, bytes);
        }
    }
    for (name, bytes) in &call.files {
        put(folder.path(), name, bytes);
    }
    let before = tree(folder.path());
    let mut command = Command::new(env!("CARGO_BIN_EXE_fitcheck"));
    command.args(&call.words).current_dir(folder.path()).env_clear().env("TZ", "UTC");
    if let Some(root) = std::env::var_os("SystemRoot") {
        command.env("SystemRoot", root);
    }
    let begin = jiff::Zoned::now().with_time_zone(jiff::tz::TimeZone::UTC);
    let child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    let mut child = child.unwrap();
    // The program may end before it has read everything.
    let _unread = child.stdin.take().unwrap().write_all(&call.input);
    let output = child.wait_with_output().unwrap();
    let end = jiff::Zoned::now().with_time_zone(jiff::tz::TimeZone::UTC);
    let after = tree(folder.path());
    let varying = Varying::new(folder.path(), &begin, &end);
    let mut lines = varying.lines('|', LONGEST_STREAM, &output.stdout).1;
    lines.extend(varying.lines('!', LONGEST_STREAM, &output.stderr).1);
    match output.status.code() {
        Some(0) => {}
        code => lines.push(format!("= {}", code.map_or("ended by a signal".to_owned(), |code| code.to_string()))),
    }
    for (name, bytes) in &after {
        if before.get(name) != Some(bytes) {
            let (note, content) = varying.lines('|', LONGEST_FILE, bytes);
            lines.push(format!("> {name}{}", if name.ends_with('/') { "" } else { note }));
            lines.extend(content);
        }
    }
    lines.extend(before.keys().filter(|name| !after.contains_key(*name)).map(|name| format!("> {name} (gone)")));
    lines
}

/// The answers to all calls, in their order.
fn answers(calls: &[&Call]) -> Vec<Vec<String>> {
    let next = AtomicUsize::new(0);
    let inputs = tree(&data().join("corpus/inputs"));
    let work = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(call) = calls.get(index) else { return done };
            done.push((index, answer(call, &inputs)));
        }
    };
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    let mut all: Vec<(usize, Vec<String>)> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().unwrap()).collect()
    });
    all.sort_by_key(|(index, _)| *index);
    all.into_iter().map(|(_, lines)| lines).collect()
}

/// Whether it is said in the same words; on Windows paths have other separators, and errors of the system other words.
fn is_the_same(recorded: &[String], said: &[String]) -> bool {
    let plain = |line: &String| line.replace("\\\\", "/").replace('\\', "/");
    let is_of_system = |line: &String| line.contains("(os error ") || line.starts_with("~ ");
    let are_alike = |(one, other): (&String, &String)| one == other || plain(one) == plain(other) || is_of_system(one);
    if cfg!(windows) {
        recorded.len() == said.len() && recorded.iter().zip(said).all(are_alike)
    } else {
        recorded == said
    }
}

#[test]
fn every_call_says_what_it_said() {
    let corpus = corpus();
    let calls: Vec<&Call> = corpus.iter().flat_map(|(_, calls, _)| calls).collect();
    let answers = answers(&calls);
    if std::env::var_os("CORPUS").is_some_and(|value| value == "write") {
        let mut answers = answers.into_iter();
        for (file, calls, rest) in &corpus {
            let mut lines = Vec::new();
            for call in calls {
                lines.extend(call.given.iter().cloned());
                lines.extend(answers.next().unwrap());
            }
            lines.extend(rest.iter().cloned());
            fitcheck::files::write(file, (lines.join("\n") + "\n").as_bytes()).unwrap();
        }
        return;
    }
    let mut differences = String::new();
    let mut count = 0;
    for (call, said) in calls.iter().zip(&answers) {
        if is_the_same(&call.said, said) {
            continue;
        }
        count += 1;
        let at = call.said.iter().zip(said).take_while(|(one, other)| one == other).count();
        let line = |lines: &[String]| lines.get(at).map_or("nothing more".to_owned(), Clone::clone);
        writeln!(
            differences,
            "{}:{}: fitcheck {}\n  expected  {}\n  but is    {}",
            call.file.display(),
            call.line,
            call.words.join(" "),
            line(&call.said),
            line(said),
        )
        .unwrap();
    }
    assert!(
        count == 0,
        "{count} of {} calls differ:\n{differences}\nwhere that is meant: CORPUS=write, and read the diff",
        calls.len()
    );
}

/// Something that the corpus needs a call for.
struct Wanted {
    what: String,
    is_used: bool,
    /// An option of a struct that several subcommands have, such as `TableArgs`, by struct and option.
    shared: Option<(String, String)>,
}

/// Structs of options that several subcommands have, by name, each with the names of its options.
type SharedStructs = BTreeMap<String, BTreeSet<String>>;

/// clap knows which subcommand has which struct, but not which options a struct has: those that all its subcommands
/// have with the same help. What a subcommand has for itself is called `Args`, everywhere.
fn shared_structs(command: &clap::Command) -> SharedStructs {
    let mut found: BTreeMap<String, (usize, BTreeSet<(String, String)>)> = BTreeMap::new();
    let mut open = vec![command];
    while let Some(command) = open.pop() {
        open.extend(command.get_subcommands());
        let options = command.get_arguments().filter(|one| !matches!(one.get_action(), clap::ArgAction::Help));
        let options: BTreeSet<_> =
            options.map(|one| (one.get_id().to_string(), format!("{:?}", one.get_help()))).collect();
        for name in command.get_groups().map(|group| group.get_id().to_string()).filter(|name| name != "Args") {
            let (subcommands, common) = found.entry(name).or_insert_with(|| (0, options.clone()));
            *subcommands += 1;
            common.retain(|option| options.contains(option));
        }
    }
    found.retain(|_, (subcommands, _)| 1 < *subcommands);
    found.into_iter().map(|(name, (_, options))| (name, options.into_iter().map(|(id, _)| id).collect())).collect()
}

/// Every subcommand, every option of it and every value of each option.
fn wanted(command: &clap::Command, path: &[&str], calls: &[&Call], shared: &SharedStructs) -> Vec<Wanted> {
    let name = path.join(" ");
    let calls: Vec<&Call> = calls
        .iter()
        .copied()
        .filter(|call| call.words.iter().zip(path).filter(|(a, b)| a == b).count() == path.len())
        .collect();
    let has = |wanted: &[&str]| calls.iter().any(|call| call.words.windows(wanted.len()).any(|words| words == wanted));
    let mut all =
        vec![Wanted { what: format!("no call of fitcheck {name}"), is_used: !calls.is_empty(), shared: None }];
    let mut structs: BTreeMap<String, bool> = BTreeMap::new();
    // What every subcommand has counts once.
    let is_own = |argument: &&clap::Arg| !argument.is_positional() && (path.is_empty() || !argument.is_global_set());
    for argument in command.get_arguments().filter(is_own) {
        let options: Vec<String> = [
            argument.get_long().map(|long| format!("--{long}")),
            argument.get_short().map(|short| format!("-{short}")),
        ]
        .into_iter()
        .flatten()
        .collect();
        let has_it = |name: &String| shared.get(name).is_some_and(|ids| ids.contains(argument.get_id().as_str()));
        let origin = command.get_groups().map(|group| group.get_id().to_string()).find(has_it);
        let mut want = |text: String, is_used: bool| {
            let what = match &origin {
                Some(origin) => format!("no subcommand with the options of {origin} has a call with {text}"),
                None => format!("fitcheck {name} without {text}"),
            };
            all.push(Wanted { what, is_used, shared: origin.clone().map(|origin| (origin, text)) });
        };
        let is_used = options.iter().any(|option| has(&[option]));
        want(options.join(" "), is_used);
        let takes_value = argument.get_action().takes_values();
        for value in argument.get_possible_values().into_iter().filter(|_| takes_value) {
            let is_used = options.iter().any(|option| has(&[option, value.get_name()]));
            want(format!("{} {}", options.join(" "), value.get_name()), is_used);
        }
        if let Some(origin) = origin {
            *structs.entry(origin).or_default() |= is_used;
        }
    }
    // An option of a shared struct counts once, but a subcommand that has the struct uses something of it.
    let of_struct = |(origin, is_used)| Wanted {
        what: format!("fitcheck {name} without any option of {origin}"),
        is_used,
        shared: None,
    };
    all.extend(structs.into_iter().map(of_struct));
    // What helps of itself repeats the help of the others.
    for subcommand in command.get_subcommands().filter(|subcommand| subcommand.get_name() != "help") {
        all.extend(wanted(subcommand, &[path, &[subcommand.get_name()]].concat(), &calls, shared));
    }
    all
}

#[test]
fn every_subcommand_option_and_value_occurs() {
    let corpus = corpus();
    let calls: Vec<&Call> = corpus.iter().flat_map(|(_, calls, _)| calls).collect();
    assert!(320 <= calls.len(), "{} calls", calls.len());
    let different: BTreeSet<String> =
        calls.iter().map(|call| format!("{:?}{:?}{:?}", call.words, call.input, call.files)).collect();
    assert_eq!(different.len(), calls.len(), "a call stands there twice");
    let mut command = fitcheck::cli::Cli::command();
    command.build();
    let shared = shared_structs(&command);
    assert!(shared["TableArgs"].contains("tables"), "the search for shared options finds only {shared:?}");
    let wanted = wanted(&command, &[], &calls, &shared);
    let used: BTreeSet<_> = wanted.iter().filter(|one| one.is_used).filter_map(|one| one.shared.as_ref()).collect();
    let is_missing = |one: &&Wanted| !one.is_used && !one.shared.as_ref().is_some_and(|shared| used.contains(shared));
    let missing: BTreeSet<&str> = wanted.iter().filter(is_missing).map(|one| one.what.as_str()).collect();
    assert!(
        missing.is_empty(),
        "{}\nfor each, add a line \"$ fitcheck …\" to tests/data/corpus/*.txt, then \
         CORPUS=write cargo test --no-default-features --test core corpus:: records what it says; read the diff",
        missing.into_iter().collect::<Vec<_>>().join("\n")
    );
}
