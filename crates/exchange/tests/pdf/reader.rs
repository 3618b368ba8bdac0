//! A small reader of PDF files, enough to see whether ours say what they should: objects, texts of pages, logical structure, attachments.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Read as _;

use super::values::{Value, Values};

/// An object: its value, and the bytes of its stream as they are read.
#[derive(Debug, Clone)]
struct Object {
    value: Value,
    stream: Vec<u8>,
}

/// A file.
#[derive(Debug)]
pub struct Pdf {
    objects: BTreeMap<usize, Object>,
    root: usize,
}

/// An element of the logical structure.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Element {
    pub role: String,
    pub alt: Option<String>,
    pub scope: String,
    /// What is said of it itself, then of what is in it.
    pub text: String,
    pub children: Vec<Self>,
}

impl Element {
    /// Every element of a role, in reading order.
    pub fn all<'a>(&'a self, role: &str, found: &mut Vec<&'a Self>) {
        if self.role == role {
            found.push(self);
        }
        self.children.iter().for_each(|child| child.all(role, found));
    }

    pub fn find(&self, role: &str) -> Vec<&Self> {
        let mut found = Vec::new();
        self.all(role, &mut found);
        found
    }

    /// Its text with that of what is in it; a picture is what its words say.
    pub fn said(&self) -> String {
        let inner = self.children.iter().map(Self::said);
        let own = self.alt.clone().unwrap_or_else(|| self.text.clone());
        [own].into_iter().chain(inner).filter(|text| !text.is_empty()).collect::<Vec<_>>().join(" ")
    }
}

impl Pdf {
    pub fn read(bytes: &[u8]) -> Self {
        assert!(bytes.starts_with(b"%PDF-1.7\n"), "{:?}", &bytes[..10]);
        let end = String::from_utf8_lossy(&bytes[bytes.len() - 40..]).into_owned();
        let start = end.split("startxref\n").nth(1).unwrap().lines().next().unwrap().parse().unwrap();
        let mut values = Values::new(bytes, start);
        assert_eq!(values.next(), Some(Value::Word("xref".to_owned())));
        let mut offsets = Vec::new();
        while let Some(first) = values.next().unwrap().whole() {
            let count = values.next().unwrap().whole().unwrap();
            for number in first..first + count {
                let offset = values.next().unwrap().whole().unwrap();
                values.next();
                if values.next().unwrap().name() == "n" {
                    offsets.push((number, offset));
                }
            }
        }
        let trailer = values.next().unwrap();
        let Some(Value::Reference(root)) = trailer.get("Root") else { panic!("no root: {trailer:?}") };
        let objects = offsets.into_iter().map(|(number, offset)| (number, object(bytes, number, offset)));
        Self { objects: objects.collect(), root: *root }
    }

    /// What a value refers to.
    pub fn of<'a>(&'a self, value: &'a Value) -> &'a Value {
        match value {
            Value::Reference(number) => &self.objects[number].value,
            _ => value,
        }
    }

    fn stream(&self, value: &Value) -> &[u8] {
        let Value::Reference(number) = value else { panic!("no stream: {value:?}") };
        &self.objects[number].stream
    }

    pub fn root(&self) -> &Value {
        &self.objects[&self.root].value
    }

    /// Every value of every object, as text: what a file must not have is not in it.
    pub fn keys(&self) -> String {
        let mut all = String::new();
        for object in self.objects.values() {
            write!(all, "{:?}", object.value).unwrap();
        }
        all
    }

    pub fn metadata(&self) -> String {
        String::from_utf8(self.stream(self.root().get("Metadata").unwrap()).to_vec()).unwrap()
    }

    /// The pages, by the numbers of their objects.
    pub fn pages(&self) -> Vec<usize> {
        let mut pages = Vec::new();
        self.page_numbers(self.root().get("Pages").unwrap(), &mut pages);
        pages
    }

    fn page_numbers(&self, node: &Value, pages: &mut Vec<usize>) {
        let Value::Reference(number) = node else { panic!("{node:?}") };
        match self.of(node).get("Kids") {
            Some(kids) => self.of(kids).items().iter().for_each(|kid| self.page_numbers(kid, pages)),
            None => pages.push(*number),
        }
    }

    pub fn page(&self, number: usize) -> &Value {
        &self.objects[&number].value
    }

    /// The texts of a page by the numbers of their pieces; what belongs to none is under `None`.
    fn pieces(&self, page: usize) -> BTreeMap<Option<usize>, String> {
        let page = self.page(page);
        let fonts = self.fonts(page);
        let mut values = Values::new(self.stream(page.get("Contents").unwrap()), 0);
        let mut operands: Vec<Value> = Vec::new();
        let mut font = String::new();
        let mut open: Vec<(Option<usize>, Option<String>)> = Vec::new();
        let mut texts: BTreeMap<Option<usize>, String> = BTreeMap::new();
        while let Some(value) = values.next() {
            let Value::Word(word) = &value else {
                operands.push(value);
                continue;
            };
            let now = open.iter().rev().find_map(|(piece, _)| *piece);
            let is_replaced = open.iter().any(|(_, actual)| actual.is_some());
            match word.as_str() {
                "Tf" => operands[0].name().clone_into(&mut font),
                "TJ" | "Tj" if !is_replaced => {
                    let codes = operands[0].items().iter().filter_map(|item| match item {
                        Value::Text(bytes) => Some(bytes.chunks(2)),
                        _ => None,
                    });
                    let text = texts.entry(now).or_default();
                    for code in codes.flatten() {
                        text.push_str(&fonts[&font][&u16::from_be_bytes([code[0], code[1]])]);
                    }
                }
                "BMC" => open.push((None, None)),
                "BDC" => {
                    let actual = operands[1].get("ActualText").map(Value::text);
                    if let Some(actual) = &actual {
                        texts.entry(now).or_default().push_str(actual);
                    }
                    open.push((operands[1].get("MCID").and_then(Value::whole), actual));
                }
                "EMC" => {
                    // A line of what belongs to no element.
                    if let Some((None, None)) = open.pop() {
                        texts.entry(None).or_default().push('\n');
                    }
                }
                "ET" if now.is_none() => texts.entry(None).or_default().push('\n'),
                _ => {}
            }
            operands.clear();
        }
        assert!(open.is_empty());
        texts
    }

    /// Everything that a page says, what belongs to no element last.
    pub fn text(&self, page: usize) -> String {
        let mut pieces = self.pieces(page);
        let rest = pieces.remove(&None).unwrap_or_default();
        let said: Vec<String> = pieces.into_values().chain([rest]).collect();
        said.join("\n")
    }

    /// The signs of the fonts of a page.
    fn fonts(&self, page: &Value) -> BTreeMap<String, BTreeMap<u16, String>> {
        let resources = self.of(page.get("Resources").unwrap());
        let Some(Value::Dictionary(fonts)) = resources.get("Font").map(|fonts| self.of(fonts)) else {
            return BTreeMap::new();
        };
        let signs = |(name, font): (&String, &Value)| {
            let font = self.of(font);
            let descendant = self.of(&self.of(font.get("DescendantFonts").unwrap()).items()[0]);
            let descriptor = self.of(descendant.get("FontDescriptor").unwrap());
            assert!(descriptor.get("FontFile2").is_some(), "a font is not in the file: {descriptor:?}");
            (name.clone(), unicode(self.stream(font.get("ToUnicode").unwrap())))
        };
        fonts.iter().map(signs).collect()
    }

    /// The logical structure, with its texts.
    pub fn structure(&self) -> Element {
        let tree = self.of(self.root().get("StructTreeRoot").unwrap());
        let pieces: BTreeMap<usize, BTreeMap<Option<usize>, String>> =
            self.pages().into_iter().map(|page| (page, self.pieces(page))).collect();
        let mut root = Element::default();
        for kid in self.of(tree.get("K").unwrap()).items() {
            root.children.push(self.element(kid, &pieces));
        }
        root
    }

    fn element(&self, value: &Value, pieces: &BTreeMap<usize, BTreeMap<Option<usize>, String>>) -> Element {
        let value = self.of(value);
        let mut element = Element {
            role: value.get("S").unwrap().name().to_owned(),
            alt: value.get("Alt").map(Value::text),
            ..Element::default()
        };
        for attributes in value.get("A").map_or(&[][..], Value::items) {
            if let Some(scope) = attributes.get("Scope") {
                scope.name().clone_into(&mut element.scope);
            }
        }
        let page = |value: &Value| match value.get("Pg") {
            Some(Value::Reference(page)) => Some(*page),
            _ => None,
        };
        for kid in value.get("K").map_or(&[][..], Value::items) {
            let (page, piece) = match (kid, self.of(kid)) {
                (Value::Number(_), piece) => (page(value), piece.whole()),
                (_, kid) if kid.get("MCID").is_some() => {
                    (page(kid).or_else(|| page(value)), kid.get("MCID").and_then(Value::whole))
                }
                _ => {
                    element.children.push(self.element(kid, pieces));
                    continue;
                }
            };
            // A piece without a text, such as a picture, has none.
            let text = pieces[&page.unwrap()].get(&piece);
            element.text.push_str(text.map_or("", String::as_str));
        }
        element
    }

    /// The attachments: name, relationship, bytes.
    pub fn attachments(&self) -> Vec<(String, String, Vec<u8>)> {
        let files = self.of(self.root().get("AF").unwrap());
        let file = |value: &Value| {
            let value = self.of(value);
            let stream = self.of(value.get("EF").unwrap()).get("F").unwrap();
            let relation = value.get("AFRelationship").unwrap().name().to_owned();
            (value.get("UF").unwrap().text(), relation, self.stream(stream).to_vec())
        };
        files.items().iter().map(file).collect()
    }
}

/// The object at a place of the file.
fn object(bytes: &[u8], number: usize, offset: usize) -> Object {
    let mut values = Values::new(bytes, offset);
    assert_eq!(values.next().unwrap().whole(), Some(number));
    values.next();
    assert_eq!(values.next().unwrap().name(), "obj");
    let value = values.next().unwrap();
    let mut stream = Vec::new();
    if values.next().unwrap().name() == "stream" {
        let length = value.get("Length").unwrap().whole().unwrap();
        let start = values.at + if bytes[values.at] == b'\r' { 2 } else { 1 };
        let packed = &bytes[start..start + length];
        let filters: Vec<&str> = value.get("Filter").map_or(&[][..], Value::items).iter().map(Value::name).collect();
        match filters.as_slice() {
            [] | ["DCTDecode"] => packed.clone_into(&mut stream),
            ["FlateDecode"] => {
                flate2::read::ZlibDecoder::new(packed).read_to_end(&mut stream).unwrap();
            }
            _ => panic!("a filter that is not read: {filters:?}"),
        }
    }
    Object { value, stream }
}

/// The signs of the codes of a font (`beginbfchar`, `beginbfrange`).
fn unicode(map: &[u8]) -> BTreeMap<u16, String> {
    let mut values = Values::new(map, 0);
    let mut operands: Vec<Value> = Vec::new();
    let mut signs = BTreeMap::new();
    let wide = |value: &Value| match value {
        Value::Text(bytes) => bytes.chunks(2).map(|two| u16::from_be_bytes([two[0], two[1]])).collect::<Vec<_>>(),
        _ => panic!("{value:?}"),
    };
    while let Some(value) = values.next() {
        let Value::Word(word) = &value else {
            operands.push(value);
            continue;
        };
        match word.as_str() {
            "endbfchar" => {
                for pair in operands.chunks(2) {
                    signs.insert(wide(&pair[0])[0], String::from_utf16(&wide(&pair[1])).unwrap());
                }
            }
            "endbfrange" => panic!("a range of signs is not read"),
            _ => {}
        }
        operands.clear();
    }
    signs
}
