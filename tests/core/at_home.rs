//! A program that a test starts has a home of its own: nothing reaches the folders and the journal of whoever runs the tests.

use std::path::Path;

/// The variables by which Linux names the folders of a user besides the home.
const FOLDERS: [&str; 3] = ["XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"];

pub trait AtHome {
    /// The home is this folder, and the other folders of the user are below it.
    fn at_home(&mut self, home: impl AsRef<Path>) -> &mut Self;
}

macro_rules! at_home {
    ($($command:ty),+) => {
        $(impl AtHome for $command {
            fn at_home(&mut self, home: impl AsRef<Path>) -> &mut Self {
                for name in FOLDERS {
                    self.env_remove(name);
                }
                let home = home.as_ref();
                // Without these, Windows asks the system, which names the folders of whoever runs the tests.
                self.env("APPDATA", home.join("Roaming")).env("LOCALAPPDATA", home.join("Local"));
                self.env("HOME", home).env("USERPROFILE", home)
            }
        })+
    };
}

at_home!(std::process::Command, assert_cmd::Command);
