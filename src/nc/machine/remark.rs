//! What is worth knowing about a run that went on.

use std::collections::BTreeMap;

use super::budget::Budget;
use super::fault::BlockPlace;
use super::path::NcPath;
use crate::control::variables::Parameter;
use crate::message::{Message, Say};

/// Something worth knowing.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "machine-remark")]
pub enum Remark {
    /// A block that is not known was passed over.
    Skipped,
    /// M2 or M30 in a called program ended the whole run.
    EndedWithin {
        /// The M function.
        function: u32,
    },
    /// A value that was given before the run stands in place of the block's.
    GivenWins {
        /// The parameter.
        parameter: Parameter,
        /// Its value.
        value: String,
    },
    /// FN 16, FN 27 or a measuring log wrote no file: no folder was chosen.
    NotWritten {
        /// The file.
        path: NcPath,
    },
    /// A table that FN 27 has changed could not be written after the run had already failed, or a measuring log.
    NotSaved {
        /// The file.
        path: NcPath,
        /// Why.
        reason: Message,
    },
    /// `M_APPEND_MAX`: the file has reached its size, nothing was added.
    Full {
        /// The file.
        path: NcPath,
        /// Its size, kilobytes.
        kilobytes: u32,
    },
    /// FN 27 has changed a table, and the file was written.
    TableWritten {
        /// The file.
        path: NcPath,
    },
    /// The run is over and recorded contacts are left: perhaps they belong to other features than those they were given to.
    ContactsLeft {
        /// How many there were.
        count: usize,
        /// How many the cycles took.
        used: usize,
    },
    /// The tool is not in the touch-probe table, the first probe was used.
    OtherProbe {
        /// The tool.
        tool: String,
        /// The probe.
        probe: u32,
    },
}

/// The remarks of a run: so many, then they are counted only.
#[derive(Debug)]
pub(super) struct Remarks {
    list: Vec<(BlockPlace, Remark)>,
    /// Which of the list are about a block.
    of: BTreeMap<BlockPlace, Vec<usize>>,
    unlisted: usize,
    most: usize,
}

impl Remarks {
    pub(super) const fn new(budget: &Budget) -> Self {
        Self { list: Vec::new(), of: BTreeMap::new(), unlisted: 0, most: budget.remarks }
    }

    /// Remembers what is worth knowing, once a block.
    pub(super) fn add(&mut self, place: BlockPlace, remark: Remark) {
        // Only those of the block are looked through: a loop makes the same ones again and again.
        let said = self.of.get(&place).into_iter().flatten();
        if said.filter_map(|number| self.list.get(*number)).any(|(_, said)| *said == remark) {
            return;
        }
        if self.list.len() < self.most {
            self.of.entry(place.clone()).or_default().push(self.list.len());
            self.list.push((place, remark));
        } else {
            self.unlisted += 1;
        }
    }

    pub(super) fn list(&self) -> &[(BlockPlace, Remark)] {
        &self.list
    }

    pub(super) const fn unlisted(&self) -> usize {
        self.unlisted
    }
}
