//! The pages become a file.

use std::io;
use std::sync::Arc;

use jiff::civil::DateTime;
use krilla::configure::{Accessibility, Archival, ConfigurationBuilder, ValidationError};
use krilla::destination::XyzDestination;
use krilla::embed::{AssociationKind, EmbeddedFile, MimeType};
use krilla::error::KrillaError;
use krilla::geom::Point;
use krilla::metadata::{DateTime as Stamp, Metadata};
use krilla::outline::{Outline, OutlineNode};
use krilla::page::PageSettings;
use krilla::tagging::{Artifact, ArtifactType, ContentTag, Identifier};
use krilla::{Document, SerializeSettings};

use super::attach::Attachments;
use super::brush::Brush;
use super::fonts::Fonts;
use super::head::MOST_NAME;
use super::pictures::Drawable;
use super::sheet::{Piece, Sheet};
use super::tags::Tags;
use crate::report::Report;

/// Everything that becomes a file.
pub(super) struct Book<'a> {
    pub fonts: &'a Fonts,
    pub size: [f32; 2],
    pub sheets: Vec<Sheet>,
    pub tags: Tags,
    pub pictures: Vec<Drawable>,
    /// The headings, with their pages and places.
    pub outline: Vec<(String, usize, f32)>,
    pub title: String,
    pub language: &'static str,
}

/// Why there is no file.
#[derive(Debug)]
pub(super) enum EmitError {
    /// A picture cannot be read to its end, or has colours that a file to be kept must not have.
    Picture(String),
    /// The checks cannot be read, or the writer has failed.
    Other(io::Error),
}

impl From<io::Error> for EmitError {
    fn from(error: io::Error) -> Self {
        Self::Other(error)
    }
}

impl From<EmitError> for io::Error {
    fn from(error: EmitError) -> Self {
        match error {
            EmitError::Picture(why) => Self::other(why),
            EmitError::Other(error) => error,
        }
    }
}

impl From<KrillaError> for EmitError {
    fn from(error: KrillaError) -> Self {
        match &error {
            KrillaError::Image(.., why) => Self::Picture(why.clone()),
            KrillaError::Validation(all)
                if all.iter().all(|(what, _)| matches!(what, ValidationError::MissingCMYKProfile)) =>
            {
                Self::Picture("CMYK".to_owned())
            }
            // The writer only counts them.
            KrillaError::Validation(all) => {
                Self::Other(io::Error::other(format!("{:?}", all.first().map(|(what, _)| what))))
            }
            _ => Self::Other(io::Error::other(error.to_string())),
        }
    }
}

fn fault(what: &'static str) -> EmitError {
    EmitError::Other(io::Error::other(what))
}

/// Makes the file.
pub(super) fn bytes(book: Book<'_>, report: &Report, attachments: &Attachments) -> Result<Vec<u8>, EmitError> {
    let configuration = ConfigurationBuilder::new()
        .with_archival_validator(Archival::A3_A)
        .with_accessibility_validator(Accessibility::UA1)
        .finish()
        .map_err(|_two_standards| fault("PDF/A-3a and PDF/UA-1 do not go together"))?;
    let mut document = Document::new_with(SerializeSettings { configuration, ..SerializeSettings::default() });
    let [width, height] = book.size;
    let mut identifiers: Vec<Identifier> = Vec::new();
    let mut brush = Brush::new(book.fonts, &book.pictures);
    // A page is let go once it is drawn.
    for sheet in book.sheets {
        let settings = PageSettings::from_wh(width, height).ok_or_else(|| fault("a page without a size"))?;
        let mut page = document.start_page_with(settings);
        let mut surface = page.surface();
        let ends = sheet.pieces.iter().skip(1).map(|(start, _)| *start).chain([sheet.shapes.len()]);
        for ((start, piece), end) in sheet.pieces.iter().zip(ends) {
            let kind = match piece {
                Piece::Of(_) => ContentTag::Other,
                Piece::Layout => ContentTag::Artifact(Artifact::with_kind(ArtifactType::Layout)),
                Piece::Running => ContentTag::Artifact(Artifact::with_kind(ArtifactType::PaginationOther)),
            };
            let identifier = surface.start_tagged(kind);
            if matches!(piece, Piece::Of(_)) {
                // Pieces are numbered in the order of drawing.
                identifiers.push(identifier);
            }
            for shape in sheet.shapes.get(*start..end).unwrap_or_default() {
                brush.draw(&mut surface, shape);
            }
            surface.end_tagged();
        }
        surface.finish();
        page.finish();
    }
    document.set_tag_tree(book.tags.tree(&identifiers));
    document.set_outline(outline(&book.outline));
    document.set_metadata(metadata(&book.title, book.language, report, attachments));
    for file in &attachments.files {
        let embedded = EmbeddedFile {
            path: file.name.to_owned(),
            mime_type: MimeType::new(file.media),
            description: Some(short(&book.title)),
            association_kind: AssociationKind::Data,
            data: Arc::clone(&file.bytes).into(),
            modification_date: Some(stamp(report.created)),
            compress: Some(true),
            location: None,
        };
        document.embed_file(embedded).ok_or_else(|| fault("two attachments of one name"))?;
    }
    Ok(document.finish()?)
}

/// A text where it is not read, but listed.
fn short(text: &str) -> String {
    Fonts::clean(text).chars().take(MOST_NAME).collect()
}

fn outline(headings: &[(String, usize, f32)]) -> Outline {
    let mut outline = Outline::new();
    for (text, page, y) in headings {
        let place = XyzDestination::new(*page, Point::from_xy(0.0, *y));
        outline.push_child(OutlineNode::new(short(text), place));
    }
    outline
}

fn metadata(title: &str, language: &str, report: &Report, attachments: &Attachments) -> Metadata {
    let metadata = Metadata::new()
        .title(short(title))
        .language(language.to_owned())
        .creator(short(&report.program))
        .creation_date(stamp(report.created))
        // The same for the same data in the same language and on the same paper.
        .document_id(format!("{}-{}-{}", attachments.digest, language, report.paper.name()));
    match &report.inspector {
        Some(inspector) => metadata.authors(vec![short(inspector)]),
        None => metadata,
    }
}

fn stamp(time: DateTime) -> Stamp {
    let small = |number: i8| u8::try_from(number).unwrap_or(0);
    Stamp::new(u16::try_from(time.year()).unwrap_or(0))
        .month(small(time.month()))
        .day(small(time.day()))
        .hour(small(time.hour()))
        .minute(small(time.minute()))
        .second(small(time.second()))
}
