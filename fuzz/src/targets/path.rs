//! A text as a path of a program: no part of it leads up, away or to a device, and it is the same from anywhere.

use fitcheck::nc::machine::NcPath;

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let main = NcPath::new(r"TNC:\fit\main.h").expect("a path");
    for path in [NcPath::new(text), main.resolve(text), Ok(NcPath::of_file(text))] {
        match path {
            Ok(path) => stays_inside(&path, &main),
            Err(error) => told(bytes, &error),
        }
    }
}

fn stays_inside(path: &NcPath, main: &NcPath) {
    let whole = path.to_string();
    assert_eq!(NcPath::new(&whole).as_ref(), Ok(path));
    assert_eq!(main.resolve(&whole).as_ref(), Ok(path));
    assert_eq!(Some(path.file_name()), path.parts().next_back());
    for part in path.parts() {
        assert!(!part.is_empty() && part != "." && part != "..", "{whole}");
        assert!(
            !part.contains(['/', '\\', ':', '*', '?', '"', '<', '>', '|']) && !part.contains(char::is_control),
            "{whole}"
        );
        assert!(!part.ends_with(['.', ' ']), "{whole}");
    }
}
