//! The list of everything that a user can do.

use fitcheck_core::tolerance::{Base, Feature};
use fitcheck_exchange::exchange::tables::TABLE_FORMATS;
use fitcheck_exchange::journal::query::Column;
use fitcheck_exchange::report::RENDERINGS;
use fitcheck_exchange::report::pairing::FORMATS as PAIR_FORMATS;

use crate::parts::PartsView;
use crate::program::Switch;
use crate::records::Shorthand;
use crate::{Density, MeasureBy, Page, Step, Theme};

/// The list; an action with a value is one action for each of its values.
macro_rules! actions {
    ($($(#[$doc:meta])* $name:ident $(($of:ty): $all:expr)?;)*) => {
        /// Something that a user can do by menu, button or key.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Action {
            $($(#[$doc])* $name $(($of))?,)*
        }

        impl Action {
            /// Every action, in the order of the pages.
            pub fn all() -> impl Iterator<Item = Self> {
                let mut all = Vec::new();
                $(actions!(@add all $name $($all)?);)*
                all.into_iter()
            }
        }
    };
    (@add $list:ident $name:ident) => { $list.push(Self::$name) };
    (@add $list:ident $name:ident $all:expr) => { $list.extend($all.into_iter().map(Self::$name)) };
}

actions! {
    Open(Page): Page::ALL;
    /// Reads measurements.
    Import;
    /// Reads measurements once their columns were seen.
    ImportColumns;
    /// Imports the file whose columns are shown.
    TakeColumns;
    /// Shows the columns of the file that the notice tells of.
    CorrectColumns;
    /// Forgets what was remembered of them.
    ForgetColumns;
    /// Writes the checks in a format of the report's list, by its number there.
    Export(usize): 0..RENDERINGS.len();
    /// Writes the status window's text.
    ExportStatus;
    /// Chooses light, dark, or the system's setting.
    UseTheme(Theme): [Theme::System, Theme::Light, Theme::Dark];
    /// Chooses how high everything is that is pressed.
    UseDensity(Density): Density::ALL;
    /// Looks limits up in a source of the list.
    UseSource(Base): Base::ALL;
    /// Rounds the halves of js, or not.
    RoundJs;
    /// Uses the edition of 1988, or the one of 2010.
    Edition1988;
    /// Reads a folder of the user's own tables.
    LoadTables;
    /// Stops using the user's own tables.
    NoOwnTables;
    /// Reads a mask.
    LoadMask;
    /// Undoes the last change of the history.
    Undo;
    /// Empties the history.
    ClearHistory;
    /// Chooses every listed check that is not good for export.
    ChooseBad;
    ChooseNone;
    /// Shows or hides the keypad.
    Keypad;
    /// Closes what lies over the page: a dialog, a window, the oldest notice.
    Close;
    /// Opens the file that was written in its own program.
    OpenWritten;
    /// Shows the file that was written in its folder.
    ShowWritten;
    /// Empties the list of recent files.
    ForgetRecent;

    /// Shows the system's file dialog.
    Browse;
    /// Shows the folder above.
    FolderUp;
    /// Shows the user's own folder.
    HomeFolder;
    /// Shows all files of the folder, or only those of the kind that is asked for.
    AllFiles;
    /// Goes to another entry of the folder.
    MoveFile(Step): Step::ENTRIES;
    /// Writes over the file that exists.
    ReplaceFile;
    /// Keeps the file that exists.
    KeepFile;

    /// Measures and judges.
    Measure;
    /// Judges a typed value that was asked about, as it is.
    JudgeAnyway;
    /// Takes what a typed value may have been instead of it.
    TakeMeant;
    /// Takes what a doubted text probably means instead of it.
    TakeText;
    /// Judges by a doubted text as it stands.
    KeepText;
    /// Shows another row of the imported file, worst first.
    ShowInLot(Step): Step::PATH;
    ClearResult;
    /// Chooses where the next measurement comes from.
    MeasureBy(MeasureBy): [MeasureBy::Typing, MeasureBy::Simulating];
    /// Puts the status window's text on the clipboard.
    CopyStatus;
    /// Goes to the filter of the history.
    FindInHistory;
    /// Leaves the good checks out of the list.
    OnlyBad;
    /// Sorts the list by a column.
    SortHistory(Column): Column::ALL;
    /// Goes to another check of the list.
    MoveCheck(Step): Step::BLOCKS;
    /// Shows the check again.
    ShowCheck;
    /// Chooses the check for export, or not.
    ChooseCheck;
    /// Chooses every check of the list.
    ChooseAll;
    /// Puts the chosen checks, or the one at which the keys are, on the clipboard.
    CopyChecks;
    /// Shows the history, or the rows of the large file in its place.
    ShowRows(bool): [true, false];
    /// Cancels the run over a large file.
    CancelRows;
    /// Judges the large file once more.
    JudgeRowsAgain;
    /// Forgets the large file.
    CloseRows;
    /// Goes to another row of the large file.
    MoveRow(Step): Step::BLOCKS;
    /// Shows the check of the row.
    ShowRow;
    /// Adds the check of the shown row to the history.
    KeepRow;

    /// Goes to another class of the map.
    MoveClass(Step): Step::CLASSES;
    /// Shows the map of hole classes or of shaft classes.
    ShowClasses(Feature): [Feature::Hole, Feature::Shaft];
    /// Takes one side of the fit to the check page.
    CheckPart(Feature): [Feature::Hole, Feature::Shaft];

    RunCycle;
    /// Clears the result.
    ClearCycle;
    /// Steps along the path.
    StepPath(Step): Step::PATH;
    /// Opens the dialog of the simulated workpiece.
    EditWorkpiece;
    /// Makes a simulated workpiece that suits the page's inputs.
    SuitWorkpiece;
    /// Reads a simulated workpiece.
    OpenWorkpiece;
    /// Writes the simulated workpiece.
    SaveWorkpiece;
    /// Reads recorded contacts.
    OpenContacts;
    /// Reads a tool table.
    OpenTools;
    /// Monitors no tools.
    CloseTools;
    /// Writes the tool table as the run has changed it.
    SaveTools;
    /// Reads a touch-probe table.
    OpenProbes;
    /// Takes the built-in touch-probe table.
    ShippedProbes;
    /// Opens the field for an NC block.
    PasteBlock;
    /// Fills the form from the NC block.
    TakeBlock;
    /// Puts the form as an NC block on the clipboard.
    CopyBlock;
    /// Puts the status window's text on the clipboard.
    CopyCycleStatus;
    /// Puts the results on the clipboard.
    CopyResults;
    /// Writes the measuring log.
    SaveLog;

    /// Reads a table.
    OpenTable;
    /// Writes the shown table in a format of the tables' list, by its number there.
    SaveTable(usize): 0..TABLE_FORMATS.len();
    /// Undoes the last edit of the shown table.
    UndoEdit;
    RedoEdit;
    /// Looks limits up in the shown table first.
    UseTable;
    /// Goes to the filter.
    FindInTable;
    /// Selects the previous cell that differs from ISO 286.
    PreviousDifference;
    /// Selects the next one.
    NextDifference;
    /// Goes to another cell.
    MoveCell(Step): Step::CELLS;
    /// Goes to the fields of the cell.
    EditCell;
    /// Puts the fields into the cell.
    SetCell;
    /// Puts what ISO 286 says into the cell.
    TakeStandard;
    /// Empties the cell.
    EmptyCell;
    /// Adds classes to the shown table.
    AddColumns;
    /// Removes the selected cell's class.
    RemoveColumn;
    /// Makes a table from ISO 286.
    MakeTable;

    /// Reads an NC program.
    OpenProgram;
    /// Reads a simulated part of several features.
    OpenPart;
    RunProgram;
    PauseProgram;
    /// Runs one block.
    StepProgram;
    /// Runs one block, including everything that it calls.
    StepOver;
    /// Runs up to the selected block.
    RunToSelected;
    /// Sets a breakpoint at the selected block, or removes it.
    ToggleBreakpoint;
    /// Goes back to before the first block.
    ResetProgram;
    /// Switches an option of the run on or off.
    Switch(Switch): Switch::ALL;
    /// Goes to another block.
    MoveBlock(Step): Step::BLOCKS;
    /// Gives a parameter a value at the next start.
    GiveValue;

    /// Begins a new uncertainty budget.
    NewBudget;
    /// Reads a budget.
    OpenBudget;
    /// Writes the budget.
    SaveBudget;
    /// Checks use the budget.
    UseBudget;
    /// Checks use no budget any more.
    LeaveBudget;
    /// Evaluates the budget for the contacts of the check that is shown on the check page.
    ContactsOfCheck;
    /// Evaluates the budget for the recorded contacts.
    ContactsRecorded;
    /// Evaluates the budget for its own contacts, or those of the fields.
    OwnContacts;
    /// Reads readings of a calibrated piece.
    OpenReadings;
    /// Takes the checks of the history as readings.
    TakeReadings;
    /// Takes the readings of the budget.
    OwnReadings;

    /// Opens a view of the parts page.
    ShowParts(PartsView): PartsView::ALL;
    /// Begins a new part plan.
    NewPlan;
    /// Reads a plan.
    OpenPlan;
    /// Writes the plan: as TOML, as CSV.
    SavePlan(usize): 0..2;
    /// Takes the last change of the plan back.
    UndoPlan;
    /// Makes it again.
    RedoPlan;
    /// Goes to another cell of the plan.
    MoveInPlan(Step): Step::CELLS;
    /// Selects cells from where the keys are to another cell.
    ExtendInPlan(Step): Step::CELLS;
    /// Types into the cell of the plan.
    EditPlanCell;
    /// Takes what is typed, and goes to the cell below.
    TakePlanCell;
    /// Empties the selected cells of the plan.
    EmptyPlanCells;
    /// Puts the selected cells of the plan on the clipboard.
    CopyPlanCells;
    /// Asks for what is on the clipboard, for the cells of the plan.
    PastePlanCells;
    /// Puts a feature above the cell.
    InsertPlanRow;
    /// Deletes the selected features.
    DeletePlanRows;
    /// Moves the selected features up or down.
    MovePlanRows(Step): [Step::Up, Step::Down];
    /// Sorts the features by the column of the cell.
    SortPlan;
    /// Numbers the features from 1.
    RenumberPlan;
    /// Shows every column of the plan, or those that are used.
    ShowAllColumns;
    /// Goes to what is wrong before the cell.
    PreviousFinding;
    /// Goes to what is wrong after it.
    NextFinding;
    /// Leaves out what could not be read of the plan's file.
    LeaveOutOfPlan;
    /// Puts into a cell of the plan what it should probably hold.
    TakeMeantCell;
    /// Chooses the part's picture.
    ChoosePicture;
    /// Begins a part with the serial number in its field.
    BeginPart;
    /// Counts the serial number up.
    CountUp;
    /// Takes the typed value of the size that is asked for.
    TakeValue;
    /// Takes what the typed value may have been.
    TakeMeantValue;
    /// Measures the feature by its cycle on a perfect part.
    SimulateValue;
    /// Asks once more for the size that is shown.
    SizeAgain;
    /// Of the values of a size that contradict each other the last one counts.
    CountNewest;
    /// Asks why the size is left out.
    SkipSize;
    /// Leaves it out for the reason in its field.
    SkipFor;
    LeaveSkip;
    /// Ends the part; the serial number of the next one is counted up.
    NextPart;
    /// Goes to another size.
    MoveSize(Step): Step::BLOCKS;
    /// Reads measurements into the part.
    ImportValues;
    /// Reads measurements into the part once their columns were seen.
    ImportValuesColumns;
    /// Watches a folder that files are dropped into.
    WatchFolder;
    /// Ends that.
    StopWatch;

    /// Reads measured holes or shafts.
    OpenParts(Feature): [Feature::Hole, Feature::Shaft];
    /// Takes the holes or the shafts of the history.
    HistoryParts(Feature): [Feature::Hole, Feature::Shaft];
    /// Writes the pairs in a format of their list, by its number there.
    SavePairs(usize): 0..PAIR_FORMATS.len();
    /// Goes to another pair.
    MovePair(Step): Step::BLOCKS;
    /// Puts all pairs on the clipboard.
    CopyPairs;

    /// Puts a word into the question to the journal, or takes it out.
    AskRecords(Shorthand): Shorthand::ALL;
    /// Goes to the question.
    FindRecords;
    /// Goes to another record.
    MoveRecord(Step): Step::BLOCKS;
    OpenRecord;
    /// Chooses the record for the report, or not.
    ChooseRecord;
    /// Chooses none.
    ChooseNoRecords;
    /// Takes simulated checks into the report, or leaves them out.
    WithSimulated;
    /// Puts the chosen records, or the one at which the keys are, on the clipboard.
    CopyRecords;
    /// Writes the chosen records in a format of the report's list, by its number there.
    ReportRecords(usize): 0..RENDERINGS.len();
    /// Writes the part that is being measured in a format of the report's list, by its number there.
    ReportPart(usize): 0..RENDERINGS.len();
    /// Stops reading or writing the file that is at work.
    StopWorking;
    /// Goes back to the list.
    CloseRecord;
    /// Takes what the record asked for to the check page.
    MeasureAgain;
    /// Opens the form of a correction.
    CorrectRecord;
    /// Writes the correction.
    SendCorrection;
    /// Closes the form.
    LeaveCorrection;
    /// Takes the record back without another in its place.
    WithdrawRecord;
    /// Walks the chain of the journal.
    VerifyRecords;
    /// Stops that.
    CancelVerify;
    /// Writes again what could not be recorded.
    RecordAgain;
    /// Opens or closes the form for the server of the shop.
    AskForServer;
    /// Sends to the server in the field.
    TakeServer;
    /// Sends to no server any more.
    LeaveServer;
    /// Sends at once, whatever went wrong before.
    SendAgain;
    /// The name in the field measures from now on.
    TakeName;
}
