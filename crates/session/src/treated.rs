//! Where the manual treats a field or a part that folds away: what F1 opens. A field without a place here has its paragraph alone.

use fitcheck_core::part::HeadField;

use super::check::CheckField;
use super::field::Field;
use super::help::HelpPlace;
use super::parts::{PartsField, PlanField};
use super::records::RecordsField;

/// A page of the manual and what links call one of its headings.
type Place = (&'static str, &'static str);

const RECORDED: Place = ("records.md", "what-is-recorded");
const CORRECTED: Place = ("records.md", "correct-report-verify");
const RULE: Place = ("rules.md", "choose-a-rule");
const UNCERTAINTY: Place = ("rules.md", "the-uncertainty-of-the-value");
const TEMPERATURE: Place = ("temperature.md", "temperature-on-the-check-page");

/// The place about a field.
pub(super) fn of_field(field: Field) -> Option<HelpPlace> {
    let (file, heading) = match field {
        Field::Check(field) => of_check(field)?,
        Field::Records(field) => of_records(field),
        Field::Parts(PartsField::Walk(_)) => ("parts.md", "measure-a-part-feature-by-feature"),
        Field::Parts(PartsField::Plan(PlanField::Head(field))) => match field {
            HeadField::Rule => RULE,
            HeadField::Uncertainty => UNCERTAINTY,
            HeadField::Picture => ("parts.md", "the-picture-of-a-part"),
            _ => ("parts.md", "the-plan-as-a-table"),
        },
        Field::Parts(PartsField::Plan(PlanField::Cell)) => ("parts.md", "the-plan-as-a-table"),
        Field::Statistics(_) => ("statistics.md", "in-the-window"),
        Field::Budget(_) => ("uncertainty.md", "the-uncertainty-page"),
        Field::Help(_) => ("window.md", "help"),
        _ => return None,
    };
    Some(HelpPlace::at(file, heading))
}

const fn of_check(field: CheckField) -> Option<Place> {
    Some(match field {
        CheckField::Uncertainty | CheckField::Coverage => UNCERTAINTY,
        CheckField::GuardFactor => ("rules.md", "ilac-g8"),
        CheckField::GuardWidth => ("rules.md", "fixed-guard-band"),
        CheckField::ProcessMean | CheckField::ProcessSpread => ("rules.md", "the-risks-of-a-process"),
        CheckField::PartTemperature
        | CheckField::PartExpansion
        | CheckField::ScaleTemperature
        | CheckField::ScaleExpansion => TEMPERATURE,
        CheckField::Serial | CheckField::Remark => RECORDED,
        _ => return None,
    })
}

const fn of_records(field: RecordsField) -> Place {
    match field {
        RecordsField::Question | RecordsField::Filter => ("records.md", "the-records-page"),
        RecordsField::Who => RECORDED,
        RecordsField::Server => ("shop-server.md", "add-stations-and-readers"),
        _ => CORRECTED,
    }
}

/// The place about a part of a page that folds away, by its name.
pub(super) fn of_fold(name: &str) -> Option<HelpPlace> {
    let (file, heading) = match name {
        "check-rule-section" => RULE,
        "check-temperature-section" => TEMPERATURE,
        "records-page-fold" => RECORDED,
        "part-section" => ("fields.md", "part-or-feature"),
        "probe-position" => ("fields.md", "centre-x"),
        "simulated-workpiece" => ("fields.md", "true-diameter"),
        _ => return None,
    };
    Some(HelpPlace::at(file, heading))
}
