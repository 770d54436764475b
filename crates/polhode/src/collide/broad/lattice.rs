//! Space cut into equal cubes, and which of them a box or a ray goes through: what the grids have in common.
//!
//! The cell of a coordinate, ⌊(x − origin)/edge⌋ cut off at ±2³⁰, never decreases with x, rounding included. So two boxes that
//! overlap have the lower corner of their intersection, max(a.min, b.min), in one cell that both cover: a structure that lists a
//! box in every cell it covers reports the pair in that cell and in no other.

use super::{Aabb, Ray};
use crate::math::{Lane, Vec3};

/// Cells are numbered from −2³⁰ to 2³⁰, so that differences fit an i32.
const FARTHEST: f64 = (1 << 30) as f64;

/// Cubes of one edge length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lattice {
    pub(super) origin: Vec3,
    pub(super) edge: f64,
}

impl Default for Lattice {
    fn default() -> Self {
        Self { origin: Vec3::ZERO, edge: 1.0 }
    }
}

/// The cells of a box: from `low` to `high`, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cells {
    pub(super) low: [i32; 3],
    pub(super) high: [i32; 3],
}

impl Lattice {
    pub(super) fn cell(&self, p: Vec3) -> [i32; 3] {
        [0, 1, 2].map(|i| ((p[i] - self.origin[i]) / self.edge).floor().clamp(-FARTHEST, FARTHEST) as i32)
    }
    pub(super) fn cells(&self, b: &Aabb) -> Cells {
        Cells { low: self.cell(b.min), high: self.cell(b.max) }
    }
    /// The cell in which two boxes that overlap report it.
    pub(super) fn meeting_cell(&self, a: &Aabb, b: &Aabb) -> [i32; 3] {
        self.cell(Vec3::new(a.min.x.greatest(b.min.x), a.min.y.greatest(b.min.y), a.min.z.greatest(b.min.z)))
    }
    /// Calls `visit` with ranges of cells that together hold every cell of `within` that `ray` goes through.
    ///
    /// Slices along the axis that the ray crosses fastest, and in each the cells of the box around that piece of the ray,
    /// widened by what rounding could take away: a few cells too many, never one too few.
    pub(super) fn along(&self, ray: &Ray, within: &Aabb, mut visit: impl FnMut(Cells)) {
        let Some((first, last)) = within.ray(ray) else { return };
        let bounds = self.cells(within);
        let d = ray.direction.to_array().map(f64::abs);
        let axis = if d[0] >= d[1] && d[0] >= d[2] { 0 } else { 1 + usize::from(d[2] > d[1]) };
        // ∞·0 where a faint direction makes t overflow.
        let along = |t: f64, d: f64| if d == 0.0 { 0.0 } else { t * d };
        let at = |t: f64, i: usize| ray.origin[i] + along(t, ray.direction[i]);
        let slack = 1e-9 * (self.edge + ray.origin.max_abs() + within.min.max_abs() + within.max.max_abs());
        // The cells of one piece of the ray, from t = a to t = b.
        let piece = |a: f64, b: f64| {
            let low = Vec3::from([0, 1, 2].map(|i| at(a, i).least(at(b, i)) - slack));
            let high = Vec3::from([0, 1, 2].map(|i| at(a, i).greatest(at(b, i)) + slack));
            let cells = self.cells(&Aabb::new(low, high));
            cells.within(&bounds)
        };
        let whole = piece(first, last);
        for slice in whole.low[axis]..=whole.high[axis] {
            let face = |n: f64| (self.origin[axis] + n * self.edge - ray.origin[axis]) / ray.direction[axis];
            let (a, b) = (face(f64::from(slice)), face(f64::from(slice) + 1.0));
            let (a, b) = (a.least(b).greatest(first).least(last), a.greatest(b).least(last).greatest(first));
            let mut cells = piece(a, b);
            cells.low[axis] = slice;
            cells.high[axis] = slice;
            visit(cells);
        }
    }
}

impl Cells {
    /// How many there are, or `None` if they are more than `most`.
    pub(super) fn count(&self, most: u64) -> Option<u64> {
        let mut count = 1_u64;
        for i in 0..3 {
            let edge = u64::try_from(i64::from(self.high[i]) - i64::from(self.low[i]) + 1).unwrap_or(0);
            count = count.checked_mul(edge).filter(|&c| c <= most)?;
        }
        Some(count)
    }
    /// Those that are also in `range`.
    pub(super) fn within(&self, range: &Self) -> Self {
        Self {
            low: [0, 1, 2].map(|i| self.low[i].max(range.low[i])),
            high: [0, 1, 2].map(|i| self.high[i].min(range.high[i])),
        }
    }
    /// Those and `n` more on every side.
    pub(super) fn grown(&self, n: i32) -> Self {
        Self { low: self.low.map(|c| c - n), high: self.high.map(|c| c + n) }
    }
    /// All of them, x fastest.
    pub(super) fn iter(self) -> impl Iterator<Item = [i32; 3]> {
        let x = move || self.low[0]..=self.high[0];
        let y = move || self.low[1]..=self.high[1];
        (self.low[2]..=self.high[2]).flat_map(move |z| y().flat_map(move |y| x().map(move |x| [x, y, z])))
    }
}
