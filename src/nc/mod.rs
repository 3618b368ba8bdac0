//! NC programs: read and written, run, and made for a control to measure with.
//!
//! | file | what |
//! |---|---|
//! | `program` | NC programs in Klartext, read and written |
//! | `machine` | runs NC programs, within bounds |
//! | `sets` | programs, tables and mask with which a control measures a plan |

pub mod machine;
pub mod program;
pub mod sets;
