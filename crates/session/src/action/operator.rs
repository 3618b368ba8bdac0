//! What an operator can do: measure, look at results, read the manual. Everything else is for the full mode.

use super::{Action, WindowAction};
use crate::check::CheckAction;
use crate::parts::PartsAction;
use crate::settings_page::SettingsAction;

/// The report that an operator writes: the one for people.
const FOR_PEOPLE: usize = 0;

impl Action {
    /// Whether an operator has it.
    pub fn is_for_operators(self) -> bool {
        match self {
            Self::Window(WindowAction::Open(page)) => page.is_for_operators(),
            Self::Window(action) => matches!(
                action,
                WindowAction::Help
                    | WindowAction::Undo
                    | WindowAction::Keypad
                    | WindowAction::Close
                    | WindowAction::CloseNotice
                    | WindowAction::Messages
                    | WindowAction::ForgetMessages
                    | WindowAction::RecordAgain
                    | WindowAction::TakeName
                    | WindowAction::StopWorking
            ),
            Self::Check(action) => matches!(
                action,
                CheckAction::Measure
                    | CheckAction::JudgeAnyway
                    | CheckAction::TakeMeant
                    | CheckAction::TakeText
                    | CheckAction::KeepText
            ),
            Self::Parts(action) => matches!(
                action,
                PartsAction::BeginPart
                    | PartsAction::CountUp
                    | PartsAction::TakeValue
                    | PartsAction::TakeMeantValue
                    | PartsAction::SizeAgain
                    | PartsAction::CountNewest
                    | PartsAction::SkipSize
                    | PartsAction::SkipFor
                    | PartsAction::LeaveSkip
                    | PartsAction::NextPart
                    | PartsAction::BeginByOpenPlan
                    | PartsAction::KeepMeasuring
                    | PartsAction::MoveSize(_)
                    | PartsAction::ReportPart(FOR_PEOPLE)
            ),
            Self::Help(_) => true,
            Self::Settings(action) => {
                matches!(action, SettingsAction::LeaveOperator | SettingsAction::TryPin | SettingsAction::Stay)
            }
            _ => false,
        }
    }
}
