//! NC programs: read and written, run, and made for a control to measure with.
//!
//! | file | what |
//! |---|---|
//! | `program` | NC programs in Klartext, read and written: text in, blocks and warnings out |
//! | `machine` | runs NC programs, within limits; reads and writes through the store that it is given |
//! | `sets` | programs, tables and mask for a control to measure a plan, as bytes |
//!
//! `sets` uses `machine`, which uses `program`. Masks, tables, parameters and logs belong to `control`; nothing in
//! `control` uses this room, and nothing in this room reads a file.

pub mod control;
pub mod machine;
pub mod program;
pub mod sets;
