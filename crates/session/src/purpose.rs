//! What files are read and written for.

use fitcheck_core::tolerance::Feature;

/// What a file dialog is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Purpose {
    /// Reading measurements.
    Import,
    /// Reading a mask.
    LoadMask,
    /// Reading a folder of tables.
    LoadTables,
    /// Writing the history or the chosen checks in a format of the report's list, by its number there.
    Export(usize),
    /// Writing the status window's text.
    ExportStatus,
    /// Reading one table for the table page.
    OpenTable,
    /// Writing the shown table in a format of the tables' list, by its number there.
    SaveTable(usize),
    /// Reading something for the cycles page.
    OpenCycleFile(CycleFile),
    /// Writing the simulated workpiece.
    SaveWorkpiece,
    /// Writing the measuring log of the cycle that was run.
    SaveCycleLog,
    /// Reading an NC program.
    OpenProgram,
    /// Reading a simulated part of several features.
    OpenPart,
    /// Reading a tool table.
    OpenTools,
    /// Writing the tool table as a run has changed it.
    SaveTools,
    /// Reading an uncertainty budget.
    OpenBudget,
    /// Reading the budget that checks used the last time.
    UseBudget,
    /// Writing the budget of the budget page.
    SaveBudget,
    /// Reading a part plan.
    OpenPlan,
    /// Reading measurements into the part that is walked through, by its number among all that were begun.
    ImportValues(u64),
    /// Reading measurements whose columns are to be seen first.
    AskColumns(ImportInto),
    /// Watching a folder that files are dropped into.
    WatchFolder,
    /// Writing the plan: as TOML, or as CSV.
    SavePlan(usize),
    /// Choosing the picture of a plan.
    OpenPicture,
    /// Reading readings of a calibrated piece.
    OpenReadings,
    /// Reading measured holes or shafts for the pairing page.
    OpenParts(Feature),
    /// Writing the pairs in a format of their list, by its number there.
    SavePairs(usize),
    /// Writing the chosen records in a format of the report's list, by its number there.
    ReportRecords(usize),
    /// Writing the part that is being measured in a format of the report's list, by its number there.
    ReportPart(usize),
}

impl Purpose {
    /// Whether a folder is asked for, and no file.
    pub const fn is_folder(self) -> bool {
        matches!(self, Self::LoadTables | Self::WatchFolder)
    }

    /// Whether something is read; otherwise a file is written.
    pub const fn is_reading(self) -> bool {
        match self {
            Self::Export(_)
            | Self::ExportStatus
            | Self::SaveTable(_)
            | Self::SaveWorkpiece
            | Self::SaveCycleLog
            | Self::SaveTools
            | Self::SaveBudget
            | Self::SavePlan(_)
            | Self::SavePairs(_)
            | Self::ReportRecords(_)
            | Self::ReportPart(_) => false,
            Self::Import
            | Self::LoadMask
            | Self::LoadTables
            | Self::OpenTable
            | Self::OpenCycleFile(_)
            | Self::OpenProgram
            | Self::OpenPart
            | Self::OpenTools
            | Self::OpenBudget
            | Self::OpenPlan
            | Self::OpenPicture
            | Self::ImportValues(_)
            | Self::AskColumns(_)
            | Self::WatchFolder
            | Self::UseBudget
            | Self::OpenReadings
            | Self::OpenParts(_) => true,
        }
    }
}

/// Where measurements of a file go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ImportInto {
    /// The history of the check page.
    History,
    /// The part that is walked through, by its number among all that were begun: it may be another one when the file is read.
    Part(u64),
}

impl ImportInto {
    /// The purpose that reads them there.
    pub const fn purpose(self) -> Purpose {
        match self {
            Self::History => Purpose::Import,
            Self::Part(run) => Purpose::ImportValues(run),
        }
    }
}

/// A file that the cycles page reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CycleFile {
    /// Recorded contacts.
    Contacts,
    /// A simulated workpiece and probe.
    Workpiece,
    /// A touch-probe table.
    Probes,
}
