//! The inspection report: one model, one file a rendering.
