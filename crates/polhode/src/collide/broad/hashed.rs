//! The hashed grid: cubes without bounds, of which only those in use are stored (Teschner et al. 2003; Ericson 2005, §7.1.3).
//!
//! ```text
//! for each box, for each cell it covers:  append (cell, box) to a list
//! group the list by the hash of the cell into buckets
//! two boxes of one bucket that overlap are a pair, reported in the cell of the lower corner of their intersection
//! ```
//!
//! No map is iterated: the list is grouped by counting, so its order depends on nothing but the boxes. The edge of a cell is
//! twice the median box, which suits boxes of one size, in clusters or spread without bounds; n boxes take time n. A box over more
//! than 64 cells is kept apart and asked one by one, which is what a mixture of sizes does to a grid.

use super::lattice::{Cells, Lattice};
use super::{Aabb, BroadPhase, Pair, PairSort, Ray, bytes, pair, valid_keys};

/// A box over more cells than this goes into the list of large ones.
const MOST_CELLS: u64 = 64;

/// A grid whose cells lie in a table by their hash.
#[derive(Clone, Debug, Default)]
pub struct Hashed {
    boxes: Vec<Aabb>,
    keys: Vec<u32>,
    lattice: Lattice,
    /// Boxes over too many cells.
    large: Vec<u32>,
    is_large: Vec<bool>,
    /// Where each bucket ends in `entries`; a power of two of them, and one more in front.
    ends: Vec<u32>,
    /// Keys by bucket, ascending in each.
    entries: Vec<u32>,
    /// The box around all that is finite.
    around: Option<Aabb>,
    pair_sort: PairSort,
}

/// The median of the largest finite edges, or 1 m if that is nothing.
pub(super) fn median_edge(boxes: &[Aabb], keys: &[u32]) -> f64 {
    let largest = |b: &Aabb| b.size().max_abs();
    let mut edges: Vec<f64> =
        keys.iter().map(|&i| largest(&boxes[i as usize])).filter(|e| e.is_finite() && *e > 0.0).collect();
    if edges.is_empty() {
        return 1.0;
    }
    let middle = edges.len() / 2;
    *edges.select_nth_unstable_by(middle, f64::total_cmp).1
}

impl Hashed {
    fn bucket(&self, cell: [i32; 3]) -> usize {
        // The primes of Teschner et al.; the high bits, which all inputs reach, choose the bucket.
        let [x, y, z] = cell.map(|c| u64::from(c.cast_unsigned()));
        let mixed = (x * 73_856_093) ^ (y * 19_349_663) ^ (z * 83_492_791);
        let spread = mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        (spread >> 32) as usize & (self.ends.len() - 2)
    }
    fn in_bucket(&self, bucket: usize) -> &[u32] {
        &self.entries[self.ends[bucket] as usize..self.ends[bucket + 1] as usize]
    }
    fn small(&self) -> impl Iterator<Item = (u32, Cells)> + '_ {
        let small = self.keys.iter().filter(|&&i| !self.is_large[i as usize]);
        small.map(|&i| (i, self.lattice.cells(&self.boxes[i as usize])))
    }

    /// Groups (cell, key) by bucket: counts, then places.
    fn fill(&mut self) {
        let n_buckets = (2 * self.keys.len()).next_power_of_two().max(2);
        let mut ends = core::mem::take(&mut self.ends);
        ends.clear();
        ends.resize(n_buckets + 1, 0);
        self.ends = ends;
        let mut counts = vec![0_u32; n_buckets];
        for (_, cells) in self.small() {
            for cell in cells.iter() {
                counts[self.bucket(cell)] += 1;
            }
        }
        for (bucket, count) in counts.iter().enumerate() {
            self.ends[bucket + 1] = self.ends[bucket] + count;
        }
        counts.copy_from_slice(&self.ends[..n_buckets]);
        let mut entries = core::mem::take(&mut self.entries);
        entries.clear();
        entries.resize(self.ends[n_buckets] as usize, 0);
        for (key, cells) in self.small() {
            for cell in cells.iter() {
                let next = &mut counts[self.bucket(cell)];
                entries[*next as usize] = key;
                *next += 1;
            }
        }
        self.entries = entries;
    }

    /// Sorts what was found and takes out what was found in several cells.
    fn finish(out: &mut Vec<u32>) {
        out.sort_unstable();
        out.dedup();
    }
}

impl BroadPhase for Hashed {
    fn update(&mut self, boxes: &[Aabb]) {
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
        valid_keys(boxes, &mut self.keys);
        self.lattice.edge = 2.0 * median_edge(boxes, &self.keys);
        let lattice = self.lattice;
        self.is_large.clear();
        self.is_large.extend(boxes.iter().map(|b| !b.is_finite() || lattice.cells(b).count(MOST_CELLS).is_none()));
        self.large.clear();
        self.large.extend(self.keys.iter().filter(|&&i| self.is_large[i as usize]));
        self.around = self
            .keys
            .iter()
            .filter(|&&i| !self.is_large[i as usize])
            .map(|&i| boxes[i as usize])
            .reduce(|a, b| a.merged(&b));
        self.fill();
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        out.clear();
        let n_buckets = self.ends.len().saturating_sub(1);
        for bucket in 0..n_buckets {
            let keys = self.in_bucket(bucket);
            for (n, &i) in keys.iter().enumerate() {
                let a = &self.boxes[i as usize];
                // A box may be twice in a bucket, by two cells with one hash; and so may a pair.
                let first_of_i = n == 0 || keys[n - 1] != i;
                for (m, &j) in keys.iter().enumerate().skip(n + 1) {
                    let b = &self.boxes[j as usize];
                    let first = first_of_i && keys[m - 1] != j || m == n + 1 && first_of_i && j != i;
                    if first && i != j && a.meets(b) && self.bucket(self.lattice.meeting_cell(a, b)) == bucket {
                        out.push(pair(i, j));
                    }
                }
            }
        }
        for &i in &self.large {
            let a = &self.boxes[i as usize];
            let others = self.keys.iter().filter(|&&j| j > i || !self.is_large[j as usize]);
            out.extend(others.filter(|&&j| a.meets(&self.boxes[j as usize])).map(|&j| pair(i, j)));
        }
        self.pair_sort.sort(out);
    }
    fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        out.clear();
        let meets = |i: &&u32| self.boxes[**i as usize].overlaps(region);
        let cells = self.lattice.cells(region);
        if !region.is_valid() {
            return;
        }
        if cells.count(self.keys.len() as u64).is_none() {
            out.extend(self.keys.iter().filter(meets));
            return;
        }
        for cell in cells.iter() {
            out.extend(self.in_bucket(self.bucket(cell)).iter().filter(meets));
        }
        out.extend(self.large.iter().filter(meets));
        Self::finish(out);
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        let hit = |i: &&u32| self.boxes[**i as usize].ray(ray).is_some();
        let Some(around) = self.around else {
            out.extend(self.large.iter().filter(hit));
            return;
        };
        // Where the scene is far larger than its cells, more cells than boxes lie on the ray.
        let longest = (around.size() / self.lattice.edge).max_abs();
        if longest > self.keys.len() as f64 {
            out.extend(self.keys.iter().filter(hit));
            return;
        }
        self.lattice.along(ray, &around, |cells| {
            for cell in cells.iter() {
                out.extend(self.in_bucket(self.bucket(cell)).iter().filter(hit));
            }
        });
        out.extend(self.large.iter().filter(hit));
        Self::finish(out);
    }
    fn memory(&self) -> usize {
        let lists = [&self.keys, &self.large, &self.ends, &self.entries];
        lists.into_iter().map(bytes).sum::<usize>()
            + bytes(&self.boxes)
            + bytes(&self.is_large)
            + self.pair_sort.memory()
    }
}
