//! Lines of a cycle that a missing sign has put into a block of their own.
//!
//! A cycle whose line lacks its `~` ends there. What a control makes of the next line is on no page that we found; read alone,
//! `Q275=+25.01` is an assignment, and the cycle would measure without its limit. So such a line is refused.

use fitcheck_core::probing::cycle::{Control, Cycle};
use fitcheck_core::probing::cycles::cycles_of;

use super::super::block::Body;
use super::super::cycle_block::CycleBlock;
use super::super::error::ProgramWarningKind;
use super::super::lines::{Front, Piece};
use crate::control::variables::Parameter;

/// A cycle, and nothing behind it yet but comments and lines that may be its own.
#[derive(Debug)]
pub(in super::super) struct Before {
    has_number: bool,
    code: String,
    /// Its last line, from 1.
    line: usize,
}

impl Before {
    /// The cycle that a block is, or that it still stands behind.
    pub(in super::super) fn after(
        before: Option<Self>,
        front: Front,
        body: &Body,
        end: usize,
        is_cut_off: bool,
    ) -> Option<Self> {
        match body {
            Body::Probe(CycleBlock { number, .. }) => {
                Some(Self { has_number: front.number.is_some(), code: number.clone(), line: end })
            }
            Body::Nothing => before,
            _ if is_cut_off => before,
            _ => None,
        }
    }

    fn declares(&self, parameter: Parameter) -> bool {
        let cycle: Option<&Cycle> = cycles_of(Control::Milling).find(|cycle| cycle.code == self.code);
        cycle.is_some_and(|cycle| cycle.parameter_named(&parameter.to_string()).is_some())
    }
}

/// What is wrong, in which of the pieces, and whether the block can mean something else: a control may read it otherwise than
/// whoever wrote it.
pub(in super::super) struct CutOff {
    pub piece: usize,
    pub what: ProgramWarningKind,
    pub is_refused: bool,
}

/// `Q275=+25.01` where the cycle's next line would stand.
pub(in super::super) fn assigned(
    before: Option<&Before>,
    front: Front,
    first: &Piece<'_>,
    read: &Body,
) -> Option<CutOff> {
    let before = before?;
    let (Body::Assign { to: parameter, .. } | Body::AssignText { to: parameter, .. }) = read else { return None };
    // `FN 0:` and `DECLARE STRING` begin no line of a cycle.
    if !first.code.starts_with(['Q', 'q']) {
        return None;
    }
    let is_unnumbered = front.number.is_none();
    let is_line = is_unnumbered && before.has_number || before.declares(*parameter) || first.goes_on;
    let what = ProgramWarningKind::CycleCut { cycle: before.code.clone(), line: before.line, parameter: *parameter };
    is_line.then_some(CutOff { piece: 0, what, is_refused: is_unnumbered || first.goes_on })
}
