//! The drawings of the cycles page. They show what they are given and decide nothing; nothing in them moves.
//!
//! | file | what |
//! |---|---|
//! | `parameter` | the drawing of a parameter by its declared meaning and its cycle's shape, and its sentence |
//! | `tile` | the small picture of a cycle, by which it is chosen |
//! | `plan`, `section`, `choice`, `general` | its views: from above, from the side, one of a few numbers, any other |
//! | `path`, `scale` | the path of the ball's centre, from above and from the side; one view of it |
//! | `system` | the zero and the axes of a program in such a view |
//! | `part` | the features of a simulated part in such a view |
//! | `contacts` | contacts about a circle, deviations magnified; `bar`: one deviation between its limits |
//! | `criteria` | every criterion of a circle side by side |
//! | `canvas` | lines, arrows, dimensions, labels: what all drawings are made of |
//!
//! Every drawing has a name that says in words what it shows.

mod bar;
mod canvas;
mod choice;
mod contacts;
mod criteria;
mod general;
mod parameter;
mod part;
mod path;
mod plan;
mod scale;
mod scene;
mod section;
mod system;
#[cfg(test)]
mod tests;
mod tile;
mod way;

pub(in crate::gui) use contacts::{contacts_factor, contacts_picture};
pub(in crate::gui) use criteria::criteria_table;
pub(in crate::gui) use parameter::{parameter_picture, parameter_range, parameter_sentence};
pub(in crate::gui) use path::{Surroundings, path_picture};
pub(in crate::gui) use tile::tile_picture;
