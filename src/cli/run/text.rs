//! The result of a run, for people: windows and trace on standard output, notes on standard error.

use super::super::CliRemark;
use super::super::cycle::Source;
use super::super::said::remark;
use super::{Ended, Io, LONGEST_TEXT, Listener, place};
use crate::message::message;
use crate::nc::machine::{BlockPlace, Fault, FileRead, Machine, Pause, ToolChanged, shown};
use crate::text::cut;
use crate::words::{Language, Words};

/// Prints windows as they open, and with a trace every block before.
pub(super) struct Printer {
    trace: bool,
    windows: usize,
    at: Option<BlockPlace>,
}

impl Printer {
    pub(super) const fn new(trace: bool) -> Self {
        Self { trace, windows: 0, at: None }
    }

    fn print_block(&self, machine: &Machine, io: &mut Io<'_>) {
        let Some(BlockPlace { program, block }) = &self.at else { return };
        let (file, line) = place(machine, program, *block);
        let program = machine.program(program);
        let Some(text) = program.and_then(|program| program.text_of(*block).next()) else { return };
        writeln!(io.people(), "{file}:{line}  {}", cut(text.trim(), LONGEST_TEXT));
        for parameter in machine.changed() {
            match machine.variables().get(*parameter) {
                Some(value) => writeln!(io.people(), "    {parameter} = {}", shown(value)),
                None => writeln!(io.people(), "    {parameter} undefined"),
            }
        }
    }
}

impl Listener for Printer {
    fn before(&mut self, machine: &Machine) {
        if self.trace {
            self.at = Some(machine.place());
        }
    }

    fn after(&mut self, machine: &Machine, io: &mut Io<'_>) {
        self.print_block(machine, io);
        for window in machine.windows().iter().skip(self.windows) {
            if 0 < self.windows && !self.trace {
                writeln!(io.people());
            }
            io.people().write_all(window.text.as_bytes());
            self.windows += 1;
        }
    }
}

/// What is worth knowing, in the user's language; with a trace also where every file came from.
pub(super) fn notes(machine: &Machine, ended: &Ended, is_traced: bool, language: Language, io: &mut Io<'_>) {
    let words = Words::new(language);
    for pause in &ended.pauses {
        if matches!(pause, Pause::Tolerance(_) | Pause::Log) {
            io.tell(format_args!("note: {}", words.told(pause)));
        }
    }
    for (BlockPlace { program, block }, remark) in machine.remarks() {
        let (file, line) = place(machine, program, *block);
        io.note(format_args!("note: {file}:{line}: {}", words.told(remark)));
    }
    if 0 < machine.unlisted_remarks() {
        let more = message!("machine-remark-more").text("count", machine.unlisted_remarks());
        io.note(format_args!("note: {}", words.say(&more)));
    }
    if let Some(passed_over) = machine.passed_over_message() {
        io.note(format_args!("note: {}", words.say(&passed_over)));
    }
    if is_traced {
        for (path, origin) in machine.origins() {
            io.note(format_args!("note: {}", words.told(&FileRead::of(path, origin))));
        }
    }
    for ToolChanged { place: BlockPlace { program, block }, change } in machine.tool_changes() {
        let (file, line) = place(machine, program, *block);
        io.note(format_args!("note: {file}:{line}: {}", words.told(change)));
    }
    let mut written: Vec<_> =
        machine.outputs().iter().filter(|output| output.is_saved).map(|output| &output.path).collect();
    written.sort();
    // A file that is printed to a thousand times is one file.
    written.dedup();
    for path in written {
        io.note(CliRemark::Wrote { path: path.to_string() });
    }
}

/// That nobody measured, where anything was.
pub(super) fn tell_source(machine: &Machine, source: &Source, io: &mut Io<'_>) {
    if machine.cycles().is_empty() {
        return;
    }
    match source {
        // Whoever asks for quiet must know it, too.
        Source::Perfect => io.tell(remark(&CliRemark::PerfectWorkpiece)),
        Source::Workpiece { .. } => io.tell(remark(&CliRemark::Simulated)),
        Source::Contacts { .. } => {}
    }
}

/// Why the run stopped.
pub(super) fn tell_fault(fault: &Fault, language: Language, io: &mut Io<'_>) {
    io.fail(Words::new(language).told(fault));
}
