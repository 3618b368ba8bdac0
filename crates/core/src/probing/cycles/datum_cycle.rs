//! What the cycles that set a datum share: where it goes, which coordinates the measured place gets, and the contact along the probe axis
//! that some of them add.
//!
//! Order, names and defaults of the parameters as in public post-processors and a trainer that was written after the manual of the
//! iTNC 530 (`docs/SOURCES.md`, "Datum cycles"); the German words are seen for Q331, Q332 and Q405 only. Not seen on a page, and decided
//! here: Q303 that is not given counts as −1, as in a program of a control that had no Q303; the result of the contact along the probe
//! axis has no parameter; the results count in the system before the new datum.

use super::probed::met_at;
use crate::length::Length;
use crate::probing::contact::Contact;
use crate::probing::cycle::shared::{CENTRE_1, CENTRE_2, CLEARANCE_HEIGHT};
use crate::probing::cycle::{
    Axis, Course, CycleError, DatumAxis, DatumTarget, Inputs, Key, Meaning, Measured, NewDatum, Parameter, Range,
    ResultName, ResultParameter, nearest,
};
use crate::words::Dialogue::{De, En, It, Nl};

// De: not seen but the names of Q321, Q322, Q331, Q332 and Q405. It: not seen.

const ROW_KEY: Key = Key::Q(305);
const TRANSFER_KEY: Key = Key::Q(303);

/// The last row of a table: TNC 640 and TNC7; an iTNC 530 has fewer.
const LAST_ROW: u32 = 99_999;

/// The nominal centre, first axis.
pub(super) const FIRST: Parameter = CENTRE_1.at(321).asked(&[
    (En, "Center in 1st axis?"),
    (Nl, "Midden 1e as?"),
    (De, "Mitte 1. Achse?"),
    (It, "Centro 1. asse?"),
]);
/// Second axis.
pub(super) const SECOND: Parameter = CENTRE_2.at(322).asked(&[
    (En, "Center in 2nd axis?"),
    (Nl, "Midden 2e as?"),
    (De, "Mitte 2. Achse?"),
    (It, "Centro 2. asse?"),
]);
/// The height at which nothing is in the way: it has no default here.
pub(super) const CLEARANCE: Parameter = CLEARANCE_HEIGHT.required();

/// The row of the table.
pub(super) const ROW: Parameter = Parameter::new(ROW_KEY, "NUMBER IN TABLE", Range::Count { most: LAST_ROW })
    .named(&[(Nl, "NUMMER IN TABEL"), (De, "NR. IN TABELLE"), (It, "NUMERO IN TABELLA")])
    .asked(&[
        (En, "Number in table?"),
        (Nl, "Nummer in tabel?"),
        (De, "Nummer in Tabelle?"),
        (It, "Numero nella tabella?"),
    ])
    .or(0)
    .means(Meaning::TableRow);
/// Which table: −1 comes from programs of controls that had no such parameter.
pub(super) const TRANSFER: Parameter = Parameter::choice(TRANSFER_KEY, "MEAS. VALUE TRANSFER", &[-1, 0, 1])
    .named(&[(Nl, "OVERDRACHT MEETW."), (De, "MESSWERT-UEBERGABE"), (It, "TRASM. VALORE MIS.")])
    .asked(&[
        (En, "Meas. value transfer (0,1)?"),
        (Nl, "Overdracht meetwaarde (0,1)?"),
        (De, "Messwert-Übergabe (0,1)?"),
        (It, "Trasm. valore misurato (0,1)?"),
    ])
    .or(-1)
    .means(Meaning::Transfer);

/// The coordinate that a measured place gets.
const fn new_datum(number: u16, meaning: Meaning) -> Parameter {
    Parameter::coordinate(Key::Q(number), "DATUM")
        .named(&[(Nl, "REFERENTIEPUNT"), (De, "BEZUGSPUNKT"), (It, "ORIGINE")])
        .asked(&[(En, "New datum?"), (Nl, "Nieuw referentiepunt?"), (De, "Neuer Bezugspunkt?"), (It, "Nuova origine?")])
        .or(0)
        .means(meaning)
}

/// In the first axis.
pub(super) const NEW_1: Parameter = new_datum(331, Meaning::NewDatum(Axis::First)).asked(&[
    (En, "New datum in reference axis?"),
    (Nl, "Nieuw referentiepunt hoofdas?"),
    (De, "Neuer Bezugspunkt Hauptachse?"),
    (It, "Nuova origine asse princ.?"),
]);
/// In the second.
pub(super) const NEW_2: Parameter = new_datum(332, Meaning::NewDatum(Axis::Second)).asked(&[
    (En, "New datum in minor axis?"),
    (Nl, "Nieuw referentiepunt nevenas?"),
    (De, "Neuer Bezugspunkt Nebenachse?"),
    (It, "Nuova origine asse second.?"),
]);
/// In the probe axis, where that is probed, too.
pub(super) const NEW_3: Parameter = new_datum(333, Meaning::NewDatum(Axis::Third)).asked(&[
    (En, "New datum in TS axis?"),
    (Nl, "Nieuw referentiepunt TS-as?"),
    (De, "Neuer Bezugspunkt TS-Achse?"),
    (It, "Nuova origine asse TS?"),
]);
/// In the measured axis of 408 and 409.
pub(super) const NEW_ALONG: Parameter = new_datum(405, Meaning::NewCoordinate);
/// In the measured axis of 417 and 419.
pub(super) const NEW_COORDINATE: Parameter = NEW_3.means(Meaning::NewCoordinate);

/// Whether the probe axis is probed, too.
pub(super) const TOP: Parameter = Parameter::choice(Key::Q(381), "PROBE IN TS AXIS", &[0, 1])
    .named(&[(Nl, "TASTEN IN TS-AS"), (De, "ANTASTEN TS-ACHSE"), (It, "TASTARE IN ASSE TS")])
    .asked(&[
        (En, "Probe in TS axis? (0/1)"),
        (Nl, "Tasten in TS-as? (0/1)"),
        (De, "Antasten in TS-Achse? (0/1)"),
        (It, "Tastare in asse TS? (0/1)"),
    ])
    .or(0)
    .means(Meaning::ToolAxisProbing);
/// Where, in the first axis.
pub(super) const TOP_1: Parameter = Parameter::coordinate(Key::Q(382), "1ST CO. FOR TS AXIS")
    .named(&[(Nl, "1E COORD. TS-AS"), (De, "1. KO. FUER TS-ACHSE"), (It, "1. COORD. ASSE TS")])
    .asked(&[
        (En, "Probe TS axis: Coord. 1st axis?"),
        (Nl, "Tasten TS-as: coörd. 1e as?"),
        (De, "Tasten TS-Achse: Koord. 1. Achse?"),
        (It, "Tast. asse TS: coord. 1. asse?"),
    ])
    .or(0)
    .means(Meaning::ToolAxisPoint(Axis::First));
/// In the second.
pub(super) const TOP_2: Parameter = Parameter::coordinate(Key::Q(383), "2ND CO. FOR TS AXIS")
    .named(&[(Nl, "2E COORD. TS-AS"), (De, "2. KO. FUER TS-ACHSE"), (It, "2. COORD. ASSE TS")])
    .asked(&[
        (En, "Probe TS axis: Coord. 2nd axis?"),
        (Nl, "Tasten TS-as: coörd. 2e as?"),
        (De, "Tasten TS-Achse: Koord. 2. Achse?"),
        (It, "Tast. asse TS: coord. 2. asse?"),
    ])
    .or(0)
    .means(Meaning::ToolAxisPoint(Axis::Second));
/// In the third.
pub(super) const TOP_3: Parameter = Parameter::coordinate(Key::Q(384), "3RD CO. FOR TS AXIS")
    .named(&[(Nl, "3E COORD. TS-AS"), (De, "3. KO. FUER TS-ACHSE"), (It, "3. COORD. ASSE TS")])
    .asked(&[
        (En, "Probe TS axis: Coord. 3rd axis?"),
        (Nl, "Tasten TS-as: coörd. 3e as?"),
        (De, "Tasten TS-Achse: Koord. 3. Achse?"),
        (It, "Tast. asse TS: coord. 3. asse?"),
    ])
    .or(0)
    .means(Meaning::ToolAxisPoint(Axis::Third));

/// Where the datum goes, known before anything is probed.
pub(super) fn target(inputs: &Inputs) -> Result<DatumTarget, CycleError> {
    let row = inputs.whole(ROW_KEY);
    match (u32::try_from(row).unwrap_or(0), inputs.whole(TRANSFER_KEY)) {
        // Q303 has no function then.
        (0, _) => Ok(DatumTarget::Display),
        (row, 1) => Ok(DatumTarget::Preset { row }),
        (row, 0) => Ok(DatumTarget::Table { row }),
        (_, _) => Err(CycleError::NoTransfer { key: TRANSFER_KEY, row_key: ROW_KEY, row }),
    }
}

/// An axis that gets the coordinate of a parameter.
pub(super) fn axis(axis: Axis, measured: Length, inputs: &Inputs, wanted: Key) -> DatumAxis {
    DatumAxis { axis, measured, wanted: inputs.length(wanted) }
}

/// Ends a cycle: probes the probe axis where Q381 asks for that, and says what the new datum is. That contact is none of the surface that
/// is measured, such as a circle: only the path and the results have it.
pub(super) fn set(
    target: DatumTarget,
    (contacts, mut results, mut axes): (Vec<Contact>, Vec<ResultParameter>, Vec<DatumAxis>),
    inputs: &Inputs,
    course: &mut Course<'_>,
) -> Result<Measured, CycleError> {
    if inputs.whole(381) == 1 {
        course.needs_heights()?;
        let top = met_at([382, 383, 384].map(|number: u16| inputs.mm(number)), [0.0, 0.0, -1.0], inputs, course)?;
        course.leave(inputs.mm(260));
        let height = nearest(top.z)?;
        results.push(ResultParameter::without_key(ResultName::POSITION_3, height));
        axes.push(axis(Axis::Third, height, inputs, NEW_3.key));
    }
    Ok(Measured { contacts, results, datum: Some(NewDatum { target, axes }), ..Measured::default() })
}
