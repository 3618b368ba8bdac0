//! A text that is read from left to right, character by character; reading never passes its end and never fails.

/// Where something is in a text, in bytes: from `start` up to before `end`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct TextSpan {
    pub(super) start: usize,
    pub(super) end: usize,
}

/// A text and how far it has been read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scanner<'a> {
    text: &'a str,
    rest: &'a str,
}

impl<'a> Scanner<'a> {
    pub(super) const fn new(text: &'a str) -> Self {
        Self { text, rest: text }
    }

    /// The whole text.
    pub(super) const fn text(&self) -> &'a str {
        self.text
    }

    /// What has not been read yet.
    pub(super) const fn rest(&self) -> &'a str {
        self.rest
    }

    /// Bytes read so far.
    pub(super) const fn offset(&self) -> usize {
        self.text.len() - self.rest.len()
    }

    /// From an earlier offset up to here.
    pub(super) const fn place_from(&self, start: usize) -> TextSpan {
        TextSpan { start, end: self.offset() }
    }

    /// What has been read since an earlier offset.
    pub(super) fn since(&self, start: usize) -> &'a str {
        self.text.get(start..self.offset()).map_or("", |since| since)
    }

    /// The next character, if any.
    pub(super) fn peek(&self) -> Option<char> {
        self.rest.chars().next()
    }

    /// Reads the next character if it is wanted.
    pub(super) fn eat(&mut self, wanted: impl Fn(char) -> bool) -> bool {
        let mut chars = self.rest.chars();
        let eaten = chars.next().is_some_and(wanted);
        if eaten {
            self.rest = chars.as_str();
        }
        eaten
    }

    /// Reads a word if it comes next.
    pub(super) fn eat_word(&mut self, word: &str) -> bool {
        match self.rest.strip_prefix(word) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    /// Reads all characters that are wanted, perhaps none.
    pub(super) fn take_while(&mut self, wanted: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !wanted(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at_checked(end).unwrap_or((self.rest, ""));
        self.rest = rest;
        taken
    }

    pub(super) fn skip_blanks(&mut self) {
        self.rest = self.rest.trim_start();
    }
}

/// A figure, or a decimal sign.
pub(super) fn is_figure(c: char) -> bool {
    c.is_ascii_digit() || is_decimal_sign(c)
}

pub(super) const fn is_decimal_sign(c: char) -> bool {
    matches!(c, '.' | ',')
}

/// The keyboard's hyphen, the true minus, and the printed en dash.
pub(super) const fn is_minus(c: char) -> bool {
    matches!(c, '-' | '\u{2212}' | '\u{2013}')
}

/// What a deviation may begin with.
pub(super) const fn is_sign(c: char) -> bool {
    is_minus(c) || matches!(c, '+' | '±')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_what_is_wanted_and_nothing_else() {
        let mut scanner = Scanner::new("Ø25 \u{2013}mm");
        assert!(scanner.eat(|c| c == 'Ø') && !scanner.eat(is_sign));
        assert_eq!((scanner.take_while(is_figure), scanner.take_while(is_figure)), ("25", ""));
        scanner.skip_blanks();
        assert!(scanner.eat(is_minus) && !scanner.eat_word("mmm") && scanner.eat_word("mm"));
        assert_eq!((scanner.peek(), scanner.rest(), scanner.since(2)), (None, "", "25 \u{2013}mm"));
        assert_eq!(scanner.place_from(2), TextSpan { start: 2, end: 10 });
        assert!(!scanner.eat(|_| true) && scanner.take_while(|_| true).is_empty());
    }
}
