//! Jumps, calls and returns.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::budget::{Budget, UsedUp};
use super::fault::{BlockPlace, FaultKind};
use super::path::NcPath;
use super::run::Machine;
use super::step::Step;
use super::store::StoreError;
use crate::control::variables::{Family, Parameter, Value};
use crate::nc::program::{Program, Target, TextOperand, Unit};

/// A program that runs: where it is and what is its own.
#[derive(Debug)]
pub(super) struct Frame {
    pub(super) path: NcPath,
    pub(super) program: Arc<Program>,
    pub(super) unit: Option<Unit>,
    /// The block that is run next.
    pub(super) next: usize,
    /// Whether `BEGIN PGM` was passed.
    pub(super) has_begun: bool,
    /// How often each repeated part is still to be run, by the block that repeats it.
    repeats: BTreeMap<usize, u32>,
}

impl Frame {
    pub(super) fn new(path: NcPath, program: Arc<Program>) -> Self {
        Self { path, unit: program.unit(), program, next: 0, has_begun: false, repeats: BTreeMap::new() }
    }
}

/// A call that has not returned.
#[derive(Debug)]
pub struct Call {
    /// The block that called.
    pub from: BlockPlace,
    kind: CallKind,
}

#[derive(Debug)]
enum CallKind {
    Label,
    /// The caller, and the parameters that are its own.
    Program(Box<Frame>, Vec<(Parameter, Value)>),
}

impl Call {
    /// Whether another program was called, and not a label.
    pub const fn is_program(&self) -> bool {
        matches!(self.kind, CallKind::Program(..))
    }
}

impl Machine {
    /// `LBL 0` returns from a subprogram; without a call it is passed over, and so is every other label.
    pub(super) fn pass_label(&mut self, label: &Target) {
        let returns = *label == Target::Number(0) && self.calls.last().is_some_and(|call| !call.is_program());
        if let Some(call) = self.calls.pop_if(|_call| returns) {
            self.frame.next = call.from.block + 1;
        }
    }

    pub(super) fn jump(&mut self, label: &Target) -> Result<(), FaultKind> {
        self.frame.next = self.block_of(label)?;
        Ok(())
    }

    /// The block of a label of the program that runs.
    fn block_of(&self, label: &Target) -> Result<usize, FaultKind> {
        let program = &self.frame.program;
        let Target::Parameter(parameter) = label else { return Ok(program.label(label)?) };
        let label = if parameter.family == Family::Qs {
            Target::Name(self.text(*parameter)?.to_owned())
        } else {
            let value = self.number(*parameter)?;
            let number = whole(value).and_then(|number| u32::try_from(number).ok());
            let no_label = || FaultKind::NoLabel { parameter: *parameter, value: value.to_string() };
            Target::Number(number.ok_or_else(no_label)?)
        };
        Ok(program.label(&label)?)
    }

    /// Runs a subprogram, or the part of the program between the label and here again.
    pub(super) fn call_label(&mut self, at: usize, label: &Target, repeat: Option<u32>) -> Result<(), FaultKind> {
        let to = self.block_of(label)?;
        if let Some(repeat) = repeat {
            match self.frame.repeats.remove(&at).unwrap_or(repeat).checked_sub(1) {
                // The count is used up: the next time it begins anew.
                None => {}
                Some(left) => {
                    self.frame.repeats.insert(at, left);
                    self.frame.next = to;
                }
            }
            return Ok(());
        }
        let labels = self.calls.iter().filter(|call| !call.is_program()).count();
        Budget::one_more(labels, self.budget().label_calls, UsedUp::LabelCalls)?;
        self.calls.push(Call { from: self.place_of(at), kind: CallKind::Label });
        self.frame.next = to;
        Ok(())
    }

    pub(super) fn call_program(&mut self, at: usize, path: &TextOperand) -> Result<(), FaultKind> {
        let path = self.path_of(path)?;
        let depth = self.calls.iter().filter(|call| call.is_program()).count();
        Budget::one_more(depth, self.budget().program_calls, UsedUp::ProgramCalls)?;
        let program = self.load(&path)?;
        let from = self.place_of(at);
        let caller = std::mem::replace(&mut self.frame, Frame::new(path, program));
        let locals = self.take_locals();
        self.calls.push(Call { from, kind: CallKind::Program(Box::new(caller), locals) });
        Ok(())
    }

    /// A program from the store, once.
    fn load(&mut self, path: &NcPath) -> Result<Arc<Program>, FaultKind> {
        if let Some(program) = self.programs.get(path) {
            return Ok(Arc::clone(program));
        }
        let bytes = self.read(path).or_else(|fault| self.with_suffix(path, fault))?;
        self.keep_file(bytes.len())?;
        let read = self.known.program(path, &bytes);
        let program = read.map_err(|error| FaultKind::NoProgram { path: path.clone(), error })?;
        self.programs.insert(path.clone(), Arc::clone(&program));
        Ok(program)
    }

    /// `CALL PGM sub` without `.h`.
    fn with_suffix(&mut self, path: &NcPath, fault: FaultKind) -> Result<Vec<u8>, FaultKind> {
        if path.file_name().contains('.') || !matches!(fault, FaultKind::Store(StoreError::Missing { .. })) {
            return Err(fault);
        }
        self.read(&NcPath::new(&format!("{path}.h"))?).map_err(|_missing_too| fault)
    }

    /// A file from the store.
    pub(super) fn read(&mut self, path: &NcPath) -> Result<Vec<u8>, FaultKind> {
        let bytes = self.store.read(path)?;
        self.moved(bytes.len())?;
        Ok(bytes)
    }

    /// Counts bytes that were read or written: a loop around a large file would go on for days.
    pub(super) fn moved(&mut self, bytes: usize) -> Result<(), FaultKind> {
        self.traffic = self.traffic.saturating_add(bytes);
        let most = self.budget().traffic;
        if most < self.traffic { Err(UsedUp::Traffic(most).into()) } else { Ok(()) }
    }

    /// Counts a file that is kept.
    pub(super) fn keep_file(&mut self, bytes: usize) -> Result<(), FaultKind> {
        let (files, most, bytes_of_all) =
            (self.programs.len() + self.changed_tables.len(), self.budget().files, self.file_bytes + bytes);
        Budget::one_more(files, most, UsedUp::Files)?;
        if self.budget().file_bytes < bytes_of_all {
            return Err(UsedUp::FileBytes(self.budget().file_bytes).into());
        }
        self.file_bytes = bytes_of_all;
        Ok(())
    }

    /// `END PGM`: back to the caller, or the end of the run.
    pub(super) fn end_program(&mut self) -> Step {
        while let Some(call) = self.calls.pop() {
            if let CallKind::Program(caller, locals) = call.kind {
                self.take_locals();
                for (parameter, value) in locals {
                    self.variables.set(parameter, value);
                }
                self.frame = *caller;
                return Step::Went;
            }
        }
        Step::Ended
    }

    pub(super) fn is_within_call(&self) -> bool {
        self.calls.iter().any(Call::is_program)
    }

    /// Takes the parameters away that belong to the program that runs.
    fn take_locals(&mut self) -> Vec<(Parameter, Value)> {
        self.variables.take(Family::Ql)
    }
}

/// A whole number from 0, if it is one.
pub(super) fn whole(value: f64) -> Option<usize> {
    const MOST: f64 = 1e15;
    if !(0.0..=MOST).contains(&value) || 0.0 < value.fract() {
        return None;
    }
    #[expect(
        clippy::as_conversions,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a whole number in range, just checked"
    )]
    Some(value as usize)
}
