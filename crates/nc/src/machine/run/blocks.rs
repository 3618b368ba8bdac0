//! What each block does, and which part of the machine does it.

use std::sync::Arc;

use fitcheck_core::message::Say as _;
use fitcheck_core::probing::cycle::{Control, LogTarget};

use super::super::around::{Purpose, reset_datum};
use super::super::budget::{Settings, UsedUp};
use super::super::cycles::{CycleRequest, CycleRun, cycle_of, hand_over};
use super::super::fault::{BlockPlace, Counted, Fault, FaultKind};
use super::super::files::Files;
use super::super::logs::Log;
use super::super::path::{NcPath, PathError};
use super::super::placement::Placement;
use super::super::prints::rendered;
use super::super::remark::Remark;
use super::super::step::{Pause, Step};
use super::super::tool_call::{Named, unknown_words};
use super::super::values::shown_arg;
use super::Run;
use super::skipped::ReadAs;
use crate::control::mask::Context;
use crate::control::variables::{Parameter, Value};
use crate::program::{Axis, Block, Body, CycleBlock, MachineFunction, PassedOver, TextOperand, Tool};

impl Run {
    /// Runs the next block.
    pub(super) fn step(&mut self, files: &mut Files, settings: &Settings) -> Result<Step, Fault> {
        self.values.begin_block();
        let at = self.flow.next();
        let place = self.flow.place_of(at);
        let travels = self.way.travels().len();
        let mut done = self.block(at, files, settings);
        self.look_at_travels(&place, travels, settings);
        self.remarks.add_all(&place, files.take_told());
        if matches!(done, Ok(Step::Ended)) {
            if let Some(left) = self.cycles.contacts_left() {
                self.remark(at, left);
            }
            for parameter in self.values.given_without_effect() {
                self.remark(at, Remark::GivenWithoutEffect { parameter });
            }
            // A second error at the end counts as an error of the block that ended the run.
            if let Err(kind) = self.close_table(files) {
                done = Err(kind);
            }
        }
        done.map_err(|kind| self.fail(at, kind, files))
    }

    /// Remarks on what the moves of a block would touch: the first place of the block, and once for a run what they are
    /// not looked at with.
    fn look_at_travels(&mut self, place: &BlockPlace, before: usize, settings: &Settings) {
        // Where no tool was called, its axis is Z.
        let placement = self.around.placement(settings.assumes_tool, Purpose::Datum);
        let is_upright = placement.ok().is_none_or(Placement::is_upright);
        let Some(travels) = self.way.travels().get(before..) else { return };
        let probed = self.cycles.probed();
        if before == 0 && !travels.is_empty() {
            self.remarks.add_all(place, probed.unchecked().into_iter().collect());
        }
        if !is_upright && !travels.is_empty() && probed.has_stylus() {
            self.remarks.add_once(place, Remark::StylusUnchecked);
        }
        if !self.remarks.has_collision(place) {
            let found = travels.iter().find_map(|travel| probed.collision(travel, is_upright));
            self.remarks.add_all(place, found.into_iter().collect());
        }
    }

    /// Ends the run with a fault; what FN 27 has changed so far is written, as on the control.
    fn fail(&mut self, at: usize, kind: FaultKind, files: &mut Files) -> Fault {
        let table = self.tables.path().cloned();
        if let (Err(error), Some(path)) = (self.close_table(files), table) {
            self.remark(at, Remark::NotSaved { path, reason: error.message() });
        }
        Fault::new(self.flow.program(), self.flow.place_of(at), kind)
    }

    /// Runs the block at a place of the current program.
    fn block(&mut self, at: usize, files: &mut Files, settings: &Settings) -> Result<Step, FaultKind> {
        let program = Arc::clone(self.flow.program());
        if settings.budget.blocks <= self.blocks {
            return Err(UsedUp::Blocks(settings.budget.blocks).into());
        }
        let block = program.blocks().get(at).ok_or(FaultKind::Broken { what: program.notation().end() })?;
        self.blocks += 1;
        self.flow.pass(at, &block.body)?;
        if block.may_be_skipped && settings.block_skip {
            if let Body::Probe(cycle) = &block.body {
                self.remark(at, Remark::CycleSkipped);
                self.lose_measured(at, cycle);
            }
            return Ok(Step::Went);
        }
        let step = self.body(at, block, files, settings);
        self.note_reading(at);
        step
    }

    fn body(&mut self, at: usize, block: &Block, files: &mut Files, settings: &Settings) -> Result<Step, FaultKind> {
        match &block.body {
            Body::Begin { .. } | Body::Nothing | Body::Heading { .. } => {}
            Body::Label(label) => self.flow.pass_label(label),
            Body::End { .. } => {
                self.look_behind_end(at);
                return self.end_program();
            }
            Body::CallLabel { label, repeat } => self.flow.call_label(at, label, *repeat, &self.values)?,
            Body::CallProgram(path) => {
                let path = self.path_of(path)?;
                self.call_program(at, path, files)?;
            }
            Body::CallSelectedProgram => {
                let path = self.around.selected().cloned().ok_or(FaultKind::NothingSelected)?;
                self.call_program(at, path, files)?;
            }
            Body::Assign { .. } | Body::AssignText { .. } | Body::Undefine(_) => self.assign(at, &block.body)?,
            Body::Jump { condition, label } => {
                if self.values.holds(condition)? {
                    self.flow.jump(label, &self.values)?;
                }
            }
            Body::Branch { .. }
            | Body::Subprogram { .. }
            | Body::Show(_)
            | Body::Input { .. }
            | Body::ReadNoFurther => self.lathe(at, &block.body)?,
            Body::Error(number) => {
                let number = self.values.whole(Counted::Word("FN 14: ERROR"), *number)?;
                return Err(FaultKind::Programmed(u32::try_from(number).unwrap_or(u32::MAX)));
            }
            Body::Print { mask, output } => self.print(at, mask, output, files, settings)?,
            Body::File(function) => self.file(at, function, files)?,
            Body::TableOpen(_) | Body::TableRead { .. } | Body::TableWrite { .. } => {
                self.table(at, &block.body, files)?;
            }
            Body::ToolCall { tool, axis, rest } => {
                self.call_tool(at, tool.as_ref(), *axis, rest)?;
                self.cycles.call_tool(tool.as_ref(), &settings.probe_table, &self.values)?;
                let remarks = self.tools.call(tool.as_ref(), &self.values)?;
                self.remarks.add_all(&self.flow.place_of(at), remarks);
                if self.flow.program().notation().control() == Control::Milling {
                    self.take_tool(at, tool.as_ref(), rest)?;
                }
            }
            Body::Move(movement) => {
                self.around.turn(&movement.axes, &|operand| self.values.operand(operand));
                self.way.travel(self.flow.place_of(at), movement, self.flow.unit(), &self.around, &self.values)?;
                return Ok(self.machine_functions(at, &movement.machine, settings));
            }
            Body::PassedOver(PassedOver { words, goes, machine }) => {
                if words == "FN 17" {
                    self.lose_tools(at);
                }
                self.around.pass_over(words);
                self.around.turn(&goes.axes, &|operand| self.values.operand(operand));
                self.way.jump(goes, self.flow.unit(), &self.around, &self.values)?;
                return Ok(self.machine_functions(at, machine, settings));
            }
            Body::SelectProgram(_)
            | Body::CycleDefinition(_)
            | Body::GlobalDefinition(_)
            | Body::Mode(_)
            | Body::Frame(_)
            | Body::SystemRead { .. } => self.set_up(at, &block.body, files)?,
            Body::MachineFunctions(functions) => return Ok(self.machine_functions(at, functions, settings)),
            Body::Stop(functions) => {
                self.around.stop();
                return Ok(match self.machine_functions(at, functions, settings) {
                    Step::Went => Step::Paused(Pause::Stop),
                    step => step,
                });
            }
            Body::Probe(cycle) => return self.probe(at, cycle, files, settings),
            // An unknown block stops the run, or is skipped if the user has chosen so.
            Body::Other if settings.skip_unknown => self.skip(at, files)?,
            Body::Other => return Err(FaultKind::UnknownBlock),
        }
        Ok(Step::Went)
    }

    /// What TOOL CALL says of the tool in the spindle.
    fn call_tool(&mut self, at: usize, tool: Option<&Tool>, axis: Option<Axis>, rest: &str) -> Result<(), FaultKind> {
        let named = match tool {
            None => Named::Nothing,
            Some(Tool::Number(number)) if self.values.operand(*number)?.abs() <= 0.0 => Named::Empty,
            Some(_) => Named::Tool,
        };
        self.around.call_tool(named, axis, rest);
        // On a lathe M functions may stand beside the tool.
        let is_milling = self.flow.program().notation().control() == Control::Milling;
        if let Some(words) = unknown_words(rest).filter(|_| is_milling) {
            self.remark(at, Remark::ToolCallWords { words });
        }
        Ok(())
    }

    pub(super) fn remark(&mut self, at: usize, remark: Remark) {
        self.remarks.add(self.flow.place_of(at), remark);
    }

    /// The path in an operand, relative to the running program.
    pub(super) fn path_of(&self, operand: &TextOperand) -> Result<NcPath, FaultKind> {
        let path = self.values.path_text(operand)?;
        Ok(self.flow.path().resolve(&path)?)
    }

    /// The path of a file that FN 16 prints to. An interface, a network drive and a printer are folders beside the others: nothing is sent.
    fn output_path(&mut self, at: usize, operand: &TextOperand) -> Result<NcPath, FaultKind> {
        let given = self.values.path_text(operand)?;
        if given.trim().eq_ignore_ascii_case("SCREEN") {
            self.remark(at, Remark::ScreenMeant);
        }
        match self.flow.path().resolve(&given) {
            Err(error @ PathError::OtherRoot { .. }) => {
                let path = NcPath::tamed(&given).ok_or(error)?;
                self.remark(at, Remark::OtherDevice { given: given.trim().to_owned(), path: path.clone() });
                Ok(path)
            }
            path => Ok(path?),
        }
    }

    fn end_program(&mut self) -> Result<Step, FaultKind> {
        if !self.flow.end_program()? {
            return Ok(Step::Ended);
        }
        self.values.leave_program();
        Ok(Step::Went)
    }

    fn call_program(&mut self, at: usize, path: NcPath, files: &mut Files) -> Result<(), FaultKind> {
        self.flow.check_depth()?;
        self.check_file(&path, ReadAs::Other)?;
        let (program, remarks) = files.program(&path, self.tables.changed())?;
        self.remarks.add_all(&self.flow.place_of(at), remarks);
        self.flow.call_program(at, path, program);
        self.values.enter_program();
        Ok(())
    }

    /// Whether the main program is running.
    pub(super) fn is_main(&self) -> bool {
        !self.flow.is_within_call()
    }

    /// Adds a remark about a value that was given before the run and takes the place of a block's value.
    pub(super) fn note_given(&mut self, at: usize, parameter: Parameter, given: Option<Value>) {
        if let Some(value) = given {
            self.remark(at, Remark::GivenWins { parameter, value: shown_arg(&value) });
        }
    }

    pub(super) fn close_table(&mut self, files: &mut Files) -> Result<(), FaultKind> {
        self.tables.close(self.flow.path(), files, &mut self.remarks)
    }

    /// FN 16.
    fn print(
        &mut self,
        at: usize,
        mask: &TextOperand,
        output: &TextOperand,
        files: &mut Files,
        settings: &Settings,
    ) -> Result<(), FaultKind> {
        let to = self.values.text_operand(output)?.to_owned();
        let is = |word: &str| to.trim().eq_ignore_ascii_case(word);
        if is("SCLR:") {
            self.prints.close_windows();
            return Ok(());
        }
        let path = if is("SCREEN:") { None } else { Some(self.output_path(at, output)?) };
        let mask = self.path_of(mask)?;
        self.check_file(&mask, ReadAs::Other)?;
        let call_path = self.flow.path().to_string();
        let context = Context { language: settings.language, time: settings.time, call_path: &call_path };
        let (output, remarks) = rendered(&mask, &context, &self.values, files)?;
        self.remarks.add_all(&self.flow.place_of(at), remarks);
        let place = self.flow.place_of(at);
        match path {
            None => Ok(self.prints.show(place, mask, output.text)?),
            Some(path) => self.prints.print(place, path, output, files, &mut self.remarks),
        }
    }

    /// Runs a cycle and sets its result parameters.
    fn probe(
        &mut self,
        at: usize,
        block: &CycleBlock,
        files: &mut Files,
        settings: &Settings,
    ) -> Result<Step, FaultKind> {
        if let Some(passed) = self.pass_cycle(at, block) {
            return passed.map(|()| Step::Went);
        }
        if let Some(probed) = self.probe_point(at, block, settings) {
            return probed.map(|()| Step::Went);
        }
        let cycle = match cycle_of(&block.number, self.flow.program().notation().control()) {
            Err(_unknown) if settings.skip_unknown => return self.skip_cycle(at, block).map(|()| Step::Went),
            cycle => cycle?,
        };
        self.cycles.check_count()?;
        let place = self.flow.place_of(at);
        let purpose = if cycle.sets_datum() { Purpose::Datum } else { Purpose::Measurement };
        let placement = self.around.placement(settings.assumes_tool, purpose)?;
        let ended = cycle.ends_rotation().then(|| self.around.end_rotation(self.flow.made(at))).flatten();
        let placement =
            if ended.is_some() { Placement { system: self.around.system(), ..placement } } else { placement };
        self.remarks.add_all(&place, ended.into_iter().chain(self.around.odd()).collect());
        if let Some(other) = self.cycles.other_probe() {
            self.remark(at, other);
        }
        self.remarks.add_all(&place, self.tools.called());
        if cycle.control == Control::Lathe {
            let unknown = self.way.place().is_none().then_some(Remark::PositionUnknown);
            let without_size = self.cycles.probed().is_perfect().then_some(Remark::NoNominal);
            self.remarks.add_all(&place, unknown.into_iter().chain(without_size).collect());
        }
        let asked = CycleRequest { block, unit: self.flow.unit(), placement, position: self.way.place() };
        let (path, result) = self.cycles.measure(cycle, &asked, &self.around, &self.values)?;
        let path = placement.moves(&path);
        self.way.follow(&place, &path)?;
        let result = self.tools.seen(result?);
        // What it measured counts in the system before the datum that it sets.
        let around = (self.around.moment(), self.around.datum());
        self.remarks.add_all(&place, Remark::of_cycle(cycle, &result));
        hand_over(cycle, &result, &path, self.flow.unit(), &mut self.values)?;
        self.values.measured();
        self.around.stated(block, true, self.flow.unit(), &mut self.values)?;
        if let Some(log) = Log::of(cycle, &result, &self.flow, settings, self.cycles.is_simulated())? {
            self.remarks.add_all(&place, log.other(&result).into_iter().collect());
            log.write(place.clone(), &mut self.prints, files, &mut self.remarks)?;
        }
        let step = match (&result.stop, result.log) {
            (Some(stop), _) => Step::Paused(Pause::Tolerance(Box::new(stop.clone()))),
            (None, LogTarget::Screen) => Step::Paused(Pause::Log),
            (None, LogTarget::None | LogTarget::File(_) | LogTarget::Shown) => Step::Went,
        };
        if let Some(new) = &result.datum {
            self.set_datum(at, new, files)?;
        }
        if let Some(new) = &result.rotation {
            self.set_rotation(at, new, files)?;
        }
        // The last step: what was measured stands, even if the tool is broken.
        let monitored = self.tools.monitor(&place, cycle, &result, &mut self.remarks);
        if let Some(again) = self.cycles.keep(CycleRun::new(place, cycle, result, around)) {
            self.remark(at, again);
        }
        monitored.map(|()| step)
    }

    /// M0, M1, M2 and M30 act at once, some are remembered; the others have no effect here.
    fn machine_functions(&mut self, at: usize, functions: &[MachineFunction], settings: &Settings) -> Step {
        self.around.machine_functions(functions);
        let is_milling = self.flow.program().notation().control() == Control::Milling;
        if is_milling && functions.iter().any(|function| matches!(function.number, 3..=5 | 8 | 9 | 13 | 14)) {
            self.put_spindle();
        }
        if is_milling && reset_datum(functions) {
            self.around.lose_system(|| self.flow.made(at));
            self.remark(at, Remark::NotFollowed);
        }
        let mut step = Step::Went;
        for function in functions {
            match function.number {
                0 => step = Step::Paused(Pause::Stop),
                1 if settings.optional_stop => step = Step::Paused(Pause::OptionalStop),
                2 | 30 => {
                    if self.flow.is_within_call() {
                        self.remark(at, Remark::EndedWithin { function: function.number });
                    }
                    return Step::Ended;
                }
                _ => {}
            }
        }
        step
    }
}
