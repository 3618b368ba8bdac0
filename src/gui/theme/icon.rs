//! The icons: Phosphor, cut to what is named here by `assets/fonts/subset.py`.

use eframe::egui::{Align2, Color32, FontFamily, FontId, Painter, Pos2, RichText};

fitcheck_core::named! {
    /// How an icon is drawn: bold for verdicts and carets, filled for the page where one is.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Weight {
        ALL;
        /// The name of its font, which is a family of its own: a line of text has another middle than an icon.
        fn font;
        Regular = "icons-regular",
        Bold = "icons-bold",
        Fill = "icons-fill",
    }
}

macro_rules! icons {
    ($($name:ident = $sign:literal)*) => {
        /// An icon by Phosphor's name for it.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Icon { $($name),* }

        impl Icon {
            /// Every icon, for the test that each has a glyph.
            #[cfg(test)]
            pub const ALL: &[Self] = &[$(Self::$name),*];

            const fn sign(self) -> char {
                match self { $(Self::$name => $sign),* }
            }
        }
    };
}

icons! {
    AppWindow = '\u{e5da}'
    ArrowBendDoubleUpRight = '\u{e03c}'
    ArrowCounterClockwise = '\u{e038}'
    ArrowLineDown = '\u{e05c}'
    ArrowRight = '\u{e06c}'
    ArrowUUpLeft = '\u{e08a}'
    ArrowUUpRight = '\u{e08c}'
    ArrowsVertical = '\u{eb04}'
    Backspace = '\u{e0ae}'
    Bell = '\u{e0ce}'
    Buildings = '\u{e102}'
    CaretDown = '\u{e136}'
    CaretRight = '\u{e13a}'
    ChartScatter = '\u{eaac}'
    Check = '\u{e182}'
    CheckCircle = '\u{e184}'
    Columns = '\u{e546}'
    Copy = '\u{e1ca}'
    Crosshair = '\u{e1d6}'
    Cube = '\u{e1da}'
    CursorText = '\u{e7d8}'
    Database = '\u{e1de}'
    DotsThree = '\u{e1fe}'
    FileCode = '\u{e914}'
    FileText = '\u{e23a}'
    FloppyDisk = '\u{e248}'
    Folder = '\u{e24a}'
    FolderOpen = '\u{e256}'
    FunnelSimple = '\u{e268}'
    GearSix = '\u{e272}'
    Info = '\u{e2ce}'
    Intersect = '\u{e2d2}'
    Keyboard = '\u{e2d8}'
    LinkSimpleHorizontal = '\u{e2ea}'
    ListChecks = '\u{eadc}'
    ListNumbers = '\u{e2f6}'
    LockSimple = '\u{e308}'
    MagnifyingGlass = '\u{e30c}'
    Minus = '\u{e32a}'
    NotePencil = '\u{e34c}'
    Numpad = '\u{e3c8}'
    Palette = '\u{e6c8}'
    Pause = '\u{e39e}'
    PencilSimple = '\u{e3b4}'
    Play = '\u{e3d0}'
    Plus = '\u{e3d4}'
    PlusMinus = '\u{e3d8}'
    Question = '\u{e3e8}'
    Repeat = '\u{e3f6}'
    Ruler = '\u{e6b8}'
    Scales = '\u{e750}'
    SealCheck = '\u{e606}'
    SkipForward = '\u{e5a6}'
    Table = '\u{e476}'
    Target = '\u{e47c}'
    ThermometerSimple = '\u{e5cc}'
    TrayArrowDown = '\u{e010}'
    User = '\u{e4c2}'
    WarningCircle = '\u{e4e2}'
    X = '\u{e4f6}'
}

impl Icon {
    /// In a button or a line: a piece of text of its own.
    pub fn text(self, weight: Weight, size: f32) -> RichText {
        RichText::new(self.sign()).font(font(weight, size))
    }

    /// An icon of a page that will be printed, by its sign in the font.
    pub fn paint_sign(painter: &Painter, at: Pos2, sign: char, size: f32, colour: Color32) {
        painter.text(at, Align2::CENTER_CENTER, sign, font(Weight::Bold, size), colour);
    }

    /// In the middle of a place.
    pub fn paint(self, painter: &Painter, at: Pos2, weight: Weight, size: f32, colour: Color32) {
        painter.text(at, Align2::CENTER_CENTER, self.sign(), font(weight, size), colour);
    }
}

fn font(weight: Weight, size: f32) -> FontId {
    FontId::new(size, FontFamily::Name(weight.font().into()))
}
