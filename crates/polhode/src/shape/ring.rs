//! The ring, planar.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, lamina, outline};

/// What is between two circles about the origin in the plane z = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ring {
    /// Radius of the hole \[m\].
    pub inner: f64,
    /// Outer radius, more than `inner` \[m\].
    pub outer: f64,
}

impl Ring {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m²\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite, or `inner` is not less than `outer`.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => lamina::ring(self.inner, self.outer, density),
            Fill::Shell { thickness } => outline::ring(self.inner, self.outer, thickness, density),
        }
    }
}
