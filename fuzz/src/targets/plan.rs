//! Any bytes as a plan: it is refused, or a set is made for a control, runs to exactly the plan's limits, and is the same
//! when it is made again.

use std::collections::BTreeSet;

use fitcheck::nc::sets::{Control, NcKind, NcPlan, NcSet, SetError, Target};
use fitcheck::words::Dialogue;

use super::shared::{OWN_SOURCES, told};

/// The kinds that one program measures.
const fn program(kind: &NcKind) -> &'static str {
    match kind {
        NcKind::Boss(_) => "pocket",
        kind => kind.word(),
    }
}

pub fn run(bytes: &[u8]) {
    let plan = match NcPlan::read(bytes) {
        Ok(plan) => plan,
        Err(error) => return told(bytes, &error),
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
        Err(error @ (SetError::Plan(_) | SetError::Shape { .. } | SetError::Table { .. })) => told(bytes, &error),
        Err(error) => panic!("{error}"),
    }
}
