//! Any bytes on standard input of a subcommand: it ends with an exit code of its own, its JSON is JSON, and nothing that
//! it tells a person changes a terminal.

use clap::Parser as _;
use fitcheck::cli::{Cli, Io};

/// The subcommands that read standard input; the first byte of an input chooses one.
const CALLS: [&[&str]; 24] = [
    &["limits", "-"],
    &["limits", "-", "--format", "csv"],
    &["limits", "-", "--format", "json"],
    &["fit", "-"],
    &["fit", "-", "--format", "json"],
    &["circle", "-"],
    &["circle", "-", "--format", "csv"],
    &["circle", "-", "--format", "json"],
    &["check", "25 H7", "--contacts", "-"],
    &["check", "25 H7", "--contacts", "-", "--format", "json"],
    &["import", "-"],
    &["import", "-", "--format", "csv"],
    &["import", "-", "--format", "json"],
    &["report", "-", "-o", "-", "--format", "html"],
    &["report", "-", "-o", "-", "--format", "json"],
    &["table", "verify", "-"],
    &["table", "verify", "-", "--format", "json"],
    &["cycle", "421", "--inputs", "-", "--format", "json"],
    &["cycle", "427", "--inputs", "-"],
    &["cycle", "444", "--inputs", "-", "--format", "json"],
    &["cycle", "G785", "--inputs", "-", "--as-block"],
    &["cycle", "426", "--block", "-", "--path"],
    &["run", "-", "--max-blocks", "500"],
    &["run", "-", "--max-blocks", "500", "--trace", "--format", "json"],
];

pub fn run(bytes: &[u8]) {
    thread_local! {
        static READY: Vec<Cli> = CALLS.iter().map(|call| {
            Cli::try_parse_from(["fitcheck"].iter().chain(*call)).expect("a call")
        }).collect();
    }
    let Some((&first, mut input)) = bytes.split_first() else { return };
    let number = usize::from(first) % CALLS.len();
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let code = READY.with(|ready| ready[number].run(&mut Io::new(&mut input, &mut out, &mut err)));
    assert!([0, 1, 10, 11, 12, 14].contains(&code), "exit code {code}");
    let err = String::from_utf8(err).expect("a text");
    assert!(code == 1 || !err.lines().any(|line| line.starts_with("fitcheck: ")), "exit code {code}: {err}");
    is_tame(&err);
    match CALLS[number].iter().rfind(|word| ["csv", "json", "html"].contains(word)) {
        Some(&"json") => {
            let values = serde_json::Deserializer::from_slice(&out).into_iter::<serde_json::Value>();
            values.for_each(|value| drop(value.expect("JSON")));
        }
        Some(_) => assert!(std::str::from_utf8(&out).is_ok()),
        None => is_tame(std::str::from_utf8(&out).expect("a text")),
    }
}

fn is_tame(text: &str) {
    let wild = text.chars().find(|c| c.is_control() && !"\n\t\r".contains(*c) || ('\u{202a}'..='\u{202e}').contains(c));
    assert_eq!(wild, None, "{text:?}");
}
