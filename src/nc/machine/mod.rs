//! The machine: runs NC programs as a control does, within bounds.
//!
//! | file | what |
//! |---|---|
//! | `run`, `step` | the machine: its state, one block after the other, and what a step comes to |
//! | `view` | what it shows of itself |
//! | `flow` | jumps, calls, repeats, other programs |
//! | `values` | parameters and what blocks set |
//! | `expressions`, `texts` | formulas of numbers and texts |
//! | `known` | what was read before is not taken apart twice |
//! | `tables` | FN 26, FN 27, FN 28 |
//! | `prints` | FN 16: windows and files |
//! | `logs` | the measuring logs of cycles (Q281) |
//! | `cycles`, `contacts` | `TCH PROBE`, and what the probe touches |
//! | `moves` | straight lines and the way of the ball's centre |
//! | `path`, `store`, `folders` | paths of the control; where files come from and go to |
//! | `budget`, `fault`, `remark` | what a run may use, why it stopped, what is worth knowing |
//!
//! Semantics as the manuals say (`docs/SOURCES.md`, Klartext); where they are silent, a run stops with a fault that says
//! why, never with a guess. A program can do no harm: blocks, nesting, text, outputs and memory have budgets, files are
//! read from the given folders and written into one, and nothing else is touched. A step takes no longer in a long
//! program than in a short one.

mod budget;
mod contacts;
mod cycles;
mod expressions;
mod fault;
mod flow;
mod folders;
mod known;
mod logs;
mod moves;
mod path;
mod prints;
mod remark;
mod run;
mod step;
mod store;
mod tables;
mod texts;
mod values;
mod view;

#[cfg(test)]
mod tests;

pub use budget::{Budget, Settings, UsedUp};
pub use contacts::Contacts;
pub use cycles::CycleRun;
pub use fault::{BlockPlace, Fault, FaultKind};
pub use flow::Call;
pub use folders::Folders;
pub use moves::{Travel, TravelKind};
pub use path::{NcPath, PathError};
pub use prints::{Window, Written};
pub use remark::Remark;
pub use run::Machine;
pub use step::{Pause, Step};
pub use store::{InMemory, Shipped, Store, StoreError};
pub use values::shown;
