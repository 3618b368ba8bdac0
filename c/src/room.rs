//! Memory for a page, which has no allocator of its own.

/// The memory that a page writes to and reads from: texts in, numbers and a text out. A page asks one thing at a time.
static mut ROOM: [u64; 1 << 10] = [0; 1 << 10];

/// Where it begins. It has 8 KiB.
#[unsafe(no_mangle)]
pub extern "C" fn fitcheck_room() -> *mut u64 {
    (&raw mut ROOM).cast()
}
