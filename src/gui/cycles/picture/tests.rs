//! The drawings, by what they say.
