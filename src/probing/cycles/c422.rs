//! Cycle 422, measure circle outside: limits in Q277 and Q278.

use super::circle_cycle::{Side, parameters, run};
use crate::probing::cycle::{Cycle, Parameter};
use crate::tolerance::Feature;
use crate::words::Language;

const SIDE: Side = Side { feature: Feature::Shaft, maximum: 277, minimum: 278 };

/// The declaration. The Dutch name is that of seed `000_2e707c2d138629e0.txt`.
pub(super) const CYCLE: Cycle = Cycle {
    number: 422,
    names: &[(Language::En, "MEAS. CIRCLE OUTSIDE"), (Language::Nl, "MET. CIRKEL BUITEN")],
    parameters: &PARAMETERS,
    run: |inputs, prober| run(&SIDE, inputs, prober),
};

const PARAMETERS: [Parameter; 18] = parameters(&SIDE);
