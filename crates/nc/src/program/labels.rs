//! Where the labels of a program are.

use std::collections::HashMap;

use super::block::{Block, Body, Target};
use super::error::LabelFault;

/// Labels by number and by name; `LBL 0` does not count.
#[derive(Debug, Clone, Default)]
pub(super) struct Labels(HashMap<Target, LabelPlace>);

#[derive(Debug, Clone, Copy)]
struct LabelPlace {
    block: usize,
    line: usize,
    /// The line where it is defined again.
    again: Option<usize>,
}

/// A label that is defined again, and its first place.
pub(super) struct RepeatedLabel<'a> {
    pub label: &'a Target,
    pub line: usize,
    pub first: usize,
}

impl Labels {
    /// Finds the labels of blocks, and those defined more than once. Lines count from 1.
    pub(super) fn of(blocks: &[Block]) -> (Self, Vec<RepeatedLabel<'_>>) {
        let mut labels = Self::default();
        let mut twice = Vec::new();
        for (block, of) in blocks.iter().enumerate() {
            let (label, block) = match &of.body {
                Body::Label(label) => (label, block),
                // A call begins behind the line that names the subprogram.
                Body::Subprogram { label, .. } => (label, block + 1),
                _ => continue,
            };
            if *label == Target::Number(0) {
                continue;
            }
            let line = of.lines.start + 1;
            match labels.0.get_mut(label) {
                Some(found) => {
                    found.again.get_or_insert(line);
                    twice.push(RepeatedLabel { label, line, first: found.line });
                }
                None => {
                    labels.0.insert(label.clone(), LabelPlace { block, line, again: None });
                }
            }
        }
        (labels, twice)
    }

    pub(super) fn block(&self, label: &Target) -> Result<usize, LabelFault> {
        match label {
            Target::Parameter(_) => return Err(LabelFault::Parameter { label: label.clone() }),
            Target::Number(0) => return Err(LabelFault::Zero),
            Target::Number(_) | Target::Name(_) => {}
        }
        match self.0.get(label) {
            None => Err(LabelFault::Missing { label: label.clone() }),
            Some(LabelPlace { line, again: Some(second), .. }) => {
                Err(LabelFault::Twice { label: label.clone(), first: *line, second: *second })
            }
            Some(found) => Ok(found.block),
        }
    }
}
