//! The keys of actions: which are shown beside them, which are heard now, and which action takes them where two could.

use super::window::WindowAction;
use super::{Action, ActionScope, Key, Part, Shortcut};
use crate::Session;
use crate::page::Page;
use crate::parts::PartsView;

impl Action {
    /// All its keys, even those that another action takes first. The first one is shown to the user.
    pub fn shortcuts(self) -> impl Iterator<Item = Shortcut> {
        self.row().keys.into_iter().flatten()
    }

    /// The keys that are shown beside it: in the file dialog its own, else those of the page.
    pub fn shortcut_shown(self, page: Page) -> Option<Shortcut> {
        if self.place() == ActionScope::Dialog { self.shortcuts().next() } else { self.shortcut_on(page) }
    }

    /// The keys that are shown on a page; `None` where it has none, or where another action of the page takes them.
    pub fn shortcut_on(self, page: Page) -> Option<Shortcut> {
        let first = self.shortcuts().next().filter(|_| self.place().is_on(page))?;
        (!self.leaves_to_another(first, page)).then_some(first)
    }

    /// Whether another action of the page takes these keys, also while it is not possible: Ctrl+Z on the table page never
    /// undoes what is not in sight.
    fn leaves_to_another(self, keys: Shortcut, page: Page) -> bool {
        let rank = self.place().rank();
        let takes = |other: Self| {
            let place = other.place();
            place.is_on(page) && place.rank() < rank && other.shortcuts().any(|other| other == keys)
        };
        // Escape belongs to whatever can use it: a run that goes on, or what lies over the page.
        keys.key != Key::Escape && Self::all().any(takes)
    }
}

impl Session {
    /// While a part is measured the plan is not in sight, and Ctrl+Z takes the last value back.
    fn undoes_value(&self, action: Action) -> bool {
        action == WindowAction::Undo.into() && self.page() == Page::Parts && self.parts().view == PartsView::Walk
    }

    /// Whether the dialog for an NC block lies over the page.
    fn block_is_open(&self) -> bool {
        self.page() == Page::Cycles && self.cycles().block.is_some()
    }

    /// The actions of the keys now, the nearest place first: `part` has the focus, or a text field (`is_typing`).
    pub fn keys(&self, part: Option<Part>, is_typing: bool) -> Vec<(Shortcut, Action)> {
        let is_covered = self.dialog().is_some()
            || self.open_columns().is_some()
            || self.is_leaving()
            || self.asks_about().is_some()
            || self.block_is_open()
            || self.palette.is_some();
        let is_heard = |action: Action| match action.place() {
            ActionScope::Everywhere => true,
            // The workpiece's window lies over the listing, and takes Escape.
            ActionScope::Page(Page::Program) if self.workpiece_is_open() => false,
            ActionScope::Dialog => false,
            ActionScope::Part(of) => part == Some(of) && of.page == self.page(),
            place => place.is_on(self.page()),
        };
        let is_of_cover =
            |action: Action| action == WindowAction::Close.into() || action.place() == ActionScope::Dialog;
        let heard = Action::all().filter(|action| if is_covered { is_of_cover(*action) } else { is_heard(*action) });
        let mut keys: Vec<_> = heard
            .flat_map(|action| action.shortcuts().map(move |shortcut| (shortcut, action)))
            .filter(|(shortcut, action)| !(is_typing && shortcut.is_of_text()) && self.can(*action))
            .filter(|(shortcut, action)| {
                self.undoes_value(*action) || !action.leaves_to_another(*shortcut, self.page())
            })
            .collect();
        keys.sort_by_key(|(_, action)| action.place().rank());
        keys
    }
}
