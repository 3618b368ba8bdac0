//! The fonts of a page: which of them has a sign, how wide a text is, and its glyphs.
//!
//! The fonts are the window's. They cover Latin and Greek. A sign that none of them has is shown as an empty box, and the text behind it stays
//! what it is: it can be searched and copied. Signs that a page must not contain become replacement characters before that, see
//! [`Fonts::clean`].

use std::borrow::Cow;
use std::cell::Cell;
use std::io;

use fitcheck_shipped::fonts;
use krilla::text::{Font, GlyphId, KrillaGlyph};
use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider as _};
use unicode_normalization::{UnicodeNormalization as _, is_nfc};

use crate::report::said::is_hidden;

/// How heavy a text is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Weight {
    Regular,
    Semibold,
}

/// What stands for a sign that no font has.
const SUBSTITUTE: char = '□';
/// What stands for a text that was cut.
pub(super) const ELLIPSIS: char = '…';
/// Up to here glyphs are found without a search: Latin and its marks.
const LOW: u32 = 0x250;

/// A glyph of a font, and its width in ems.
#[derive(Debug, Clone, Copy)]
struct Found {
    glyph: u32,
    advance: f32,
}

/// A glyph to be drawn by its outline: its font, its number there, and its width in ems.
pub(super) type Drawn = (FontRef<'static>, skrifa::GlyphId, f32);

struct Face {
    font: Font,
    all: FontRef<'static>,
    low: Vec<Option<Found>>,
    /// Sorted.
    high: Vec<(char, Found)>,
}

impl Face {
    fn new(bytes: &'static [u8]) -> io::Result<Self> {
        let font = Font::new(bytes.into(), 0).ok_or_else(|| io::Error::other("a built-in font cannot be read"))?;
        let all = FontRef::new(bytes).map_err(io::Error::other)?;
        let metrics = all.glyph_metrics(Size::unscaled(), LocationRef::default());
        let mut low = Vec::new();
        let mut high = Vec::new();
        for (sign, glyph) in all.charmap().mappings() {
            let Some(sign) = char::from_u32(sign) else { continue };
            let advance = metrics.advance_width(glyph).map_or(0.0, |width| width / font.units_per_em());
            let found = Found { glyph: glyph.to_u32(), advance };
            if u32::from(sign) < LOW {
                let at = usize::try_from(u32::from(sign)).map_err(io::Error::other)?;
                if low.len() <= at {
                    low.resize(at + 1, None);
                }
                if let Some(place) = low.get_mut(at) {
                    *place = Some(found);
                }
            } else {
                high.push((sign, found));
            }
        }
        high.sort_unstable_by_key(|(sign, _)| *sign);
        Ok(Self { font, all, low, high })
    }

    fn drawn(&self, found: Found) -> Drawn {
        (self.all.clone(), skrifa::GlyphId::new(found.glyph), found.advance)
    }

    fn find(&self, sign: char) -> Option<Found> {
        if u32::from(sign) < LOW {
            let at = usize::try_from(u32::from(sign)).ok()?;
            return self.low.get(at).copied().flatten();
        }
        let at = self.high.binary_search_by_key(&sign, |(known, _)| *known).ok()?;
        self.high.get(at).map(|(_, found)| *found)
    }
}

/// Glyphs of one font that stand one behind the other.
pub(super) struct Run<'a> {
    pub font: Font,
    pub glyphs: Vec<KrillaGlyph>,
    pub text: &'a str,
    pub width: f32,
}

/// The fonts.
pub(super) struct Fonts {
    regular: Face,
    semibold: Face,
    symbols: Face,
    icons: Face,
    lacks: Cell<bool>,
}

impl Fonts {
    /// The built-in fonts.
    ///
    /// # Errors
    /// One of them cannot be read, which is a fault of the program.
    pub fn new() -> io::Result<Self> {
        Ok(Self {
            regular: Face::new(fonts::SANS)?,
            semibold: Face::new(fonts::SEMIBOLD)?,
            symbols: Face::new(fonts::SYMBOLS)?,
            icons: Face::new(fonts::ICONS_BOLD)?,
            lacks: Cell::new(false),
        })
    }

    /// Whether a sign was asked for that no font has.
    pub fn has_lacked(&self) -> bool {
        self.lacks.get()
    }

    /// The text as a page may have it: its letters composed, its line ends and tabs as spaces, and a replacement character for each sign that
    /// must not be on a page or would not be seen there.
    pub fn clean(text: &str) -> Cow<'_, str> {
        let is_space = |c: char| matches!(c, '\n' | '\r' | '\t');
        let is_bad = |c: char| is_hidden(c) || is_unseen(c);
        if is_nfc(text) && !text.chars().any(|c| is_space(c) || is_bad(c)) {
            return Cow::Borrowed(text);
        }
        let clean = |c: char| match c {
            _ if is_space(c) => ' ',
            _ if is_bad(c) => char::REPLACEMENT_CHARACTER,
            _ => c,
        };
        Cow::Owned(text.nfc().map(clean).collect())
    }

    const fn face(&self, weight: Weight) -> &Face {
        match weight {
            Weight::Regular => &self.regular,
            Weight::Semibold => &self.semibold,
        }
    }

    /// The font and the glyph of a sign; a box where no font has it.
    fn find(&self, sign: char, weight: Weight) -> (&Face, Found) {
        let face = self.face(weight);
        if let Some(found) = face.find(sign) {
            return (face, found);
        }
        if let Some(found) = self.symbols.find(sign) {
            return (&self.symbols, found);
        }
        self.lacks.set(true);
        (face, face.find(SUBSTITUTE).unwrap_or(Found { glyph: 0, advance: 0.5 }))
    }

    /// The width of a sign in ems.
    pub fn advance(&self, sign: char, weight: Weight) -> f32 {
        self.find(sign, weight).1.advance
    }

    /// The width of a text of this size.
    pub fn width(&self, text: &str, weight: Weight, size: f32) -> f32 {
        text.chars().map(|sign| self.advance(sign, weight)).sum::<f32>() * size
    }

    /// The glyphs of a text, by their fonts.
    pub fn runs<'a>(&self, text: &'a str, weight: Weight) -> Vec<Run<'a>> {
        let mut runs: Vec<Run<'a>> = Vec::new();
        let mut start = 0;
        for (at, sign) in text.char_indices() {
            let (face, found) = self.find(sign, weight);
            if runs.last().is_none_or(|run| run.font != face.font) {
                runs.push(Run { font: face.font.clone(), glyphs: Vec::new(), text: "", width: 0.0 });
                start = at;
            }
            let end = at + sign.len_utf8();
            if let Some(run) = runs.last_mut() {
                run.text = text.get(start..end).unwrap_or("");
                run.width += found.advance;
                run.glyphs.push(glyph(found, at - start..end - start));
            }
        }
        runs
    }

    /// The glyphs of a text one by one, for a picture.
    pub fn drawn<'a>(&'a self, text: &'a str, weight: Weight) -> impl Iterator<Item = Drawn> + 'a {
        text.chars().map(move |sign| {
            let (face, found) = self.find(sign, weight);
            face.drawn(found)
        })
    }

    /// An icon, for a picture.
    pub fn drawn_icon(&self, sign: char) -> Option<Drawn> {
        self.icons.find(sign).map(|found| self.icons.drawn(found))
    }

    /// The outline of an icon: its font, its glyph, and its width in ems.
    pub fn icon(&self, sign: char) -> Option<(Font, KrillaGlyph, f32)> {
        let found = self.icons.find(sign)?;
        Some((self.icons.font.clone(), glyph(found, 0..sign.len_utf8()), found.advance))
    }
}

fn glyph(found: Found, range: std::ops::Range<usize>) -> KrillaGlyph {
    KrillaGlyph {
        glyph_id: GlyphId::new(found.glyph),
        text_range: range,
        x_advance: found.advance,
        x_offset: 0.0,
        y_offset: 0.0,
        y_advance: 0.0,
        location: None,
    }
}

/// Signs without a form of their own, and signs that mean something to one program alone: neither is allowed in a file that is to be kept.
const fn is_unseen(c: char) -> bool {
    matches!(c,
        '\u{ad}' | '\u{200b}'..='\u{200f}' | '\u{2028}' | '\u{2029}' | '\u{2060}'..='\u{2065}' | '\u{feff}' | '\u{fff0}'..='\u{fffb}'
        | '\u{e000}'..='\u{f8ff}' | '\u{fdd0}'..='\u{fdef}' | '\u{e0000}'..='\u{e0fff}' | '\u{f0000}'..='\u{10ffff}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_must_not_be_on_a_page_becomes_visible() {
        assert_eq!(Fonts::clean("Bore A"), "Bore A");
        assert_eq!(Fonts::clean("a\tb\nc\u{1b}[0m\u{202e}d\u{e000}"), "a b c\u{fffd}[0m\u{fffd}d\u{fffd}");
        assert_eq!(Fonts::clean("Lo\u{308}cher"), "Löcher");
    }

    #[test]
    fn a_sign_that_no_font_has_is_a_box_and_is_known() {
        let fonts = Fonts::new().unwrap();
        assert_eq!(fonts.runs("Ø 25 H7 ⌀ µ", Weight::Regular).len(), 3);
        assert!(!fonts.has_lacked());
        let runs = fonts.runs("中", Weight::Semibold);
        assert_eq!((runs.len(), runs[0].text, fonts.has_lacked()), (1, "中", true));
    }
}
