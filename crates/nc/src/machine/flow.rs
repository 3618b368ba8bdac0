//! Which block is next: labels, jumps, repeats, calls and returns.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck_core::text::cut;

use super::around::ChangingBlock;
use super::budget::{Budget, UsedUp};
use super::fault::{BlockPlace, Counted, FaultKind};
use super::path::NcPath;
use super::values::{Values, whole};
use crate::control::variables::Family;
use crate::program::{Body, Operand, Program, Target, Unit};

/// How much of a block's text a later message repeats.
const LONGEST_TEXT: usize = 512;

/// A program that runs, and where it is.
#[derive(Debug)]
struct Frame {
    path: NcPath,
    program: Arc<Program>,
    unit: Option<Unit>,
    /// The block that runs next.
    next: usize,
    /// Whether `BEGIN PGM` was passed.
    has_begun: bool,
    /// How many repeats are left for each repeated part, by the block that repeats it.
    repeats: BTreeMap<usize, u32>,
}

impl Frame {
    fn new(path: NcPath, program: Arc<Program>) -> Self {
        Self { path, unit: program.unit(), program, next: 0, has_begun: false, repeats: BTreeMap::new() }
    }
}

/// A call that has not returned.
#[derive(Debug)]
pub struct Call {
    pub from: BlockPlace,
    /// The program that called, if another one was called.
    caller: Option<Box<Frame>>,
}

impl Call {
    /// Whether a program was called, not a label.
    pub const fn is_program(&self) -> bool {
        self.caller.is_some()
    }
}

/// The program that runs, and the calls that lead to it.
#[derive(Debug)]
pub(super) struct Flow {
    frame: Frame,
    calls: Vec<Call>,
    budget: Budget,
}

impl Flow {
    pub(super) fn new(path: NcPath, program: Arc<Program>, budget: &Budget) -> Self {
        Self { frame: Frame::new(path, program), calls: Vec::new(), budget: *budget }
    }

    pub(super) const fn path(&self) -> &NcPath {
        &self.frame.path
    }

    pub(super) const fn program(&self) -> &Arc<Program> {
        &self.frame.program
    }

    pub(super) const fn unit(&self) -> Option<Unit> {
        self.frame.unit
    }

    /// The unit of the main program, which is that of all logs (TNC: Q113).
    pub(super) fn main_unit(&self) -> Option<Unit> {
        self.calls.iter().find_map(|call| call.caller.as_ref()).map_or(self.frame.unit, |main| main.unit)
    }

    /// The block that runs next.
    pub(super) const fn next(&self) -> usize {
        self.frame.next
    }

    /// A block of the program that runs.
    pub(super) fn place_of(&self, block: usize) -> BlockPlace {
        BlockPlace { program: self.frame.path.clone(), block }
    }

    /// A block of the program that runs, as a later message names it.
    pub(super) fn made(&self, at: usize) -> ChangingBlock {
        let program = &self.frame.program;
        let line = program.blocks().get(at).map_or(0, |block| block.lines.start + 1);
        ChangingBlock { line, text: cut(program.first_line_of(at).trim(), LONGEST_TEXT) }
    }

    pub(super) fn calls(&self) -> &[Call] {
        &self.calls
    }

    /// Whether the program that runs was called by another.
    pub(super) fn is_within_call(&self) -> bool {
        self.calls.iter().any(Call::is_program)
    }

    /// Moves past a block that runs now. Only comments may come before `BEGIN PGM`.
    pub(super) fn pass(&mut self, at: usize, body: &Body) -> Result<(), FaultKind> {
        self.frame.next = at + 1;
        if !self.frame.has_begun {
            self.frame.has_begun = match body {
                Body::Begin { .. } => true,
                Body::Nothing | Body::Heading { .. } => false,
                _ => return Err(FaultKind::Broken { what: self.frame.program.notation().begin() }),
            };
        }
        Ok(())
    }

    /// `LBL 0` returns from a subprogram; without a call it has no effect, like every other label.
    pub(super) fn pass_label(&mut self, label: &Target) {
        let returns = *label == Target::Number(0) && self.calls.last().is_some_and(|call| !call.is_program());
        if let Some(call) = self.calls.pop_if(|_call| returns) {
            self.frame.next = call.from.block + 1;
        }
    }

    pub(super) fn jump(&mut self, label: &Target, values: &Values) -> Result<(), FaultKind> {
        self.frame.next = self.block_of(label, values)?;
        Ok(())
    }

    /// Goes to a block of the program that runs, as a branch does.
    pub(super) const fn go_to(&mut self, block: usize) {
        self.frame.next = block;
    }

    /// The block of a label of the program that runs.
    fn block_of(&self, label: &Target, values: &Values) -> Result<usize, FaultKind> {
        let program = &self.frame.program;
        let Target::Parameter(parameter) = label else { return Ok(program.label(label)?) };
        let label = if parameter.family == Family::Qs {
            Target::Name(values.text(*parameter)?.to_owned())
        } else {
            let value = values.number(*parameter)?;
            let number = whole(value).and_then(|number| u32::try_from(number).ok());
            let no_label = || FaultKind::NoLabel { parameter: *parameter, value };
            Target::Number(number.ok_or_else(no_label)?)
        };
        Ok(program.label(&label)?)
    }

    /// Runs a subprogram, or repeats the part of the program from the label to this block.
    pub(super) fn call_label(
        &mut self,
        at: usize,
        label: &Target,
        repeat: Option<Operand>,
        values: &Values,
    ) -> Result<(), FaultKind> {
        let to = self.block_of(label, values)?;
        if let Some(repeat) = repeat {
            // The part would end before it begins.
            if at < to {
                let line = self.frame.program.blocks().get(to).map_or(0, |block| block.lines.start + 1);
                return Err(FaultKind::RepeatAhead { line });
            }
            let left = match self.frame.repeats.remove(&at) {
                Some(left) => left,
                None => u32::try_from(values.whole(Counted::Word("REP"), repeat)?).unwrap_or(u32::MAX),
            };
            match left.checked_sub(1) {
                // The count is used up: the next time it starts again.
                None => {}
                Some(left) => {
                    self.frame.repeats.insert(at, left);
                    self.frame.next = to;
                }
            }
            return Ok(());
        }
        let labels = self.calls.iter().filter(|call| !call.is_program()).count();
        Budget::one_more(labels, self.budget.label_calls, UsedUp::LabelCalls)?;
        self.calls.push(Call { from: self.place_of(at), caller: None });
        self.frame.next = to;
        Ok(())
    }

    /// Whether one more program may be called.
    pub(super) fn check_depth(&self) -> Result<(), UsedUp> {
        let depth = self.calls.iter().filter(|call| call.is_program()).count();
        Budget::one_more(depth, self.budget.program_calls, UsedUp::ProgramCalls)
    }

    /// Enters another program.
    pub(super) fn call_program(&mut self, at: usize, path: NcPath, program: Arc<Program>) {
        let from = self.place_of(at);
        let mut frame = Frame::new(path, program);
        if !frame.program.has_unit() {
            frame.unit = self.frame.unit;
        }
        let caller = std::mem::replace(&mut self.frame, frame);
        self.calls.push(Call { from, caller: Some(Box::new(caller)) });
    }

    /// `END PGM`: returns to the caller; `false` if there is none.
    ///
    /// # Errors
    /// A subprogram that is still open: what stands behind its call would not run, and not be measured.
    pub(super) fn end_program(&mut self) -> Result<bool, FaultKind> {
        let Some(call) = self.calls.pop() else { return Ok(false) };
        let Some(caller) = call.caller else {
            let called = self.frame.program.blocks().get(call.from.block);
            return Err(FaultKind::OpenSubprogram { line: called.map_or(0, |block| block.lines.start + 1) });
        };
        self.frame = *caller;
        Ok(true)
    }
}
