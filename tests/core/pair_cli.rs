//! `fitcheck pair`, through the built program.
