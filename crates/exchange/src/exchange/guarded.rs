//! A panic of a decoder as an error: nothing of what it has made is used afterwards.

use std::any::Any;
use std::cell::Cell;
use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::sync::Once;

thread_local! {
    /// Whether this thread is decoding, so that a panic is told as an error and not by Rust.
    static IS_DECODING: Cell<bool> = const { Cell::new(false) };
}

/// Decodes something.
///
/// # Errors
/// What a panic says, if it says anything.
pub(super) fn guarded<T>(decode: impl FnOnce() -> T) -> Result<T, Option<String>> {
    static QUIET: Once = Once::new();
    QUIET.call_once(|| {
        let others = take_hook();
        set_hook(Box::new(move |panic| {
            if !IS_DECODING.get() {
                others(panic);
            }
        }));
    });
    let was = IS_DECODING.replace(true);
    let decoded = catch_unwind(AssertUnwindSafe(decode));
    IS_DECODING.set(was);
    decoded.map_err(|panic| said(panic.as_ref()))
}

fn said(panic: &(dyn Any + Send)) -> Option<String> {
    let text = panic.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| panic.downcast_ref::<String>().cloned())
}
