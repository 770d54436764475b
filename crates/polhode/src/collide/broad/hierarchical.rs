//! The hierarchical grid: a hashed grid for each size of box (Ericson 2005, §7.2.1).
//!
//! ```text
//! level of a box = the least L with 2^L ≥ its largest edge;  its cell = the cube of edge 2^L that holds its centre
//! for each box, for each level in use that is not finer, for each cell that its box, widened by half a cell, touches:
//!     ask the boxes whose centre is there
//! ```
//!
//! Each box is stored once, whatever its size, and a box of level L reaches at most half a cell beyond its own: so small boxes look
//! for large ones in at most 27 cells a level, and large ones never look for small. Time n times the number of levels in use.

use super::lattice::Lattice;
use super::{Aabb, BroadPhase, Pair, PairSort, Ray, bytes, pair, valid_keys};
use crate::math::Vec3;

/// Boxes beyond this level, or infinite, are asked one by one.
const LEVELS: core::ops::RangeInclusive<i32> = -40..=60;

/// Where a box is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Place {
    level: i32,
    cell: [i32; 3],
}

/// A box by the cell that holds its centre.
#[derive(Clone, Copy, Debug)]
struct Entry {
    place: Place,
    key: u32,
}

/// Grids of every size, in one table.
#[derive(Clone, Debug, Default)]
pub struct Hierarchical {
    boxes: Vec<Aabb>,
    keys: Vec<u32>,
    large: Vec<u32>,
    is_large: Vec<bool>,
    /// Where each bucket of `entries` begins; a power of two of them, and the end.
    begins: Vec<u32>,
    entries: Vec<Entry>,
    /// The levels in use, fine to coarse, each with the box around its boxes.
    levels: Vec<(i32, Aabb)>,
    pair_sort: PairSort,
}

fn lattice(level: i32) -> Lattice {
    Lattice { origin: Vec3::ZERO, edge: libm::ldexp(1.0, level) }
}

/// `None` for a box that no level suits.
fn place(b: &Aabb) -> Option<Place> {
    let largest = b.size().max_abs();
    if !largest.is_finite() || b.center().max_abs() > 1e100 {
        return None;
    }
    // largest = m 2^e with ½ ≤ m < 1, so 2^e exceeds it.
    let level = libm::frexp(largest).1.max(*LEVELS.start());
    (level <= *LEVELS.end()).then(|| Place { level, cell: lattice(level).cell(b.center()) })
}

impl Hierarchical {
    fn bucket(&self, place: Place) -> usize {
        let [x, y, z] = place.cell.map(|c| u64::from(c.cast_unsigned()));
        let level = u64::from(place.level.cast_unsigned());
        let mixed = (x * 73_856_093) ^ (y * 19_349_663) ^ (z * 83_492_791) ^ (level * 50_331_653);
        (mixed.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as usize & (self.begins.len() - 2)
    }
    /// The keys whose centre is in a cell.
    fn at(&self, place: Place) -> impl Iterator<Item = u32> + '_ {
        let bucket = self.bucket(place);
        let entries = &self.entries[self.begins[bucket] as usize..self.begins[bucket + 1] as usize];
        entries.iter().filter(move |e| e.place == place).map(|e| e.key)
    }
    /// The keys of one level whose boxes may overlap `region`.
    fn near(&self, (level, around): &(i32, Aabb), region: &Aabb, mut visit: impl FnMut(u32)) {
        if !around.meets(region) {
            return;
        }
        // A centre is within half a cell of its box's faces; the rest is for the rounding of centre and sum.
        let lattice = lattice(*level);
        let reach = lattice.edge * 0.5;
        let slack = 4.0 * f64::EPSILON * (reach + region.min.max_abs() + region.max.max_abs());
        let slack = if slack.is_finite() { slack } else { 0.0 };
        let cells = lattice.cells(&region.expanded(reach + slack)).within(&lattice.cells(around));
        if cells.count(self.keys.len() as u64).is_none() {
            self.entries.iter().filter(|e| e.place.level == *level).for_each(|e| visit(e.key));
            return;
        }
        for cell in cells.iter() {
            self.at(Place { level: *level, cell }).for_each(&mut visit);
        }
    }
    fn fill(&mut self) {
        let placed: Vec<Entry> = self
            .keys
            .iter()
            .filter(|&&key| !self.is_large[key as usize])
            .filter_map(|&key| place(&self.boxes[key as usize]).map(|place| Entry { place, key }))
            .collect();
        self.begins.clear();
        self.begins.resize((2 * placed.len()).next_power_of_two() + 1, 0);
        for e in &placed {
            let bucket = self.bucket(e.place);
            self.begins[bucket + 1] += 1;
        }
        for i in 1..self.begins.len() {
            self.begins[i] += self.begins[i - 1];
        }
        let mut next = self.begins.clone();
        self.entries.clear();
        self.entries.extend_from_slice(&placed);
        for e in placed {
            let at = &mut next[self.bucket(e.place)];
            self.entries[*at as usize] = e;
            *at += 1;
        }
        self.levels.clear();
        for level in LEVELS {
            let of_level = self.entries.iter().filter(|e| e.place.level == level);
            let around = of_level.map(|e| self.boxes[e.key as usize]).reduce(|a, b| a.merged(&b));
            self.levels.extend(around.map(|around| (level, around)));
        }
    }
}

impl BroadPhase for Hierarchical {
    fn update(&mut self, boxes: &[Aabb]) {
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
        valid_keys(boxes, &mut self.keys);
        self.is_large.clear();
        self.is_large.extend(boxes.iter().map(|b| place(b).is_none()));
        self.large.clear();
        self.large.extend(self.keys.iter().filter(|&&i| self.is_large[i as usize]));
        self.fill();
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        out.clear();
        for e in &self.entries {
            let a = &self.boxes[e.key as usize];
            for level in self.levels.iter().filter(|(level, _)| *level >= e.place.level) {
                // On its own level a box is found by each of the two: the lower key reports.
                let is_later = |j: u32| level.0 > e.place.level || j > e.key;
                self.near(level, a, |j| {
                    if is_later(j) && a.meets(&self.boxes[j as usize]) {
                        out.push(pair(e.key, j));
                    }
                });
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
        if !region.is_valid() {
            return;
        }
        let meets = |i: u32| self.boxes[i as usize].meets(region);
        for level in &self.levels {
            self.near(level, region, |i| out.extend(meets(i).then_some(i)));
        }
        out.extend(self.large.iter().filter(|&&i| meets(i)));
        out.sort_unstable();
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        let hit = |i: u32| self.boxes[i as usize].ray(ray).is_some();
        for (level, around) in &self.levels {
            let lattice = lattice(*level);
            if (around.size() / lattice.edge).max_abs() > self.keys.len() as f64 {
                let of_level = self.entries.iter().filter(|e| e.place.level == *level);
                out.extend(of_level.map(|e| e.key).filter(|&i| hit(i)));
                continue;
            }
            // A box may reach half a cell out of the cell of its centre: the cells around those of the ray are asked too.
            let range = lattice.cells(around);
            lattice.along(ray, &around.expanded(lattice.edge), |cells| {
                for cell in cells.grown(1).within(&range).iter() {
                    out.extend(self.at(Place { level: *level, cell }).filter(|&i| hit(i)));
                }
            });
        }
        out.extend(self.large.iter().filter(|&&i| hit(i)));
        out.sort_unstable();
        out.dedup();
    }
    fn memory(&self) -> usize {
        let lists = [&self.keys, &self.large, &self.begins].into_iter().map(bytes).sum::<usize>();
        lists + bytes(&self.boxes) + bytes(&self.is_large) + bytes(&self.entries) + self.pair_sort.memory()
    }
}
