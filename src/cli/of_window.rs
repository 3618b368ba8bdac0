//! What only the window knows of this computer: the command line asks for it, and `main` brings it.

use std::path::PathBuf;

use crate::message::Message;

/// What only the window knows.
#[derive(Debug)]
pub struct OfWindow {
    /// What draws it on this display.
    pub renderer: Result<String, Message>,
    /// What it keeps in its settings.
    pub kept: Result<Kept, Message>,
}

/// What a window keeps in its settings of things around it.
#[derive(Debug, Default)]
pub struct Kept {
    /// Its journal, where it is not the user's own.
    pub journal: Option<PathBuf>,
    /// The address of its server.
    pub server: Option<String>,
    /// The folder of the user's own tables.
    pub tables: Option<PathBuf>,
    /// Its gauges: their names, and their ports.
    pub gauges: Vec<(String, String)>,
}
