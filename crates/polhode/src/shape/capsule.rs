//! The capsule.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, shell, solid};

/// All points within a distance of a segment of the z axis that is centred at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    /// Radius \[m\].
    pub radius: f64,
    /// Length of the segment, which is that of the cylindrical part \[m\].
    pub length: f64,
}

impl Capsule {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => solid::capsule(self.radius, self.length, density),
            Fill::Shell { thickness } => shell::capsule(self.radius, self.length, thickness, density),
        }
    }
}
