//! What status windows are drawn with: the status words and the built-in masks.

use std::sync::{LazyLock, OnceLock};

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Dialogue;
use fitcheck_shipped as shipped;

use super::mask::Mask;
use super::variables::Value;

/// The status word that program 82551 puts into QS3; the Dutch words are those of NC-Solution 8255, letter by letter.
pub fn status_word(status: Status, dialogue: Dialogue) -> &'static str {
    let words = &dialogue.words().status;
    match status {
        Status::Good => &words.good,
        Status::Rework => &words.rework,
        Status::Scrap => &words.scrap,
        Status::ReMeasure => &words.re_measure,
        Status::OutOfLimits => &words.out_of_limits,
    }
}

/// The status that a word means, in any dialogue language or as machines write it.
pub fn status_of(word: &str) -> Option<Status> {
    let small = word.trim().to_lowercase();
    let is = |known: &str| known.to_lowercase() == small;
    let means = |status: &Status| {
        is(status.word()) || Dialogue::ALL.into_iter().any(|dialogue| is(status_word(*status, dialogue)))
    };
    Status::ALL.into_iter().find(means)
}

/// A length in micrometres. The decimal text is exact, the product of a float and 1000 is not: 0.5015 mm would be
/// 501.49999999999994 µm.
pub fn micrometres(length: Length) -> Value {
    let exact = length.exact(Unit::Micrometre, 0).parse();
    Value::Number(exact.unwrap_or_else(|_never| length.to_mm_f64() * 1000.0))
}

/// The built-in mask with a name, such as a cycle's number, in a dialogue language: `427_nl.a`.
///
/// # Panics
/// Never: a test reads every shipped mask.
pub fn mask_named(name: &str, dialogue: Dialogue) -> Option<&'static Mask> {
    /// A file and, once it was wanted, what it says.
    type Shipped = (&'static str, &'static [u8], OnceLock<Mask>);
    static MASKS: LazyLock<Vec<Shipped>> =
        LazyLock::new(|| shipped::MASKS.iter().map(|(file, bytes)| (*file, *bytes, OnceLock::new())).collect());
    #[expect(clippy::expect_used, reason = "the files are part of the program and read by a test")]
    let read = |bytes| Mask::read(bytes).expect("a shipped mask can be read").0;
    let file = format!("{name}_{dialogue}.a");
    let (_, bytes, mask) = MASKS.iter().find(|(known, ..)| *known == file)?;
    Some(mask.get_or_init(|| read(bytes)))
}

/// The built-in mask of program 82551: `82552_nl.a` is that of NC-Solution 8255, byte for byte.
///
/// # Panics
/// Never: a test proves that every dialogue language has its masks.
pub fn shipped_mask(dialogue: Dialogue) -> &'static Mask {
    #[expect(clippy::expect_used, reason = "a test holds that every dialogue language has its masks")]
    mask_named("82552", dialogue).expect("every dialogue language has a mask")
}
