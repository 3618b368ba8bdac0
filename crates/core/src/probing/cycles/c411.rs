//! Cycle 411, datum at the centre of a boss.

use super::rectangle_datum_cycle::{PARAMETERS, rectangle, run};
use crate::probing::cycle::{Control, Cycle, Log, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 411,
    code: "411",
    control: Control::Milling,
    names: &[
        (En, "DATUM OUTS. RECTAN."),
        (Nl, "REF.PT RECHTH. BUIT."),
        (De, "BZPKT RECHTECK AUS."),
        (It, "ORIGINE RETTANG. EST."),
    ],
    notes: &[],
    parameters: &PARAMETERS,
    surface: |inputs| rectangle(Feature::Shaft).surface(inputs),
    run: |inputs, course| run(Feature::Shaft, inputs, course),
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};
