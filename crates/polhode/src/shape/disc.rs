//! The disc, planar.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, lamina, outline};

/// A disc in the plane z = 0 about the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Radius \[m\].
    pub radius: f64,
}

impl Disc {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m²\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => lamina::disc(self.radius, density),
            Fill::Shell { thickness } => outline::disc(self.radius, thickness, density),
        }
    }
}
