//! The ball.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, shell, solid};

/// A ball about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Radius \[m\].
    pub radius: f64,
}

impl Sphere {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => solid::sphere(self.radius, density),
            Fill::Shell { thickness } => shell::sphere(self.radius, thickness, density),
        }
    }
}
