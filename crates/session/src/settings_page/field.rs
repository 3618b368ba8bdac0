//! The text fields of the settings page. Settings that are texts stand in the fields of the pages that use them.

/// A text field of the settings page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SettingsField {
    /// Words of the settings that are looked for.
    Find,
    /// A PIN that is to lock the operator's window.
    NewPin,
    /// The PIN that is asked for where an operator leaves it.
    Pin,
    /// What the gauge that is shown is called.
    GaugeName,
    /// Its port, by the name that the system has for it.
    GaugePort,
    /// Bits in a second.
    GaugeSpeed,
    /// What its newest line gave.
    GaugeGave,
    /// Who stands at the top of reports whose template names nobody.
    Company,
    /// The lines of its address, with a semicolon between them.
    CompanyAddress,
    /// The path of its logo.
    CompanyLogo,
}
