//! Files named on the command line, and a start without a display.

use assert_cmd::cargo::cargo_bin_cmd;

/// The exit code and what is on standard error, without a display.
fn start(arguments: &[&str], folder: &std::path::Path) -> (Option<i32>, String) {
    let mut command = cargo_bin_cmd!("fitcheck");
    for variable in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
        command.env_remove(variable);
    }
    let output = command.args(arguments).current_dir(folder).output().unwrap();
    assert!(output.stdout.is_empty());
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn a_file_that_cannot_be_opened_is_wrong_usage_and_says_what_is_possible() {
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, text: &str| fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
    put("notes.pdf", "%PDF");
    put("part.csv", "id,callout,measured\n");
    std::fs::create_dir(folder.path().join("parts")).unwrap();
    for (arguments, told) in [
        (vec!["none.csv"], "no such file: none.csv; name an existing file"),
        // What follows two hyphens is a file, whatever it is called.
        (vec!["--", "none.csv"], "no such file: none.csv"),
        (vec!["--", "check"], "no such file: check"),
        (vec!["--", "notes.pdf"], "notes.pdf is not a file that the window opens"),
        (vec!["part.csv", "none.csv"], "no such file: none.csv"),
        (vec!["./none"], "no such file: ./none"),
        (vec!["./parts"], "this is a folder, not a file: ./parts"),
        (vec!["notes.pdf"], "notes.pdf is not a file that the window opens; it opens measurements"),
        (vec!["part.csv", "notes.pdf"], "notes.pdf is not a file that the window opens"),
    ] {
        let (code, text) = start(&arguments, folder.path());
        assert_eq!(code, Some(2), "{arguments:?}: {text}");
        assert!(text.starts_with(&format!("error: {told}")), "{arguments:?}: {text}");
        assert!(text.contains("--help"), "{text}");
    }
}

#[test]
fn a_mistyped_subcommand_gets_the_nearest_name() {
    let folder = tempfile::tempdir().unwrap();
    for (arguments, nearest) in [(vec!["chek", "25 H7"], "'check'"), (vec!["limts"], "'limits'")] {
        let (code, text) = start(&arguments, folder.path());
        assert_eq!(code, Some(2));
        assert!(text.contains("unrecognized subcommand") && text.contains(nearest), "{text}");
    }
    // What follows the point of a size is no ending.
    let (code, text) = start(&["12.5H7"], folder.path());
    assert!(code == Some(2) && text.contains("unrecognized subcommand '12.5H7'"), "{text}");
    // A subcommand of the name comes before a file of the name.
    fitcheck::files::write(&folder.path().join("limits"), b"25 H7").unwrap();
    let (code, text) = start(&["limits"], folder.path());
    assert!(code == Some(2) && text.contains("CALLOUT"), "{text}");
}

#[cfg(all(feature = "gui", target_os = "linux"))]
#[test]
fn without_a_display_the_first_cause_is_told_and_then_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    fitcheck::files::write(&folder.path().join("part.csv"), b"id,callout,measured\n").unwrap();
    for arguments in [&[][..], &["part.csv"]] {
        let (code, text) = start(arguments, folder.path());
        assert_eq!(code, Some(1), "{text}");
        let told = "fitcheck: no display: DISPLAY and WAYLAND_DISPLAY are not set. Log in on a desktop";
        assert!(text.starts_with(told), "{text}");
        assert!(text.contains("ssh -X") && text.contains("fitcheck check"), "{text}");
    }
}

#[cfg(not(feature = "gui"))]
#[test]
fn a_program_without_the_window_says_so() {
    let folder = tempfile::tempdir().unwrap();
    fitcheck::files::write(&folder.path().join("part.csv"), b"id,callout,measured\n").unwrap();
    for arguments in [&[][..], &["part.csv"]] {
        let (code, text) = start(arguments, folder.path());
        assert_eq!(code, Some(1));
        assert!(text.contains("built without the window"), "{text}");
    }
}
