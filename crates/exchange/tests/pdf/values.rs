//! What a PDF is made of (ISO 32000-1, 7.3): names, numbers, texts, arrays, dictionaries, references.

use std::collections::BTreeMap;

/// A value.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Number(f64),
    Name(String),
    Text(Vec<u8>),
    Array(Vec<Self>),
    Dictionary(BTreeMap<String, Self>),
    Reference(usize),
    /// `true`, `null`, `obj`, an operator.
    Word(String),
}

impl Value {
    pub fn get(&self, key: &str) -> Option<&Self> {
        match self {
            Self::Dictionary(all) => all.get(key),
            _ => None,
        }
    }

    pub fn name(&self) -> &str {
        match self {
            Self::Name(name) | Self::Word(name) => name,
            _ => "",
        }
    }

    pub fn items(&self) -> &[Self] {
        match self {
            Self::Array(items) => items,
            _ => std::slice::from_ref(self),
        }
    }

    pub fn whole(&self) -> Option<usize> {
        match self {
            Self::Number(number) => format!("{number:.0}").parse().ok(),
            _ => None,
        }
    }

    /// A text as UTF-16 with its mark, or as bytes.
    pub fn text(&self) -> String {
        let Self::Text(bytes) = self else { return String::new() };
        match bytes.strip_prefix(&[0xfe, 0xff]) {
            Some(wide) => {
                let units: Vec<u16> = wide.chunks(2).map(|two| u16::from_be_bytes([two[0], two[1]])).collect();
                String::from_utf16(&units).unwrap()
            }
            None => bytes.iter().map(|byte| char::from(*byte)).collect(),
        }
    }
}

/// Reads values one after the other.
#[derive(Clone)]
pub struct Values<'a> {
    pub bytes: &'a [u8],
    pub at: usize,
}

impl<'a> Values<'a> {
    pub const fn new(bytes: &'a [u8], at: usize) -> Self {
        Self { bytes, at }
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn blanks(&mut self) {
        while let Some(byte) = self.peek() {
            match byte {
                b'%' => {
                    while self.peek().is_some_and(|byte| byte != b'\n' && byte != b'\r') {
                        self.at += 1;
                    }
                }
                b' ' | b'\n' | b'\r' | b'\t' | 0 | 12 => self.at += 1,
                _ => return,
            }
        }
    }

    fn starts(&self, with: &[u8]) -> bool {
        self.bytes[self.at..].starts_with(with)
    }

    /// The next one; `None` at the end.
    pub fn next(&mut self) -> Option<Value> {
        self.blanks();
        Some(match self.peek()? {
            b'/' => {
                self.at += 1;
                Value::Name(self.word())
            }
            b'(' => self.literal(),
            b'<' if self.starts(b"<<") => {
                self.at += 2;
                self.dictionary()
            }
            b'<' => self.hexadecimal(),
            b'[' => {
                self.at += 1;
                let mut items = Vec::new();
                loop {
                    self.blanks();
                    if self.peek()? == b']' {
                        self.at += 1;
                        return Some(Value::Array(items));
                    }
                    items.push(self.next()?);
                }
            }
            _ => self.number_or_word(),
        })
    }

    fn word(&mut self) -> String {
        let start = self.at;
        let ends = |byte: u8| byte.is_ascii_whitespace() || b"/<>[](){}%\0".contains(&byte);
        while self.peek().is_some_and(|byte| !ends(byte)) {
            self.at += 1;
        }
        String::from_utf8_lossy(&self.bytes[start..self.at]).into_owned()
    }

    fn number_or_word(&mut self) -> Value {
        let word = self.word();
        assert!(!word.is_empty(), "odd byte {:?} at {}", self.peek().map(char::from), self.at);
        let Ok(number) = word.parse::<f64>() else { return Value::Word(word) };
        // `12 0 R`
        let mut ahead = self.clone();
        ahead.blanks();
        let generation = ahead.word();
        ahead.blanks();
        if !generation.is_empty() && generation.bytes().all(|b| b.is_ascii_digit()) && ahead.word() == "R" {
            self.at = ahead.at;
            return Value::Reference(word.parse().unwrap());
        }
        Value::Number(number)
    }

    fn dictionary(&mut self) -> Value {
        let mut all = BTreeMap::new();
        loop {
            self.blanks();
            if self.starts(b">>") {
                self.at += 2;
                return Value::Dictionary(all);
            }
            let key = self.next().unwrap();
            all.insert(key.name().to_owned(), self.next().unwrap());
        }
    }

    fn hexadecimal(&mut self) -> Value {
        let end = self.at + self.bytes[self.at..].iter().position(|byte| *byte == b'>').unwrap();
        let digits: Vec<u8> = self.bytes[self.at + 1..end].iter().copied().filter(u8::is_ascii_hexdigit).collect();
        self.at = end + 1;
        let byte = |two: &[u8]| u8::from_str_radix(std::str::from_utf8(two).unwrap(), 16).unwrap();
        Value::Text(digits.chunks(2).map(byte).collect())
    }

    fn literal(&mut self) -> Value {
        let mut text = Vec::new();
        let mut deep = 0;
        loop {
            let byte = self.peek().unwrap();
            self.at += 1;
            match byte {
                b'(' => {
                    deep += 1;
                    if deep == 1 {
                        continue;
                    }
                }
                b')' => {
                    deep -= 1;
                    if deep == 0 {
                        return Value::Text(text);
                    }
                }
                b'\\' => {
                    let escaped = self.peek().unwrap();
                    self.at += 1;
                    text.push(match escaped {
                        b'n' => b'\n',
                        b'r' => b'\r',
                        b't' => b'\t',
                        b'b' => 8,
                        b'f' => 12,
                        b'0'..=b'7' => {
                            let digits = std::str::from_utf8(&self.bytes[self.at - 1..self.at + 2]).unwrap();
                            self.at += 2;
                            u8::from_str_radix(digits, 8).unwrap()
                        }
                        other => other,
                    });
                    continue;
                }
                _ => {}
            }
            text.push(byte);
        }
    }
}
