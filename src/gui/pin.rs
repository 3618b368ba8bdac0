//! The PIN that locks the operator's window: only its salted hash is kept, in the form of the library's.

use argon2::{Argon2, PasswordHasher as _, PasswordVerifier as _};

use crate::message::{Message, message};

/// The hash of a PIN, with a salt of its own.
pub(super) fn hash(pin: &str) -> Result<String, Message> {
    let hashed = Argon2::default().hash_password(pin.as_bytes());
    hashed.map(|hash| hash.to_string()).map_err(|error| message!("operator-pin-not-hashed").text("why", error))
}

/// Whether a PIN is the one of a hash; a hash that is none opens to nobody.
pub(super) fn is_it(pin: &str, hash: &str) -> bool {
    Argon2::default().verify_password(pin.as_bytes(), hash).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pin_opens_its_own_hash_and_two_hashes_of_one_pin_differ() {
        let [one, other] = [hash("4711"), hash("4711")].map(Result::unwrap);
        assert_ne!(one, other, "the salt is random");
        assert!(!one.contains("4711") && one.starts_with("$argon2id$"), "{one}");
        assert!(is_it("4711", &one) && is_it("4711", &other));
        assert!(!is_it("4712", &one) && !is_it("", &one) && !is_it("4711", "") && !is_it("4711", "no hash"));
    }
}
