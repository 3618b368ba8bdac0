//! Cycle 409, datum at the centre line of a ridge.

use super::datum_cycle::{CLEARANCE, FIRST, NEW_3, NEW_ALONG, ROW, SECOND, TOP, TOP_1, TOP_2, TOP_3, TRANSFER};
use super::width_cycle::AXIS;
use super::width_datum_cycle::{run, surface, width};
use crate::probing::cycle::shared::{MEASURING_HEIGHT, SET_UP_CLEARANCE};
use crate::probing::cycle::{Control, Cycle, Log, Window};
use crate::tolerance::Feature;
use crate::words::Dialogue::{De, En, It, Nl};

// De: title remembered. Nl, It: ours.

/// The declaration.
pub(super) const CYCLE: Cycle = Cycle {
    number: 409,
    code: "409",
    control: Control::Milling,
    names: &[
        (En, "RIDGE CENTER REF PT"),
        (Nl, "REF.PT MIDDEN DAM"),
        (De, "BZPKT MITTE STEG"),
        (It, "ORIGINE CENTRO ISOLA"),
    ],
    notes: &[],
    parameters: &[
        FIRST,
        SECOND,
        width(
            "RIDGE WIDTH",
            &[(Nl, "DAMBREEDTE"), (De, "BREITE DES STEGS"), (It, "LARGHEZZA ISOLA")],
            &[(En, "Ridge width?"), (Nl, "Dambreedte?"), (De, "Breite des Stegs?"), (It, "Larghezza isola?")],
        ),
        AXIS,
        MEASURING_HEIGHT,
        SET_UP_CLEARANCE,
        CLEARANCE,
        ROW,
        NEW_ALONG,
        TRANSFER,
        TOP,
        TOP_1,
        TOP_2,
        TOP_3,
        NEW_3,
    ],
    surface: |inputs| surface(Feature::Shaft, inputs),
    run: |inputs, course| run(Feature::Shaft, inputs, course),
    subject: |_inputs| None,
    corrects: |_result| None,
    window: Window::None,
    log: Log::None,
};
