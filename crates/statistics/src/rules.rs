//! The rules of Nelson (1984) and of Western Electric (1956): patterns that a stable process shows seldom.
//!
//! A rule fires at the last point of its pattern, and at each further point that continues it. Runs are counted in points, as
//! Nelson does: six points rise in five steps. *Two of three* and *four of five* fire only where the newest point is itself in
//! the zone. A point on the centre line ends a run on one side; equal neighbours end a trend and an alternation.

use fitcheck_core::message::Say;

fitcheck_core::named! {
    /// A rule.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Say)]
    #[say(prefix = "statistics-rule")]
    pub enum Rule {
        /// All of them.
        ALL;
        /// Its name in files and options.
        fn word;
        /// Nelson 1, Western Electric 1: a point beyond 3 s.
        BeyondLimits = "nelson-1",
        /// Nelson 2: nine points on one side of the centre line.
        NineOneSide = "nelson-2",
        /// Nelson 3: six points rising or falling.
        SixTrend = "nelson-3",
        /// Nelson 4: fourteen points alternately rising and falling.
        FourteenAlternating = "nelson-4",
        /// Nelson 5, Western Electric 2: two of three points beyond 2 s on one side.
        TwoOfThree = "nelson-5",
        /// Nelson 6, Western Electric 3: four of five points beyond 1 s on one side.
        FourOfFive = "nelson-6",
        /// Nelson 7: fifteen points within 1 s.
        FifteenWithin = "nelson-7",
        /// Nelson 8: eight points beyond 1 s, on either side.
        EightBeyond = "nelson-8",
        /// Western Electric 4: eight points on one side of the centre line.
        EightOneSide = "western-electric-4",
    }
}

impl Rule {
    /// How many points its pattern has.
    pub const fn points(self) -> usize {
        match self {
            Self::BeyondLimits => 1,
            Self::NineOneSide => 9,
            Self::SixTrend => 6,
            Self::FourteenAlternating => 14,
            Self::TwoOfThree => 3,
            Self::FourOfFive => 5,
            Self::FifteenWithin => 15,
            Self::EightBeyond | Self::EightOneSide => 8,
        }
    }

    const fn bit(self) -> u16 {
        match self {
            Self::BeyondLimits => 1,
            Self::NineOneSide => 2,
            Self::SixTrend => 4,
            Self::FourteenAlternating => 8,
            Self::TwoOfThree => 16,
            Self::FourOfFive => 32,
            Self::FifteenWithin => 64,
            Self::EightBeyond => 128,
            Self::EightOneSide => 256,
        }
    }
}

/// A set of rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Rules(u16);

impl Rules {
    /// None of them.
    pub const NONE: Self = Self(0);
    /// The eight of Nelson.
    pub const NELSON: Self = Self(255);
    /// The four of Western Electric.
    pub const WESTERN_ELECTRIC: Self = Self(1 + 16 + 32 + 256);

    /// The same with a rule, or without it.
    #[must_use]
    pub const fn with(self, rule: Rule, is_on: bool) -> Self {
        if is_on { Self(self.0 | rule.bit()) } else { Self(self.0 & !rule.bit()) }
    }

    /// Whether a rule is in it.
    pub const fn has(self, rule: Rule) -> bool {
        self.0 & rule.bit() != 0
    }

    /// The rules that are in both.
    #[must_use]
    pub const fn both(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// The rules that are in one of them.
    #[must_use]
    pub const fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Whether there is none in it.
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The rules in it.
    pub fn iter(self) -> RulesIter {
        RulesIter { rules: self, all: Rule::ALL.into_iter() }
    }
}

impl IntoIterator for Rules {
    type Item = Rule;
    type IntoIter = RulesIter;

    fn into_iter(self) -> RulesIter {
        self.iter()
    }
}

/// The rules of a set.
#[derive(Debug, Clone)]
pub struct RulesIter {
    rules: Rules,
    all: std::array::IntoIter<Rule, 9>,
}

impl Iterator for RulesIter {
    type Item = Rule;

    fn next(&mut self) -> Option<Rule> {
        self.all.find(|rule| self.rules.has(*rule))
    }
}

/// Looks at one point after another.
#[derive(Debug, Clone, Default)]
pub struct Scanner {
    /// Distances from the centre line in s: those of the four points before.
    before: [f64; 4],
    /// The last value, and whether it rose to it; equal values neither rise nor fall.
    last: Option<f64>,
    rose: Option<bool>,
    /// How many points are on one side, above where the flag says so.
    side: Run<bool>,
    trend: usize,
    alternating: usize,
    within: usize,
    beyond: usize,
}

/// How often the same comes after another.
#[derive(Debug, Clone, Copy, Default)]
struct Run<T> {
    what: Option<T>,
    length: usize,
}

impl<T: PartialEq> Run<T> {
    /// One more; `None` ends it.
    fn next(&mut self, what: Option<T>) {
        self.length = match (&what, &self.what) {
            (None, _) => 0,
            (new, old) if new == old => self.length + 1,
            _ => 1,
        };
        self.what = what;
    }
}

impl Scanner {
    /// The rules that fire at the next point: its value, and its distance from the centre line in s of what is drawn.
    pub fn next(&mut self, value: f64, distance: f64) -> Rules {
        self.count(value, distance);
        let [a, b, c, d] = self.before;
        self.before = [b, c, d, distance];
        let beyond = |zone: f64, points: &[f64]| {
            let same = |point: &&f64| zone < **point * distance.signum();
            if zone < distance.abs() { points.iter().filter(same).count() + 1 } else { 0 }
        };
        Rules::NONE
            .with(Rule::BeyondLimits, 3.0 < distance.abs())
            .with(Rule::NineOneSide, 9 <= self.side.length)
            .with(Rule::EightOneSide, 8 <= self.side.length)
            .with(Rule::SixTrend, 6 <= self.trend)
            .with(Rule::FourteenAlternating, 14 <= self.alternating)
            .with(Rule::TwoOfThree, 2 <= beyond(2.0, &[c, d]))
            .with(Rule::FourOfFive, 4 <= beyond(1.0, &[a, b, c, d]))
            .with(Rule::FifteenWithin, 15 <= self.within)
            .with(Rule::EightBeyond, 8 <= self.beyond)
    }

    /// How many points are on one side of the centre line, the newest one included.
    pub const fn on_one_side(&self) -> usize {
        self.side.length
    }

    fn count(&mut self, value: f64, distance: f64) {
        let rises = self.last.filter(|last| value < *last || *last < value).map(|last| last < value);
        (self.trend, self.alternating) = match (rises, self.rose) {
            (None, _) => (1, 1),
            (Some(_), None) => (2, 2),
            (Some(now), Some(before)) if now == before => (self.trend + 1, 2),
            (Some(_), Some(_)) => (2, self.alternating + 1),
        };
        self.last = Some(value);
        self.rose = rises;
        self.side.next((distance < 0.0 || 0.0 < distance).then_some(0.0 < distance));
        self.within = if distance.abs() < 1.0 { self.within + 1 } else { 0 };
        self.beyond = if 1.0 < distance.abs() { self.beyond + 1 } else { 0 };
    }
}
