//! What a plan says of a feature, and of the part: the columns of its table and the keys of its file.

crate::named! {
    /// What a plan says of a feature. The key is the name in files.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Column {
        /// Every column, in the order of files and of the table in the window.
        ALL;
        /// The name in files.
        fn key;
        /// The number of its balloon on the drawing.
        Number = "number",
        /// Its name.
        Name = "name",
        /// What is measured: a diameter if not given.
        Kind = "kind",
        /// The measured axis of a width, or the direction in which a face or point is probed.
        Axis = "axis",
        /// Nominal size and tolerance; the band of a point.
        Callout = "callout",
        /// The same for the side of a pocket or boss along Y.
        SecondCallout = "callout2",
        /// Hole or shaft, where the callout does not say it.
        Feature = "feature",
        /// Centre in X, or the point's place, mm.
        X = "x",
        /// Centre in Y, or the point's place, mm.
        Y = "y",
        /// Measuring height in Z, or the point's place, mm.
        Z = "z",
        /// Angle of the first contact from +X, degrees.
        Angle = "angle",
        /// Lateral set-up clearance, mm.
        Clearance = "clearance",
        /// Where the probe moves without a collision, mm.
        ClearanceHeight = "clearance_height",
        /// The measuring cycle, where it is not the usual one of the kind.
        Cycle = "cycle",
        /// Further parameters of the cycle: `Q423=3 Q320=1`.
        Parameters = "parameters",
        /// The material, or its expansion in millionths per kelvin.
        Material = "material",
        /// The decision rule.
        Rule = "rule",
        /// The standard uncertainty, µm.
        Uncertainty = "u_um",
        /// What a value can be at all: two lengths, mm.
        Plausible = "plausible",
        /// The same for the side of a pocket or boss along Y.
        SecondPlausible = "plausible2",
        /// Anything else.
        Remark = "remark",
        /// Where its balloon is on the picture: from 0 at the left to 1 at the right.
        BalloonX = "balloon_x",
        /// From 0 at the top to 1 at the bottom.
        BalloonY = "balloon_y",
    }
}

impl Column {
    /// Its place among [`Self::ALL`].
    pub fn at(self) -> usize {
        Self::ALL.iter().take_while(|column| **column != self).count()
    }

    /// The column of a name in a file, in any case of letters.
    pub fn of_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|column| column.key().eq_ignore_ascii_case(key.trim()))
    }

    /// Whether a file has it as a number where it is one.
    pub const fn is_number(self) -> bool {
        matches!(
            self,
            Self::Number
                | Self::X
                | Self::Y
                | Self::Z
                | Self::Angle
                | Self::Clearance
                | Self::ClearanceHeight
                | Self::Cycle
                | Self::Uncertainty
                | Self::BalloonX
                | Self::BalloonY
        )
    }

    /// Whether a file has it as two numbers.
    pub(super) const fn is_range(self) -> bool {
        matches!(self, Self::Plausible | Self::SecondPlausible)
    }

    /// Whether it holds any text: one that a spreadsheet could take for a formula is copied with a mark.
    pub const fn is_free_text(self) -> bool {
        matches!(self, Self::Number | Self::Name | Self::Remark)
    }

    /// The names of all of them, as errors list them.
    pub fn known() -> String {
        Self::ALL.map(Self::key).join(", ")
    }
}

crate::named! {
    /// What a plan says of the part as a whole.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum HeadField {
        /// Every field, in the order of files and of the form.
        ALL;
        /// The name in files.
        fn key;
        /// The part's name or number.
        Part = "part",
        /// The drawing.
        Drawing = "drawing",
        /// The picture: a PNG, JPEG or SVG file beside the plan.
        Picture = "picture",
        /// The material of every feature that names none.
        Material = "material",
        /// The decision rule of every feature that names none.
        Rule = "rule",
        /// The standard uncertainty of every feature that names none, µm.
        Uncertainty = "u_um",
        /// The machine's travel in X: two numbers, mm.
        TravelX = "travel_x",
        /// The same in Y.
        TravelY = "travel_y",
        /// The same in Z.
        TravelZ = "travel_z",
        /// Anything else.
        Remark = "remark",
    }
}

impl HeadField {
    /// Its place among [`Self::ALL`].
    pub fn at(self) -> usize {
        Self::ALL.iter().take_while(|field| **field != self).count()
    }

    /// The field of a name in a file.
    pub fn of_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|field| field.key().eq_ignore_ascii_case(key))
    }

    /// The column of a feature that it stands for where a feature says nothing itself.
    pub const fn column(self) -> Option<Column> {
        match self {
            Self::Material => Some(Column::Material),
            Self::Rule => Some(Column::Rule),
            Self::Uncertainty => Some(Column::Uncertainty),
            _ => None,
        }
    }

    /// Whether a file has it as two numbers.
    pub(super) const fn is_travel(self) -> bool {
        matches!(self, Self::TravelX | Self::TravelY | Self::TravelZ)
    }

    /// The names of all of them, as errors list them.
    pub fn known() -> String {
        Self::ALL.map(Self::key).join(", ")
    }
}
