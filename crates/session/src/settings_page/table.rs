//! The table of settings: every setting of the window is one row here. The settings page and the palette are made from it.

use fitcheck_core::tolerance::Base;
use fitcheck_core::verdict::rules::{Prover, RuleName};
use fitcheck_core::words::{Dialogue, Language};
use fitcheck_exchange::exchange::gauge::LineUnit;
use fitcheck_gauges::{DataBits, Parity, StopBits};

use super::{Section, SettingsAction, SettingsField};
use crate::Session;
use crate::action::{Action, WindowAction};
use crate::check::{CheckField, UncertaintyFrom};
use crate::field::Field;
use crate::gauges::GaugeAction;
use crate::page::Page;
use crate::parts::PartsAction;
use crate::records::{RecordsAction, RecordsField};
use crate::settings::{DecimalSign, Density, Mode, RowHeight, Theme};

/// A setting: a row of the page.
#[derive(Debug, Clone, Copy)]
pub struct Setting {
    pub section: Section,
    /// The id of its name.
    pub name: &'static str,
    /// The id of the line that says what it does.
    pub about: &'static str,
    pub control: Control,
    /// Whether it has an effect now; without one its control is grey.
    pub counts: fn(&Session) -> bool,
}

/// How a setting is set.
#[derive(Debug, Clone, Copy)]
pub enum Control {
    /// One of several choices, and the one of a first start; `None` where the system chooses that.
    OneOf(fn() -> Vec<Action>, Option<Action>),
    /// On or off; off at a first start.
    Switch(Action),
    /// What is in force, and what can be done about it.
    Buttons(Told, &'static [Action]),
    /// A text field and its unit, with what can be done with its text.
    Field(Field, &'static str, &'static [Action]),
    /// The scale of the window.
    Zoom,
    /// How large a millimetre is on the screen.
    Ruler,
    /// Who measures.
    Who,
    /// Which gauge is shown, and what is done about it.
    Gauge(&'static [Action]),
    /// The port of the gauge that is shown, and those of this computer.
    Port(&'static [Action]),
    /// What is in force, and set elsewhere.
    Told(Told),
}

/// What a row says is in force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Told {
    /// Nothing.
    None,
    /// The folder of the user's own tables.
    OwnTables,
    /// The user's own mask.
    OwnMask,
    /// The user's own texts: how many count, and which are refused.
    OwnTexts,
    /// The budget that checks use.
    Budget,
    /// The file of the journal.
    Journal,
    Station,
    /// How many entries the server of the shop lacks.
    Server,
    /// The folder that is watched.
    Watched,
    /// The port of the gauge that is shown.
    GaugePort,
    /// The line that the gauge that is shown was taught with.
    Taught,
    /// How many files are remembered.
    RecentFiles,
    Version,
    Licence,
    /// The file that keeps the settings.
    StateFile,
}

const fn row(section: Section, name: &'static str, about: &'static str, control: Control) -> Setting {
    Setting { section, name, about, control, counts: |_| true }
}

impl Setting {
    const fn when(self, counts: fn(&Session) -> bool) -> Self {
        Self { counts, ..self }
    }
}

const fn action(action: SettingsAction) -> Action {
    Action::Settings(action)
}

const fn gauge(action: GaugeAction) -> Action {
    Action::Settings(SettingsAction::Gauge(action))
}

const fn window(action: WindowAction) -> Action {
    Action::Window(action)
}

/// A field of the check page: what stands there counts for the next check.
const fn of_check(
    section: Section,
    names: (&'static str, &'static str),
    field: CheckField,
    unit: &'static str,
) -> Setting {
    row(section, names.0, names.1, Control::Field(Field::Check(field), unit, &[]))
}

/// Something that stands at the top of reports.
const fn of_company(names: (&'static str, &'static str), field: SettingsField) -> Setting {
    row(Section::Records, names.0, names.1, Control::Field(Field::Settings(field), "", &[]))
}

/// Something of the gauge that is shown.
const fn of_gauge(names: (&'static str, &'static str), control: Control) -> Setting {
    row(Section::Gauges, names.0, names.1, control).when(has_gauge)
}

fn has_gauge(session: &Session) -> bool {
    session.settings_page().gauges.shown().is_some()
}

/// Every setting, in the order of the page.
pub const SETTINGS: &[Setting] = &[
    row(
        Section::General,
        "language",
        "settings-page-language-about",
        Control::OneOf(|| of(Language::all(), SettingsAction::UseLanguage), None),
    ),
    row(
        Section::General,
        "settings-page-own-texts",
        "settings-page-own-texts-about",
        Control::Buttons(Told::OwnTexts, &[action(SettingsAction::LoadTexts), action(SettingsAction::NoOwnTexts)]),
    ),
    row(
        Section::General,
        "operator-mode",
        "operator-mode-about",
        Control::OneOf(|| of(Mode::ALL, SettingsAction::UseMode), Some(action(SettingsAction::UseMode(Mode::Full)))),
    ),
    row(
        Section::General,
        "operator-pin",
        "operator-pin-about",
        Control::Field(
            Field::Settings(SettingsField::NewPin),
            "",
            &[action(SettingsAction::SetPin), action(SettingsAction::RemovePin)],
        ),
    ),
    row(Section::General, "keypad", "settings-page-keypad-about", Control::Switch(window(WindowAction::Keypad))),
    row(Section::General, "sounds", "sounds-about", Control::Switch(action(SettingsAction::Sounds))),
    row(
        Section::General,
        "settings-page-shop",
        "settings-page-shop-about",
        Control::Buttons(Told::None, &[action(SettingsAction::ExportSettings), action(SettingsAction::ImportSettings)]),
    ),
    row(
        Section::Appearance,
        "settings-page-colours",
        "settings-page-colours-about",
        Control::OneOf(|| of(Theme::ALL, WindowAction::UseTheme), Some(window(WindowAction::UseTheme(Theme::System)))),
    ),
    row(Section::Appearance, "settings-page-zoom", "settings-page-zoom-about", Control::Zoom),
    row(Section::Appearance, "ruler", "ruler-about", Control::Ruler),
    row(
        Section::Appearance,
        "density",
        "settings-page-density-about",
        Control::OneOf(
            || of(Density::ALL, WindowAction::UseDensity),
            Some(window(WindowAction::UseDensity(Density::ByUse))),
        ),
    ),
    row(
        Section::Appearance,
        "settings-page-rows",
        "settings-page-rows-about",
        Control::OneOf(
            || of(RowHeight::ALL, SettingsAction::UseRows),
            Some(action(SettingsAction::UseRows(RowHeight::Usual))),
        ),
    ),
    row(
        Section::Appearance,
        "settings-page-decimal",
        "settings-page-decimal-about",
        Control::OneOf(
            || of(DecimalSign::ALL, SettingsAction::UseDecimal),
            Some(action(SettingsAction::UseDecimal(DecimalSign::OfLanguage))),
        ),
    ),
    row(
        Section::Rule,
        "limits-from",
        "settings-page-limits-about",
        Control::OneOf(|| of(Base::ALL, WindowAction::UseSource), Some(window(WindowAction::UseSource(Base::Iso286)))),
    ),
    row(Section::Rule, "standard-js-rounded", "settings-page-js-about", Control::Switch(window(WindowAction::RoundJs))),
    row(Section::Rule, "standard-1988", "settings-page-1988-about", Control::Switch(window(WindowAction::Edition1988))),
    row(
        Section::Rule,
        "settings-page-decision-rule",
        "settings-page-decision-rule-about",
        Control::OneOf(
            || of(RuleName::ALL, SettingsAction::UseRule),
            Some(action(SettingsAction::UseRule(RuleName::Simple))),
        ),
    ),
    row(
        Section::Rule,
        "settings-page-prover",
        "settings-page-prover-about",
        Control::OneOf(
            || of([Prover::Supplier, Prover::Customer], SettingsAction::LetProve),
            Some(action(SettingsAction::LetProve(Prover::Supplier))),
        ),
    )
    .when(|session| session.check().asked.worth.judging.rule.takes_prover()),
    row(
        Section::Rule,
        "settings-page-uncertainty-from",
        "settings-page-uncertainty-from-about",
        Control::OneOf(
            || of(UncertaintyFrom::ALL, SettingsAction::TellUncertainty),
            Some(action(SettingsAction::TellUncertainty(UncertaintyFrom::Standard))),
        ),
    ),
    of_check(Section::Rule, ("check-uncertainty", "settings-page-uncertainty-about"), CheckField::Uncertainty, "µm")
        .when(is_typed),
    of_check(Section::Rule, ("coverage-factor", "settings-page-coverage-about"), CheckField::Coverage, "")
        .when(is_typed),
    row(
        Section::Rule,
        "settings-page-budget",
        "settings-page-budget-about",
        Control::Buttons(Told::Budget, &[window(WindowAction::Open(Page::Budget))]),
    ),
    of_check(Section::Rule, ("guard-factor", "settings-page-guard-factor-about"), CheckField::GuardFactor, "× U")
        .when(|session| session.check().asked.worth.judging.rule.takes_factor()),
    of_check(Section::Rule, ("guard-width", "settings-page-guard-width-about"), CheckField::GuardWidth, "µm")
        .when(|session| session.check().asked.worth.judging.rule.takes_width()),
    of_check(
        Section::Rule,
        ("settings-page-part-temperature", "settings-page-part-temperature-about"),
        CheckField::PartTemperature,
        "°C",
    ),
    of_check(
        Section::Rule,
        ("part-expansion", "settings-page-part-expansion-about"),
        CheckField::PartExpansion,
        "10⁻⁶/K",
    ),
    of_check(
        Section::Rule,
        ("settings-page-scale-temperature", "settings-page-scale-temperature-about"),
        CheckField::ScaleTemperature,
        "°C",
    ),
    of_check(
        Section::Rule,
        ("scale-expansion", "settings-page-scale-expansion-about"),
        CheckField::ScaleExpansion,
        "10⁻⁶/K",
    ),
    of_check(Section::Rule, ("clearance", "settings-page-clearance-about"), CheckField::Clearance, "mm"),
    of_check(Section::Rule, ("settings-page-height", "settings-page-height-about"), CheckField::Height, "mm"),
    of_check(Section::Rule, ("first-contact", "settings-page-first-contact-about"), CheckField::FirstAngle, "°"),
    of_check(
        Section::Rule,
        ("centre-tolerance", "settings-page-centre-tolerance-about"),
        CheckField::CentreTolerance,
        "mm",
    ),
    row(
        Section::OwnFiles,
        "settings-page-own-tables",
        "settings-page-own-tables-about",
        Control::Buttons(Told::OwnTables, &[window(WindowAction::LoadTables), window(WindowAction::NoOwnTables)]),
    ),
    row(
        Section::OwnFiles,
        "settings-page-mask",
        "settings-page-mask-about",
        Control::OneOf(
            || of(std::iter::once(None).chain(Dialogue::ALL.map(Some)), SettingsAction::UseMask),
            Some(action(SettingsAction::UseMask(None))),
        ),
    ),
    row(
        Section::OwnFiles,
        "settings-page-own-mask",
        "settings-page-own-mask-about",
        Control::Buttons(Told::OwnMask, &[window(WindowAction::LoadMask)]),
    ),
    row(
        Section::OwnFiles,
        "settings-page-columns",
        "settings-page-columns-about",
        Control::Buttons(Told::None, &[window(WindowAction::ImportColumns)]),
    ),
    row(Section::Records, "settings-page-journal", "settings-page-journal-about", Control::Told(Told::Journal)),
    row(Section::Records, "records-page-who", "settings-page-who-about", Control::Who),
    row(Section::Records, "settings-page-station", "settings-page-station-about", Control::Told(Told::Station)),
    of_company(("settings-page-company", "settings-page-company-about"), SettingsField::Company),
    of_company(("settings-page-company-address", "settings-page-company-address-about"), SettingsField::CompanyAddress),
    of_company(("settings-page-company-logo", "settings-page-company-logo-about"), SettingsField::CompanyLogo),
    row(
        Section::ShopServer,
        "settings-page-server",
        "settings-page-server-about",
        Control::Field(
            Field::Records(RecordsField::Server),
            "",
            &[Action::Records(RecordsAction::TakeServer), Action::Records(RecordsAction::LeaveServer)],
        ),
    )
    .when(|session| session.recording().is_on()),
    row(
        Section::ShopServer,
        "settings-page-sent",
        "settings-page-sent-about",
        Control::Buttons(Told::Server, &[Action::Records(RecordsAction::SendAgain)]),
    ),
    row(
        Section::Gauges,
        "gauges-gauge",
        "gauges-gauge-about",
        Control::Gauge(&[gauge(GaugeAction::Add), gauge(GaugeAction::Remove)]),
    ),
    of_gauge(("gauges-name", "gauges-name-about"), Control::Field(Field::Settings(SettingsField::GaugeName), "", &[])),
    of_gauge(
        ("gauges-port", "gauges-port-about"),
        Control::Port(&[gauge(GaugeAction::Connect), gauge(GaugeAction::FindPorts)]),
    ),
    of_gauge(
        ("gauges-speed", "gauges-speed-about"),
        Control::Field(Field::Settings(SettingsField::GaugeSpeed), "Bd", &[]),
    ),
    of_gauge(
        ("gauges-bits", "gauges-bits-about"),
        Control::OneOf(|| DataBits::ALL.map(|of| gauge(GaugeAction::UseBits(of))).to_vec(), None),
    ),
    of_gauge(
        ("gauges-parity", "gauges-parity-about"),
        Control::OneOf(|| Parity::ALL.map(|of| gauge(GaugeAction::UseParity(of))).to_vec(), None),
    ),
    of_gauge(
        ("gauges-stop", "gauges-stop-about"),
        Control::OneOf(|| StopBits::ALL.map(|of| gauge(GaugeAction::UseStop(of))).to_vec(), None),
    ),
    of_gauge(
        ("gauges-unit", "gauges-unit-about"),
        Control::OneOf(|| LineUnit::ALL.map(|of| gauge(GaugeAction::UseUnit(of))).to_vec(), None),
    )
    .when(|session| session.settings_page().gauges.shown().is_some_and(|gauge| gauge.saved.taught.is_none())),
    of_gauge(
        ("gauges-gave", "gauges-gave-about"),
        Control::Field(
            Field::Settings(SettingsField::GaugeGave),
            "mm",
            &[gauge(GaugeAction::Teach), gauge(GaugeAction::Forget)],
        ),
    ),
    of_gauge(("gauges-taught", "gauges-taught-about"), Control::Told(Told::Taught)),
    row(
        Section::Folders,
        "settings-page-watched",
        "settings-page-watched-about",
        Control::Buttons(
            Told::Watched,
            &[Action::Parts(PartsAction::WatchFolder), Action::Parts(PartsAction::StopWatch)],
        ),
    ),
    row(
        Section::Folders,
        "recent-files",
        "settings-page-recent-about",
        Control::Buttons(Told::RecentFiles, &[window(WindowAction::ForgetRecent)]),
    ),
    row(Section::About, "settings-page-version", "settings-page-version-about", Control::Told(Told::Version)),
    row(
        Section::About,
        "settings-page-licence",
        "settings-page-licence-about",
        Control::Buttons(Told::Licence, &[action(SettingsAction::ShowLicences)]),
    ),
    row(Section::About, "settings-page-state-file", "settings-page-state-file-about", Control::Told(Told::StateFile)),
    row(Section::About, "settings-page-journal-file", "settings-page-journal-file-about", Control::Told(Told::Journal)),
];

/// An action for each value of a list.
fn of<T, A: Into<Action>>(values: impl IntoIterator<Item = T>, action: fn(T) -> A) -> Vec<Action> {
    values.into_iter().map(|value| action(value).into()).collect()
}

/// Whether the uncertainty is typed, and no budget is asked.
fn is_typed(session: &Session) -> bool {
    session.check().asked.worth.judging.from != UncertaintyFrom::Budget
}

/// The setting that an action is a choice of; `None` where it sets nothing.
pub(crate) fn setting_of(action: Action) -> Option<&'static Setting> {
    SETTINGS.iter().find(|setting| match setting.control {
        Control::OneOf(choices, _) => choices().contains(&action),
        Control::Switch(of) => of == action,
        Control::Zoom => matches!(
            action,
            Action::Settings(SettingsAction::ZoomOut | SettingsAction::ZoomIn | SettingsAction::ZoomNormal)
        ),
        Control::Buttons(Told::OwnTables | Told::OwnMask | Told::OwnTexts, actions) => actions.contains(&action),
        Control::Buttons(..)
        | Control::Ruler
        | Control::Field(..)
        | Control::Who
        | Control::Gauge(_)
        | Control::Port(_)
        | Control::Told(_) => false,
    })
}
