//! The circular cylinder.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, shell, solid};

/// A circular cylinder along z, centred at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// Radius \[m\].
    pub radius: f64,
    /// Distance of the two discs \[m\].
    pub length: f64,
}

impl Cylinder {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => solid::cylinder(self.radius, self.length, density),
            Fill::Shell { thickness } => shell::cylinder(self.radius, self.length, thickness, density),
        }
    }
}
