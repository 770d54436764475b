//! The torus.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, shell, solid};

/// A tube around a circle in the plane z = 0 that is centred at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Torus {
    /// Radius of the circle \[m\].
    pub major: f64,
    /// Radius of the tube, at most `major` \[m\].
    pub minor: f64,
}

impl Torus {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite, or `minor` exceeds `major`.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => solid::torus(self.major, self.minor, density),
            Fill::Shell { thickness } => shell::torus(self.major, self.minor, thickness, density),
        }
    }
}
