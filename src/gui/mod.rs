//! The window: draws from the session, returns commands.
//!
//! | file | what |
//! |---|---|
//! | `app` | one frame: panels, commands, effects |
//! | `effects`, `errands`, `reading`, `file_contents` | files, dialogs and the clipboard, off the frame's thread |
//! | `measurements` | files of measurements, and what their columns are taken for |
//! | `gauges`, `sound` | the threads of the ports of gauges, and of the sounds of verdicts |
//! | `renderer` | whether a window can be opened at all, and what draws it |
//! | `rows` | the workers behind the rows of a large file |
//! | `working` | a file that is read or written: how far it is, and how it is stopped |
//! | `store` | the state file |
//! | `crash` | the report that a panic leaves |
//! | `journal` | who keeps and reads records |
//! | `theme` | colours, sizes, fonts |
//! | `operator` | the window for an operator |
//! | `check`, `fit`, `cycles`, `tables`, `program`, `pairing`, `budget`, `records`, `statistics`, `reports`, `parts`, `help`, `settings` | the pages |
//! | `pages`, `page` | the list of the pages; what the window has to know of one |
//! | `over_page`, `palette` | what lies over a page; everything that can be done, found by its name |
//! | `rail`, `top_bar`, `dialogs`, `notices`, `folder_list`, `columns_panel` | what belongs to every page |
//! | `who` | who is measuring |
//! | `templates` | the user's own templates of reports |
//! | `tools` | the tool table on the pages that measure |
//! | `view`, `keys`, `key_names` | actions as buttons, entries of menus and keys |
//! | `zoom` | the scale of the window |
//! | `in_turn` | keys that come faster than frames |
//! | `picture` | pictures of parts become dots |
//! | `printing` | pages are handed to the system's printer |
//! | `pin` | the PIN that locks the operator's window |
//! | `table` | a list of rows with heads |
//! | `columns`, `split`, `room` | three columns, a list with what is open of it, and how both fold |
//! | `spoken` | what a screen reader says of what is drawn |
//! | `empty` | what stands where there is nothing yet |
//! | `card`, `section`, `segments`, `class_chooser`, `field`, `field_help`, `keypad`, `limits`, `material`, `popup`, `shapes`, `verdict_card` | widgets of our own |
//!
//! Nothing here decides anything or computes with lengths; nothing outside names egui.
//!
//! To add a page, begin with the list in `crates/session/src/lib.rs`, and then:
//!
//! 1. Write its folder: `NAME_ui` in `mod.rs`, one file per panel. A panel draws from the session and sends commands.
//!    It declares a list of rows as a `table::Table`, cells under heads as a `table::grid::Grid`, and its answer as a `card`.
//! 2. Say in its `PAGE` how it is drawn, what a file is that is dropped on it, and its group and icon in the rail, and add its line to
//!    `pages.rs`. A new icon is named in `theme/icon.rs`, and the fonts are cut anew (`assets/fonts/README.md`).
//! 3. Carry out its new effects in `effects.rs`: what touches a file or takes long runs off the frame's thread.
//! 4. Add its texts to every folder of `assets/locales`: a file `NAME-page.ftl`, with `page-NAME` for the rail.
//! 5. Test it by label and key in `tests/gui/NAME_page.rs`; add it to `sizes.rs` (every size and language) and, with its picture, to
//!    `readme.rs` there. Both `main.rs` name the files of tests. The name of a page stands in every picture of a whole window: take them
//!    anew (`tests/gui/pictures.rs` says how) and look at them.
//! 6. Describe it in `docs/manual/`, whose `README.md` lists the pages, its keys in `window.md`, and it in `CHANGELOG.md`; add its words to
//!    `docs/TERMS.md`.

mod action_icon;
mod app;
mod budget;
mod card;
mod check;
mod class_chooser;
mod columns;
mod columns_panel;
mod crash;
mod cycles;
mod dialogs;
mod effects;
mod empty;
mod errands;
mod field;
mod field_help;
mod field_id;
mod file_contents;
mod fit;
mod folder_list;
mod gauges;
mod help;
mod in_turn;
pub mod journal;
mod keeping;
mod key_names;
mod keypad;
mod keys;
mod limits;
mod material;
mod measurements;
mod notices;
mod operator;
mod over_page;
mod page;
mod pages;
mod pairing;
mod palette;
mod parts;
mod picture;
mod pin;
mod popup;
mod printing;
mod program;
mod rail;
mod reading;
mod records;
mod renderer;
mod reports;
mod room;
mod rows;
mod section;
mod segments;
mod settings;
mod shapes;
mod sound;
mod split;
mod spoken;
mod statistics;
mod store;
mod table;
mod tables;
mod templates;
mod theme;
mod tools;
mod top_bar;
mod verdict_card;
mod view;
mod watching;
mod who;
mod working;
mod zoom;

pub use app::{App, Setup};
pub use errands::Errands;
pub use renderer::renderer;
pub use store::Store;
pub use theme::install as install_theme;

use std::path::PathBuf;

use eframe::egui::{Vec2, ViewportBuilder};

use crate::message::Say;
use crate::session::Purpose;

/// Why the window could not be opened.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "window", error)]
pub enum WindowError {
    /// There is no display to open a window on.
    NoDisplay,
    /// No renderer could open a window.
    NotOpened {
        /// The system's message.
        reason: String,
    },
}

/// Whether this system names its display in variables, and none of them is set: the first cause, before any message of
/// a renderer.
fn has_no_display() -> bool {
    let is_named_so = cfg!(all(unix, not(any(target_os = "macos", target_os = "ios", target_os = "android"))));
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    is_named_so && !["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"].into_iter().any(is_set)
}

/// The icon of the window, drawn from `assets/icons/fitcheck.svg`.
const ICON: &[u8] = include_bytes!("../../assets/icons/128.png");

fn icon() -> eframe::egui::IconData {
    eframe::icon_data::from_png_bytes(ICON).unwrap_or_else(|error| {
        log::warn!("the window has no icon: {error}");
        eframe::egui::IconData::default()
    })
}

/// Opens the window with these files and runs it until it is closed.
pub fn run(files: &[(Purpose, PathBuf)]) -> Result<(), WindowError> {
    if has_no_display() {
        return Err(WindowError::NoDisplay);
    }
    if let Some(folder) = Store::of_user().folder() {
        crash::watch(folder.to_owned());
    }
    let setup = || Setup { files: files.to_owned(), ..Setup::for_user() };
    let opened = open(KEPT, &|cc| Ok(Box::new(App::new(cc, setup()))));
    opened.map_err(|reason| {
        // Started from a shortcut, it has no console that the reason could be read on.
        #[cfg(windows)]
        rfd::MessageDialog::new().set_title("Fitcheck").set_description(&reason).show();
        WindowError::NotOpened { reason }
    })
}

type NewApp<'app> = dyn Fn(&eframe::CreationContext<'_>) -> Result<Box<dyn eframe::App + 'app>, Box<dyn std::error::Error + Send + Sync>>
    + 'app;

/// Whether place and size of a window are kept for the next one.
const KEPT: bool = true;

/// Opens a window and runs what is made for it: with OpenGL, or, with the feature `wgpu`, by wgpu where OpenGL fails.
fn open<'app>(persist_window: bool, app: &'app NewApp<'app>) -> Result<(), String> {
    let open = |renderer| {
        let viewport = ViewportBuilder::default()
            .with_app_id("fitcheck")
            .with_title("Fitcheck")
            .with_icon(icon())
            .with_inner_size(Vec2::new(1280.0, 800.0))
            .with_min_inner_size(Vec2::new(480.0, 320.0));
        let persistence_path = crate::files::carried_folder().map(|folder| folder.join("app.ron"));
        let options =
            eframe::NativeOptions { viewport, renderer, persistence_path, persist_window, ..Default::default() };
        eframe::run_native("fitcheck", options, Box::new(app))
    };
    let opened = open(eframe::Renderer::Glow);
    #[cfg(not(feature = "wgpu"))]
    return opened.map_err(|error| error.to_string());
    #[cfg(feature = "wgpu")]
    opened.or_else(|first| match first {
        // Neither renderer opens a window on a display that does not answer, and a second try would say only that it is
        // the second.
        eframe::Error::WinitEventLoop(_) => Err(first.to_string()),
        _ => open(eframe::Renderer::Wgpu).map_err(|second| format!("{first}; {second}")),
    })
}
