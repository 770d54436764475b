//! The simple polygon, planar.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, lamina, outline};

/// A simple polygon in the plane z = 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// Corners in either sense of rotation; the last is joined to the first \[m\].
    pub points: Vec<[f64; 2]>,
}

impl Polygon {
    /// Mass, centre and second moment in its own frame, at `density` \[kg/m²\].
    ///
    /// # Errors
    /// If the polygon is not simple, or the density or the thickness is not positive and finite.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => lamina::polygon(&self.points, density),
            Fill::Shell { thickness } => outline::polygon(&self.points, thickness, density),
        }
    }
}
