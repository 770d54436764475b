//! The hashed grid: cubes without bounds, of which only those in use are stored (Teschner et al. 2003; Ericson 2005, §7.1.3).
//!
//! ```text
//! for each box, for each cell it covers:  append the box to the list of the cell's hash
//! two boxes of one list that overlap are a pair, reported by the cell of the lower corner of their intersection
//! ```
//!
//! The edge of a cell is twice the median box, which suits boxes of one size, in clusters or spread without bounds: time n. A box
//! over more than 64 cells is kept apart and asked one by one, which is what a mixture of sizes does to a grid.

use super::lattice::Lattice;
use super::listing::{Listing, Numbering, median_edge};
use super::{Aabb, BroadPhase, Pair, Ray};
use crate::math::Vec3;

/// Cells without bounds, by hash.
#[derive(Clone, Debug, Default)]
pub struct Hashed(Listing);

impl BroadPhase for Hashed {
    fn update(&mut self, boxes: &[Aabb]) {
        let lattice = Lattice { origin: Vec3::ZERO, edge: 2.0 * median_edge(boxes) };
        let n_lists = (2 * boxes.len()).next_power_of_two();
        self.0.update(boxes, lattice, Numbering::Hashed(n_lists));
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        self.0.pairs(out);
    }
    fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        self.0.query(region, out);
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        self.0.ray(ray, out);
    }
    fn memory(&self) -> usize {
        self.0.memory()
    }
}
