//! The measuring cycles.
