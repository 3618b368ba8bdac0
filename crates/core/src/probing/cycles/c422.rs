//! Cycle 422, measure circle outside: limits in Q277 and Q278.

use super::circle_cycle::{Side, corrects, figures, parameters, run, subject};
use crate::probing::cycle::{Control, Cycle, Log, LogFigure, Note, Parameter, TextLog, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, It: not seen.

const SIDE: Side = Side {
    feature: Feature::Shaft,
    maximum: 277,
    maximum_question: &[
        (En, "Maximum limit of size for stud?"),
        (Nl, "Maximale grensmaat tap?"),
        (De, "Größtmaß Zapfen?"),
        (It, "Limite max dimensione isola?"),
    ],
    minimum: 278,
    minimum_question: &[
        (En, "Minimum limit of size for stud?"),
        (Nl, "Minimale grensmaat tap?"),
        (De, "Kleinstmaß Zapfen?"),
        (It, "Limite minimo dimensione isola?"),
    ],
};

/// The declaration. The Dutch name is that of NC-Solution 8255 (7/2020).
pub(super) const CYCLE: Cycle = Cycle {
    number: 422,
    code: "422",
    control: Control::Milling,
    names: &[
        (En, "MEAS. CIRCLE OUTSIDE"),
        (Nl, "MET. CIRKEL BUITEN"),
        (De, "MESSEN KREIS AUSSEN"),
        (It, "MIS. CERCHIO ESTERNO"),
    ],
    notes: &[Note::EndsRotation],
    parameters: &PARAMETERS,
    surface: |inputs| SIDE.circle().surface(inputs),
    run: |inputs, course| run(&SIDE, inputs, course),
    subject: |inputs| Some(subject(inputs)),
    corrects: |result| corrects(&SIDE, result),
    window: Window::Diameter,
    log: Log::Text(TextLog { file: "TCHPR422.TXT", figures: &FIGURES }),
};

const PARAMETERS: [Parameter; 20] = parameters(&SIDE);

const FIGURES: [LogFigure; 3] = figures("stud");
