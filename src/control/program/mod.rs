//! NC programs in Klartext: read, shown and written again.
//!
//! | file | what |
//! |---|---|
//! | `block` | what a block says |
//! | `expression` | formulas of numbers and texts |
//! | `read` | text to blocks, with warnings |
//! | `write` | blocks to text: a program that was read comes back byte for byte, but for trailing blanks |
//!
//! A program keeps its text; a block is a range of its lines and what they say. What is not known is kept as text
//! ([`Body::Other`]), never refused: real programs hold far more than Fitcheck runs. Running is the business of
//! [`super::machine`]. Grammar: manuals and public programs, see `docs/SOURCES.md`.

mod block;
mod expression;

pub use block::{
    Axis, AxisWord, Block, Body, Columns, Condition, CycleBlock, CycleLine, CycleValue, Feed, MachineFunction,
    Movement, Operand, Place, Relation, Target, TextOperand, Tool, Unit,
};
pub use expression::{Expression, NumberFunction, Operation, TextExpression};
