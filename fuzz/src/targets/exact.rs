//! Arithmetic with twice the digits of a float: a number is the sum of two floats, the second below the last bit of the
//! first (Dekker 1971, Knuth's sum without a comparison).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number of about 32 digits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exact(f64, f64);

impl Exact {
    pub const ZERO: Self = Self(0.0, 0.0);

    /// The nearest float.
    pub fn float(self) -> f64 {
        self.0 + self.1
    }

    pub fn sqrt(self) -> Self {
        if self.0 <= 0.0 {
            return Self::ZERO;
        }
        let root = Self::from(self.0.sqrt());
        // One step of Newton's doubles the digits.
        root + (self - root * root) / (root + root)
    }
}

/// A sum and what its rounding lost.
fn sum(a: f64, b: f64) -> Exact {
    let sum = a + b;
    let from_b = sum - a;
    Exact(sum, (a - (sum - from_b)) + (b - from_b))
}

impl From<f64> for Exact {
    fn from(number: f64) -> Self {
        Self(number, 0.0)
    }
}

impl Add for Exact {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.0, other.0), sum(self.1, other.1));
        let middle = sum(high.0, high.1 + low.0);
        sum(middle.0, middle.1 + low.1)
    }
}

impl Neg for Exact {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0, -self.1)
    }
}

impl Sub for Exact {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Exact {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let high = self.0 * other.0;
        let lost = self.0.mul_add(other.0, -high);
        sum(high, lost + (self.0 * other.1 + self.1 * other.0))
    }
}

impl Div for Exact {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = Self::from(self.0 / other.0);
        let rest = self - first * other;
        let second = Self::from(rest.0 / other.0);
        let rest = rest - second * other;
        first + second + Self::from(rest.0 / other.0)
    }
}
