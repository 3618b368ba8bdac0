//! What comes from others keeps to `deny.toml`: licences, doubled and banned crates, sources. Nothing here asks the
//! network.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

/// Cargo's own registry: where our dependencies come from that name none.
fn registry() -> String {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["metadata", "--no-deps", "--offline", "--locked", "--format-version", "1"]);
    let output = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let packages = metadata["packages"].as_array().unwrap();
    let dependencies = packages.iter().flat_map(|one| one["dependencies"].as_array().unwrap());
    let sources: BTreeSet<&str> =
        dependencies.filter(|one| one["registry"].is_null()).filter_map(|one| one["source"].as_str()).collect();
    assert_eq!(sources.len(), 1, "{sources:?}");
    sources.into_iter().next().unwrap().to_owned()
}

fn toml(file: &str) -> toml::Table {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
    text.parse().unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// The tables in a list, each as texts by key; a value that is a list of texts has them in one line.
fn tables(value: &toml::Value) -> impl Iterator<Item = BTreeMap<&str, String>> {
    let text = |value: &toml::Value| match value {
        toml::Value::Array(all) => all.iter().map(|one| one.as_str().unwrap()).collect::<Vec<_>>().join(" "),
        one => one.as_str().unwrap_or_default().to_owned(),
    };
    let entries = value.as_array().unwrap().iter().map(|entry| entry.as_table().unwrap());
    entries.map(move |entry| entry.iter().map(|(key, value)| (key.as_str(), text(value))).collect())
}

/// A version as numbers, for comparing.
fn numbers(version: &str) -> Vec<u64> {
    let plain = version.split(['+', '-']).next().unwrap();
    plain.split('.').map(|number| number.parse().unwrap()).collect()
}

#[test]
fn every_crate_comes_from_the_registry_with_a_checksum() {
    let is_ours = |name: &str| name == "fitcheck" || name.starts_with("fitcheck-");
    let registry = registry();
    for (file, at_least) in [("Cargo.lock", 400), ("fuzz/Cargo.lock", 80)] {
        let lock = toml(file);
        let crates: Vec<_> = tables(&lock["package"]).collect();
        assert!(at_least < crates.len(), "{file} has only {} crates", crates.len());
        for one in &crates {
            let name = one["name"].as_str();
            let source = one.get("source").map_or("", String::as_str);
            let expected = if is_ours(name) { "" } else { &registry };
            assert_eq!(source, expected, "{file}: {name}");
            let is_checked = one.get("checksum").is_some_and(|sum| sum.len() == 64);
            assert_eq!(is_checked, !is_ours(name), "{file}: {name} and its checksum");
        }
    }
    let deny = toml("deny.toml");
    let sources = deny["sources"].as_table().unwrap();
    assert!(!sources.contains_key("allow-registry"), "without a list, Cargo's own registry is the only one");
    assert_eq!(sources["unknown-registry"].as_str(), Some("deny"));
    assert_eq!(sources["allow-git"].as_array().unwrap().len(), 0);
}

#[test]
fn a_crate_is_doubled_only_where_deny_toml_says_why() {
    let lock = toml("Cargo.lock");
    let mut versions: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for one in tables(&lock["package"]) {
        versions.entry(one["name"].clone()).or_default().push(one["version"].clone());
    }
    let mut doubled = BTreeSet::new();
    for (name, mut versions) in versions {
        versions.sort_by_key(|version| numbers(version));
        let _newest = versions.pop();
        doubled.extend(versions.into_iter().map(|version| format!("{name}@{version}")));
    }
    let deny = toml("deny.toml");
    let skipped: Vec<_> = tables(&deny["bans"]["skip"]).collect();
    for one in &skipped {
        assert!(one.get("reason").is_some_and(|reason| !reason.is_empty()), "{} has no reason", one["crate"]);
    }
    let skipped: BTreeSet<String> = skipped.iter().map(|one| one["crate"].clone()).collect();
    assert_eq!(doubled, skipped, "the older versions in Cargo.lock and those of deny.toml");
}

/// A banned crate may be there only for the crates that its line names.
#[test]
fn no_banned_crate_is_there() {
    let (lock, deny) = (toml("Cargo.lock"), toml("deny.toml"));
    let crates: Vec<_> = tables(&lock["package"]).collect();
    let banned: Vec<_> = tables(&deny["bans"]["deny"]).collect();
    assert!(10 < banned.len(), "deny.toml bans only {}", banned.len());
    let (mut wrong, mut wrappers) = (Vec::new(), 0);
    for one in &banned {
        let name = one["crate"].as_str();
        let may: BTreeSet<&str> = one.get("wrappers").map_or("", String::as_str).split_whitespace().collect();
        let asks = |other: &&BTreeMap<&str, String>| {
            other.get("dependencies").is_some_and(|all| all.split_whitespace().any(|word| word == name))
        };
        let asking: BTreeSet<&str> = crates.iter().filter(asks).map(|other| other["name"].as_str()).collect();
        wrong.extend(asking.difference(&may).map(|other| format!("{name} for {other}")));
        let is_there = crates.iter().any(|other| other["name"] == name);
        assert_eq!(is_there, !may.is_empty(), "{name} is in Cargo.lock only if deny.toml names what it is for");
        assert_eq!(may.difference(&asking).collect::<Vec<_>>(), Vec::<&&str>::new(), "do not ask for {name}");
        wrappers += may.len();
    }
    assert_eq!(wrong, Vec::<String>::new());
    assert_eq!(wrappers, 3, "TLS for the server of a shop is the only exception");
}

/// What TLS is for is a feature of its own: without it nothing in the program can reach another machine.
#[test]
fn no_crate_for_networks_is_built_without_the_shops_server() {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["tree", "--offline", "--locked", "--no-default-features", "--edges", "normal", "--prefix", "none"]);
    let output = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let crates: BTreeSet<&str> = text.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(60 < crates.len(), "only {}", crates.len());
    for one in ["keyring", "mio", "ring", "rustls", "socket2", "tokio", "tokio-postgres"] {
        assert!(!crates.contains(one), "{one}");
    }
}

/// Name and licence of every crate on this machine, and whether these are all of Cargo.lock. A machine that has built
/// only a part has only its crates; `.ci/run` fetches them all.
fn licences() -> (Vec<(String, String)>, bool) {
    let attempts: [&[&str]; 4] = [
        &["--all-features"],
        &["--all-features", "--filter-platform", "host-tuple"],
        &["--filter-platform", "host-tuple"],
        &["--no-default-features", "--filter-platform", "host-tuple"],
    ];
    for (number, attempt) in attempts.iter().enumerate() {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["metadata", "--offline", "--locked", "--format-version", "1"]).args(*attempt);
        let output = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
        if !output.status.success() {
            assert!(number + 1 < attempts.len(), "{}", String::from_utf8_lossy(&output.stderr));
            continue;
        }
        let metadata: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        let text = |one: &serde_json::Value, key: &str| one[key].as_str().unwrap_or_default().to_owned();
        let crates = metadata["packages"].as_array().unwrap();
        return (crates.iter().map(|one| (text(one, "name"), text(one, "license"))).collect(), number == 0);
    }
    unreachable!("the last attempt returns or fails")
}

/// The licences under which a crate may be used, as sets that go together: `MIT OR (A AND B)` is `[{MIT}, {A, B}]`.
/// A slash is an older `OR`.
fn choices(expression: &str) -> Vec<BTreeSet<String>> {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ").replace(" WITH ", "_WITH_");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut at = 0;
    let found = any_of(&words, &mut at);
    assert_eq!(at, words.len(), "{expression}");
    found
}

fn any_of(words: &[&str], at: &mut usize) -> Vec<BTreeSet<String>> {
    let mut found = all_of(words, at);
    while words.get(*at) == Some(&"OR") {
        *at += 1;
        found.extend(all_of(words, at));
    }
    found
}

fn all_of(words: &[&str], at: &mut usize) -> Vec<BTreeSet<String>> {
    let mut found = one_of(words, at);
    while words.get(*at) == Some(&"AND") {
        *at += 1;
        let others = one_of(words, at);
        found = found.iter().flat_map(|one| others.iter().map(move |other| one | other)).collect();
    }
    found
}

fn one_of(words: &[&str], at: &mut usize) -> Vec<BTreeSet<String>> {
    let word = words[*at];
    *at += 1;
    if word != "(" {
        return vec![BTreeSet::from([word.replace("_WITH_", " WITH ")])];
    }
    let found = any_of(words, at);
    assert_eq!(words[*at], ")");
    *at += 1;
    found
}

#[test]
fn a_licence_is_read_as_a_choice_of_sets() {
    let set = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<BTreeSet<_>>();
    assert_eq!(choices("MIT"), [set(&["MIT"])]);
    assert_eq!(choices("MIT/Apache-2.0"), [set(&["MIT"]), set(&["Apache-2.0"])]);
    assert_eq!(choices("(MIT OR ISC) AND Zlib"), [set(&["MIT", "Zlib"]), set(&["ISC", "Zlib"])]);
    assert_eq!(choices("A WITH B OR C AND D"), [set(&["A WITH B"]), set(&["C", "D"])]);
}

#[test]
fn every_licence_is_allowed_and_no_allowed_one_is_needless() {
    let deny = toml("deny.toml");
    let allowed = deny["licenses"]["allow"].as_array().unwrap();
    let allowed: BTreeSet<String> = allowed.iter().map(|one| one.as_str().unwrap().to_owned()).collect();
    let exceptions: BTreeMap<String, String> =
        tables(&deny["licenses"]["exceptions"]).map(|one| (one["crate"].clone(), one["allow"].clone())).collect();
    let (crates, is_everything) = licences();
    assert!(60 < crates.len(), "only {} crates", crates.len());
    assert!(is_everything || std::env::var("CI").is_err(), "CI must have every crate: cargo fetch --locked");
    let (mut wrong, mut used, mut excepted) = (Vec::new(), BTreeSet::new(), BTreeSet::new());
    for (name, licence) in &crates {
        let exception = exceptions.get(name);
        let may = |one: &String| allowed.contains(one) || exception == Some(one);
        match choices(licence).into_iter().find(|all| all.iter().all(may)) {
            None => wrong.push(format!("{name}: {licence}")),
            Some(all) => {
                excepted.extend(all.iter().filter(|one| !allowed.contains(*one)).map(|_| name.clone()));
                used.extend(all);
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new(), "licences that deny.toml does not allow");
    if is_everything {
        assert_eq!(allowed.difference(&used).collect::<Vec<_>>(), Vec::<&String>::new(), "allowed and needed by none");
        assert_eq!(excepted, exceptions.into_keys().collect(), "exceptions that a crate needs, and those listed");
    }
}

/// `packaging/sbom --licences` writes the page, which the window shows under About.
#[test]
fn the_manual_names_every_crate_of_cargo_lock_with_its_licence() {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/manual/licences.md")).unwrap();
    let mut listed: BTreeMap<String, String> = BTreeMap::new();
    for section in text.split("\n## ").skip(2) {
        let (licence, crates) = section.split_once('\n').unwrap();
        let crates = crates.split_whitespace().collect::<Vec<_>>().join(" ");
        listed.extend(crates.split(", ").map(|one| (one.to_owned(), licence.to_owned())));
    }
    let lock = toml("Cargo.lock");
    let of_others = tables(&lock["package"]).filter(|one| one.contains_key("source"));
    let locked: BTreeSet<String> = of_others.map(|one| format!("{} {}", one["name"], one["version"])).collect();
    assert_eq!(listed.keys().cloned().collect::<BTreeSet<_>>(), locked, "run packaging/sbom --licences");
    for (name, licence) in licences().0 {
        // Of two versions, each may have a licence of its own.
        let mut under = listed.iter().filter(|(one, _)| one.split(' ').next() == Some(name.as_str()));
        let is_ours = name == "fitcheck" || name.starts_with("fitcheck-");
        assert!(is_ours || under.any(|(_, told)| choices(told) == choices(&licence)), "{name}: {licence}");
    }
}

#[test]
fn the_largest_dependencies_are_those_of_cargo_lock() {
    let lock = toml("Cargo.lock");
    let crates: Vec<_> = tables(&lock["package"]).map(|one| (one["name"].clone(), one["version"].clone())).collect();
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/DEPENDENCIES.md")).unwrap();
    let rows: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("| `")).collect();
    assert_eq!(rows.len(), 10, "docs/DEPENDENCIES.md names the ten largest");
    for row in rows {
        let (name, rest) = row.split_once("` ").unwrap();
        let wanted = rest.split_once(" |").unwrap().0;
        let is_there = |(known, version): &(String, String)| {
            known == name && version.strip_prefix(wanted).is_some_and(|rest| rest.starts_with('.'))
        };
        assert!(crates.iter().any(is_there), "docs/DEPENDENCIES.md says {name} {wanted}");
    }
}
