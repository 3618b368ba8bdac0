//! What a cycle is run with: values of parameters, the probe, the position of the machine.

use std::collections::BTreeMap;

use super::key::Key;
use super::value::{Angle, Value};
use crate::length::Length;
use crate::probing::touch_probe::TouchProbe;
use crate::tolerance::{Deviations, Nominal};

/// The values that a cycle is run with.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Inputs {
    pub(super) given: BTreeMap<Key, Value>,
    pub(super) filled: BTreeMap<Key, Value>,
    pub(super) globals: BTreeMap<Key, Value>,
    pub(super) probe: TouchProbe,
    pub(super) position: Option<[f64; 3]>,
}

impl Inputs {
    /// No values given, and the probe of the built-in table.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives a parameter a value; it is checked when the cycle runs.
    #[must_use]
    pub fn with(mut self, key: impl Into<Key>, value: Value) -> Self {
        self.given.insert(key.into(), value);
        self
    }

    /// Gives a parameter the value that PREDEF stands for, as GLOBAL DEF does in a program.
    #[must_use]
    pub fn with_global(mut self, key: impl Into<Key>, value: Value) -> Self {
        self.globals.insert(key.into(), value);
        self
    }

    /// Uses another row of the touch-probe table.
    #[must_use]
    pub const fn with_probe(mut self, probe: TouchProbe) -> Self {
        self.probe = probe;
        self
    }

    /// Sets where the ball's centre is before the cycle, mm. Only G785 without D and WB needs it.
    #[must_use]
    pub const fn with_position(mut self, position: [f64; 3]) -> Self {
        self.position = Some(position);
        self
    }

    /// The probe.
    pub const fn probe(&self) -> &TouchProbe {
        &self.probe
    }

    /// Where the ball's centre is before the cycle, mm, if that was set.
    pub const fn position(&self) -> Option<[f64; 3]> {
        self.position
    }

    /// The value of a parameter: the given one or, in the inputs of a result, its default.
    pub fn value(&self, key: impl Into<Key>) -> Option<&Value> {
        let key = key.into();
        self.filled.get(&key).or_else(|| self.given.get(&key))
    }

    /// Whether a value was given, so that no default is used.
    pub fn is_given(&self, key: impl Into<Key>) -> bool {
        self.given.contains_key(&key.into())
    }

    /// A length from checked inputs; zero if there is none.
    pub(in crate::probing) fn length(&self, key: impl Into<Key>) -> Length {
        if let Some(Value::Length(length)) = self.value(key) { *length } else { Length::ZERO }
    }

    /// The same in millimetres.
    pub(in crate::probing) fn mm(&self, key: impl Into<Key>) -> f64 {
        self.length(key).to_mm_f64()
    }

    pub(in crate::probing) fn angle(&self, key: impl Into<Key>) -> Angle {
        if let Some(Value::Angle(angle)) = self.value(key) { *angle } else { Angle::default() }
    }

    /// An angle from checked inputs in degrees; zero if there is none.
    pub(in crate::probing) fn degrees(&self, key: impl Into<Key>) -> f64 {
        self.angle(key).to_degrees_f64()
    }

    pub(in crate::probing) fn whole(&self, key: impl Into<Key>) -> i64 {
        if let Some(Value::Whole(whole)) = self.value(key) { *whole } else { 0 }
    }

    pub(in crate::probing) fn number(&self, key: impl Into<Key>) -> f64 {
        if let Some(Value::Number(number)) = self.value(key) { *number } else { 0.0 }
    }

    /// A nominal value from checked inputs; zero without a tolerance if there is none.
    pub(in crate::probing) fn nominal(&self, key: impl Into<Key>) -> Nominal {
        if let Some(Value::Nominal(nominal)) = self.value(key) { *nominal } else { Nominal::of(Length::ZERO) }
    }

    pub(in crate::probing) fn band(&self, key: impl Into<Key>) -> Option<Deviations> {
        if let Some(Value::Band(band)) = self.value(key) { *band } else { None }
    }
}
