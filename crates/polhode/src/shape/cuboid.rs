//! The box.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, shell, solid};
use crate::math::Vec3;

/// A box centred at the origin, edges along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// Full edge lengths along x, y, z \[m\].
    pub size: Vec3,
}

impl Cuboid {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => solid::cuboid(self.size, density),
            Fill::Shell { thickness } => shell::cuboid(self.size, thickness, density),
        }
    }
}
