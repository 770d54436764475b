//! The vertex farthest in a direction, and what is inside.

use super::ConvexHull;
use crate::math::Vec3;

/// Up to this many vertices, looking at all of them costs less than walking along edges.
const FEW: usize = 16;

/// How far an edge rises in a direction for certain: less the rounding of the product and of the edge, so that no walk can go
/// in a circle.
pub(super) fn rise(direction: Vec3, edge: Vec3) -> f64 {
    let terms = direction.scale(edge);
    terms.x + terms.y + terms.z - 4.0 * f64::EPSILON * (terms.x.abs() + terms.y.abs() + terms.z.abs())
}

impl ConvexHull {
    /// The vertex farthest in `direction`, of any length, and its position \[m\].
    ///
    /// Walks uphill along edges: on a convex surface no other summit exists. Of vertices equally far to rounding it may
    /// give any, but always the same for the same direction.
    pub fn support(&self, direction: Vec3) -> (usize, Vec3) {
        let height = |v: u32| direction.dot(self.vertices[v as usize]);
        let mut best = self.extremes[0];
        if self.vertices.len() <= FEW {
            for v in 0..self.vertices.len() as u32 {
                if height(v) > height(best) {
                    best = v;
                }
            }
        } else {
            for v in self.extremes {
                if height(v) > height(best) {
                    best = v;
                }
            }
            best =
                self.climb(best, |from, to| rise(direction, self.vertices[to as usize] - self.vertices[from as usize]));
        }
        (best as usize, self.vertices[best as usize])
    }

    /// The vertex farthest in `direction`, from a vertex that is near it, such as the last answer.
    ///
    /// # Panics
    /// If there is no vertex `start`.
    pub fn support_from(&self, start: usize, direction: Vec3) -> (usize, Vec3) {
        let along = |from: u32, to: u32| rise(direction, self.vertices[to as usize] - self.vertices[from as usize]);
        let best = self.climb(start as u32, along) as usize;
        (best, self.vertices[best])
    }

    /// The summit above `start`, by the rise from one vertex to a neighbour.
    ///
    /// The rise along an edge, unlike a difference of two heights, is right to the rounding of a length as short as the
    /// edge: the walk does not end early among vertices that are close together.
    pub(super) fn climb(&self, start: u32, rise: impl Fn(u32, u32) -> f64) -> u32 {
        let mut here = start;
        loop {
            let (mut best, mut most) = (here, 0.0);
            for &v in self.neighbours(here as usize) {
                let r = rise(here, v);
                if r > most {
                    (best, most) = (v, r);
                }
            }
            if best == here {
                return here;
            }
            here = best;
        }
    }

    /// Whether a point is inside or, to [`ConvexHull::rounding`], on the surface.
    pub fn contains(&self, point: Vec3) -> bool {
        let below = |(n, &offset): (&Vec3, &f64)| n.dot(point) - offset <= self.rounding;
        self.normals.iter().zip(&self.offsets).all(below)
    }

    /// The vertices farthest along −x, x, −y, y, −z, z: where walks begin.
    pub(super) fn find_extremes(&self) -> [u32; 6] {
        let mut extremes = [0; 6];
        for (k, extreme) in extremes.iter_mut().enumerate() {
            let sign = if k % 2 == 0 { -1.0 } else { 1.0 };
            for v in 0..self.vertices.len() {
                if sign * self.vertices[v][k / 2] > sign * self.vertices[*extreme as usize][k / 2] {
                    *extreme = v as u32;
                }
            }
        }
        extremes
    }
}
