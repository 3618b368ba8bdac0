//! Random tables with a known truth, through every way that a file can take: `import`, `batch`, a plan, the window's session, and
//! the program itself. A verdict that is not the truth is a failure, a refusal with a reason is not; and a plain table is read.
//!
//! `TRUTH_ROWS` rows go through the readers (a million takes some minutes), from `TRUTH_SEED`.

mod program;
mod table;
mod ways;

use std::collections::BTreeMap;

use crate::fuzzing::{Random, variable};
use table::{Table, Truth};
use ways::WAYS;

/// Rows of a table: a small one, so that there are many tables.
const ROWS_OF_A_TABLE: usize = 24;

/// Rows where nothing else is asked for: some seconds.
const ROWS: usize = 12_000;

#[derive(Default)]
struct Counts {
    right: usize,
    refused: usize,
}

/// Faults of one kind: how many, and the first one whole.
#[derive(Default)]
struct Faults(BTreeMap<String, (usize, String)>);

impl Faults {
    fn add(&mut self, kind: String, what: impl FnOnce() -> String) {
        self.0.entry(kind).or_insert_with(|| (0, what())).0 += 1;
    }

    /// Each kind with its number, and some whole.
    fn list(&self) -> String {
        let kinds = self.0.iter().map(|(kind, (count, _))| format!("{count} times {kind}\n"));
        let first = self.0.values().take(4).map(|(_, what)| what.chars().take(1500).chain("\n\n".chars()).collect());
        kinds.chain(first).collect()
    }
}

#[test]
fn no_row_has_a_verdict_that_is_not_the_truth() {
    let (seed, rows) = (variable("TRUTH_SEED").unwrap_or(20_261_125), variable("TRUTH_ROWS").unwrap_or(ROWS));
    let mut random = Random::new(seed);
    let mut counts: BTreeMap<&str, Counts> = BTreeMap::new();
    let (mut wrong, mut dull) = (Faults::default(), Faults::default());
    let mut done = 0;
    while done < rows {
        let table = Table::random(&mut random, "", ROWS_OF_A_TABLE);
        for way in WAYS {
            let said = (way.say)(&table);
            let count = counts.entry(way.name).or_default();
            let kind = |what: &str| format!("{}, {}: {what}", way.name, table.kind());
            for (name, answer) in &said {
                let truth = table.rows.iter().find(|truth| truth.name == *name);
                let is_simulated = |truth: &Truth| answer.is_simulated == truth.is_simulated || !way.tells;
                let what = match truth {
                    None => "no row",
                    Some(truth) if truth.status.is_none() => "a verdict that nothing gives",
                    Some(truth) if Some(answer.status) != truth.status => "another verdict",
                    Some(truth) if !is_simulated(truth) => "simulated or not",
                    Some(truth) if truth.is_contradicted && way.tells && !answer.is_contradicted => {
                        "the file's own status is passed over"
                    }
                    Some(_) => {
                        count.right += 1;
                        continue;
                    }
                };
                wrong
                    .add(kind(what), || format!("{name}: {answer:?} is not {truth:?}\n{}\n{}", table.made, table.text));
            }
            count.refused += table.rows.len().saturating_sub(said.len());
            // A refusal is no fault, but one of a plain table would make this test one that cannot fail.
            if table.is_plain && said.len() < table.rows.len() {
                dull.add(kind("plain, and not read whole"), || {
                    format!("{} of {} rows\n{}\n{}", said.len(), table.rows.len(), table.made, table.text)
                });
            }
        }
        done += table.rows.len();
    }
    println!("{done} rows from seed {seed}");
    for (name, Counts { right, refused }) in &counts {
        println!("{name}: {right} right, {refused} refused");
    }
    assert!(wrong.0.is_empty() && dull.0.is_empty(), "wrong:\n{}\nplain:\n{}", wrong.list(), dull.list());
}
