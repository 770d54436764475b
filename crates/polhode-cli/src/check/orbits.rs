use super::suite::Check;
pub(super) const CHECKS: &[Check] = &[];
