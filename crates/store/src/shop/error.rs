//! Why the server of a shop could not be asked, and whether asking again can help.

use std::error::Error as _;
use std::path::PathBuf;

use fitcheck_core::message::{Arg, Message, Say, printed, shortened};
use fitcheck_exchange::journal::chain::{ChainId, Hash};

use super::address::ShopAddress;

/// Why the server of a shop could not be asked. None of these has a password or the text of an entry.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "shop", error)]
pub enum ShopError {
    /// Nobody answers.
    Unreachable {
        /// The address without its password.
        address: String,
        /// What the system says.
        reason: String,
    },
    /// The server does not answer in time, or the connection broke.
    Lost {
        /// What the system says.
        reason: String,
    },
    /// The server has no space left.
    Full,
    /// The server asks to wait: it starts, stops, or has too many connections.
    Busy {
        /// What the server says.
        reason: String,
    },
    /// It asks for a password, and there is none.
    NoPassword { user: String },
    /// The server does not let this user in.
    Refused {
        /// What the server says.
        reason: String,
    },
    /// The server has no TLS.
    NoTls,
    /// The certificate of the server is not one that is trusted, or is another machine's.
    Certificate {
        /// What is wrong with it.
        fault: CertificateFault,
    },
    /// The file of trusted authorities cannot be used.
    Authorities {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// The system trusts no authority at all.
    NoAuthorities,
    /// The database has no journal of a shop.
    NotMade { database: String },
    /// The user may not do this there.
    NoRight {
        /// What the server says.
        reason: String,
    },
    /// There is a schema of this name that is something else.
    Foreign,
    /// A newer Fitcheck made it.
    Newer {
        version: i32,
        /// The newest that is known here.
        known: i32,
    },
    /// The server is older than any that can be used.
    OldServer {
        version: i32,
        /// The oldest that can.
        oldest: i32,
    },
    /// The texts of the database are in another encoding.
    Encoding { encoding: String },
    /// The chain belongs to another login.
    OtherLogin {
        /// The login that began it.
        login: String,
        /// The one that asks.
        ours: String,
    },
    /// The server has another entry with this number: there are two copies of one journal.
    Fork {
        /// The entry's number.
        #[say(with = printed)]
        number: u64,
        /// Its hash here; its first digits are said.
        #[say(with = first_digits)]
        ours: Hash,
        #[say(with = first_digits)]
        theirs: Hash,
    },
    /// The server has more of this chain than the journal here: it was put back from a backup, or is a copy.
    Ahead {
        /// The last entry here.
        #[say(with = printed)]
        ours: u64,
        /// The last entry there.
        #[say(with = printed)]
        theirs: u64,
    },
    /// An entry here cannot be sent: its body is no text.
    NotText {
        /// The entry's number.
        #[say(with = printed)]
        number: u64,
    },
    /// An entry here is longer than any that is kept.
    TooLong {
        /// The entry's number.
        #[say(with = printed)]
        number: u64,
        #[say(with = printed)]
        bytes: usize,
    },
    /// The server says something that it should not.
    Server {
        /// What it says.
        reason: String,
        code: String,
    },
    /// The journal here cannot be read.
    Journal {
        /// What it says.
        what: Box<Message>,
    },
    /// This machine cannot begin: no thread, no runtime.
    Machine {
        /// What the system says.
        reason: String,
    },
    /// Somebody stopped it.
    Stopped,
}

/// What is wrong with a server's certificate.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "shop-certificate")]
pub enum CertificateFault {
    /// No authority that is trusted here has issued it.
    UnknownIssuer,
    /// It is another machine's.
    OtherName,
    /// Its time is over.
    Expired,
    /// Its time has not come.
    NotYet,
    /// Something else.
    Other {
        /// What the check says.
        reason: String,
    },
}

impl CertificateFault {
    fn of(error: &rustls::Error) -> Self {
        use rustls::CertificateError as Fault;
        let rustls::Error::InvalidCertificate(fault) = error else {
            return Self::Other { reason: shortened(&error.to_string(), 300) };
        };
        match fault {
            Fault::UnknownIssuer => Self::UnknownIssuer,
            Fault::NotValidForName | Fault::NotValidForNameContext { .. } => Self::OtherName,
            Fault::Expired | Fault::ExpiredContext { .. } => Self::Expired,
            Fault::NotValidYet | Fault::NotValidYetContext { .. } => Self::NotYet,
            other => Self::Other { reason: shortened(&other.to_string(), 300) },
        }
    }
}

fn first_digits(hash: &Hash) -> Arg {
    Arg::Text(hash.short())
}

impl ShopError {
    /// Whether it may pass by itself, so that asking again later helps.
    pub const fn is_passing(&self) -> bool {
        matches!(
            self,
            Self::Unreachable { .. } | Self::Lost { .. } | Self::Full | Self::Busy { .. } | Self::NotMade { .. }
        )
    }

    /// What a source of entries says.
    pub(super) fn journal(what: Message) -> Self {
        Self::Journal { what: Box::new(what) }
    }

    /// What the client says of a connection.
    pub(super) fn connecting(error: &tokio_postgres::Error, address: &ShopAddress) -> Self {
        if let Some(certificate) = certificate(error) {
            return certificate;
        }
        let text = words(error);
        if text.contains("server does not support TLS") {
            return Self::NoTls;
        }
        if text.contains("password missing") {
            return Self::NoPassword { user: address.user().to_owned() };
        }
        match Self::asking(error) {
            Self::Lost { reason } => Self::Unreachable { address: address.to_string(), reason },
            other => other,
        }
    }

    /// What the client or the server says of a question.
    pub(super) fn asking(error: &tokio_postgres::Error) -> Self {
        let Some(said) = error.as_db_error() else { return Self::Lost { reason: words(error) } };
        // Only the first sentence: the details can have the texts of a row.
        let reason = shortened(said.message(), 200);
        let code = said.code().code();
        match (code, code.get(..2).unwrap_or(code)) {
            ("53100", _) => Self::Full,
            ("42P01" | "3F000", _) => Self::NotMade { database: String::new() },
            (_, "08") => Self::Lost { reason },
            (_, "25" | "40" | "53" | "55" | "57" | "58") => Self::Busy { reason },
            ("3D000", _) | (_, "28") => Self::Refused { reason },
            ("42501", _) => Self::NoRight { reason },
            _ => Self::Server { reason, code: code.to_owned() },
        }
    }
}

/// What is wrong with a certificate, where the handshake failed for that.
fn certificate(error: &tokio_postgres::Error) -> Option<ShopError> {
    let handshake = error.source()?.downcast_ref::<std::io::Error>()?.get_ref()?;
    handshake.downcast_ref::<rustls::Error>().map(|error| ShopError::Certificate { fault: CertificateFault::of(error) })
}

/// An error with the reasons behind it.
fn words(error: &tokio_postgres::Error) -> String {
    let mut text = error.to_string();
    let mut source = error.source();
    while let Some(reason) = source {
        let said = reason.to_string();
        if !text.contains(&said) {
            text = format!("{text}: {said}");
        }
        source = reason.source();
    }
    shortened(&text, 300)
}

/// A chain that the server names in another way than by 16 bytes.
pub(super) fn chain_of(bytes: &[u8]) -> Result<ChainId, ShopError> {
    bytes.try_into().map(ChainId).map_err(|_length| odd("a chain"))
}

/// A hash that the server has in another way than as 32 bytes.
pub(super) fn hash_of(bytes: &[u8]) -> Result<Hash, ShopError> {
    bytes.try_into().map(Hash).map_err(|_length| odd("a hash"))
}

fn odd(what: &str) -> ShopError {
    ShopError::Server { reason: format!("{what} of another length"), code: "-".to_owned() }
}
