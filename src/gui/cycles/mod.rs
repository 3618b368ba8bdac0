//! The cycles page.
//!
//! | file | what |
//! |---|---|
//! | `picture` | drawings: what a parameter means, the probe's path, contacts, criteria |

// The page that shows the drawings follows; until then only tests do.
#![cfg_attr(not(test), expect(dead_code, unused_imports, reason = "shown by the page"))]

pub(super) mod picture;
