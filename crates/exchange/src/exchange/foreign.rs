//! Files that are known by their first bytes and hold no measured values that are read here: they are named, with what to do.

use super::error::ImportErrorKind;
use super::source::Beginning;

/// What a file is.
#[derive(Clone, Copy)]
enum Kind {
    Model,
    Drawing,
    Document,
    Image,
    Archive,
}

/// Beginnings of files, and what they are of.
const BEGINNINGS: [(&[u8], Kind, &str); 27] = [
    (b"ISO-10303-21", Kind::Model, "STEP"),
    (b"**ABCDEFGHIJKLMNOPQRSTUVWXYZ", Kind::Model, "Parasolid"),
    (b"DBA ", Kind::Model, "ACIS"),
    (b"glTF", Kind::Model, "glTF"),
    (b"AC10", Kind::Drawing, "DWG"),
    (b"AutoCAD Binary DXF", Kind::Drawing, "DXF"),
    (b"%PDF-", Kind::Document, "PDF"),
    (b"%!PS", Kind::Document, "PostScript"),
    (b"{\\rtf", Kind::Document, "RTF"),
    (b"<!DOCTYPE html", Kind::Document, "HTML"),
    (b"<!doctype html", Kind::Document, "HTML"),
    (b"<html", Kind::Document, "HTML"),
    (b"\x89PNG\r\n", Kind::Image, "PNG"),
    (b"\xff\xd8\xff", Kind::Image, "JPEG"),
    (b"GIF87a", Kind::Image, "GIF"),
    (b"GIF89a", Kind::Image, "GIF"),
    (b"II*\0", Kind::Image, "TIFF"),
    (b"MM\0*", Kind::Image, "TIFF"),
    (b"RIFF", Kind::Image, "WebP"),
    (b"<svg", Kind::Image, "SVG"),
    (b"7z\xbc\xaf\x27\x1c", Kind::Archive, "7z"),
    (b"Rar!\x1a\x07", Kind::Archive, "RAR"),
    (b"\x1f\x8b", Kind::Archive, "gzip"),
    (b"BZh", Kind::Archive, "bzip2"),
    (b"\xfd7zXZ\0", Kind::Archive, "xz"),
    (b"\x28\xb5\x2f\xfd", Kind::Archive, "zstd"),
    (b"MSCF", Kind::Archive, "CAB"),
];

/// Why a file is not read, where it is of a kind that is known; it has passed the formats that say by their content what they are.
pub(super) fn known(beginning: &Beginning<'_>) -> Option<ImportErrorKind> {
    let bytes = beginning.bytes;
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let by_bytes = BEGINNINGS.iter().find(|(begin, ..)| bytes.starts_with(begin)).map(|(_, kind, name)| (*kind, *name));
    let (kind, format) = by_bytes.or_else(|| by_text(beginning))?;
    Some(match kind {
        Kind::Model => ImportErrorKind::ModelNotRead { format },
        Kind::Drawing => ImportErrorKind::DrawingNotRead { format },
        Kind::Document => ImportErrorKind::DocumentNotRead { format },
        Kind::Image => ImportErrorKind::ImageNotRead { format },
        Kind::Archive => ImportErrorKind::ArchiveNotRead { format },
    })
}

/// Kinds that only the lines of a text show.
fn by_text(beginning: &Beginning<'_>) -> Option<(Kind, &'static str)> {
    let text = beginning.text();
    let mut lines = text.lines().map(str::trim_end).filter(|line| !line.trim().is_empty());
    let first = lines.next()?;
    let second = lines.next()?.trim();
    // A comment of a DXF begins with the group 999.
    if first.trim() == "0" && second == "SECTION" || first.trim() == "999" && text.contains("SECTION") {
        return Some((Kind::Drawing, "DXF"));
    }
    if first.starts_with("solid") && (second.starts_with("facet normal") || second.starts_with("endsolid")) {
        return Some((Kind::Model, "STL"));
    }
    // Each line of an IGES file has the letter of its section and a number in the last eight columns.
    let is_numbered = |line: &str| {
        let end = fitcheck_core::text::behind(line, 72);
        line.len() == 80
            && end.starts_with('S')
            && end.trim_start_matches('S').trim().bytes().all(|byte| byte.is_ascii_digit())
    };
    is_numbered(first).then_some((Kind::Model, "IGES"))
}
