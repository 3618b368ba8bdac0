//! Which parameters of a cycle are folded away in its form, and what the folds are called.

use fitcheck_core::probing::cycle::{Cycle, Key, Parameter, ParameterGroup, Value};

/// Whether a parameter may be folded away: one with a value of its own. Limits are always in sight, for they make the verdict.
pub fn may_fold(parameter: &Parameter) -> bool {
    let has_value = !matches!(parameter.default_value(), None | Some(Value::Band(None)));
    has_value && parameter.meaning.other_limit().is_none()
}

/// The name of the fold that a parameter stands in; `None` where it is always in sight.
pub(crate) fn fold_of(cycle: &Cycle, key: Key) -> Option<&'static str> {
    let parameter = cycle.parameter(key).filter(|parameter| parameter.has_effect && may_fold(parameter))?;
    Some(fold_name(cycle, parameter.meaning.group()))
}

/// The id of the name of a group.
pub const fn group_name(group: ParameterGroup) -> &'static str {
    match group {
        ParameterGroup::Position => "cycles-group-position",
        ParameterGroup::Probing => "cycles-group-probing",
        ParameterGroup::Tolerance => "cycles-group-tolerance",
        ParameterGroup::Output => "cycles-group-output",
    }
}

/// The id of the name of its fold: that of the group where nothing stands before it.
pub fn fold_name(cycle: &Cycle, group: ParameterGroup) -> &'static str {
    let of_group = |parameter: &&Parameter| parameter.has_effect && parameter.meaning.group() == group;
    if cycle.parameters.iter().filter(of_group).all(may_fold) {
        return group_name(group);
    }
    match group {
        ParameterGroup::Position => "cycles-optional-position",
        ParameterGroup::Probing => "cycles-optional-probing",
        ParameterGroup::Tolerance => "cycles-optional-tolerance",
        ParameterGroup::Output => "cycles-optional-output",
    }
}
