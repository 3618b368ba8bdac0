//! What a value may be called, and to which feature of a plan that belongs: to one alone.

use std::collections::BTreeMap;

use super::column::Column;
use super::fault::PlanFault;

/// The signs between the name of a feature and its side.
const BEFORE_SIDE: [&str; 4] = [" ", ".", "_", "-"];

/// Names are told apart without regard to case and blanks around them: files on a control ignore case.
pub(super) fn key(name: &str) -> String {
    name.trim().to_uppercase()
}

/// The same of numbers: `01` is `1`.
pub(super) fn number_key(number: &str) -> String {
    let number = number.trim();
    let is_whole = !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit());
    if !is_whole {
        return key(number);
    }
    let significant = number.trim_start_matches('0');
    if significant.is_empty() { "0" } else { significant }.to_owned()
}

/// What the size of a side may be called; the name itself where a feature has one size.
pub(super) fn of_side(name: &str, side: &str) -> Vec<String> {
    if side.is_empty() {
        return vec![name.to_owned()];
    }
    BEFORE_SIDE.map(|sign| format!("{name}{sign}{side}")).to_vec()
}

/// A feature that was seen before.
#[derive(Debug, Clone)]
struct Earlier {
    name: String,
    number: String,
    line: usize,
}

/// The names and numbers that earlier features have.
#[derive(Debug, Default)]
pub(super) struct Names {
    features: Vec<Earlier>,
    /// The positions of features by their names, by what their sizes may be called, and by their numbers.
    by_name: BTreeMap<String, usize>,
    /// The same by their names as numbers: `01` is `1`.
    as_number: BTreeMap<String, usize>,
    sizes: BTreeMap<String, usize>,
    numbers: BTreeMap<String, usize>,
}

impl Names {
    /// Takes a feature with its sides, and says what of it is another one's.
    pub(super) fn take(
        &mut self,
        line: Option<usize>,
        number: &str,
        name: &str,
        sides: &[&str],
    ) -> Vec<(Column, PlanFault)> {
        let mut faults = self.name(name, sides);
        if !number.is_empty() {
            faults.extend(self.number(number));
        }
        let at = self.features.len();
        let name = name.to_owned();
        let number = number.to_owned();
        // A feature of no file is on line 0, of which the texts say nothing.
        let line = line.map_or(0, |line| line);
        for called in sides.iter().flat_map(|side| of_side(&name, side)) {
            self.sizes.entry(key(&called)).or_insert(at);
        }
        self.by_name.entry(key(&name)).or_insert(at);
        self.as_number.entry(number_key(&name)).or_insert(at);
        if !number.is_empty() {
            self.numbers.entry(number_key(&number)).or_insert(at);
        }
        self.features.push(Earlier { name, number, line });
        faults
    }

    fn earlier(&self, at: Option<&usize>) -> Option<&Earlier> {
        self.features.get(*at?)
    }

    fn name(&self, name: &str, sides: &[&str]) -> Vec<(Column, PlanFault)> {
        let fault = |what| vec![(Column::Name, what)];
        if let Some(Earlier { line, .. }) = self.earlier(self.by_name.get(&key(name))) {
            return fault(PlanFault::SameName { name: name.to_owned(), line: *line });
        }
        let all: Vec<String> = sides.iter().flat_map(|side| of_side(name, side)).chain([name.to_owned()]).collect();
        for called in &all {
            let at = self.sizes.get(&key(called)).or_else(|| self.by_name.get(&key(called)));
            if let Some(Earlier { name: other, line, .. }) = self.earlier(at) {
                let called = called.clone();
                let other = other.clone();
                return fault(PlanFault::SameSize { called, other, line: *line });
            }
        }
        for called in all {
            if let Some(Earlier { name: other, line, .. }) = self.earlier(self.numbers.get(&number_key(&called))) {
                let other = other.clone();
                return fault(PlanFault::NameIsNumber { called, other, line: *line });
            }
        }
        Vec::new()
    }

    fn number(&self, number: &str) -> Option<(Column, PlanFault)> {
        let fault = |what| Some((Column::Number, what));
        if let Some(Earlier { number: other, line, .. }) = self.earlier(self.numbers.get(&number_key(number))) {
            let number = number.to_owned();
            let other = other.clone();
            return fault(PlanFault::SameNumber { number, other, line: *line });
        }
        let named = |key: &str| self.sizes.get(key).or_else(|| self.by_name.get(key));
        // A name such as 01 is that of the number 1, too.
        let at = named(&key(number)).or_else(|| self.as_number.get(&number_key(number)));
        let Earlier { name, line, .. } = self.earlier(at)?;
        fault(PlanFault::NumberIsName { number: number.to_owned(), other: name.clone(), line: *line })
    }
}
