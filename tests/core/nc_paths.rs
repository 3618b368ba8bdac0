//! Paths as programs write them: none leads out of the given folders.

use fitcheck::nc::machine::NcPath;

#[track_caller]
fn check(path: &str, expected: &str) {
    let from = NcPath::new(r"TNC:\fit\check\main.h").unwrap();
    let said = from.resolve(path).map_or_else(|error| error.to_string(), |path| path.to_string());
    assert_eq!(said, expected, "{path}");
}

#[test]
fn a_path_counts_from_the_program_or_from_the_root() {
    check("a.h", r"TNC:\fit\check\a.h");
    check(r".\sub\a.h", r"TNC:\fit\check\sub\a.h");
    check(r"..\a.h", r"TNC:\fit\a.h");
    check(r"TNC:\a.h", r"TNC:\a.h");
    check(r"tnc:a.h", r"TNC:\a.h");
    check("TNC:/x/./y/../a.h", r"TNC:\x\a.h");
    check("%FN16RUN.A", r"TNC:\fit\check\%FN16RUN.A");
    check("COM10.h", r"TNC:\fit\check\COM10.h");
}

#[test]
fn a_program_has_a_path_whatever_it_is_called() {
    for (path, expected) in [
        (r"TNC:\fit\a.h", r"TNC:\fit\a.h"),
        ("a.h", r"TNC:\a.h"),
        (r"C:\parts\a.h", r"TNC:\a.h"),
        ("/home/user/a.h", r"TNC:\a.h"),
        ("NUL", r"TNC:\program.h"),
    ] {
        assert_eq!(NcPath::of_file(path).to_string(), expected);
    }
}

#[test]
fn nothing_leads_out() {
    check(r"..\..\..\a.h", r"..\..\..\a.h leads out of the folder");
    check(r"TNC:\..\a.h", r"TNC:\..\a.h leads out of the folder");
    check(r"C:\a.h", r"C:\a.h is neither a path on TNC: nor a path from the program's folder");
    check(r"\\server\share\a.h", r"\\server\share\a.h is neither a path on TNC: nor a path from the program's folder");
    check("/etc/passwd", "/etc/passwd is neither a path on TNC: nor a path from the program's folder");
    check("a.h:stream", "a.h:stream is neither a path on TNC: nor a path from the program's folder");
    check(r"TNC:\a.h:stream", r"a.h:stream in TNC:\a.h:stream is not a name for a file or folder");
    check(r"sub\NUL.txt", r"NUL.txt in sub\NUL.txt is not a name for a file or folder");
    check("com1", "com1 in com1 is not a name for a file or folder");
    check("a.h.", "a.h. in a.h. is not a name for a file or folder");
    check("a\u{7}b", "a\\u{7}b in a b is not a name for a file or folder");
    check("  ", "the path is empty");
    check(r"TNC:\", "the path is empty");
    check(r"sub\", "the path is empty");
    let too_long = "the path has more than 255 characters, which a control does not allow";
    let below = r"TNC:\fit\check\".len();
    check(&"x".repeat(255 - below), &format!(r"TNC:\fit\check\{}", "x".repeat(255 - below)));
    check(&"x".repeat(256 - below), too_long);
    check(&r"a\..\".repeat(60), too_long);
}

/// With its drive: 250 characters and `TNC:\`.
#[test]
fn a_path_that_is_followed_is_read_again_as_it_is_written() {
    let longest = NcPath::new(&"x".repeat(250)).unwrap();
    assert_eq!(NcPath::new(&longest.to_string()), Ok(longest));
    assert!(NcPath::new(&"x".repeat(251)).is_err());
}
