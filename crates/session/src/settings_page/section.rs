//! The sections of the settings page.

fitcheck_core::named! {
    /// A section of the settings page.
    #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Section {
        /// Every section in the order of the page.
        ALL;
        /// The id of its name.
        fn name;
        /// Language and keypad.
        #[default]
        General = "settings-page-general",
        /// Colours and sizes.
        Appearance = "settings-page-appearance",
        /// How a value is judged.
        Rule = "settings-page-rule",
        /// Tables, masks and columns of the user.
        OwnFiles = "settings-page-own-files",
        /// Where checks are recorded, and who measures.
        Records = "settings-page-records",
        ShopServer = "settings-page-shop-server",
        /// Gauges on serial and USB ports.
        Gauges = "gauges-section",
        /// Folders that are watched or remembered.
        Folders = "settings-page-folders",
        /// Every key.
        Keys = "settings-page-keys",
        About = "settings-page-about",
    }
}
