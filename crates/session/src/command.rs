//! Every command, and what it asks of the outside world.
//!
//! The list of commands is the window's manual: menu, key, button, test and script all send one of these.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::{Message, OwnTexts};
use fitcheck_core::tolerance::{Base, DeviationTable, iso286};
use fitcheck_core::words::{Dialogue, Language};
use fitcheck_files::FileError;
use fitcheck_nc::control::mask::Mask;

use super::check::CheckCommand;
use super::columns::ColumnsCommand;
use super::field::Field;
use super::files::{DialogId, FilesCommand};
use super::history::ListCommand;
use super::page::{Page, pages};
use super::palette::PaletteCommand;
use super::parts::{PartsCommand, WalkCommand};
use super::purpose::Purpose;
use super::rows::RowsCommand;
use super::ruler::Ruler;
use super::settings::{DecimalSign, Density, Mode, RowHeight, Theme};
use super::settings_page::Section;
use super::tools::ToolsCommand;
use super::workpiece::WorkpieceCommand;
use super::zoom::Zoom;

macro_rules! command {
    ($($(#[$doc:meta])* $page:ident: $folder:ident, $State:ident, $Command:ident, $Field:ident, $Action:ident, $name:literal, $manual:literal;)+) => {
        /// A change of the state.
        #[derive(Debug, Clone)]
        pub enum Command {
            $($(#[$doc])* $page(super::$folder::$Command),)+
            /// Does something with the columns of a file of measurements.
            Columns(ColumnsCommand),
            /// Does something with the simulated workpiece or recorded contacts.
            Workpiece(WorkpieceCommand),
            /// Does something with the tool table.
            Tools(ToolsCommand),
            /// Does something with the palette.
            Palette(PaletteCommand),
            /// Does something with the file dialog, recent files or a file that was written.
            Files(FilesCommand),
            OpenPage(Page),
            /// Goes to a field and selects its text.
            GoTo(Field),
            /// Enter was pressed in a field: does what it is for there, or gives the highlighted answer to what is asked.
            Enter(Field),
            /// The button of an answer to what is asked was pressed; the number is its place among the answers.
            Answer(usize),
            /// Shows or hides the keypad.
            ShowKeypad(bool),
            /// Makes a sound for each verdict, or none.
            UseSounds(bool),
            /// No sound could be played.
            SoundFailed(Message),
            /// Chooses whom the window is for.
            SetMode(Mode),
            /// Says how large a millimetre is on this screen.
            SetRuler(Option<Ruler>),
            /// A file of this name was dropped on the operator's window.
            DroppedOnOperator(String),
            /// Goes on from a verdict that has been read to the next value.
            GoOn,
            /// Changes the language of the window.
            SetLanguage(Language),
            /// Chooses light, dark, or the system's setting.
            SetTheme(Theme),
            /// Chooses how high everything is that is pressed.
            SetDensity(Density),
            /// Chooses how high the rows of lists are.
            SetRows(RowHeight),
            /// Chooses what stands before the decimals of a number.
            SetDecimal(DecimalSign),
            /// Scales the whole window.
            SetZoom(Zoom),
            /// Sets what a section of the settings page has back to what a first start has.
            BackToDefaults(Section),
            /// Shows the first steps on the check page, or hides them.
            Welcome(bool),
            /// A finger touched the window, or a mouse moved over it.
            Touched(bool),
            /// Draws the status window with a built-in mask; `None` is the mask of the language.
            SetMask(Option<Dialogue>),
            /// Asks for a file or a folder.
            OpenDialog(Purpose),
            /// Replaces the path in the dialog.
            TypePath(String),
            /// Shows the system's file dialog.
            Browse,
            /// The system's file dialog answered; `None` when it was cancelled or cannot be shown.
            Picked(Option<PathBuf>),
            /// Does what the dialog is for.
            Confirm,
            /// Closes the dialog or the oldest notice.
            Close,
            /// Closes the notice that is shown, whatever else is open.
            CloseNotice,
            /// Shows or hides what was told before.
            ShowMessages(bool),
            /// Empties the list of what was told before.
            ForgetMessages,
            /// Takes back the change of a setting that a notice tells of.
            SettingBack,
            /// The answer to the question whether unsaved changes may be lost to another document.
            Discard(bool),
            /// Asks whether the window may be closed: at once, unless something has unsaved changes.
            AskToLeave,
            /// Closes the window without saving, or keeps it open.
            Leave(bool),
            /// A mask was read, or not.
            MaskRead {
                path: PathBuf,
                /// The mask and its warnings.
                result: Result<(Box<Mask>, Vec<Message>), Message>,
            },
            /// A folder of tables was read, or not.
            TablesRead {
                folder: PathBuf,
                /// The tables, and warnings.
                result: Result<(Vec<DeviationTable>, Vec<Message>), Message>,
            },
            /// A file of settings was read, or not.
            SettingsRead {
                path: PathBuf,
                result: Result<String, Message>,
            },
            /// Something came from the port of a gauge.
            Heard {
                /// The number of the port.
                run: u64,
                news: fitcheck_gauges::News,
            },
            /// A file of own texts was read, or not.
            TextsRead {
                path: PathBuf,
                result: Result<Arc<OwnTexts>, Message>,
            },
            /// Stops using own texts.
            NoOwnTexts,
            /// Stops using the user's own tables.
            NoOwnTables,
            /// Looks limits up in another source, after the user's own tables.
            UseSource(Base),
            /// Chooses where editions of ISO 286 differ.
            SetStandard(iso286::Options),
            /// The answer to what a dialog asked for: it closes that dialog or shows what is wrong, and leaves any other alone.
            Answered(DialogId, Box<Self>),
            /// A file was written, or not.
            Saved {
                path: PathBuf,
                /// Whether that succeeded.
                result: Result<(), FileError>,
            },
        }

        $(impl From<super::$folder::$Command> for Command {
            fn from(command: super::$folder::$Command) -> Self {
                Self::$page(command)
            }
        })+
    };
}

pages!(command);
from_variants!(Command: Palette(PaletteCommand), Columns(ColumnsCommand), Workpiece(WorkpieceCommand), Tools(ToolsCommand), Files(FilesCommand));

impl From<RowsCommand> for Command {
    fn from(command: RowsCommand) -> Self {
        Self::Check(CheckCommand::Rows(command))
    }
}

impl From<WalkCommand> for Command {
    fn from(command: WalkCommand) -> Self {
        Self::Parts(PartsCommand::Walk(command))
    }
}

impl From<ListCommand> for Command {
    fn from(command: ListCommand) -> Self {
        Self::Check(CheckCommand::List(command))
    }
}
