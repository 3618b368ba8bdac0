//! Deviations that were written in micrometres where millimetres are read.

use super::Callout;
use crate::length::Length;
use crate::tolerance::coarsest::widest;
use crate::tolerance::deviations::Deviations;

/// A micrometre is a thousandth of a millimetre.
const THOUSAND: i64 = 1_000;

/// The finest deviation that anybody writes in micrometres, in nanometres: half of one.
const FINEST: i64 = 500;

/// The callout whose deviations are as many micrometres, where that is a zone that nobody doubts.
pub(in super::super) fn as_micrometres(nominal: Length, deviations: Deviations) -> Option<Callout> {
    let meant = thousandths(deviations)?;
    if nominal <= Length::ZERO || nominal.checked_add(meant.lower())? <= Length::ZERO || widest(nominal) < meant.width()
    {
        return None;
    }
    Callout::with_deviations(nominal, meant).ok()
}

/// A thousandth of both deviations, where that is what somebody may have written in micrometres.
pub(in super::super) fn thousandths(deviations: Deviations) -> Option<Deviations> {
    let of = |deviation: Length| {
        let nm = deviation.nanometres();
        let is_whole = nm % THOUSAND == 0 && (nm == 0 || FINEST <= nm.abs() / THOUSAND);
        is_whole.then(|| Length::from_nanometres(nm / THOUSAND).ok()).flatten()
    };
    Some(Deviations::spanning(of(deviations.upper())?, of(deviations.lower())?))
}
