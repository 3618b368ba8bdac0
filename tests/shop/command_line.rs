//! `fitcheck journal` and `--record` with a server: what a station has recorded arrives, is listed and verified, and what cannot be sent
//! stays recorded here.

use std::path::Path;
use std::process::Output;

use assert_cmd::cargo::cargo_bin_cmd;

use crate::harness::Shop;

/// Exit code, standard output and standard error of a call with a home of its own.
fn run(home: &Path, args: &[&str]) -> (i32, String, String) {
    let mut command = cargo_bin_cmd!("fitcheck");
    for name in ["XDG_DATA_HOME", "XDG_CONFIG_HOME", "APPDATA", "LOCALAPPDATA", "FITCHECK_JOURNAL", "PGPASSWORD"] {
        command.env_remove(name);
    }
    command.env("HOME", home).env("USERPROFILE", home).env("TZ", "UTC").current_dir(home);
    let Output { status, stdout, stderr } = command.args(args).output().unwrap();
    (status.code().unwrap(), String::from_utf8(stdout).unwrap(), String::from_utf8(stderr).unwrap())
}

const CHECK: [&str; 5] = ["check", "25 H7", "--measured", "25.012", "--record"];

#[test]
fn what_a_station_has_recorded_is_sent_listed_and_verified() {
    let Some(shop) = Shop::empty("FITCHECK_TEST_PG") else { return };
    let home = tempfile::tempdir().unwrap();
    let done = |args: &[&str]| {
        let (code, out, err) = run(home.path(), args);
        assert_eq!(code, 0, "{args:?}: {out}{err}");
        (out, err)
    };
    let address = shop.address.as_str();
    let (_, err) = done(&["journal", "init-shop", address]);
    assert!(err.contains("the journal was created in the database"), "{err}");
    assert!(done(&["journal", "init-shop", address]).1.contains("existed already"));
    done(&[&CHECK[..], &["--part", "Flange"]].concat());
    let (_, err) = done(&["journal", "send", address, "--station", "Mill 3"]);
    assert!(err.contains("2 entries were sent to postgres://") && err.contains("up to entry 2"), "{err}");
    assert!(done(&["journal", "send", address]).1.contains("nothing had to be sent to postgres://"));
    // Recorded here first, and sent at once.
    let (out, err) = done(&[&CHECK[..], &["--part", "Shaft", "--journal", address]].concat());
    assert!(out.starts_with("FIT STATUS: GOOD"), "{out}");
    assert!(err.contains("recorded as entry 3 of ") && err.contains("1 entry was sent to postgres://"), "{err}");
    let (here, _) = done(&["journal", "list", "--format", "csv"]);
    let (there, _) = done(&["journal", "list", "--format", "csv", "--journal", address]);
    assert_eq!((here.lines().count(), &here), (3, &there));
    let (found, _) = done(&["journal", "list", "part:Shaft", "--format", "csv", "--journal", address]);
    assert_eq!(found.lines().count(), 2, "{found}");
    let (exported, _) = done(&["journal", "export", "--journal", address]);
    assert_eq!(exported, here);
    let (lines, _) = done(&["journal", "export", "part:Flange", "--format", "json", "--journal", address]);
    assert_eq!(lines, done(&["journal", "export", "part:Flange", "--format", "json"]).0);
    let (local, _) = done(&["journal", "verify"]);
    let head = local.trim().rsplit(' ').next().unwrap();
    let chain = done(&["journal", "show", "1"]).0;
    let chain = chain.lines().find_map(|line| line.strip_prefix("chain        ")).unwrap().to_owned();
    let known = format!("{chain}:{head}");
    let (out, _) = done(&["journal", "verify", "--journal", address, "--head", &known]);
    assert!(out.contains(&format!("({chain}): 3 entries are as they were written; the last one is {head}")), "{out}");
    assert!(out.contains("its newest entry was received ") && out.contains(" s after the time on its clock"), "{out}");
    let (json, _) = done(&["journal", "verify", "--journal", address, "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    let (newest, login) = (json["chains"][0]["clock"]["newest_ms"].as_i64(), json["chains"][0]["login"].as_str());
    assert!(newest.is_some_and(|ms| (0..60_000).contains(&ms)) && login == Some("fitadmin"), "{json}");
    let ahead = known.replace(&format!(":{}:", 3), ":4:");
    let (code, out, _) = run(home.path(), &["journal", "verify", "--journal", address, "--head", &ahead]);
    assert_eq!(code, 1);
    assert!(out.contains("entry 4 is known elsewhere"), "{out}");
    let (code, _, err) = run(home.path(), &["journal", "verify", "--journal", address, "--head", head]);
    assert_eq!((code, err.contains("--head CHAIN:NUMBER:HASH")), (1, true), "{err}");
}

#[test]
fn verify_says_what_it_verified_and_misses_what_this_station_has_sent() {
    let Some(shop) = Shop::empty("FITCHECK_TEST_PG") else { return };
    let home = tempfile::tempdir().unwrap();
    let address = shop.address.as_str();
    let call = |args: &[&str]| run(home.path(), args);
    let verify = || call(&["journal", "verify", "--journal", address]);
    assert_eq!(call(&["journal", "init-shop", address]).0, 0);
    let (code, out, _) = verify();
    assert_eq!(
        (code, out.contains("nothing was verified: the server has no entry of any journal")),
        (1, true),
        "{out}"
    );
    assert_eq!(call(&[&CHECK[..], &["--station", "Mill 3"]].concat()).0, 0);
    let (code, out, _) = verify();
    assert_eq!((code, out.contains("ends with entry 2, but the server has 0 entries of it")), (1, true), "{out}");
    assert_eq!(call(&["journal", "send", address]).0, 0);
    let (code, out, err) = verify();
    assert_eq!(code, 0, "{out}{err}");
    assert!(out.contains("2 entries are as they were written"), "{out}");
    assert!(out.contains("entry 2 is the one that is known here"), "{out}");
    assert!(out.contains("1 journal with 2 entries verified, 1 compared with an entry that is known here"), "{out}");
    assert!(
        out.contains("functions, triggers, policies, grants, views and indexes are as init-shop makes them"),
        "{out}"
    );
    let (code, json, _) = call(&["journal", "verify", "--journal", address, "--format", "json"]);
    let json: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!((code, &json["complete"], &json["chains"][0]["known_here"]), (0, &true.into(), &2.into()), "{json}");
    // Somebody with all rights removes the newest entry, and then the whole journal.
    let remove = |which: &str| {
        shop.run(&format!(
            "ALTER TABLE fitcheck.entry DISABLE TRIGGER entry_keeps; DELETE FROM fitcheck.entry WHERE {which}; \
             ALTER TABLE fitcheck.entry ENABLE ALWAYS TRIGGER entry_keeps"
        ));
    };
    remove("number = 2");
    // Not even what the station knows of its own file is there any more.
    std::fs::remove_file(home.path().join(".config/fitcheck/journal-heads.txt")).unwrap();
    let (code, out, _) = verify();
    assert_eq!((code, out.contains("entry 2 is known elsewhere")), (1, true), "{out}");
    remove("true");
    let (code, out, _) = verify();
    assert_eq!(
        (code, out.contains("of which entry 2 is known elsewhere, is missing on the server")),
        (1, true),
        "{out}"
    );
    assert!(out.contains("nothing was verified"), "{out}");
}

#[test]
fn what_cannot_be_sent_is_recorded_here_and_no_password_is_told() {
    let home = tempfile::tempdir().unwrap();
    let address = "postgres://mill3:s3cret@127.0.0.1:1/checks";
    let (code, out, err) = run(home.path(), &[&CHECK[..], &["--journal", address]].concat());
    assert_eq!(code, 0, "{err}");
    assert!(out.starts_with("FIT STATUS: GOOD"), "{out}");
    assert!(err.contains("recorded as entry 2 of ") && err.contains("warning: not yet sent to the server: "), "{err}");
    let (code, out, more) = run(home.path(), &["journal", "send", address]);
    assert_eq!((code, out.as_str()), (1, ""));
    assert!(!format!("{err}{more}").contains("s3cret"), "{err}{more}");
    for refused in [["journal", "show", "2"], ["journal", "backup", "x.sqlite"]] {
        let (code, _, err) = run(home.path(), &[&refused[..], &["--journal", address]].concat());
        assert_eq!(code, 1);
        assert!(err.contains("needs the journal file of a station") && !err.contains("s3cret"), "{err}");
    }
}
