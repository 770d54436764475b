//! A box in every cell it covers: what the uniform and the hashed grid have in common.
//!
//! Cells are numbered, densely or by a hash; the boxes of each number lie one after the other in one array, grouped by
//! counting. No map is iterated, so the order depends on nothing but the boxes.

use super::lattice::{Cells, Lattice};
use super::{Aabb, Pair, PairSort, Ray, bytes, pair, valid_keys};
use core::ops::Range;

/// A box over more cells than this goes into the list of large ones.
const MOST_CELLS: u64 = 64;

/// How cells become numbers from 0.
#[derive(Clone, Copy, Debug)]
pub(super) enum Numbering {
    /// One by one, x fastest.
    Dense,
    /// By a hash, into as many as this power of two.
    Hashed(usize),
}

/// Boxes by cell.
#[derive(Clone, Debug)]
pub(super) struct Listing {
    boxes: Vec<Aabb>,
    keys: Vec<u32>,
    lattice: Lattice,
    numbering: Numbering,
    /// The cells in use lie among these.
    range: Cells,
    /// The box around all that is listed.
    around: Aabb,
    /// Boxes over too many cells, or infinite: asked one by one.
    large: Vec<u32>,
    is_large: Vec<bool>,
    /// Where the boxes of a number begin and end in `entries`.
    begins: Vec<u32>,
    ends: Vec<u32>,
    /// Keys by number, ascending in each.
    entries: Vec<u32>,
    pair_sort: PairSort,
}

impl Default for Listing {
    fn default() -> Self {
        Self {
            boxes: Vec::new(),
            keys: Vec::new(),
            lattice: Lattice::default(),
            numbering: Numbering::Dense,
            range: Cells { low: [0; 3], high: [-1; 3] },
            around: Aabb::EMPTY,
            large: Vec::new(),
            is_large: Vec::new(),
            begins: Vec::new(),
            ends: Vec::new(),
            entries: Vec::new(),
            pair_sort: PairSort::default(),
        }
    }
}

/// The median of the largest finite edges, or 1 m if that is nothing.
pub(super) fn median_edge(boxes: &[Aabb]) -> f64 {
    let largest = |b: &Aabb| b.size().max_abs();
    let mut edges: Vec<f64> = boxes.iter().map(largest).filter(|e| e.is_finite() && *e > 0.0).collect();
    if edges.is_empty() {
        return 1.0;
    }
    let middle = edges.len() / 2;
    *edges.select_nth_unstable_by(middle, f64::total_cmp).1
}

impl Listing {
    /// Lists the boxes anew in the cells of a lattice.
    pub(super) fn update(&mut self, boxes: &[Aabb], lattice: Lattice, numbering: Numbering) {
        (self.lattice, self.numbering) = (lattice, numbering);
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
        valid_keys(boxes, &mut self.keys);
        self.is_large.clear();
        self.is_large.extend(boxes.iter().map(|b| !b.is_finite() || lattice.cells(b).count(MOST_CELLS).is_none()));
        self.large.clear();
        self.large.extend(self.keys.iter().filter(|&&i| self.is_large[i as usize]));
        let listed = self.keys.iter().filter(|&&i| !self.is_large[i as usize]).map(|&i| boxes[i as usize]);
        self.around = listed.fold(Aabb::EMPTY, |a, b| a.merged(&b));
        self.range =
            if self.around.is_valid() { lattice.cells(&self.around) } else { Cells { low: [0; 3], high: [-1; 3] } };
        self.fill();
    }

    /// Groups the keys by number: counts, then places.
    fn fill(&mut self) {
        let n_numbers = match self.numbering {
            Numbering::Dense => self.range.count(u64::MAX).unwrap_or(0) as usize,
            Numbering::Hashed(n) => n,
        };
        let mut ends = core::mem::take(&mut self.ends);
        ends.clear();
        ends.resize(n_numbers, 0);
        self.each_listed(|number, _| ends[number] += 1);
        self.begins.clear();
        let mut before = 0;
        for end in &mut ends {
            let count = core::mem::replace(end, before);
            self.begins.push(before);
            before += count;
        }
        let mut entries = core::mem::take(&mut self.entries);
        entries.clear();
        entries.resize(before as usize, 0);
        self.each_listed(|number, key| {
            let (begin, end) = (self.begins[number] as usize, ends[number] as usize);
            // Two cells of one box may have one hash: it is listed once.
            if end == begin || entries[end - 1] != key {
                entries[end] = key;
                ends[number] += 1;
            }
        });
        (self.ends, self.entries) = (ends, entries);
    }
    fn each_listed(&self, mut visit: impl FnMut(usize, u32)) {
        for &key in self.keys.iter().filter(|&&i| !self.is_large[i as usize]) {
            for cell in self.lattice.cells(&self.boxes[key as usize]).iter() {
                visit(self.number(cell), key);
            }
        }
    }
    /// The number of a cell in range.
    fn number(&self, cell: [i32; 3]) -> usize {
        match self.numbering {
            Numbering::Dense => {
                let at = |i: usize| (cell[i] - self.range.low[i]) as usize;
                let edge = |i: usize| (self.range.high[i] - self.range.low[i] + 1) as usize;
                (at(2) * edge(1) + at(1)) * edge(0) + at(0)
            }
            Numbering::Hashed(n) => {
                // The primes of Teschner et al.; a multiplication carries all of them into the upper half.
                let [x, y, z] = cell.map(|c| u64::from(c.cast_unsigned()));
                let mixed = (x * 73_856_093) ^ (y * 19_349_663) ^ (z * 83_492_791);
                (mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as usize & (n - 1)
            }
        }
    }
    fn entries_of(&self, number: usize) -> Range<usize> {
        self.begins[number] as usize..self.ends[number] as usize
    }

    /// Every two boxes that overlap.
    pub(super) fn pairs(&mut self, out: &mut Vec<Pair>) {
        out.clear();
        for number in 0..self.begins.len() {
            let keys = &self.entries[self.entries_of(number)];
            for (n, &i) in keys.iter().enumerate() {
                let a = &self.boxes[i as usize];
                for &j in &keys[n + 1..] {
                    let b = &self.boxes[j as usize];
                    if a.meets(b) && self.number(self.lattice.meeting_cell(a, b)) == number {
                        out.push((i, j));
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
    /// Every box that overlaps `region`.
    pub(super) fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        out.clear();
        if !region.is_valid() {
            return;
        }
        let meets = |i: &&u32| self.boxes[**i as usize].meets(region);
        let cells = self.lattice.cells(region).within(&self.range);
        if cells.count(self.keys.len() as u64).is_none() {
            out.extend(self.keys.iter().filter(meets));
            return;
        }
        for cell in cells.iter() {
            out.extend(self.entries[self.entries_of(self.number(cell))].iter().filter(meets));
        }
        out.extend(self.large.iter().filter(meets));
        out.sort_unstable();
        out.dedup();
    }
    /// Every box that `ray` goes through.
    pub(super) fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        let hit = |i: &&u32| self.boxes[**i as usize].ray(ray).is_some();
        // Where the scene is far larger than its cells, more cells than boxes lie on the ray.
        let longest = (self.around.size() / self.lattice.edge).max_abs();
        if self.around.is_valid() && longest > self.keys.len() as f64 {
            out.extend(self.keys.iter().filter(hit));
            return;
        }
        self.lattice.along(ray, &self.around, |cells| {
            for cell in cells.within(&self.range).iter() {
                out.extend(self.entries[self.entries_of(self.number(cell))].iter().filter(hit));
            }
        });
        out.extend(self.large.iter().filter(hit));
        out.sort_unstable();
        out.dedup();
    }
    /// Memory in use \[bytes\].
    pub(super) fn memory(&self) -> usize {
        let lists = [&self.keys, &self.large, &self.begins, &self.ends, &self.entries];
        let listed = lists.into_iter().map(bytes).sum::<usize>();
        listed + bytes(&self.boxes) + bytes(&self.is_large) + self.pair_sort.memory()
    }
}
