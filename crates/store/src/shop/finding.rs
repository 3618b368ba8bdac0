//! What is wrong on a server, besides its chains.

use fitcheck_core::message::Say;

/// What is wrong on a server, besides its chains.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "shop-finding")]
pub enum ShopFinding {
    /// What keeps entries from being changed is missing or switched off.
    Altered {
        /// The trigger.
        name: String,
    },
    /// Stations are no longer kept to their own chains.
    RowSecurity {
        /// The table.
        name: String,
    },
    /// Something is not what `init` makes.
    Changed { kind: Thing, name: String },
    /// Something that `init` makes is not there.
    Gone { kind: Thing, name: String },
    /// Something is there that `init` does not make.
    Strange { kind: Thing, name: String },
    /// A chain has a name of another length.
    ChainName {
        /// The name in hexadecimal digits.
        name: String,
    },
}

/// A kind of thing in a schema.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "shop-thing")]
pub enum Thing {
    Function,
    /// Who may do what.
    Grant,
    Index,
    /// Whose it is.
    Owner,
    /// Which rows may be read and added.
    Policy,
    Role,
    /// What is done in place of a statement.
    Rule,
    /// A table, one of its columns or of its conditions.
    Table,
    Trigger,
    View,
}
