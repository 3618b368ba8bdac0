//! Decimal numbers digit by digit, as on paper: slow, of any length, without floats and without the crate's own code.

/// A decimal number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Decimal {
    is_negative: bool,
    /// Digits, the most significant first.
    digits: Vec<u8>,
    /// How many of them come after the point.
    decimals: usize,
}

impl Decimal {
    /// A number from its digits before and after the point.
    pub fn of(is_negative: bool, whole: &str, decimals: &str) -> Self {
        let digits = whole.bytes().chain(decimals.bytes()).map(|digit| digit - b'0').collect();
        Self { is_negative, digits, decimals: decimals.len() }
    }

    /// A plain number as Rust prints it.
    pub fn plain(text: &str) -> Self {
        let (is_negative, text) = text.strip_prefix('-').map_or((false, text), |text| (true, text));
        let (whole, decimals) = text.split_once('.').unwrap_or((text, ""));
        Self::of(is_negative, whole, decimals)
    }

    /// Its product with a small number.
    pub fn times(mut self, factor: u32) -> Self {
        let mut carry = 0;
        for digit in self.digits.iter_mut().rev() {
            let product = u32::from(*digit) * factor + carry;
            *digit = last_digit(product);
            carry = product / 10;
        }
        while 0 < carry {
            self.digits.insert(0, last_digit(carry));
            carry /= 10;
        }
        self
    }

    /// Its product with this power of ten.
    pub fn times_ten_to(mut self, power: usize) -> Self {
        for _ in 0..power {
            if self.decimals == 0 { self.digits.push(0) } else { self.decimals -= 1 }
        }
        self
    }

    /// The number over this power of ten.
    pub fn over_ten_to(mut self, power: usize) -> Self {
        self.decimals += power;
        while self.digits.len() <= self.decimals {
            self.digits.insert(0, 0);
        }
        self
    }

    /// Whether all digits after the point are zero.
    pub fn is_whole(&self) -> bool {
        self.digits.iter().rev().take(self.decimals).all(|digit| *digit == 0)
    }

    /// Rounded half away from zero.
    pub fn rounded(mut self, decimals: usize) -> Self {
        while self.decimals < decimals {
            self.digits.push(0);
            self.decimals += 1;
        }
        let dropped = self.digits.split_off(self.digits.len() - (self.decimals - decimals));
        self.decimals = decimals;
        if dropped.first().is_some_and(|digit| 5 <= *digit) {
            for digit in self.digits.iter_mut().rev() {
                *digit = (*digit + 1) % 10;
                if *digit != 0 {
                    return self;
                }
            }
            self.digits.insert(0, 1);
        }
        self
    }

    /// With all its decimals, at least one digit before the point, and a minus unless it is zero.
    pub fn text(&self) -> String {
        let mut text =
            String::from(if self.is_negative && self.digits.iter().any(|digit| *digit != 0) { "-" } else { "" });
        let (whole, decimals) = self.digits.split_at(self.digits.len() - self.decimals);
        let zeros = whole.iter().take_while(|digit| **digit == 0).count().min(whole.len().saturating_sub(1));
        text.extend(whole[zeros..].iter().map(|digit| char::from(b'0' + digit)));
        if whole.is_empty() {
            text.push('0');
        }
        if !decimals.is_empty() {
            text.push('.');
            text.extend(decimals.iter().map(|digit| char::from(b'0' + digit)));
        }
        text
    }
}

fn last_digit(number: u32) -> u8 {
    (number % 10).to_le_bytes()[0]
}
