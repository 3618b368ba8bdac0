//! What a page asks before something is done, and what Enter answers.
//!
//! One rule for every question: its first answer is the highlighted one, and Enter gives that one and no other.

use super::Action;
use crate::check::CheckAction;
use crate::cycles::CyclesAction;
use crate::parts::{PartsAction, PartsView};
use crate::{Field, Page, Session};

impl Session {
    /// The answers to what the open page asks, the highlighted one first; none where nothing is asked.
    pub fn answers(&self) -> Vec<Action> {
        let (question, meant, as_it_is): (_, Action, Action) = match self.page() {
            Page::Check => (self.check().question(), CheckAction::TakeMeant.into(), CheckAction::JudgeAnyway.into()),
            Page::Parts if self.parts().view == PartsView::Walk => {
                let question = self.parts().walking.question();
                (question, PartsAction::TakeMeantValue.into(), PartsAction::TakeValue.into())
            }
            _ => return Vec::new(),
        };
        let Some(question) = question else { return Vec::new() };
        question.doubt.meant().map(|_| meant).into_iter().chain([as_it_is]).collect()
    }

    /// What Enter does in a text field of the open page now.
    pub fn on_enter(&self, field: Field) -> Option<Action> {
        let usual = Action::on_enter(field, self.page())?;
        let is_asked = matches!(usual, Action::Check(CheckAction::Measure) | Action::Parts(PartsAction::TakeValue));
        self.answers().into_iter().next().filter(|_| is_asked).or(Some(usual))
    }

    /// Whether an action would only do once more what stands on screen: Enter repeats nothing, its button and keys do.
    pub(crate) fn repeats(&self, action: Action) -> bool {
        match action {
            Action::Check(CheckAction::Measure) => self.check().would_repeat(),
            Action::Cycles(CyclesAction::RunCycle) => self.cycles().would_repeat(),
            _ => false,
        }
    }
}
