//! Where an action applies: everywhere, on a page, or in a part of one.

use crate::page::Page;

/// Where an action applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ActionScope {
    /// On every page.
    Everywhere,
    /// On the pages that measure the simulated workpiece.
    Workpiece,
    Page(Page),
    /// In the focused part of a page.
    Part(Part),
    /// In the file dialog, over any page.
    Dialog,
}

/// A part of a page that takes the focus as a whole: a list, a table, a map.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Part {
    /// The page that it belongs to.
    pub page: Page,
    /// Its name: no other part has it.
    pub name: &'static str,
    /// The keys that go on inside it instead of leaving it.
    pub keeps: Keeps,
}

/// Keys that a part keeps to itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Keeps {
    /// Up and down: a list.
    Rows,
    /// All arrows: cells.
    Cells,
    /// All arrows, and Tab: a table that is typed into.
    CellsAndTab,
}

impl Part {
    /// A list.
    pub const fn list(page: Page, name: &'static str) -> Self {
        Self { page, name, keeps: Keeps::Rows }
    }

    /// A grid of cells.
    pub const fn cells(page: Page, name: &'static str) -> Self {
        Self { page, name, keeps: Keeps::Cells }
    }

    /// A grid of cells that is typed into.
    pub const fn sheet(page: Page, name: &'static str) -> Self {
        Self { page, name, keeps: Keeps::CellsAndTab }
    }
}

impl ActionScope {
    /// The page that it belongs to; `None` where that is no single one.
    pub(crate) const fn page(self) -> Option<Page> {
        match self {
            Self::Page(page) | Self::Part(Part { page, .. }) => Some(page),
            Self::Everywhere | Self::Workpiece | Self::Dialog => None,
        }
    }

    pub fn is_on(self, page: Page) -> bool {
        match self {
            Self::Everywhere => true,
            Self::Workpiece => matches!(page, Page::Cycles | Page::Program),
            Self::Page(of) | Self::Part(Part { page: of, .. }) => of == page,
            Self::Dialog => false,
        }
    }

    /// The nearer place goes first: where two places use the same keys, the smaller one takes them.
    pub(super) const fn rank(self) -> u8 {
        match self {
            Self::Part(_) | Self::Dialog => 0,
            Self::Page(_) => 1,
            Self::Workpiece => 2,
            Self::Everywhere => 3,
        }
    }
}
