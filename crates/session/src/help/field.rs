//! The text field of the help page.

/// A text field of the help page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum HelpField {
    /// What is searched for.
    Search,
}
