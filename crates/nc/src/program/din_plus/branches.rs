//! IF, WHILE, SWITCH and subprograms: each block knows the block that comes next when its condition does not hold.

use super::super::block::{Block, Body, Target};
use super::super::expression::{Expression, Relation, Test};
use super::super::fault::BlockFault;
use super::language::RETURN;
use super::statement::Said;

/// Where a branch goes until its end is found; one without an end is refused.
const NOT_FOUND: usize = usize::MAX;

/// A branch or subprogram that has not ended.
#[derive(Debug)]
struct Open {
    block: usize,
    kind: BranchKind,
}

#[derive(Debug)]
enum BranchKind {
    If {
        /// Whether `THEN` on a line of its own may follow.
        takes_then: bool,
        otherwise: Option<usize>,
    },
    While,
    Switch(Switch),
    Subprogram,
}

#[derive(Debug)]
struct Switch {
    value: Expression,
    /// The last `CASE`, which goes to the next one.
    case: Option<usize>,
    has_default: bool,
    /// Whether the next `CASE` cannot be reached from the block before it.
    is_left: bool,
    breaks: Vec<usize>,
}

impl BranchKind {
    /// How it begins and how it ends.
    const fn words(&self) -> (&'static str, &'static str) {
        match self {
            Self::If { .. } => ("IF", "ENDIF"),
            Self::While => ("WHILE", "ENDWHILE"),
            Self::Switch(_) => ("SWITCH", "ENDSWITCH"),
            Self::Subprogram => ("SUBPROGRAM", RETURN),
        }
    }
}

/// A beginning whose end does not occur, by its block.
pub(super) type Unended = (usize, BlockFault);

/// The branches that are open while blocks are read.
#[derive(Debug, Default)]
pub(super) struct Branches(Vec<Open>);

impl Branches {
    /// Whether a subprogram is open.
    pub(super) fn is_in_subprogram(&self) -> bool {
        self.0.iter().any(|open| matches!(open.kind, BranchKind::Subprogram))
    }

    /// Opens what a line begins that cannot be understood, so that its end belongs to it.
    pub(super) fn open_other(&mut self, code: &str, block: usize) {
        let begins = |word: &str| {
            let rest = code.split_at_checked(word.len()).filter(|(begin, _)| begin.eq_ignore_ascii_case(word));
            rest.is_some_and(|(_, rest)| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
        };
        let kind = match () {
            () if begins("IF") => BranchKind::If { takes_then: true, otherwise: None },
            () if begins("WHILE") => BranchKind::While,
            () if begins("SWITCH") => BranchKind::Switch(Switch::of(Expression::Pi)),
            () => return,
        };
        self.0.push(Open { block, kind });
    }

    /// The body of the next block; sets where the blocks before it go.
    pub(super) fn body(&mut self, said: Said, blocks: &mut [Block]) -> Result<Body, BlockFault> {
        let at = blocks.len();
        if !matches!(said, Said::Case(_) | Said::Default | Said::EndSwitch | Said::Body(Body::Nothing))
            && let Some(Open { kind: BranchKind::Switch(switch), .. }) = self.0.last_mut()
        {
            switch.is_left = false;
        }
        match said {
            Said::Body(body) => Ok(body),
            Said::If(test) => Ok(self.open(at, BranchKind::If { takes_then: true, otherwise: None }, test)),
            Said::While(test) => Ok(self.open(at, BranchKind::While, test)),
            Said::Then => match self.0.last_mut() {
                Some(Open { kind: BranchKind::If { takes_then, otherwise: None }, .. }) if *takes_then => {
                    *takes_then = false;
                    Ok(Body::Nothing)
                }
                _ => Err(alone("THEN", "IF")),
            },
            Said::Else => match self.0.last_mut() {
                Some(Open { block, kind: BranchKind::If { otherwise: otherwise @ None, .. } }) => {
                    *otherwise = Some(at);
                    go(blocks, *block, at + 1);
                    Ok(always(NOT_FOUND))
                }
                _ => Err(alone("ELSE", "IF")),
            },
            Said::EndIf => match self.0.pop_if(|open| matches!(open.kind, BranchKind::If { .. })) {
                Some(Open { block, kind: BranchKind::If { otherwise, .. } }) => {
                    go(blocks, otherwise.unwrap_or(block), at);
                    Ok(Body::Nothing)
                }
                _ => Err(alone("ENDIF", "IF")),
            },
            Said::EndWhile => match self.0.pop_if(|open| matches!(open.kind, BranchKind::While)) {
                Some(Open { block, .. }) => {
                    go(blocks, block, at + 1);
                    Ok(always(block))
                }
                None => Err(alone("ENDWHILE", "WHILE")),
            },
            Said::Switch(value) => {
                self.0.push(Open { block: at, kind: BranchKind::Switch(Switch::of(value)) });
                Ok(Body::Nothing)
            }
            Said::Case(value) => self.switch("CASE")?.next_case(at, Some(value), blocks),
            Said::Default => self.switch("DEFAULT")?.next_case(at, None, blocks),
            Said::Break => self.leave(at),
            Said::EndSwitch => self.end_switch(at, blocks),
            Said::Subprogram(label) => {
                self.0.push(Open { block: at, kind: BranchKind::Subprogram });
                Ok(Body::Subprogram { label, behind: NOT_FOUND })
            }
            Said::Return => match self.0.pop_if(|open| matches!(open.kind, BranchKind::Subprogram)) {
                Some(Open { block, .. }) => {
                    go(blocks, block, at + 1);
                    Ok(Body::Label(Target::Number(0)))
                }
                None => Err(alone(RETURN, "SUBPROGRAM")),
            },
            // The reader of the blocks looks after units.
            Said::Unit | Said::EndOfUnit => Ok(Body::Other),
        }
    }

    fn open(&mut self, block: usize, kind: BranchKind, test: Test) -> Body {
        self.0.push(Open { block, kind });
        Body::Branch { unless: Some(Box::new(test)), to: NOT_FOUND }
    }

    fn switch(&mut self, found: &'static str) -> Result<&mut Switch, BlockFault> {
        match self.0.last_mut() {
            Some(Open { kind: BranchKind::Switch(switch), .. }) => Ok(switch),
            _ => Err(alone(found, "SWITCH")),
        }
    }

    /// `BREAK` leaves the SWITCH that it stands in, also from within an IF. Whether it leaves a WHILE is not documented.
    fn leave(&mut self, at: usize) -> Result<Body, BlockFault> {
        let is_last = matches!(self.0.last(), Some(Open { kind: BranchKind::Switch(_), .. }));
        let mut around = self.0.iter_mut().rev().skip_while(|open| matches!(open.kind, BranchKind::If { .. }));
        match around.next() {
            Some(Open { kind: BranchKind::Switch(switch), .. }) => {
                switch.breaks.push(at);
                switch.is_left = is_last;
                Ok(always(NOT_FOUND))
            }
            _ => Err(alone("BREAK", "SWITCH")),
        }
    }

    fn end_switch(&mut self, at: usize, blocks: &mut [Block]) -> Result<Body, BlockFault> {
        match self.0.pop_if(|open| matches!(open.kind, BranchKind::Switch(_))) {
            Some(Open { kind: BranchKind::Switch(Switch { case, breaks, .. }), .. }) => {
                case.into_iter().chain(breaks).for_each(|from| go(blocks, from, at));
                Ok(Body::Nothing)
            }
            _ => Err(alone("ENDSWITCH", "SWITCH")),
        }
    }

    /// Ends what is open within the subprogram, or all where `and_subprogram` says so: refuses its blocks, and says what is
    /// missing.
    pub(super) fn end(&mut self, and_subprogram: bool, blocks: &mut [Block]) -> Vec<Unended> {
        let mut found = Vec::new();
        while let Some(open) = self.0.pop_if(|open| and_subprogram || !matches!(open.kind, BranchKind::Subprogram)) {
            let (begins, missing) = open.kind.words();
            let inner = match open.kind {
                BranchKind::If { otherwise, .. } => otherwise.into_iter().collect(),
                BranchKind::Switch(Switch { case, breaks, .. }) => case.into_iter().chain(breaks).collect(),
                BranchKind::While | BranchKind::Subprogram => Vec::new(),
            };
            for block in inner.into_iter().chain([open.block]) {
                if let Some(block) = blocks.get_mut(block) {
                    block.body = Body::Other;
                }
            }
            found.push((open.block, alone(begins, missing)));
        }
        found
    }
}

impl Switch {
    const fn of(value: Expression) -> Self {
        Self { value, case: None, has_default: false, is_left: true, breaks: Vec::new() }
    }

    /// `CASE 1`, or `DEFAULT` without a value. Nothing may run into it from the case before: whether it would is not
    /// documented.
    fn next_case(&mut self, at: usize, value: Option<Expression>, blocks: &mut [Block]) -> Result<Body, BlockFault> {
        let found = if value.is_some() { "CASE" } else { "DEFAULT" };
        if self.has_default {
            return Err(alone(found, "ENDSWITCH"));
        }
        if self.case.is_some() && !self.is_left {
            return Err(alone(found, "BREAK"));
        }
        self.is_left = false;
        if let Some(case) = self.case.take() {
            go(blocks, case, at);
        }
        let Some(value) = value else {
            self.has_default = true;
            return Ok(Body::Nothing);
        };
        self.case = Some(at);
        let test = Test::Compare(self.value.clone(), Relation::Equal, value);
        Ok(Body::Branch { unless: Some(Box::new(test)), to: NOT_FOUND })
    }
}

const fn alone(found: &'static str, missing: &'static str) -> BlockFault {
    BlockFault::Alone { found, missing }
}

const fn always(to: usize) -> Body {
    Body::Branch { unless: None, to }
}

/// Sets where a block goes.
fn go(blocks: &mut [Block], from: usize, destination: usize) {
    match blocks.get_mut(from).map(|block| &mut block.body) {
        Some(Body::Branch { to, .. }) => *to = destination,
        Some(Body::Subprogram { behind, .. }) => *behind = destination,
        // Not understood, so it is refused when it is reached.
        _ => {}
    }
}
