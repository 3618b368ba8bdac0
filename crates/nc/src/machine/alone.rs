//! What a measuring block loses where it is taken out of its program and run alone: coordinates that were moved before it, what a called
//! program does, and that a control may not run it at all.
//!
//! Nothing is run: every block that may come before it counts, with the changes that a run would keep. What is not known, such as the value
//! of a parameter, is never neutral.

use std::collections::BTreeMap;

use fitcheck_core::message::{Located, Say};
use fitcheck_core::probing::cycle::{Control, Cycle, Meaning, Parameter};
use fitcheck_core::probing::cycles::cycles_of;
use fitcheck_core::text::cut;

use super::around::{Around, CarriedState, ChangingBlock, machining, reset_datum};
use super::change::may_set_datum;
use super::tool_call::Named;
use crate::control::probe_block::ProbeBlock;
use crate::program::{
    Block, Body, Course, CycleBlock, CycleValue, MachineFunction, Operand, PassedOver, Program, Unread,
};

/// How much of a block's text is repeated.
const LONGEST_TEXT: usize = 80;

/// What begins an ISO program, for a text that lacks it.
const ISO_HEAD: &str = "%A G71 *\n";

/// Why a block alone may not measure what it measures in its program. Its place is the line of the block that is the reason.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "alone")]
pub enum Alone {
    /// The coordinates of the block are moved, turned, mirrored or scaled, or its tool axis or mode is another one.
    Moved {
        /// The block that has done so.
        text: String,
    },
    /// Blocks are called that may move them.
    Called {
        /// The call.
        text: String,
    },
    /// A block is not understood, and may move them.
    NotUnderstood {
        /// The block.
        text: String,
    },
    /// The program does not come to the block.
    NotRun {
        /// The last block that it comes to.
        text: String,
    },
    /// The program may end without the block.
    Passed {
        /// The block that may go past it.
        text: String,
    },
    /// The block has a `/` and is not run with block skip.
    Skipped,
}

/// What the block that was read from a text loses without the others; nothing of a text that is one block, nor of a lathe's cycle, which
/// has no limits to judge by.
///
/// ```
/// use fitcheck_nc::control::probe_block::read;
/// use fitcheck_nc::machine::{Alone, alone};
///
/// let text = "CYCL DEF 10.1 ROT+15\nTCH PROBE 427 MEASURE COORDINATE ~\nQ263=+35";
/// let told = alone(text, &read(text)?);
/// assert_eq!(told[0].place.line, Some(1));
/// assert_eq!(told[0].what, Alone::Moved { text: "CYCL DEF 10.1 ROT+15".to_owned() });
/// # Ok::<(), fitcheck_nc::control::probe_block::ProbeBlockError>(())
/// ```
pub fn alone(text: &str, block: &ProbeBlock) -> Vec<Located<Alone>> {
    if block.cycle.control == Control::Lathe {
        return Vec::new();
    }
    let line = block.line.saturating_sub(1);
    let read = |head: &str| {
        let program = Program::read(format!("{head}{text}").as_bytes()).ok()?.0;
        let added = usize::from(!head.is_empty());
        let at = program.block_at(line + added)?;
        let block = program.blocks().get(at)?;
        let is_found = matches!(block.body, Body::Probe(_)) && block.lines.start == line + added;
        is_found.then(|| BlockReasons { program: &program, block: at, added, said: Vec::new() }.all())
    };
    read("").or_else(|| read(ISO_HEAD)).unwrap_or_else(|| not_read(text, line))
}

/// What is before a block, counted from 0, that no reader of programs knows as a measuring cycle.
fn not_read(text: &str, line: usize) -> Vec<Located<Alone>> {
    let Ok((program, _)) = Program::read(text.as_bytes()) else {
        let before = (1..).zip(text.lines()).take(line).find(|(_, text)| !text.trim().is_empty());
        let first = |(at, text)| Located::in_line(at, Alone::NotUnderstood { text: shown(text) });
        return before.map(first).into_iter().collect();
    };
    let mut told = BlockReasons { program: &program, block: 0, added: 0, said: Vec::new() };
    let says = |block: &Block| !matches!(block.body, Body::Begin { .. } | Body::Nothing | Body::Heading { .. });
    if let Some(first) = program.blocks().iter().position(says).filter(|first| told.line(*first) <= line) {
        told.say(first, |text| Alone::NotUnderstood { text });
    }
    let itself =
        program.block_at(line).filter(|at| program.blocks().get(*at).is_some_and(|block| block.may_be_skipped));
    if let Some(block) = itself {
        told.say(block, |_| Alone::Skipped);
    }
    told.said
}

fn shown(text: &str) -> String {
    cut(text.trim(), LONGEST_TEXT).replace(char::is_control, "\u{fffd}")
}

/// What is said of a block.
struct BlockReasons<'a> {
    program: &'a Program,
    block: usize,
    /// How many lines stand before the text that is none of its own.
    added: usize,
    said: Vec<Located<Alone>>,
}

impl BlockReasons<'_> {
    /// The line of a block, from 1.
    fn line(&self, block: usize) -> usize {
        (self.program.blocks().get(block).map_or(0, |block| block.lines.start) + 1).saturating_sub(self.added)
    }

    fn say(&mut self, block: usize, what: impl FnOnce(String) -> Alone) {
        let text = shown(self.program.first_line_of(block));
        self.said.push(Located::in_line(self.line(block), what(text)));
    }

    fn all(mut self) -> Vec<Located<Alone>> {
        let course = self.program.course_to(self.block);
        if let Some(last) = course.last {
            self.say(last, |text| Alone::NotRun { text });
        }
        if let Some(passes) = course.passes {
            self.say(passes, |text| Alone::Passed { text });
        }
        self.before(&course);
        if self.program.blocks().get(self.block).is_some_and(|block| block.may_be_skipped) {
            let block = self.block;
            self.say(block, |_| Alone::Skipped);
        }
        self.said
    }

    /// What the blocks before it do.
    fn before(&mut self, course: &Course) {
        let program = self.program;
        let mut around = Around::new(program.notation());
        let mut kept: BTreeMap<CarriedState, usize> = BTreeMap::new();
        let mut called = None;
        let mut unread = None;
        // A reset counts where nothing goes past it.
        let mut is_certain = course.is_straight;
        for (at, block) in program.blocks().iter().enumerate() {
            if course.before.get(at) != Some(&true) {
                continue;
            }
            match set_up(&mut around, program, at, block) {
                Before::Nothing => continue,
                Before::Changed => {}
                Before::Called => _ = called.get_or_insert(at),
                Before::NotUnderstood => _ = unread.get_or_insert(at),
            }
            let in_force: Vec<CarriedState> = around.kept().collect();
            is_certain &= !(block.may_be_skipped && kept.keys().any(|kept| !in_force.contains(kept)));
            if is_certain {
                kept.retain(|kept, _| in_force.contains(kept));
            }
            for found in in_force {
                kept.entry(found).or_insert(at);
            }
        }
        let mut moved: Vec<usize> = kept.into_values().collect();
        moved.sort_unstable();
        moved.dedup();
        for block in moved {
            self.say(block, |text| Alone::Moved { text });
        }
        if let Some(block) = called {
            self.say(block, |text| Alone::Called { text });
        }
        if let Some(block) = unread {
            self.say(block, |text| Alone::NotUnderstood { text });
        }
    }
}

/// What a block does for those behind it.
enum Before {
    Nothing,
    Changed,
    Called,
    NotUnderstood,
}

/// Whether the block of a cycle sets a datum, or corrects the active preset by a number that is not 0.
fn sets_datum(cycle: &Cycle, block: &CycleBlock) -> bool {
    let corrects = |parameter: &Parameter| {
        let key = parameter.key.to_string();
        let line = block.lines.iter().find(|line| line.parameter.to_string() == key);
        let is_zero = |value: f64| value.abs() <= 0.0;
        line.is_some_and(|line| match &line.value {
            CycleValue::Number { value: Operand::Number(value), .. } => !is_zero(*value),
            _ => true,
        })
    };
    cycle.sets_datum() || cycle.meant(Meaning::PresetCorrection).is_some_and(corrects)
}

/// Does what a block says, as far as a measurement behind it depends on it; parameters of the block that measures are numbers.
fn set_up(around: &mut Around, program: &Program, at: usize, block: &Block) -> Before {
    let unknown = |operand: Operand| {
        Ok(match operand {
            Operand::Number(value) => value,
            Operand::Parameter { .. } => f64::NAN,
        })
    };
    let made = || ChangingBlock { line: block.lines.start + 1, text: String::new() };
    match &block.body {
        Body::CallLabel { .. } | Body::CallProgram(_) | Body::CallSelectedProgram => return Before::Called,
        Body::Frame(frame) => {
            if around.change(frame, made(), program.unit(), &unknown).is_err() {
                around.lose_system(made);
            }
        }
        Body::Move(movement) => {
            around.turn(&movement.axes, &unknown);
            machine_functions(around, &movement.machine, made);
        }
        Body::PassedOver(PassedOver { goes, machine, .. }) => {
            around.turn(&goes.axes, &unknown);
            machine_functions(around, machine, made);
        }
        Body::MachineFunctions(machine) | Body::Stop(machine) => machine_functions(around, machine, made),
        Body::ToolCall { axis, .. } => around.call_tool(Named::Nothing, *axis, ""),
        Body::Mode(mode) => around.set_mode(*mode),
        Body::CycleDefinition(cycle) => match machining(cycle) {
            Some(number) => around.turning(number, made()),
            None => around.lose_system(made),
        },
        Body::Probe(cycle) => {
            let known = cycles_of(Control::Milling).find(|known| known.code == cycle.number);
            if !known.map_or_else(|| may_set_datum(&cycle.number), |known| sets_datum(known, cycle)) {
                return Before::Nothing;
            }
            around.lose_system(made);
        }
        Body::Other => {
            return match program.unread(at) {
                Unread::Flow => Before::Called,
                Unread::Anything(_) => Before::NotUnderstood,
                Unread::Nothing
                | Unread::Sets(_)
                | Unread::TableOpen
                | Unread::TableWrite
                | Unread::Sql(_)
                | Unread::Files => Before::Nothing,
            };
        }
        Body::Begin { .. }
        | Body::End { .. }
        | Body::Nothing
        | Body::Heading { .. }
        | Body::Label(_)
        | Body::SelectProgram(_)
        | Body::Assign { .. }
        | Body::Undefine(_)
        | Body::AssignText { .. }
        | Body::Jump { .. }
        | Body::Branch { .. }
        | Body::Subprogram { .. }
        | Body::Show(_)
        | Body::Input { .. }
        | Body::ReadNoFurther
        | Body::Error(_)
        | Body::Print { .. }
        | Body::File(_)
        | Body::TableOpen(_)
        | Body::TableRead { .. }
        | Body::TableWrite { .. }
        | Body::GlobalDefinition(_)
        | Body::SystemRead { .. } => return Before::Nothing,
    }
    Before::Changed
}

/// M functions that change the datum.
fn machine_functions(around: &mut Around, functions: &[MachineFunction], made: impl FnOnce() -> ChangingBlock) {
    if reset_datum(functions) {
        around.lose_system(made);
    }
}
