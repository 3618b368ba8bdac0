//! The window: draws from the session, returns commands.
//!
//! | file | what |
//! |---|---|
//! | `app` | one frame: panels, commands, effects |
//! | `effects` | files, dialogs and the clipboard, off the frame's thread |
//! | `store` | the state file |
//! | `theme` | colours, sizes, fonts |
//! | `check`, `fit`, `cycles`, `tables`, `program` | the pages |
//! | `top_bar`, `dialogs` | what belongs to every page |
//! | `view`, `keys` | actions as buttons, entries of menus and keys |
//! | `columns` | three columns, and how they fold |
//! | `class_chooser`, `field`, `keypad`, `limits`, `popup`, `shapes`, `verdict_card` | widgets of our own |
//!
//! Nothing here decides anything or computes with lengths; nothing outside names egui.

mod app;
mod check;
mod class_chooser;
mod columns;
mod cycles;
mod dialogs;
mod effects;
mod field;
mod fit;
mod keypad;
mod keys;
mod limits;
mod popup;
mod program;
mod shapes;
mod store;
mod tables;
mod theme;
mod top_bar;
mod verdict_card;
mod view;

pub use app::{App, Setup};
pub use effects::Errands;
pub use store::Store;
pub use theme::install as install_theme;

use eframe::egui::{Vec2, ViewportBuilder};

use crate::message::Say;

/// Why the window could not be opened.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "window", error)]
pub enum WindowError {
    /// No renderer could open a window.
    NotOpened {
        /// The system's message.
        reason: String,
    },
}

/// Opens the window and runs it until it is closed: with OpenGL, or, with the feature `wgpu`, by wgpu where OpenGL
/// fails.
pub fn run() -> Result<(), WindowError> {
    let open = |renderer| {
        let viewport = ViewportBuilder::default()
            .with_app_id("fitcheck")
            .with_title("Fitcheck")
            .with_inner_size(Vec2::new(1280.0, 800.0))
            .with_min_inner_size(Vec2::new(480.0, 320.0));
        let options = eframe::NativeOptions { viewport, renderer, ..Default::default() };
        eframe::run_native("fitcheck", options, Box::new(|cc| Ok(Box::new(App::new(cc, Setup::for_user())))))
    };
    let opened = open(eframe::Renderer::Glow);
    #[cfg(feature = "wgpu")]
    let opened = opened.or_else(|first| {
        log::warn!("no window with OpenGL: {first}");
        open(eframe::Renderer::Wgpu)
    });
    opened.map_err(|error| WindowError::NotOpened { reason: error.to_string() })
}
