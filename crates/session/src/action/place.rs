//! Where an action applies: everywhere, on a page, or in a part of one.

use crate::Page;

/// Where an action applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Place {
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

/// A part of a page that takes the focus as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// The map of classes on the fit page.
    Classes,
    /// The cells of the table page.
    Cells,
    /// The listing of the program page.
    Listing,
    /// The list of checks on the check page.
    History,
    /// The list of the rows of a large file, in its place.
    Rows,
    /// The list of pairs on the pairing page.
    Pairs,
    /// The list of the records page.
    Records,
    /// The table of the plan on the parts page.
    Plan,
    /// The sizes of the part on the parts page.
    Sizes,
}

impl Part {
    /// The parts of all pages.
    pub const ALL: [Self; 9] = [
        Self::Classes,
        Self::Cells,
        Self::Listing,
        Self::History,
        Self::Rows,
        Self::Pairs,
        Self::Records,
        Self::Plan,
        Self::Sizes,
    ];

    /// The page that it belongs to.
    pub const fn page(self) -> Page {
        match self {
            Self::Classes => Page::Fit,
            Self::Cells => Page::Tables,
            Self::Listing => Page::Program,
            Self::History | Self::Rows => Page::Check,
            Self::Pairs => Page::Pairing,
            Self::Records => Page::Records,
            Self::Plan | Self::Sizes => Page::Parts,
        }
    }
}

impl Place {
    pub fn is_on(self, page: Page) -> bool {
        match self {
            Self::Everywhere => true,
            Self::Workpiece => matches!(page, Page::Cycles | Page::Program),
            Self::Page(of) => of == page,
            Self::Part(part) => part.page() == page,
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
