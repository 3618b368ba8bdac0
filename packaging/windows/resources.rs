// What the properties of a program for Windows show, and what it asks of the system: included by the build scripts of both programs.

/// Adds icon, version and manifest where the program is built for Windows. `root` is the folder of the repository.
fn add_resources(root: &str) -> std::io::Result<()> {
    println!("cargo::rerun-if-changed={root}/packaging/windows");
    println!("cargo::rerun-if-changed={root}/assets/icons/fitcheck.ico");
    if std::env::var_os("CARGO_CFG_WINDOWS").is_none() {
        return Ok(());
    }
    winresource::WindowsResource::new()
        .set("ProductName", "Fitcheck")
        .set("FileDescription", env!("CARGO_PKG_DESCRIPTION"))
        .set_icon(&format!("{root}/assets/icons/fitcheck.ico"))
        .set_manifest_file(&format!("{root}/packaging/windows/fitcheck.manifest"))
        .compile()
}
