//! Any bytes as a mask: it prints the same twice, line by line; with every parameter defined only the wrong kind of a
//! parameter is an error, and without any a parameter is named.

use fitcheck::control::mask::{Context, Mask, RenderFault};
use fitcheck::control::variables::{Family, Parameter, Value, Variables};
use fitcheck::length::Length;
use fitcheck::words::Dialogue;

use super::shared::{NOW, told};

/// Parameters up to this number are defined.
const DEFINED: u16 = 600;

pub fn run(bytes: &[u8]) {
    thread_local! {
        static ALL: Variables = all();
    }
    let mask = match Mask::read(bytes) {
        Ok((mask, warnings)) => {
            for warning in &warnings {
                told(bytes, warning);
            }
            mask
        }
        Err(error) => return told(bytes, &error),
    };
    for language in [Dialogue::En, Dialogue::De] {
        let context = Context { language, time: NOW, call_path: r"TNC:\FIT\A.H" };
        let rendered = ALL.with(|all| mask.render(all, &context));
        match &rendered {
            Ok(output) => {
                assert!(output.text.is_empty() || output.text.ends_with('\n'));
                assert_eq!(ALL.with(|all| mask.render(all, &context)).as_ref(), Ok(output));
            }
            Err(error) => {
                assert!(match &error.what {
                    RenderFault::Undefined { name } => is_beyond(name),
                    RenderFault::NumberAsText { .. } | RenderFault::TextAsNumber { .. } => true,
                    RenderFault::NotFinite { .. } => false,
                });
                told(bytes, error);
            }
        }
        if let Err(error) = mask.render(&Variables::new(), &context) {
            told(bytes, &error);
        }
    }
}

fn is_beyond(name: &str) -> bool {
    name.parse().is_ok_and(|parameter: Parameter| DEFINED < parameter.number)
}

/// Lengths, other numbers, texts, and some empty texts.
fn all() -> Variables {
    let mut variables = Variables::new();
    for number in 0..=DEFINED {
        let length = Length::from_micrometres(i32::from(number) * 7 - 900);
        variables.set(Parameter::q(number), Value::Length(length));
        let float = Value::Number(f64::from(number) / 3.0 - 50.0);
        variables.set(Parameter { family: Family::Ql, number }, float.clone());
        variables.set(Parameter { family: Family::Qr, number }, float);
        let text = if number % 3 == 0 { String::new() } else { format!("text {number}") };
        variables.set(Parameter::qs(number), Value::Text(text));
    }
    variables
}
