//! Files of contacts: every sensible layout, and what is refused with its place.

use fitcheck::exchange::contacts::read;

#[track_caller]
fn check(csv: &[u8], expected: &str) {
    let said = match read(csv) {
        Ok(read) => {
            let points: Vec<String> = read.contacts.iter().map(|c| format!("({}, {}, {})", c.x, c.y, c.z)).collect();
            format!("{} ignored {:?}", points.join(" "), read.ignored)
        }
        Err(error) => error.to_string(),
    };
    assert_eq!(said, expected);
}

#[test]
fn reads_every_sensible_layout() {
    check(b"x,y\n1.5,2\n3,4\n", "(1.5, 2, 0) (3, 4, 0) ignored []");
    check(b"\xef\xbb\xbfY;X;Z\r\n2;1,5;-5\r\n", "(1.5, 2, -5) ignored []");
    check(b"1.5\t2\n3\t4\n", "(1.5, 2, 0) (3, 4, 0) ignored []");
    check(b"# bore 7\nx [mm],y [mm],remark\n1,2,good\n\n", "(1, 2, 0) ignored [\"remark\"]");
    check(b"+1e1,-2.5E-3,0\n", "(10, -0.0025, 0) ignored []");
}

#[test]
fn refuses_with_line_and_column() {
    check(b"", "the file holds no contacts");
    check(b"x,y\n", "the file holds no contacts");
    check(b"x,q\n1,2\n", "line 1: the header must name x and y, and may name z; it is x, q");
    check(b"x,y\n1,2\n1\n", "line 3: expected 2 cells, found 1: 1");
    check(b"x,y\n1;2\n", "line 2: expected 2 cells, found 1: 1;2");
    check(b"x,y\n1,2\n1,abc\n", "line 3, column 2: y is abc, not a number of millimetres");
    check(b"x,y\n1,nan\n", "line 2, column 2: y is nan, not a number of millimetres");
    check(b"x,y\n1,\n", "line 2, column 2: y is empty, not a number of millimetres");
    check(b"x;y\n1.234,5;2\n", "line 2, column 1: x is 1.234,5, not a number of millimetres");
    check(b"x;y\n1.5;2\n1;2,5\n", "line 3, column 2: 2,5 has a different decimal sign than the rows before it");
    check(b"x,y\n1,\"2\n3,4\n", "line 2: a quotation mark is not closed");
}

#[test]
fn columns_of_another_unit_or_another_kind_are_not_taken_for_millimetres() {
    let only = "the header must name x and y, and may name z; it is";
    check(b"x [inch],y [inch]\n1,2\n", &format!("line 1: {only} x [inch], y [inch]"));
    check(b"x_dev;y_dev\n1;2\n", &format!("line 1: {only} x_dev, y_dev"));
    check(b"x_nominal;y_nominal;x;y\n1;2;3;4\n", "(3, 4, 0) ignored [\"x_nominal\", \"y_nominal\"]");
    check(b"X (mm);y_mm;z mm\n1;2;3\n", "(1, 2, 3) ignored []");
    check(b"x;y;x [mm]\n1;2;3\n", "line 1: columns 1 and 3 are both x");
}

#[test]
fn no_bytes_make_the_reader_panic() {
    proptest::proptest!(|(bytes in proptest::collection::vec(proptest::prelude::any::<u8>(), 0..200))| {
        let _read = read(&bytes);
    });
}
