//! Cycle 422, measure circle outside: limits in Q277 and Q278.

use super::circle_cycle::{Side, nominal, parameters, run};
use crate::probing::cycle::{Cycle, Parameter};
use crate::tolerance::Feature;
use crate::words::Dialogue::{En, Nl};

const SIDE: Side = Side {
    feature: Feature::Shaft,
    maximum: 277,
    maximum_question: &[(En, "Maximum limit of size for stud?")],
    minimum: 278,
    minimum_question: &[(En, "Minimum limit of size for stud?")],
    log: "TCHPR422.TXT",
};

/// The declaration. The Dutch name is that of NC-Solution 8255 (7/2020).
pub(super) const CYCLE: Cycle = Cycle {
    number: 422,
    code: "422",
    names: &[(En, "MEAS. CIRCLE OUTSIDE"), (Nl, "MET. CIRKEL BUITEN")],
    parameters: &PARAMETERS,
    run: |inputs, course| run(&SIDE, inputs, course),
    nominal: |inputs| nominal(&SIDE, inputs),
};

const PARAMETERS: [Parameter; 20] = parameters(&SIDE);
