//! The palette: everything that can be done, and every page and recent file, found by any of their names in any language. A callout that
//! is typed there is understood.
//!
//! | file | what |
//! |---|---|
//! | here | what is open: the query, its entries, the highlighted one |
//! | `command` | what can be done with it |
//! | `entry` | one entry, and every one that there is |
//! | `matching` | which entries a query finds, the best first |

mod command;
mod entry;
mod matching;

use fitcheck_core::words::Words;

pub use command::PaletteCommand;
pub use entry::{PaletteEntry, PaletteGroup};

use self::entry::{Does, all};
use super::Session;
use super::command::Command;
use super::step::Step;

/// How many entries a page of the list has.
const PAGE: usize = 8;

/// The open palette.
#[derive(Debug)]
pub struct Palette {
    /// What is searched for.
    pub query: String,
    /// What the query finds, group by group.
    pub found: Vec<PaletteEntry>,
    /// The highlighted entry: Enter does what it stands for.
    pub at: usize,
    /// Everything that can be found.
    all: Vec<PaletteEntry>,
}

impl Palette {
    pub(super) fn open(session: &Session) -> Self {
        let mut palette = Self { query: String::new(), found: Vec::new(), at: 0, all: all(session) };
        palette.search(session);
        palette
    }

    fn search(&mut self, session: &Session) {
        let words = Words::new(session.language());
        let callout = entry::of_callout(&self.query, session, &words);
        self.found = callout.into_iter().chain(matching::found(&self.query, &self.all)).collect();
        self.at = 0;
    }

    fn step(&mut self, step: Step) {
        let last = self.found.len().saturating_sub(1);
        self.at = match step {
            Step::Up => self.at.checked_sub(1).unwrap_or(last),
            Step::Down if self.at == last => 0,
            Step::Down => self.at + 1,
            Step::PageUp => self.at.saturating_sub(PAGE),
            Step::PageDown => (self.at + PAGE).min(last),
            Step::First | Step::Top => 0,
            Step::Last | Step::Bottom => last,
            Step::Left | Step::Right => self.at,
        };
    }
}

impl Session {
    /// Does something with the palette; what its entry stands for comes back, to be done in its order.
    pub(super) fn apply_palette(&mut self, command: PaletteCommand) -> Vec<Command> {
        match command {
            PaletteCommand::Show(is_open) => self.palette = is_open.then(|| Palette::open(self)),
            PaletteCommand::Type(query) => {
                if let Some(mut palette) = self.palette.take() {
                    palette.query = query;
                    palette.search(self);
                    self.palette = Some(palette);
                }
            }
            PaletteCommand::Move(step) => {
                if let Some(palette) = &mut self.palette {
                    palette.step(step);
                }
            }
            PaletteCommand::Do(number) => return self.take_entry(number),
        }
        Vec::new()
    }

    /// The palette closes, and the page of an action is opened before it is done: nothing is changed out of sight.
    fn take_entry(&mut self, number: Option<usize>) -> Vec<Command> {
        let Some(palette) = &self.palette else { return Vec::new() };
        let Some(entry) = palette.found.get(number.unwrap_or(palette.at)).filter(|entry| entry.is_possible) else {
            return Vec::new();
        };
        let commands = match &entry.does {
            Does::Commands(commands) => commands.clone(),
            Does::Action(action) => {
                let page = action.place().page().filter(|page| *page != self.page()).map(Command::OpenPage);
                page.into_iter().chain(action.command(self)).collect()
            }
        };
        self.palette = None;
        commands
    }
}
