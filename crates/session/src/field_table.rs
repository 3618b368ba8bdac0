//! What is to be known of every text field: its name, where it stands, its paragraph of the manual and its drawing. Help and palette are
//! made from it. A field without a row does not compile.

use fitcheck_core::part::HeadField;
use fitcheck_core::probing::cycle::{Cycle, Meaning};
use fitcheck_nc::control::variables::Parameter;

use super::budget::BudgetField;
use super::check::CheckField;
use super::cycles::{Axis, CycleField, WorkpieceField};
use super::field::Field;
use super::fit::FitField;
use super::help::{HelpField, HelpPlace};
use super::page::Page;
use super::pairing::PairingField;
use super::parts::{PartsField, PlanField, WalkField};
use super::program::{Input, ProgramField};
use super::records::RecordsField;
use super::reports::ReportsField;
use super::settings_page::SettingsField;
use super::statistics::StatisticsField;
use super::tables::TablesField;

/// The page of the manual with a paragraph for each field.
const MANUAL: &str = "fields.md";

/// Where a field stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldPlace {
    /// Always on its page.
    Page,
    /// On its page, in the fold of this name.
    Fold(&'static str),
    /// On its page, or in a window over it, as long as something else is chosen or open there.
    AtTimes,
}

/// What is to be known of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct FieldRow {
    /// The id of its name.
    pub name: &'static str,
    pub place: FieldPlace,
    /// What links call the heading of its paragraph.
    paragraph: &'static str,
}

/// The fields of a page.
pub(super) trait Rows: Sized + 'static {
    const ALL: &'static [Self];

    fn row(self) -> FieldRow;
}

/// A list of fields, a row each: the field, the id of its name, where it stands, and its paragraph.
macro_rules! rows {
    ($Field:ident: $($field:ident, $name:literal, $place:expr, $paragraph:literal;)+) => {
        impl Rows for $Field {
            const ALL: &'static [Self] = &[$(Self::$field),+];

            fn row(self) -> FieldRow {
                match self {
                    $(Self::$field => FieldRow { name: $name, place: $place, paragraph: $paragraph },)+
                }
            }
        }
    };
}

pub(super) const PAGE: FieldPlace = FieldPlace::Page;
pub(super) const AT_TIMES: FieldPlace = FieldPlace::AtTimes;
/// The part of the check page with the decision rule.
pub(crate) const RULE_PART: &str = "check-rule-section";

const PROBE: FieldPlace = FieldPlace::Fold("probe-position");
const SIMULATED: FieldPlace = FieldPlace::Fold("simulated-workpiece");
const RULE: FieldPlace = FieldPlace::Fold(RULE_PART);
const WARMTH: FieldPlace = FieldPlace::Fold("check-temperature-section");
const RECORD: FieldPlace = FieldPlace::Fold("records-page-fold");

rows! {
    CheckField:
    Callout, "callout", PAGE, "callout";
    Measured, "measured-value", PAGE, "measured-value";
    Part, "part-name", FieldPlace::Fold("part-section"), "part-or-feature";
    Serial, "records-page-serial", RECORD, "serial-number";
    Remark, "records-page-remark", RECORD, "remark";
    Nominal, "nominal-size", PAGE, "nominal-size";
    CentreX, "centre-x", PROBE, "centre-x";
    CentreY, "centre-y", PROBE, "centre-y";
    Height, "height-z", PROBE, "height-z";
    FirstAngle, "first-contact", PROBE, "first-contact";
    Clearance, "clearance", PROBE, "set-up-clearance";
    CentreTolerance, "centre-tolerance", PROBE, "centre-tolerance";
    TrueDiameter, "true-diameter", SIMULATED, "true-diameter";
    OffsetX, "offset-x", SIMULATED, "offset-x";
    OffsetY, "offset-y", SIMULATED, "offset-y";
    Ovality, "ovality", SIMULATED, "ovality";
    Lobes, "lobes", SIMULATED, "lobes";
    LobeHeight, "lobe-height", SIMULATED, "lobe-height";
    SurfaceScatter, "surface-scatter", SIMULATED, "surface-scatter";
    ProbeScatter, "probe-scatter", SIMULATED, "probe-scatter";
    Seed, "seed", SIMULATED, "seed";
    Uncertainty, "uncertainty-u", RULE, "uncertainty-of-the-value";
    Coverage, "coverage-factor", RULE, "coverage-factor";
    GuardFactor, "guard-factor", AT_TIMES, "multiple-of-the-uncertainty";
    GuardWidth, "guard-width", AT_TIMES, "width-of-the-guard-band";
    ProcessMean, "process-mean", RULE, "mean-of-the-process";
    ProcessSpread, "process-spread", RULE, "standard-deviation-of-the-process";
    PartTemperature, "part-temperature", WARMTH, "temperature-of-the-part";
    PartExpansion, "part-expansion", WARMTH, "expansion-of-the-part";
    ScaleTemperature, "scale-temperature", WARMTH, "temperature-of-the-scales";
    ScaleExpansion, "scale-expansion", WARMTH, "expansion-of-the-scales";
    HistoryFilter, "history-filter", PAGE, "filter-of-the-history";
    RowsFilter, "history-filter", AT_TIMES, "filter-of-a-large-file";
}

rows! {
    FitField:
    Callout, "fit-callout", PAGE, "fit-of-hole-and-shaft";
    HoleMeasured, "fit-hole-measured", PAGE, "measured-hole";
    ShaftMeasured, "fit-shaft-measured", PAGE, "measured-shaft";
    Temperature, "fit-temperature", PAGE, "temperature-of-both-parts";
    HoleExpansion, "fit-hole-expansion", PAGE, "expansion-of-the-hole";
    ShaftExpansion, "fit-shaft-expansion", PAGE, "expansion-of-the-shaft";
    PressLength, "fit-press-length", PAGE, "length-of-the-joint";
    HubOuter, "fit-hub-outer", PAGE, "outer-diameter-of-the-hub";
    ShaftBore, "fit-shaft-bore", PAGE, "bore-of-the-shaft";
    WantedMinimum, "fit-wanted-minimum", PAGE, "minimum-of-the-clearance";
    WantedMaximum, "fit-wanted-maximum", PAGE, "maximum-of-the-clearance";
}

rows! {
    ReportsField:
    Title, "reports-page-title", PAGE, "title-of-the-report";
    Order, "report-order", PAGE, "order-of-the-report";
    Customer, "report-customer", PAGE, "customer";
    Revision, "report-revision", PAGE, "revision";
    Batch, "report-batch", PAGE, "batch";
    Instrument, "report-instrument", PAGE, "instrument";
    Calibrated, "report-calibrated", PAGE, "calibration-of-the-instrument";
}

rows! {
    PairingField:
    Wanted, "pairing-page-wanted", PAGE, "wanted-clearance-or-fit";
    Groups, "pairing-page-groups", PAGE, "groups";
}

rows! {
    TablesField:
    Filter, "tables-filter", PAGE, "filter-of-the-table";
    CellUpper, "tables-upper", AT_TIMES, "upper-deviation-of-the-cell";
    CellLower, "tables-lower", AT_TIMES, "lower-deviation-of-the-cell";
    Classes, "tables-classes", PAGE, "classes-to-add";
    To, "tables-up-to", PAGE, "largest-size";
}

rows! {
    BudgetField:
    Size, "budget-page-size", PAGE, "measured-size";
    Touches, "budget-page-touches", AT_TIMES, "number-of-contacts";
    Step, "budget-page-step", AT_TIMES, "step";
    Day, "budget-page-day", PAGE, "day";
    HeadName, "budget-head-name", AT_TIMES, "name-of-the-budget";
    HeadBy, "budget-head-by", AT_TIMES, "who-made-the-budget";
    RowName, "budget-row-name", AT_TIMES, "name-of-a-contribution";
    RowValue, "budget-row-half-width", AT_TIMES, "figure-of-a-contribution";
    RowCoverage, "budget-row-k", AT_TIMES, "coverage-factor-of-a-contribution";
    RowAlpha, "budget-row-alpha", AT_TIMES, "expansion-of-a-contribution";
    RowDelta, "budget-row-delta", AT_TIMES, "distance-from-20-c";
    RowTouches, "budget-row-touches", AT_TIMES, "contacts-of-a-contribution";
    RowStep, "budget-row-step", AT_TIMES, "step-of-a-contribution";
    RowSensitivity, "budget-row-sensitivity", AT_TIMES, "sensitivity";
    RowFreedom, "budget-row-freedom", AT_TIMES, "degrees-of-freedom";
}

rows! {
    WalkField:
    Serial, "walk-page-serial", AT_TIMES, "serial-number-of-the-part";
    Value, "walk-page-value", AT_TIMES, "value-of-the-feature";
    Reason, "walk-page-reason", AT_TIMES, "reason-to-skip";
    Cause, "walk-page-alarm-cause", AT_TIMES, "cause-of-an-alarm";
    Action, "walk-page-alarm-action", AT_TIMES, "action-after-an-alarm";
}

rows! {
    HeadField:
    Part, "parts-page-head-part", AT_TIMES, "part-of-the-plan";
    Drawing, "parts-page-head-drawing", AT_TIMES, "drawing-of-the-plan";
    Picture, "parts-page-head-picture", AT_TIMES, "picture-of-the-plan";
    Material, "parts-page-head-material", AT_TIMES, "material-of-the-plan";
    Rule, "parts-page-head-rule", AT_TIMES, "rule-of-the-plan";
    Uncertainty, "parts-page-head-u-um", AT_TIMES, "uncertainty-of-the-plan";
    TravelX, "parts-page-head-travel-x", AT_TIMES, "travel-x";
    TravelY, "parts-page-head-travel-y", AT_TIMES, "travel-y";
    TravelZ, "parts-page-head-travel-z", AT_TIMES, "travel-z";
    Remark, "parts-page-head-remark", AT_TIMES, "remark-of-the-plan";
}

rows! {
    RecordsField:
    Question, "records-page-question", PAGE, "find-records";
    Filter, "records-page-filter-value", AT_TIMES, "value-of-a-filter";
    Who, "records-page-new-name", AT_TIMES, "another-name";
    Server, "records-page-server-address", AT_TIMES, "address-of-the-server";
    Reason, "records-page-reason", AT_TIMES, "reason-of-a-correction";
    Part, "head-part", AT_TIMES, "corrected-part";
    Serial, "records-page-serial", AT_TIMES, "corrected-serial-number";
    Feature, "records-page-feature", AT_TIMES, "corrected-feature";
    Measurer, "records-page-who", AT_TIMES, "corrected-name";
    Remark, "records-page-remark", AT_TIMES, "corrected-remark";
    Measured, "measured-value", AT_TIMES, "corrected-value";
    Callout, "callout", AT_TIMES, "corrected-callout";
}

rows! {
    StatisticsField:
    Question, "statistics-page-question", PAGE, "records-of-the-statistics";
    Last, "statistics-page-last", PAGE, "number-of-values";
    Size, "statistics-page-size", AT_TIMES, "values-of-a-point";
    Pause, "statistics-page-pause", AT_TIMES, "pause-between-points";
    Reason, "statistics-page-reason", AT_TIMES, "reason-to-leave-a-point-out";
    StudyLower, "statistics-study-lower", AT_TIMES, "lower-limit-of-a-study";
    StudyUpper, "statistics-study-upper", AT_TIMES, "upper-limit-of-a-study";
    StudyReference, "statistics-study-reference", AT_TIMES, "calibrated-size";
    StudyResolution, "statistics-study-resolution", AT_TIMES, "step-of-the-display";
}

rows! {
    HelpField:
    Search, "help-page-search", PAGE, "search-the-manual";
}

rows! {
    SettingsField:
    Find, "settings-page-find", PAGE, "find-a-setting";
    NewPin, "operator-pin", AT_TIMES, "pin";
    Pin, "operator-pin", AT_TIMES, "pin-to-leave";
    GaugeName, "gauges-name", AT_TIMES, "name-of-a-gauge";
    GaugePort, "gauges-port", AT_TIMES, "port-of-a-gauge";
    GaugeSpeed, "gauges-speed", AT_TIMES, "speed-of-a-gauge";
    GaugeGave, "gauges-gave", AT_TIMES, "what-a-line-gave";
    Company, "settings-page-company", AT_TIMES, "company-on-reports";
    CompanyAddress, "settings-page-company-address", AT_TIMES, "address-on-reports";
    CompanyLogo, "settings-page-company-logo", AT_TIMES, "logo-on-reports";
}

rows! {
    Input:
    Size, "nominal-size", AT_TIMES, "input-of-the-program";
    Class, "tolerance-class", AT_TIMES, "input-of-the-program";
    CentreX, "centre-x", AT_TIMES, "input-of-the-program";
    CentreY, "centre-y", AT_TIMES, "input-of-the-program";
    Height, "height-z", AT_TIMES, "input-of-the-program";
    Angle, "first-contact", AT_TIMES, "input-of-the-program";
    Clearance, "clearance", AT_TIMES, "input-of-the-program";
}

rows! {
    WorkpieceField:
    CentreX, "workpiece-centre-1", AT_TIMES, "centre-1st-axis";
    CentreY, "workpiece-centre-2", AT_TIMES, "centre-2nd-axis";
    Diameter, "true-diameter", AT_TIMES, "diameter-of-the-workpiece";
    Ovality, "ovality", AT_TIMES, "ovality-of-the-workpiece";
    OvalityAngle, "workpiece-ovality-angle", AT_TIMES, "ovality-angle";
    LobeCount, "lobes", AT_TIMES, "lobes-of-the-workpiece";
    LobeHeight, "lobe-height", AT_TIMES, "lobe-height-of-the-workpiece";
    LobeAngle, "workpiece-lobe-angle", AT_TIMES, "lobe-angle";
    PointX, "workpiece-point-x", AT_TIMES, "point-x";
    PointY, "workpiece-point-y", AT_TIMES, "point-y";
    PointZ, "workpiece-point-z", AT_TIMES, "point-z";
    NormalX, "workpiece-normal-x", AT_TIMES, "normal-x";
    NormalY, "workpiece-normal-y", AT_TIMES, "normal-y";
    NormalZ, "workpiece-normal-z", AT_TIMES, "normal-z";
    WaveHeight, "workpiece-wave-height", AT_TIMES, "wave-amplitude";
    WaveLength, "workpiece-wave-length", AT_TIMES, "wave-length";
    WaveX, "workpiece-wave-x", AT_TIMES, "wave-direction-x";
    WaveY, "workpiece-wave-y", AT_TIMES, "wave-direction-y";
    WaveZ, "workpiece-wave-z", AT_TIMES, "wave-direction-z";
    Deviation, "workpiece-deviation", AT_TIMES, "deviation-along-the-normal";
    Radius, "workpiece-radius", AT_TIMES, "radius-of-the-surface";
    Width, "workpiece-width", AT_TIMES, "width";
    FirstLength, "workpiece-length-1", AT_TIMES, "1st-length";
    SecondLength, "workpiece-length-2", AT_TIMES, "2nd-length";
    Angle, "workpiece-angle", AT_TIMES, "angle-of-the-walls";
    SurfaceScatter, "surface-scatter", AT_TIMES, "surface-scatter-of-the-workpiece";
    BallRadius, "workpiece-ball", AT_TIMES, "ball-radius";
    TriggerScatter, "workpiece-trigger", AT_TIMES, "trigger-scatter";
    CalibrationError, "workpiece-calibration", AT_TIMES, "calibration-error";
    OffsetX, "workpiece-offset-x", AT_TIMES, "offset-of-the-ball-x";
    OffsetY, "workpiece-offset-y", AT_TIMES, "offset-of-the-ball-y";
    LobingCount, "workpiece-lobing-count", AT_TIMES, "lobes-of-the-pre-travel";
    LobingHeight, "workpiece-lobing", AT_TIMES, "pre-travel-amplitude";
    LobingAngle, "workpiece-lobing-angle", AT_TIMES, "pre-travel-angle";
    Seed, "seed", AT_TIMES, "seed-of-the-workpiece";
    Temperature, "workpiece-temperature", AT_TIMES, "workpiece-temperature";
    Expansion, "workpiece-expansion", AT_TIMES, "expansion-of-the-workpiece";
}

/// The paragraph of a parameter of a cycle.
const fn of_meaning(meaning: Meaning) -> &'static str {
    match meaning {
        Meaning::Centre(_) | Meaning::SecondCentre(_) => "nominal-centre",
        Meaning::CentreTolerance(_) => "tolerance-of-the-centre",
        Meaning::Diameter | Meaning::SecondDiameter | Meaning::Side(_) | Meaning::Width => "nominal-length",
        Meaning::MaximumDiameter
        | Meaning::MinimumDiameter
        | Meaning::MaximumSide(_)
        | Meaning::MinimumSide(_)
        | Meaning::MaximumWidth
        | Meaning::MinimumWidth => "limits-of-the-size",
        Meaning::Start(_) | Meaning::FirstPoint(_) | Meaning::SecondPoint(_) => "starting-point",
        Meaning::Shift => "shift-of-the-second-measurement",
        Meaning::StartDiameter => "starting-diameter",
        Meaning::FirstAngle => "starting-angle",
        Meaning::Step | Meaning::Arc => "stepping-angle",
        Meaning::Path => "probing-path",
        Meaning::Difference => "difference-of-two-contacts",
        Meaning::MeasuringHeight | Meaning::SecondHeight => "measuring-height",
        Meaning::SetUpClearance | Meaning::ClearanceHeight | Meaning::Retract => "safe-distances",
        Meaning::Point(_) | Meaning::NextPoint(_) => "measured-point",
        Meaning::MaximumCoordinate | Meaning::MinimumCoordinate => "limits-of-the-coordinate",
        Meaning::Normal(_) => "surface-normal",
        Meaning::Band => "tolerance-band",
        Meaning::MoveToClearance | Meaning::ClearanceMode | Meaning::Traverse => "way-between-contacts",
        Meaning::ContactCount => "contacts-of-the-circle",
        Meaning::Plane
        | Meaning::InsideOutside
        | Meaning::Geometries
        | Meaning::MeasuredAxis
        | Meaning::AxisOfPlane
        | Meaning::Direction
        | Meaning::DirectedAxis => "choice-of-what-is-measured",
        Meaning::Log | Meaning::Stop | Meaning::StopOnUndersize | Meaning::StopOnScrap => "measuring-log-and-stop",
        Meaning::Tool => "tool-for-monitoring",
        Meaning::ToolAxisProbing | Meaning::ToolAxisPoint(_) => "probe-axis-of-a-datum-cycle",
        Meaning::NewDatum(_) | Meaning::NewCoordinate | Meaning::PresetCorrection => "new-datum",
        Meaning::AlignedAngle
        | Meaning::CompensationAxis
        | Meaning::ZeroAfterAlignment
        | Meaning::RotaryAlignment
        | Meaning::RotationTransfer => "new-rotation",
        Meaning::TableRow | Meaning::Transfer => "table-of-the-datum",
        Meaning::Length | Meaning::Angle | Meaning::Choice | Meaning::Number => "other-parameter",
    }
}

/// A field of the program page that is no input of 8255.
const fn of_program(field: ProgramField) -> Option<FieldRow> {
    let (name, place, paragraph) = match field {
        ProgramField::Input(_) | ProgramField::Tool(_) => return None,
        ProgramField::Diameter => ("true-diameter", AT_TIMES, "diameter-of-the-measured-part"),
        ProgramField::WorkpieceX => ("program-page-workpiece-x", AT_TIMES, "actual-centre-x"),
        ProgramField::WorkpieceY => ("program-page-workpiece-y", AT_TIMES, "actual-centre-y"),
        ProgramField::Filter => ("program-page-filter", PAGE, "filter-of-the-parameters"),
        ProgramField::Name => ("program-page-set", AT_TIMES, "parameter-to-start-with"),
        ProgramField::Value => ("program-page-value", AT_TIMES, "value-to-start-with"),
    };
    Some(FieldRow { name, place, paragraph })
}

/// Every field, with those of the parameters of a cycle.
pub(super) fn all(cycle: &'static Cycle) -> Vec<Field> {
    fn of<F: Rows + Copy + Into<Field>>() -> impl Iterator<Item = Field> {
        F::ALL.iter().map(|field| (*field).into())
    }
    let cycles = cycle.parameters.iter().map(|parameter| CycleField::Parameter(parameter.key));
    let cycles = cycles.chain(Axis::ALL.map(CycleField::Position)).map(Field::from);
    let head = HeadField::ALL.map(PlanField::Head).into_iter().chain([PlanField::Cell]).map(Field::from);
    let inputs = Input::ALL.map(ProgramField::Input).into_iter();
    let program = inputs.chain([ProgramField::Diameter, ProgramField::WorkpieceX, ProgramField::WorkpieceY]).chain([
        ProgramField::Tool(Parameter::q(330)),
        ProgramField::Filter,
        ProgramField::Name,
        ProgramField::Value,
    ]);
    of::<CheckField>()
        .chain(of::<WalkField>())
        .chain(head)
        .chain(of::<RecordsField>())
        .chain(of::<StatisticsField>())
        .chain(of::<ReportsField>())
        .chain(of::<FitField>())
        .chain(of::<PairingField>())
        .chain(of::<TablesField>())
        .chain(cycles)
        .chain(program.map(Field::from))
        .chain(of::<BudgetField>())
        .chain(of::<HelpField>())
        .chain(of::<SettingsField>())
        .chain(of::<WorkpieceField>())
        .collect()
}

impl Field {
    /// Its row; none for a cell of the plan, a parameter of a cycle and a tool, which are named by what they belong to.
    pub(super) fn row(self) -> Option<FieldRow> {
        Some(match self {
            Self::Check(field) => field.row(),
            Self::Parts(PartsField::Walk(field)) => field.row(),
            Self::Parts(PartsField::Plan(PlanField::Head(field))) => field.row(),
            Self::Records(field) => field.row(),
            Self::Statistics(field) => field.row(),
            Self::Reports(field) => field.row(),
            Self::Fit(field) => field.row(),
            Self::Pairing(field) => field.row(),
            Self::Tables(field) => field.row(),
            Self::Program(ProgramField::Input(input)) => input.row(),
            Self::Program(field) => return of_program(field),
            Self::Budget(field) => field.row(),
            Self::Help(field) => field.row(),
            Self::Settings(field) => field.row(),
            Self::Workpiece(field) => field.row(),
            Self::Parts(PartsField::Plan(PlanField::Cell)) | Self::Cycles(_) => return None,
        })
    }

    /// The page that it belongs to; the simulated workpiece belongs to the cycles page first.
    pub const fn page(self) -> Page {
        match self {
            Self::Check(_) => Page::Check,
            Self::Parts(_) => Page::Parts,
            Self::Records(_) => Page::Records,
            Self::Statistics(_) => Page::Statistics,
            Self::Reports(_) => Page::Reports,
            Self::Fit(_) => Page::Fit,
            Self::Pairing(_) => Page::Pairing,
            Self::Tables(_) => Page::Tables,
            Self::Cycles(_) | Self::Workpiece(_) => Page::Cycles,
            Self::Program(_) => Page::Program,
            Self::Budget(_) => Page::Budget,
            Self::Help(_) => Page::Help,
            Self::Settings(_) => Page::Settings,
        }
    }

    /// Its place in the manual; `cycle` says what a parameter means.
    pub(super) fn help(self, cycle: &Cycle) -> HelpPlace {
        let paragraph = match self {
            Self::Cycles(CycleField::Parameter(key) | CycleField::Global(key)) => {
                cycle.parameter(key).map_or("other-parameter", |parameter| of_meaning(parameter.meaning))
            }
            Self::Cycles(CycleField::Position(_)) => "position-of-the-ball",
            Self::Program(ProgramField::Tool(_)) => "tool-to-be-monitored",
            field => field.row().map_or("cell-of-the-plan", |row| row.paragraph),
        };
        HelpPlace::at(MANUAL, paragraph)
    }
}
