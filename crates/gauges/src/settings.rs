//! How a port is set. The manual of a gauge or of its cable names all of it.

use serde::{Deserialize, Serialize};

/// How a port is set.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct PortSettings {
    /// The name that the system has for it: `/dev/ttyUSB0`, `COM3`.
    pub port: String,
    /// Bits in a second.
    pub speed: u32,
    pub bits: DataBits,
    pub parity: Parity,
    pub stop: StopBits,
}

/// What most gauges send.
impl Default for PortSettings {
    fn default() -> Self {
        Self {
            port: String::new(),
            speed: 9_600,
            bits: DataBits::default(),
            parity: Parity::default(),
            stop: StopBits::default(),
        }
    }
}

/// How many bits a character has.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum DataBits {
    Seven,
    #[default]
    Eight,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Parity {
    #[default]
    None,
    Even,
    Odd,
}

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum StopBits {
    #[default]
    One,
    Two,
}

impl PortSettings {
    /// The speeds that gauges have.
    pub const SPEEDS: [u32; 10] = [300, 600, 1_200, 2_400, 4_800, 9_600, 19_200, 38_400, 57_600, 115_200];
}

impl DataBits {
    pub const ALL: [Self; 2] = [Self::Seven, Self::Eight];
}

impl Parity {
    pub const ALL: [Self; 3] = [Self::None, Self::Even, Self::Odd];
}

impl StopBits {
    pub const ALL: [Self; 2] = [Self::One, Self::Two];
}
