//! Cycle 408, datum at the centre line of a slot.

use super::datum_cycle::{CLEARANCE, FIRST, NEW_3, NEW_ALONG, ROW, SECOND, TOP, TOP_1, TOP_2, TOP_3, TRANSFER};
use super::width_cycle::AXIS;
use super::width_datum_cycle::{run, surface, width};
use crate::probing::cycle::shared::{MEASURING_HEIGHT, MOVE_TO_CLEARANCE, SET_UP_CLEARANCE};
use crate::probing::cycle::{Control, Cycle, Log, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 408,
    code: "408",
    control: Control::Milling,
    names: &[
        (En, "SLOT CENTER REF PT"),
        (Nl, "REF.PT MIDDEN SLEUF"),
        (De, "BZPKT MITTE NUT"),
        (It, "ORIGINE CENTRO SCANAL."),
    ],
    notes: &[],
    parameters: &[
        FIRST,
        SECOND,
        width(
            "SLOT WIDTH",
            &[(Nl, "SLEUFBREEDTE"), (De, "BREITE DER NUT"), (It, "LARGHEZZA SCANAL.")],
            &[(En, "Slot width?"), (Nl, "Sleufbreedte?"), (De, "Breite der Nut?"), (It, "Larghezza scanalatura?")],
        ),
        AXIS,
        MEASURING_HEIGHT,
        SET_UP_CLEARANCE,
        CLEARANCE,
        MOVE_TO_CLEARANCE,
        ROW,
        NEW_ALONG,
        TRANSFER,
        TOP,
        TOP_1,
        TOP_2,
        TOP_3,
        NEW_3,
    ],
    surface: |inputs| surface(Feature::Hole, inputs),
    run: |inputs, course| run(Feature::Hole, inputs, course),
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};
