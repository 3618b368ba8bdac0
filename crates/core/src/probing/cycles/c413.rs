//! Cycle 413, datum at the centre of a stud.

use super::circle_datum_cycle::{PARAMETERS, circle, run};
use crate::probing::cycle::{Control, Cycle, Log, Note, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 413,
    code: "413",
    control: Control::Milling,
    names: &[
        (En, "DATUM OUTSIDE CIRCLE"),
        (Nl, "REF.PT CIRKEL BUITEN"),
        (De, "BZPKT KREIS AUSSEN"),
        (It, "ORIGINE CERCHIO EST."),
    ],
    notes: &[Note::Recommended { cycle: "1401" }],
    parameters: &PARAMETERS,
    surface: |inputs| circle(Feature::Shaft).surface(inputs),
    run: |inputs, course| run(Feature::Shaft, inputs, course),
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};
