//! A text as a callout, a text of cycles 14xx or of QS400, or a class: what is printed reads back as the same, and an
//! error points into the text.

use fitcheck::probing::cycle::Value;
use fitcheck::tolerance::callout::{halves, qs400};
use fitcheck::tolerance::{Callout, CalloutError, CycleText, ToleranceClass};

use super::shared::told;

pub fn run(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let (size, rest) = halves(text);
    assert!(text.contains(size) && text.contains(rest));
    match text.parse::<Callout>() {
        Ok(callout) => assert_eq!(callout.to_string().parse(), Ok(callout)),
        Err(error) => points_into(bytes, text, &error),
    }
    match text.parse::<CycleText>() {
        Ok(read) => assert_eq!(read.to_string().parse(), Ok(read)),
        Err(error) => points_into(bytes, text, &error),
    }
    match qs400(text) {
        Ok(band) => assert_eq!(qs400(&Value::Band(band).to_string()), Ok(band)),
        Err(error) => points_into(bytes, text, &error),
    }
    if let Ok(class) = text.parse::<ToleranceClass>() {
        assert_eq!(class.to_string().parse(), Ok(class));
        assert_eq!(class.other_case().other_case(), class);
    }
}

fn points_into(bytes: &[u8], text: &str, error: &CalloutError) {
    let span = error.span().expect("a text was read");
    assert!(span.end <= text.chars().count(), "{span:?} of {text:?}");
    assert!(error.text.chars().count() <= 81);
    told(bytes, error);
}
