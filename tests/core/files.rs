//! Files are written whole or not at all, and several of them together or none.

use std::path::Path;

use fitcheck::control::mask::FileUse;
use fitcheck::files::{
    FileError, LARGEST, list, list_up_to, make_folder, read, read_head, save, save_with, set_aside, write,
    write_folder, write_new, write_with,
};
use fitcheck::nc::machine::{NcPath, Store as _};
use fitcheck::store::programs::Folders;

#[test]
fn a_written_file_is_whole_and_leaves_nothing_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.html");
    write(&path, b"one").unwrap();
    write(&path, b"two").unwrap();
    assert_eq!(read(&path).unwrap(), b"two");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn folders_and_missing_files_are_named() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(read(folder.path()), Err(FileError::IsFolder { path: folder.path().to_owned() }));
    assert_eq!(write(folder.path(), b""), Err(FileError::IsFolder { path: folder.path().to_owned() }));
    let missing = folder.path().join("none.csv");
    assert_eq!(read(&missing), Err(FileError::Missing { path: missing }));
    let beneath = folder.path().join("none").join("x.csv");
    assert_eq!(write(&beneath, b""), Err(FileError::Missing { path: beneath }));
}

#[test]
fn a_file_beyond_the_bound_is_refused_unread() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("huge.csv");
    std::fs::File::create(&path).unwrap().set_len(LARGEST + 1).unwrap();
    assert_eq!(read(&path), Err(FileError::TooLarge { path }));
}

#[test]
fn a_broken_file_is_set_aside_not_lost() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.json");
    write(&path, b"{").unwrap();
    let aside = set_aside(&path).unwrap();
    assert_eq!(std::fs::read(aside).unwrap(), b"{");
    assert!(!path.exists());
}

const FILES: [(&str, &[u8]); 2] = [("a.h", b"one"), ("b.tab", b"two")];

fn names(folder: &Path) -> Vec<String> {
    let name = |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name().to_string_lossy().into_owned();
    let mut names: Vec<String> = std::fs::read_dir(folder).unwrap().map(name).collect();
    names.sort();
    names
}

#[test]
fn a_new_folder_comes_with_all_its_files() {
    let parent = tempfile::tempdir().unwrap();
    let folder = parent.path().join("set");
    let paths = write_folder(&folder, &FILES, false).unwrap();
    assert_eq!(paths, [folder.join("a.h"), folder.join("b.tab")]);
    assert_eq!(names(&folder), ["a.h", "b.tab"]);
    assert_eq!(names(parent.path()), ["set"]);
}

#[test]
fn nothing_is_written_where_one_file_is_there_already() {
    let folder = tempfile::tempdir().unwrap();
    let there = folder.path().join("b.tab");
    write(&there, b"mine").unwrap();
    let refused = write_folder(folder.path(), &FILES, false);
    assert_eq!(refused, Err(FileError::Exists { path: there.clone() }));
    assert_eq!(names(folder.path()), ["b.tab"]);
    assert_eq!(std::fs::read(&there).unwrap(), b"mine");
    write_folder(folder.path(), &FILES, true).unwrap();
    assert_eq!(names(folder.path()), ["a.h", "b.tab"]);
    assert_eq!(std::fs::read(&there).unwrap(), b"two");
}

#[test]
fn a_failure_takes_back_what_was_written() {
    let parent = tempfile::tempdir().unwrap();
    let twice = [FILES[0], FILES[0]];
    assert!(write_folder(&parent.path().join("set"), &twice, false).is_err());
    assert!(write_folder(parent.path(), &twice, false).is_err());
    assert!(names(parent.path()).is_empty());
    let missing = parent.path().join("none");
    let refused = Err(FileError::Missing { path: missing.clone() });
    assert_eq!(write_folder(&missing.join("set"), &FILES, false).map(drop), refused);
    assert_eq!(make_folder(&missing.join("set")), refused);
}

#[test]
fn a_new_file_never_takes_the_place_of_another() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("set.zip");
    write_new(&path, b"one").unwrap();
    assert_eq!(write_new(&path, b"two"), Err(FileError::Exists { path: path.clone() }));
    assert_eq!(std::fs::read(&path).unwrap(), b"one");
    assert_eq!(write_folder(&path, &FILES, true), Err(FileError::Exists { path }));
}

#[test]
fn a_file_is_only_replaced_by_leave() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.csv");
    save(&path, b"one", false).unwrap();
    assert_eq!(save(&path, b"two", false), Err(FileError::Exists { path: path.clone() }));
    assert_eq!(read(&path).unwrap(), b"one");
    save(&path, b"two", true).unwrap();
    assert_eq!(read(&path).unwrap(), b"two");
    assert_eq!(names(folder.path()), ["report.csv"]);
    for replace in [false, true] {
        let refused = save(folder.path(), b"three", replace);
        assert_eq!(refused, Err(FileError::IsFolder { path: folder.path().to_owned() }), "nobody asks for a folder");
    }
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_nowhere_is_not_replaced_unasked() {
    let folder = tempfile::tempdir().unwrap();
    let link = folder.path().join("report.csv");
    std::os::unix::fs::symlink(folder.path().join("none"), &link).unwrap();
    assert_eq!(save(&link, b"one", false), Err(FileError::Exists { path: link.clone() }));
    assert!(link.symlink_metadata().unwrap().is_symlink());
}

#[test]
fn a_folder_is_listed_with_folders_first_and_sizes() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["b.csv", "A.TAB", ".hidden"] {
        write(&folder.path().join(name), b"12345").unwrap();
    }
    make_folder(&folder.path().join("zones")).unwrap();
    let listing = list(folder.path()).unwrap();
    let told: Vec<_> = listing.entries.iter().map(|one| (one.name.as_str(), one.is_folder)).collect();
    assert_eq!(told, [("zones", true), (".hidden", false), ("A.TAB", false), ("b.csv", false)]);
    let [_, hidden, table, csv] = listing.entries.as_slice() else { panic!() };
    assert_eq!((hidden.is_hidden(), table.is_hidden(), csv.bytes), (true, false, 5));
    assert!(table.ends_with(&["tab"]) && !csv.ends_with(&["tab"]) && !hidden.ends_with(&["hidden"]));
    assert!(csv.changed.is_some());
    assert_eq!((listing.folder.as_path(), listing.has_more), (folder.path(), false));
    let above = list(&folder.path().join("zones").join("..")).unwrap();
    // Windows says the same path in two ways.
    assert_eq!(above.folder.canonicalize().unwrap(), folder.path().canonicalize().unwrap());
    let missing = folder.path().join("none");
    assert_eq!(list(&missing), Err(FileError::Missing { path: missing }));
    assert!(matches!(list(&folder.path().join("b.csv")), Err(FileError::System { .. })));
}

#[test]
fn a_huge_folder_is_read_up_to_a_bound() {
    let folder = tempfile::tempdir().unwrap();
    for number in 0..=20 {
        std::fs::File::create(folder.path().join(format!("{number}.csv"))).unwrap();
    }
    let listing = list_up_to(folder.path(), 20).unwrap();
    assert_eq!((listing.entries.len(), listing.has_more), (20, true));
    std::fs::remove_file(&listing.entries[0].path).unwrap();
    let listing = list_up_to(folder.path(), 20).unwrap();
    assert_eq!((listing.entries.len(), listing.has_more), (20, false));
}

#[test]
fn the_beginning_of_a_file_is_enough_to_know_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.csv");
    write(&path, b"id,callout").unwrap();
    assert_eq!((read_head(&path, 2).unwrap(), read_head(&path, 99).unwrap()), (b"id".to_vec(), b"id,callout".to_vec()));
}

#[test]
fn a_file_that_is_written_piece_by_piece_is_whole_or_not_there() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("report.csv");
    write_with(&path, &mut |out| (0..3).try_for_each(|number| write!(out, "{number}"))).unwrap();
    assert_eq!(read(&path).unwrap(), b"012");
    let failed = write_with(&path, &mut |out| {
        out.write_all(b"half")?;
        Err(std::io::Error::other("no more"))
    });
    assert!(matches!(failed, Err(FileError::System { reason, .. }) if reason == "no more"));
    assert_eq!(
        save_with(&path, false, &mut |out| out.write_all(b"new")),
        Err(FileError::Exists { path: path.clone() })
    );
    assert_eq!(read(&path).unwrap(), b"012");
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_folder_is_listed_once_however_often_a_run_looks_for_files_in_it() {
    let folder = tempfile::tempdir().unwrap();
    for number in 0..300 {
        std::fs::File::create(folder.path().join(format!("{number}.txt"))).unwrap();
    }
    let mut store = Folders::new().writing(folder.path());
    let missing = NcPath::new(&format!(r"TNC:\{}none.a", r"a\".repeat(120))).unwrap();
    for _ in 0..20 {
        assert!(store.read(&missing).is_err());
    }
    assert_eq!(store.listed(), 1);
    // What the run itself writes is found by its exact name and in any other case, and nothing is listed again.
    let own = NcPath::new(r"TNC:\Own.txt").unwrap();
    for number in 0..20 {
        store.write(&own, b"x", FileUse::Append).unwrap();
        assert_eq!(store.read(&own).unwrap().len(), number + 1);
        assert_eq!(store.read(&NcPath::new(r"TNC:\OWN.TXT").unwrap()).unwrap().len(), number + 1);
        assert!(store.read(&missing).is_err());
    }
    assert_eq!(store.listed(), 1);
}
