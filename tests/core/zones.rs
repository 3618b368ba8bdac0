//! The time zone of a station: by name on every system, recorded, and never taken for UTC in silence.

use std::path::Path;
use std::process::Output;

use assert_cmd::cargo::cargo_bin_cmd;

use crate::at_home::AtHome as _;

fn run(home: &Path, args: &[&str], variables: &[(&str, &str)]) -> (i32, String, String) {
    let mut command = cargo_bin_cmd!("fitcheck");
    for name in ["FITCHECK_JOURNAL", "TZ", "TZDIR"] {
        command.env_remove(name);
    }
    command.at_home(home).current_dir(home).envs(variables.iter().copied());
    let Output { status, stdout, stderr } = command.args(args).output().unwrap();
    (status.code().unwrap(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
}

/// Offset and name of the zone of an entry that is recorded now.
fn recorded(variables: &[(&str, &str)]) -> (i64, String) {
    let home = tempfile::tempdir().unwrap();
    let check = ["check", "25 H7", "--measured", "25.012", "--record", "--journal", "j.sqlite"];
    let (code, out, err) = run(home.path(), &check, variables);
    assert_eq!(code, 0, "{variables:?}: {out}{err}");
    assert!(!err.contains("warning"), "{err}");
    let show = ["journal", "show", "2", "--format", "json", "--journal", "j.sqlite"];
    let (_, out, _) = run(home.path(), &show, variables);
    let entry: serde_json::Value = serde_json::from_str(&out).unwrap();
    let time = &entry["body"]["about"]["time"];
    (time["offset_min"].as_i64().unwrap(), time["zone"].as_str().unwrap().to_owned())
}

/// Kathmandu, Kolkata and Phoenix have no summer time.
const ZONES: [(&str, i64); 4] = [("Asia/Kathmandu", 345), ("Asia/Kolkata", 330), ("America/Phoenix", -420), ("UTC", 0)];

#[test]
fn a_zone_by_name_is_right_and_recorded_with_a_database_and_without_one() {
    let empty = tempfile::tempdir().unwrap();
    for (zone, minutes) in ZONES {
        let folder = empty.path().to_str().unwrap();
        for variables in [&[("TZ", zone)][..], &[("TZ", zone), ("TZDIR", folder)]] {
            assert_eq!(recorded(variables), (minutes, zone.to_owned()), "{variables:?}");
        }
    }
    for given in [":Asia/Kathmandu", "/usr/share/zoneinfo/Asia/Kathmandu", "asia/kathmandu"] {
        assert_eq!(recorded(&[("TZ", given)]), (345, "Asia/Kathmandu".to_owned()), "{given}");
    }
}

#[test]
fn a_zone_that_the_systems_database_lacks_is_found_in_the_other_one() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("Etc")).unwrap();
    // A database with one zone: eight hours without a name.
    let system = Path::new("/usr/share/zoneinfo/Etc/UTC");
    if !system.exists() {
        return;
    }
    std::fs::copy(system, folder.path().join("Etc/UTC")).unwrap();
    let variables = [("TZ", "Asia/Kathmandu"), ("TZDIR", folder.path().to_str().unwrap())];
    assert_eq!(recorded(&variables), (345, "Asia/Kathmandu".to_owned()));
}

#[test]
fn a_rule_in_place_of_a_name_is_recorded_as_it_is() {
    assert_eq!(recorded(&[("TZ", "NPT-5:45")]), (345, "NPT-5:45".to_owned()));
}

#[test]
fn a_zone_that_is_not_understood_is_refused_and_never_taken_for_utc() {
    let home = tempfile::tempdir().unwrap();
    for given in ["Europe/Amsterdm", "Mars/Olympus", "/nowhere", "AMS"] {
        for args in [
            &["check", "25 H7", "--measured", "25.012", "--record", "--journal", "j.sqlite"][..],
            &["journal", "list", "today"],
        ] {
            let (code, out, err) = run(home.path(), args, &[("TZ", given)]);
            assert_eq!((code, out.as_str()), (2, ""), "{given}: {err}");
            assert!(err.contains(&format!("TZ is set to \"{given}\", which is not a time zone")), "{err}");
        }
        assert!(!home.path().join("j.sqlite").exists());
    }
}
