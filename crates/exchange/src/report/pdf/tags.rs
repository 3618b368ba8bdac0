//! The logical structure of the pages, for programs that read them aloud: sections, headings, paragraphs, and tables with their heads.

use std::num::NonZeroU16;

use krilla::geom::Rect;
use krilla::tagging::{BBox, Identifier, Node, TableHeaderScope, Tag, TagGroup, TagKind, TagTree};

/// An element of the structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct TagId(usize);

/// What an element is.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Kind {
    Section,
    /// With its level, from 1.
    Heading(u16, String),
    Paragraph,
    Table,
    TableHead,
    TableBody,
    Row,
    /// The head of a column.
    ColumnHead,
    /// The head of a row.
    RowHead,
    Cell,
    /// With what it shows, in words; and where it is: page, left, top, width, height.
    Figure(String, Option<(usize, [f32; 4])>),
}

enum Child {
    Element(TagId),
    /// A piece of a page, by its number.
    Piece(usize),
}

struct Element {
    kind: Kind,
    children: Vec<Child>,
}

/// The elements, the first of which is the root.
pub(super) struct Tags {
    elements: Vec<Element>,
    pieces: usize,
}

impl Tags {
    pub fn new() -> Self {
        Self { elements: vec![Element { kind: Kind::Section, children: Vec::new() }], pieces: 0 }
    }

    pub const ROOT: TagId = TagId(0);

    /// Adds an element behind those that its parent has.
    pub fn add(&mut self, parent: TagId, kind: Kind) -> TagId {
        let id = TagId(self.elements.len());
        self.elements.push(Element { kind, children: Vec::new() });
        if let Some(parent) = self.elements.get_mut(parent.0) {
            parent.children.push(Child::Element(id));
        }
        id
    }

    /// Adds a piece of a page to an element, and gives the piece's number.
    pub fn piece(&mut self, of: TagId) -> usize {
        let number = self.pieces;
        self.pieces += 1;
        if let Some(element) = self.elements.get_mut(of.0) {
            element.children.push(Child::Piece(number));
        }
        number
    }

    /// The structure, with what the pieces are called on their pages.
    pub fn tree(&self, pieces: &[Identifier]) -> TagTree {
        let children = self.elements.first().map_or_else(Vec::new, |root| self.children(root, pieces));
        TagTree::from(vec![Node::from(TagGroup::with_children(Tag::Section, children))])
    }

    fn children(&self, element: &Element, pieces: &[Identifier]) -> Vec<Node> {
        let node = |child: &Child| match child {
            Child::Piece(number) => pieces.get(*number).map(|piece| Node::from(*piece)),
            Child::Element(id) => self.elements.get(id.0).map(|element| {
                let children = self.children(element, pieces);
                Node::from(TagGroup::with_children(kind(&element.kind), children))
            }),
        };
        element.children.iter().filter_map(node).collect()
    }
}

fn kind(kind: &Kind) -> TagKind {
    match kind {
        Kind::Section => Tag::Section.into(),
        Kind::Heading(level, title) => {
            let level = NonZeroU16::new(*level).unwrap_or(NonZeroU16::MIN);
            Tag::Hn(level, Some(title.clone())).into()
        }
        Kind::Paragraph => Tag::P.into(),
        Kind::Table => Tag::Table.into(),
        Kind::TableHead => Tag::THead.into(),
        Kind::TableBody => Tag::TBody.into(),
        Kind::Row => Tag::TR.into(),
        Kind::ColumnHead => Tag::TH(TableHeaderScope::Column).into(),
        Kind::RowHead => Tag::TH(TableHeaderScope::Row).into(),
        Kind::Cell => Tag::TD.into(),
        Kind::Figure(said, place) => {
            let place = place
                .and_then(|(page, [x, y, width, height])| Some(BBox::new(page, Rect::from_xywh(x, y, width, height)?)));
            Tag::Figure(Some(said.clone())).with_bbox(place).into()
        }
    }
}
