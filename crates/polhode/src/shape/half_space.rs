//! The half-space.

use crate::error::Error;
use crate::mass::check;
use crate::math::Vec3;

/// Everything on one side of a plane through the origin: all r with normal·r ≤ 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfSpace {
    /// Points out of the matter; of any length but zero.
    pub normal: Vec3,
}

impl HalfSpace {
    /// Checks that there is a normal.
    ///
    /// # Errors
    /// If it is zero or not finite.
    pub fn validate(&self) -> Result<(), Error> {
        check::finite("normal", self.normal)?;
        match self.normal.direction() {
            Some(_) => Ok(()),
            None => Err(Error::new("normal", "must not be zero")),
        }
    }
}
