//! What the notations of milling controls, Klartext and ISO, have in common.
//!
//! | file | what |
//! |---|---|
//! | `blocks` | from lines to blocks; what each notation does in its own way is a [`Form`] |
//! | `cut_off` | lines of a cycle that a missing sign has put into a block of their own |
//! | `cycle` | the lines of a cycle |

mod blocks;
mod cut_off;
mod cycle;

pub(super) use blocks::{Form, Reader};
pub(super) use cut_off::{Before, CutOff, assigned};
pub(super) use cycle::{first_parameter, head as cycle_head, line as cycle_line, with_lines};
