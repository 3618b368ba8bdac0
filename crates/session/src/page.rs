//! The pages of the window: one line each, from which everything follows that has to name every page.

/// Hands the pages to a macro, a line each, in the order of the rail: what the page is for, its variant, its folder, its state, its
/// commands, its text fields, its actions, its name, and its page of the manual.
macro_rules! pages {
    ($make:ident) => {
        $make! {
            /// One part: good, rework or scrap.
            Check: check, CheckPage, CheckCommand, CheckField, CheckAction, "page-check", "check.md";
            /// Plans of whole parts, and the walk through them.
            Parts: parts, PartsPage, PartsCommand, PartsField, PartsAction, "page-parts", "parts.md";
            /// Everything that was recorded.
            Records: records, RecordsPage, RecordsCommand, RecordsField, RecordsAction, "page-records", "records.md";
            /// Hole against shaft.
            Fit: fit, FitPage, FitCommand, FitField, FitAction, "page-fit", "fits.md";
            /// Measured holes against measured shafts.
            Pairing: pairing, PairingPage, PairingCommand, PairingField, PairingAction, "page-pairing", "pairs.md";
            /// Tables of deviations.
            Tables: tables, TablesPage, TablesCommand, TablesField, TablesAction, "page-tables", "tables.md";
            /// Measuring cycles.
            Cycles: cycles, CyclesPage, CyclesCommand, CycleField, CyclesAction, "page-cycles", "cycles.md";
            /// NC programs.
            Program: program, ProgramPage, ProgramCommand, ProgramField, ProgramAction, "page-program", "programs.md";
            /// Uncertainty budgets.
            Budget: budget, BudgetPage, BudgetCommand, BudgetField, BudgetAction, "page-budget", "uncertainty.md";
            /// The values of a feature as a series.
            Statistics: statistics, StatisticsPage, StatisticsCommand, StatisticsField, StatisticsAction, "page-statistics", "statistics.md";
            /// Reports to print, to sign and to keep.
            Reports: reports, ReportsPage, ReportsCommand, ReportsField, ReportsAction, "page-reports", "reports.md";
            /// The manual, the keys and the samples.
            Help: help, HelpPage, HelpCommand, HelpField, HelpAction, "page-help", "window.md";
            /// Everything that can be set.
            Settings: settings_page, SettingsPage, SettingsCommand, SettingsField, SettingsAction, "page-settings", "settings.md";
        }
    };
}

macro_rules! page {
    ($($(#[$doc:meta])* $page:ident: $folder:ident, $State:ident, $Command:ident, $Field:ident, $Action:ident, $name:literal, $manual:literal;)+) => {
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

            /// The id of another name by which it is found, where it is known by one.
            pub(crate) const fn also(self) -> Option<&'static str> {
                match self {
                    Self::Budget => Some("page-budget-also"),
                    _ => None,
                }
            }

            /// The file of the manual's page about it, which F1 opens.
            pub const fn manual(self) -> &'static str {
                match self {
                    $(Self::$page => $manual,)+
                }
            }

            /// Whether an operator has it.
            pub const fn is_for_operators(self) -> bool {
                matches!(self, Self::Check | Self::Parts | Self::Records | Self::Help)
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
