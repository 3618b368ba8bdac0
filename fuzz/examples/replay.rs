//! Runs a target once on each of some files: `replay TARGET FILE|FOLDER...`. Without the engine and its counters, for
//! others: of lines, of time.

use std::path::Path;
use std::process::ExitCode;

use fitcheck_fuzz::targets::TARGETS;

fn main() -> ExitCode {
    let mut given = std::env::args().skip(1);
    let name = given.next().unwrap_or_default();
    let Some(target) = TARGETS.iter().find(|target| target.name == name) else {
        eprintln!("{name:?} is not a target");
        return ExitCode::from(2);
    };
    given.flat_map(|path| files(Path::new(&path))).for_each(|input| (target.run)(&input));
    ExitCode::SUCCESS
}

fn files(path: &Path) -> Vec<Vec<u8>> {
    let Ok(folder) = std::fs::read_dir(path) else { return std::fs::read(path).into_iter().collect() };
    folder.flatten().filter_map(|file| std::fs::read(file.path()).ok()).collect()
}
