//! What is wrong, block by block: what reading remarked, what the run remarked, and the error that ended it.

use super::ProgramPage;
use crate::message::{Message, Say as _};
use crate::nc::machine::BlockPlace;

/// Something that is wrong or worth knowing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// What it is.
    pub kind: ProblemKind,
    /// The block.
    pub place: BlockPlace,
    /// What is said.
    pub message: Message,
}

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ProblemKind {
    /// It ended the run.
    Fault,
    /// The run remarked it.
    Remark,
    /// Reading remarked it.
    Warning,
}

impl ProgramPage {
    /// How many problems there are.
    pub fn problem_count(&self) -> usize {
        let run = self.run.as_ref();
        let of_run = run.map_or(0, |run| usize::from(run.fault().is_some()) + run.remark_count());
        of_run + self.warnings.len()
    }

    /// A problem by its number: the error first, then what the run remarked, then what reading remarked.
    pub fn problem(&self, number: usize) -> Option<Problem> {
        let run = self.run.as_ref();
        let fault = run.and_then(|run| run.fault());
        let Some(number) = number.checked_sub(usize::from(fault.is_some())) else {
            let fault = fault?;
            return Some(Problem { kind: ProblemKind::Fault, place: fault.place.clone(), message: fault.message() });
        };
        if let Some((place, remark)) = run.and_then(|run| run.remark(number)) {
            let line = self.documents.get(&place.program).map(|document| document.first_line(place.block) + 1);
            let block = self.block_number(place);
            let message = match (block, line) {
                (Some(number), _) => Message::new("program-page-at-block").text("number", number),
                (None, Some(line)) => Message::new("program-page-at-line").text("line", line),
                (None, None) => Message::new("program-page-at-block").text("number", place.block),
            };
            let message = message.message("what", remark.message());
            return Some(Problem { kind: ProblemKind::Remark, place: place.clone(), message });
        }
        let warning = self.warnings.get(number.checked_sub(run.map_or(0, super::Run::remark_count))?)?;
        let main = self.main()?;
        // A line between blocks belongs to the block before it.
        let line = warning.place.line.saturating_sub(1);
        let block = main.program().blocks().partition_point(|block| block.lines.start <= line).saturating_sub(1);
        let place = BlockPlace { program: main.path().clone(), block };
        Some(Problem { kind: ProblemKind::Warning, place, message: warning.message() })
    }

    fn block_number(&self, place: &BlockPlace) -> Option<u32> {
        let program = match self.documents.get(&place.program) {
            Some(document) => std::sync::Arc::clone(document.program()),
            None => self.run.as_ref()?.program(&place.program)?,
        };
        program.blocks().get(place.block)?.number
    }
}
