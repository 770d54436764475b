//! The rectangle, planar.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, lamina, outline};

/// A rectangle in the plane z = 0, centred at the origin, edges along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Full edge lengths along x and y \[m\].
    pub size: [f64; 2],
}

impl Rectangle {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m²\].
    ///
    /// # Errors
    /// If a dimension, the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => lamina::rectangle(self.size, density),
            Fill::Shell { thickness } => outline::rectangle(self.size, thickness, density),
        }
    }
}
