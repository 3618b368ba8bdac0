//! PostgreSQL's password file: `host:port:database:user:password`, one line a login.
//!
//! The rules are those of libpq: the first line that fits counts, `*` fits everything, `\:` and `\\` are a colon and a
//! backslash, and a line that begins with `#` is a remark.

use fitcheck_core::text::Within as _;

/// The password of the first line that fits this host, port, database and user.
pub fn find(text: &str, wanted: [&str; 4]) -> Option<String> {
    text.lines().map(|line| line.strip_suffix('\r').unwrap_or(line)).find_map(|line| fitting(line, wanted))
}

fn fitting(line: &str, wanted: [&str; 4]) -> Option<String> {
    if line.starts_with('#') {
        return None;
    }
    let mut rest = line;
    let [host, others @ ..] = wanted;
    let is_host = |given: &str| given == host || (given == "localhost" && SOCKETS.contains(&host));
    let given = field(&mut rest)?;
    if given.raw != "*" && !is_host(&given.text) {
        return None;
    }
    for wanted in others {
        let given = field(&mut rest)?;
        if given.raw != "*" && given.text != wanted {
            return None;
        }
    }
    let password = unescaped(rest).text;
    (!password.is_empty()).then_some(password)
}

/// Folders of the server's socket that libpq calls `localhost` here.
const SOCKETS: [&str; 3] = ["/run/postgresql", "/tmp", "/var/run/postgresql"];

struct Field<'a> {
    raw: &'a str,
    text: String,
}

/// Takes the field before the next colon that no backslash stands before.
fn field<'a>(rest: &mut &'a str) -> Option<Field<'a>> {
    let found = unescaped(rest);
    let (_, behind) = rest.split_at_checked(found.raw.len())?;
    *rest = behind.strip_prefix(':')?;
    Some(found)
}

/// What is before the next colon, or everything.
fn unescaped(text: &str) -> Field<'_> {
    let mut plain = String::new();
    let mut characters = text.char_indices();
    while let Some((at, character)) = characters.next() {
        match character {
            ':' => return Field { raw: text.within(..at), text: plain },
            '\\' => plain.extend(characters.next().map(|(_, next)| next)),
            other => plain.push(other),
        }
    }
    Field { raw: text, text: plain }
}
