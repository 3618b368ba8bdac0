//! What targets have in common.

use std::collections::BTreeSet;
use std::sync::{Arc, LazyLock};

use fitcheck::control::deviations::read_table;
use fitcheck::exchange::{FORMATS, Imported, import};
use fitcheck::message::Say;
use fitcheck::nc::machine::{Budget, Contacts, InMemory, Machine, Settings, Step};
use fitcheck::nc::program::{Notation, Program};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use fitcheck::words::{Dialogue, Language, Words};
use jiff::civil::DateTime;

/// A report of this format, which says neither hole nor shaft: every row is a record, set aside or an error, with a line of its own, and none is rework or scrap.
pub fn printed(bytes: &[u8], name: &str) {
    let file = "a.txt";
    let format = FORMATS.iter().find(|format| format.recognises(bytes, file));
    if format.is_none_or(|format| format.name != name) {
        return;
    }
    let Imported { records, lines, unjudged, errors, warnings, rows, .. } = import(file, bytes, &OWN_SOURCES, NOW);
    assert_eq!(rows, records.len() + unjudged.len() + errors.len());
    let is_open = |status| matches!(status, Status::Good | Status::OutOfLimits);
    assert!(records.iter().all(|record| is_open(record.verdict.status())));
    assert!(0 < rows, "nothing was read, and nothing said");
    let lines: Vec<usize> = lines.into_iter().chain(unjudged.iter().map(|row| row.line)).collect();
    assert_eq!(lines.iter().collect::<BTreeSet<_>>().len(), lines.len(), "a line with two values");
    for error in errors.iter().take(3) {
        told(bytes, error);
    }
    for warning in warnings.iter().take(3) {
        told(bytes, warning);
    }
}

/// A time for everything that is given one.
pub const NOW: DateTime = DateTime::constant(2026, 3, 7, 8, 5, 9, 0);

/// Columns of a shop of its own, with a class of ISO 286 among them.
const OWN: [&str; 2] = [
    "BEGIN OWN_HOLE.TAB\nNR BEREICH PF    H7    U1Z1\n0  30      +40   +25   +2.5\n1          +10   +0    -2.5\n[END]\n",
    "BEGIN OWN_SHAFT.TAB\nNR BEREICH pf\n0  30      -10\n1          -40\n[END]\n",
];

/// Where limits come from in a shop with own columns, such as PF.
pub static OWN_SOURCES: LazyLock<Sources> = LazyLock::new(|| {
    let read = |text: &str| read_table(text.as_bytes(), "own.tab", "own.tab", false).expect("a table").0;
    Sources::default().with_own(OWN.into_iter().filter_map(read))
});

/// Figures from the beginning of an input; zeros where it has ended.
pub struct Figures<'a>(pub &'a [u8]);

impl Figures<'_> {
    /// The next bytes.
    pub fn bytes<const N: usize>(&mut self) -> [u8; N] {
        std::array::from_fn(|_| match self.0.split_first() {
            Some((first, rest)) => {
                self.0 = rest;
                *first
            }
            None => 0,
        })
    }

    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        let [byte] = self.bytes();
        byte
    }

    /// One of several.
    pub fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[usize::from(self.byte()) % all.len()]
    }

    /// A whole number from zero to this one.
    pub fn up_to(&mut self, most: i64) -> i64 {
        i64::from_le_bytes(self.bytes()).rem_euclid(most + 1)
    }

    /// A whole number of two bytes.
    pub fn short(&mut self) -> i16 {
        i16::from_le_bytes(self.bytes())
    }
}

/// What comes before the first byte 0x1C, and what comes behind it.
pub fn halves(bytes: &[u8]) -> (&[u8], &[u8]) {
    let mut parts = bytes.splitn(2, |byte| *byte == 0x1c);
    (parts.next().unwrap_or_default(), parts.next().unwrap_or_default())
}

/// What a run may use.
pub const SMALL: Budget = Budget {
    blocks: 2_000,
    label_calls: 20,
    program_calls: 10,
    text: 255,
    windows: 20,
    outputs: 20,
    output_bytes: 10_000,
    output_files: 10,
    folders: 10,
    table_writes: 20,
    cycles: 20,
    path: 500,
    files: 5,
    file_bytes: 100_000,
    traffic: 1_000_000,
    remarks: 50,
};

/// A program, and one in a file beside it.
pub struct Source<'a> {
    /// The name of the program.
    pub name: &'a str,
    /// What is written in it.
    pub text: &'a [u8],
    /// The other file: its name and its bytes.
    pub beside: (&'a str, &'a [u8]),
}

impl Source<'_> {
    /// The program, if it is one in this notation: written as it was read, its blocks one behind the other.
    pub fn reads(&self, notation: Notation) -> Option<Program> {
        let (program, warnings) = match Program::read(self.text) {
            Ok(read) => read,
            Err(error) => {
                told(self.text, &error);
                return None;
            }
        };
        assert_eq!(program.write(), self.text);
        if program.notation() != notation {
            return None;
        }
        for warning in warnings {
            assert!(warning.place.line.is_some_and(|line| line <= program.line_count()));
            told(self.text, &warning);
        }
        let mut behind = 0;
        for (index, block) in program.blocks().iter().enumerate() {
            assert!(behind <= block.lines.start && block.lines.start < block.lines.end);
            assert_eq!(program.block_at(block.lines.start), Some(index));
            behind = block.lines.end;
        }
        assert!(behind <= program.line_count());
        Some(program)
    }

    /// Runs it twice on perfect workpieces; the length of the text decides what is skipped and assumed.
    pub fn runs_twice_alike(&self, program: Program) {
        let mut settings = Settings::new(Dialogue::En, NOW);
        settings.budget = SMALL;
        settings.skip_unknown = self.text.len() % 2 == 1;
        settings.assumes_tool = self.text.len() % 4 < 2;
        let (name, bytes) = self.beside;
        let store = InMemory::new().with(self.name, self.text).with(name, bytes);
        let mut machine = Machine::new(self.name, Arc::new(program), store, Contacts::Perfect, settings);
        let first = self.to_the_end(&mut machine);
        let wrote = !machine.outputs().is_empty();
        machine.restart(Contacts::Perfect);
        let second = self.to_the_end(&mut machine);
        // A file that the first run has written stays.
        assert!(wrote || second == first, "a second run does something else");
    }

    fn to_the_end(&self, machine: &mut Machine) -> String {
        to_its_end(self.text, machine);
        assert!(machine.is_over() && machine.blocks_run() <= SMALL.blocks);
        let results: Vec<_> = machine.cycles().iter().map(|run| &run.result.results).collect();
        format!("{:?} {:?} {results:?} {}", machine.variables(), machine.windows(), machine.blocks_run())
    }
}

/// Runs a program to its end or to a fault; what is said of it has a sentence.
pub fn to_its_end(bytes: &[u8], machine: &mut Machine) {
    loop {
        match machine.run(100) {
            Ok(Step::Ended) => break,
            Ok(_) => {}
            Err(fault) => {
                told(bytes, &fault);
                break;
            }
        }
    }
    machine.remarks().iter().take(3).for_each(|(_, remark)| told(bytes, remark));
}

/// What went wrong has a sentence in every language. Sentences take far longer than reading, so one input in a hundred
/// or so has to make them.
pub fn told(bytes: &[u8], what: &impl Say) {
    thread_local! {
        static WORDS: Vec<Words> = Language::all().map(Words::new).collect();
    }
    if bytes.iter().fold(0_u8, |sum, byte| sum.wrapping_mul(31).wrapping_add(*byte)).is_multiple_of(128) {
        let message = what.message();
        WORDS.with(|words| {
            for language in words {
                let said = language.say(&message);
                assert!(!said.is_empty() && said != message.id, "{} has no text", message.id);
            }
        });
    }
}
