//! The values of a column as a packed page.
//!
//! A column of a row group is one page, with a page of words before it where it has few different ones. Both are encoded here
//! and not by the `parquet` crate, which wants a counted reference for each text of each row.

use std::io;

use bytes::Bytes;
use parquet::basic::{Compression, Encoding, Type, ZstdLevel};
use parquet::column::page::{CompressedPage, Page, PageWriter as _};
use parquet::column::writer::ColumnCloseResult;
use parquet::errors::ParquetError;
use parquet::file::metadata::ColumnChunkMetaData;
use parquet::file::statistics::Statistics;
use parquet::file::writer::{SerializedPageWriter, TrackedWrite};
use parquet::schema::types::ColumnDescPtr;

use super::delta::put_varint;
use fitcheck_core::text::long;

/// The column of a row group, ready to be written.
#[derive(Debug)]
pub(super) struct Chunk {
    pub(super) bytes: Bytes,
    pub(super) close: ColumnCloseResult,
}

/// The values of a page.
#[derive(Debug, Clone, Copy)]
pub(super) enum Body<'a> {
    /// As the format's plain encoding has them.
    Plain(&'a [u8]),
    /// As packed differences.
    Delta(&'a [u8]),
    /// Words, in the plain encoding, and for each value the number of its word.
    Words(&'a [u8], u32, &'a [u8]),
}

/// Packs pages.
pub(super) struct Packer {
    zstd: zstd::bulk::Compressor<'static>,
}

impl Packer {
    /// Zstandard at level 1.
    pub(super) fn new() -> io::Result<Self> {
        Ok(Self { zstd: zstd::bulk::Compressor::new(LEVEL)? })
    }

    /// A column with so many rows. `levels` say which of them have a value, 1 or 0; nothing where the column has no gaps.
    pub(super) fn chunk(
        &mut self,
        column: &ColumnDescPtr,
        rows: usize,
        levels: &[i16],
        body: Body<'_>,
        statistics: Option<Statistics>,
    ) -> Result<Chunk, ParquetError> {
        let mut out = TrackedWrite::new(Vec::new());
        let mut pages = SerializedPageWriter::new(&mut out);
        let mut unpacked = 0;
        let mut packed = 0;
        // Numbers in all their bits, packed differences and numbers of words hardly get smaller; texts do.
        let is_packed = matches!(body, Body::Plain(_)) && column.physical_type() == Type::BYTE_ARRAY;
        let num_values = u32::try_from(rows).map_err(too_large)?;
        let mut dictionary_page = None;
        let mut data_page = 0;
        if let Body::Words(words, count, _) = body {
            let buf = words.to_vec().into();
            let page = Page::DictionaryPage { buf, num_values: count, encoding: Encoding::PLAIN, is_sorted: false };
            let spec = pages.write_page(CompressedPage::new(page, words.len()))?;
            unpacked += spec.uncompressed_size;
            packed += spec.compressed_size;
            dictionary_page = Some(0);
            data_page = i64::try_from(spec.bytes_written).map_err(too_large)?;
        }
        let mut text = Vec::new();
        if 0 < column.max_def_level() {
            text.extend_from_slice(&[0; 4]);
            put_bits(levels.iter().map(|level| u8::from(*level != 0)), levels.len(), 1, &mut text);
            let length = u32::try_from(text.len() - 4).map_err(too_large)?;
            if let Some((place, _)) = text.split_first_chunk_mut() {
                *place = length.to_le_bytes();
            }
        }
        let encoding = match body {
            Body::Plain(values) => {
                text.extend_from_slice(values);
                Encoding::PLAIN
            }
            Body::Delta(values) => {
                text.extend_from_slice(values);
                Encoding::DELTA_BINARY_PACKED
            }
            Body::Words(_, count, numbers) => {
                let width = (u32::BITS - count.saturating_sub(1).leading_zeros()).max(1);
                let width = u8::try_from(width).map_err(too_large)?;
                text.push(width);
                put_bits(numbers.iter().copied(), numbers.len(), width.into(), &mut text);
                Encoding::RLE_DICTIONARY
            }
        };
        let size = text.len();
        let page = Page::DataPage {
            buf: if is_packed { self.pack(&text)? } else { text.into() },
            num_values,
            encoding,
            def_level_encoding: Encoding::RLE,
            rep_level_encoding: Encoding::RLE,
            statistics: None,
        };
        let spec = pages.write_page(CompressedPage::new(page, size))?;
        unpacked += spec.uncompressed_size;
        packed += spec.compressed_size;
        let number = |size: usize| i64::try_from(size).map_err(too_large);
        let mut metadata = ColumnChunkMetaData::builder(std::sync::Arc::clone(column))
            .set_compression(if is_packed {
                Compression::ZSTD(ZstdLevel::try_new(LEVEL)?)
            } else {
                Compression::UNCOMPRESSED
            })
            .set_encodings(vec![Encoding::PLAIN, Encoding::RLE, encoding])
            .set_num_values(number(rows)?)
            .set_total_uncompressed_size(number(unpacked)?)
            .set_total_compressed_size(number(packed)?)
            .set_dictionary_page_offset(dictionary_page)
            .set_data_page_offset(data_page);
        if let Some(statistics) = statistics {
            metadata = metadata.set_statistics(statistics);
        }
        let close = ColumnCloseResult {
            bytes_written: u64::try_from(packed).map_err(too_large)?,
            rows_written: num_values.into(),
            metadata: metadata.build()?,
            bloom_filter: None,
            column_index: None,
            offset_index: None,
        };
        Ok(Chunk { bytes: out.into_inner()?.into(), close })
    }

    fn pack(&mut self, text: &[u8]) -> Result<Bytes, ParquetError> {
        // Sizes of pages have 31 bits.
        i32::try_from(text.len()).map_err(too_large)?;
        Ok(self.zstd.compress(text)?.into())
    }
}

/// Half the size that Snappy gives, for a third more time.
const LEVEL: i32 = 1;

fn too_large(error: std::num::TryFromIntError) -> ParquetError {
    ParquetError::General(format!("a row group of more than 2 GB in one column: {error}"))
}

/// Numbers of a few bits: as one run where all are the same, else each in its bits, the lowest first (the format's hybrid
/// of run lengths and packed bits).
fn put_bits(mut numbers: impl Iterator<Item = u8> + Clone, count: usize, width: u32, out: &mut Vec<u8>) {
    /// Fills the last group of eight.
    const PADDING: u8 = 0;
    let mut all = numbers.clone();
    // Of no numbers there is a run of length 0.
    let first = all.next().unwrap_or(0);
    if all.all(|number| number == first) {
        put_varint(long(count << 1), out);
        out.push(first);
        return;
    }
    put_varint(long(count.div_ceil(8) << 1 | 1), out);
    for _ in 0..count.div_ceil(8) {
        // Eight numbers of at most eight bits fit.
        let mut group = 0_u64;
        for at in 0..8 {
            group |= u64::from(numbers.next().unwrap_or(PADDING)) << (at * width);
        }
        out.extend(group.to_le_bytes().into_iter().zip(0..width).map(|(byte, _)| byte));
    }
}
