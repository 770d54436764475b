//! The circular cone.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, shell, solid};

/// A circular cone with its apex at z = ¾ length and its base at −¼ length: the origin is its centre of mass if solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cone {
    /// Radius of the base \[m\].
    pub radius: f64,
    /// From base to apex \[m\].
    pub length: f64,
}

impl Cone {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => solid::cone(self.radius, self.length, density),
            Fill::Shell { thickness } => shell::cone(self.radius, self.length, thickness, density),
        }
    }
}
