//! One file, written whole or not at all.
//!
//! Linux keeps an unfinished file without a name, so nothing is left behind however the program ends. Where a folder
//! cannot do that, the file has one fixed name beside its target: the next writer of the target removes what is left of
//! it, and so does a signal that ends the program.

use std::ffi::OsString;
use std::fs::{File, Metadata};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::folder_of;
use super::straight::Straight;
use super::unfinished::Unfinished;

/// What a path leads to.
enum WriteTarget {
    /// A file or nothing, with every link on the way followed.
    File(PathBuf, Option<Metadata>),
    /// A pipe, a device or an open file of this program: it is written to and never replaced.
    Straight,
}

/// How many links are followed, as many as the Linux kernel does.
const MOST_LINKS: usize = 40;

impl WriteTarget {
    fn of(path: &Path) -> io::Result<Self> {
        let mut at = path.to_owned();
        for _ in 0..MOST_LINKS {
            let metadata = match at.symlink_metadata() {
                Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Self::File(at, None)),
                metadata => metadata?,
            };
            if metadata.is_dir() {
                return Err(io::ErrorKind::IsADirectory.into());
            }
            if metadata.is_file() {
                return Ok(Self::File(at, Some(metadata)));
            }
            // What these links name is not always a path, and replacing it would not reach who holds the file open.
            let is_open_file = || folder_of(&at).canonicalize().is_ok_and(|folder| folder.starts_with("/proc"));
            if !metadata.is_symlink() || is_open_file() {
                return Ok(Self::Straight);
            }
            at = folder_of(&at).join(at.read_link()?);
        }
        Err(io::Error::other("too many links"))
    }
}

/// Writes a file that may exist. Its mode and, where the system allows it, its owner and group stay; a link stays, and
/// what it leads to is written. A pipe or a device is written to.
pub(super) fn write(path: &Path, fill: &mut dyn FnMut(&mut (dyn Write + Send)) -> io::Result<()>) -> io::Result<()> {
    let (target, metadata) = match WriteTarget::of(path)? {
        WriteTarget::File(target, metadata) => (target, metadata),
        WriteTarget::Straight => {
            // Appended, because the open file may hold something already.
            let mut file = File::options().append(true).open(path)?;
            return fill(&mut file);
        }
    };
    if metadata.is_some() {
        // A file that may not be written to is not replaced either.
        drop(File::options().write(true).open(&target)?);
    }
    let whole = FinishedFile::filled(&target, fill)?;
    if let Some(metadata) = metadata {
        keep_owner(&metadata, &whole.file)?;
    }
    whole.replace(&target)
}

/// Writes a file where there is nothing yet.
///
/// # Errors
/// [`io::ErrorKind::AlreadyExists`] where there is something, even if it came meanwhile.
pub(super) fn write_new(
    path: &Path,
    fill: &mut dyn FnMut(&mut (dyn Write + Send)) -> io::Result<()>,
) -> io::Result<()> {
    // A link that leads nowhere is something, too.
    if path.symlink_metadata().is_ok() {
        return Err(io::ErrorKind::AlreadyExists.into());
    }
    FinishedFile::filled(path, fill)?.place(path)
}

/// A file that is finished but not yet in its place.
struct FinishedFile {
    file: File,
    /// Its name; `None` where it has none.
    name: Option<Unfinished>,
}

impl FinishedFile {
    fn filled(target: &Path, fill: &mut dyn FnMut(&mut (dyn Write + Send)) -> io::Result<()>) -> io::Result<Self> {
        let whole = match nameless(folder_of(target))? {
            Some(file) => Self { file, name: None },
            None => Self::named(target)?,
        };
        std::thread::scope(|scope| {
            let mut out = Straight::new(&whole.file, scope);
            fill(&mut out)?;
            out.end()
        })?;
        Ok(whole)
    }

    /// A file with the fixed name. What is left there of a writer that ended goes; one that still writes is not
    /// disturbed.
    fn named(target: &Path) -> io::Result<Self> {
        let path = unfinished_name(target);
        let create = || File::options().write(true).create_new(true).open(&path);
        let file = match create() {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                remove_left(&path)?;
                create()?
            }
            created => created?,
        };
        // A network folder without locks: the name is then protected by `create_new` alone.
        let _unlocked = file.try_lock();
        Ok(Self { file, name: Some(Unfinished::at(path)) })
    }

    /// Puts it where nothing is.
    fn place(self, target: &Path) -> io::Result<()> {
        match &self.name {
            None => link_nameless(&self.file, target)?,
            Some(name) => match std::fs::hard_link(name.path(), target) {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => return Err(error),
                // A folder that knows no second name for a file; nothing was there a moment ago.
                Err(_) if target.symlink_metadata().is_err() => std::fs::rename(name.path(), target)?,
                linked => linked?,
            },
        }
        sync_folder(target);
        Ok(())
    }

    /// Puts it in the place of what is there.
    fn replace(mut self, target: &Path) -> io::Result<()> {
        match self.name.take() {
            Some(name) => {
                std::fs::rename(name.path(), target)?;
                name.finished();
            }
            None => self.replace_nameless(target)?,
        }
        sync_folder(target);
        Ok(())
    }

    /// Gives a file without a name the fixed one and moves it. Writers of one folder take turns for these two steps, so
    /// what has that name already was left by a broken run.
    fn replace_nameless(&self, target: &Path) -> io::Result<()> {
        let path = unfinished_name(target);
        let _turn = turn(folder_of(target));
        // Before it has the name: a signal may come between the two.
        let name = Unfinished::at(path);
        match link_nameless(&self.file, name.path()) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                std::fs::remove_file(name.path())?;
                link_nameless(&self.file, name.path())?;
            }
            linked => linked?,
        }
        std::fs::rename(name.path(), target)?;
        name.finished();
        Ok(())
    }
}

/// Waits for other writers of a folder, and keeps them out as long as this is held. A folder without locks has no turns,
/// and nobody is waited for longer than a moment.
fn turn(folder: &Path) -> Option<File> {
    const TRIES: usize = 400;
    let folder = File::open(folder).ok()?;
    for _ in 0..TRIES {
        match folder.try_lock() {
            Err(std::fs::TryLockError::WouldBlock) => std::thread::sleep(std::time::Duration::from_millis(5)),
            locked => return locked.ok().map(|()| folder),
        }
    }
    None
}

/// The name of an unfinished file beside its target: always the same, so that a broken run leaves at most one.
pub(super) fn unfinished_name(target: &Path) -> PathBuf {
    /// Names have at most 255 bytes on most systems.
    const MOST_BYTES: usize = 200;
    let mut name = OsString::from(".");
    match super::name_of(target) {
        short if short.len() <= MOST_BYTES => name.push(short),
        long => {
            let long = long.to_string_lossy();
            let (short, _) = long.split_at(long.floor_char_boundary(MOST_BYTES));
            name.push(short);
        }
    }
    name.push(".fitcheck");
    target.with_file_name(name)
}

/// Removes what a broken run has left under a fixed name, unless another program still writes it.
fn remove_left(path: &Path) -> io::Result<()> {
    if path.symlink_metadata()?.is_file()
        && let Err(std::fs::TryLockError::WouldBlock) = File::options().write(true).open(path)?.try_lock()
    {
        return Err(io::Error::new(io::ErrorKind::ResourceBusy, "another program is writing this file"));
    }
    std::fs::remove_file(path)
}

/// The folder keeps the new name even if the machine loses its power now. The file is whole either way, so a folder
/// that cannot be synced is no error.
pub(super) fn sync_folder(target: &Path) {
    #[cfg(unix)]
    if let Ok(folder) = File::open(folder_of(target)) {
        let _not_synced = folder.sync_all();
    }
    #[cfg(not(unix))]
    let _ = target;
}

/// Gives a new file the owner, group and mode of the one that it replaces.
#[cfg(unix)]
pub(super) fn keep_owner(old: &Metadata, file: &File) -> io::Result<()> {
    use std::os::unix::fs::{MetadataExt as _, PermissionsExt as _, fchown};
    let new = file.metadata()?;
    // Only the administrator gives files away; then at least the group stays, if the writer belongs to it.
    if (old.uid(), old.gid()) != (new.uid(), new.gid()) && fchown(file, Some(old.uid()), Some(old.gid())).is_err() {
        let _not_a_member = fchown(file, None, Some(old.gid()));
    }
    let mode = old.mode() & 0o777;
    // Rights of a group do not pass to another one.
    let is_same_group = file.metadata()?.gid() == old.gid();
    let mode = if is_same_group { mode } else { mode & !0o070 | (mode & 0o007) << 3 };
    file.set_permissions(std::fs::Permissions::from_mode(mode))
}

#[cfg(not(unix))]
pub(super) fn keep_owner(_old: &Metadata, _file: &File) -> io::Result<()> {
    Ok(())
}

/// A file without a name in a folder; `None` where the system or the folder has no such thing.
#[cfg(target_os = "linux")]
fn nameless(folder: &Path) -> io::Result<Option<File>> {
    use rustix::fs::{Mode, OFlags};
    use rustix::io::Errno;
    // A name is given to it through this folder.
    if !Path::new("/proc/self/fd").is_dir() {
        return Ok(None);
    }
    let mode = Mode::from_raw_mode(0o666);
    match rustix::fs::open(folder, OFlags::TMPFILE | OFlags::WRONLY | OFlags::CLOEXEC, mode) {
        Ok(file) => Ok(Some(File::from(file))),
        // Kernels and network folders that do not know the flag.
        Err(Errno::OPNOTSUPP | Errno::ISDIR | Errno::INVAL) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

#[cfg(not(target_os = "linux"))]
fn nameless(_folder: &Path) -> io::Result<Option<File>> {
    Ok(None)
}

/// Gives a file without a name its name.
#[cfg(target_os = "linux")]
fn link_nameless(file: &File, name: &Path) -> io::Result<()> {
    use rustix::fs::{AtFlags, CWD, linkat};
    use std::os::fd::AsRawFd as _;
    let open = format!("/proc/self/fd/{}", file.as_raw_fd());
    Ok(linkat(CWD, open, CWD, name, AtFlags::SYMLINK_FOLLOW)?)
}

#[cfg(not(target_os = "linux"))]
fn link_nameless(_file: &File, _name: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = std::fs::read_dir(folder).unwrap();
        let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    fn named(target: &Path, bytes: &[u8]) -> FinishedFile {
        let whole = FinishedFile::named(target).unwrap();
        (&whole.file).write_all(bytes).unwrap();
        whole
    }

    #[test]
    fn a_folder_without_nameless_files_has_one_fixed_name_that_goes() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("report.html");
        let whole = named(&target, b"one");
        assert_eq!(names(folder.path()), [".report.html.fitcheck"]);
        whole.place(&target).unwrap();
        assert_eq!(names(folder.path()), ["report.html"]);
        named(&target, b"two").replace(&target).unwrap();
        assert_eq!(std::fs::read(&target).unwrap(), b"two");
        drop(named(&target, b"never finished"));
        assert_eq!(named(&target, b"three").place(&target).unwrap_err().kind(), io::ErrorKind::AlreadyExists);
        assert_eq!(std::fs::read(&target).unwrap(), b"two");
        assert_eq!(names(folder.path()), ["report.html"]);
    }

    #[test]
    fn what_a_broken_run_left_goes_and_what_another_one_writes_stays() {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("report.html");
        let left = folder.path().join(".report.html.fitcheck");
        write(&left, &mut |out| out.write_all(b"half")).unwrap();
        named(&target, b"whole").place(&target).unwrap();
        assert_eq!(names(folder.path()), ["report.html"]);
        let other = named(&target, b"other");
        let refused = FinishedFile::named(&target).map(drop).unwrap_err();
        assert_eq!(refused.kind(), io::ErrorKind::ResourceBusy);
        other.replace(&target).unwrap();
        assert_eq!(std::fs::read(&target).unwrap(), b"other");
        write(&left, &mut |out| out.write_all(b"half")).unwrap();
        write(&target, &mut |out| out.write_all(b"again")).unwrap();
        assert_eq!(std::fs::read(&target).unwrap(), b"again");
        assert_eq!(names(folder.path()), ["report.html"]);
    }

    #[test]
    fn the_longest_name_has_an_unfinished_name() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["ä".repeat(127), "a".repeat(255)] {
            let target = folder.path().join(name);
            write(&target, &mut |out| out.write_all(b"one")).unwrap();
            write(&target, &mut |out| out.write_all(b"two")).unwrap();
            named(&target, b"three").replace(&target).unwrap();
            assert_eq!(std::fs::read(&target).unwrap(), b"three");
        }
        assert_eq!(names(folder.path()).len(), 2);
    }
}
