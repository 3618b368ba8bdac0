//! The window: draws from the session, returns commands.
//!
//! | file | what |
//! |---|---|
//! | `app` | one frame: panels, commands, effects |
//! | `effects` | files, dialogs and the clipboard, off the frame's thread |
//! | `store` | the state file |
//! | `theme` | colours, sizes, fonts |
//! | `top_bar`, `fit_panel`, `band_plot`, `contacts_plot`, `answer_panel`, `status_panel`, `history_panel`, `dialogs` | the parts of the check page |
//! | `class_chooser`, `field`, `keypad`, `shapes` | widgets of our own |
//!
//! No decision and no arithmetic on lengths happens here; egui is named nowhere else.

mod answer_panel;
mod app;
mod band_plot;
mod class_chooser;
mod contacts_plot;
mod dialogs;
mod effects;
mod field;
mod fit_panel;
mod history_panel;
mod keypad;
mod shapes;
mod status_panel;
mod store;
mod theme;
mod top_bar;
mod view;

pub use app::{App, Setup};
pub use effects::Errands;
pub use store::Store;
pub use theme::install as install_theme;

use eframe::egui::{Vec2, ViewportBuilder};

/// Why the window could not be opened.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum WindowError {
    /// Neither renderer could open a window.
    #[error("the window cannot be opened: {reason}; the command line works without a display, see fitcheck --help")]
    NotOpened {
        /// What the system says.
        reason: String,
    },
}

/// Opens the window and runs it until it is closed: OpenGL first, wgpu where there is none.
pub fn run() -> Result<(), WindowError> {
    let open = |renderer| {
        let viewport = ViewportBuilder::default()
            .with_app_id("fitcheck")
            .with_title("Fitcheck")
            .with_inner_size(Vec2::new(1280.0, 800.0))
            .with_min_inner_size(Vec2::new(1024.0, 600.0));
        let options = eframe::NativeOptions { viewport, renderer, ..Default::default() };
        eframe::run_native("fitcheck", options, Box::new(|cc| Ok(Box::new(App::new(cc, Setup::for_user())))))
    };
    open(eframe::Renderer::Glow).or_else(|first| {
        log::warn!("no window with OpenGL: {first}");
        open(eframe::Renderer::Wgpu).map_err(|error| WindowError::NotOpened { reason: error.to_string() })
    })
}
