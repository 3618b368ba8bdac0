//! A panic of a decoder as an error.
//!
//! What [`CheckedPages`](super::checked) cannot see, the decoders of packed differences of the `parquet` crate do not see either: in
//! a damaged page they index beyond their bytes. Nothing of theirs is used afterwards.

use parquet::errors::ParquetError;

/// Decodes something; where that panics, the page is damaged.
pub(super) fn guarded<T>(decode: impl FnOnce() -> Result<T, ParquetError>) -> Result<T, ParquetError> {
    crate::exchange::guarded::guarded(decode).unwrap_or_else(|said| {
        let said = said.as_deref().unwrap_or("its values cannot be decoded");
        Err(ParquetError::General(format!("a page is damaged: {said}")))
    })
}
