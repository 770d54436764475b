//! Stage 7 for the schemes that evaluate all rates together.

use super::forces::forces;
use super::scratch::Scratch;
use crate::integrate::coupled::Coupled as _;
