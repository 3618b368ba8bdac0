//! NC programs: read and written, run, and made for a control to measure with.
//!
//! | file | what |
//! |---|---|
//! | `program` | NC programs in Klartext, read and written: text in, blocks and warnings out |
//! | `machine` | runs NC programs, within bounds; reads and writes by the store that it is handed |
//! | `sets` | programs, tables and mask with which a control measures a plan, as bytes |
//!
//! `sets` uses `machine`, which uses `program`. Masks, tables, parameters and logs are `control`'s; nothing in `control`
//! knows of this room, and nothing in this room reads a file.

pub mod machine;
pub mod program;
pub mod sets;
