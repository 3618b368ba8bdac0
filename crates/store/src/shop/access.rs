//! The password of a shop's server, from the places where PostgreSQL's own programs look for it.
//!
//! In this order: the address, `PGPASSWORD`, the password file, the system's keyring. It is never written to a file, a
//! log or an error.

use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::Duration;
use std::{fmt, thread};

use fitcheck_core::message::Say;
use fitcheck_files as files;

use super::address::ShopAddress;
use super::password::Password;
use super::pgpass;

/// How long the keyring may ask somebody to open it.
const KEYRING_WAITS: Duration = Duration::from_mins(1);

/// What the password is kept under in the keyring, beside the address.
const SERVICE: &str = "fitcheck";

/// Where a password may be.
#[derive(Clone)]
pub struct Places {
    /// `PGPASSWORD`.
    pub environment: Option<Password>,
    /// The password file.
    pub file: Option<PathBuf>,
    /// Asks the system's keyring: the service, and the address as it is shown.
    pub keyring: fn(&str, &str) -> Result<Option<Password>, String>,
}

impl fmt::Debug for Places {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Places").field("file", &self.file).finish_non_exhaustive()
    }
}

impl Places {
    /// The places of whoever runs the program.
    pub fn of_system() -> Self {
        let variable = |name| std::env::var_os(name).filter(|value| !value.is_empty());
        let environment = variable("PGPASSWORD").and_then(|value| value.into_string().ok()).map(Password::new);
        let of_home = || {
            if cfg!(windows) {
                variable("APPDATA").map(|folder| PathBuf::from(folder).join("postgresql").join("pgpass.conf"))
            } else {
                variable("HOME").map(|home| PathBuf::from(home).join(".pgpass"))
            }
        };
        let file = variable("PGPASSFILE").map(PathBuf::from).or_else(of_home);
        Self { environment, file, keyring: from_keyring }
    }

    /// No place at all.
    pub const fn none() -> Self {
        Self { environment: None, file: None, keyring: |_service, _user| Ok(None) }
    }
}

/// What is said of a place that had no password to give.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "shop-password")]
pub enum PasswordRemark {
    /// Others may read the password file.
    Open {
        /// The file.
        path: PathBuf,
    },
    /// The password file cannot be read.
    Unread {
        /// What the system says, with the file.
        what: files::FileError,
    },
    /// The keyring does not answer.
    NoKeyring {
        /// What it says.
        reason: String,
    },
}

/// An address with its password: all that a connection needs. It prints as the address.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Access {
    pub address: ShopAddress,
    pub(super) password: Option<Password>,
    /// What is said of places that had none to give.
    pub remarks: Vec<PasswordRemark>,
}

impl Access {
    /// Looks for the password of an address: the given one, which stood in the address, comes first. It may ask the
    /// system's keyring and so wait for somebody.
    pub fn find(address: ShopAddress, given: Option<Password>, places: &Places) -> Self {
        let mut remarks = Vec::new();
        let password = given
            .or_else(|| places.environment.clone())
            .or_else(|| from_file(&address, places.file.as_deref()?, &mut remarks))
            .or_else(|| match (places.keyring)(SERVICE, &address.to_string()) {
                Ok(password) => password,
                Err(reason) => {
                    remarks.push(PasswordRemark::NoKeyring { reason });
                    None
                }
            });
        // A keyring that does not answer is ordinary: many servers ask for no password.
        Self { address, password, remarks }
    }

    /// Whether a password was found.
    pub const fn has_password(&self) -> bool {
        self.password.is_some()
    }
}

fn from_file(address: &ShopAddress, path: &Path, remarks: &mut Vec<PasswordRemark>) -> Option<Password> {
    if !path.exists() {
        return None;
    }
    if is_open_to_others(path) {
        remarks.push(PasswordRemark::Open { path: path.to_owned() });
        return None;
    }
    let bytes = match files::read_file(path) {
        Ok(bytes) => bytes,
        Err(what) => {
            remarks.push(PasswordRemark::Unread { what });
            return None;
        }
    };
    let text = String::from_utf8_lossy(&bytes);
    let wanted = [&address.host(), &address.port().to_string(), address.database(), address.user()];
    pgpass::find(&text, wanted).map(Password::new)
}

#[cfg(unix)]
fn is_open_to_others(path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt as _;
    std::fs::metadata(path).is_ok_and(|metadata| metadata.mode() & 0o077 != 0)
}

#[cfg(not(unix))]
const fn is_open_to_others(_path: &Path) -> bool {
    false
}

/// Asks the system's keyring, on a thread of its own: it may wait for somebody to open it, and must not run where other
/// asynchronous work does.
fn from_keyring(service: &str, user: &str) -> Result<Option<Password>, String> {
    let service = service.to_owned();
    let user = user.to_owned();
    on_its_own(move || match entry(&service, &user)?.get_password() {
        Ok(password) => Ok(Some(Password::new(password))),
        Err(keyring::Error::NoEntry) => Ok(None),
        Err(error) => Err(error.to_string()),
    })
}

/// Offers a password to the system's keyring, so that it is found there next time.
///
/// # Errors
/// What the keyring says, without the password.
pub fn keep_in_keyring(address: &ShopAddress, password: &Password) -> Result<(), String> {
    let user = address.to_string();
    let password = password.clone();
    on_its_own(move || entry(SERVICE, &user)?.set_password(password.secret()).map_err(|error| error.to_string()))
}

/// An entry of the keyring, or why there is no keyring: on Linux, that no session of D-Bus is there.
fn entry(service: &str, user: &str) -> Result<keyring::Entry, String> {
    if let Err(error) = keyring::Entry::store_status() {
        return Err(error.to_string());
    }
    keyring::Entry::new(service, user).map_err(|error| error.to_string())
}

fn on_its_own<T: Send + 'static>(work: impl FnOnce() -> Result<T, String> + Send + 'static) -> Result<T, String> {
    let (answer, answers) = mpsc::channel();
    let asking = move || drop(answer.send(work()));
    thread::Builder::new().name("keyring".to_owned()).spawn(asking).map_err(|error| error.to_string())?;
    answers.recv_timeout(KEYRING_WAITS).unwrap_or_else(|error| Err(error.to_string()))
}
