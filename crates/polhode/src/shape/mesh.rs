//! The triangle mesh.

use super::Fill;
use crate::error::Error;
use crate::mass::{Moments, mesh};
use crate::math::Vec3;

/// Triangles between vertices, counter-clockwise as seen from outside.
///
/// Every index is in range and every position finite. Closed it can have mass; open it can be the ground.
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleMesh {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl TriangleMesh {
    /// From positions \[m\] and triples of their indices.
    ///
    /// # Errors
    /// Names the first position that is not finite, or the first triangle with an index out of range; or says that there are
    /// no triangles.
    pub fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, Error> {
        mesh::check(&positions, &triangles)?;
        Ok(Self { positions, triangles })
    }
    /// Positions of the vertices \[m\].
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }
    /// Indices of the corners of each triangle.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }
    /// The same surface with vertices at exactly the same place made one, and triangles that this makes degenerate removed.
    ///
    /// Files that repeat a vertex for each triangle (STL) or for each normal (glTF) describe a closed surface only after this.
    /// The vertices keep the order of their first appearance.
    pub fn merged(self) -> Self {
        let mut order: Vec<u32> = (0..self.positions.len() as u32).collect();
        // +0 makes −0 and 0 the same place.
        let key = |&i: &u32| self.positions[i as usize].to_array().map(|x| (x + 0.0).to_bits());
        order.sort_unstable_by_key(|i| (key(i), *i));
        let mut first = vec![0; order.len()];
        for place in order.chunk_by(|i, j| key(i) == key(j)) {
            for &i in place {
                first[i as usize] = place[0];
            }
        }
        let mut positions = Vec::new();
        let mut renamed = vec![0; order.len()];
        for (i, &p) in self.positions.iter().enumerate() {
            if first[i] as usize == i {
                renamed[i] = positions.len() as u32;
                positions.push(p);
            }
        }
        let triangles = self.triangles.iter().map(|t| t.map(|i| renamed[first[i as usize] as usize]));
        let triangles = triangles.filter(|&[a, b, c]| a != b && b != c && c != a).collect();
        Self { positions, triangles }
    }
    /// Mass, centre and second moment of the closed mesh, at `density` \[kg/m³\].
    ///
    /// # Errors
    /// As [`mesh::solid`] and [`mesh::shell`]: names the first triangle or edge that keeps it from being closed.
    pub fn moments(&self, fill: Fill, density: f64) -> Result<Moments, Error> {
        match fill {
            Fill::Solid => mesh::solid(&self.positions, &self.triangles, density),
            Fill::Shell { thickness } => mesh::shell(&self.positions, &self.triangles, thickness, density),
        }
    }
}
