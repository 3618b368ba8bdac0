//! What can be done on the settings page, and what can be set everywhere and is no action of another page.

use fitcheck_core::verdict::rules::{Prover, RuleName};
use fitcheck_core::words::{Dialogue, Language, Words};

use super::{Section, SettingsCommand, SettingsField};
use crate::Session;
use crate::action::row::{ActionRow, Actions, Sends, actions, everywhere, on};
use crate::action::{ActionScope, Shortcut};
use crate::check::{CheckCommand, UncertaintyFrom, rule_name_id};
use crate::command::Command;
use crate::field::Field;
use crate::gauges::GaugeAction;
use crate::help::{HelpCommand, HelpPlace, HelpTopic};
use crate::page::Page;
use crate::purpose::Purpose;
use crate::ruler::{Ruler, RulerStep};
use crate::settings::{DecimalSign, Mode, RowHeight};
use crate::shared::MaskChoice;
use crate::zoom::Zoom;

actions! {
    /// What can be done on the settings page, and what can be set everywhere.
    SettingsAction

    ShowSection(Section): Section::ALL;
    /// Goes to the field in which settings are looked for.
    FindSetting;
    /// Sets what the shown section has back to what a first start has.
    BackToDefaults;
    /// Takes back the last change of a setting.
    SettingBack;
    /// Writes the settings, for other stations.
    ExportSettings;
    /// Reads such a file.
    ImportSettings;
    /// Opens the manual at what is built in, and its licences.
    ShowLicences;
    /// Chooses whom the window is for.
    UseMode(Mode): Mode::ALL;
    /// Locks the operator's window with a PIN.
    SetPin;
    RemovePin;
    /// Leaves the operator's window.
    LeaveOperator;
    /// Tries the PIN.
    TryPin;
    /// Stays in the operator's window.
    Stay;
    /// Changes the language of the window.
    UseLanguage(Language): Language::all();
    /// Reads a file of own texts.
    LoadTexts;
    /// Stops using own texts.
    NoOwnTexts;
    /// Says that a bank card is longer or shorter on the screen.
    MoveRuler(RulerStep): RulerStep::ALL;
    /// Says nothing of that any more.
    ForgetRuler;
    ZoomOut;
    ZoomIn;
    /// Draws the window as large as the system says.
    ZoomNormal;
    /// Makes a sound for each verdict, or none.
    Sounds;
    /// Chooses what stands before the decimals of a number.
    UseDecimal(DecimalSign): DecimalSign::ALL;
    /// Chooses how high the rows of lists are.
    UseRows(RowHeight): RowHeight::ALL;
    /// Chooses the decision rule.
    UseRule(RuleName): RuleName::ALL;
    /// Says who has to prove.
    LetProve(Prover): [Prover::Supplier, Prover::Customer];
    /// Chooses how the uncertainty is told.
    TellUncertainty(UncertaintyFrom): UncertaintyFrom::ALL;
    /// Does something with the gauges.
    Gauge(GaugeAction): GaugeAction::all();
    /// Draws the status window with a built-in mask; `None` is the mask of the language.
    UseMask(Option<Dialogue>): std::iter::once(None).chain(Dialogue::ALL.map(Some));
}

impl Actions for SettingsAction {
    #[expect(clippy::too_many_lines, reason = "one row for everything that can be done")]
    fn row(&self) -> ActionRow {
        match *self {
            Self::ShowSection(section) => on(Page::Settings, section.name(), SettingsCommand::Show(section)),
            Self::ShowLicences => {
                let place = HelpPlace::of(HelpTopic::Manual("licences.md"));
                everywhere("settings-page-licences", HelpCommand::Open(place).into())
            }
            Self::FindSetting => on(Page::Settings, "settings-page-find", Command::GoTo(SettingsField::Find.into()))
                .key(Shortcut::ctrl('F')),
            Self::BackToDefaults => ActionRow::new(
                ActionScope::Page(Page::Settings),
                "settings-page-defaults",
                Sends::FromState(|session| Command::BackToDefaults(session.settings_page().section)),
            )
            .hint("settings-page-defaults-hint")
            .when(|session| {
                let page = session.settings_page();
                page.found.is_none() && !session.commands_to_defaults(page.section).is_empty()
            }),
            Self::SettingBack => everywhere("settings-page-take-back", Command::SettingBack)
                .when(|session| session.notices().iter().any(|notice| notice.before.is_some())),
            Self::ExportSettings => everywhere("settings-page-export", Command::OpenDialog(Purpose::ExportSettings)),
            Self::ImportSettings => everywhere("settings-page-import", Command::OpenDialog(Purpose::ImportSettings)),
            Self::UseMode(mode) => {
                let text = match mode {
                    Mode::Full => "operator-mode-full",
                    Mode::Operator => "operator-mode-operator",
                };
                everywhere(text, Command::SetMode(mode))
            }
            Self::SetPin => everywhere("operator-pin-use", SettingsCommand::SetPin.into())
                .when(|session| !session.text(SettingsField::NewPin).trim().is_empty()),
            Self::RemovePin => {
                everywhere("operator-pin-remove", SettingsCommand::RemovePin.into()).when(Session::has_pin)
            }
            Self::LeaveOperator => everywhere("operator-leave", SettingsCommand::LeaveOperator.into())
                .when(|session| session.is_for_operators() && !session.settings_page().asks_for_pin()),
            Self::TryPin => everywhere("operator-pin-try", SettingsCommand::TryPin.into())
                .when(|session| session.settings_page().asks_for_pin()),
            Self::Stay => everywhere("operator-stay", SettingsCommand::Stay.into())
                .when(|session| session.settings_page().asks_for_pin()),
            Self::UseLanguage(language) => everywhere("language", Command::SetLanguage(language)),
            Self::LoadTexts => everywhere("load-texts", Command::OpenDialog(Purpose::LoadTexts)),
            Self::NoOwnTexts => {
                everywhere("no-own-texts", Command::NoOwnTexts).when(|session| session.own_texts().is_some())
            }
            Self::MoveRuler(step) => {
                let (text, command): (_, fn(&Session) -> Command) = match step {
                    RulerStep::MuchShorter => ("ruler-much-shorter", |session| moved(session, RulerStep::MuchShorter)),
                    RulerStep::Shorter => ("ruler-shorter", |session| moved(session, RulerStep::Shorter)),
                    RulerStep::Longer => ("ruler-longer", |session| moved(session, RulerStep::Longer)),
                    RulerStep::MuchLonger => ("ruler-much-longer", |session| moved(session, RulerStep::MuchLonger)),
                };
                scaled(text, command)
            }
            Self::ForgetRuler => {
                everywhere("ruler-forget", Command::SetRuler(None)).when(|session| session.ruler().is_some())
            }
            Self::ZoomOut => scaled("settings-page-zoom-out", |session| Command::SetZoom(session.zoom().smaller()))
                .when(|session| Zoom::LEAST < session.zoom()),
            Self::ZoomIn => scaled("settings-page-zoom-in", |session| Command::SetZoom(session.zoom().larger()))
                .when(|session| session.zoom() < Zoom::MOST),
            Self::ZoomNormal => everywhere("settings-page-zoom-normal", Command::SetZoom(Zoom::NORMAL)),
            Self::Sounds => {
                let switched = |session: &Session| Command::UseSounds(!session.has_sounds());
                ActionRow::new(ActionScope::Everywhere, "sounds", Sends::FromState(switched))
            }
            Self::UseDecimal(decimal) => {
                let text = match decimal {
                    DecimalSign::OfLanguage => "settings-page-decimal-of-language",
                    DecimalSign::Point => "settings-page-decimal-point",
                    DecimalSign::Comma => "settings-page-decimal-comma",
                };
                everywhere(text, Command::SetDecimal(decimal))
            }
            Self::UseRows(rows) => {
                let text = match rows {
                    RowHeight::Usual => "settings-page-rows-usual",
                    RowHeight::Close => "settings-page-rows-close",
                };
                everywhere(text, Command::SetRows(rows))
            }
            Self::UseRule(rule) => everywhere("check-rule", CheckCommand::UseRule(rule).into()),
            Self::LetProve(prover) => {
                let text = match prover {
                    Prover::Supplier => "prover-supplier",
                    Prover::Customer => "prover-customer",
                };
                everywhere(text, CheckCommand::LetProve(prover).into())
            }
            Self::TellUncertainty(from) => {
                let text = match from {
                    UncertaintyFrom::Standard => "uncertainty-standard",
                    UncertaintyFrom::Expanded => "uncertainty-expanded",
                    UncertaintyFrom::Budget => "uncertainty-budget",
                };
                everywhere(text, CheckCommand::TellUncertainty(from).into())
            }
            Self::Gauge(action) => action.row(),
            Self::UseMask(language) => everywhere("mask-choice-of-language", Command::SetMask(language)),
        }
    }

    fn name(&self, _session: &Session, words: &Words) -> Option<String> {
        self.listed_name(words)
    }

    fn on_enter(field: Field, _page: Page) -> Option<Self> {
        match field {
            Field::Settings(SettingsField::NewPin) => Some(Self::SetPin),
            Field::Settings(SettingsField::Pin) => Some(Self::TryPin),
            Field::Settings(SettingsField::GaugePort | SettingsField::GaugeSpeed) => {
                Some(Self::Gauge(GaugeAction::Connect))
            }
            Field::Settings(SettingsField::GaugeGave) => Some(Self::Gauge(GaugeAction::Teach)),
            _ => None,
        }
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        let judging = session.check().asked.worth.judging;
        Some(match *self {
            Self::ShowSection(section) => {
                let page = session.settings_page();
                page.found.is_none() && page.section == section
            }
            Self::UseMode(mode) => session.mode() == mode,
            Self::UseLanguage(language) => session.language() == language,
            Self::Sounds => session.has_sounds(),
            Self::UseDecimal(decimal) => session.decimal() == decimal,
            Self::UseRows(rows) => session.rows() == rows,
            Self::UseRule(rule) => judging.rule == rule,
            Self::LetProve(prover) => judging.prover == prover,
            Self::TellUncertainty(from) => judging.from == from,
            Self::UseMask(language) => mask_is(session, language),
            Self::Gauge(action) => return action.is_on(session),
            _ => return None,
        })
    }
}

impl SettingsAction {
    /// Its name, where that comes from a list.
    pub(super) fn listed_name(self, words: &Words) -> Option<String> {
        Some(match self {
            Self::UseLanguage(language) => language.name().to_owned(),
            Self::UseRule(rule) => words.get(rule_name_id(rule)),
            Self::UseMask(Some(language)) => language.name().to_owned(),
            _ => return None,
        })
    }
}

/// The length of a bank card on the screen after a step.
fn moved(session: &Session, step: RulerStep) -> Command {
    Command::SetRuler(Some(session.ruler().unwrap_or(Ruler::USUAL).moved(step)))
}

/// A step from the scale that there is.
fn scaled(text: &'static str, command: fn(&Session) -> Command) -> ActionRow {
    ActionRow::new(ActionScope::Everywhere, text, Sends::FromState(command))
}

/// Whether the status window is drawn with a built-in mask, or with that of the language (`None`).
fn mask_is(session: &Session, language: Option<Dialogue>) -> bool {
    match (session.mask(), language) {
        (MaskChoice::OfLanguage, None) => true,
        (MaskChoice::Shipped(drawn), Some(language)) => *drawn == language,
        _ => false,
    }
}
