//! A program as it is shown: its outline, names of its parameters, the selected block. Made once, when it is opened.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck_nc::control::variables::Parameter;
use fitcheck_nc::machine::NcPath;
use fitcheck_nc::program::{Body, Columns, Notation, Program, ProgramError, ProgramWarning, Target};

use super::inputs::assigned;
use super::named_tools::{ToolOf, named};
use super::tokens::comment;

/// A shown program.
#[derive(Debug, Clone)]
pub struct Document {
    /// Its path, as programs write it.
    pub path: NcPath,
    pub program: Arc<Program>,
    /// Structure blocks and labels, in the order of the program.
    pub outline: Vec<Entry>,
    names: BTreeMap<Parameter, String>,
    /// Plain values that the program assigns before it does anything else.
    assigned: BTreeMap<Parameter, String>,
    /// Whether a run of it may move the probe: it measures or calls a program.
    pub may_measure: bool,
    /// The tools that its cycles name in Q330.
    tools: Vec<ToolOf>,
    /// The selected block.
    pub selected: usize,
    longest: usize,
}

/// A place that can be jumped to from the outline.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    pub block: usize,
    /// Structure or label.
    pub kind: EntryKind,
    /// How deep a structure block is, from 1; 1 for a label.
    pub depth: usize,
    pub text: String,
}

/// What an entry of the outline is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum EntryKind {
    /// A structure block.
    Heading,
    Label,
}

impl Document {
    /// Reads a program and looks through it once; `name` is its file name.
    ///
    /// # Errors
    /// [`ProgramError`] where the bytes are not text.
    pub fn read(name: &str, bytes: &[u8]) -> Result<(Self, Vec<ProgramWarning>), ProgramError> {
        let (program, warnings) = Program::read(bytes)?;
        Ok((Self::new(NcPath::of_file(name), Arc::new(program)), warnings))
    }

    pub(super) fn new(path: NcPath, program: Arc<Program>) -> Self {
        let blocks = program.blocks().iter().enumerate();
        let outline = blocks.filter_map(|(block, of)| entry(block, &of.body)).collect();
        let longest = (0..program.line_count()).map(|line| program.line(line).chars().count()).max().unwrap_or(0);
        let names = names(&program);
        let assigned = assigned(&program);
        let measures = |body: &Body| matches!(body, Body::Probe(_) | Body::CallProgram(_));
        let may_measure = program.blocks().iter().any(|block| measures(&block.body));
        let tools = named(&program);
        Self { path, program, outline, names, assigned, may_measure, tools, selected: 0, longest }
    }

    /// Its file name.
    pub fn title(&self) -> &str {
        self.path.file_name()
    }

    /// The structure or label that a block is under, as its number in the outline.
    pub fn under(&self, block: usize) -> Option<usize> {
        self.outline.partition_point(|entry| entry.block <= block).checked_sub(1)
    }

    /// The name of a parameter: the comment at its first assignment.
    pub fn name_of(&self, parameter: Parameter) -> Option<&str> {
        self.names.get(&parameter).map(String::as_str)
    }

    /// Plain values that the program assigns to parameters before it does anything else.
    pub(super) const fn assigned(&self) -> &BTreeMap<Parameter, String> {
        &self.assigned
    }

    /// The tools that its cycles name in Q330, each once.
    pub(super) fn tools(&self) -> &[ToolOf] {
        &self.tools
    }

    pub(super) fn select(&mut self, block: usize) {
        self.selected = block.min(self.program.blocks().len().saturating_sub(1));
    }

    /// The line that a block begins in, counted from 0.
    pub fn first_line(&self, block: usize) -> usize {
        self.program.blocks().get(block).map_or(0, |block| block.lines.start)
    }

    /// How many characters the longest line has.
    pub const fn longest_line(&self) -> usize {
        self.longest
    }
}

fn entry(block: usize, body: &Body) -> Option<Entry> {
    match body {
        Body::Heading { depth, text } => {
            Some(Entry { block, kind: EntryKind::Heading, depth: *depth, text: text.clone() })
        }
        // LBL 0 ends subprograms: nothing jumps there.
        Body::Label(Target::Number(0)) => None,
        Body::Label(target) => {
            let text = match target {
                Target::Number(number) => format!("LBL {number}"),
                Target::Name(name) => format!("LBL \"{name}\""),
                Target::Parameter(parameter) => format!("LBL {parameter}"),
            };
            Some(Entry { block, kind: EntryKind::Label, depth: 1, text })
        }
        Body::Subprogram { label, .. } => {
            Some(Entry { block, kind: EntryKind::Label, depth: 1, text: format!("SUBPROGRAM {label}") })
        }
        _ => None,
    }
}

/// The comments after assignments; the first one for a parameter counts.
fn names(program: &Program) -> BTreeMap<Parameter, String> {
    let mut names = BTreeMap::new();
    for (index, block) in program.blocks().iter().enumerate() {
        let to = match &block.body {
            Body::Assign { to, .. } | Body::AssignText { to, .. } => to,
            // With several columns the comment would be about all of them.
            Body::TableRead { to, columns, .. } if !matches!(columns, Columns::Names(names) if 1 < names.len()) => to,
            _ => continue,
        };
        if names.contains_key(to) {
            continue;
        }
        let said = match program.notation() {
            Notation::DinPlus => program.comment_of(index),
            Notation::Klartext | Notation::Iso => comment(program.line(block.lines.start)),
        };
        if let Some(name) = said.filter(|name| !name.is_empty()) {
            names.insert(*to, name.to_owned());
        }
    }
    names
}
