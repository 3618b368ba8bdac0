//! Cycle 410, datum at the centre of a pocket.

use super::rectangle_datum_cycle::{PARAMETERS, rectangle, run};
use crate::probing::cycle::{Control, Cycle, Log, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 410,
    code: "410",
    control: Control::Milling,
    names: &[
        (En, "DATUM INSIDE RECTAN."),
        (Nl, "REF.PT RECHTH. BINN."),
        (De, "BZPKT RECHTECK INNEN"),
        (It, "ORIGINE RETTANG. INT."),
    ],
    notes: &[],
    parameters: &PARAMETERS,
    surface: |inputs| rectangle(Feature::Hole).surface(inputs),
    run: |inputs, course| run(Feature::Hole, inputs, course),
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};
