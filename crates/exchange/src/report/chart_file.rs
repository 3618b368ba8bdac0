//! Charts as files: drawings that stay sharp, or pictures of them.

use std::io;
use std::path::Path;

use super::png::of_svg;

/// Dots for each unit of the drawing: lines and texts stay sharp on a page.
const FINENESS: u16 = 3;

/// A format of charts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChartFile {
    Svg,
    Png,
}

impl ChartFile {
    /// The endings of such files.
    pub const ENDINGS: [&str; 2] = ["svg", "png"];

    /// The format that the ending of a file says; `None` for another ending.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        match ending.as_str() {
            "svg" => Some(Self::Svg),
            "png" => Some(Self::Png),
            _ => None,
        }
    }

    /// A drawing in this format.
    ///
    /// # Errors
    /// A drawing that is refused.
    pub fn bytes(self, name: &str, svg: &str) -> io::Result<Vec<u8>> {
        match self {
            Self::Svg => Ok(svg.as_bytes().to_vec()),
            Self::Png => of_svg(name, svg, FINENESS),
        }
    }
}
