//! The pages of the window: one line each, from which everything follows that has to name every page.

/// Hands the pages to a macro, a line each, in the order of the rail: what the page is for, its variant, its folder, its state, its
/// commands, its text fields, its actions, and its name.
macro_rules! pages {
    ($make:ident) => {
        $make! {
            /// One part: good, rework or scrap.
            Check: check, CheckPage, CheckCommand, CheckField, CheckAction, "page-check";
            /// Plans of whole parts, and the walk through them.
            Parts: parts, PartsPage, PartsCommand, PartsField, PartsAction, "page-parts";
            /// Everything that was recorded.
            Records: records, RecordsPage, RecordsCommand, RecordsField, RecordsAction, "page-records";
            /// Hole against shaft.
            Fit: fit, FitPage, FitCommand, FitField, FitAction, "page-fit";
            /// Measured holes against measured shafts.
            Pairing: pairing, PairingPage, PairingCommand, PairingField, PairingAction, "page-pairing";
            /// Tables of deviations.
            Tables: tables, TablesPage, TablesCommand, TablesField, TablesAction, "page-tables";
            /// Measuring cycles.
            Cycles: cycles, CyclesPage, CyclesCommand, CycleField, CyclesAction, "page-cycles";
            /// NC programs.
            Program: program, ProgramPage, ProgramCommand, ProgramField, ProgramAction, "page-program";
            /// Uncertainty budgets.
            Budget: budget, BudgetPage, BudgetCommand, BudgetField, BudgetAction, "page-budget";
        }
    };
}

macro_rules! page {
    ($($(#[$doc:meta])* $page:ident: $folder:ident, $State:ident, $Command:ident, $Field:ident, $Action:ident, $name:literal;)+) => {
        /// A page of the window.
        #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
        #[serde(rename_all = "lowercase")]
        pub enum Page {
            #[default]
            $($(#[$doc])* $page,)+
        }

        impl Page {
            /// Every page in the order of the rail.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$page),+];

            /// The id of its name.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$page => $name,)+
                }
            }

            /// The digit that opens it with Ctrl; only the first nine have one.
            pub fn digit(self) -> Option<char> {
                let place = Self::ALL.iter().position(|page| *page == self)?;
                char::from_digit(u32::try_from(place + 1).ok()?, 10)
            }
        }
    };
}

pages!(page);
pub(crate) use pages;
