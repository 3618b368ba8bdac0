//! Whether a window can be opened at all, and what draws it: one is opened for a frame.

use std::cell::RefCell;
use std::sync::Arc;

use eframe::egui::{Ui, ViewportCommand};
use eframe::glow::HasContext as _;

use super::{KEPT, WindowError, has_no_display, open};

/// A window that closes in its first frame.
struct OneFrame;

impl eframe::App for OneFrame {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        ui.send_viewport_cmd(ViewportCommand::Close);
    }

    fn persist_egui_memory(&self) -> bool {
        false
    }
}

/// What draws the window on this display: its name, where a window can be opened.
pub fn renderer() -> Result<String, WindowError> {
    if has_no_display() {
        return Err(WindowError::NoDisplay);
    }
    let found = RefCell::new(None);
    let opened = open(!KEPT, &|cc| {
        found.replace(Some(name(cc)));
        Ok(Box::new(OneFrame))
    });
    match (opened, found.into_inner()) {
        (Ok(()), Some(renderer)) => Ok(renderer),
        (opened, _) => Err(WindowError::NotOpened { reason: opened.err().unwrap_or_default() }),
    }
}

fn name(cc: &eframe::CreationContext<'_>) -> String {
    #[cfg(feature = "wgpu")]
    if let Some(state) = &cc.wgpu_render_state {
        let adapter = state.adapter.get_info();
        return format!("{} ({})", adapter.name, adapter.backend);
    }
    let opengl = |gl: &Arc<eframe::glow::Context>| {
        let version = gl.version();
        format!("OpenGL {}.{} {}", version.major, version.minor, version.vendor_info)
    };
    cc.gl.as_ref().map_or_else(String::new, opengl)
}
