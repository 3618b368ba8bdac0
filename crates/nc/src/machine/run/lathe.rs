//! Blocks that only programs of lathe controls have.

use super::super::fault::FaultKind;
use super::super::remark::Remark;
use super::Run;
use crate::program::Body;

impl Run {
    /// Runs a block; others have no effect here.
    pub(super) fn lathe(&mut self, at: usize, body: &Body) -> Result<(), FaultKind> {
        match body {
            Body::Branch { unless, to } => {
                let holds = unless.as_ref().map_or(Ok(false), |test| self.values.passes(test))?;
                if !holds {
                    self.flow.go_to(*to);
                }
            }
            Body::Subprogram { behind, .. } => self.flow.go_to(*behind),
            Body::Show(text) => {
                let text = format!("{}\n", self.values.evaluate_text(text)?);
                let place = self.flow.place_of(at);
                // There is no mask: the program itself shows it.
                self.prints.show(place, self.flow.path().clone(), text)?;
            }
            Body::Input { question, to } => match self.values.answer(*to) {
                Some(value) => self.note_given(at, *to, Some(value)),
                None => return Err(FaultKind::NoAnswer { parameter: *to, question: question.clone() }),
            },
            Body::ReadNoFurther => self.values.wait(),
            _ => {}
        }
        Ok(())
    }

    /// Adds remarks about what a lathe control's cycle has left in `#i99`, if the block has read it.
    pub(super) fn note_reading(&mut self, at: usize) {
        let Some(parameter) = self.values.take_read() else { return };
        self.remark(at, Remark::ContentUncertain { parameter });
        if self.values.is_ahead() {
            self.remark(at, Remark::NotWaited { parameter });
        }
    }
}
