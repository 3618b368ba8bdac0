//! Cycle 421, measure hole: limits in Q275 and Q276.

use super::circle_cycle::{Side, nominal, parameters, run};
use crate::probing::cycle::{Cycle, Parameter};
use crate::tolerance::Feature;
use crate::words::Dialogue::{En, Nl};

const SIDE: Side = Side {
    feature: Feature::Hole,
    maximum: 275,
    maximum_question: &[(En, "Maximum limit of size for hole?")],
    minimum: 276,
    minimum_question: &[(En, "Minimum limit of size for hole?")],
    log: "TCHPR421.TXT",
};

/// The declaration. The Dutch name is that of NC-Solution 8255 (7/2020).
pub(super) const CYCLE: Cycle = Cycle {
    number: 421,
    code: "421",
    names: &[(En, "MEASURE HOLE"), (Nl, "METEN BORING")],
    parameters: &PARAMETERS,
    run: |inputs, course| run(&SIDE, inputs, course),
    nominal: |inputs| nominal(&SIDE, inputs),
};

const PARAMETERS: [Parameter; 20] = parameters(&SIDE);
