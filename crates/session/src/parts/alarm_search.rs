//! What is looked for once values are on disk: whether a rule of a control chart fires there.

use std::collections::BTreeMap;

use fitcheck_exchange::series::{FeatureKey, Look};

/// The newest value of a feature, which is on disk.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewestValue {
    /// The number of its entry.
    pub number: u64,
    /// What it is named.
    pub part: String,
    pub serial: String,
    pub feature: String,
}

/// How series are looked at for alarms: as the statistics page looks at them.
#[derive(Debug, Clone, PartialEq)]
pub struct AlarmSearch {
    /// The values that came; none where only the open alarms are asked for.
    pub newest: Vec<NewestValue>,
    pub look: Look,
    /// The baselines of features.
    pub baselines: BTreeMap<FeatureKey, [u64; 2]>,
    /// So many values of a feature.
    pub most: usize,
}
