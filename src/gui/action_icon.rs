//! The icons of actions: what is done often is found by its icon before its word is read.

use super::theme::Icon;
use crate::session::{
    Action, BudgetAction, CheckAction, PairingAction, PartsAction, ProgramAction, RecordsAction, StatisticsAction,
    TablesAction, WindowAction, WorkpieceAction,
};

/// The icon of an action, where it has one.
pub(super) const fn icon_of(action: Action) -> Option<Icon> {
    Some(match action {
        Action::Window(action) => return of_window(action),
        Action::Parts(action) => return of_parts(action),
        Action::Program(action) => return of_program(action),
        Action::Check(CheckAction::CorrectCheck) | Action::Records(RecordsAction::CorrectRecord) => Icon::PencilSimple,
        Action::Records(RecordsAction::MeasureAgain) => Icon::ArrowCounterClockwise,
        Action::Records(RecordsAction::AskForFilter) => Icon::FunnelSimple,
        Action::Records(RecordsAction::VerifyRecords) => Icon::SealCheck,
        Action::Records(RecordsAction::CopyRecords)
        | Action::Pairing(PairingAction::CopyPairs)
        | Action::Check(CheckAction::CopyChecks | CheckAction::CopyStatus) => Icon::Copy,
        Action::Tables(TablesAction::OpenTable)
        | Action::Statistics(StatisticsAction::OpenStudy)
        | Action::Budget(BudgetAction::OpenBudget | BudgetAction::OpenReadings)
        | Action::Pairing(PairingAction::OpenParts(_))
        | Action::Workpiece(
            WorkpieceAction::OpenWorkpiece | WorkpieceAction::OpenContacts | WorkpieceAction::OpenTools,
        ) => Icon::FolderOpen,
        Action::Tables(TablesAction::SaveTable(_))
        | Action::Budget(BudgetAction::SaveBudget)
        | Action::Statistics(StatisticsAction::SaveStudyBudget | StatisticsAction::SaveChart)
        | Action::Pairing(PairingAction::SavePairs(_)) => Icon::FloppyDisk,
        Action::Budget(BudgetAction::AddContribution | BudgetAction::NewBudget)
        | Action::Tables(TablesAction::AddColumns) => Icon::Plus,
        Action::Budget(BudgetAction::RemoveContribution) => Icon::X,
        Action::Tables(TablesAction::UndoEdit) => Icon::ArrowUUpLeft,
        Action::Tables(TablesAction::RedoEdit) => Icon::ArrowUUpRight,
        _ => return None,
    })
}

const fn of_window(action: WindowAction) -> Option<Icon> {
    Some(match action {
        WindowAction::Import => Icon::TrayArrowDown,
        WindowAction::ImportColumns => Icon::Columns,
        WindowAction::LoadTables => Icon::FolderOpen,
        WindowAction::Undo => Icon::ArrowUUpLeft,
        _ => return None,
    })
}

const fn of_parts(action: PartsAction) -> Option<Icon> {
    Some(match action {
        PartsAction::NewPlan => Icon::Plus,
        PartsAction::OpenPlan => Icon::FolderOpen,
        PartsAction::SavePlan(_) => Icon::FloppyDisk,
        PartsAction::UndoPlan => Icon::ArrowUUpLeft,
        PartsAction::RedoPlan => Icon::ArrowUUpRight,
        PartsAction::SizeAgain => Icon::ArrowCounterClockwise,
        PartsAction::SkipSize => Icon::SkipForward,
        PartsAction::NextPart => Icon::ArrowRight,
        PartsAction::ImportValues => Icon::TrayArrowDown,
        PartsAction::SimulateValue => Icon::Play,
        _ => return None,
    })
}

const fn of_program(action: ProgramAction) -> Option<Icon> {
    Some(match action {
        ProgramAction::OpenProgram => Icon::FolderOpen,
        ProgramAction::RunProgram => Icon::Play,
        ProgramAction::PauseProgram => Icon::Pause,
        ProgramAction::StepProgram => Icon::ArrowLineDown,
        ProgramAction::StepOver => Icon::ArrowBendDoubleUpRight,
        ProgramAction::RunToSelected => Icon::CursorText,
        ProgramAction::ResetProgram => Icon::ArrowCounterClockwise,
        _ => return None,
    })
}
