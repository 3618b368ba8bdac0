//! The chain of a journal: each entry is hashed over the one before, so that a changed, removed, inserted or reordered
//! entry is found and named.
//!
//! The hash is SHA-256 over this, numbers with their highest byte first:
//!
//! | what | bytes |
//! |---|---|
//! | `fitcheck entry 1` and a zero byte | 17 |
//! | the hash of the entry before; zeros for the first | 32 |
//! | how long the chain's name is, and the name | 4 + 16 |
//! | the entry's number, from 1 | 8 |
//! | how long the body is, and its bytes as they are kept | 4 + … |
//!
//! The frame tells each part's length, so no two entries have the same bytes; the words at its beginning keep it apart
//! from everything else that is hashed (RFC 6962 does both). A body is never parsed for it.
//!
//! What a chain alone cannot prove: that its newest entries were not cut off, or that an older copy was not put back. That takes a
//! [`Head`] that was kept elsewhere.

use std::fmt;
use std::str::FromStr;

use fitcheck_core::message::Say;
use sha2::{Digest as _, Sha256};

/// What the bytes of every entry begin with.
const DOMAIN: &[u8] = b"fitcheck entry 1\0";

/// The name of a chain: random, made with its first entry. A journal begun anew is another chain, whatever its station is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ChainId(pub [u8; 16]);

/// A SHA-256.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Hash(pub [u8; 32]);

/// An entry of a chain by its number and hash. One that was kept elsewhere proves all entries up to it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct Head {
    /// The entry's number, from 1; 0 where a chain has none.
    pub number: u64,
    /// Its hash; zeros where a chain has none.
    pub hash: Hash,
}

/// Not the hexadecimal digits of a hash or a chain's name.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(id = "journal-hex", error)]
pub struct HexError {
    /// What was given.
    pub text: String,
    /// How many digits there have to be.
    pub digits: usize,
}

impl Hash {
    /// SHA-256 of a file's bytes, as `sha256sum` prints it.
    pub fn of_file(bytes: &[u8]) -> Self {
        Self(Sha256::digest(bytes).into())
    }

    /// Its first eight digits, for people.
    pub fn short(&self) -> String {
        let [one, two, three, four, ..] = self.0;
        hex(&[one, two, three, four])
    }
}

/// The first digits of a hash, as people copy them: enough to find an entry by, if no other one begins so.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HashPrefix(String);

impl HashPrefix {
    /// The fewest digits: those that a report shows.
    pub const FEWEST: usize = 8;

    /// The digits in a text; `None` where it has others, fewer than [`Self::FEWEST`] or more than a hash.
    pub fn read(text: &str) -> Option<Self> {
        let is_prefix = (Self::FEWEST..=64).contains(&text.len()) && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        is_prefix.then(|| Self(text.to_ascii_lowercase()))
    }

    /// Whether a hash begins so.
    pub fn begins(&self, hash: Hash) -> bool {
        let mut digits = hash.0.iter().flat_map(|byte| [byte >> 4, byte & 15]);
        self.0.chars().all(|wanted| digits.next().is_some_and(|digit| wanted.to_digit(16) == Some(u32::from(digit))))
    }
}

impl fmt::Display for HashPrefix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// SHA-256 of a file that is read piece by piece.
#[derive(Debug, Clone, Default)]
pub struct FileHash(Sha256);

impl FileHash {
    /// Takes the next bytes.
    pub fn see(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// The hash of all bytes so far.
    pub fn hash(self) -> Hash {
        Hash(self.0.finalize().into())
    }
}

/// The hash of an entry with this body that follows `before`. `None` where a body is too long to be counted: four gigabytes and more.
pub fn entry_hash(chain: ChainId, before: Head, body: &[u8]) -> Option<Hash> {
    let mut hasher = Sha256::new();
    hasher.update(DOMAIN);
    hasher.update(before.hash.0);
    hasher.update(u32::try_from(chain.0.len()).ok()?.to_be_bytes());
    hasher.update(chain.0);
    hasher.update(before.number.checked_add(1)?.to_be_bytes());
    hasher.update(u32::try_from(body.len()).ok()?.to_be_bytes());
    hasher.update(body);
    Some(Hash(hasher.finalize().into()))
}

pub(crate) fn hex(bytes: &[u8]) -> String {
    use fmt::Write as _;
    bytes.iter().fold(String::with_capacity(2 * bytes.len()), |mut text, byte| {
        // A text takes everything.
        let _written = write!(text, "{byte:02x}");
        text
    })
}

fn unhex<const N: usize>(text: &str) -> Result<[u8; N], HexError> {
    let wrong = || HexError { text: fitcheck_core::message::shortened(text, 80), digits: 2 * N };
    if text.len() != 2 * N || !text.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return Err(wrong());
    }
    let mut bytes = [0; N];
    for (byte, at) in bytes.iter_mut().zip((0..).step_by(2)) {
        let digits = text.get(at..at + 2).ok_or_else(wrong)?;
        *byte = u8::from_str_radix(digits, 16).map_err(|_not_hex| wrong())?;
    }
    Ok(bytes)
}

impl fmt::Display for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&hex(&self.0))
    }
}

impl fmt::Display for ChainId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&hex(&self.0))
    }
}

impl FromStr for Hash {
    type Err = HexError;

    fn from_str(text: &str) -> Result<Self, HexError> {
        unhex(text).map(Self)
    }
}

impl FromStr for ChainId {
    type Err = HexError;

    fn from_str(text: &str) -> Result<Self, HexError> {
        unhex(text).map(Self)
    }
}
