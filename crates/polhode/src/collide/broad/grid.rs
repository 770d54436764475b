//! The uniform grid: the box around everything, cut into about as many cubes as there are boxes (Ericson 2005, §7.1).
//!
//! ```text
//! for each box, for each cell it covers:  append the box to the cell
//! two boxes of one cell that overlap are a pair, reported by the cell of the lower corner of their intersection
//! ```
//!
//! A cell is found by three divisions and nothing is searched: time n, for boxes of one size that fill their space evenly. One
//! box far away makes all cells large and puts the rest into one of them: n² again. That is what hashing cures.

use super::lattice::Lattice;
use super::listing::{Listing, Numbering, median_edge};
use super::{Aabb, BroadPhase, Pair, Ray};

/// Cells between bounds, in an array.
#[derive(Clone, Debug, Default)]
pub struct Grid(Listing);

/// About a cell a box, none smaller than the median box, and never more than four cells a box.
fn lattice(boxes: &[Aabb]) -> Lattice {
    let around = boxes.iter().filter(|b| b.is_valid() && b.is_finite()).fold(Aabb::EMPTY, |a, b| a.merged(b));
    if !around.is_valid() {
        return Lattice::default();
    }
    let n = boxes.len() as u64;
    let size = around.size();
    let even = libm::cbrt(size.x * size.y * size.z / n as f64);
    let median = median_edge(boxes);
    let edge = if even > median && even.is_finite() { even } else { median };
    let mut lattice = Lattice { origin: around.min, edge };
    while lattice.cells(&around).count(4 * n + 64).is_none() {
        lattice.edge *= 2.0;
    }
    lattice
}

impl BroadPhase for Grid {
    fn update(&mut self, boxes: &[Aabb]) {
        self.0.update(boxes, lattice(boxes), Numbering::Dense);
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
