//! The file formats of the control.
//!
//! | file | what |
//! |---|---|
//! | `cycle_status` | the status window of a measuring cycle |
//! | `variables` | Q, QL, QR and QS parameters |
//! | `table` | freely definable tables `.TAB`, three header generations, read and written |
//! | `probe_table` | the touch-probe table `tchprobe.tp` |
//! | `tool_table` | the tool table `tool.t`, and what measuring cycles change in it (Q330) |
//! | `deviations` | such a table as a table of deviations; the two built-in ones |
//! | `mask` | FN 16 masks, read and rendered |
//! | `log` | measuring logs as texts, read and written |
//! | `point_log` | the log of points as HTML, read and written |
//! | `probe_block` | the block of a probing cycle in an NC program, read and written |
//! | `simulated` | the line that marks what a simulation has written |
//! | `cycle_log` | from a cycle's result to its log |

pub mod cycle_log;
pub mod cycle_status;
pub mod deviations;
pub mod log;
pub mod mask;
pub mod point_log;
pub mod probe_block;
pub mod probe_table;
pub mod simulated;
pub mod status;
pub mod table;
pub mod tool_table;
pub mod variables;

pub use deviations::shipped_tables;
