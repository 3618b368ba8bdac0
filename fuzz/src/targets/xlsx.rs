//! Any bytes as a workbook, and any text as its sheet: every row is a record, set aside or an error, and none is lost or makes a panic.
//! A sheet in a ZIP file is stored without packing, so that what changes reaches the reader of cells.

use fitcheck::exchange::{Imported, import, sheet_rows};

use super::shared::{NOW, OWN_SOURCES, told};

/// The members of a workbook besides its sheet.
const MEMBERS: [(&str, &str); 4] = [
    (
        "_rels/.rels",
        r#"<Relationships><Relationship Id="a" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/officeDocument" Target="xl/workbook.xml"/></Relationships>"#,
    ),
    ("xl/workbook.xml", r#"<workbook><sheets><sheet name="S" sheetId="1" r:id="a"/></sheets></workbook>"#),
    (
        "xl/_rels/workbook.xml.rels",
        r#"<Relationships><Relationship Id="a" Type="http://schemas.openxmlformats.org/officeDocument/2006/relationships/worksheet" Target="worksheets/sheet1.xml"/></Relationships>"#,
    ),
    // Cells with s="1" to s="4" show a unit or a percent sign.
    (
        "xl/styles.xml",
        r#"<styleSheet><numFmts><numFmt numFmtId="164" formatCode="0.000&quot; mm&quot;"/><numFmt numFmtId="165" formatCode="0.0&quot; µm&quot;"/><numFmt numFmtId="166" formatCode="0.0000\&quot;"/></numFmts><cellXfs><xf numFmtId="0"/><xf numFmtId="164"/><xf numFmtId="165"/><xf numFmtId="166"/><xf numFmtId="10"/></cellXfs></styleSheet>"#,
    ),
];

pub fn run(bytes: &[u8]) {
    if bytes.starts_with(b"PK") {
        return check(bytes);
    }
    let mut members: Vec<(&str, &[u8])> = MEMBERS.iter().map(|(name, text)| (*name, text.as_bytes())).collect();
    members.push(("xl/worksheets/sheet1.xml", bytes));
    check(&stored(&members));
}

fn check(bytes: &[u8]) {
    let Imported { records, unjudged, errors, warnings, rows, .. } = import("a.xlsx", bytes, &OWN_SOURCES, NOW);
    assert_eq!(rows, records.len() + unjudged.len() + errors.len());
    errors.iter().take(9).for_each(|error| told(bytes, error));
    warnings.iter().take(9).for_each(|warning| told(bytes, warning));
    let _either = sheet_rows(bytes);
}

/// A ZIP file whose members are not packed.
fn stored(members: &[(&str, &[u8])]) -> Vec<u8> {
    let (mut file, mut list) = (Vec::new(), Vec::new());
    for (name, content) in members {
        let at = u32::try_from(file.len()).expect("small");
        let size = u32::try_from(content.len()).expect("small");
        let long = u16::try_from(name.len()).expect("short");
        let sum = checksum(content).to_le_bytes();
        let sizes = [[0; 4], sum, size.to_le_bytes(), size.to_le_bytes()].concat();
        file.extend(
            [b"PK\x03\x04\x14\0\0\0\0\0".as_slice(), &sizes, &long.to_le_bytes(), &[0; 2], name.as_bytes(), content]
                .concat(),
        );
        list.extend(
            [
                b"PK\x01\x02\x14\0\x14\0\0\0\0\0".as_slice(),
                &sizes,
                &long.to_le_bytes(),
                &[0; 12],
                &at.to_le_bytes(),
                name.as_bytes(),
            ]
            .concat(),
        );
    }
    let (at, size) = (u32::try_from(file.len()).expect("small"), u32::try_from(list.len()).expect("small"));
    let count = u16::try_from(members.len()).expect("few").to_le_bytes();
    file.extend(list);
    file.extend(
        [b"PK\x05\x06\0\0\0\0".as_slice(), &count, &count, &size.to_le_bytes(), &at.to_le_bytes(), &[0; 2]].concat(),
    );
    file
}

/// The checksum of ZIP files, CRC-32.
fn checksum(content: &[u8]) -> u32 {
    let step = |sum: u32, _bit| if sum & 1 == 1 { sum >> 1 ^ 0xedb8_8320 } else { sum >> 1 };
    !content.iter().fold(u32::MAX, |sum, &byte| (0..8).fold(sum ^ u32::from(byte), step))
}
