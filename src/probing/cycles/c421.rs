//! Cycle 421, measure hole: limits in Q275 and Q276.

use super::circle_cycle::{Side, parameters, run};
use crate::probing::cycle::{Cycle, Parameter};
use crate::tolerance::Feature;
use crate::words::Language;

const SIDE: Side = Side { feature: Feature::Hole, maximum: 275, minimum: 276 };

/// The declaration. The Dutch name is that of seed `000_2e707c2d138629e0.txt`.
pub(super) const CYCLE: Cycle = Cycle {
    number: 421,
    names: &[(Language::En, "MEASURE HOLE"), (Language::Nl, "METEN BORING")],
    parameters: &PARAMETERS,
    run: |inputs, prober| run(&SIDE, inputs, prober),
};

const PARAMETERS: [Parameter; 18] = parameters(&SIDE);
