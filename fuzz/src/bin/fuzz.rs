//! libFuzzer with the target that the variable `FUZZ_TARGET` names. Without one it prints the names of all targets; with
//! `FUZZ_WORDS` the words of the target's language as a dictionary.

#![no_main]

use std::sync::OnceLock;

use fitcheck_fuzz::targets::{TARGETS, Target};
use libfuzzer_sys::fuzz_target;

static TARGET: OnceLock<&Target> = OnceLock::new();

fuzz_target!(
    init: {
        let name = std::env::var("FUZZ_TARGET").unwrap_or_default();
        match TARGETS.iter().find(|target| target.name == name) {
            Some(target) if std::env::var_os("FUZZ_WORDS").is_none() => drop(TARGET.set(target)),
            target => {
                let names = || TARGETS.iter().map(|target| format!("{}\n", target.name)).collect();
                print!("{}", target.map_or_else(names, |target| target.words.to_owned()));
                std::process::exit(i32::from(target.is_none() && !name.is_empty()));
            }
        }
    },
    |bytes: &[u8]| if let Some(target) = TARGET.get() { (target.run)(bytes) }
);
