//! The block of a cycle's inputs, from its declaration.

use fitcheck_core::probing::cycle::{Control, Cycle, Inputs, Key, Parameter, Value};
use fitcheck_core::words::Dialogue;

use super::fault::{ProbeBlockError, ProbeBlockFault};
use super::shown;

/// Between lines.
const LINE_END: &str = "\r\n";

/// The block of a cycle with these inputs: every parameter of the declaration that was given or has a default, in its
/// order, with its name in a dialogue language if that is known. Without a block number; CRLF between lines.
///
/// ```
/// use fitcheck_nc::control::probe_block::write;
/// use fitcheck_core::probing::cycle::Inputs;
/// use fitcheck_core::probing::cycles::cycle_named;
/// use fitcheck_core::words::Dialogue;
///
/// let cycle = cycle_named("427").unwrap();
/// let block = write(cycle, &cycle.set(Inputs::new(), "Q263", "35")?, Dialogue::It)?;
/// assert!(block.starts_with("TCH PROBE 427 MISURAZ. COORDINATA ~\r\n    Q263=+35   ;1. PUNTO 1. ASSE ~\r\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ProbeBlockFault::NotWritable`], with the line of the block, for a text that no block can hold.
pub fn write(cycle: &Cycle, inputs: &Inputs, language: Dialogue) -> Result<String, ProbeBlockError> {
    let mut pairs = Vec::new();
    for (line, parameter) in (2..).zip(cycle.parameters) {
        let given = inputs.value(parameter.key).cloned();
        if let Some(value) = given.or_else(|| parameter.default_with(inputs)) {
            let text = value_text(cycle, parameter, &value).map_err(|fault| fault.at(line))?;
            pairs.push((parameter, text));
        }
    }
    if cycle.control == Control::Lathe {
        let words = pairs.iter().map(|(parameter, text)| format!(" {}{text}", parameter.key));
        return Ok(format!("{}{}{LINE_END}", cycle.code, words.collect::<String>()));
    }
    let mut lines = vec![format!("TCH PROBE {} {}", cycle.code, cycle.name(language))];
    for (parameter, text) in pairs {
        let pair = match (parameter.key, inputs.value(parameter.key)) {
            // A tool name goes into the text parameter of the same number.
            (Key::Q(number), Some(Value::Text(_))) => format!("QS{number}={text}"),
            (key, _) => format!("{key}={text}"),
        };
        lines.push(format!("    {pair:<10} ;{}", parameter.name_in(language)));
    }
    Ok(lines.join(&format!(" ~{LINE_END}")) + LINE_END)
}

/// A value as in a block: a sign for numbers of a milling control, quotation marks round a text.
fn value_text(cycle: &Cycle, parameter: &Parameter, value: &Value) -> Result<String, ProbeBlockFault> {
    let number = |number: String| {
        let is_plain = cycle.control == Control::Lathe || number.starts_with('-');
        if is_plain { number } else { format!("+{number}") }
    };
    Ok(match value {
        Value::Length(length) => number(length.to_string()),
        Value::Angle(angle) => number(angle.to_string().trim_end_matches('°').to_owned()),
        Value::Whole(whole) => number(whole.to_string()),
        Value::Number(float) => number(float.to_string()),
        Value::Predef => value.to_string(),
        Value::Text(_) | Value::Band(_) | Value::Nominal(_) => {
            let text = match value {
                // Without a tolerance, as the control writes it.
                Value::Nominal(nominal) if nominal.limits().is_none() => number(nominal.to_string()),
                value => value.to_string(),
            };
            if text.contains(|c: char| c == '"' || c.is_control()) {
                return Err(ProbeBlockFault::NotWritable { key: parameter.key, given: shown(&text) });
            }
            format!("\"{text}\"")
        }
    })
}
