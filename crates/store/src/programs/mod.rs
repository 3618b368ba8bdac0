//! What NC programs read and write in the user's folders: never a file outside them, whatever a program says.

mod names;

use fitcheck_core::text::Within as _;
use std::cell::RefCell;
use std::collections::HashMap;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

use fitcheck_files::{FileError, LARGEST, read, system, write};
use fitcheck_nc::control::mask::FileUse;
use fitcheck_nc::machine::{NcPath, Origin, OtherNames, Shipped, Store, StoreError};

use self::names::Names;

/// Folders to read from and one to write into. `TNC:\fit\a.h` is looked for as `fit/a.h` and then as `a.h` in each of
/// them, first in the one that is written into; the built-in files come last.
#[derive(Debug, Clone, Default)]
pub struct Folders {
    reading: Vec<PathBuf>,
    writing: Option<PathBuf>,
    /// Whether the built-in files do not count.
    is_alone: bool,
    names: RefCell<Names>,
}

impl Folders {
    /// Only the built-in files, and nothing is written.
    pub fn new() -> Self {
        Self::default()
    }

    /// The folder of a program's file; for a bare name, the current folder.
    pub fn beside(program: &Path) -> Self {
        let folder = program.parent().map(|folder| if folder.as_os_str().is_empty() { Path::new(".") } else { folder });
        Self { reading: folder.map(Path::to_owned).into_iter().collect(), ..Self::default() }
    }

    /// A copy with one more folder to read from, after those before it.
    #[must_use]
    pub fn reading(mut self, folder: impl Into<PathBuf>) -> Self {
        self.reading.push(folder.into());
        self
    }

    /// A copy with the folder that outputs go to.
    #[must_use]
    pub fn writing(mut self, folder: impl Into<PathBuf>) -> Self {
        self.writing = Some(folder.into());
        self
    }

    /// A copy in which the built-in files do not count.
    #[must_use]
    pub const fn without_built_in(mut self) -> Self {
        self.is_alone = true;
        self
    }

    /// The first file on this path, and the folder in which it was looked for.
    fn find(&self, path: &NcPath) -> Result<Option<(&Path, PathBuf)>, StoreError> {
        let parts: Vec<&str> = path.parts().collect();
        let mut names = self.names.borrow_mut();
        let mut search = Search { names: &mut names, found: HashMap::new() };
        let folders = self.writing.iter().chain(&self.reading);
        // The user may have copied a folder on the path without those above it.
        let places = folders.flat_map(|folder| (0..parts.len()).map(move |skipped| (folder, skipped)));
        for (folder, skipped) in places {
            let found = search.find(folder, parts.within(skipped..));
            if let Some(found) = found.map_err(|names| StoreError::Ambiguous { path: path.clone(), names })? {
                return Ok(Some((folder, found)));
            }
        }
        Ok(None)
    }

    /// How many times a folder was listed: the expensive part of looking for files.
    pub fn listed(&self) -> u64 {
        self.names.borrow().listed()
    }
}

impl Store for Folders {
    fn read(&self, path: &NcPath) -> Result<Vec<u8>, StoreError> {
        match self.find(path)? {
            Some((folder, found)) => bytes_of(folder, &found, path),
            None if self.is_alone => Err(StoreError::Missing { path: path.clone() }),
            None => Shipped.read(path),
        }
    }

    fn origin(&self, path: &NcPath) -> Origin {
        match self.find(path) {
            Ok(Some((_, found))) => Origin::Given(Some(found)),
            // What is ambiguous is never read.
            _ if self.reading.is_empty() => Origin::BuiltIn,
            _ => Origin::BuiltInInstead,
        }
    }

    fn other_names(&self, path: &NcPath) -> Vec<OtherNames> {
        let Ok(Some((folder, found))) = self.find(path) else { return Vec::new() };
        let mut names = self.names.borrow_mut();
        let inside = found.ancestors().take_while(|at| *at != folder);
        let others = inside.filter_map(|at| {
            let read = at.file_name()?;
            let mut others = names.find(at.parent()?, &read.to_string_lossy());
            others.retain(|other| other != read);
            let read = read.to_string_lossy().into_owned();
            (!others.is_empty()).then(|| OtherNames { read, others: listed(&others) })
        });
        others.collect()
    }

    fn write(&mut self, path: &NcPath, bytes: &[u8], how: FileUse) -> Result<usize, StoreError> {
        let folder = self.writing.as_ref().ok_or(StoreError::ReadOnly)?;
        let target = target(folder, path)?;
        // Where the system does not say, an output that is there is not written over.
        let is_there = target.try_exists().map_err(|error| of_file(system(&target, &error), path))?;
        let is_behind = how != FileUse::Replace && is_there;
        let old = if is_behind { bytes_of(folder, &target, path)? } else { Vec::new() };
        let whole = [old.as_slice(), bytes].concat();
        // As it is looked for: the target may be spelled as the system does.
        let mut into = folder.clone();
        into.extend(path.parts());
        into.pop();
        let written = self.names.get_mut().writing(&into, path.file_name(), || write(&target, &whole));
        written.map_err(|error| of_file(error, path))?;
        Ok(whole.len())
    }

    fn writes(&self) -> bool {
        self.writing.is_some()
    }

    fn remove(&mut self, path: &NcPath) -> Result<(), StoreError> {
        let writing = self.writing.as_ref().ok_or(StoreError::ReadOnly)?;
        let file = match self.find(path)? {
            Some((folder, found)) if folder == writing => inside(folder, &found, path)?,
            Some(_) => return Err(StoreError::Elsewhere { path: path.clone() }),
            None if self.origin(path) == Origin::Given(None) || Shipped.read(path).is_ok() && !self.is_alone => {
                return Err(StoreError::Elsewhere { path: path.clone() });
            }
            None => return Err(StoreError::Missing { path: path.clone() }),
        };
        if !file.is_file() {
            return Err(StoreError::NoFile { path: path.clone() });
        }
        std::fs::remove_file(&file).map_err(|error| of_file(system(&file, &error), path))
    }
}

/// A look-up of one path: nothing is asked of the system twice, however often the same folders come on the way.
struct Search<'a> {
    names: &'a mut Names,
    /// What was found under a name in a folder.
    found: HashMap<PathBuf, FolderLookup>,
}

/// An entry of a folder, or the names of several that a control would take for one.
type FolderLookup = Result<Option<PathBuf>, String>;

impl Search<'_> {
    /// The entry below a folder, with the same name or one that differs only by case; links are not followed yet.
    fn find(&mut self, folder: &Path, parts: &[&str]) -> FolderLookup {
        let mut at = folder.to_owned();
        for part in parts {
            let Some(entry) = self.entry(&at, part)? else { return Ok(None) };
            at = entry;
        }
        Ok(Some(at))
    }

    /// An entry of a folder: the exact name first, so that what the run itself has just written is found.
    fn entry(&mut self, folder: &Path, name: &str) -> FolderLookup {
        let exact = folder.join(name);
        if let Some(found) = self.found.get(&exact) {
            return found.clone();
        }
        let is_there = exact.symlink_metadata().is_ok();
        // Windows finds an entry under its name in any case: which one it is, the list says.
        let found = if is_there && !cfg!(windows) {
            Ok(Some(exact.clone()))
        } else {
            match self.names.find(folder, name).as_slice() {
                [] => Ok(is_there.then(|| exact.clone())),
                several if several.iter().any(|other| other == name) => Ok(Some(exact.clone())),
                [other] => Ok(Some(folder.join(other))),
                several => Err(listed(several)),
            }
        };
        self.found.insert(exact, found.clone());
        found
    }
}

fn listed(names: &[OsString]) -> String {
    let names: Vec<_> = names.iter().map(|name| name.to_string_lossy()).collect();
    names.join(", ")
}

/// The bytes of a file that must lie below the folder, links followed.
fn bytes_of(folder: &Path, file: &Path, path: &NcPath) -> Result<Vec<u8>, StoreError> {
    let inside = inside(folder, file, path)?;
    // Reading a pipe would wait.
    if !inside.is_file() {
        return Err(StoreError::NoFile { path: path.clone() });
    }
    read(&inside).map_err(|error| of_file(error, path))
}

/// The path without links, if it is below the folder.
fn inside(folder: &Path, file: &Path, path: &NcPath) -> Result<PathBuf, StoreError> {
    let real = |path: &Path| path.canonicalize();
    let system = |error: std::io::Error| StoreError::System { path: path.clone(), reason: error.to_string() };
    let folder = real(folder).map_err(system)?;
    let file = real(file).map_err(system)?;
    if file.starts_with(&folder) { Ok(file) } else { Err(StoreError::Outside { path: path.clone() }) }
}

/// Where an output goes: the whole path below the folder; folders on the way are made.
fn target(folder: &Path, path: &NcPath) -> Result<PathBuf, StoreError> {
    let system = |error: std::io::Error| StoreError::System { path: path.clone(), reason: error.to_string() };
    let mut at = inside(folder, folder, path)?;
    let mut parts: Vec<&str> = path.parts().collect();
    // A path has at least a name.
    let name = parts.pop().unwrap_or("");
    for part in parts {
        at.push(part);
        if at.symlink_metadata().is_err() {
            std::fs::create_dir(&at).map_err(system)?;
        }
        at = inside(folder, &at, path)?;
    }
    at.push(name);
    match at.symlink_metadata() {
        // Renaming over a link would replace it, but the user wants the file behind it to stay.
        Ok(data) if data.is_symlink() => Err(StoreError::Outside { path: path.clone() }),
        Ok(data) if !data.is_file() => Err(StoreError::NoFile { path: path.clone() }),
        _ => Ok(at),
    }
}

fn of_file(error: FileError, path: &NcPath) -> StoreError {
    let path = path.clone();
    match error {
        // Nothing here asks for a file that must not exist yet, writes a set, reads a file twice or stops.
        FileError::IsFolder { .. }
        | FileError::NotAFile { .. }
        | FileError::HalfSet { .. }
        | FileError::Exists { .. }
        | FileError::Changed { .. }
        | FileError::Stopped { .. } => StoreError::NoFile { path },
        FileError::Missing { .. } => StoreError::Missing { path },
        FileError::TooLarge { .. } => StoreError::TooLarge { path, most: LARGEST >> 20 },
        FileError::System { reason, .. } => StoreError::System { path, reason },
        FileError::Busy { .. } => StoreError::System { reason: error.to_string(), path },
    }
}
