//! The palette: everything that can be done, and every page and recent file, found by any of their names in any language. A callout that
//! is typed there is understood.
//!
//! | file | what |
//! |---|---|
//! | here | what is open: the query, its entries, the highlighted one |
//! | `command` | what can be done with it |
//! | `entry` | one entry, and every one that there is |
//! | `matching` | which entries a query finds, the best first |
//! | `records` | what the journal adds when it has answered |
//! | `more` | what else can be done with an entry |

mod command;
mod entry;
mod matching;
mod more;
mod records;

pub use command::PaletteCommand;
pub use entry::{PaletteEntry, PaletteGroup};

use jiff::civil::DateTime;

use self::entry::{Does, all};
use super::Session;
use super::command::Command;
use super::effect::Effect;
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
    /// Whether what else can be done with an entry stands in the place of what was found.
    pub shows_more: bool,
    /// What was found, and what was highlighted there, meanwhile.
    before: (Vec<PaletteEntry>, usize),
    /// The number of the question that the journal was asked.
    run: u64,
    /// Everything that can be found.
    all: Vec<PaletteEntry>,
}

impl Palette {
    pub(super) fn open(session: &Session) -> Self {
        let mut palette = Self {
            query: String::new(),
            found: Vec::new(),
            at: 0,
            shows_more: false,
            before: (Vec::new(), 0),
            run: 0,
            all: all(session),
        };
        palette.search(session);
        palette
    }

    fn search(&mut self, session: &Session) {
        let words = session.shared.words();
        let callout = entry::of_callout(&self.query, session, &words);
        let manual = entry::of_manual_search(&self.query, &words).filter(|_| callout.is_none());
        self.found = callout.into_iter().chain(matching::found(&self.query, &self.all)).chain(manual).collect();
        self.at = 0;
        self.shows_more = false;
    }

    /// What else can be done with the highlighted entry takes the place of what was found, or gives it back.
    fn show_more(&mut self, shows: bool, session: &Session) {
        if shows && !self.shows_more {
            let words = session.shared.words();
            let more = self.found.get(self.at).map_or_else(Vec::new, |entry| more::more(entry, session, &words));
            if !more.is_empty() {
                self.before = (std::mem::replace(&mut self.found, more), self.at);
                (self.shows_more, self.at) = (true, 0);
            }
        } else if !shows && self.shows_more {
            (self.found, self.at) = std::mem::take(&mut self.before);
            self.shows_more = false;
        }
    }

    /// Adds records behind everything else: what is highlighted stays where it is.
    fn add(&mut self, records: Vec<PaletteEntry>) {
        let list = if self.shows_more { &mut self.before.0 } else { &mut self.found };
        list.extend(records);
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
    /// Does something with the palette, and what its entry stands for. A setting that changes away from its page is told, with a way back.
    pub(super) fn take_palette(&mut self, command: PaletteCommand, now: DateTime) -> Vec<Effect> {
        let (commands, asked) = self.apply_palette(command);
        self.by_palette = true;
        let mut effects: Vec<_> = commands.into_iter().flat_map(|command| self.apply(command, now)).collect();
        self.by_palette = false;
        effects.extend(asked);
        effects
    }

    /// Does something with the palette. What its entry stands for comes back, to be done in its order, and what is asked of the journal.
    fn apply_palette(&mut self, command: PaletteCommand) -> (Vec<Command>, Option<Effect>) {
        match command {
            PaletteCommand::Show(is_open) => self.palette = is_open.then(|| Palette::open(self)),
            PaletteCommand::Type(query) => return (Vec::new(), self.search_palette(query)),
            PaletteCommand::More(shows) => {
                if let Some(mut palette) = self.palette.take() {
                    palette.show_more(shows, self);
                    self.palette = Some(palette);
                }
            }
            PaletteCommand::Found { run, result } => {
                let words = self.shared.words();
                if let Some(palette) = self.palette.as_mut().filter(|palette| palette.run == run) {
                    palette.add(match result {
                        Ok(rows) => records::entries(&rows, &words),
                        Err(why) => vec![records::problem(&why, &words)],
                    });
                }
            }
            PaletteCommand::Move(step) => {
                if let Some(palette) = &mut self.palette {
                    palette.step(step);
                }
            }
            PaletteCommand::Do(number) => return (self.take_entry(number), None),
        }
        (Vec::new(), None)
    }

    /// Finds what is typed at once, and asks the journal for more.
    fn search_palette(&mut self, query: String) -> Option<Effect> {
        let mut palette = self.palette.take()?;
        palette.query = query;
        palette.search(self);
        self.palette_runs += 1;
        palette.run = self.palette_runs;
        let question = records::question(&palette.query, self);
        let run = palette.run;
        self.palette = Some(palette);
        question.map(|question| Effect::FindRecords { run, question: Box::new(question), most: records::MOST })
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
