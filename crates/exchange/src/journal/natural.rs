//! Texts in the order in which people count: part 2 before part 10.

use std::cmp::Ordering;

/// A text whose numbers count as numbers; case decides only where nothing else does.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Natural(pub String);

impl Ord for Natural {
    fn cmp(&self, other: &Self) -> Ordering {
        natural(&self.0, &other.0).then_with(|| self.0.cmp(&other.0))
    }
}

impl PartialOrd for Natural {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

fn natural(mut one: &str, mut other: &str) -> Ordering {
    loop {
        let order = match (number(&mut one), number(&mut other)) {
            // A longer number without leading zeros is larger.
            (Some(a), Some(b)) => a.len().cmp(&b.len()).then_with(|| a.cmp(b)),
            (a, b) => {
                let first = |number: Option<&str>, rest: &mut &str| match number {
                    // Every number stands where its digits stand among the characters.
                    Some(_) => Some('0'),
                    None => character(rest),
                };
                let a = first(a, &mut one);
                let b = first(b, &mut other);
                if a.is_none() && b.is_none() {
                    return Ordering::Equal;
                }
                a.cmp(&b)
            }
        };
        if order.is_ne() {
            return order;
        }
    }
}

/// Takes the number at the front, without leading zeros.
fn number<'a>(text: &mut &'a str) -> Option<&'a str> {
    let end = text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let (digits, rest) = text.split_at_checked(end).filter(|(digits, _)| !digits.is_empty())?;
    *text = rest;
    Some(digits.trim_start_matches('0'))
}

/// Takes the character at the front, in small letters.
fn character(text: &mut &str) -> Option<char> {
    let mut characters = text.chars();
    let first = characters.next()?;
    *text = characters.as_str();
    Some(first.to_lowercase().next().unwrap_or(first))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_count_as_numbers() {
        let sorted = ["", " 1", "+", "2", "010", "10", "A1", "a2", "A10", "a10", "A10b", "B", "b", "é"];
        for (place, one) in sorted.iter().enumerate() {
            for (other_place, other) in sorted.iter().enumerate() {
                let order = Natural((*one).to_owned()).cmp(&Natural((*other).to_owned()));
                assert_eq!(order, place.cmp(&other_place), "{one:?} {other:?}");
            }
        }
    }
}
