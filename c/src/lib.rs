//! Fitcheck for C: limits of size and verdicts, as `include/fitcheck.h` declares them. The page in the browser calls the same functions.
//!
//! | file | what |
//! |---|---|
//! | here | the border: pointers in, numbers and a text out |
//! | `answer` | what is answered, without pointers |
//! | `room` | memory for a page, which has no allocator of its own |

mod answer;
#[cfg(target_family = "wasm")]
mod room;

use std::ffi::{CStr, c_char};
use std::panic::{AssertUnwindSafe, catch_unwind};

use answer::{Answer, Given};

/// The limits of size, whole nanometres.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub struct FitcheckLimits {
    /// The nominal size.
    pub nominal_nm: i64,
    /// The smallest permitted size.
    pub minimum_nm: i64,
    /// The largest permitted size.
    pub maximum_nm: i64,
    /// 1 hole, 2 shaft, 0 where nobody has said it.
    pub feature: i32,
}

/// A verdict, lengths in whole nanometres.
#[repr(C)]
#[derive(Debug, Clone, Copy, Default)]
pub struct FitcheckVerdict {
    /// What the value was compared with.
    pub limits: FitcheckLimits,
    /// The measured diameter.
    pub measured_nm: i64,
    /// Measured minus nominal size.
    pub deviation_nm: i64,
    /// For rework: what to remove from the diameter to reach the nearest limit; otherwise 0.
    pub remove_nm: i64,
    /// 0 good, 1 rework, 2 re-measure, 3 out of limits (neither hole nor shaft), 4 scrap.
    pub status: i32,
    /// 1 where the text says something to look at before the status is believed.
    pub look_first: i32,
}

/// How a call ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum End {
    Answered = 0,
    Refused = 1,
    Misused = 2,
    Failed = 3,
}

/// The version of this border: it changes where a declaration of the header does.
#[unsafe(no_mangle)]
pub extern "C" fn fitcheck_version() -> i32 {
    1
}

/// The limits of size of a callout.
///
/// # Safety
/// As the header says: `callout` and `language` end with a zero byte, `limits` and `text` can be written to.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fitcheck_limits(
    callout: *const c_char,
    language: *const c_char,
    limits: *mut FitcheckLimits,
    text: *mut c_char,
    capacity: usize,
) -> i32 {
    if limits.is_null() {
        return End::Misused as i32;
    }
    // SAFETY: the caller keeps what the header asks for.
    let asked = unsafe { [string(callout), string(language)] };
    // SAFETY: as above.
    let found = unsafe { asked_for(asked, None, text, capacity) };
    match found {
        Ok(answer) => {
            // SAFETY: it is not null, and the caller has room for one there.
            unsafe { limits.write(answer.verdict.limits) };
            End::Answered as i32
        }
        Err(end) => end as i32,
    }
}

/// The verdict for a measured diameter in whole nanometres.
///
/// # Safety
/// As for [`fitcheck_limits`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fitcheck_check_nm(
    callout: *const c_char,
    measured_nm: i64,
    language: *const c_char,
    verdict: *mut FitcheckVerdict,
    text: *mut c_char,
    capacity: usize,
) -> i32 {
    // SAFETY: the caller keeps what the header asks for.
    unsafe { checked([string(callout), string(language)], Given::Nanometres(measured_nm), verdict, text, capacity) }
}

/// The verdict for a measured diameter as text, in millimetres unless it states another unit.
///
/// # Safety
/// As for [`fitcheck_limits`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fitcheck_check(
    callout: *const c_char,
    measured: *const c_char,
    language: *const c_char,
    verdict: *mut FitcheckVerdict,
    text: *mut c_char,
    capacity: usize,
) -> i32 {
    // SAFETY: the caller keeps what the header asks for.
    let given = unsafe { string(measured) };
    let Some(given) = given else { return End::Misused as i32 };
    // SAFETY: as above.
    unsafe { checked([string(callout), string(language)], Given::Text(given), verdict, text, capacity) }
}

/// A verdict written where the caller wants it.
///
/// # Safety
/// `verdict` is null or has room for one, `text` for `capacity` bytes.
unsafe fn checked(
    asked: [Option<&str>; 2],
    given: Given<'_>,
    verdict: *mut FitcheckVerdict,
    text: *mut c_char,
    capacity: usize,
) -> i32 {
    if verdict.is_null() {
        return End::Misused as i32;
    }
    // SAFETY: the caller has said how much room there is.
    match unsafe { asked_for(asked, Some(given), text, capacity) } {
        Ok(answer) => {
            // SAFETY: it is not null, and there is room for one.
            unsafe { verdict.write(answer.verdict) };
            End::Answered as i32
        }
        Err(end) => end as i32,
    }
}

/// The answer, its text written. A panic does not leave this library.
///
/// # Safety
/// `text` is null or has room for `capacity` bytes.
unsafe fn asked_for(
    [callout, language]: [Option<&str>; 2],
    given: Option<Given<'_>>,
    text: *mut c_char,
    capacity: usize,
) -> Result<Answer, End> {
    let callout = callout.ok_or(End::Misused)?;
    let found = catch_unwind(AssertUnwindSafe(|| answer::answer(callout, given, language)));
    let found = found.map_err(|_panic| End::Failed)?;
    let said = match &found {
        Ok(answer) => &answer.text,
        Err(reason) => reason,
    };
    // SAFETY: as above.
    unsafe { put(said, text, capacity) };
    found.map_err(|_reason| End::Refused)
}

/// The text of a caller; `None` where it is null or not UTF-8.
///
/// # Safety
/// Null, or it ends with a zero byte and stays as it is until the call ends.
unsafe fn string<'a>(text: *const c_char) -> Option<&'a str> {
    if text.is_null() {
        return None;
    }
    // SAFETY: it ends with a zero byte.
    unsafe { CStr::from_ptr(text) }.to_str().ok()
}

/// Writes a text with a zero byte behind it; of a longer one as many whole characters as there is room for.
///
/// # Safety
/// Null, or there is room for `capacity` bytes.
unsafe fn put(said: &str, text: *mut c_char, capacity: usize) {
    let Some(most) = capacity.checked_sub(1).filter(|_| !text.is_null()) else { return };
    let fits = said.get(..said.floor_char_boundary(most)).unwrap_or("");
    // A zero byte would end it for the caller.
    let fits = fits.split('\0').next().unwrap_or("");
    // SAFETY: there is room for as many bytes and one more.
    unsafe {
        text.copy_from_nonoverlapping(fits.as_ptr().cast(), fits.len());
        text.add(fits.len()).write(0);
    }
}
