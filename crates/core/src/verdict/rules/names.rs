//! The list of decision rules. `mod.rs` says how to add one.

use serde::{Deserialize, Serialize};

use super::{Declaration, Use};

macro_rules! rules {
    ($($(#[$doc:meta])* $name:ident: $file:ident;)+) => {
        /// Which rule. A state file keeps it by its word.
        #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
        #[serde(into = "&'static str", try_from = "String")]
        pub enum RuleName {
            #[default]
            $($(#[$doc])* $name,)+
        }

        impl RuleName {
            /// Every rule, in the order of menus and help.
            pub const ALL: [Self; [$(stringify!($name)),+].len()] = [$(Self::$name),+];

            pub(super) const fn declaration(self) -> &'static Declaration {
                match self {
                    $(Self::$name => &super::$file::DECLARATION,)+
                }
            }
        }
    };
}

rules! {
    /// The control's own.
    Simple: simple;
    /// Conformity with 95 % probability.
    Iso14253Of2017: iso14253_2017;
    /// The expanded uncertainty.
    Iso14253Of1998: iso14253_1998;
    /// A multiple of the expanded uncertainty.
    IlacG8: ilac_g8;
    /// No guard band, where the uncertainty is small enough.
    AsmeSimple: asme_simple;
    /// A smaller zone of acceptance.
    AsmeStringent: asme_stringent;
    /// A larger zone of acceptance.
    AsmeRelaxed: asme_relaxed;
    /// A guard band of a given width.
    Fixed: fixed;
}

impl RuleName {
    /// The word for it on the command line, in files and in answers for programs.
    pub const fn word(self) -> &'static str {
        self.declaration().name
    }

    /// The rule with a word.
    pub fn of_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|rule| rule.word() == word)
    }

    /// Whether its guard band is a multiple of the expanded uncertainty that may be chosen.
    pub const fn takes_factor(self) -> bool {
        self.declaration().takes_factor
    }

    /// Whether it depends on who has to prove.
    pub fn takes_prover(self) -> bool {
        self.declaration().how == Use::Proof
    }

    /// Whether its sentence says the uncertainty: it is made of it.
    pub fn says_uncertainty(self) -> bool {
        self.declaration().needs_uncertainty()
    }

    /// Whether its guard band is given.
    pub const fn takes_width(self) -> bool {
        self.declaration().takes_width
    }
}

impl From<RuleName> for &'static str {
    fn from(rule: RuleName) -> Self {
        rule.word()
    }
}

impl TryFrom<String> for RuleName {
    type Error = String;

    /// # Errors
    /// The words of all rules.
    fn try_from(word: String) -> Result<Self, String> {
        let words = || Self::ALL.map(Self::word).join(", ");
        Self::of_word(&word).ok_or_else(|| format!("{word} is no decision rule: expected {}", words()))
    }
}
