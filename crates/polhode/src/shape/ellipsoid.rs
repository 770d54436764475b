//! The ellipsoid.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, shell, solid};
use crate::math::Vec3;

/// An ellipsoid centred at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipsoid {
    /// Semi-axes along x, y, z \[m\].
    pub semi_axes: Vec3,
}

impl Ellipsoid {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => solid::ellipsoid(self.semi_axes, density),
            Fill::Shell { thickness } => shell::ellipsoid(self.semi_axes, thickness, density),
        }
    }
}
