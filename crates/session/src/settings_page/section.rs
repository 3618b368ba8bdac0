//! The sections of the settings page.

/// A section of the settings page.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Section {
    /// Language and keypad.
    #[default]
    General,
    /// Colours and sizes.
    Appearance,
    /// How a value is judged.
    Rule,
    /// Tables, masks and columns of the user.
    OwnFiles,
    /// Where checks are recorded, and who measures.
    Records,
    ShopServer,
    /// Gauges on serial and USB ports.
    Gauges,
    /// Folders that are watched or remembered.
    Folders,
    /// Every key.
    Keys,
    About,
}

impl Section {
    /// Every section in the order of the page.
    pub const ALL: [Self; 10] = [
        Self::General,
        Self::Appearance,
        Self::Rule,
        Self::OwnFiles,
        Self::Records,
        Self::ShopServer,
        Self::Gauges,
        Self::Folders,
        Self::Keys,
        Self::About,
    ];

    /// The id of its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::General => "settings-page-general",
            Self::Appearance => "settings-page-appearance",
            Self::Rule => "settings-page-rule",
            Self::OwnFiles => "settings-page-own-files",
            Self::Records => "settings-page-records",
            Self::ShopServer => "settings-page-shop-server",
            Self::Gauges => "gauges-section",
            Self::Folders => "settings-page-folders",
            Self::Keys => "settings-page-keys",
            Self::About => "settings-page-about",
        }
    }
}
