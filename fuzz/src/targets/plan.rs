//! Any bytes as a plan: it is refused, or a set is made for a control, runs to exactly the plan's limits, and is the same
//! when it is made again.

use std::collections::BTreeSet;

use fitcheck::exchange::ImportInputs;
use fitcheck::nc::sets::{Control, NcSet, SetError, Target};
use fitcheck::part::{Document, Draft, FeatureKind};
use fitcheck::words::Dialogue;

use super::shared::{OWN_SOURCES, told};

/// The kinds that one program measures.
const fn program(kind: &FeatureKind) -> &'static str {
    match kind {
        FeatureKind::Boss(_) => "pocket",
        kind => kind.word(),
    }
}

pub fn run(bytes: &[u8]) {
    let given = ImportInputs::new(&OWN_SOURCES, jiff::civil::DateTime::MIN);
    let document = match fitcheck::exchange::read_plan("plan", bytes, given) {
        Ok(document) => document,
        Err(error) => return told(bytes, &error),
    };
    writes_back(&document.draft);
    let plan = match document.plan(&OWN_SOURCES) {
        Ok(plan) => plan,
        Err(errors) => return errors.iter().for_each(|error| told(bytes, error)),
    };
    // Making a set takes milliseconds; more features only take longer.
    if 3 < plan.features().len() {
        return;
    }
    let control = Control::ALL[bytes.len() % Control::ALL.len()];
    let target = Target::new(control, Dialogue::ALL[bytes.len() / 3 % Dialogue::ALL.len()]);
    match NcSet::make(&plan, &target, &OWN_SOURCES) {
        Ok(set) => {
            // A called program and its mask for every kind.
            let words: BTreeSet<&str> = plan.features().iter().map(|feature| program(&feature.kind)).collect();
            let kinds = words.len() + usize::from(!words.contains("diameter"));
            assert_eq!(set.files.len(), 4 + 2 * kinds);
            assert!(set.zip().is_ok());
            for remark in &set.remarks {
                told(bytes, remark);
            }
        }
        Err(
            error
            @ (SetError::Feature(_) | SetError::Features { .. } | SetError::Shape { .. } | SetError::Table { .. }),
        ) => told(bytes, &error),
        Err(error) => panic!("{error}"),
    }
}

/// What is written as TOML reads back as the same texts, whatever they are.
fn writes_back(draft: &Draft) {
    let again = Document::read(draft.to_toml().as_bytes()).expect("what is written is a plan");
    assert_eq!(again.problems, []);
    assert_eq!(texts(&again.draft), texts(draft));
}

fn texts(draft: &Draft) -> Vec<Vec<Option<&str>>> {
    use fitcheck::part::{Column, HeadField};
    let head = HeadField::ALL.iter().map(|field| draft.text(*field)).collect();
    let rows = draft.rows.iter().map(|row| Column::ALL.iter().map(|column| row.text(*column)).collect());
    std::iter::once(head).chain(rows).collect()
}
