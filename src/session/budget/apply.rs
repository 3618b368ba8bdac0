//! How commands and news change the budget page.

use jiff::civil::DateTime;

use super::{BudgetCommand, BudgetPage};
use crate::session::command::Effect;
use crate::session::shared::{News, PageState, Shared};

impl PageState for BudgetPage {
    type Command = BudgetCommand;

    fn apply(&mut self, command: BudgetCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            BudgetCommand::Type(field, text) => self.texts.set(field, text),
            BudgetCommand::Leave => {
                shared.budget = None;
                shared.spread(News::Budget);
            }
        }
        Vec::new()
    }

    fn follow(&mut self, _news: &News, _shared: &mut Shared) {}
}
