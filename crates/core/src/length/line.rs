//! A text that grows at its end.

use std::io;

/// A text that grows at its end. Short pieces go into a [`Window`] of it, which knows how much room it has.
#[derive(Debug, Clone, Default)]
pub struct Line {
    /// What was written, and room behind it.
    bytes: Vec<u8>,
    /// How much was written.
    end: usize,
}

/// Room for pieces of a text that are at most 128 bytes long together; what is longer is cut off.
#[derive(Debug)]
pub struct Window<'a> {
    bytes: &'a mut [u8; ROOM],
    /// How much was written.
    end: usize,
}

/// How long all pieces are at most: more than six lengths, of at most eighteen bytes each.
const MOST: usize = 128;

/// How long a piece is at most.
const LONGEST: usize = 16;

/// The room that pieces need.
pub const ROOM: usize = MOST + LONGEST;

impl<'a> Window<'a> {
    /// Nothing written yet.
    pub const fn new(bytes: &'a mut [u8; ROOM]) -> Self {
        Self { bytes, end: 0 }
    }

    /// What was written.
    pub fn bytes(&self) -> &[u8] {
        let (written, _) = self.bytes.split_at(self.end.min(MOST));
        written
    }

    /// Appends the first `count` bytes of a piece, at most all. The piece is written in one step, and without a question
    /// whether there is room: behind the last place there is room for any.
    #[expect(clippy::inline_always, reason = "a store and a sum, ten times for each of millions of rows")]
    #[inline(always)]
    pub fn piece<const N: usize>(&mut self, piece: [u8; N], count: u8) {
        const { assert!(N <= LONGEST, "there is no room for it") };
        if let Some(place) = self.bytes.get_mut(self.end.min(MOST)..).and_then(<[u8]>::first_chunk_mut) {
            *place = piece;
            self.end += usize::from(count);
        }
    }

    /// Appends a byte.
    #[inline]
    pub fn push(&mut self, byte: u8) {
        self.piece([byte], 1);
    }
}

impl Line {
    /// What was written.
    pub fn bytes(&self) -> &[u8] {
        let (written, _) = self.bytes.split_at(self.end);
        written
    }

    /// Begins anew; the room stays.
    pub const fn clear(&mut self) {
        self.end = 0;
    }

    /// Appends pieces.
    #[expect(clippy::inline_always, reason = "as each piece")]
    #[inline(always)]
    pub fn pieces(&mut self, write: impl FnOnce(&mut Window<'_>)) {
        let bytes = match self.bytes.get_mut(self.end..).and_then(<[u8]>::first_chunk_mut) {
            Some(bytes) => bytes,
            None => match Self::room(&mut self.bytes, self.end).and_then(<[u8]>::first_chunk_mut) {
                Some(bytes) => bytes,
                None => return,
            },
        };
        let mut window = Window::new(bytes);
        write(&mut window);
        self.end += window.end.min(MOST);
    }

    /// Appends a byte.
    #[inline]
    pub fn push(&mut self, byte: u8) {
        self.append(&[byte]);
    }

    /// Appends a text.
    #[inline]
    pub fn append(&mut self, text: &[u8]) {
        match self.bytes.get_mut(self.end..).and_then(|rest| rest.get_mut(..text.len())) {
            Some(place) => place.copy_from_slice(text),
            None => self.append_beyond(text),
        }
        self.end += text.len();
    }

    /// Appends a part of a text. What comes behind the part in the text may be read, so that most of it is copied in steps
    /// of a fixed length.
    #[inline]
    pub fn append_part(&mut self, text: &[u8], start: usize, end: usize) {
        const STEP: usize = 64;
        let mut at = start;
        while at < end {
            let piece = text.get(at..).and_then(<[u8]>::first_chunk::<STEP>);
            let place = self.bytes.get_mut(self.end..).and_then(<[u8]>::first_chunk_mut);
            let (Some(piece), Some(place)) = (piece, place) else {
                // The last of the text, or of the room.
                return text.get(at..end).map_or((), |rest| self.append(rest));
            };
            *place = *piece;
            self.end += STEP.min(end - at);
            at += STEP;
        }
    }

    #[cold]
    fn append_beyond(&mut self, text: &[u8]) {
        self.bytes.truncate(self.end);
        self.bytes.extend_from_slice(text);
    }

    /// More room behind what was written, twice as much as there was.
    #[cold]
    fn room(bytes: &mut Vec<u8>, end: usize) -> Option<&mut [u8]> {
        bytes.resize(2 * end + ROOM, 0);
        bytes.get_mut(end..)
    }
}

impl io::Write for Line {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.append(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_and_parts_stand_one_behind_the_other() {
        let text: Vec<u8> = (0..=255).collect();
        for length in 0..200 {
            let mut line = Line::default();
            let mut should = Vec::new();
            for start in [0, 7, 56, 255] {
                let end = (start + length).min(text.len());
                line.append_part(&text, start, end);
                should.extend_from_slice(&text[start..end]);
                line.pieces(|window| {
                    window.piece(*b"12345678", u8::try_from(length % 9).unwrap());
                    window.push(b';');
                });
                should.extend_from_slice(&b"12345678"[..length % 9]);
                should.push(b';');
            }
            assert_eq!(line.bytes(), should);
            line.clear();
            assert_eq!(line.bytes(), b"");
        }
    }

    #[test]
    fn what_has_no_room_in_a_window_is_cut_off() {
        for count in 0..=8 {
            let mut bytes = [0; ROOM];
            let mut window = Window::new(&mut bytes);
            (0..40).for_each(|_| window.piece(*b"12345678", count));
            let should = b"12345678"[..usize::from(count)].repeat(40);
            assert_eq!(window.bytes(), &should[..should.len().min(MOST)]);
        }
    }
}
