//! Bytes to lines: CR, LF, both, or ETX end one. Lines without anything are passed over.

use crate::news::{News, Refusal};

/// The longest line.
pub const LONGEST: usize = 200;

/// ETX ends what a gauge frames by STX and ETX.
const ENDS: [u8; 3] = [b'\r', b'\n', 3];

/// Signs of lines that some gauges send in Windows-1252: degree, plus or minus, micro and the diameters.
const SINGLE: [u8; 5] = [0xb0, 0xb1, 0xb5, 0xd8, 0xf8];

/// What has come of a line.
#[derive(Debug, Default)]
pub struct Lines {
    held: Vec<u8>,
    /// Whether the rest of a line that is too long is passed over.
    is_skipping: bool,
    /// Whether the port was opened a moment ago: a line may have begun before.
    is_joining: bool,
    /// What was told since the last line.
    told: Vec<std::mem::Discriminant<Refusal>>,
}

impl Lines {
    /// Lines of a port that was opened now. What comes without a pause is the end of a line whose beginning nobody has heard.
    pub fn opened() -> Self {
        Self { is_joining: true, ..Self::default() }
    }

    /// Takes bytes as they come, and says what is whole.
    pub fn take(&mut self, bytes: &[u8], tell: &mut dyn FnMut(News)) {
        for byte in bytes {
            if ENDS.contains(byte) {
                self.end(tell);
            } else if self.is_skipping {
                // It ends with the line.
            } else if self.held.len() < LONGEST {
                self.held.push(*byte);
            } else {
                self.held.clear();
                self.is_skipping = true;
                self.refuse(Refusal::TooLong { most: LONGEST }, tell);
            }
        }
    }

    /// Nothing has come for a while: half a line is no line.
    pub fn fall_silent(&mut self, tell: &mut dyn FnMut(News)) {
        self.is_skipping = false;
        self.is_joining = false;
        if !self.held.is_empty() {
            let given = shown(&std::mem::take(&mut self.held));
            self.refuse(Refusal::Half { given }, tell);
        }
    }

    /// Whether silence would change something.
    pub fn awaits_more(&self) -> bool {
        self.is_skipping || self.is_joining || !self.held.is_empty()
    }

    fn end(&mut self, tell: &mut dyn FnMut(News)) {
        let line = std::mem::take(&mut self.held);
        let is_joined = std::mem::take(&mut self.is_joining);
        if std::mem::take(&mut self.is_skipping) || line.iter().all(|byte| b" \t\x02".contains(byte)) {
            return;
        }
        match text(&line) {
            _ if is_joined => self.refuse(Refusal::Joined { given: shown(&line) }, tell),
            Some(line) => {
                self.told.clear();
                tell(News::Line(line));
            }
            None => self.refuse(Refusal::NotText { given: shown(&line) }, tell),
        }
    }

    fn refuse(&mut self, refusal: Refusal, tell: &mut dyn FnMut(News)) {
        let kind = std::mem::discriminant(&refusal);
        if !self.told.contains(&kind) {
            self.told.push(kind);
            tell(News::Refused(refusal));
        }
    }
}

/// A line as text: UTF-8, or ASCII with single signs of Windows-1252.
fn text(line: &[u8]) -> Option<String> {
    let text = std::str::from_utf8(line).map_or_else(
        |_not_utf8| {
            let is_known = |byte: &u8| byte.is_ascii() || SINGLE.contains(byte);
            line.iter().all(is_known).then(|| line.iter().copied().map(char::from).collect::<String>())
        },
        |text| Some(text.to_owned()),
    )?;
    let is_text = |sign: char| !sign.is_control() || sign == '\t' || sign == '\u{2}';
    text.chars().all(is_text).then_some(text)
}

/// Bytes as a message shows them.
fn shown(bytes: &[u8]) -> String {
    bytes.escape_ascii().to_string()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heard(pieces: &[&[u8]]) -> Vec<News> {
        let mut lines = Lines::default();
        let mut heard = Vec::new();
        for piece in pieces {
            // An empty piece stands for silence.
            if piece.is_empty() {
                lines.fall_silent(&mut |news| heard.push(news));
            } else {
                lines.take(piece, &mut |news| heard.push(news));
            }
        }
        heard
    }

    fn line(text: &str) -> News {
        News::Line(text.to_owned())
    }

    #[test]
    fn lines_end_by_cr_lf_both_or_etx_and_empty_ones_are_none() {
        assert_eq!(
            heard(&[b"25.0\r\n", b"25.1\n\r25.2\r", b"2", b"5.3\n\n\r\n \t\n"]),
            ["25.0", "25.1", "25.2", "25.3"].map(line)
        );
        assert_eq!(heard(&[b"\x0225.0\x03\x0225.1\x03\r\n"]), ["\u{2}25.0", "\u{2}25.1"].map(line));
    }

    #[test]
    fn a_line_may_be_as_long_as_allowed_and_no_byte_longer() {
        let longest = [&[b'1'; LONGEST][..], b"\n"].concat();
        assert_eq!(heard(&[&longest]), [line(&"1".repeat(LONGEST))]);
        let longer = [&[b'1'; LONGEST + 1][..], b"\n25.0\n"].concat();
        assert_eq!(heard(&[&longer]), [News::Refused(Refusal::TooLong { most: LONGEST }), line("25.0")]);
    }

    #[test]
    fn garbage_is_told_once_until_a_line_comes() {
        let news = heard(&[b"\xff\xfe\n\xff\n\x00\n25.0\n\x80\n\x81\n"]);
        let not_text = |given: &str| News::Refused(Refusal::NotText { given: given.to_owned() });
        assert_eq!(news, [not_text("\\xff\\xfe"), line("25.0"), not_text("\\x80")]);
    }

    #[test]
    fn half_a_line_and_then_silence_is_told_and_dropped() {
        let news = heard(&[b"25.0", b"", b"25.1\n", b""]);
        assert_eq!(news, [News::Refused(Refusal::Half { given: "25.0".to_owned() }), line("25.1")]);
        // What goes on after a pause is another line.
        let long = [b'1'; LONGEST + 7];
        assert_eq!(heard(&[&long, b"", b"25.0\n"]), [News::Refused(Refusal::TooLong { most: LONGEST }), line("25.0")]);
    }

    #[test]
    fn the_line_in_which_a_port_was_opened_is_told_and_dropped() {
        let mut lines = Lines::opened();
        let mut heard = Vec::new();
        lines.take(b"0123\r\n25.0123\r\n", &mut |news| heard.push(news));
        assert_eq!(heard, [News::Refused(Refusal::Joined { given: "0123".to_owned() }), line("25.0123")]);
        for pause in [&b""[..], b"\r\n"] {
            let mut lines = Lines::opened();
            let mut heard = Vec::new();
            let mut tell = |news| heard.push(news);
            lines.take(pause, &mut tell);
            if pause.is_empty() {
                assert!(lines.awaits_more());
                lines.fall_silent(&mut tell);
            }
            lines.take(b"25.0123\r\n", &mut tell);
            assert_eq!(heard, [line("25.0123")]);
        }
    }

    #[test]
    fn signs_of_utf8_and_of_windows_1252_are_text() {
        assert_eq!(
            heard(&["\u{d8} 25,0 \u{b5}m\n".as_bytes(), b"\xd8 25,0 \xb5m\n"]),
            [line("\u{d8} 25,0 \u{b5}m"), line("\u{d8} 25,0 \u{b5}m")]
        );
    }

    #[test]
    fn no_bytes_whatever_stop_it() {
        let all: Vec<u8> = (0..=255).cycle().take(5_000).collect();
        for size in [1, 2, 3, 7, 199, 200, 201, 5_000] {
            let pieces: Vec<&[u8]> = all.chunks(size).collect();
            assert!(!heard(&pieces).is_empty());
        }
    }
}
