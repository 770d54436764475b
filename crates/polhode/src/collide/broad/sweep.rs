//! Sweep and prune along one axis (Baraff 1992; Ericson 2005, §7.5).
//!
//! ```text
//! sort the boxes by min on one axis
//! for each box a, in order:
//!     for each box b after a while b.min ≤ a.max:  report (a, b) if they overlap on the other axes too
//! ```
//!
//! The axis is the one along which the centres vary most, so that the fewest intervals overlap. The order is kept from update to
//! update: after a small motion it is nearly right, and an insertion sort mends it in time n plus the number of swaps. Good for
//! scenes spread along a line; a layer of boxes n^(1/2) wide still leaves n^(1/2) candidates a box, a full cube n^(2/3).

use super::{Aabb, BroadPhase, Pair, PairSort, Ray, bytes, pair, valid_keys};
use crate::math::Vec3;

/// The boxes in the order of their least coordinate along one axis.
#[derive(Clone, Debug, Default)]
pub struct Sweep {
    boxes: Vec<Aabb>,
    axis: usize,
    /// Keys of the valid boxes by `min[axis]`, ties by key.
    order: Vec<u32>,
    /// The boxes once more in that order, so that the sweep reads memory forwards.
    sorted: Vec<Aabb>,
    /// The greatest `max[axis]` up to each place: before it falls below a query nothing can reach the query.
    reach: Vec<f64>,
    pair_sort: PairSort,
}

/// The axis along which the centres of `boxes` vary most; the first of equals.
pub(crate) fn widest_axis(boxes: &[Aabb], keys: &[u32]) -> usize {
    let n = keys.len().max(1) as f64;
    // Cut off so that a box reaching to infinity does not decide alone, nor overflow.
    let center = |&i: &u32| {
        let c = boxes[i as usize].center();
        Vec3::new(c.x.clamp(-1e9, 1e9), c.y.clamp(-1e9, 1e9), c.z.clamp(-1e9, 1e9))
    };
    let mean = keys.iter().map(center).sum::<Vec3>() / n;
    let spread: Vec3 = keys.iter().map(|i| (center(i) - mean).scale(center(i) - mean)).sum();
    let mut axis = 0;
    for i in 1..3 {
        if spread[i] > spread[axis] {
            axis = i;
        }
    }
    axis
}

impl Sweep {
    /// Mends the order by insertion; gives up, and sorts, where the boxes have been shuffled.
    fn sort(&mut self) {
        let key = |i: u32| (self.boxes[i as usize].min[self.axis], i);
        let mut swaps_left = 8 * self.order.len();
        for n in 1..self.order.len() {
            let (moving, mut at) = (self.order[n], n);
            while at > 0 && key(self.order[at - 1]) > key(moving) {
                self.order[at] = self.order[at - 1];
                at -= 1;
            }
            self.order[at] = moving;
            swaps_left = swaps_left.saturating_sub(n - at);
            if swaps_left == 0 {
                // No NaN is among valid boxes, so the comparison is total.
                self.order.sort_unstable_by(|&i, &j| key(i).partial_cmp(&key(j)).unwrap_or(core::cmp::Ordering::Equal));
                return;
            }
        }
    }
}

impl BroadPhase for Sweep {
    fn update(&mut self, boxes: &[Aabb]) {
        let same =
            self.boxes.len() == boxes.len() && self.boxes.iter().zip(boxes).all(|(a, b)| a.is_valid() == b.is_valid());
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
        if !same {
            valid_keys(boxes, &mut self.order);
        }
        self.axis = widest_axis(boxes, &self.order);
        self.sort();
        self.sorted.clear();
        self.sorted.extend(self.order.iter().map(|&i| boxes[i as usize]));
        self.reach.clear();
        let mut reach = f64::NEG_INFINITY;
        for b in &self.sorted {
            reach = if b.max[self.axis] > reach { b.max[self.axis] } else { reach };
            self.reach.push(reach);
        }
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        out.clear();
        for (n, a) in self.sorted.iter().enumerate() {
            let end = a.max[self.axis];
            for (b, &j) in self.sorted[n + 1..].iter().zip(&self.order[n + 1..]) {
                if b.min[self.axis] > end {
                    break;
                }
                if a.meets(b) {
                    out.push(pair(self.order[n], j));
                }
            }
        }
        self.pair_sort.sort(out);
    }
    fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        out.clear();
        if !region.is_valid() {
            return;
        }
        let (low, high) = (region.min[self.axis], region.max[self.axis]);
        let first = self.reach.partition_point(|&reach| reach < low);
        for (b, &i) in self.sorted.iter().zip(&self.order).skip(first) {
            if b.min[self.axis] > high {
                break;
            }
            if b.meets(region) {
                out.push(i);
            }
        }
        out.sort_unstable();
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        // One axis alone says little about a line: it is asked of all.
        out.extend(self.sorted.iter().zip(&self.order).filter(|(b, _)| b.ray(ray).is_some()).map(|(_, &i)| i));
        out.sort_unstable();
    }
    fn memory(&self) -> usize {
        bytes(&self.boxes) + bytes(&self.order) + bytes(&self.sorted) + bytes(&self.reach) + self.pair_sort.memory()
    }
}
