//! Simulated stays simulated, corrected stays corrected, and no name is more than a name.
#[path = "core/hostile.rs"]
mod hostile;
#[path = "core/told_again.rs"]
mod told_again;
