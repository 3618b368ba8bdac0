//! Icon, version and manifest of the program for Windows.

include!("packaging/windows/resources.rs");

fn main() -> std::io::Result<()> {
    add_resources(env!("CARGO_MANIFEST_DIR"))
}
