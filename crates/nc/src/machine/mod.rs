//! The machine: runs NC programs as a control does, within limits.
//!
//! | file | what |
//! |---|---|
//! | `run` | the machine as its users see it, and in `run/blocks` what each block does with the parts below |
//! | `flow` | labels, jumps, repeats, calls and returns |
//! | `values` | parameters and formulas |
//! | `tables` | FN 26, FN 27, FN 28 |
//! | `presets` | the preset table |
//! | `prints`, `logs` | FN 16: windows and files; the measuring logs of cycles (Q281) |
//! | `around`, `placement` | what is set up around measurements: tool axis, mode, global values, datum; where a cycle measures |
//! | `change` | changes of the system under which nothing is measured here |
//! | `alone` | what a measuring block loses where it is taken out of its program |
//! | `cycles`, `contacts` | `TCH PROBE`, and what the probe touches |
//! | `tool_call` | the tool in the spindle, as TOOL CALL says |
//! | `tools` | the tool table: the called tool, the tool of Q330 |
//! | `moves` | straight lines and the path of the ball's centre |
//! | `files`, `store` | what the run reads and writes, counted; where it comes from (`files::Folders`, or memory) |
//! | `path` | paths of the control |
//! | `budget`, `fault`, `remark`, `step` | what a run may use, why it stopped, its remarks, a step's outcome |
//!
//! Semantics as in the manuals (`docs/SOURCES.md`, Klartext); where they say nothing, a run stops with a fault that
//! says why, never with a guess. A program can do no harm: blocks, nesting, text, outputs and memory have budgets, and
//! only the store that the machine is given reads and writes files. A step takes no longer in a long program than in a
//! short one.

mod alone;
mod around;
mod budget;
mod change;
mod contacts;
mod cycles;
mod fault;
mod files;
mod flow;
mod logs;
mod moves;
mod path;
mod placement;
mod presets;
mod prints;
mod remark;
mod run;
mod step;
mod store;
mod tables;
mod tool_call;
mod tools;
mod values;

pub use alone::{Alone, alone};
pub use around::{DatumInForce, SetBy, Turn};
pub use budget::{Budget, Settings, UsedUp};
pub use change::Change;
pub use contacts::Contacts;
pub use cycles::CycleRun;
pub use fault::{BlockPlace, Counted, Fault, FaultKind};
pub use flow::Call;
pub use moves::{Travel, TravelKind};
pub use path::{NcPath, PathError};
pub use prints::{Window, Written};
pub use remark::Remark;
pub use run::Machine;
pub use step::{Pause, Step};
pub use store::{FileRead, InMemory, Origin, OtherNames, Shipped, Store, StoreError};
pub use tools::ToolChanged;
pub use values::shown;
