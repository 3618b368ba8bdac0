//! The address of a shop's server: `postgres://station3@shop.example/checks`.
//!
//! It is read by the PostgreSQL client, after what that client refuses was taken out: `sslmode=verify-full` and
//! `sslrootcert`. A password in it is taken out too; it is used and never printed.

use std::fmt;
use std::net::IpAddr;
use std::path::{Path, PathBuf};

use fitcheck_core::message::{Say, shortened};
use tokio_postgres::Config;
use tokio_postgres::config::{Host, SslMode};

use super::password::Password;
use fitcheck_core::text::Within as _;

/// What an address begins with.
const SCHEMES: [&str; 2] = ["postgres://", "postgresql://"];

/// Where the server of a shop is, and as whom it is asked. It holds no password.
#[derive(Clone, PartialEq, Eq)]
pub struct ShopAddress {
    shown: String,
    config: Config,
    user: String,
    database: String,
    is_tls: bool,
    authority: Option<PathBuf>,
}

/// Why a text is no address of a server. None of them repeats the address: it may hold a password.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "shop-address", error)]
pub enum AddressError {
    Scheme,
    /// No host is named.
    NoHost,
    /// No user is named.
    NoUser,
    /// An `@` besides the one behind the user.
    At,
    /// The client cannot read it.
    Unreadable {
        /// What it says.
        reason: String,
    },
    /// A mode of TLS that is none.
    Mode {
        /// The mode.
        given: String,
    },
    /// Plain text to another machine.
    Plain {
        host: String,
    },
}

impl ShopAddress {
    /// Reads an address, and the password in it if there is one.
    ///
    /// # Errors
    /// [`AddressError`] where the text is no address of a server, or asks for plain text to another machine.
    pub fn read(text: &str) -> Result<(Self, Option<Password>), AddressError> {
        let text = text.trim();
        let rest = SCHEMES.iter().find_map(|scheme| text.strip_prefix(scheme)).ok_or(AddressError::Scheme)?;
        let parts = AddressParts::of(rest)?;
        let shown = format!("postgres://{}", parts.text(|_key| true));
        let known = |key: &str| !["sslmode", "sslrootcert"].contains(&key);
        let unreadable = |error: tokio_postgres::Error| AddressError::Unreadable { reason: reason(&error) };
        let mut config: Config = format!("postgres://{}", parts.text(known)).parse().map_err(unreadable)?;
        if config.get_hosts().is_empty() && config.get_hostaddrs().is_empty() {
            return Err(AddressError::NoHost);
        }
        let user = config.get_user().filter(|user| !user.is_empty()).ok_or(AddressError::NoUser)?.to_owned();
        let database = config.get_dbname().unwrap_or(&user).to_owned();
        let is_tls = wants_tls(&config, parts.option("sslmode").as_deref())?;
        config.ssl_mode(if is_tls { SslMode::Require } else { SslMode::Disable });
        let authority = parts.option("sslrootcert").filter(|file| file != "system").map(PathBuf::from);
        let password = parts.password.and_then(decoded).or_else(|| parts.option("password"));
        Ok((Self { shown, config, user, database, is_tls, authority }, password.map(Password::new)))
    }

    /// How the server is reached, without a password.
    pub(super) const fn config(&self) -> &Config {
        &self.config
    }

    /// Whether everything goes through TLS, with the server's certificate checked: always to another machine.
    pub const fn is_tls(&self) -> bool {
        self.is_tls
    }

    /// The file of the authorities that are trusted instead of the system's.
    pub fn authority(&self) -> Option<&Path> {
        self.authority.as_deref()
    }

    pub fn user(&self) -> &str {
        &self.user
    }

    pub fn database(&self) -> &str {
        &self.database
    }

    /// Which server and database it is, whoever asks.
    pub fn server(&self) -> String {
        format!("{}:{}/{}", self.host(), self.port(), self.database())
    }

    /// The first host as a password file names it.
    pub fn host(&self) -> String {
        match (self.config.get_hosts().first(), self.config.get_hostaddrs().first()) {
            (Some(Host::Tcp(host)), _) => host.clone(),
            #[cfg(unix)]
            (Some(Host::Unix(folder)), _) => folder.display().to_string(),
            (None, address) => address.map_or_else(String::new, ToString::to_string),
        }
    }

    /// The first port.
    pub fn port(&self) -> u16 {
        self.config.get_ports().first().copied().unwrap_or(5432)
    }
}

/// As it was given, without the password: this is what may be kept and shown.
impl fmt::Display for ShopAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.shown)
    }
}

impl fmt::Debug for ShopAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("ShopAddress").field(&self.shown).finish()
    }
}

/// Whether a connection is made through TLS. Not asking for it is possible on this machine only; there it takes a
/// certificate that is made for this machine's name, which nobody has unless they asked.
fn wants_tls(config: &Config, mode: Option<&str>) -> Result<bool, AddressError> {
    let other = other_machine(config);
    match (mode, other) {
        (Some("disable"), Some(host)) => Err(AddressError::Plain { host }),
        (Some("require" | "verify-ca" | "verify-full"), _) | (None | Some("allow" | "prefer"), Some(_)) => Ok(true),
        (None | Some("allow" | "prefer" | "disable"), None) => Ok(false),
        (Some(given), _) => Err(AddressError::Mode { given: shortened(given, 40) }),
    }
}

/// The first of the hosts that is not surely this machine.
fn other_machine(config: &Config) -> Option<String> {
    let is_here = |host: &Host| match host {
        Host::Tcp(name) => {
            name.eq_ignore_ascii_case("localhost") || name.parse().is_ok_and(|address: IpAddr| address.is_loopback())
        }
        #[cfg(unix)]
        Host::Unix(_) => true,
    };
    let name = |host: &Host| match host {
        Host::Tcp(name) => name.clone(),
        #[cfg(unix)]
        Host::Unix(folder) => folder.display().to_string(),
    };
    let named = config.get_hosts().iter().find(|host| !is_here(host)).map(name);
    let address = || config.get_hostaddrs().iter().find(|address| !address.is_loopback()).map(ToString::to_string);
    named.or_else(address)
}

/// What the client says, with the reason behind it.
fn reason(error: &tokio_postgres::Error) -> String {
    use std::error::Error as _;
    shortened(&error.source().map_or_else(|| error.to_string(), ToString::to_string), 200)
}

/// An address without its scheme, cut into its parts and not yet decoded.
struct AddressParts<'a> {
    user: Option<&'a str>,
    password: Option<&'a str>,
    /// Hosts and ports.
    hosts: &'a str,
    /// The database with the slash before it.
    path: &'a str,
    options: Vec<(&'a str, &'a str)>,
}

impl<'a> AddressParts<'a> {
    fn of(rest: &'a str) -> Result<Self, AddressError> {
        let (place, options) = rest.split_once('?').unwrap_or((rest, ""));
        let (authority, path) = place.find('/').and_then(|at| place.split_at_checked(at)).unwrap_or((place, ""));
        let (login, hosts) = authority.split_once('@').map_or((None, authority), |(user, hosts)| (Some(user), hosts));
        // Where a password has one of `@/?` as it is, its second half would be taken for a host and be shown.
        if [hosts, path, options].iter().any(|part| part.contains('@')) {
            return Err(AddressError::At);
        }
        let (user, password) = match login.map(|login| login.split_once(':').ok_or(login)) {
            None => (None, None),
            Some(Err(user)) => (Some(user), None),
            Some(Ok((user, password))) => (Some(user), Some(password)),
        };
        let options = options.split('&').filter(|option| !option.is_empty());
        let options = options.map(|option| option.split_once('=').unwrap_or((option, "")));
        Ok(Self { user, password, hosts, path, options: options.collect() })
    }

    /// The address without its password, with the options whose names are wanted.
    fn text(&self, wanted: impl Fn(&str) -> bool) -> String {
        let options = self.options.iter().filter(|(key, _)| {
            // What is no text has no name.
            decoded(key).map_or_else(|| wanted(""), |key| key != "password" && wanted(&key))
        });
        let options: Vec<String> = options.map(|(key, value)| format!("{key}={value}")).collect();
        let user = self.user.map_or_else(String::new, |user| format!("{user}@"));
        let mark = if options.is_empty() { "" } else { "?" };
        format!("{user}{}{}{mark}{}", self.hosts, self.path, options.join("&"))
    }

    /// The last value of an option.
    fn option(&self, name: &str) -> Option<String> {
        let named = self.options.iter().rfind(|(key, _)| decoded(key).is_some_and(|key| key == name));
        named.and_then(|(_, value)| decoded(value))
    }
}

/// A text with `%40` for `@`; `None` where it is no UTF-8.
fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let Some((first, others)) = rest.split_first() {
        let digits = others.get(..2).filter(|digits| *first == b'%' && digits.iter().all(u8::is_ascii_hexdigit));
        let byte = digits.and_then(|digits| std::str::from_utf8(digits).ok());
        let byte = byte.and_then(|digits| u8::from_str_radix(digits, 16).ok());
        bytes.push(byte.unwrap_or(*first));
        rest = others.within(if byte.is_some() { 2 } else { 0 }..);
    }
    String::from_utf8(bytes).ok()
}
