//! The reports page: what is reported, by which template, and its pages as they will print.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields of the head |
//! | `command`, `apply` | what can be done, and doing it |
//! | `actions` | menus, buttons, keys |
//! | `drawing` | how far the pages are, and their end before that |
//! | `made` | the report that the page shows and writes |
//!
//! Pages of a long report take longer than a frame may, so drawing them is an errand: [`Effect::DrawReport`] asks for it with a number, and an
//! answer with another number than the last one is dropped.

mod actions;
mod apply;
mod command;
mod drawing;
mod field;
mod made;

use std::collections::BTreeSet;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::words::Language;
use fitcheck_exchange::report::changes::EarlierReport;
use fitcheck_exchange::report::paper::Paper;
use fitcheck_exchange::report::pdf::Pages;
use fitcheck_exchange::report::template::{Section, Template};

pub use actions::ReportsAction;
pub use command::ReportsCommand;
pub use drawing::Drawing;
pub use field::ReportsField;

use crate::effect::Effect;
use crate::texts::Texts;

fitcheck_core::named! {
    /// What a report is about.
    #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
    pub enum ReportOf {
        ALL;
        /// The id of its name.
        fn name;
        /// The part that is being measured.
        Part = "reports-page-part",
        /// The verdict that stands on the check page.
        Check = "reports-page-check",
        /// What the check page lists.
        #[default]
        List = "reports-page-list",
        /// The chosen records, or all that a question finds.
        Records = "reports-page-records",
        /// What the statistics page shows.
        Statistics = "reports-page-statistics",
    }
}

/// How large the pages are shown, per cent of their size on paper; the whole page at first.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Magnification {
    #[default]
    WholePage,
    Percent(u16),
}

impl Magnification {
    const STEPS: [u16; 8] = [25, 50, 75, 100, 125, 150, 200, 300];

    /// The next larger or smaller one, from what the whole page comes to.
    #[must_use]
    pub fn step(self, is_larger: bool, whole_page: u16) -> Self {
        let now = match self {
            Self::WholePage => whole_page,
            Self::Percent(percent) => percent,
        };
        let next = if is_larger {
            Self::STEPS.into_iter().find(|step| now < *step)
        } else {
            Self::STEPS.into_iter().rev().find(|step| *step < now)
        };
        next.map_or(self, Self::Percent)
    }
}

/// What is done where everything of the session is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Wanted {
    /// The report on paper.
    Print,
    /// A template of the user's own, to begin with.
    NewTemplate,
}

/// The state of the reports page.
#[derive(Debug, Default)]
pub struct ReportsPage {
    texts: Texts<ReportsField>,
    of: Option<ReportOf>,
    /// The name of the chosen template; the first one where none of this name is there.
    template: String,
    /// The user's own, and why files beside them are none.
    own: Vec<Result<Arc<Template>, Message>>,
    /// Another language than the template's.
    language: Option<Language>,
    /// Another paper than the template's.
    paper: Option<Paper>,
    /// The name of an earlier report's file, and what it says: the report says what changed since.
    earlier: Option<(String, Arc<EarlierReport>)>,
    /// Sections of the template that are left out.
    hidden: BTreeSet<Section>,
    pages: Option<Result<Arc<Pages>, Message>>,
    /// The page in sight, from 0.
    at: usize,
    pub magnification: Magnification,
    /// Whether what is shown is not what would be written now.
    is_stale: bool,
    /// Whether the user's own templates are to be read.
    reads_templates: bool,
    /// What was asked for and is done where everything of the session is known.
    wanted: Option<Wanted>,
    /// The number of the last question, and how far its answer is while it is awaited.
    run: u64,
    at_work: Option<(u64, Arc<Drawing>)>,
    errands: Vec<Effect>,
}

impl ReportsPage {
    /// Every template: the shipped ones, then the user's own.
    pub fn templates(&self) -> impl Iterator<Item = &Arc<Template>> {
        Template::shipped().iter().chain(self.own.iter().filter_map(|own| own.as_ref().ok()))
    }

    /// Why files beside the user's own templates are none.
    pub fn refused(&self) -> impl Iterator<Item = &Message> {
        self.own.iter().filter_map(|own| own.as_ref().err())
    }

    /// The chosen template as it is.
    pub fn template(&self) -> Arc<Template> {
        let named = self.templates().find(|template| template.name == self.template);
        named.or_else(|| Template::shipped().first()).map_or_else(Template::usual, Arc::clone)
    }

    /// Whether a section of the template stands on the pages.
    pub fn shows(&self, section: Section) -> bool {
        self.template().has(section) && !self.hidden.contains(&section)
    }

    /// The paper that it is set on.
    pub fn paper(&self) -> Paper {
        self.paper.unwrap_or_else(|| self.template().paper)
    }

    /// Its language, where it is another one than the window's.
    pub fn language(&self) -> Option<Language> {
        self.language.or_else(|| self.template().language())
    }

    /// The earlier report that it is compared with, by its file's name.
    pub fn earlier(&self) -> Option<(&str, &EarlierReport)> {
        self.earlier.as_ref().map(|(name, earlier)| (name.as_str(), &**earlier))
    }

    /// Its pages as they will print, or why there are none; `None` while they are made.
    pub fn pages(&self) -> Option<Result<&Arc<Pages>, &Message>> {
        self.pages.as_ref().map(Result::as_ref)
    }

    /// The page in sight, from 0.
    pub fn at(&self) -> usize {
        self.at.min(self.last())
    }

    fn last(&self) -> usize {
        let pages = self.pages.as_ref().and_then(|pages| pages.as_ref().ok());
        pages.map_or(0, |pages| pages.count().saturating_sub(1))
    }

    /// How far its pages are while they are being made.
    pub fn at_work(&self) -> Option<&Drawing> {
        self.at_work.as_ref().map(|(_, drawing)| &**drawing)
    }
}
