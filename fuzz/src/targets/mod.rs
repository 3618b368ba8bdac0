//! What is fuzzed: one target per reader, and one per question that can be answered in two ways.
//!
//! libFuzzer (`fuzz/campaign`) and the short run of the tests (`tests/core/fuzzing.rs`) both use [`TARGETS`]. A target
//! panics where an input breaks what it holds, and returns otherwise.
//!
//! To add a target:
//!
//! 1. Write a file here, with its `mod` line and its line in the table `targets!`. The line names the words of its language, a
//!    file of `fuzz/words`, or `none`.
//! 2. Add a folder of seeds to `fuzz/corpus` and a row to `fuzz/README.md`. Tests name what is missing.

mod aqdef;
mod batch;
mod block;
mod budget;
mod callout;
mod calypso;
mod circle;
mod command;
mod contacts;
mod decimal;
mod deviations;
mod exact;
mod fn16;
mod format;
mod gauge_lines;
mod geopak;
mod iso;
mod journal_body;
mod lathe;
mod length;
mod limits;
mod log;
mod machine;
mod mask;
mod materials;
mod measurements;
mod own_texts;
mod path;
mod pcdmis;
mod plan;
mod point_log;
mod probe_table;
mod probed;
mod program;
mod protocol;
mod qif;
mod question;
mod report_data;
mod report_template;
mod series_table;
mod shared;
mod state;
mod table;
mod tool_table;
mod twin;
mod workpiece;
mod xlsx;

/// A target.
#[derive(Debug, Clone, Copy)]
pub struct Target {
    /// Its name: that of its module and of its folder of seeds.
    pub name: &'static str,
    /// Runs one input.
    pub run: fn(&[u8]),
    /// Words of its language, as a dictionary of libFuzzer.
    pub words: &'static str,
}

macro_rules! targets {
    ($($name:ident $words:literal)+) => {
        /// Every target.
        pub const TARGETS: &[Target] = &[$(Target {
            name: stringify!($name),
            run: $name::run,
            words: include_str!(concat!("../../words/", $words, ".dict")),
        }),+];
    };
}

targets! {
    aqdef "aqdef"
    batch "csv"
    block "klartext"
    budget "toml"
    callout "sizes"
    calypso "calypso"
    circle "none"
    command "csv"
    contacts "csv"
    deviations "table"
    fn16 "mask"
    format "none"
    gauge_lines "none"
    geopak "csv"
    iso "iso"
    journal_body "journal"
    lathe "din_plus"
    length "sizes"
    limits "sizes"
    log "log"
    machine "klartext"
    mask "mask"
    materials "toml"
    measurements "csv"
    own_texts "none"
    path "sizes"
    pcdmis "pcdmis"
    plan "csv"
    point_log "page"
    probe_table "table"
    probed "probed"
    program "klartext"
    protocol "none"
    qif "qif"
    question "question"
    report_data "none"
    report_template "toml"
    series_table "table"
    state "toml"
    table "table"
    tool_table "table"
    twin "none"
    workpiece "toml"
    xlsx "sheet"
}
