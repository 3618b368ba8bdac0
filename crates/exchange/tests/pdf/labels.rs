//! Labels as pictures: the same label as in the PDF, in dots.

use fitcheck_core::words::{Language, Words};
use fitcheck_exchange::report::paper::Paper;
use fitcheck_exchange::report::template::Template;
use fitcheck_exchange::report::{Report, png};

use super::made::{of_part, part, record, rendered, report as report_of, simulated, whole};
use super::templates::in_journal;

fn label(report: Report, paper: Paper) -> Report {
    let template = Template::shipped().iter().find(|template| template.word() == "label").unwrap();
    Report { paper, ..report.by(template) }
}

/// Width, height, and the dots from black to white.
fn read(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = ::png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
    let fineness = reader.info().pixel_dims.unwrap();
    assert_eq!((fineness.xppu, fineness.yppu), (11_811, 11_811), "300 dots an inch");
    let mut dots = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut dots).unwrap();
    (info.width, info.height, dots)
}

#[test]
fn a_label_is_a_picture_of_its_size_and_the_same_every_time() {
    for (paper, size) in [(Paper::SmallLabel, (732, 343)), (Paper::LargeLabel, (1_181, 591))] {
        let report = label(in_journal(of_part(part(&whole()), &whole())), paper);
        let bytes = rendered(&report, "de", "png");
        assert_eq!(bytes, rendered(&report, "de", "png"));
        let (width, height, dots) = read(&bytes);
        assert_eq!((width, height), size);
        let dark = dots.iter().filter(|dot| **dot < 128).count();
        assert!(dots.len() / 20 < dark && dark < dots.len() / 2, "{dark} of {}", dots.len());
        assert!(dots.first() == Some(&255) && dots.last() == Some(&255), "the corners are free");
    }
}

/// The code stands on the right: its left upper eye is seven squares of black, five of white, three of black (ISO/IEC 18004).
#[test]
fn the_code_of_the_record_has_edges_that_a_scanner_finds() {
    let report = label(in_journal(of_part(part(&whole()), &whole())), Paper::LargeLabel);
    let (width, _, dots) = read(&rendered(&report, "en", "png"));
    let rows: Vec<&[u8]> = dots.chunks(usize::try_from(width).unwrap()).collect();
    let right = |row: &[u8]| row[row.len() - 590..].to_vec();
    assert!(rows.iter().all(|row| right(row).iter().all(|dot| *dot < 60 || 250 < *dot)), "no grey in a code");
    let top = rows.iter().copied().map(right).find(|row| row.iter().any(|dot| *dot < 60)).unwrap();
    let from = top.iter().position(|dot| *dot < 60).unwrap();
    let eye = top[from..].iter().take_while(|dot| **dot < 60).count();
    assert!((50..110).contains(&eye), "{eye}");
}

#[test]
fn what_nobody_measured_has_a_dashed_frame() {
    let edge = |report: Report| {
        let (width, _, dots) = read(&rendered(&label(report, Paper::SmallLabel), "en", "png"));
        let width = usize::try_from(width).unwrap();
        // Two points from the upper edge.
        let row = &dots[8 * width..9 * width];
        row.windows(2).filter(|two| two[0] < 128 && 128 <= two[1]).count()
    };
    assert_eq!(edge(report_of(vec![record("A", "25 H7", "25.012")])), 0);
    assert!(20 < edge(report_of(vec![simulated("A", "25 H7", "25.012")])));
}

#[test]
fn what_has_no_room_on_a_label_is_seen_to_be_missing() {
    let said = |notes: usize| {
        let report = label(report_of(vec![record("A", "25 H7", "25.012")]), Paper::SmallLabel);
        let notes = (0..notes).map(|_| fitcheck_core::message::message!("report-total")).collect();
        let pdf = super::made::pdf(&Report { notes, ..report }, "en");
        pdf.text(pdf.pages()[0])
    };
    assert!(!said(3).contains('…') && said(3).matches("Total").count() == 3, "{}", said(3));
    assert!(said(8).contains('…'), "{}", said(8));
}

#[test]
fn a_page_is_refused_in_words() {
    let report = of_part(part(&whole()), &whole());
    let words = Words::new(Language::all().next().unwrap());
    let why = png::RENDERING.bytes(&report, &words).unwrap_err().to_string();
    assert!(why.contains("PNG is for labels: choose the template label"), "{why}");
    assert!(png::RENDERING.refusal(Paper::A4).is_some() && png::RENDERING.refusal(Paper::SmallLabel).is_none());
}
