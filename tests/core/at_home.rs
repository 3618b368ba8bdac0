//! A program that a test starts has a home of its own: nothing reaches the folders and the journal of whoever runs the tests.

use std::path::Path;

/// The variables by which systems name the folders of a user besides the home.
const FOLDERS: [&str; 5] = ["XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "APPDATA", "LOCALAPPDATA"];
/// The home by its names.
const HOME: [&str; 2] = ["HOME", "USERPROFILE"];

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
                self.envs(HOME.map(|name| (name, home.as_ref())))
            }
        })+
    };
}

at_home!(std::process::Command, assert_cmd::Command);
