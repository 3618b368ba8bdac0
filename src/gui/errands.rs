//! How errands are run.

/// How errands are run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Errands {
    /// On a thread: the window stays responsive.
    OnThread,
    /// At once: for tests. File dialogs answer that nothing was picked, and no program is started.
    AtOnce,
}
