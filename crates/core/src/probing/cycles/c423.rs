//! Cycle 423, measure rectangle inside: a pocket with its sides along the axes, limits in Q284 to Q287.

use super::rectangle_cycle::{FIGURES, PARAMETERS, corrects, rectangle, run};
use crate::probing::cycle::{Control, Cycle, Log, Note, TextLog, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, It: not seen.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 423,
    code: "423",
    control: Control::Milling,
    names: &[
        (En, "MEAS. RECTAN. INSIDE"),
        (Nl, "MET. RECHTH. BINNEN"),
        (De, "MESSEN RECHTECK INN."),
        (It, "MIS. RETTANGOLO INT."),
    ],
    notes: &[Note::EndsRotation, Note::Recommended { cycle: "1403" }],
    parameters: &PARAMETERS,
    surface: |inputs| rectangle(Feature::Hole).surface(inputs),
    run: |inputs, course| run(Feature::Hole, inputs, course),
    subject: |inputs| Some(rectangle(Feature::Hole).subject(inputs)),
    corrects: |result| corrects(Feature::Hole, result),
    window: Window::Own("rectangle"),
    log: Log::Text(TextLog { file: "TCHPR423.TXT", figures: FIGURES }),
};
