//! What a check was made with, besides callout and value: it stands in the fields while the check is shown.

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::probing::Origin;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::query::RecordId;

use super::CheckField;
use crate::texts::Texts;

/// Where the nominal centre lies, and how far off the centre may be.
const POSITION: [CheckField; 3] = [CheckField::CentreX, CheckField::CentreY, CheckField::CentreTolerance];

/// Everything that a cycle on the simulated workpiece depends on, except for the seed: its field holds the next one.
pub(super) const SIMULATION: [CheckField; 14] = [
    CheckField::CentreX,
    CheckField::CentreY,
    CheckField::CentreTolerance,
    CheckField::Height,
    CheckField::FirstAngle,
    CheckField::Clearance,
    CheckField::TrueDiameter,
    CheckField::OffsetX,
    CheckField::OffsetY,
    CheckField::Ovality,
    CheckField::Lobes,
    CheckField::LobeHeight,
    CheckField::SurfaceScatter,
    CheckField::ProbeScatter,
];

/// The inputs of the checks that were made here. A record holds only what came of them.
#[derive(Debug, Default)]
pub(super) struct Inputs {
    of_simulated: BTreeMap<RecordId, Vec<(CheckField, String)>>,
    /// Typed values, as they were typed.
    typed: BTreeMap<RecordId, String>,
}

impl Inputs {
    /// Keeps what a check was made with.
    pub fn keep(&mut self, id: RecordId, texts: &Texts<CheckField>) {
        let all = SIMULATION.into_iter().map(|field| (field, texts.text(field).trim().to_owned()));
        self.of_simulated.insert(id, all.collect());
    }

    /// Keeps a value as it was typed.
    pub fn keep_typed(&mut self, id: RecordId, text: &str) {
        self.typed.insert(id, text.trim().to_owned());
    }

    /// The value of a record as it was typed here.
    pub fn typed(&self, id: Option<RecordId>) -> Option<&str> {
        self.typed.get(&id?).map(String::as_str)
    }

    /// What a record was made with; one that is in no history has no number. A typed diameter has no position, and no record from a file a workpiece.
    pub fn of(&self, id: Option<RecordId>, record: &Record) -> Vec<(CheckField, String)> {
        let mut inputs = vec![(CheckField::Part, record.id.clone())];
        match (&record.measurement.origin, id.and_then(|id| self.of_simulated.get(&id))) {
            (Origin::Simulated { .. }, Some(all)) => inputs.extend(all.iter().cloned()),
            (Origin::Contacts { .. }, Some(all)) => {
                inputs.extend(all.iter().filter(|(field, _)| POSITION.contains(field)).cloned());
            }
            _ => inputs.extend(position(record)),
        }
        inputs
    }
}

/// The position that a record was judged by, where fields can show it: both axes have the same tolerance there.
fn position(record: &Record) -> Vec<(CheckField, String)> {
    let (Some(verdict), Some(centre)) = (record.verdict.position, record.measurement.centre) else { return Vec::new() };
    let [first, second] = verdict.axes;
    if first.tolerance != second.tolerance {
        return Vec::new();
    }
    let nominal = |is: Length, deviation| is.saturating_sub(deviation).to_string();
    let tolerance = first.tolerance.unwrap_or(Length::ZERO).to_string();
    let texts = [nominal(centre[0], first.deviation), nominal(centre[1], second.deviation), tolerance];
    POSITION.into_iter().zip(texts).collect()
}
