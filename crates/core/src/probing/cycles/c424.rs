//! Cycle 424, measure rectangle outside: a boss with its sides along the axes, limits in Q284 to Q287.

use super::rectangle_cycle::{FIGURES, PARAMETERS, corrects, rectangle, run};
use crate::probing::cycle::{Control, Cycle, Log, Note, TextLog, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, It: not seen.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 424,
    code: "424",
    control: Control::Milling,
    names: &[
        (En, "MEAS. RECTAN. OUTS."),
        (Nl, "MET. RECHTH. BUITEN"),
        (De, "MESSEN RECHTECK AUS."),
        (It, "MIS. RETTANGOLO EST."),
    ],
    notes: &[Note::EndsRotation, Note::Recommended { cycle: "1403" }],
    parameters: &PARAMETERS,
    surface: |inputs| rectangle(Feature::Shaft).surface(inputs),
    run: |inputs, course| run(Feature::Shaft, inputs, course),
    subject: |inputs| Some(rectangle(Feature::Shaft).subject(inputs)),
    corrects: |result| corrects(Feature::Shaft, result),
    window: Window::Own("rectangle"),
    log: Log::Text(TextLog { file: "TCHPR424.TXT", figures: FIGURES }),
};
