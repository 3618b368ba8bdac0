//! In which notation a program is written.

use fitcheck_core::probing::cycle::Control;

/// How a program is written. All notations give the same blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Notation {
    /// Klartext of HEIDENHAIN milling controls (`.h`).
    Klartext,
    /// ISO programs of HEIDENHAIN milling controls (`.i`).
    Iso,
    /// DIN PLUS of HEIDENHAIN lathe controls (`.nc`, subprograms `.ncs`).
    DinPlus,
}

impl Notation {
    /// How a program begins.
    pub const fn begin(self) -> &'static str {
        match self {
            Self::Klartext => "BEGIN PGM",
            Self::Iso => "%NAME G71 *",
            Self::DinPlus => "%NAME.nc",
        }
    }

    pub const fn end(self) -> &'static str {
        match self {
            Self::Klartext => "END PGM",
            Self::Iso => "N99999999 %NAME G71 *",
            Self::DinPlus => "ENDE",
        }
    }

    /// The controls that read it.
    pub const fn control(self) -> Control {
        match self {
            Self::Klartext | Self::Iso => Control::Milling,
            Self::DinPlus => Control::Lathe,
        }
    }
}
