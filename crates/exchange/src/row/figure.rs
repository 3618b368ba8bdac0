//! An exact decimal, as files for programs have it.

use fitcheck_core::length::{Length, Unit};

use super::columns::Cell;

/// An exact decimal: unchanged in CSV, a number in JSON.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Figure(pub String);

impl Figure {
    /// Millimetres exactly, with at least this many decimals.
    pub fn mm(length: Length, decimals: usize) -> Self {
        Self(length.exact(Unit::Millimetre, decimals))
    }

    /// Micrometres exactly.
    pub fn um(length: Length) -> Self {
        Self(length.exact(Unit::Micrometre, 0))
    }
}

impl serde::Serialize for Figure {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match (self.0.parse::<i64>(), self.0.parse::<f64>()) {
            (Ok(whole), _) => serializer.serialize_i64(whole),
            // A length has at most 16 figures and none finer than a nanometre, so its nearest float prints the same.
            (_, Ok(number)) => serializer.serialize_f64(number),
            _ => serializer.serialize_str(&self.0),
        }
    }
}

impl Cell for Figure {
    fn cell(&self) -> Option<String> {
        Some(self.0.clone())
    }
}
