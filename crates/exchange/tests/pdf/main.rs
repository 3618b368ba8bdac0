//! Reports as PDF, read again by a small reader of our own: what the pages say, their logical structure, and what is attached.
//!
//! | file | what |
//! |---|---|
//! | `made` | reports to write |
//! | `values`, `reader` | a small reader of PDF files |
//! | `checks` | checks without a plan: rows, attachments, languages, paper |
//! | `parts` | whole parts with pictures |
//! | `names` | what names must not do |
//! | `templates` | what templates show and leave out, certificates, lots, labels, codes |
//! | `labels` | labels as pictures |
//! | `twelve` | a part of twelve features: every rendering and kind in four languages |

#![cfg(test)]

mod checks;
mod labels;
mod made;
mod names;
mod parts;
mod reader;
mod templates;
mod twelve;
mod values;
