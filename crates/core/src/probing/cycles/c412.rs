//! Cycle 412, datum at the centre of a hole.

use super::circle_datum_cycle::{PARAMETERS, circle, run};
use crate::probing::cycle::{Control, Cycle, Log, Note, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 412,
    code: "412",
    control: Control::Milling,
    names: &[
        (En, "DATUM INSIDE CIRCLE"),
        (Nl, "REF.PT CIRKEL BINNEN"),
        (De, "BZPKT KREIS INNEN"),
        (It, "ORIGINE CERCHIO INT."),
    ],
    notes: &[Note::Recommended { cycle: "1401" }],
    parameters: &PARAMETERS,
    surface: |inputs| circle(Feature::Hole).surface(inputs),
    run: |inputs, course| run(Feature::Hole, inputs, course),
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};
