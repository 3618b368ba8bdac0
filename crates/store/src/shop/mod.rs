//! The PostgreSQL server of a shop: every station's journal in one place, each of them a chain of its own.
//!
//! A station writes to its own file first and sends what it has. The server keeps the bodies byte for byte, refuses changes and looks at
//! each link; but what proves a chain is walking along it here, and the copy that its station has.
//!
//! | file | what |
//! |---|---|
//! | `address` | where the server is, without the password |
//! | `password` | the password, which nothing prints |
//! | `access`, `pgpass` | an address with its password, from the places where PostgreSQL's own programs look for it |
//! | `tls` | certificates are always checked |
//! | `server` | a connection that waits for nothing for ever |
//! | `schema`, `roles.sql`, `tables.sql`, `view.sql` | what the database has, and how it comes to a newer version |
//! | `source`, `send`, `sender` | a journal, sent once or in the background |
//! | `verify`, `clock` | whether the chains on the server are whole; how clocks differ |
//! | `structure` | whether functions, policies, grants and the like are what `init` makes |
//! | `finding` | what is wrong on a server, besides its chains |
//! | `reading` | questions about the checks of all stations |
//! | `error` | why the server could not be asked |

mod access;
mod address;
mod clock;
mod error;
mod finding;
mod password;
pub mod pgpass;
mod reading;
mod schema;
mod send;
mod sender;
mod server;
mod source;
mod structure;
mod tls;
mod verify;

pub use access::{Access, PasswordRemark, Places, keep_in_keyring};
pub use address::{AddressError, ShopAddress};
pub use clock::{Clock, clocks};
pub use error::{CertificateFault, ShopError};
pub use finding::{ShopFinding, Thing};
pub use password::Password;
pub use reading::{ListPlace, Page, ShopReader, ShopRow};
pub use schema::{SCHEMA, Schema, SchemaInit, init, init_as};
pub use send::{LONGEST_BODY, Sent, send_once};
pub use sender::{Doing, Sender, Sending, Status};
pub use server::{Patience, Stop};
pub use source::Source;
pub use verify::{Elsewhere, ShopChain, ShopVerified, verify, verify_beside};
