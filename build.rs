//! What the properties of the programs for Windows show, and what they ask of the system: icon, version and manifest.

const ICON: &str = "assets/icons/fitcheck.ico";
const MANIFEST: &str = "packaging/windows/fitcheck.manifest";

fn main() -> std::io::Result<()> {
    println!("cargo::rerun-if-changed={ICON}");
    println!("cargo::rerun-if-changed={MANIFEST}");
    if std::env::var_os("CARGO_CFG_WINDOWS").is_none() {
        return Ok(());
    }
    winresource::WindowsResource::new()
        .set("ProductName", "Fitcheck")
        .set("FileDescription", env!("CARGO_PKG_DESCRIPTION"))
        .set_icon(ICON)
        .set_manifest_file(MANIFEST)
        .compile()
}
