//! A line beside the measurements that is not used: what it says against them, if it says something.

use csv::StringRecord;
use fitcheck_core::tolerance::fit::thermal::Temperature;

use super::cell::joined;
use super::evidence::mentions_simulation;
use super::given::shorten;
use super::warmth;
use super::warning::ImportWarningKind;

/// That the cells of a line beside the measurements are not used, or what they say against them; values count as measured at this
/// temperature, where they are not corrected already.
pub(super) fn not_used(cells: &StringRecord, counted: Option<Temperature>) -> ImportWarningKind {
    let text = joined(cells);
    if mentions_simulation(&text) {
        return ImportWarningKind::SpeaksOfSimulation { text: shorten(&text) };
    }
    let differs = counted.filter(|counted| warmth::mentioned(&text).is_some_and(|warm| warmth::differ(warm, *counted)));
    let text = shorten(&text);
    match differs {
        Some(counted) => ImportWarningKind::SpeaksOfTemperature { text, counted: counted.to_string() },
        None => ImportWarningKind::NotUsed { text },
    }
}

/// What such a line says against them; `None` where it says nothing.
pub(super) fn said_against(cells: &StringRecord, counted: Option<Temperature>) -> Option<ImportWarningKind> {
    Some(not_used(cells, counted)).filter(|told| !matches!(told, ImportWarningKind::NotUsed { .. }))
}
