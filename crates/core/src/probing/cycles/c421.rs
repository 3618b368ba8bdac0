//! Cycle 421, measure hole: limits in Q275 and Q276.

use super::circle_cycle::{Side, corrects, figures, parameters, run, subject};
use crate::probing::cycle::{Control, Cycle, Log, LogFigure, Note, Parameter, TextLog, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De, It: not seen.

const SIDE: Side = Side {
    feature: Feature::Hole,
    maximum: 275,
    maximum_question: &[
        (En, "Maximum limit of size for hole?"),
        (Nl, "Maximale grensmaat boring?"),
        (De, "Größtmaß Bohrung?"),
        (It, "Limite max dimensione foro?"),
    ],
    minimum: 276,
    minimum_question: &[
        (En, "Minimum limit of size for hole?"),
        (Nl, "Minimale grensmaat boring?"),
        (De, "Kleinstmaß Bohrung?"),
        (It, "Limite minimo dimensione foro?"),
    ],
};

/// The declaration. The Dutch name is that of NC-Solution 8255 (7/2020).
pub(super) const CYCLE: Cycle = Cycle {
    number: 421,
    code: "421",
    control: Control::Milling,
    names: &[(En, "MEASURE HOLE"), (Nl, "METEN BORING"), (De, "MESSEN BOHRUNG"), (It, "MISURARE FORO")],
    notes: &[Note::EndsRotation, Note::Recommended { cycle: "1401" }],
    parameters: &PARAMETERS,
    surface: |inputs| SIDE.circle().surface(inputs),
    run: |inputs, course| run(&SIDE, inputs, course),
    subject: |inputs| Some(subject(inputs)),
    corrects: |result| corrects(&SIDE, result),
    window: Window::Diameter,
    log: Log::Text(TextLog { file: "TCHPR421.TXT", figures: &FIGURES }),
};

const PARAMETERS: [Parameter; 20] = parameters(&SIDE);

const FIGURES: [LogFigure; 3] = figures("hole");
