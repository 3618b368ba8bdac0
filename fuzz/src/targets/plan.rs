//! Any bytes as a plan: it is refused, or a set is made for a control, runs to exactly the plan's limits, and is the same
//! when it is made again.

use fitcheck::nc::sets::{Control, NcPlan, NcSet, SetError, Target};
use fitcheck::tolerance::Sources;
use fitcheck::words::Dialogue;

use super::shared::told;

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
    match NcSet::make(&plan, &target, &Sources::default()) {
        Ok(set) => {
            assert_eq!(set.files.len(), 6);
            assert!(set.zip().is_ok());
            for remark in &set.remarks {
                told(bytes, remark);
            }
        }
        Err(error @ (SetError::Plan(_) | SetError::Shape { .. } | SetError::Table { .. })) => told(bytes, &error),
        Err(error) => panic!("{error}"),
    }
}
