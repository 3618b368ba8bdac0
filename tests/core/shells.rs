//! `fitcheck completions` and `fitcheck man`, through the built program.
#![expect(clippy::disallowed_methods, reason = "a test writes small files that nobody else reads")]

use std::collections::BTreeSet;
use std::process::Command;

use assert_cmd::cargo::cargo_bin_cmd;
use clap::CommandFactory as _;

fn fitcheck(args: &[&str]) -> Vec<u8> {
    cargo_bin_cmd!("fitcheck").args(args).assert().success().get_output().stdout.clone()
}

#[test]
fn bash_completes_subcommands_options_and_values() {
    let folder = tempfile::tempdir().unwrap();
    let script = folder.path().join("fitcheck.bash");
    std::fs::write(&script, fitcheck(&["completions", "bash"])).unwrap();
    let completed = |words: &[&str]| {
        let ask = format!(
            "source {}; COMP_WORDS=({}); COMP_CWORD={}; _fitcheck fitcheck '{}' '{}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            script.display(),
            words.join(" "),
            words.len() - 1,
            words[words.len() - 1],
            words[words.len() - 2],
        );
        let answer = Command::new("bash").args(["--norc", "-c", &ask]).output().unwrap();
        assert!(answer.status.success(), "{}", String::from_utf8_lossy(&answer.stderr));
        String::from_utf8(answer.stdout).unwrap().lines().map(str::to_owned).collect::<BTreeSet<_>>()
    };
    assert!(completed(&["fitcheck", "ch"]).contains("check"));
    assert!(completed(&["fitcheck", "check", "--mea"]).contains("--measured"));
    assert!(completed(&["fitcheck", "journal", "l"]).contains("list"));
    assert!(completed(&["fitcheck", "check", "--format", "j"]).contains("json"));
}

#[test]
fn every_shell_has_a_script_that_names_every_subcommand() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = String::from_utf8(fitcheck(&["completions", shell])).unwrap();
        for subcommand in fitcheck::cli::Cli::command().get_subcommands() {
            assert!(script.contains(subcommand.get_name()), "{shell}: {}", subcommand.get_name());
        }
    }
}

#[test]
fn every_subcommand_has_a_manual_page() {
    fn names(command: &clap::Command, before: &str, all: &mut BTreeSet<String>) {
        let name = format!("{before}{}", command.get_name());
        for subcommand in command.get_subcommands() {
            names(subcommand, &format!("{name}-"), all);
        }
        all.insert(format!("{name}.1"));
    }
    let folder = tempfile::tempdir().unwrap();
    fitcheck(&["man", "-o", folder.path().to_str().unwrap()]);
    let written: BTreeSet<String> =
        std::fs::read_dir(folder.path()).unwrap().map(|one| one.unwrap().file_name().into_string().unwrap()).collect();
    let mut wanted = BTreeSet::new();
    names(&fitcheck::cli::Cli::command(), "", &mut wanted);
    assert_eq!(written, wanted);
    let page = std::fs::read(folder.path().join("fitcheck-journal-list.1")).unwrap();
    assert_eq!(fitcheck(&["man", "journal", "list"]), page);
    assert!(String::from_utf8(page).unwrap().contains(".TH fitcheck-journal-list 1"));
}
