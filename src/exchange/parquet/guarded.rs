//! A panic of a decoder as an error.
//!
//! What [`Checked`](super::checked) cannot see, the decoders of packed differences of the `parquet` crate do not see either: in
//! a damaged page they index beyond their bytes. Nothing of theirs is used afterwards.

use std::any::Any;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

use parquet::errors::ParquetError;

thread_local! {
    /// Whether this thread is decoding, so that a panic is told as an error and not by Rust.
    static IS_DECODING: Cell<bool> = const { Cell::new(false) };
}

/// Decodes something; where that panics, the page is damaged.
pub(super) fn guarded<T>(decode: impl FnOnce() -> Result<T, ParquetError>) -> Result<T, ParquetError> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let others = take_hook();
        set_hook(Box::new(move |panic| {
            if !IS_DECODING.get() {
                others(panic);
            }
        }));
    });
    IS_DECODING.set(true);
    let decoded = catch_unwind(AssertUnwindSafe(decode));
    IS_DECODING.set(false);
    decoded.unwrap_or_else(|panic| Err(ParquetError::General(format!("a page is damaged: {}", said(panic.as_ref())))))
}

fn said(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<&str>().copied();
    text.or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("its values cannot be decoded")
}
